// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include <stagecraft/bvp/lifting_rule.hpp>
#include <stagecraft/linear/almost_block_diagonal.hpp>
#include <stagecraft/linear/mass.hpp>

namespace stagecraft::detail {

/// M g = d + h f_y (integral of g) on one interval, at the Gauss nodes of a lifting rule, by dense elimination. With M
/// positions q' = v known, g_q = d_q + h (integral of g_v), and the other components are all that is eliminated.
template <class Scalar, int N, int M>
class lifting_elimination {
  public:
    /// hJ: h f_y at the nodes, n x n each, side by side.
    template <class Rule, class Mass, class Jacobians>
    void factor(const Rule& rule, const Mass& mass, const Scalar& h, const Jacobians& hJ) {
        const int n = static_cast<int>(hJ.rows()), m = rule.nodes(), r = n - M, size = r * m;
        a_.resize(size, size), x_.resize(static_cast<std::size_t>(size));
        from_.resize(static_cast<std::size_t>(size));
        mass_.setZero(n, n);
        add_mass(mass, Scalar(1), mass_.data(), n);
        for (int l = 0; l < m; ++l)
            for (int d = M; d < n; ++d)
                for (int k = 0; k < m; ++k)
                    for (int c = M; c < n; ++c) {
                        Scalar sum = k == l ? mass_(c, d) : Scalar(0);
                        sum -= rule.integrals(k, l) * hJ(c, k * n + d);
                        if (d < 2 * M) sum -= h * rule.twice(k, l) * hJ(c, k * n + d - M);
                        a_(k * r + c - M, l * r + d - M) = sum;
                    }
        row_elimination::factor(a_, size, static_cast<Scalar*>(nullptr), from_.data());
    }

    template <class Rule, class Jacobians, class Columns>
    void solve(const Rule& rule, const Scalar& h, const Jacobians& hJ, const Columns& d, Columns& g) {
        const int n = static_cast<int>(d.rows()), m = rule.nodes(), r = n - M, size = r * m;
        const auto integral = [&](const Columns& of, int c, int k) {
            Scalar sum(0);
            for (int l = 0; l < m; ++l) sum += rule.integrals(k, l) * of(c, l);
            return sum;
        };
        for (int k = 0; k < m; ++k) {
            for (int c = M; c < n; ++c) x_[k * r + c - M] = d(c, k);
            for (int q = 0; q < M; ++q) {
                const Scalar moved = integral(d, q, k);
                for (int c = M; c < n; ++c) x_[k * r + c - M] += hJ(c, k * n + q) * moved;
            }
        }
        row_elimination::apply(a_, size, static_cast<Scalar*>(nullptr), from_.data(), x_.data());
        for (int k = size - 1; k >= 0; --k) {
            x_[k] /= a_(k, k);
            for (int l = 0; l < k; ++l) x_[l] -= a_(l, k) * x_[k];
        }
        for (int k = 0; k < m; ++k)
            for (int c = M; c < n; ++c) g(c, k) = x_[k * r + c - M];
        for (int k = 0; k < m; ++k)
            for (int q = 0; q < M; ++q) g(q, k) = d(q, k) + h * integral(g, q + M, k);
    }

  private:
    Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> a_;
    Eigen::Matrix<Scalar, N, N> mass_;
    std::vector<Scalar> x_;
    std::vector<int> from_;
};

}  // namespace stagecraft::detail
