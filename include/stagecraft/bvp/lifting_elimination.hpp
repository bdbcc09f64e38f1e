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
/// together in memory, as rows are what is combined, with the right-hand side at their end. Nodes is the number of nodes where
/// it is known at compile time, or 0.
template <class Scalar, int N, int M>
class lifting_elimination {
    template <int Count>
    using numbers = Eigen::Matrix<Scalar, (Count > 0 ? Count : Eigen::Dynamic), 1>;

  public:
    /// hJ: h f_y at the nodes, n x n each, side by side.
    template <int Nodes, class Rule, class Mass, class Jacobians, class Columns>
    void solve(const Rule& rule, const Mass& mass, const Scalar& h, const Jacobians& hJ, const Columns& d,
               Columns& g) {
        const int n = N > 0 ? N : static_cast<int>(hJ.rows()), m = Nodes > 0 ? Nodes : rule.nodes();
        const int r = n - M, size = r * m, width = width_of(size);
        a_.resize(static_cast<std::size_t>(size) * width), by_.resize(static_cast<std::size_t>(size) * size);
        x_.resize(static_cast<std::size_t>(size)), inverse_.resize(static_cast<std::size_t>(size));
        from_.resize(static_cast<std::size_t>(size));
        if constexpr (!Mass::identity) {
            mass_.setZero(n, n);
            add_mass(mass, Scalar(1), mass_.data(), n);
        }
        using weights = Eigen::Map<const numbers<Nodes>>;
        for (int k = 0; k < m; ++k) {
            const weights once(rule.integrals.data() + k * m, m), twice(rule.twice.data() + k * m, m);
            for (int c = M; c < n; ++c) {
                Scalar* row = a_.data() + static_cast<std::size_t>(k * r + c - M) * width;
                for (int d2 = M; d2 < n; ++d2) {
                    auto part = every<Nodes>(row + d2 - M, m, r);
                    if (d2 < 2 * M)
                        part = -(hJ(c, k * n + d2) * once + (h * hJ(c, k * n + d2 - M)) * twice);
                    else
                        part = -hJ(c, k * n + d2) * once;
                    if constexpr (!Mass::identity) row[k * r + d2 - M] += mass_(c, d2);
                }
                if constexpr (Mass::identity) row[k * r + c - M] += Scalar(1);
                row[width - 1] = Scalar(0);  // perhaps never looked at, but combined with the others
            }
        }
        right_sides<Nodes>(rule, hJ, d, a_.data() + size, width);
        eliminate<(Nodes > 0 && N > 0) ? (N - M) * Nodes : 0>(size);
        for (int k = 0; k < size; ++k) x_[k] = a_[static_cast<std::size_t>(k) * width + size];
        back<Nodes>(rule, h, d, g);
    }

    /// The same for another d, with the factors at hand.
    template <int Nodes, class Rule, class Jacobians, class Columns>
    void solve_again(const Rule& rule, const Scalar& h, const Jacobians& hJ, const Columns& d, Columns& g) {
        const int size = static_cast<int>(x_.size());
        right_sides<Nodes>(rule, hJ, d, x_.data(), 1);
        for (int k = 0; k < size; ++k) {
            if (from_[k] != k) std::swap(x_[k], x_[from_[k]]);
            const Scalar *by = by_.data() + static_cast<std::size_t>(k) * size, f = x_[k];
            for (int i = k + 1; i < size; ++i) x_[i] -= by[i] * f;
        }
        back<Nodes>(rule, h, d, g);
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
    /// Of a row with its right-hand side, rounded up so that two numbers at a time may be combined.
    static constexpr int width_of(int size) { return (size + 2) / 2 * 2; }

    /// Every r-th number from `first` on, m in all.
    template <int Nodes>
    static auto every(Scalar* first, int m, int r) {
        using stride = Eigen::InnerStride<N >= 0 ? N - M : Eigen::Dynamic>;
        return Eigen::Map<numbers<Nodes>, 0, stride>(first, m, stride(r));
    }

    /// The integrals to node k of component c of W.
    template <int Nodes, class Rule, class Columns>
    static Scalar integral(const Rule& rule, const Columns& W, int c, int k) {
        const int m = Nodes > 0 ? Nodes : rule.nodes();
        const Scalar* weights = rule.integrals.data() + k * m;
        Scalar sum(0);
        for (int l = 0; l < m; ++l) sum += weights[l] * W(c, l);
        return sum;
    }

    /// d + h f_q (integral of d_q) of the components that are eliminated, `stride` apart.
    template <int Nodes, class Rule, class Jacobians, class Columns>
    void right_sides(const Rule& rule, const Jacobians& hJ, const Columns& d, Scalar* out, int stride) const {
        const int n = N > 0 ? N : static_cast<int>(d.rows()), m = Nodes > 0 ? Nodes : rule.nodes();
        for (int k = 0; k < m; ++k) {
            Scalar moved[M > 0 ? M : 1];
            for (int q = 0; q < M; ++q) moved[q] = integral<Nodes>(rule, d, q, k);
            for (int c = M; c < n; ++c, out += stride) {
                *out = d(c, k);
                for (int q = 0; q < M; ++q) *out += hJ(c, k * n + q) * moved[q];
            }
        }
    }

    /// g from x as the elimination has left it. The newest x comes last in every sum, so that none waits for it.
    template <int Nodes, class Rule, class Columns>
    void back(const Rule& rule, const Scalar& h, const Columns& d, Columns& g) {
        const int n = N > 0 ? N : static_cast<int>(d.rows()), m = Nodes > 0 ? Nodes : rule.nodes();
        const int r = n - M, size = r * m, width = width_of(size);
        for (int k = size - 1; k >= 0; --k) {
            const Scalar* row = a_.data() + static_cast<std::size_t>(k) * width;
            Scalar sum = x_[k];
            for (int l = size - 1; l > k; --l) sum -= row[l] * x_[l];
            x_[k] = sum * inverse_[k];
        }
        for (int k = 0; k < m; ++k)
            for (int c = M; c < n; ++c) g(c, k) = x_[k * r + c - M];
        for (int k = 0; k < m; ++k)
            for (int q = 0; q < M; ++q) g(q, k) = d(q, k) + h * integral<Nodes>(rule, g, q + M, k);
    }

    /// LU with row pivoting; whole rows change places. Of few columns all are combined, as loops of known length cost less
    /// than what they need not do: what is left of a pivot is zero, and not looked at again.
    template <int Size>
    void eliminate(int size) {
        using std::abs;
        if constexpr (Size > 0) size = Size;
        constexpr bool few = 0 < Size && Size <= 16;
        using part = numbers<few ? width_of(Size) : 0>;
        const int width = width_of(size);
        for (int k = 0; k < size; ++k) {
            Scalar* pivot = a_.data() + static_cast<std::size_t>(k) * width;
            int p = k;
            Scalar largest = abs(pivot[k]);
            for (int i = k + 1; i < size; ++i) {
                const Scalar here = abs(a_[static_cast<std::size_t>(i) * width + k]);
                if (here > largest) largest = here, p = i;
            }
            from_[k] = p;
            if (p != k)
                Eigen::Map<part>(pivot, width)
                    .swap(Eigen::Map<part>(a_.data() + static_cast<std::size_t>(p) * width, width));
            inverse_[k] = Scalar(1) / pivot[k];
            Scalar* by = by_.data() + static_cast<std::size_t>(k) * size;
            if (!usable_pivot(largest)) {
                std::fill(by, by + size, Scalar(0));
                continue;
            }
            const int begin = few ? 0 : k + 1, count = few ? width : width - begin;
            const Eigen::Map<const part> of(pivot + begin, count);
            for (int i = k + 1; i < size; ++i) {
                Scalar* row = a_.data() + static_cast<std::size_t>(i) * width;
                by[i] = row[k] * inverse_[k];
                Eigen::Map<part>(row + begin, count) -= by[i] * of;
            }
        }
    }

    Eigen::Matrix<Scalar, N, N> mass_;
    Eigen::Matrix<Scalar, N, 1> own_, change_;
    std::vector<Scalar> a_, by_, inverse_, x_;
    std::vector<int> from_;
};

}  // namespace stagecraft::detail
