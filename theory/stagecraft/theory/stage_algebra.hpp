// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <cstdint>

namespace stagecraft::tableaux {
class rational;
class fixed_rational;
class quadratic;
}  // namespace stagecraft::tableaux

namespace stagecraft::theory {

/// What the theory needs of a Runge-Kutta method, and all it needs: a stage vector is a function on the
/// nodes, and a method is the vector 1, the nodes c, the pointwise product, the map A and the functional b^T.
/// `scalar` is a commutative ring with 1, `element` a stage vector (a regular value).
template <class M>
concept stage_algebra = requires(const M& m, const typename M::element& u, const typename M::element& v) {
    typename M::scalar;
    { m.stages() } -> std::convertible_to<int>;
    { m.one() } -> std::convertible_to<typename M::element>;
    { m.c() } -> std::convertible_to<typename M::element>;
    { m.multiply(u, v) } -> std::convertible_to<typename M::element>;
    { m.apply(u) } -> std::convertible_to<typename M::element>;
    { m.dot_b(u) } -> std::convertible_to<typename M::scalar>;
};

template <stage_algebra M>
using scalar_of = typename M::scalar;
template <stage_algebra M>
using element_of = typename M::element;

/// Whether `==` over K decides: true for exact fields, false for floating and enclosing scalars, whose
/// equality is about representations. Specialise it (to true) for an exact field of your own.
template <class K>
inline constexpr bool exact_scalar = std::integral<K>;
template <>
inline constexpr bool exact_scalar<tableaux::rational> = true;
template <>
inline constexpr bool exact_scalar<tableaux::fixed_rational> = true;
template <>
inline constexpr bool exact_scalar<tableaux::quadratic> = true;

/// The rational number numerator/denominator in K, by one division there (so correctly rounded in double
/// when both fit 53 bits, exact in an exact field).
template <class K>
constexpr K ratio(std::int64_t numerator, std::int64_t denominator) {
    return denominator == 1 ? K(numerator) : K(numerator) / K(denominator);
}

/// u + v. A model may bring its own `add`; otherwise stage vectors are ranges of scalars.
template <stage_algebra M>
constexpr element_of<M> add(const M& m, element_of<M> u, const element_of<M>& v) {
    if constexpr (requires { m.add(u, v); }) {
        return m.add(u, v);
    } else {
        auto i = v.begin();
        for (auto& x : u) x += *i++;
        return u;
    }
}

/// k u. A model may bring its own `scale`.
template <stage_algebra M>
constexpr element_of<M> scale(const M& m, const scalar_of<M>& k, element_of<M> u) {
    if constexpr (requires { m.scale(k, u); }) {
        return m.scale(k, u);
    } else {
        for (auto& x : u) x *= k;
        return u;
    }
}

/// b^T (u v), the bilinear form of the quadrature. A model may bring a cheaper `inner` of its own (in the
/// shifted Legendre basis it is diagonal: s products instead of a product modulo w).
template <stage_algebra M>
constexpr scalar_of<M> inner(const M& m, const element_of<M>& u, const element_of<M>& v) {
    if constexpr (requires { m.inner(u, v); })
        return m.inner(u, v);
    else
        return m.dot_b(m.multiply(u, v));
}

/// b^T A v. A model may bring `dot_b_apply` of its own (a matrix model keeps the row b^T A).
template <stage_algebra M>
constexpr scalar_of<M> dot_b_apply(const M& m, const element_of<M>& v) {
    if constexpr (requires { m.dot_b_apply(v); })
        return m.dot_b_apply(v);
    else
        return m.dot_b(m.apply(v));
}

}  // namespace stagecraft::theory
