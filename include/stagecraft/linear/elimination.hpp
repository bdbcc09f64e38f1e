// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <utility>

#include <stagecraft/linear/columns.hpp>
#include <stagecraft/linear/split_lu.hpp>

namespace stagecraft {

/// Up to Column::together columns with factors, to be subtracted from another column at once.
template <class Column>
class multiples {
  public:
    void add(const Column& a, const typename Column::number& factor) {
        a_[count_] = a;
        factor_[count_++] = factor;
    }
    /// x := x - the sum of the multiples, in rows first ... last - 1.
    [[gnu::noinline, gnu::flatten]] void subtract_from(const Column& x, int first, int last) const {
        int k = 0;
        const auto some = [&]<int K>(std::integral_constant<int, K>) {
            for (; count_ - k >= K; k += K)
                x.subtract(first, last, a_ + k, factor_ + k, std::make_integer_sequence<int, K>());
        };
        if (first >= last) return;
        if constexpr (Column::together >= 8) some(std::integral_constant<int, 8>());
        some(std::integral_constant<int, 4>());
        some(std::integral_constant<int, 2>());
        some(std::integral_constant<int, 1>());
    }

  private:
    Column a_[Column::together];
    typename Column::number factor_[Column::together];
    int count_ = 0;
};

/// Gaussian elimination with row pivoting of an n x n matrix, kept by columns of length n; L without its
/// diagonal and U, its diagonal inverted, replace the entries. Column::together columns are eliminated from
/// each of the others at once: they stay in the nearest cache, the other column is read and written once for
/// all of them. A multiplier that is zero costs nothing: where J has few entries (kinetics), most are.
template <class Column>
class elimination {
    using scalar = typename Column::scalar;
    using number = typename Column::number;
    static constexpr int together = Column::together;

  public:
    elimination(const Column& entries, int* pivot, int n) : a_(entries), pivot_(pivot), n_(n) {}

    /// False if the matrix is singular or not finite. `negative`: the sign of the product of the row
    /// exchanges.
    bool factor(bool& negative) const {
        negative = false;
        for (int first = 0, last; first < n_; first = last) {
            last = std::min(first + Column::together, n_);
            for (int j = first; j < last; ++j) {
                const Column x = column(j);
                exchange(x, first, j);
                eliminate(x, first, j);
                if (!choose_pivot(x, j)) return false;
                negative ^= pivot_[j] != j;
                if (pivot_[j] != j)
                    for (int k = first; k <= j; ++k) column(k).swap(j, pivot_[j]);
                const number inverse = inverse_of(x[j]);
                x.set(j, inverse);
                x.scale(j + 1, n_, inverse);
            }
            for (int j = 0; j < first; ++j) exchange(column(j), first, last);
            for (int j = last; j < n_; ++j) {
                exchange(column(j), first, last);
                eliminate(column(j), first, last);
            }
        }
        return true;
    }

    /// x := A^-1 x.
    void solve(const Column& x) const {
        exchange(x, 0, n_);
        for (int first = 0; first < n_; first += Column::together)
            eliminate(x, first, std::min(first + Column::together, n_));
        for (int last = n_, first; last > 0; last = first) {
            first = std::max(0, last - Column::together);
            multiples<Column> terms;
            for (int k = last - 1; k >= first; --k) {
                const Column u = column(k);
                const number v = x[k] * u[k];
                x.set(k, v);
                for (int i = first; i < k; ++i) x.set(i, x[i] - u[i] * v);
                terms.add(u, v);
            }
            terms.subtract_from(x, 0, first);
        }
    }

  private:
    Column column(int j) const { return a_ + static_cast<std::ptrdiff_t>(j) * n_; }

    void exchange(const Column& x, int first, int last) const {
        for (int k = first; k < last; ++k)
            if (pivot_[k] != k) x.swap(k, pivot_[k]);
    }

    /// Makes x[k], first <= k < last, the multipliers of columns k of L in x and subtracts these multiples.
    /// What is skipped because of a multiplier 0 is 0 times a number known to be finite.
    void eliminate(const Column& x, int first, int last) const {
        if (last - first == together) return eliminate_panel(x, first);
        multiples<Column> terms;
        for (int k = first; k < last; ++k) {
            const number v = x[k];
            if (is_zero(v)) continue;
            const Column l = column(k);
            for (int i = k + 1; i < last; ++i) x.set(i, x[i] - l[i] * v);
            terms.add(l, v);
        }
        terms.subtract_from(x, last, n_);
    }
    [[gnu::flatten]] void eliminate_panel(const Column& x, int first) const {
        number v[together];
        bool all_zero = true, some_zero = false;
        unrolled<together>(together, [&](auto k) {
            v[k] = x[first + k];
            all_zero &= is_zero(v[k]);
        });
        if (all_zero) return;
        unrolled<together>(together, [&](auto k) {
            const Column l = column(first + k);
            unrolled<together - 1 - k>(together, [&](auto i) {
                constexpr int row = decltype(k)::value + 1 + decltype(i)::value;
                v[row] = v[row] - l[first + row] * v[k];
            });
            x.set(first + k, v[k]);
            some_zero |= is_zero(v[k]);
        });
        multiples<Column> terms;
        if (some_zero) {
            for (int k = 0; k < together; ++k)
                if (!is_zero(v[k])) terms.add(column(first + k), v[k]);
        } else {
            for (int k = 0; k < together; ++k) terms.add(column(first + k), v[k]);
        }
        terms.subtract_from(x, first + together, n_);
    }

    /// The largest entry on and below the diagonal; false if it is zero or one of them is not finite.
    bool choose_pivot(const Column& x, int j) const {
        scalar largest = size_of(x[j]), sum = largest;
        int p = j;
        for (int i = j + 1; i < n_; ++i) {
            const scalar candidate = size_of(x[i]);
            sum += candidate;
            if (candidate > largest) largest = candidate, p = i;
        }
        pivot_[j] = p;
        return usable_pivot(sum);
    }

    Column a_;
    int* pivot_;
    int n_;
};

}  // namespace stagecraft
