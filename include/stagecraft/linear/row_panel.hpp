// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include <stagecraft/linear/packet.hpp>
#include <stagecraft/linear/split_complex.hpp>

namespace stagecraft::detail {

/// In packets where the processor knows the scalar, else number by number.
template <class Scalar>
using packet_or_single = std::conditional_t<built_in<Scalar>, packet<Scalar>, single<Scalar>>;

/// Matrices whose rows lie together in memory, as rows are what is combined: `rows` of width() numbers, which is `columns`
/// rounded up to whole packets (what fills them up is written as zero). The first `pivots` columns are eliminated by rows
/// with row pivoting. Each of the three numbers is known at compile time where the template's is not 0; with all of them the
/// loops are unrolled.
template <class Scalar, int Rows, int Columns, int Pivots>
class row_panel {
    using P = packet_or_single<Scalar>;
    static constexpr bool unrolled = built_in<Scalar> && Rows > 0 && Columns > 0 && Pivots > 0;
    static constexpr int width_of(int columns) { return (columns + P::size - 1) / P::size * P::size; }

  public:
    row_panel(int rows, int columns, int pivots) : rows_(rows), columns_(columns), pivots_(pivots) {}

    int rows() const { return Rows > 0 ? Rows : rows_; }
    int columns() const { return Columns > 0 ? Columns : columns_; }
    int pivots() const { return Pivots > 0 ? Pivots : pivots_; }
    int width() const { return width_of(columns()); }
    int size() const { return rows() * width(); }

    /// LU in place: multipliers below the diagonal, the reciprocals of the pivots on it; from[k] is the row that changed
    /// places with row k. Below a pivot that nothing can be divided by, multipliers are zero.
    void eliminate(Scalar* a, int* from) const {
        const auto one_alone = [&](const Scalar* top, auto k) { return subtraction(top, k); };
        if constexpr (unrolled) {
            for_pivots([&](auto k) { pivot(a, from, k, one_alone); });
        } else {
            int k = 0;
            for (; k + 1 < pivots(); k += 2) pivot_twice(a, from, k);
            if (k < pivots()) pivot(a, from, k, one_alone);
        }
    }

    /// x, `rows` numbers, as the elimination would have left it in another column. In every sum the newest number comes last,
    /// so that none waits for it.
    void forward(const Scalar* a, const int* from, Scalar* x) const {
        for (int k = 0; k < pivots(); ++k) std::swap(x[k], x[from[k]]);
        for_pivots([&](auto k) { x[k] = less(x[k], a + k * width(), x, 0, k); });
        for (int i = pivots(); i < rows(); ++i) x[i] = less(x[i], a + i * width(), x, 0, pivots());
    }

    /// The unknowns in the first `pivots` places of x, where the right-hand sides stand; behind them the unknowns of the next
    /// `known` columns.
    void back(const Scalar* a, int known, Scalar* x) const {
        for_pivots([&](auto last) {
            const int k = pivots() - 1 - last;
            const Scalar* row = a + k * width();
            Scalar sum = x[k];
            for (int l = pivots(); l < pivots() + known; ++l) sum -= row[l] * x[l];
            for (int l = pivots() - 1; l > k; --l) sum -= row[l] * x[l];
            x[k] = sum * row[k];
        });
    }

  private:
    /// act(k) for every pivot k.
    template <class Act>
    void for_pivots(const Act& act) const {
        if constexpr (unrolled) [&]<int... k>(std::integer_sequence<int, k...>) {
                (act(std::integral_constant<int, k>()), ...);
            }
        (std::make_integer_sequence<int, Pivots>());
        else for (int k = 0; k < pivots(); ++k) act(k);
    }

    /// Brings the largest pivot to row k and writes the multipliers of the rows below; what `subtraction_of` makes of the pivot's
    /// row subtracts its multiples from them.
    template <class Index, class Make>
    void pivot(Scalar* a, int* from, Index k, const Make& subtraction_of) const {
        Scalar* top = a + k * width();
        const bool usable = exchange(a, from, k);
        const auto subtract = subtraction_of(top, k);
        for (int i = k + 1; i < rows(); ++i) {
            Scalar* other = top + (i - k) * width();
            const Scalar by = usable ? Scalar(other[k] * top[k]) : Scalar(0);
            subtract(other, by);
            other[k] = by;
        }
    }

    /// pivot() for k and k + 1, to the same bits: only column k + 1 is needed to choose the second, and what both subtract
    /// from the others is read and written once.
    void pivot_twice(Scalar* a, int* from, int k) const {
        pivot(a, from, k, [](const Scalar* top, int column) {
            return [=](Scalar* other, const Scalar& by) { other[column + 1] -= by * top[column + 1]; };
        });
        const Scalar* one = a + k * width();
        pivot(a, from, k + 1, [=, row = width()](Scalar* two, int) {
            subtract_multiple(two[k], one, k + 2, row, two);
            return [=](Scalar* other, const Scalar& by) {
                subtract_multiples(other[k], one, by, two, k + 2, row, other);
            };
        });
    }

    /// Brings the largest pivot to row k, inverted; false if nothing can be divided by it.
    bool exchange(Scalar* a, int* from, int k) const {
        using std::abs;
        const int row = width();
        Scalar* top = a + k * row;
        int p = k;
        Scalar largest = abs(top[k]);
        for (int i = k + 1; i < rows(); ++i)
            if (const Scalar here = abs(a[i * row + k]); here > largest) largest = here, p = i;
        from[k] = p;
        if (p != k) std::swap_ranges(top, top + row, a + p * row);
        top[k] = Scalar(1) / top[k];
        return usable_pivot(largest);
    }

    /// What subtracts a multiple of row `top` from another behind column k. Unrolled, the row stays in registers; a packet may
    /// begin with column k itself, which is written afterwards.
    template <class Index>
    auto subtraction(const Scalar* top, Index k) const {
        if constexpr (unrolled) {
            constexpr int down = (Index::value + 1) / P::size * P::size,
                          begin = down >= Index::value ? down : down + P::size;
            constexpr int count = (width_of(Columns) - begin) / P::size;
            struct {
                typename P::type part[count > 0 ? count : 1];
            } held;
            for (int q = 0; q < count; ++q) held.part[q] = P::load(top + begin + q * P::size);
            return [held, top](Scalar* other, const Scalar& by) {
                if (by == Scalar(0)) return;
                for (int j = Index::value + 1; j < begin; ++j) other[j] -= by * top[j];
                for (int q = 0; q < count; ++q) {
                    Scalar* to = other + begin + q * P::size;
                    P::store(to, P::load(to) - P::all(by) * held.part[q]);
                }
            };
        } else {
            return [top, k, row = width()](Scalar* other, const Scalar& by) {
                subtract_multiple(by, top, k + 1, row, other);
            };
        }
    }

    /// The same between the columns `begin` and `end`, which ends a packet. Of few dependences most multipliers are zero.
    static void subtract_multiple(const Scalar by, const Scalar* top, int begin, int end, Scalar* other) {
        if (by == Scalar(0)) return;
        const auto all = P::all(by);
        for (; begin % P::size != 0 && begin < end; ++begin) other[begin] -= by * top[begin];
        for (; begin + 2 * P::size <= end; begin += 2 * P::size) {
            const auto one = P::load(other + begin) - all * P::load(top + begin),
                       two = P::load(other + begin + P::size) - all * P::load(top + begin + P::size);
            P::store(other + begin, one);
            P::store(other + begin + P::size, two);
        }
        for (; begin < end; begin += P::size)
            P::store(other + begin, P::load(other + begin) - all * P::load(top + begin));
    }

    /// The same with multiples x and y of two rows.
    static void subtract_multiples(const Scalar x, const Scalar* one, const Scalar y, const Scalar* two,
                                   int begin, int end, Scalar* other) {
        if (x == Scalar(0)) return subtract_multiple(y, two, begin, end, other);
        if (y == Scalar(0)) return subtract_multiple(x, one, begin, end, other);
        const auto all_x = P::all(x), all_y = P::all(y);
        const auto less_both = [&](int j) {
            return P::load(other + j) - all_x * P::load(one + j) - all_y * P::load(two + j);
        };
        for (; begin % P::size != 0 && begin < end; ++begin)
            other[begin] = other[begin] - x * one[begin] - y * two[begin];
        for (; begin + 2 * P::size <= end; begin += 2 * P::size) {
            const auto here = less_both(begin), behind = less_both(begin + P::size);
            P::store(other + begin, here);
            P::store(other + begin + P::size, behind);
        }
        for (; begin < end; begin += P::size) P::store(other + begin, less_both(begin));
    }

    /// sum less the products of row and x from `first` to before `last`.
    static Scalar less(Scalar sum, const Scalar* row, const Scalar* x, int first, int last) {
        for (int l = first; l < last; ++l) sum -= row[l] * x[l];
        return sum;
    }

    int rows_, columns_, pivots_;
};

/// out = a x + b y, `count` numbers each, Count where that is not 0; without y, which is nullptr then, a x.
template <int Count, class Scalar>
void add_multiples(int count, const Scalar& a, const Scalar* x, const Scalar& b,
                   std::type_identity_t<const Scalar*> y, Scalar* out) {
    using P = packet_or_single<Scalar>;
    if constexpr (Count > 0) count = Count;
    const auto all_a = P::all(a), all_b = P::all(b);
    int k = 0;
    if (y == nullptr) {
        for (; k + P::size <= count; k += P::size) P::store(out + k, all_a * P::load(x + k));
        for (; k < count; ++k) out[k] = a * x[k];
    } else {
        for (; k + P::size <= count; k += P::size)
            P::store(out + k, all_a * P::load(x + k) + all_b * P::load(y + k));
        for (; k < count; ++k) out[k] = a * x[k] + b * y[k];
    }
}

/// out = Q x, Q being rows x columns (those of the template where they are not 0) and given by columns, the numbers of x
/// `stride` apart.
template <int Rows, int Columns, class Scalar>
void transform(int rows, int columns, const Scalar* Q, const Scalar* x, int stride, Scalar* out) {
    using P = packet_or_single<Scalar>;
    if constexpr (Rows > 0) rows = Rows;
    if constexpr (Columns > 0) columns = Columns;
    int k = 0;
    for (; k + P::size <= rows; k += P::size) {
        auto sum = P::all(x[0]) * P::load(Q + k);
        for (int l = 1; l < columns; ++l) sum = sum + P::all(x[l * stride]) * P::load(Q + l * rows + k);
        P::store(out + k, sum);
    }
    for (; k < rows; ++k) {
        Scalar sum = x[0] * Q[k];
        for (int l = 1; l < columns; ++l) sum += x[l * stride] * Q[l * rows + k];
        out[k] = sum;
    }
}

}  // namespace stagecraft::detail
