// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <type_traits>
#include <utility>

#include <stagecraft/jacobian/unconverted.hpp>

// Whether what a callable of the user's writes into its last argument reaches the caller.

namespace stagecraft::detail {

template <class... Parameters>
struct last_of : std::type_identity<void> {};
template <class Last>
struct last_of<Last> : std::type_identity<Last> {};
template <class First, class Second, class... More>
struct last_of<First, Second, More...> : last_of<Second, More...> {};

/// The last of the parameters of a function, void where that is not known: of templates and overloads.
template <class Function>
struct last_parameter : std::type_identity<void> {};
template <class R, class... A>
struct last_parameter<R (*)(A...)> : last_of<A...> {};
template <class R, class... A>
struct last_parameter<R(A...)> : last_of<A...> {};
template <class R, class P, class... A>
struct last_parameter<R (P::*)(A...)> : last_of<A...> {};
template <class R, class P, class... A>
struct last_parameter<R (P::*)(A...) const> : last_of<A...> {};

template <class Problem>
auto output_parameter() {
    if constexpr (requires { &Problem::operator(); })
        return last_parameter<decltype(&Problem::operator())>{};
    else
        return last_parameter<Problem>{};
}

/// A vector that cannot be passed by value.
template <class Vector>
struct passed_by_reference : Vector {
    using Vector::operator=;
    passed_by_reference(const passed_by_reference&) = delete;
};
/// Problem is generic and takes its last argument by value: it can be called with a temporary, which no reference binds to
/// but `auto&&` and `const auto&`, and not with what cannot be copied.
template <class Problem, class Vector, class... Others>
concept takes_copy =
    writes_last<Problem, Vector, Others...> && std::is_invocable_v<Problem&, const Others&..., Vector> &&
    !std::is_invocable_v<Problem&, const Others&..., passed_by_reference<Vector>&>;
/// What a callable writes into its last argument, a Vector, reaches the caller: that is neither a copy nor const.
template <class Problem, class Vector, class... Others>
concept writes_into =
    !std::is_same_v<std::remove_cv_t<typename decltype(output_parameter<std::remove_cv_t<Problem>>())::type>,
                    Vector> &&
    !std::is_same_v<typename decltype(output_parameter<std::remove_cv_t<Problem>>())::type, const Vector&> &&
    !takes_copy<Problem, Vector, Others...>;

}  // namespace stagecraft::detail
