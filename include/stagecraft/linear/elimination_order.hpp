// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace stagecraft {

/// In which order a matrix with few entries is eliminated, with pivots on its diagonal, and where its factors have
/// entries: the pivot of least (r - 1) (c - 1) comes next, r and c being how many entries its row and column have
/// left (H. M. Markowitz, Management Sci. 3 (1957) 255-269). It follows from the pattern alone, so that equal
/// matrices have equal factors, whatever has been factored before.
class elimination_order {
  public:
    /// An entry of the matrix: its row in this order, and its place in the matrix, which is kept by columns.
    struct entry {
        int row, place;
    };

    /// True if elimination in this order costs less than without regard to zeros; nonzero(place) tells the pattern.
    /// O(n^2) and, per pivot, n + (r + c) n / 64. Takes storage for n^2 indices when it is first called.
    template <class Nonzero>
    bool find(int n, const Nonzero& nonzero) {
        read(n, nonzero);
        order_.clear();
        long work = 0;
        for (int k = 0; k < n; ++k) {
            const int p = next();
            if (p < 0) return false;
            order_.push_back(p);
            remove(row(p), p);
            remove(column(p), p);
            const long right = *row(p).count, below = *column(p).count;
            work += entry_cost * (1 + right + below) + product_cost * right * below;
            if (work > static_cast<long>(n) * n * n / 3) return false;
            // What is left of row and column p is the pattern of the factors. It fills the others, and they lose p.
            each(row(p), [&](int j) { join(column(j), column(p), p); });
            each(column(p), [&](int i) { join(row(i), row(p), p); });
        }
        write(n, nonzero);
        return true;
    }

    /// The unknown that is eliminated as number k.
    int operator[](int k) const { return order_[k]; }

    // Column j of the factors, in this order, has its entries from start(j) to start(j + 1) - 1: U by ascending rows,
    // the diagonal at diagonal(j), and L.
    int start(int j) const { return start_[j]; }
    int diagonal(int j) const { return diagonal_[j]; }
    const int* rows() const { return row_.data(); }
    int size() const { return static_cast<int>(row_.size()); }

    // Column j of the matrix, in this order, has its entries from first(j) to first(j + 1) - 1.
    int first(int j) const { return first_[j]; }
    const entry& entry_at(int t) const { return entries_[t]; }
    int entries() const { return static_cast<int>(entries_.size()); }

  private:
    // Costs in products of two numbers in a loop without indices, as measured.
    static constexpr long product_cost = 4, entry_cost = 8;

    /// A set of numbers below n.
    struct set {
        std::uint64_t* bits;
        int* count;
    };
    set row(int i) { return set_at(i); }
    set column(int j) { return set_at(j + n_); }
    set left() { return set_at(2 * n_); }
    set set_at(int k) { return {bits_.data() + static_cast<std::size_t>(k) * words_, count_.data() + k}; }
    static std::uint64_t bit(int i) { return std::uint64_t(1) << (i % 64); }
    static bool has(const set& x, int i) { return (x.bits[i / 64] & bit(i)) != 0; }
    static void insert(const set& x, int i) {
        x.bits[i / 64] |= bit(i);
        ++*x.count;
    }
    static void remove(const set& x, int i) {
        x.bits[i / 64] &= ~bit(i);
        --*x.count;
    }
    /// x := x and y, without p.
    void join(const set& x, const set& y, int p) const {
        x.bits[p / 64] &= ~bit(p);
        *x.count = 0;
        for (std::size_t w = 0; w < words_; ++w) *x.count += std::popcount(x.bits[w] |= y.bits[w]);
    }
    template <class F>
    void each(const set& x, F&& f) const {
        for (std::size_t w = 0; w < words_; ++w)
            for (std::uint64_t rest = x.bits[w]; rest != 0; rest &= rest - 1)
                f(static_cast<int>(64 * w) + std::countr_zero(rest));
    }

    template <class Nonzero>
    void read(int n, const Nonzero& nonzero) {
        n_ = n;
        const std::size_t size = static_cast<std::size_t>(n);
        words_ = (size + 63) / 64;
        bits_.assign((2 * size + 1) * words_, 0);
        count_.assign(2 * size + 1, 0);
        number_.resize(size);
        for (std::vector<int>* all : {&order_, &start_, &diagonal_, &first_}) all->reserve(size + 1);
        row_.reserve(size * size);
        entries_.reserve(size * size / 2 + 1);
        for (int j = 0; j < n; ++j) {
            insert(left(), j);
            for (int i = 0; i < n; ++i)
                if (nonzero(i + j * n)) {
                    insert(row(i), j);
                    insert(column(j), i);
                }
        }
    }
    /// The pivot of least fill, not to be met again; -1 if what is left of the diagonal is zero.
    int next() {
        int best = -1;
        long least = 0;
        each(left(), [&](int i) {
            if (!has(row(i), i)) return;
            const long fill = static_cast<long>(*row(i).count - 1) * (*column(i).count - 1);
            if (best < 0 || fill < least) least = fill, best = i;
        });
        if (best >= 0) remove(left(), best);
        return best;
    }
    template <class Nonzero>
    void write(int n, const Nonzero& nonzero) {
        diagonal_.assign(order_.size(), 0);
        for (int k = 0; k < n; ++k) {
            number_[order_[k]] = k;
            each(row(order_[k]), [&](int j) { ++diagonal_[j]; });  // how many entries of U are above it
        }
        start_.assign(1, 0);
        for (int k = 0; k < n; ++k)
            start_.push_back(start_[k] + diagonal_[order_[k]] + 1 + *column(order_[k]).count);
        row_.resize(static_cast<std::size_t>(start_[n]));
        for (int k = 0; k < n; ++k) diagonal_[k] = start_[k];
        for (int k = 0; k < n; ++k) {
            int at = diagonal_[k];  // all rows above have been put in
            row_[at] = k;
            each(column(order_[k]), [&](int i) { row_[++at] = number_[i]; });
            each(row(order_[k]), [&](int j) { row_[diagonal_[number_[j]]++] = k; });
        }
        first_.clear(), entries_.clear();
        for (int k = 0; k < n; ++k) {
            first_.push_back(entries());
            for (int i = 0; i < n; ++i) {
                const int place = i + order_[k] * n;
                if (nonzero(place)) entries_.push_back({number_[i], place});
            }
        }
        first_.push_back(entries());
    }

    int n_ = 0;
    std::size_t words_ = 0;
    // Rows, columns, and what is left: first the patterns of what is not yet eliminated, in the end of the factors.
    std::vector<std::uint64_t> bits_;
    std::vector<int> count_;
    std::vector<int> number_, order_, start_, diagonal_, row_, first_;
    std::vector<entry> entries_;
};

}  // namespace stagecraft
