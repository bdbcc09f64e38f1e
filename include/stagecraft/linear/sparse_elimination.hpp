// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <stagecraft/linear/columns.hpp>
#include <stagecraft/linear/elimination_order.hpp>

namespace stagecraft {

/// Gaussian elimination of a dense matrix most of whose entries are zero (kinetics, circuits, chains of masses): only
/// entries that are not zero, or are filled, are touched. All pivots are on the diagonal; a matrix that needs others,
/// or is too full to gain by this, is left to `elimination`. Column: real_column or complex_column; the matrix is given as
/// one, or as anything that knows its entries by a[i + n j], by a.holds(place) which are there, and by a.zeros(n n)
/// how many are not.
template <class Column>
class sparse_elimination {
    using scalar = typename Column::scalar;
    using number = typename Column::number;

  public:
    /// Factors the matrix of n columns a. False if it is not for this class: too full, something is not finite, or
    /// what has been subtracted somewhere is more than ten times the largest entry of its row, and elsewhere of its
    /// column. (The error is n eps |L| |U|, N. J. Higham, Accuracy and Stability of Numerical Algorithms, SIAM 2002,
    /// Theorem 9.3, which either bound keeps small, whatever the units of unknowns and equations are.)
    template <class Entries = Column>
    bool factor(const Entries& a, int n) {
        factored_ = false;
        if (n < smallest) return false;
        const int zeros = a.zeros(n * n);
        if (2 * zeros < n * n) return false;
        const auto nonzero = [&](std::ptrdiff_t place) { return a.holds(place); };
        if (n * n - zeros != static_cast<int>(pattern_.size()) ||
            !std::all_of(pattern_.begin(), pattern_.end(), nonzero)) {
            pattern_.clear();
            pattern_.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n) / 2 + 1);
            for (int place = 0; place < n * n; ++place)
                if (nonzero(place)) pattern_.push_back(place);
            useful_ = order_.find(n, nonzero);
            x_.assign(static_cast<std::size_t>(n), number(scalar(0)));
            largest_l_.resize(x_.size());
            largest_u_.resize(x_.size());
            if (useful_) values_.resize(static_cast<std::size_t>(order_.size()));
        }
        if (useful_) factored_ = eliminate(a, n);
        return factored_;
    }
    /// The last matrix has been factored here.
    bool factored() const { return factored_; }

    /// How many entries the factors have.
    int entries() const { return order_.size(); }

    /// x := A^-1 x.
    void solve(const Column& x) {
        const int n = static_cast<int>(x_.size());
        const int* row = order_.rows();
        for (int k = 0; k < n; ++k) x_[k] = x[order_[k]];
        for (int k = 0; k < n; ++k) {
            const number v = x_[k];
            for (int t = order_.diagonal(k) + 1; t < order_.start(k + 1); ++t)
                x_[row[t]] = x_[row[t]] - values_[t] * v;
        }
        for (int k = n - 1; k >= 0; --k) {
            const int diagonal = order_.diagonal(k);
            const number v = x_[k] * values_[diagonal];
            x.set(order_[k], v);
            for (int t = order_.start(k); t < diagonal; ++t) x_[row[t]] = x_[row[t]] - values_[t] * v;
        }
    }

    /// The reciprocal of pivot k.
    const number& inverse_pivot(int k) const { return values_[order_.diagonal(k)]; }

  private:
    static constexpr int smallest = 8;  // below, loops without indices are as fast

    /// Column by column: the columns of L before it are subtracted from each, which is spread out in x_ meanwhile.
    template <class Entries>
    bool eliminate(const Entries& a, int n) {
        const int* row = order_.rows();
        std::fill(largest_l_.begin(), largest_l_.end(), scalar(1));
        std::fill(largest_u_.begin(), largest_u_.end(), scalar(0));
        bool small_in_columns = true;
        for (int j = 0; j < n; ++j) {
            const int diagonal = order_.diagonal(j), end = order_.start(j + 1);
            for (int t = order_.start(j); t < end; ++t) x_[row[t]] = number(scalar(0));
            scalar largest(0), sum(0);
            for (int t = order_.first(j); t < order_.first(j + 1); ++t) {
                const number v = x_[order_.entry_at(t).row] = a[order_.entry_at(t).place];
                raise(largest, size_of(v));
            }
            for (int t = order_.start(j); t < diagonal; ++t) {
                const int k = row[t];
                const number u = values_[t] = x_[k];
                const scalar size = size_of(u);
                sum += size;
                raise(largest_u_[k], size);
                small_in_columns &= size * largest_l_[k] <= growth * largest;
                for (int l = order_.diagonal(k) + 1; l < order_.start(k + 1); ++l)
                    x_[row[l]] = x_[row[l]] - values_[l] * u;
            }
            const scalar pivot = size_of(x_[j]);
            raise(largest_u_[j], pivot);
            if (!(pivot > scalar(0)) || !usable_pivot(sum + pivot)) return false;
            const number inverse = values_[diagonal] = inverse_of(x_[j]);
            for (int t = diagonal + 1; t < end; ++t) {
                values_[t] = x_[row[t]] * inverse;
                const scalar size = size_of(values_[t]);
                raise(largest_l_[j], size);
                sum += size;
            }
            small_in_columns &= largest_l_[j] * pivot <= growth * largest;
            if (!usable_pivot(sum + pivot)) return false;
        }
        return small_in_columns || small_in_rows(a, n);
    }
    template <class Entries>
    bool small_in_rows(const Entries& a, int n) {
        std::fill(largest_l_.begin(), largest_l_.end(), scalar(0));  // from here on: entries of the rows of a
        for (int t = 0; t < order_.entries(); ++t)
            raise(largest_l_[order_.entry_at(t).row], size_of(a[order_.entry_at(t).place]));
        bool small = true;
        for (int k = 0; k < n; ++k) {
            small &= largest_u_[k] <= growth * largest_l_[k];
            for (int t = order_.diagonal(k) + 1; t < order_.start(k + 1); ++t)
                small &= size_of(values_[t]) * largest_u_[k] <= growth * largest_l_[order_.rows()[t]];
        }
        return small;
    }
    static void raise(scalar& largest, const scalar& size) {
        if (size > largest) largest = size;
    }

    static constexpr int growth = 10;
    elimination_order order_;
    std::vector<int> pattern_;  // places of the entries that are not zero
    std::vector<number> values_, x_;
    std::vector<scalar> largest_l_, largest_u_;  // of each column of L, of each row of U
    bool useful_ = false, factored_ = false;
};

}  // namespace stagecraft
