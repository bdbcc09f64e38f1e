// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include <stagecraft/linear/mass.hpp>

namespace stagecraft {

/// A combination of components, or of equations: sum_k value[k] x[at[k]].
template <class Scalar>
struct sparse_combination {
    std::vector<int> at;
    std::vector<Scalar> value;

    template <class Vector>
    Scalar of(const Vector& x) const {
        Scalar sum(0);
        for (std::size_t k = 0; k < at.size(); ++k) sum += value[k] * x[at[k]];
        return sum;
    }
};

/// The vectors that a constant mass matrix M takes to zero, the directions of algebraic components: an orthonormal basis,
/// found island by island, an island being components that M couples (the nodes of a circuit between which there are
/// capacitors). One island of m components costs m^3 operations; one of more than 200 is not looked at, and taken to be
/// regular, as the mass matrix of finite elements is.
template <class Scalar>
class mass_kernel {
  public:
    using combination = sparse_combination<Scalar>;

    explicit mass_kernel(const identity_mass&, int = 0) {}
    mass_kernel(const entry_mass<Scalar>& mass, int n) : values_(static_cast<std::size_t>(n)) {
        std::vector<int> root(static_cast<std::size_t>(n));
        std::iota(root.begin(), root.end(), 0);
        const auto find = [&](int i) {
            while (root[i] != i) i = root[i] = root[root[i]];
            return i;
        };
        for (const auto& e : mass.entries()) root[find(e.row)] = find(e.column);
        std::vector<int> place(static_cast<std::size_t>(n)), size(static_cast<std::size_t>(n), 0);
        for (int i = 0; i < n; ++i) place[i] = size[find(i)]++;
        std::vector<std::vector<Scalar>> blocks(static_cast<std::size_t>(n));
        std::vector<std::vector<int>> members(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i) members[find(i)].push_back(i);
        for (int i = 0; i < n; ++i)
            if (size[i] > 0 && find(i) == i && size[i] <= most)
                blocks[i].assign(static_cast<std::size_t>(size[i] * size[i]), Scalar(0));
        for (const auto& e : mass.entries())
            if (const int i = find(e.row), m = size[i]; m <= most)
                blocks[i][place[e.row] + m * place[e.column]] += e.value;
        for (int i = 0; i < n; ++i)
            if (!blocks[i].empty()) add_kernel(blocks[i], members[i], basis_);
        values_.resize(basis_.size());
    }

    bool empty() const { return basis_.empty(); }
    const std::vector<combination>& basis() const { return basis_; }
    /// x := its orthogonal projection onto the kernel.
    template <class Vector>
    void project(Vector& x) {
        for (std::size_t k = 0; k < basis_.size(); ++k) values_[k] = basis_[k].of(x);
        x.setZero();
        for (std::size_t k = 0; k < basis_.size(); ++k)
            for (std::size_t i = 0; i < basis_[k].at.size(); ++i)
                x[basis_[k].at[i]] += values_[k] * basis_[k].value[i];
    }
    /// x := x less that projection.
    template <class Vector>
    void remove(Vector& x) const {
        for (const combination& v : basis_) {  // they are orthogonal
            const Scalar part = v.of(x);
            for (std::size_t i = 0; i < v.at.size(); ++i) x[v.at[i]] -= part * v.value[i];
        }
    }

  private:
    static constexpr int most = 200;

    /// Adds the kernel of A, column by column, by elimination with complete pivoting; rows are scaled to size one.
    static void add_kernel(std::vector<Scalar>& A, const std::vector<int>& members,
                           std::vector<combination>& basis) {
        using std::abs;
        const int m = static_cast<int>(members.size());
        std::vector<int> column(members.size());
        std::iota(column.begin(), column.end(), 0);
        for (int i = 0; i < m; ++i) {
            Scalar largest(0);
            for (int j = 0; j < m; ++j) largest = std::max<Scalar>(largest, abs(A[i + m * j]));
            if (largest > Scalar(0))
                for (int j = 0; j < m; ++j) A[i + m * j] /= largest;
        }
        int rank = 0;
        for (; rank < m; ++rank) {
            int row = rank, at = rank;
            for (int j = rank; j < m; ++j)
                for (int i = rank; i < m; ++i)
                    if (abs(A[i + m * j]) > abs(A[row + m * at])) row = i, at = j;
            if (!(abs(A[row + m * at]) > Scalar(8 * m) * std::numeric_limits<Scalar>::epsilon())) break;
            for (int j = 0; j < m; ++j) std::swap(A[rank + m * j], A[row + m * j]);
            for (int i = 0; i < m; ++i) std::swap(A[i + m * rank], A[i + m * at]);
            std::swap(column[rank], column[at]);
            for (int i = rank + 1; i < m; ++i) {
                const Scalar factor = A[i + m * rank] / A[rank + m * rank];
                for (int j = rank; j < m; ++j) A[i + m * j] -= factor * A[rank + m * j];
            }
        }
        const std::size_t first = basis.size();
        for (int j = rank; j < m; ++j) {
            std::vector<Scalar> x(members.size(), Scalar(0)), value(members.size());
            x[j] = Scalar(1);
            for (int i = rank - 1; i >= 0; --i) {
                for (int k = i + 1; k < m; ++k) x[i] -= A[i + m * k] * x[k];
                x[i] /= A[i + m * i];
            }
            for (int i = 0; i < m; ++i) value[column[i]] = x[i];
            basis.push_back({members, value});
            orthonormalise(basis, first);
        }
    }
    /// Makes the last vector orthogonal to those from `first` on, and of length one.
    static void orthonormalise(std::vector<combination>& basis, std::size_t first) {
        using std::sqrt;
        std::vector<Scalar>& x = basis.back().value;
        const auto product = [&](const std::vector<Scalar>& y) {
            return std::inner_product(x.begin(), x.end(), y.begin(), Scalar(0));
        };
        for (int twice = 0; twice < 2; ++twice)
            for (std::size_t k = first; k + 1 < basis.size(); ++k) {
                const Scalar part = product(basis[k].value);
                for (std::size_t i = 0; i < x.size(); ++i) x[i] -= part * basis[k].value[i];
            }
        const Scalar length = sqrt(product(x));
        for (Scalar& value : x) value /= length;
    }

    std::vector<combination> basis_;
    std::vector<Scalar> values_;
};

}  // namespace stagecraft
