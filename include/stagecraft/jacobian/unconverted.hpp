// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include <stagecraft/jacobian/dual_number.hpp>
#include <stagecraft/refuse/detect/named_member.hpp>
#include <stagecraft/refuse/detect/taken_arguments.hpp>

namespace stagecraft::detail {

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
/// written into cannot refer, and as they are only where F may mean to write into its last argument. Nor may F declare
/// vectors of another size.
template <class F, class Out, class... In>
concept writes_last = (requires(F & f, Out& out) { f(std::declval<In>()..., out); } ||
                       (!reads_last<F, Out, In...>() &&
                        requires(F & f, const In&... in, Out& out) { f(in..., out); })) &&
                      !mistakes_vectors<F, const In&..., Out&>();

}  // namespace stagecraft::detail
