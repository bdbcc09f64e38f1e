// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <stagecraft/linear/columns.hpp>
#include <stagecraft/linear/elimination_order.hpp>

namespace stagecraft {

/// The pattern of a dense matrix most of whose entries are zero (kinetics, circuits, chains of masses), and an order in which
/// it is eliminated. Entries: what knows a matrix by a.holds(place) which entries are there, and by a.zeros(n n) how many
/// are not; place is i + n j.
class few_entries {
  public:
    /// Looks at the matrix of n columns a; false if it is too full to gain by it.
    template <class Entries>
    bool read(const Entries& a, int n) {
        if (n < smallest) return false;
        const int zeros = a.zeros(n * n);
        if (2 * zeros < n * n) return false;
        const auto nonzero = [&](std::ptrdiff_t place) { return a.holds(place); };
        changed_ = n * n - zeros != static_cast<int>(pattern_.size()) ||
                   !std::all_of(pattern_.begin(), pattern_.end(), nonzero);
        if (changed_) {
            pattern_.clear();
            pattern_.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n) / 2 + 1);
            for (int place = 0; place < n * n; ++place)
                if (nonzero(place)) pattern_.push_back(place);
            useful_ = order_.find(n, nonzero);
        }
        return useful_;
    }
    /// The matrix had another pattern than the one before.
    bool changed() const { return changed_; }
    const elimination_order& order() const { return order_; }

  private:
    static constexpr int smallest = 8;  // below, loops without indices are as fast
    elimination_order order_;
    std::vector<int> pattern_;  // places of the entries that are not zero
    bool useful_ = false, changed_ = false;
};

template <class Scalar>
bool any_positive(const Scalar& x) {
    return x > Scalar(0);
}

/// The factors of such a matrix: only entries that are not zero, or are filled, are touched. All pivots are on the
/// diagonal. Number: real, complex, or the numbers of several matrices of the same pattern.
template <class Scalar, class Number>
class sparse_factors {
    using size_type = decltype(size_of(std::declval<Number>()));

  public:
    /// Takes storage for n columns.
    void resize(const elimination_order& order, int n) {
        x_.assign(static_cast<std::size_t>(n), Number(Scalar(0)));
        largest_l_.resize(x_.size());
        largest_u_.resize(x_.size());
        values_.resize(static_cast<std::size_t>(order.size()));
    }

    /// Factors the matrix of entries a[place], on the diagonal a.on_diagonal(place) where there is such a thing. False if
    /// something is not finite, or what has been subtracted somewhere is more than ten times the largest entry of its
    /// row, and elsewhere of its column. (The error is n eps |L| |U|, N. J. Higham, Accuracy and Stability of Numerical
    /// Algorithms, SIAM 2002, Theorem 9.3, which either bound keeps small, whatever the units of unknowns and equations
    /// are.) Column by column: the columns of L before it are subtracted from each, which is spread out in x_ meanwhile.
    template <class Entries>
    bool factor(const elimination_order& order, const Entries& a) {
        const int n = static_cast<int>(x_.size());
        const int* row = order.rows();
        const size_type zero = size_of(Number(Scalar(0))), one = size_of(Number(Scalar(1)));
        std::fill(largest_l_.begin(), largest_l_.end(), one);
        std::fill(largest_u_.begin(), largest_u_.end(), zero);
        size_type excess = zero;
        for (int j = 0; j < n; ++j) {
            const int diagonal = order.diagonal(j), end = order.start(j + 1);
            for (int t = order.start(j); t < end; ++t) x_[row[t]] = Number(Scalar(0));
            size_type largest = zero, sum = zero;
            for (int t = order.first(j); t < order.first(j + 1); ++t) {
                const Number v = x_[order.entry_at(t).row] = entry(order, a, t, j);
                raise(largest, size_of(v));
            }
            for (int t = order.start(j); t < diagonal; ++t) {
                const int k = row[t];
                const Number u = values_[t] = x_[k];
                const size_type size = size_of(u);
                sum = sum + size;
                raise(largest_u_[k], size);
                raise(excess, size * largest_l_[k] - Scalar(growth) * largest);
                for (int l = order.diagonal(k) + 1; l < order.start(k + 1); ++l)
                    x_[row[l]] = x_[row[l]] - values_[l] * u;
            }
            const size_type pivot = size_of(x_[j]);
            raise(largest_u_[j], pivot);
            if (!usable_pivot(pivot) || !usable_pivot(sum + pivot)) return false;
            const Number inverse = values_[diagonal] = inverse_of(x_[j]);
            for (int t = diagonal + 1; t < end; ++t) {
                values_[t] = x_[row[t]] * inverse;
                const size_type size = size_of(values_[t]);
                raise(largest_l_[j], size);
                sum = sum + size;
            }
            raise(excess, largest_l_[j] * pivot - Scalar(growth) * largest);
            if (!usable_pivot(sum + pivot)) return false;
        }
        return !any_positive(excess) || small_in_rows(order, a);
    }

    /// x := A^-1 x, where x is read by get(i) and written by set(i, number). Part(value) is what of the factors is
    /// solved with: all of it, or those of one matrix.
    template <class Part, class Vector, class Get, class Set>
    void solve(const elimination_order& order, Vector& x, const Part& part, const Get& get,
               const Set& set) const {
        const int n = static_cast<int>(x_.size());
        const int* row = order.rows();
        for (int k = 0; k < n; ++k) x[k] = get(order[k]);
        for (int k = 0; k < n; ++k) {
            const auto v = x[k];
            for (int t = order.diagonal(k) + 1; t < order.start(k + 1); ++t)
                x[row[t]] = x[row[t]] - part(values_[t]) * v;
        }
        for (int k = n - 1; k >= 0; --k) {
            const int diagonal = order.diagonal(k);
            const auto v = x[k] * part(values_[diagonal]);
            set(order[k], v);
            for (int t = order.start(k); t < diagonal; ++t) x[row[t]] = x[row[t]] - part(values_[t]) * v;
        }
    }
    template <class Get, class Set>
    void solve(const elimination_order& order, const Get& get, const Set& set) {
        solve(
            order, x_, [](const Number& v) -> const Number& { return v; }, get, set);
    }

    /// The reciprocal of pivot k.
    const Number& inverse_pivot(const elimination_order& order, int k) const {
        return values_[order.diagonal(k)];
    }

  private:
    template <class Entries>
    static Number entry(const elimination_order& order, const Entries& a, int t, int column) {
        const auto& at = order.entry_at(t);
        if constexpr (requires { a.on_diagonal(at.place); })
            if (at.row == column) return a.on_diagonal(at.place);
        return a[at.place];
    }
    template <class Entries>
    bool small_in_rows(const elimination_order& order, const Entries& a) {
        const int n = static_cast<int>(x_.size());
        size_type excess = size_of(Number(Scalar(0)));
        std::fill(largest_l_.begin(), largest_l_.end(), excess);  // from here on: entries of the rows of a
        for (int j = 0; j < n; ++j)
            for (int t = order.first(j); t < order.first(j + 1); ++t)
                raise(largest_l_[order.entry_at(t).row], size_of(entry(order, a, t, j)));
        for (int k = 0; k < n; ++k) {
            raise(excess, largest_u_[k] - Scalar(growth) * largest_l_[k]);
            for (int t = order.diagonal(k) + 1; t < order.start(k + 1); ++t)
                raise(excess,
                      size_of(values_[t]) * largest_u_[k] - Scalar(growth) * largest_l_[order.rows()[t]]);
        }
        return !any_positive(excess);
    }

    static void raise(size_type& largest, const size_type& size) {
        if constexpr (requires { largest.raise(size); })
            largest.raise(size);
        else if (size > largest)
            largest = size;
    }

    static constexpr int growth = 10;
    std::vector<Number> values_, x_;
    std::vector<size_type> largest_l_, largest_u_;  // of each column of L, of each row of U
};

/// Gaussian elimination of one such matrix; one that needs pivots elsewhere, or is too full, is left to `elimination`.
/// Column: real_column or complex_column; the matrix is given as one, or as anything that knows its entries as above.
template <class Column>
class sparse_elimination {
    using scalar = typename Column::scalar;
    using number = typename Column::number;

  public:
    /// Factors the matrix of n columns a. False if it is not for this class.
    template <class Entries = Column>
    bool factor(const Entries& a, int n) {
        factored_ = false;
        if (!few_.read(a, n)) return false;
        if (few_.changed()) factors_.resize(few_.order(), n);
        return factored_ = factors_.factor(few_.order(), a);
    }
    /// The last matrix has been factored here.
    bool factored() const { return factored_; }

    /// How many entries the factors have.
    int entries() const { return few_.order().size(); }

    /// x := A^-1 x.
    void solve(const Column& x) {
        factors_.solve(
            few_.order(), [&](int i) { return x[i]; }, [&](int i, const number& v) { x.set(i, v); });
    }

    /// The reciprocal of pivot k.
    const number& inverse_pivot(int k) const { return factors_.inverse_pivot(few_.order(), k); }

  private:
    few_entries few_;
    sparse_factors<scalar, number> factors_;
    bool factored_ = false;
};

}  // namespace stagecraft
