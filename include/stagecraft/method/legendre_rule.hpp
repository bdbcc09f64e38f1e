// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <vector>

#include <stagecraft/method/legendre_values.hpp>

namespace stagecraft {

/// The integrals of P_0, ..., P_most from 0 to x: (P_{k+1} - P_{k-1})(x) / (2 (2 k + 1)).
template <class Scalar>
void legendre_integrals(const Scalar& x, int most, Scalar* integrals) {
    std::vector<Scalar> P(static_cast<std::size_t>(most + 2));
    legendre_values(x, most + 1, P.data());
    integrals[0] = x;
    for (int k = 1; k <= most; ++k) integrals[k] = (P[k + 1] - P[k - 1]) / Scalar(2 * (2 * k + 1));
}

/// Gauss-Legendre nodes and weights on [0, 1] in any scalar, by Newton's iteration, with the values P_k(c_j)
/// that turn values at the nodes into Legendre coefficients: a_k = (2 k + 1) sum_j b_j P_k(c_j) v_j.
template <class Scalar>
struct legendre_rule {
    Eigen::Matrix<Scalar, Eigen::Dynamic, 1> c, b;
    Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> to_coefficients;  ///< row k, column j

    explicit legendre_rule(int size) : c(size), b(size), to_coefficients(size, size) {
        using std::abs;
        std::vector<Scalar> P(static_cast<std::size_t>(size + 1));
        for (int j = 0; j < size; ++j) {
            Scalar x = Scalar((1 - std::cos(3.14159265358979324 * (j + 0.75) / (size + 0.5))) / 2);
            for (int step = 0; step < 12; ++step) {
                legendre_values(x, size, P.data());
                const Scalar change = P[size] / derivative(x, size, P);
                x -= change;
                if (abs(change) <= 4 * std::numeric_limits<Scalar>::epsilon() * x) break;
            }
            legendre_values(x, size, P.data());
            const Scalar slope = derivative(x, size, P);
            c[j] = x;
            b[j] = Scalar(1) / (x * (1 - x) * slope * slope);
            for (int k = 0; k < size; ++k) to_coefficients(k, j) = Scalar(2 * k + 1) * b[j] * P[k];
        }
    }

    int size() const { return static_cast<int>(c.size()); }

    /// The weights w with sum_j w_j v_j = the integral of the interpolating polynomial from 0 to x.
    Eigen::Matrix<Scalar, 1, Eigen::Dynamic> integral(const Scalar& x) const {
        Eigen::Matrix<Scalar, 1, Eigen::Dynamic> k(size());
        legendre_integrals(x, size() - 1, k.data());
        return k.lazyProduct(to_coefficients);
    }
    /// The weights of its value at x.
    Eigen::Matrix<Scalar, 1, Eigen::Dynamic> value(const Scalar& x) const {
        Eigen::Matrix<Scalar, 1, Eigen::Dynamic> k(size());
        legendre_values(x, size() - 1, k.data());
        return k.lazyProduct(to_coefficients);
    }

  private:
    static Scalar derivative(const Scalar& x, int n, const std::vector<Scalar>& P) {
        return Scalar(n) * ((2 * x - 1) * P[n] - P[n - 1]) / (2 * x * (x - 1));
    }
};

}  // namespace stagecraft
