// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "stagecraft/tableaux/small_solve.hpp"
#include "stagecraft/theory/dynamics/tableau_numbers.hpp"
#include "stagecraft/theory/stability/algebraic_stability.hpp"
#include "stagecraft/theory/statements/verdict.hpp"

namespace stagecraft::theory {

using tableaux::rational;

/// |x_1 - y_1| <= factor |x_0 - y_0| for every problem with one-sided Lipschitz constant gamma, l = h gamma: the method is
/// (k, l)-algebraically stable with the weights D, factor = sqrt k (Burrage-Butcher 1980).
template <class K>
struct contraction_bound {
    theory::verdict verdict;
    K k{0};
    tableaux::column<rational> D;
    double factor = std::numeric_limits<double>::infinity();  ///< not below sqrt k
};

/// The matrix of (k, l)-algebraic stability,
///     ( k - 1 - 2l 1^T D 1        1^T D - b^T - 2l 1^T D A          )
///     ( D 1 - b - 2l A^T D 1      D A + A^T D - b b^T - 2l A^T D A  ),
/// positive semidefinite with D >= 0 where the bound holds.
template <class K>
tableaux::dense<K> burrage_butcher_matrix(const tableau<K>& t, const tableaux::column<K>& D, const K& k,
                                          const K& l) {
    const auto s = t.b.size();
    tableaux::dense<K> M(s + 1, s + 1);
    M(0, 0) = k - K(1);
    for (Eigen::Index i = 0; i < s; ++i) {
        M(0, 0) = M(0, 0) - K(2) * l * D[i];
        M(0, i + 1) = D[i] - t.b[i];
        for (Eigen::Index j = 0; j < s; ++j) M(0, i + 1) = M(0, i + 1) - K(2) * l * D[j] * t.A(j, i);
        M(i + 1, 0) = M(0, i + 1);
    }
    for (Eigen::Index i = 0; i < s; ++i) {
        for (Eigen::Index j = 0; j < s; ++j) {
            K sum = D[i] * t.A(i, j) + D[j] * t.A(j, i) - t.b[i] * t.b[j];
            for (Eigen::Index m = 0; m < s; ++m) sum = sum - K(2) * l * t.A(m, i) * D[m] * t.A(m, j);
            M(i + 1, j + 1) = sum;
        }
    }
    return M;
}

namespace detail {

/// Compass search for the logarithms of D, from several starts.
Eigen::VectorXd best_weights(const tableau<double>& t, double l);

}  // namespace detail

/// The smallest contraction factor found for l = h gamma, with its proof: D is sought in doubles and rounded to rational
/// numbers, k follows exactly from the Schur complement, and the matrix is proved positive semidefinite by L D L^T.
/// Where l <= 0 and the method is algebraically stable, D = b proves k = 1 at least. consistent, with an infinite
/// factor, where no weights were found (l beyond what the method allows).
template <class K>
contraction_bound<K> contraction(const tableau<K>& t, const rational& l) {
    require_shape(t);
    const auto s = t.b.size();
    contraction_bound<K> best{
        verdict::consistent("no D found", "none", "the search is in doubles"), K(0), {}};
    const auto attempt = [&](const tableaux::column<rational>& D, std::optional<K> k) {
        tableaux::column<K> weights(s);
        for (Eigen::Index i = 0; i < s; ++i) weights[i] = K(D[i]);
        if (!k) {  // the Schur complement of the lower block
            const auto M = burrage_butcher_matrix<K>(t, weights, K(0), K(l));
            const tableaux::dense<K> W = M.bottomRightCorner(s, s), w = M.block(1, 0, s, 1);
            const auto x = tableaux::solve<K>(W, w);
            if (!x) return;
            K sum = K(0) - M(0, 0);
            for (Eigen::Index i = 0; i < s; ++i) sum = sum + w(i, 0) * (*x)(i, 0);
            k = sum;
        }
        if (*k < K(0) ||
            tableaux::diagonalise<K>(burrage_butcher_matrix<K>(t, weights, *k, K(l))).inertia().negative > 0)
            return;
        const double factor = sqrt(enclosed_number(*k)).high();
        if (!(factor < best.factor)) return;
        best = {verdict::proved("(k, l)-algebraically stable, k = " + k->str()), *k, D, factor};
    };
    const auto doubles = in_doubles(t);
    bool rational_weights = true, positive = true;
    tableaux::column<rational> D(s);
    for (Eigen::Index i = 0; i < s; ++i) {
        positive = positive && K(0) < t.b[i];
        if constexpr (std::is_same_v<K, rational>) {
            D[i] = t.b[i];
        } else {
            rational_weights = rational_weights && t.b[i].is_rational();
            D[i] = t.b[i].rational_part();
        }
    }
    if (rational_weights && positive && l <= 0) attempt(D, K(1));
    const Eigen::VectorXd sought = detail::best_weights(doubles, l.to<double>());
    for (Eigen::Index i = 0; i < s; ++i)
        D[i] = tableaux::simplest_between(exactly(sought[i]), exactly(sought[i] * (1 + 1e-9)));
    attempt(D, {});
    return best;
}

/// The factor of lecture, Bemerkung 1.19 (Stuart-Humphries 1996, p. 387), rounded up: |x_1 - y_1| <= factor |x_0 - y_0|,
///     factor^2 = (1 + h K L)^2/((1 + h K L)^2 - 2 gamma h),
/// for an algebraically stable method with b > 0 and a right-hand side with the Lipschitz constant L and the one-sided one
/// gamma <= 0. K = max_j sum_i b_i |b_j - a_ij|/b_j is that of the method: x_1 - y_1 = X_i - Y_i + h sum_j (b_j - a_ij)
/// (f(X_j) - f(Y_j)), averaged with the weights b_i, bounds sum_i b_i |X_i - Y_i|^2 from below. Below 1 for gamma < 0, of
/// Gauss methods too, whose factor without L is 1. Throws std::invalid_argument for gamma > 0, L < -gamma, h <= 0 and for
/// other methods.
template <class K>
double lipschitz_contraction(const tableau<K>& t, const rational& gamma, const rational& L,
                             const rational& h) {
    require_shape(t);
    if (gamma > 0) throw std::invalid_argument("gamma: must not be positive, is " + gamma.str());
    if (L < -gamma) throw std::invalid_argument("L: must be at least -gamma, is " + L.str());
    if (!(h > 0)) throw std::invalid_argument("h: must be positive, is " + h.str());
    K sum(0);
    for (Eigen::Index j = 0; j < t.b.size(); ++j) {
        if (!(K(0) < t.b[j])) throw std::invalid_argument("method: needs b > 0, has " + t.b[j].str());
        sum = sum + t.b[j];
    }
    if (!(sum == K(1))) throw std::invalid_argument("method: not consistent, sum b = " + sum.str());
    if (const auto v = algebraically_stable(t); !v.is_proved())
        throw std::invalid_argument("method: not algebraically stable: " + v.reason());
    double most = 0;
    for (Eigen::Index j = 0; j < t.b.size(); ++j) {
        interval column = 0;
        for (Eigen::Index i = 0; i < t.b.size(); ++i)
            column += enclosed_number(t.b[i]) * abs(enclosed_number(K(t.b[j] - t.A(i, j))));
        most = std::max(most, (column / enclosed_number(t.b[j])).high());
    }
    const interval square_of = square(1 + interval(h) * interval(L) * interval(most));
    return sqrt(square_of / (square_of - 2 * interval(gamma) * interval(h))).high();
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/contraction-inl.hpp"
#endif
