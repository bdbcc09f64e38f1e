// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <utility>
#include <vector>

#include <stagecraft/linear/almost_block_diagonal.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableau/legendre_rule.hpp>

namespace stagecraft::detail {

/// The equations of one interval [t, t + h] by a collocation tableau, linearised, in the unknowns y at its two
/// ends, the scaled slopes Z_j = h y'(t + c_j h) and the parameters p:
///
///     M Z_j - h f(t + c_j h, y + sum_k a_jk Z_k, p) = 0,      y_+ - y - sum_k b_k Z_k = 0.
///
/// The slopes are eliminated by rows with pivots from both kinds of equations, so that the n equations left,
/// E y + F y_+ + P p = g, are well scaled for growing and decaying modes alike: a pole of R(z) is no obstacle.
/// With Positions = m > 0 the first m equations are q' = v, v being the next m components. Then v is a polynomial of
/// degree s as before, and q its integral, of degree s + 1, as in collocation of q'' itself (Ascher-Christiansen-Russell
/// 1981): where fast modes leave nothing of superconvergence, that gains two orders. s (n - m) unknowns are
/// eliminated instead of s n.
template <class Scalar, int N, int P, int S, int Positions = 0>
class collocation_blocks {
    static constexpr bool fixed = N > 0 && P >= 0 && S > 0;
    static constexpr int m = Positions;
    static constexpr int slopes_at_compile_time = fixed ? S * (N - m) : Eigen::Dynamic;
    static constexpr int rows_at_compile_time = fixed ? S * (N - m) + N : Eigen::Dynamic;
    static constexpr int columns_at_compile_time = fixed ? S * (N - m) + 2 * N + P : Eigen::Dynamic;

  public:
    using matrix = Eigen::Matrix<Scalar, rows_at_compile_time, columns_at_compile_time>;
    using square = Eigen::Matrix<Scalar, S, S>;
    using row = Eigen::Matrix<Scalar, 1, S>;

    collocation_blocks(const tableau<Scalar, S>& method, int n, int parameters)
        : method_(method), n_(n), np_(parameters) {
        if constexpr (m > 0) integrate_twice();
    }

    int n() const { return N > 0 ? N : n_; }
    int np() const { return P >= 0 ? P : np_; }
    int s() const { return S > 0 ? S : method_.stages(); }
    int slopes() const { return s() * (n() - m); }
    int rows() const { return slopes() + n(); }
    int columns() const { return slopes() + 2 * n() + np(); }

    /// The weights with which slopes of v at the nodes enter q at node j and at the end: q_j = q + c_j h v + h sum_k
    /// twice(j, k) Z_k.
    const square& twice() const { return twice_; }
    const row& twice_to_end() const { return twice_to_end_; }

    void resize(int intervals) {
        blocks_.resize(static_cast<Eigen::Index>(intervals) * rows() * columns());
        from_.resize(static_cast<std::size_t>(intervals) * slopes());
    }

    /// Writes and eliminates interval i, given h and the Jacobians at the nodes (n x (n + n_p) each, side by
    /// side in J). Returns E, F, P as one n x (2 n + n_p) block.
    template <class Jacobians, class Mass>
    auto factor(int i, const Scalar& h, const Jacobians& J, const Mass& mass) {
        auto a = block(i);
        write(a, h, J, mass);
        eliminate(a, from(i));
        return condensed(i);
    }

    /// E, F, P of interval i as one n x (2 n + n_p) block.
    auto condensed(int i) {
        return block(i).template bottomRightCorner<N, Eigen::Dynamic>(n(), 2 * n() + np());
    }

    /// Turns residuals (rho: n x s of the slope equations, gamma: n of the continuity, what the left sides
    /// are to become) into the right-hand sides of the eliminated equations: x holds slopes() + n numbers, the
    /// last n being g.
    template <class Rho, class Gamma, class X>
    void apply(int i, const Rho& rho, const Gamma& gamma, X&& x) {
        const int r = n() - m;
        for (int j = 0; j < s(); ++j)
            for (int c = m; c < n(); ++c) x[j * r + c - m] = rho(c, j);
        for (int c = 0; c < n(); ++c) x[slopes() + c] = gamma[c];
        const auto a = block(i);
        const int* p = from(i);
        for (int k = 0; k < slopes(); ++k) {
            if (p[k] != k) std::swap(x[k], x[p[k]]);
            const Scalar f = x[k];
            for (int l = k + 1; l < rows(); ++l) x[l] -= a(l, k) * f;
        }
    }

    /// The slopes Z (n x s) from what apply() left, once y at both ends and p are known.
    template <class X, class Y0, class Y1, class Parameters, class Rho, class Z>
    void recover(int i, const Scalar& h, X&& x, const Y0& left, const Y1& right, const Parameters& p,
                 const Rho& rho, Z&& z) {
        const auto a = block(i);
        const int q = slopes();
        Eigen::Map<Eigen::Matrix<Scalar, slopes_at_compile_time, 1>> of_slopes(x.data(), q);
        const auto remove = [&](int c, const Scalar& value) {
            of_slopes -= value * a.col(q + c).template head<slopes_at_compile_time>(q);
        };
        for (int c = 0; c < n(); ++c) remove(c, left[c]), remove(n() + c, right[c]);
        for (int c = 0; c < np(); ++c) remove(2 * n() + c, p[c]);
        for (int k = q - 1; k >= 0; --k) {
            x[k] *= a(k, k);
            for (int l = 0; l < k; ++l) x[l] -= a(l, k) * x[k];
        }
        const int r = n() - m;
        for (int j = 0; j < s(); ++j)
            for (int c = m; c < n(); ++c) z(c, j) = x[j * r + c - m];
        if constexpr (m > 0)
            for (int j = 0; j < s(); ++j)
                for (int c = 0; c < m; ++c) {
                    Scalar v = left[m + c];
                    for (int k = 0; k < s(); ++k) v += method_.A(j, k) * z(m + c, k);
                    z(c, j) = h * v + rho(c, j);
                }
    }

  private:
    /// A^2 and b A, which integrate through values at the nodes, and what the leading term of v adds to that: P_s / s over
    /// its leading coefficient, times the divided difference of the slopes.
    void integrate_twice() {
        const int k = s();
        twice_ = method_.A * method_.A;
        twice_to_end_ = method_.b.transpose() * method_.A;
        Eigen::Matrix<Scalar, Eigen::Dynamic, 1> values(k + 1), integral(k + 1), at_nodes(k);
        Scalar leading(1);
        for (int j = 1; j <= k; ++j) leading *= Scalar(k + j) / Scalar(j);
        for (int j = 0; j < k; ++j) {
            legendre_values(Scalar(method_.c[j]), k, values.data());
            at_nodes[j] = values[k];
        }
        row difference(k);
        for (int j = 0; j < k; ++j) {
            difference[j] = Scalar(1) / (Scalar(k) * leading);
            for (int l = 0; l < k; ++l)
                if (l != j) difference[j] /= method_.c[j] - method_.c[l];
        }
        for (int j = 0; j < k; ++j) {
            legendre_integrals(Scalar(method_.c[j]), k, integral.data());
            twice_.row(j) += (integral[k] - method_.A.row(j).dot(at_nodes)) * difference;
        }
        legendre_integrals(Scalar(1), k, integral.data());
        twice_to_end_ += (integral[k] - method_.b.dot(at_nodes)) * difference;
    }

    auto block(int i) {
        return Eigen::Map<matrix>(blocks_.data() + static_cast<std::size_t>(i) * rows() * columns(), rows(),
                                  columns());
    }
    int* from(int i) { return from_.data() + static_cast<std::size_t>(i) * slopes(); }

    template <class Block, class Jacobians, class Mass>
    void write(Block& a, const Scalar& h, const Jacobians& J, const Mass& mass) const {
        const int r = n() - m, q = slopes(), width = n() + np();
        for (int j = 0; j < s(); ++j) {
            const int at = j * width;
            for (int k = 0; k < s(); ++k) {
                const Scalar first = h * method_.A(j, k);
                Scalar second(0);
                if constexpr (m > 0) second = h * h * twice_(j, k);
                for (int d = m; d < n(); ++d)
                    for (int c = m; c < n(); ++c) {
                        Scalar sum = first * J(c, at + d);
                        if constexpr (m > 0)
                            if (d < 2 * m) sum += second * J(c, at + d - m);
                        a(j * r + c - m, k * r + d - m) = -sum;
                    }
            }
            for (int c = m; c < n(); ++c) {
                const int l = j * r + c - m;
                for (int d = 0; d < n(); ++d) {
                    Scalar sum = h * J(c, at + d);
                    if constexpr (m > 0)
                        if (d >= m && d < 2 * m) sum += h * h * method_.c[j] * J(c, at + d - m);
                    a(l, q + d) = -sum;
                    a(l, q + n() + d) = Scalar(0);
                }
                for (int d = 0; d < np(); ++d) a(l, q + 2 * n() + d) = -h * J(c, at + n() + d);
            }
            if constexpr (Mass::identity) {
                for (int l = j * r; l < (j + 1) * r; ++l) a(l, l) += Scalar(1);
            } else {
                for (const auto& e : mass.entries()) a(j * r + e.row, j * r + e.column) += e.value;
            }
        }
        write_continuity(a, h);
    }

    template <class Block>
    void write_continuity(Block& a, const Scalar& h) const {
        const int r = n() - m, q = slopes();
        for (int j = 0; j < columns(); ++j)
            for (int c = 0; c < n(); ++c) a(q + c, j) = Scalar(0);
        for (int c = 0; c < n(); ++c) {
            a(q + c, q + c) = Scalar(-1);
            a(q + c, q + n() + c) = Scalar(1);
            for (int k = 0; k < s(); ++k) {
                if (c < m)
                    a(q + c, k * r + c) = -h * twice_to_end_[k];
                else
                    a(q + c, k * r + c - m) = -method_.b[k];
            }
            if (c < m) a(q + c, q + m + c) = -h;
        }
    }

    /// LU with row pivoting, the reciprocals of the pivots in their place. Of few rows all are combined, those above the pivot
    /// with zeros, as loops of known length cost less.
    template <class Block>
    void eliminate(Block& a, int* pivot) const {
        using std::abs;
        constexpr bool few = 0 < rows_at_compile_time && rows_at_compile_time <= 16;
        constexpr int length = few ? rows_at_compile_time : Eigen::Dynamic;
        Eigen::Matrix<Scalar, length, 1> by = Eigen::Matrix<Scalar, length, 1>::Zero(rows());
        const int q = slopes(), all = rows(), width = columns();
        for (int k = 0; k < q; ++k) {
            int p = k;
            Scalar largest = abs(a(k, k));
            for (int i = k + 1; i < all; ++i)
                if (abs(a(i, k)) > largest) largest = abs(a(i, k)), p = i;
            pivot[k] = p;
            if (p != k)
                for (int j = k; j < width; ++j) std::swap(a(k, j), a(p, j));
            a(k, k) = Scalar(1) / a(k, k);
            by[k] = Scalar(0);
            if (!usable_pivot(largest)) continue;
            for (int i = k + 1; i < all; ++i) a(i, k) = by[i] = a(i, k) * a(k, k);
            const int begin = few ? 0 : k + 1, count = all - begin;
            for (int j = k + 1; j < width; ++j)
                if (const Scalar u = a(k, j); u != Scalar(0))
                    a.col(j).template segment<length>(begin, count) -=
                        u * by.template segment<length>(begin, count);
        }
    }

    tableau<Scalar, S> method_;
    square twice_;
    row twice_to_end_;
    int n_, np_;
    Eigen::Matrix<Scalar, Eigen::Dynamic, 1> blocks_;
    std::vector<int> from_;
};

}  // namespace stagecraft::detail
