// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <type_traits>

namespace stagecraft::detail {

template <class Derived>
std::type_identity<Derived> named_by_eigen(const Eigen::EigenBase<Derived>&);

/// What a user's function returns as a T holds its numbers, or refers to an object that does. An expression of Eigen's
/// does not: it refers to its operands, and those that were local to the function are gone before anybody can evaluate it.
/// No type tells such operands from others, and no compiler warns. So expressions are refused wherever a function of the
/// user's returns something.
template <class T>
concept owns_numbers = !requires(const std::remove_cvref_t<T>& x) {
    named_by_eigen(x);
}
|| requires(const std::remove_cvref_t<T>& x) {
    requires std::derived_from < std::remove_cvref_t<T>,
    typename decltype(named_by_eigen(x))::type::PlainObject > ;
};

/// The same for a function that returns a number of any kind: no product of a row and a column either, which converts to
/// one, nor a matrix of one entry.
template <class T>
concept owned_number = !std::is_void_v<T> && !requires(const std::remove_cvref_t<T>& x) {
    named_by_eigen(x);
};

/// F cannot be called with these, or returns what owns its numbers.
template <class F, class... Arguments>
concept owned_or_none =
    !std::is_invocable_v<F, Arguments...> || owns_numbers<std::invoke_result_t<F, Arguments...>>;

/// The value itself, of an expression what it has now: to be kept beyond the call that it is an argument of.
template <class T>
auto object_of(T value) {
    if constexpr (owns_numbers<T>)
        return value;
    else
        return typename decltype(named_by_eigen(value))::type::PlainObject(value);
}

}  // namespace stagecraft::detail
