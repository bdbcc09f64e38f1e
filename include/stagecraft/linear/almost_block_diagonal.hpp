// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <stagecraft/linear/split_complex.hpp>

namespace stagecraft {

/// Elimination of the first `pivots` columns of a panel by rows with row pivoting: backward stable where the
/// rows carried from panel to panel are those of separated conditions (de Boor-Weiss 1980).
struct row_elimination {
    template <class Matrix, class Scalar>
    static void factor(Matrix& a, int pivots, Scalar*, int* from) {
        using std::abs;
        const int rows = static_cast<int>(a.rows()), columns = static_cast<int>(a.cols());
        for (int k = 0; k < pivots; ++k) {
            int p = k;
            for (int i = k + 1; i < rows; ++i)
                if (abs(a(i, k)) > abs(a(p, k))) p = i;
            from[k] = p;
            if (p != k)
                for (int j = k; j < columns; ++j) std::swap(a(k, j), a(p, j));
            if (!usable_pivot(Scalar(abs(a(k, k))))) continue;
            const Scalar r = Scalar(1) / a(k, k);
            for (int i = k + 1; i < rows; ++i) a(i, k) *= r;
            for (int j = k + 1; j < columns; ++j) {
                const Scalar u = a(k, j);
                for (int i = k + 1; i < rows; ++i) a(i, j) -= a(i, k) * u;
            }
        }
    }
    template <class Matrix, class Scalar>
    static void apply(const Matrix& a, int pivots, const Scalar*, const int* from, Scalar* x) {
        const int rows = static_cast<int>(a.rows());
        for (int k = 0; k < pivots; ++k) {
            if (from[k] != k) std::swap(x[k], x[from[k]]);
            for (int i = k + 1; i < rows; ++i) x[i] -= a(i, k) * x[k];
        }
    }
    template <class Matrix, class Scalar>
    static void apply_transposed(const Matrix& a, int pivots, const Scalar*, const int* from, Scalar* x) {
        const int rows = static_cast<int>(a.rows());
        for (int k = pivots - 1; k >= 0; --k) {
            for (int i = k + 1; i < rows; ++i) x[k] -= a(i, k) * x[i];
            if (from[k] != k) std::swap(x[k], x[from[k]]);
        }
    }
};

/// A chain of unknowns x_0, ..., x_L of size n and a border z of size q, coupled by
///
///     c rows of the head:      H x_0 + H_z z = h
///     n rows per link i:       A_i x_i + B_i x_{i+1} + C_i z = g_i,   i = 0 ... L - 1
///     n + q - c rows at last:  T x_L + T_z z = t
///
/// eliminated from x_0 on by panels of c + n rows, of which c are carried on. Separated conditions are the
/// case q = 0 with row_elimination; coupled ones have x(a) in the border (cyclic_blocks.hpp). Factoring takes
/// O(L n^2 (n + q)) operations, a solution O(L n (n + q)). N is n where it is known at compile time.
template <class Scalar, int N, class Elimination = row_elimination>
class block_chain {
  public:
    using matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

    /// Takes room for L links; head rows c, border q.
    void resize(int n, int links, int head, int border) {
        n_ = n, links_ = links, c_ = head, q_ = border;
        rows_ = c_ + size(), columns_ = 2 * size() + q_;
        panels_.resize(static_cast<Eigen::Index>(links) * rows_ * columns_);
        tau_.resize(static_cast<std::size_t>(links) * size());
        from_.resize(static_cast<std::size_t>(links) * size());
        last_.setZero(size() + q_, size() + q_);
        last_from_.resize(size() + q_);
        scale_.resize(size() + q_);
        top_.resize(size(), links + 1);
        rhs_.resize(rows_ > size() + q_ ? rows_ : size() + q_);
        carry_.resize(rows_, size() + q_);
    }

    int size() const { return N >= 0 ? N : n_; }
    int links() const { return links_; }
    int head() const { return c_; }
    int border() const { return q_; }

    /// Where the matrices are written before factor(): the columns of `head` and `last` are those of x and
    /// then of z.
    auto head_rows() { return carry_.topRows(c_); }
    auto link_rows(int i) { return panel(i).bottomRows(size()); }  ///< columns x_i, x_{i+1}, z
    auto last_rows() { return last_.bottomRows(size() + q_ - c_); }

    /// Zero or non-finite pivots are replaced by the rounding error of the largest, and counted.
    int factor() {
        using std::abs;
        const int n = size();
        replaced_ = 0;
        for (int i = 0; i < links_; ++i) {
            auto a = panel(i);
            for (int k = 0; k < c_; ++k) {
                for (int j = 0; j < n; ++j) a(k, j) = carry_(k, j), a(k, n + j) = Scalar(0);
                for (int j = 0; j < q_; ++j) a(k, 2 * n + j) = carry_(k, n + j);
            }
            Elimination::factor(a, n, tau(i), from(i));
            repair(a);
            for (int j = 0; j < n + q_; ++j)
                for (int k = 0; k < c_; ++k) carry_(k, j) = a(n + k, n + j);
        }
        last_.topRows(c_) = carry_.topRows(c_);
        const int m = n + q_;
        for (int i = 0; i < m; ++i) {  // conditions of different units: rows of equal size
            Scalar largest(0);
            for (int j = 0; j < m; ++j)
                if (abs(last_(i, j)) > largest) largest = abs(last_(i, j));
            scale_[i] = largest > Scalar(0) ? Scalar(Scalar(1) / largest) : Scalar(1);
        }
        for (int i = 0; i < m; ++i) last_.row(i) *= scale_[i];
        row_elimination::factor(last_, m, static_cast<Scalar*>(nullptr), last_from_.data());
        repair(last_);
        return replaced_;
    }

    /// Solves in place: h in head (c numbers), g in links (n per column), t in last (n + q - c); the solution
    /// in x (n x (L + 1)) and z (q).
    template <class Head, class Links, class Last, class X, class Z>
    void solve(const Head& h, const Links& g, const Last& t, X& x, Z& z) {
        const int n = size(), m = n + q_;
        Scalar* r = rhs_.data();
        for (int k = 0; k < c_; ++k) r[k] = h[k];
        for (int i = 0; i < links_; ++i) {
            for (int k = 0; k < n; ++k) r[c_ + k] = g(k, i);
            Elimination::apply(panel(i), n, tau(i), from(i), r);
            for (int k = 0; k < n; ++k) top_(k, i) = r[k];
            for (int k = 0; k < c_; ++k) r[k] = r[n + k];
        }
        for (int k = 0; k < m - c_; ++k) r[c_ + k] = t[k];
        for (int k = 0; k < m; ++k) r[k] *= scale_[k];
        row_elimination::apply(last_, m, static_cast<Scalar*>(nullptr), last_from_.data(), r);
        back(last_, m, r);
        for (int k = 0; k < n; ++k) x(k, links_) = r[k];
        for (int k = 0; k < q_; ++k) z[k] = r[n + k];
        for (int i = links_ - 1; i >= 0; --i) {
            const auto a = panel(i);
            for (int k = 0; k < n; ++k) {
                Scalar sum = top_(k, i);
                for (int j = 0; j < n; ++j) sum -= a(k, n + j) * x(j, i + 1);
                for (int j = 0; j < q_; ++j) sum -= a(k, 2 * n + j) * z[j];
                x(k, i) = sum;
            }
            for (int k = n - 1; k >= 0; --k) {
                for (int j = k + 1; j < n; ++j) x(k, i) -= a(k, j) * x(j, i);
                x(k, i) /= a(k, k);
            }
        }
    }

    /// The transposed system: given the weights v of x (n x (L + 1)) and of z, the weights of the equations.
    template <class X, class Z, class Head, class Links, class Last>
    void solve_transposed(const X& v, const Z& vz, Head& h, Links& g, Last& t) {
        const int n = size(), m = n + q_;
        Scalar *r = rhs_.data(), *border = r + n;
        for (int k = 0; k < n; ++k) r[k] = v(k, 0);
        for (int k = 0; k < q_; ++k) border[k] = vz[k];
        for (int i = 0; i < links_; ++i) {
            const auto a = panel(i);
            for (int k = 0; k < n; ++k) {
                Scalar sum = r[k];
                for (int j = 0; j < k; ++j) sum -= a(j, k) * top_(j, i);
                top_(k, i) = sum / a(k, k);
            }
            for (int k = 0; k < n; ++k) {
                r[k] = v(k, i + 1);
                for (int j = 0; j < n; ++j) r[k] -= a(j, n + k) * top_(j, i);
            }
            for (int k = 0; k < q_; ++k)
                for (int j = 0; j < n; ++j) border[k] -= a(j, 2 * n + k) * top_(j, i);
        }
        for (int k = 0; k < m; ++k) {
            for (int j = 0; j < k; ++j) r[k] -= last_(j, k) * r[j];
            r[k] /= last_(k, k);
        }
        row_elimination::apply_transposed(last_, m, static_cast<Scalar*>(nullptr), last_from_.data(), r);
        for (int k = 0; k < m; ++k) r[k] *= scale_[k];
        for (int k = 0; k < m - c_; ++k) t[k] = r[c_ + k];
        for (int i = links_ - 1; i >= 0; --i) {
            for (int k = c_ - 1; k >= 0; --k) r[n + k] = r[k];
            for (int k = 0; k < n; ++k) r[k] = top_(k, i);
            Elimination::apply_transposed(panel(i), n, tau(i), from(i), r);
            for (int k = 0; k < n; ++k) g(k, i) = r[c_ + k];
        }
        for (int k = 0; k < c_; ++k) h[k] = r[k];
    }

  private:
    auto panel(int i) {
        return Eigen::Map<matrix>(panels_.data() + static_cast<std::size_t>(i) * rows_ * columns_, rows_,
                                  columns_);
    }
    Scalar* tau(int i) { return tau_.data() + static_cast<std::size_t>(i) * size(); }
    int* from(int i) { return from_.data() + static_cast<std::size_t>(i) * size(); }

    template <class Matrix>
    void repair(Matrix& a) {
        using std::abs;
        const int m = static_cast<int>(a.rows() == a.cols() ? a.rows() : size());
        for (int k = 0; k < m; ++k)
            if (!usable_pivot(Scalar(abs(a(k, k))))) {
                Scalar largest(0);
                for (int j = k; j < a.cols(); ++j)
                    if (abs(a(k, j)) > largest) largest = abs(a(k, j));
                if (!(largest > Scalar(0)) || !(largest - largest == Scalar(0))) largest = Scalar(1);
                a(k, k) = std::numeric_limits<Scalar>::epsilon() * largest;
                ++replaced_;
            }
    }
    template <class Matrix>
    static void back(const Matrix& a, int m, Scalar* r) {
        for (int k = m - 1; k >= 0; --k) {
            for (int j = k + 1; j < m; ++j) r[k] -= a(k, j) * r[j];
            r[k] /= a(k, k);
        }
    }

    int n_ = 0, links_ = 0, c_ = 0, q_ = 0, rows_ = 0, columns_ = 0, replaced_ = 0;
    Eigen::Matrix<Scalar, Eigen::Dynamic, 1> panels_;
    std::vector<Scalar> tau_, rhs_, scale_;
    std::vector<int> from_, last_from_;
    matrix last_, carry_, top_;
};

/// Almost block diagonal systems: conditions separated into those at the left and those at the right.
template <class Scalar, int N>
using almost_block_diagonal = block_chain<Scalar, N, row_elimination>;

}  // namespace stagecraft
