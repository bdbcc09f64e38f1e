// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <stdexcept>
#include <type_traits>

namespace stagecraft {

/// Thrown where a function of the user's resized its output or returned one of another size; a run ends with
/// status::size_changed then.
struct size_change : std::length_error {
    size_change()
        : std::length_error("a function returned a vector or matrix of another size than it has to") {}
};

namespace detail {

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

/// What a user's function returned, of this size; else size_change. (Eigen itself looks at sizes that are not known at compile
/// time in builds with assertions alone, and reads past the end in others.)
template <class Value>
const Value& of_size(const Value& value, Eigen::Index rows, Eigen::Index columns = 1) {
    const bool turned = columns == 1 && value.rows() == 1;  // a row for a column
    if (turned ? value.cols() != rows : value.rows() != rows || value.cols() != columns) throw size_change();
    return value;
}

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

}  // namespace detail

}  // namespace stagecraft
