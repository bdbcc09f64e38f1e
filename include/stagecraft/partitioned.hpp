// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/integrate.hpp>
#include <stagecraft/method/partitioned_method.hpp>
#include <stagecraft/problem/hamiltonian.hpp>
#include <stagecraft/problem/partition.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>
#include <stagecraft/step/partitioned_step.hpp>

namespace stagecraft {

/// A pair of tableaux for q' = f, p' = g, the first for q, the second for p, of the same number of stages:
///
///     integrate(partitioned(lobatto_iiia<3>(), lobatto_iiib<3>()), hamiltonian<2>(H), y0, t0, t1, {.fixed_step = 0.01})
///
/// problem is partition(f, g) or hamiltonian<n>(...); y = (q, p). Steps are equal (options.fixed_step): a pair has no error
/// estimate, and a symplectic one keeps what it keeps only so (Hairer-Lubich-Wanner VIII.1). In separable problems stages
/// that depend on evaluated ones alone are explicit; report.f counts evaluations of g there. Else each step solves one
/// system of 2 n s equations down to rounding, whatever rtol is, and factors as often as the Jacobian changes. Observers,
/// events and results are those of any run; between the ends of a step y(t) is Hermite's cubic, which costs one
/// evaluation of f and g a step where an observer asks for it. std::invalid_argument where the numbers of stages differ.
template <class Scalar, int First, int Second>
auto partitioned(const tableau<Scalar, First>& first, const tableau<Scalar, Second>& second) {
    constexpr bool equal = First == Second || First == dynamic || Second == dynamic;
    static_assert(equal, "partitioned(first, second): both tableaux must have the same number of stages");
    using method = partitioned_method<Scalar, equal ? detail::common_stages<First, Second> : dynamic>;
    return detail::pair_of<method>(first, second, "partitioned", false);
}

/// A pair whose order holds for separable problems, q' = f(t, p), p' = g(t, q), alone (trees of alternating colours: Ruth,
/// Forest-Ruth); a problem with other parts does not compile.
template <class Scalar, int First, int Second>
auto separable(const tableau<Scalar, First>& first, const tableau<Scalar, Second>& second) {
    constexpr bool equal = First == Second || First == dynamic || Second == dynamic;
    static_assert(equal, "separable(first, second): both tableaux must have the same number of stages");
    using method = separable_method<Scalar, equal ? detail::common_stages<First, Second> : dynamic>;
    return detail::pair_of<method>(first, second, "separable", true);
}

namespace detail {
struct call_of_partitioned {
    template <class Method>
    static constexpr bool say() {
        static_assert(never<Method>,
                      "partitioned(first, second): both must be tableaux of the same scalar type, "
                      "lobatto_iiia<3>() with its parentheses, say");
        return true;
    }
};
}  // namespace detail

/// Of what are no tableaux.
partitioned_method<double, 1> partitioned(detail::refused_call<detail::call_of_partitioned>, ...);

}  // namespace stagecraft
