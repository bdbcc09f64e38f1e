// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/small_solve.hpp"
#include "stagecraft/theory/dynamics/evaluate.hpp"

namespace stagecraft::theory {

using tableaux::column;
using tableaux::dense;

/// Throws std::invalid_argument unless G is n x n, symmetric and positive definite (exact L D L^T).
void require_inner_product(const dense<rational>& G, Eigen::Index n);

/// x^T G y.
template <class T>
T inner_product(const dense<rational>& G, const column<T>& x, const column<T>& y) {
    T sum(0);
    for (Eigen::Index i = 0; i < G.rows(); ++i)
        for (Eigen::Index j = 0; j < G.cols(); ++j)
            if (G(i, j) != 0) sum = sum + T(G(i, j)) * x[i] * y[j];
    return sum;
}

/// (G B + B^T G)/2, the symmetric part of B in the inner product x^T G y.
template <class T>
dense<T> symmetric_part(const dense<rational>& G, const dense<T>& B) {
    const auto n = B.rows();
    dense<T> GB(n, n), S(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) {
            GB(i, j) = T(0);
            for (Eigen::Index k = 0; k < n; ++k)
                if (G(i, k) != 0) GB(i, j) = GB(i, j) + T(G(i, k)) * B(k, j);
        }
    }
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) S(i, j) = (GB(i, j) + GB(j, i)) * T(rational(1, 2));
    return S;
}

/// gamma G - S >= 0: exact.
bool bounds(const rational& gamma, const dense<rational>& G, const dense<rational>& S);

/// The largest eigenvalue of the pencil S - gamma G by bisection on exact inertias: [low, high] of at most
/// `width`, low = high where it is a rational number with a small denominator.
supremum largest_eigenvalue(const dense<rational>& G, const dense<rational>& S,
                            const rational& width = rational(1, 1LL << 30));

inline dense<rational> euclidean(int n) { return tableaux::identity<rational>(n); }

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/inner_product-inl.hpp"
#endif
