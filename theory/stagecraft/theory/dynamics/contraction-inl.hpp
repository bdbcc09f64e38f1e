// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/contraction.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

namespace detail {

/// The least k for given weights, where the lower block is positive definite: by its Schur complement; else infinity.
STAGECRAFT_INLINE double least_k(const tableau<double>& t, const Eigen::VectorXd& D, double l) {
    const auto M = burrage_butcher_matrix<double>(t, D, 0.0, l);
    const auto s = t.b.size();
    const Eigen::MatrixXd W = M.bottomRightCorner(s, s);
    const Eigen::LLT<Eigen::MatrixXd> cholesky(W);
    if (cholesky.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
    const Eigen::VectorXd w = M.block(1, 0, s, 1);
    return -M(0, 0) + w.dot(cholesky.solve(w));
}

STAGECRAFT_INLINE Eigen::VectorXd best_weights(const tableau<double>& t, double l) {
    const auto s = t.b.size();
    Eigen::VectorXd best = t.b.cwiseMax(1e-3);
    double least = std::numeric_limits<double>::infinity();
    for (const double start : {1.0, 0.3, 3.0, 0.05, 1.2}) {
        Eigen::VectorXd D = start * t.b.cwiseMax(1e-3);
        double k = least_k(t, D, l);
        for (double step = 0.5; step > 1e-10;) {
            bool better = false;
            for (Eigen::Index i = 0; i < s; ++i) {
                for (Eigen::Index j = 0; j < s; ++j) {
                    for (const int sign : {-1, 1, -2, 2}) {
                        Eigen::VectorXd next = D;
                        next[i] *= std::exp(sign > 0 ? step : -step);
                        if (j != i) next[j] *= std::exp(sign % 2 == 0 ? step : -step);
                        const double value = least_k(t, next, l);
                        if (value < k) {
                            k = value;
                            D = next;
                            better = true;
                        }
                    }
                }
            }
            if (!better) step /= 2;
        }
        if (k < least) {
            least = k;
            best = D;
        }
    }
    return best;
}

}  // namespace detail

}  // namespace stagecraft::theory
