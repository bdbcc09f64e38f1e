// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/integer.hpp"
#include "stagecraft/tableaux/polynomial.hpp"

namespace stagecraft::tableaux {

/// Dense matrices and columns of run-time size over an exact field K.
template <class K>
using dense = Eigen::Matrix<K, Eigen::Dynamic, Eigen::Dynamic>;
template <class K>
using column = Eigen::Matrix<K, Eigen::Dynamic, 1>;

namespace detail {

template <class K>
void require_square(const dense<K>& m, const char* who) {
    if (m.rows() != m.cols()) throw std::invalid_argument(std::string(who) + ": the matrix must be square");
}

/// Reduced row echelon form in place; returns the pivot columns. Pivots are the first non-zero entries:
/// exact arithmetic needs no better ones.
template <class K>
std::vector<Eigen::Index> eliminate(dense<K>& m, Eigen::Index columns) {
    std::vector<Eigen::Index> pivots;
    for (Eigen::Index j = 0, row = 0; j < columns && row < m.rows(); ++j) {
        Eigen::Index p = row;
        while (p < m.rows() && m(p, j) == K(0)) ++p;
        if (p == m.rows()) continue;
        if (p != row) m.row(p).swap(m.row(row));
        const K inverse = K(1) / m(row, j);
        for (Eigen::Index k = j; k < m.cols(); ++k) m(row, k) = m(row, k) * inverse;
        for (Eigen::Index i = 0; i < m.rows(); ++i) {
            if (i == row || m(i, j) == K(0)) continue;
            const K f = m(i, j);
            for (Eigen::Index k = j; k < m.cols(); ++k) m(i, k) = m(i, k) - f * m(row, k);
        }
        pivots.push_back(j);
        ++row;
    }
    return pivots;
}

}  // namespace detail

/// X with M X = B, or nothing where M is singular. Throws std::invalid_argument where the sizes do not fit.
/// O(n^3) operations in K.
template <class K>
std::optional<dense<K>> solve(const dense<K>& m, const dense<K>& right) {
    detail::require_square(m, "solve");
    if (m.rows() != right.rows()) throw std::invalid_argument("solve: the right-hand side does not fit");
    dense<K> work(m.rows(), m.cols() + right.cols());
    work.leftCols(m.cols()) = m;
    work.rightCols(right.cols()) = right;
    if (static_cast<Eigen::Index>(detail::eliminate<K>(work, m.cols()).size()) < m.rows()) return {};
    return dense<K>(work.rightCols(right.cols()));
}

template <class K>
dense<K> identity(Eigen::Index n) {
    dense<K> unit(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) unit(i, j) = K(i == j ? 1 : 0);
    }
    return unit;
}

/// M^-1, or nothing where M is singular.
template <class K>
std::optional<dense<K>> inverse(const dense<K>& m) {
    return solve<K>(m, identity<K>(m.rows()));
}

template <class K>
int rank(dense<K> m) {
    return static_cast<int>(detail::eliminate<K>(m, m.cols()).size());
}

/// Determinant by elimination, O(n^3).
template <class K>
K determinant(dense<K> m) {
    detail::require_square(m, "determinant");
    K value(1);
    for (Eigen::Index j = 0; j < m.cols(); ++j) {
        Eigen::Index p = j;
        while (p < m.rows() && m(p, j) == K(0)) ++p;
        if (p == m.rows()) return K(0);
        if (p != j) {
            m.row(p).swap(m.row(j));
            value = K(0) - value;
        }
        value = value * m(j, j);
        for (Eigen::Index i = j + 1; i < m.rows(); ++i) {
            if (m(i, j) == K(0)) continue;
            const K f = m(i, j) / m(j, j);
            for (Eigen::Index k = j; k < m.cols(); ++k) m(i, k) = m(i, k) - f * m(j, k);
        }
    }
    return value;
}

/// What Faddeev and Leverrier's recursion gives in one go: characteristic polynomial and adjugate.
template <class K>
struct faddeev_leverrier {
    std::vector<K> c;                ///< det(x I - M) = x^n + c[1] x^(n-1) + ... + c[n]; c[0] = 1
    std::vector<dense<K>> adjugate;  ///< adj(x I - M) = sum_k adjugate[k] x^(n-1-k)
};

/// O(n^4) operations in K, divisions by 1..n only.
template <class K>
faddeev_leverrier<K> leverrier(const dense<K>& m) {
    detail::require_square(m, "leverrier");
    const auto n = m.rows();
    faddeev_leverrier<K> out;
    out.c.push_back(K(1));
    dense<K> next = identity<K>(n);
    for (Eigen::Index k = 1; k <= n; ++k) {
        out.adjugate.push_back(next);
        dense<K> product(n, n);
        K trace(0);
        for (Eigen::Index i = 0; i < n; ++i) {
            for (Eigen::Index j = 0; j < n; ++j) {
                K sum(0);
                for (Eigen::Index l = 0; l < n; ++l) {
                    if (!(m(i, l) == K(0))) sum = sum + m(i, l) * next(l, j);
                }
                product(i, j) = sum;
            }
            trace = trace + product(i, i);
        }
        const K c = K(0) - trace / K(static_cast<int>(k));
        out.c.push_back(c);
        next = product;
        for (Eigen::Index i = 0; i < n; ++i) next(i, i) = next(i, i) + c;
    }
    return out;
}

/// A common denominator of the entries: 1 where K has none.
template <class K>
K common_denominator(const dense<K>& m) {
    if constexpr (requires(const K& a) { K(lcm(a.denominator(), a.denominator())); }) {
        auto common = K(1).denominator();
        for (Eigen::Index i = 0; i < m.size(); ++i) common = lcm(common, m.data()[i].denominator());
        return K(common);
    } else {
        return K(1);
    }
}

namespace detail {

// 1, c_1, ..., c_n of leverrier(m), found for a matrix of integers: fractions would be cancelled in each of
// the O(n^4) operations, here they are in each of the n coefficients.
template <class K>
std::vector<K> characteristic_coefficients(dense<K> m) {
    const K common = common_denominator<K>(m);
    for (Eigen::Index i = 0; i < m.size(); ++i) m.data()[i] = m.data()[i] * common;
    auto c = leverrier<K>(m).c;
    K power(1);
    for (K& entry : c) {
        entry = entry / power;
        power = power * common;
    }
    return c;
}

}  // namespace detail

/// det(x I - M). O(n^4) operations on integers for rational entries.
template <class K>
polynomial<K> characteristic_polynomial(const dense<K>& m) {
    auto c = detail::characteristic_coefficients<K>(m);
    return polynomial<K>(std::vector<K>(c.rbegin(), c.rend()));
}

/// det(I - z M), a polynomial in z with value 1 at z = 0: the product over the diagonal blocks where M is
/// block lower triangular, as the matrix of every explicit or diagonally implicit method is. O(s n^3)
/// operations for blocks of size n <= s.
template <class K>
polynomial<K> determinant_of_one_minus_z(const dense<K>& m) {
    detail::require_square(m, "determinant_of_one_minus_z");
    const auto n = m.rows();
    polynomial<K> product{K(1)};
    for (Eigen::Index first = 0, end = 0; first < n; first = end) {
        end = first + 1;  // the block ends where no row above reaches further right
        for (Eigen::Index i = first; i < end; ++i) {
            for (Eigen::Index j = n - 1; j >= end; --j) {
                if (m(i, j) == K(0)) continue;
                end = j + 1;
                break;
            }
        }
        const dense<K> block = m.block(first, first, end - first, end - first);
        product = product * polynomial<K>(detail::characteristic_coefficients<K>(block));
    }
    return product;
}

/// Sylvester's inertia.
struct inertia {
    int positive = 0;
    int zero = 0;
    int negative = 0;
    friend constexpr bool operator==(const inertia&, const inertia&) = default;
};

/// The congruence V M V^T = diag(pivots) of a symmetric M: an exact L D L^T with diagonal pivoting; where the
/// whole remaining diagonal vanishes, two rows are added first. Row k of V shows the sign of its pivot:
/// v^T M v = pivots[k].
template <class K>
struct diagonalised {
    column<K> pivots;
    dense<K> rows;

    tableaux::inertia inertia() const {
        tableaux::inertia n;
        for (Eigen::Index k = 0; k < pivots.size(); ++k) {
            (pivots[k] == K(0) ? n.zero : pivots[k] < K(0) ? n.negative : n.positive) += 1;
        }
        return n;
    }
    /// A vector v with v^T M v < 0, or nothing where M is positive semidefinite.
    std::optional<column<K>> negative_direction() const {
        for (Eigen::Index k = 0; k < pivots.size(); ++k) {
            if (pivots[k] < K(0)) return column<K>(rows.row(k).transpose());
        }
        return {};
    }
};

/// Throws std::invalid_argument where M is not symmetric. O(n^3).
template <class K>
diagonalised<K> diagonalise(dense<K> m) {
    detail::require_square(m, "diagonalise");
    const auto n = m.rows();
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < i; ++j) {
            if (!(m(i, j) == m(j, i)))
                throw std::invalid_argument("diagonalise: the matrix is not symmetric");
        }
    }
    diagonalised<K> out{column<K>(n), identity<K>(n)};
    // row i += f row j and column i += f column j
    const auto add = [&](Eigen::Index i, Eigen::Index j, const K& f) {
        for (Eigen::Index k = 0; k < n; ++k) m(i, k) = m(i, k) + f * m(j, k);
        for (Eigen::Index k = 0; k < n; ++k) m(k, i) = m(k, i) + f * m(k, j);
        for (Eigen::Index k = 0; k < n; ++k) out.rows(i, k) = out.rows(i, k) + f * out.rows(j, k);
    };
    for (Eigen::Index k = 0; k < n; ++k) {
        Eigen::Index p = k;
        while (p < n && m(p, p) == K(0)) ++p;
        if (p == n) {
            for (Eigen::Index i = k; i < n && p == n; ++i) {
                for (Eigen::Index j = i + 1; j < n && p == n; ++j) {
                    if (m(i, j) == K(0)) continue;
                    add(i, j, K(1));
                    p = i;
                }
            }
        }
        if (p == n) break;  // nothing but zeros is left
        if (p != k) {
            m.row(p).swap(m.row(k));
            m.col(p).swap(m.col(k));
            out.rows.row(p).swap(out.rows.row(k));
        }
        for (Eigen::Index i = k + 1; i < n; ++i) {
            if (!(m(i, k) == K(0))) add(i, k, K(0) - m(i, k) / m(k, k));
        }
    }
    for (Eigen::Index k = 0; k < n; ++k) out.pivots[k] = m(k, k);
    return out;
}

}  // namespace stagecraft::tableaux
