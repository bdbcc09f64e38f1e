// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <stagecraft/linear/banded_matrix.hpp>
#include <stagecraft/linear/block_work.hpp>
#include <stagecraft/linear/complex_number.hpp>
#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/split_lu.hpp>
#include <type_traits>
#include <vector>

namespace stagecraft {

namespace detail {

/// f(a number of diagonals as a constant), 0 standing for none and for more than four: loops that short are unrolled.
template <class F>
bool with_count(int diagonals, F&& f) {
    switch (diagonals) {
        case 1:
            return f(std::integral_constant<int, 1>());
        case 2:
            return f(std::integral_constant<int, 2>());
        case 3:
            return f(std::integral_constant<int, 3>());
        case 4:
            return f(std::integral_constant<int, 4>());
        default:
            return f(std::integral_constant<int, 0>());
    }
}

/// Factors matrices of one size and band, a column of each in turn: while one waits for its pivot, the others go on. False
/// if one is singular or not finite. Each of `ranges` is one of objects with a member eliminate<lower>(column).
template <class... Ranges>
bool eliminate_in_turn(int n, int lower, Ranges&&... ranges) {
    return with_count(lower, [&](auto count) {
        constexpr int constant = count;
        const auto column = [](auto& range, int k) {
            for (auto& matrix : range)
                if (!matrix.template eliminate<constant>(k)) return false;
            return true;
        };
        for (int k = 0; k < n; ++k)
            if (!(column(ranges, k) && ...)) return false;
        return true;
    });
}

/// Calls row(first), row(first + step), ... of each of `substitutions` in turn, `count` times: while one waits for a result
/// of its own, the others go on.
template <class... Substitution>
[[gnu::flatten]] inline bool substitute_in_turn(int first, int step, int count,
                                                Substitution... substitutions) {
    for (int k = first; count > 0; k += step, --count) (substitutions.row(k), ...);
    return true;
}

/// Solves with factors of one size and band, a row of each in turn; one after the other where rows were exchanged or there
/// are many diagonals. Each of `systems` has the factors `lu` and the right-hand side `x`.
template <class First, class... More>
void solve_in_turn(const First& first, const More&... more) {
    const int n = first.lu.size(), width = std::max({first.lu.width(), more.lu.width()...});
    with_count(first.lu.lower(), [&](auto lower) {
        if constexpr (lower > 0)
            if (!(first.lu.exchanged() || ... || more.lu.exchanged()))
                return substitute_in_turn(0, 1, n, first.template down<lower, false>(),
                                          more.template down<lower, false>()...);
        return (substitute_in_turn(0, 1, n, first.template down<lower, true>()) && ... &&
                substitute_in_turn(0, 1, n, more.template down<lower, true>()));
    });
    with_count(width, [&](auto constant) {
        if constexpr (constant > 0)
            return substitute_in_turn(n - 1, -1, n, first.template up<constant>(width),
                                      more.template up<constant>(width)...);
        else
            return (substitute_in_turn(n - 1, -1, n, first.template up<0>(width)) && ... &&
                    substitute_in_turn(n - 1, -1, n, more.template up<0>(width)));
    });
}

}  // namespace detail

/// LU with row pivoting of a banded matrix over T (a scalar or a complex_number). Row exchanges widen the
/// upper band by up to `lower` diagonals, which cost nothing where there are none; O(n lower (lower + upper))
/// operations, O(n (2 lower + upper)) storage, taken once.
template <class T>
class banded_lu {
  public:
    /// An n x n matrix with this band; entries are set through operator() before factor().
    void resize(int n, bandwidth band) {
        if (n == n_ && band.lower == lower_ && band.upper == upper_) return;
        n_ = n;
        lower_ = band.lower;
        upper_ = band.upper;
        height_ = 2 * lower_ + upper_ + 1;
        a_.assign(static_cast<std::size_t>(height_) * n, T{});
        pivot_.assign(n, 0);
    }
    T& operator()(int i, int j) { return column(j)[i]; }
    /// The matrix := -J, of the band and size given to resize().
    template <class Scalar>
    void assign_negative(const banded_matrix<Scalar>& J) {
        std::fill(a_.begin(), a_.end(), T{});
        for (int j = 0; j < n_; ++j) {
            const Scalar* from = &J(j, j);
            T* to = column(j) + j;
            for (int i = -std::min(upper_, j), last = std::min(lower_, n_ - 1 - j); i <= last; ++i)
                to[i] = T(Scalar(-from[i]));
        }
    }

    /// False if the matrix is singular or not finite.
    bool factor() { return detail::eliminate_in_turn(n_, lower_, std::span(this, 1)); }

    /// Column k of the factors, after those before it; false if there is no pivot. Lower: the lower diagonals, 0 where
    /// their number is not a constant.
    // Rows below the last are stored as zeros, so that no column has to stop short of them.
    template <int Lower>
    [[gnu::flatten]] bool eliminate(int k) {
        if (k == 0) last_column_ = width_ = 0, exchanged_ = false;
        const auto each = [this](auto&& f) { unrolled<(Lower > 0 ? Lower : -1)>(lower_, f); };
        T* ck = column(k) + k;
        int p = 0;
        auto largest = size_of(ck[0]);
        // A loop: where rows are hardly exchanged, nothing waits for p then.
        for (int i = 1; i <= (Lower > 0 ? Lower : lower_); ++i) {
            const auto candidate = size_of(ck[i]);
            if (candidate > largest) largest = candidate, p = i;
        }
        if (!usable_pivot(largest)) return false;
        pivot_[k] = k + p;
        exchanged_ = exchanged_ || p != 0;
        std::swap(ck[0], ck[p]);
        ck[0] = inverse_of(ck[0]);
        std::array<T, Lower> multipliers;
        each([&](auto i) {
            ck[i + 1] = ck[i + 1] * ck[0];
            if constexpr (Lower > 0) multipliers[i] = ck[i + 1];
        });
        last_column_ = std::max(last_column_, std::min(k + p + upper_, n_ - 1));
        width_ = std::max(width_, last_column_ - k);
        for (int j = 1; j <= last_column_ - k; ++j) {
            T* cj = column(k + j) + k;
            const T m = cj[p];
            cj[p] = cj[0];
            cj[0] = m;
            each([&](auto i) { cj[i + 1] = cj[i + 1] - (Lower > 0 ? multipliers[i] : ck[i + 1]) * m; });
        }
        return true;
    }

    int size() const { return n_; }
    int lower() const { return lower_; }
    /// The diagonals above the main one that the upper factor has, and whether rows were exchanged.
    int width() const { return width_; }
    bool exchanged() const { return exchanged_; }

    /// Substitution with the lower factor, a row at a time from the first one on. Lower: its diagonals, 0 where their number
    /// is not a constant; where it is, the entries of x that a column changes are kept in `next`, which moves along with
    /// it. Those beyond the ends of x are zeros; what becomes of them is not used.
    template <int Lower, bool Exchanged, class X>
    struct downwards {
        const banded_lu& lu;
        X x;
        std::array<T, Lower + 1> next;

        downwards(const banded_lu& factors, const X& to) : lu(factors), x(to), next{} {
            for (int i = 0; i <= Lower && i < lu.n_; ++i) next[i] = x[i];
        }
        void row(int k) {
            const T* ck = lu.column(k) + k;
            const int p = lu.pivot_[k] - k;
            if constexpr (Lower > 0) {
                if constexpr (Exchanged)
                    unrolled<Lower>(Lower, [&](auto i) {
                        if (p == i + 1) std::swap(next[0], next[i + 1]);
                    });
                const T m = next[0];
                x.set(k, m);
                unrolled<Lower>(Lower, [&](auto i) { next[i] = next[i + 1] - ck[i + 1] * m; });
                next[Lower] = k + 1 + Lower < lu.n_ ? T(x[k + 1 + Lower]) : T{};
            } else {
                const T m = x[k + p];
                if (p != 0) x.set(k + p, x[k]);
                x.set(k, m);
                for (int i = 1; i <= std::min(lu.lower_, lu.n_ - 1 - k); ++i)
                    x.set(k + i, x[k + i] - ck[i] * m);
            }
        }
    };
    /// The same with the upper factor, from the last row on.
    template <int Width, class X>
    struct upwards {
        const banded_lu& lu;
        X x;
        int width;
        std::array<T, Width + 1> next;

        upwards(const banded_lu& factors, const X& to, int diagonals)
            : lu(factors), x(to), width(diagonals), next{} {
            for (int i = 0; i <= Width && i < lu.n_; ++i) next[i] = x[lu.n_ - 1 - i];
        }
        void row(int k) {
            const T* ck = lu.column(k) + k;
            const T m = (Width > 0 ? next[0] : T(x[k])) * ck[0];
            x.set(k, m);
            if constexpr (Width > 0) {
                unrolled<Width>(Width, [&](auto i) { next[i] = next[i + 1] - ck[-1 - i] * m; });
                next[Width] = k - 1 - Width >= 0 ? T(x[k - 1 - Width]) : T{};
            } else {
                for (int i = std::max(0, k - width); i < k; ++i) x.set(i, x[i] - ck[i - k] * m);
            }
        }
    };
    /// Factors and a right-hand side, indexed from 0 to n - 1, in which solve_in_turn() leaves the solution.
    template <class X>
    struct right_hand_side {
        const banded_lu& lu;
        X x;
        template <int Lower, bool Exchanged>
        auto down() const {
            return downwards<Lower, Exchanged, X>(lu, x);
        }
        template <int Width>
        auto up(int width) const {
            return upwards<Width, X>(lu, x, width);
        }
    };

  private:
    /// Column j such that column(j)[i] is entry (i, j).
    T* column(int j) { return a_.data() + (static_cast<std::ptrdiff_t>(height_) * j + lower_ + upper_ - j); }
    const T* column(int j) const {
        return a_.data() + (static_cast<std::ptrdiff_t>(height_) * j + lower_ + upper_ - j);
    }
    int n_ = -1, lower_ = 0, upper_ = 0, height_ = 1, width_ = 0;  // width_: of the upper factor
    int last_column_ = 0;     // the furthest that a row met so far reaches
    bool exchanged_ = false;  // some rows were
    std::vector<T> a_;
    std::vector<int> pivot_;
};

/// The linear solvers for shift M - J with J a banded_matrix. The band of M must lie within that of J.
template <class Scalar>
struct banded_blocks {
    class real {
      public:
        explicit real(int) {}
        /// Factors shift M - J; false if it is singular or not finite.
        template <class Mass>
        bool factor_shifted(const Mass& mass, const banded_matrix<Scalar>& J, const Scalar& shift) {
            assemble(lu_, mass, J, shift);
            return lu_.factor();
        }
        void solve(Scalar* x) const { detail::solve_in_turn(with(x)); }
        /// As of banded_lu.
        template <int Lower>
        bool eliminate(int k) {
            return lu_.template eliminate<Lower>(k);
        }

      private:
        struct access {
            Scalar* x;
            const Scalar& operator[](int i) const { return x[i]; }
            void set(int i, const Scalar& v) const { x[i] = v; }
        };
        friend banded_blocks;
        auto with(Scalar* x) const {
            return typename banded_lu<Scalar>::template right_hand_side<access>{lu_, {x}};
        }
        banded_lu<Scalar> lu_;
    };

    class complex {
      public:
        explicit complex(int) {}
        /// Factors (re + i im) M - J; false if it is singular or not finite.
        template <class Mass>
        bool factor_shifted(const Mass& mass, const banded_matrix<Scalar>& J, const Scalar& re,
                            const Scalar& im) {
            assemble(lu_, mass, J, complex_number<Scalar>{re, im});
            return lu_.factor();
        }
        void solve(Scalar* x, Scalar* y) const { detail::solve_in_turn(with(x, y)); }
        /// As of banded_lu.
        template <int Lower>
        bool eliminate(int k) {
            return lu_.template eliminate<Lower>(k);
        }

      private:
        struct access {
            Scalar *x, *y;
            complex_number<Scalar> operator[](int i) const { return {x[i], y[i]}; }
            void set(int i, const complex_number<Scalar>& v) const { x[i] = v.re, y[i] = v.im; }
        };
        friend banded_blocks;
        auto with(Scalar* x, Scalar* y) const {
            return typename banded_lu<complex_number<Scalar>>::template right_hand_side<access>{lu_, {x, y}};
        }
        banded_lu<complex_number<Scalar>> lu_;
    };

    /// Factors all matrices of a step at once: shift M - J for the real ones, then for the complex ones, whose shifts are
    /// pairs of numbers. False if one is singular or not finite.
    template <class Mass>
    static bool factor_all(std::vector<real>& reals, std::vector<complex>& pairs, const Mass& mass,
                           const banded_matrix<Scalar>& J, const Scalar* shift) {
        for (real& block : reals) assemble(block.lu_, mass, J, *shift++);
        for (complex& block : pairs) {
            assemble(block.lu_, mass, J, complex_number<Scalar>{shift[0], shift[1]});
            shift += 2;
        }
        return detail::eliminate_in_turn(J.size(), J.lower(), reals, pairs);
    }

    /// Solves with all matrices of a step; the right-hand sides follow each other as the shifts do, n numbers each. At most
    /// three matrices at a time: what more of them hold on to would not stay in registers.
    static void solve_all(const std::vector<real>& reals, const std::vector<complex>& pairs, Scalar* x,
                          int n) {
        const auto column = [&](std::ptrdiff_t k) { return x + k * n; };
        const auto pair = [&, first = static_cast<std::ptrdiff_t>(reals.size())](std::size_t k) {
            const std::ptrdiff_t at = first + 2 * static_cast<std::ptrdiff_t>(k);
            return pairs[k].with(column(at), column(at + 1));
        };
        std::size_t k = pairs.size() % 2;
        if (reals.size() == 1 && k == 1) {
            detail::solve_in_turn(reals[0].with(x), pair(0));
        } else if (reals.size() == 1 && !pairs.empty()) {
            detail::solve_in_turn(reals[0].with(x), pair(0), pair(1));
            k = 2;
        } else {
            for (std::size_t r = 0; r < reals.size(); ++r)
                reals[r].solve(column(static_cast<std::ptrdiff_t>(r)));
            if (k == 1) detail::solve_in_turn(pair(0));
        }
        for (; k < pairs.size(); k += 2) detail::solve_in_turn(pair(k), pair(k + 1));
    }

  private:
    /// lu := shift M - J.
    template <class T, class Mass>
    static void assemble(banded_lu<T>& lu, const Mass& mass, const banded_matrix<Scalar>& J, const T& shift) {
        lu.resize(J.size(), {J.lower(), J.upper()});
        lu.assign_negative(J);
        add_mass_to(lu, mass, shift, J.size());
    }
    template <class T>
    static void add_mass_to(banded_lu<T>& lu, const identity_mass&, const T& shift, int n) {
        for (int i = 0; i < n; ++i) lu(i, i) = lu(i, i) + shift;
    }
    template <class T>
    static void add_mass_to(banded_lu<T>& lu, const entry_mass<Scalar>& mass, const T& shift, int) {
        for (const auto& e : mass.entries()) lu(e.row, e.column) = lu(e.row, e.column) + T(e.value) * shift;
    }
};

template <class Number>
struct work_of<banded_matrix<Number>> {
    template <class Scalar>
    static block_work<Scalar> estimate(const banded_matrix<Number>& J) {
        const Scalar n = Scalar(J.size()), lower = Scalar(J.lower()), band = lower + Scalar(J.upper());
        return {n * (20 + 5 * lower * band), n * (25 + 5 * band)};
    }
};

template <class Scalar>
struct default_blocks<banded_matrix<Scalar>> {
    using type = banded_blocks<Scalar>;
};

}  // namespace stagecraft
