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
/// `scalar` is a commutative ring with 1. `element` is a stage vector, a regular value, kept as its
/// `stages()` coordinates in some basis of the functions on the nodes: sums and multiples go coordinate by
/// coordinate, products need not.
template <class M>
concept stage_algebra = requires(const M& m, const typename M::element& u, const typename M::element& v,
                                 typename M::element& w) {
    typename M::scalar;
    { m.stages() } -> std::convertible_to<int>;
    { m.one() } -> std::convertible_to<typename M::element>;
    { m.c() } -> std::convertible_to<typename M::element>;
    { m.multiply(u, v) } -> std::convertible_to<typename M::element>;
    { m.apply(u) } -> std::convertible_to<typename M::element>;
    { m.dot_b(u) } -> std::convertible_to<typename M::scalar>;
    { *u.begin() } -> std::convertible_to<typename M::scalar>;
    { *w.begin() } -> std::same_as<typename M::scalar&>;
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

/// u + v.
template <stage_algebra M>
constexpr element_of<M> add(const M&, element_of<M> u, const element_of<M>& v) {
    auto i = v.begin();
    for (auto& x : u) x += *i++;
    return u;
}

/// k u.
template <stage_algebra M>
constexpr element_of<M> scale(const M&, const scalar_of<M>& k, element_of<M> u) {
    for (auto& x : u) x *= k;
    return u;
}

/// The k-th basis vector, 0 <= k < stages().
template <stage_algebra M>
constexpr element_of<M> basis_vector(const M& m, int k) {
    element_of<M> u = m.one();
    for (auto& x : u) x = k-- == 0 ? scalar_of<M>(1) : scalar_of<M>(0);
    return u;
}

/// b^T A v. A model may bring `dot_b_apply` of its own (a matrix model keeps the row b^T A).
template <stage_algebra M>
constexpr scalar_of<M> dot_b_apply(const M& m, const element_of<M>& v) {
    if constexpr (requires { m.dot_b_apply(v); })
        return m.dot_b_apply(v);
    else
        return m.dot_b(m.apply(v));
}

// Rows, that is functionals on stage vectors, are kept as their values on the basis.

/// f^T v.
template <stage_algebra M>
constexpr scalar_of<M> pair(const M&, const element_of<M>& f, const element_of<M>& v) {
    scalar_of<M> sum(0);
    auto i = v.begin();
    for (const auto& x : f) sum += x * *i++;
    return sum;
}

/// b^T (u v), the bilinear form of the quadrature. A model may bring a cheaper `inner` of its own, or its
/// matrix `gram()` (in the shifted Legendre basis of Gauss, Radau and Lobatto it is diagonal: s products
/// instead of a product modulo w).
template <stage_algebra M>
constexpr scalar_of<M> inner(const M& m, const element_of<M>& u, const element_of<M>& v) {
    if constexpr (requires { m.inner(u, v); })
        return m.inner(u, v);
    else if constexpr (requires { element_of<M>(m.gram() * v); })
        return pair(m, u, m.gram() * v);
    else
        return m.dot_b(m.multiply(u, v));
}

/// The row whose value on u is functional(u).
template <stage_algebra M, class Functional>
constexpr element_of<M> row_of(const M& m, const Functional& functional) {
    element_of<M> f = m.one();
    int k = 0;
    for (auto& x : f) x = functional(basis_vector(m, k++));
    return f;
}

}  // namespace stagecraft::theory
