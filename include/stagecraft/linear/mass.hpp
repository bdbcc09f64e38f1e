// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include <stagecraft/linear/combinations.hpp>

namespace stagecraft {

/// The identity as mass matrix, that of y' = f: nothing is stored and nothing is multiplied.
struct identity_mass {
    static constexpr bool identity = true;
};

/// A constant mass matrix kept as the list of its nonzero entries. That suits both of its uses, the product M
/// x and adding a multiple of M to a matrix, as mass matrices in practice are diagonal, banded or block
/// sparse.
template <class Scalar>
class entry_mass {
  public:
    static constexpr bool identity = false;
    struct entry {
        int row, column;
        Scalar value;
    };

    /// From a dense, diagonal or sparse matrix of Eigen, or from a banded_matrix.
    template <class Matrix>
    explicit entry_mass(const Matrix& m) {
        if constexpr (requires {
                          typename Matrix::InnerIterator;
                          m.isCompressed();
                      }) {
            for (Eigen::Index k = 0; k < m.outerSize(); ++k)
                for (typename Matrix::InnerIterator it(m, k); it; ++it)
                    add(static_cast<int>(it.row()), static_cast<int>(it.col()), it.value());
        } else if constexpr (
            requires { m.diagonal(); } && !requires { m(0, 0); }) {
            for (int i = 0; i < m.rows(); ++i) add(i, i, m.diagonal()[i]);
        } else if constexpr (requires { m.in_band(0, 0); }) {
            for (int j = 0; j < m.cols(); ++j)
                for (int i = 0; i < m.rows(); ++i)
                    if (m.in_band(i, j)) add(i, j, m(i, j));
        } else {
            for (int j = 0; j < m.cols(); ++j)
                for (int i = 0; i < m.rows(); ++i) add(i, j, m(i, j));
        }
    }

    const std::vector<entry>& entries() const { return entries_; }
    entry_mass transposed() const {
        entry_mass result = *this;
        for (auto& e : result.entries_) std::swap(e.row, e.column);
        return result;
    }

  private:
    void add(int i, int j, const Scalar& value) {
        if (!(value == Scalar(0))) entries_.push_back({i, j, value});
    }
    std::vector<entry> entries_;
};

/// A constant mass matrix that is known by its products alone (Operator::add_times).
template <class Operator>
class mass_by_products {
  public:
    static constexpr bool identity = false;
    explicit mass_by_products(const Operator& m) : operator_(m) {}
    const Operator& get() const { return operator_; }

  private:
    Operator operator_;
};

/// True if the entries of a mass matrix can be looked at.
template <class Mass>
inline constexpr bool has_entries = Mass::identity || requires(const Mass& m) {
    m.entries();
};

/// Adds `factor` M x to r, both pointers to n contiguous numbers.
template <class Scalar>
void add_mass_times(const identity_mass&, const Scalar& factor, const Scalar* x, Scalar* r, int n) {
    combine<true, 1>(n, 1, &factor, x, r);
}
/// The same with the entries that M has.
template <class Scalar>
void add_mass_times(const entry_mass<Scalar>& m, const Scalar& factor, const Scalar* x, Scalar* r, int) {
    for (const auto& e : m.entries()) r[e.row] += factor * e.value * x[e.column];
}

/// The same with an operator of the problem's own.
template <class Operator, class Scalar>
void add_mass_times(const mass_by_products<Operator>& m, const Scalar& factor, const Scalar* x, Scalar* r,
                    int) {
    m.get().add_times(factor, x, r);
}

/// Adds `factor` M to the dense matrix given by its column-major entries with leading dimension n.
template <class Scalar>
void add_mass(const identity_mass&, const Scalar& factor, Scalar* a, int n) {
    for (int i = 0; i < n; ++i) a[i + i * n] += factor;
}
template <class Scalar>
void add_mass(const entry_mass<Scalar>& m, const Scalar& factor, Scalar* a, int n) {
    for (const auto& e : m.entries()) a[e.row + e.column * n] += factor * e.value;
}

namespace detail {

/// write(row, column, value) for every entry of M, n x n, without its first rows and columns, which are not counted.
template <class Write>
void for_mass(const identity_mass&, int first, int n, const Write& write) {
    for (int i = 0; i < n - first; ++i) write(i, i, 1);
}
template <class Scalar, class Write>
void for_mass(const entry_mass<Scalar>& m, int first, int, const Write& write) {
    for (const auto& e : m.entries())
        if (e.row >= first && e.column >= first) write(e.row - first, e.column - first, e.value);
}

}  // namespace detail

}  // namespace stagecraft
