// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <stagecraft/jacobian/dual_number.hpp>
#include <stagecraft/named_member.hpp>

namespace stagecraft::detail {

struct call_operator_member {
    void operator()();
    template <class T>
    static constexpr bool visible_in = requires {
        &T::operator();
    };
};

/// What an argument of type A is converted to by a rival call.
template <class A>
struct converted_from {
    converted_from(A);
};
struct rival_called {};

/// F with one more operator(), which takes argument K by a conversion and the others as they are, and the object as it
/// is, not const. Overload resolution prefers it to an operator() const of F's that converts argument K as well; with one
/// of F's that takes this argument as it is, the call is ambiguous. So it is found out which of them F has without
/// compiling what F does (unless its operator() is not const: that one is better then, and compiled).
template <class F, std::size_t K, class Positions, class... Args>
struct rival;
template <class F, std::size_t K, std::size_t... I, class... Args>
struct rival<F, K, std::index_sequence<I...>, Args...> : F {
    using F::operator();
    rival_called operator()(std::conditional_t<I == K, converted_from<Args>, Args>...);
};

template <class F, std::size_t K, class... Args>
concept converts_argument =
    requires(rival<std::remove_const_t<F>, K, std::index_sequence_for<Args...>, Args...>& f) {
    { f(std::declval<Args>()...) } -> std::same_as<rival_called>;
};

/// A vector of dual numbers that is read, which Eigen's matrices of plain numbers are constructible from, if only by
/// their declarations.
template <class A>
concept vector_of_duals = std::is_const_v<std::remove_reference_t<A>> && requires {
    requires is_dual<typename std::remove_cvref_t<A>::Scalar>;
};

template <class F, class... Args>
constexpr bool converts_duals() {
    if constexpr (requires { &F::operator(); })  // no template: of plain numbers
        return (vector_of_duals<Args> || ...);
    else if constexpr (has_member_named<F, call_operator_member> && !std::is_final_v<F>)
        return []<std::size_t... K>(std::index_sequence<K...>) {
            return ((vector_of_duals<Args> && converts_argument<F, K, Args...>) || ...);
        }
    (std::index_sequence_for<Args...>());
    else return false;
}

/// F (const or not) can be called with these references, and vectors of dual numbers among them arrive as what they
/// are: not where a parameter `const Eigen::VectorXd& y` stands beside `auto& f`.
template <class F, class... Args>
concept callable_unconverted = !converts_duals<F, Args...>() && requires(F & f, Args... args) {
    f(args...);
};

/// F is generic and takes a temporary as its last argument: it does not write into that.
template <class F, class Out, class... In>
constexpr bool reads_last() {
    if constexpr (has_member_named<F, call_operator_member> && !std::is_final_v<F> &&
                  !requires { &F::operator(); })
        return !converts_argument<F, sizeof...(In), const In&..., Out>;
    else
        return false;
}

/// F can be called with these arguments and writes into the last. A generic F that takes them in another order would not
/// compile, and say so from inside: so the others are given as temporaries, to which the `auto&` of what is
/// written into cannot refer, and as they are only where F may mean to write into its last argument.
template <class F, class Out, class... In>
concept writes_last = requires(F& f, Out& out) {
    f(std::declval<In>()..., out);
}
|| (!reads_last<F, Out, In...>() && requires(F & f, const In&... in, Out& out) { f(in..., out); });

}  // namespace stagecraft::detail
