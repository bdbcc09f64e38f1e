// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include <stagecraft/bvp/lifting_rule.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/split_complex.hpp>

namespace stagecraft::detail {

/// M g = d + h f_y (integral of g) on one interval, at the Gauss nodes of a lifting rule, by dense elimination. With M
/// positions q' = v known, g_q = d_q + h (integral of g_v), and the other components are all that is eliminated. Rows lie
/// together in memory, as rows are what is combined. Nodes is the number of nodes where it is known at compile time, or 0.
template <class Scalar, int N, int M>
class lifting_elimination {
  public:
    /// hJ: h f_y at the nodes, n x n each, side by side.
    template <int Nodes, class Rule, class Mass, class Jacobians>
    void factor(const Rule& rule, const Mass& mass, const Scalar& h, const Jacobians& hJ) {
        const int n = N > 0 ? N : static_cast<int>(hJ.rows()), m = Nodes > 0 ? Nodes : rule.nodes();
        const int r = n - M, size = r * m;
        a_.resize(static_cast<std::size_t>(size) * size), x_.resize(static_cast<std::size_t>(size));
        from_.resize(static_cast<std::size_t>(size));
        if constexpr (!Mass::identity) {
            mass_.setZero(n, n);
            add_mass(mass, Scalar(1), mass_.data(), n);
        }
        for (int k = 0; k < m; ++k) {
            const Scalar *once = rule.integrals.data() + k * m, *twice = rule.twice.data() + k * m;
            for (int c = M; c < n; ++c) {
                Scalar* row = a_.data() + static_cast<std::size_t>(k * r + c - M) * size;
                for (int d = M; d < n; ++d) {
                    const Scalar by = hJ(c, k * n + d),
                                 by_position = d < 2 * M ? h * hJ(c, k * n + d - M) : Scalar(0);
                    if (d < 2 * M)
                        for (int l = 0; l < m; ++l)
                            row[l * r + d - M] = -(by * once[l] + by_position * twice[l]);
                    else
                        for (int l = 0; l < m; ++l) row[l * r + d - M] = -by * once[l];
                    if constexpr (!Mass::identity) row[k * r + d - M] += mass_(c, d);
                }
                if constexpr (Mass::identity) row[k * r + c - M] += Scalar(1);
            }
        }
        eliminate<(Nodes > 0 && N > 0) ? (N - M) * Nodes : 0>(size);
    }

    template <int Nodes, class Rule, class Jacobians, class Columns>
    void solve(const Rule& rule, const Scalar& h, const Jacobians& hJ, const Columns& d, Columns& g) {
        const int n = N > 0 ? N : static_cast<int>(d.rows()), m = Nodes > 0 ? Nodes : rule.nodes();
        const int r = n - M, size = r * m;
        const auto integral = [&](const Columns& of, int c, int k) {
            const Scalar *weights = rule.integrals.data() + k * m, *value = of.data() + c;
            Scalar sum(0);
            for (int l = 0; l < m; ++l) sum += weights[l] * value[l * n];
            return sum;
        };
        Scalar* x = x_.data();
        for (int k = 0; k < m; ++k) {
            for (int c = M; c < n; ++c) x[k * r + c - M] = d(c, k);
            for (int q = 0; q < M; ++q) {
                const Scalar moved = integral(d, q, k);
                for (int c = M; c < n; ++c) x[k * r + c - M] += hJ(c, k * n + q) * moved;
            }
        }
        for (int k = 0; k < size; ++k) {
            if (from_[k] != k) std::swap(x[k], x[from_[k]]);
            const Scalar* row = a_.data() + static_cast<std::size_t>(k) * size;
            Scalar sum = x[k];
            for (int l = 0; l < k; ++l) sum -= row[l] * x[l];
            x[k] = sum;
        }
        for (int k = size - 1; k >= 0; --k) {
            const Scalar* row = a_.data() + static_cast<std::size_t>(k) * size;
            Scalar sum = x[k];
            for (int l = k + 1; l < size; ++l) sum -= row[l] * x[l];
            x[k] = sum / row[k];
        }
        for (int k = 0; k < m; ++k)
            for (int c = M; c < n; ++c) g(c, k) = x[k * r + c - M];
        for (int k = 0; k < m; ++k)
            for (int q = 0; q < M; ++q) g(q, k) = d(q, k) + h * integral(g, q + M, k);
    }

    /// The same by sweeps from node to node, which cost least where h f_y is moderate; false where they do not contract, and
    /// with a mass matrix.
    template <int Nodes, class Rule, class Mass, class Jacobians, class Columns>
    bool sweep(const Rule& rule, const Mass&, const Jacobians& hJ, const Columns& d, Columns& g) {
        using std::abs;
        if constexpr (!Mass::identity) return false;
        const int n = static_cast<int>(d.rows()), m = Nodes > 0 ? Nodes : rule.nodes();
        g = d;
        own_.resize(n), change_.resize(n);
        Scalar before(0);
        for (int k = 0; k < rule.order + 4; ++k) {
            Scalar change(0), size(0);
            for (int j = 0; j < m; ++j) {
                combine<N, Nodes>(rule.integrals.data() + j * m, m, g.data(), n, own_.data(), n);
                combine<N>(own_.data(), n, &hJ(0, j * n), n, change_.data(), n);
                for (int c = 0; c < n; ++c) {
                    const Scalar value = d(c, j) + change_[c], move = abs(value - g(c, j));
                    if (move > change) change = move;
                    if (abs(value) > size) size = abs(value);
                    g(c, j) = value;
                }
            }
            if (change <= Scalar(1) / 100000 * size) return true;
            if (k > 2 && !(change < before / 2)) return false;
            before = change;
        }
        return false;
    }

  private:
    /// LU with row pivoting; whole rows change places, so that solve() may take the changes as it goes.
    template <int Size>
    void eliminate(int size) {
        using std::abs;
        if constexpr (Size > 0) size = Size;
        for (int k = 0; k < size; ++k) {
            Scalar* pivot = a_.data() + static_cast<std::size_t>(k) * size;
            int p = k;
            Scalar largest = abs(pivot[k]);
            for (int i = k + 1; i < size; ++i) {
                const Scalar here = abs(a_[static_cast<std::size_t>(i) * size + k]);
                if (here > largest) largest = here, p = i;
            }
            from_[k] = p;
            if (p != k) std::swap_ranges(pivot, pivot + size, a_.data() + static_cast<std::size_t>(p) * size);
            if (!usable_pivot(largest)) continue;
            const Scalar inverse = Scalar(1) / pivot[k];
            for (int i = k + 1; i < size; ++i) {
                Scalar* row = a_.data() + static_cast<std::size_t>(i) * size;
                const Scalar by = row[k] *= inverse;
                for (int j = k + 1; j < size; ++j) row[j] -= by * pivot[j];
            }
        }
    }

    Eigen::Matrix<Scalar, N, N> mass_;
    Eigen::Matrix<Scalar, N, 1> own_, change_;
    std::vector<Scalar> a_, x_;
    std::vector<int> from_;
};

}  // namespace stagecraft::detail
