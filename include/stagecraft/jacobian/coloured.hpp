// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stagecraft/jacobian/finite_difference.hpp>
#include <stagecraft/linear/banded_matrix.hpp>
#include <vector>

namespace stagecraft {

/// Calls f(i, entry) for every entry of column j that a banded or column-major sparse matrix stores.
template <class Scalar, class F>
void for_each_in_column(banded_matrix<Scalar>& J, int j, F&& f) {
    for (int i = std::max(0, j - J.upper()); i <= std::min(J.size() - 1, j + J.lower()); ++i) f(i, J(i, j));
}
/// The same for a sparse matrix, of which the stored zeros count.
template <class Sparse, class F>
requires requires(Sparse& m) {
    typename Sparse::InnerIterator;
    m.outerIndexPtr();
}
void for_each_in_column(Sparse& J, int j, F&& f) {
    static_assert(!Sparse::IsRowMajor, "problem.sparsity() must be column-major");
    for (typename Sparse::InnerIterator it(J, j); it; ++it) f(static_cast<int>(it.row()), it.valueRef());
}

/// df/dy of known structure by forward differences, one evaluation of f per group of columns that share no
/// row (Curtis, Powell and Reid 1974, columns taken in their order): lower + upper + 1 groups for a band.
template <class Vector>
class coloured_jacobian {
  public:
    using scalar = typename Vector::Scalar;

    explicit coloured_jacobian(Eigen::Index n) : y_(n), f_(n), step_(n) {}

    /// Finds the groups for the pattern of J.
    template <class Matrix>
    void group(Matrix& J) {
        const int n = static_cast<int>(J.cols());
        std::vector<std::vector<int>> columns_of_row(n);
        for (int j = 0; j < n; ++j)
            for_each_in_column(J, j, [&](int i, const scalar&) { columns_of_row[i].push_back(j); });
        std::vector<int> colour(n, -1), used_by(n, -1);
        groups_.clear();
        for (int j = 0; j < n; ++j) {
            for_each_in_column(J, j, [&](int i, const scalar&) {
                for (const int k : columns_of_row[i])
                    if (colour[k] >= 0) used_by[colour[k]] = j;
            });
            int c = 0;
            while (c < static_cast<int>(groups_.size()) && used_by[c] == j) ++c;
            if (c == static_cast<int>(groups_.size())) groups_.emplace_back();
            groups_[c].push_back(j);
            colour[j] = c;
        }
    }

    int groups() const { return static_cast<int>(groups_.size()); }

    /// Writes J, given f0 = f(t, y), what counts as negligible in every component, and how far a first step reaches;
    /// returns the evaluations.
    template <class Problem, class Matrix>
    int operator()(Problem& problem, const scalar& t, const Vector& y, const Vector& f0,
                   const Vector& negligible, const scalar& reach, Matrix& J) {
        int calls = 0;
        y_ = y;
        for (const auto& columns : groups_) {
            calls += take(problem, t, y, f0, negligible, reach, columns.data(),
                          columns.data() + columns.size(), J);
            if (columns.size() < 2 || f_.allFinite()) continue;
            for (const int& j :
                 columns)  // they may have to leave the border of the domain to different sides
                calls += take(problem, t, y, f0, negligible, reach, &j, &j + 1, J);
        }
        return calls;
    }

  private:
    /// The columns `first` ... `last`, which share no row; leaves f beside y in f_.
    template <class Problem, class Matrix>
    int take(Problem& problem, const scalar& t, const Vector& y, const Vector& f0, const Vector& negligible,
             const scalar& reach, const int* first, const int* last, Matrix& J) {
        using std::abs;
        using std::sqrt;
        const scalar root = sqrt(std::numeric_limits<scalar>::epsilon());
        const auto move = [&](const scalar& part) {
            for (const int* j = first; j != last; ++j) {
                const scalar size = abs(y[*j]) > negligible[*j] ? abs(y[*j]) : negligible[*j];
                y_[*j] = y[*j] + part * (root * (f0[*j] < scalar(0) ? scalar(-size) : size));
                step_[*j] = y_[*j] - y[*j];
            }
        };
        int calls = call_beside<scalar>(f_, move, [&] { problem(t, y_, f_); });
        const bool jump = may_have_jumped(f0, f_, negligible, reach);
        for (const int* j = first; j != last; ++j) {
            for_each_in_column(J, *j, [&](int i, scalar& entry) { entry = jump ? f_[i] : f0[i]; });
            if (jump) y_[*j] += step_[*j];
        }
        if (jump) {
            problem(t, y_, f_);
            ++calls;
            if (!f_.allFinite())  // then between none and one, which has f in the entries
                for (const int* j = first; j != last; ++j)
                    for_each_in_column(J, *j, [&](int i, scalar& entry) {
                        f_[i] = entry;
                        entry = f0[i];
                    });
        }
        for (const int* j = first; j != last; ++j) {
            for_each_in_column(J, *j, [&](int i, scalar& entry) { entry = (f_[i] - entry) / step_[*j]; });
            y_[*j] = y[*j];
        }
        return calls;
    }

    Vector y_, f_, step_;
    std::vector<std::vector<int>> groups_;
};

}  // namespace stagecraft
