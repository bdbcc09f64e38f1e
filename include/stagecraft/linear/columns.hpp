// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <utility>

#include <stagecraft/linear/complex_number.hpp>
#include <stagecraft/linear/packet.hpp>

namespace stagecraft {

/// A column of a matrix of floating-point numbers, or a vector.
template <class Scalar>
struct real_column {
    using scalar = Scalar;
    using number = Scalar;
    static constexpr int together = 8;  ///< so many columns are eliminated from another one at once

    Scalar* x;

    number operator[](std::ptrdiff_t i) const { return x[i]; }
    bool holds(std::ptrdiff_t i) const { return !is_zero(x[i]); }
    void set(int i, const number& v) const { x[i] = v; }
    void swap(int i, int k) const { std::swap(x[i], x[k]); }
    friend real_column operator+(const real_column& c, std::ptrdiff_t i) { return {c.x + i}; }

    /// How many of the first n entries are zero.
    [[gnu::flatten]] int zeros(int n) const {
        int i = 0;
        const auto run = [&]<class P>(P) {
            auto sum = P::all(Scalar(0));
            for (; i + P::size <= n; i += P::size) sum = sum + P::one_if_zero(P::load(x + i));
            return static_cast<int>(P::sum(sum));
        };
        const int most = run(packet<Scalar>());
        return most + run(single<Scalar>());
    }

    /// Multiplies entries first ... last - 1 by `factor`.
    [[gnu::flatten]] void scale(int first, int last, const number& factor) const {
        int i = first;
        const auto run = [&]<class P>(P) {
            const auto m = P::all(factor);
            for (; i + P::size <= last; i += P::size) P::store(x + i, P::load(x + i) * m);
        };
        run(packet<Scalar>());
        run(single<Scalar>());
    }

    /// Subtracts m[0] a[0] + m[1] a[1] + ..., as many terms as there are k, from entries first ... last - 1.
    template <int... k>
    void subtract(int first, int last, const real_column* a, const number* m,
                  std::integer_sequence<int, k...>) const {
        int i = first;
        const auto run = [&]<class P>(P) {
            const Scalar* const from[] = {a[k].x...};
            const typename P::type by[] = {P::all(m[k])...};
            for (; i + P::size <= last; i += P::size)
                P::store(x + i, P::load(x + i) - ((P::load(from[k] + i) * by[k]) + ...));
        };
        run(packet<Scalar>());
        run(single<Scalar>());
    }
};

/// A column of complex numbers, real and imaginary parts apart.
template <class Scalar>
struct complex_column {
    using scalar = Scalar;
    using number = complex_number<Scalar>;
    static constexpr int together = 4;

    Scalar *re, *im;

    number operator[](std::ptrdiff_t i) const { return {re[i], im[i]}; }
    bool holds(std::ptrdiff_t i) const { return !is_zero((*this)[i]); }
    void set(int i, const number& v) const { re[i] = v.re, im[i] = v.im; }
    void swap(int i, int k) const { std::swap(re[i], re[k]), std::swap(im[i], im[k]); }
    friend complex_column operator+(const complex_column& c, std::ptrdiff_t i) {
        return {c.re + i, c.im + i};
    }

    [[gnu::flatten]] int zeros(int n) const {
        int i = 0;
        const auto run = [&]<class P>(P) {
            auto sum = P::all(Scalar(0));
            for (; i + P::size <= n; i += P::size)
                sum = sum + P::one_if_zero(P::load(re + i)) * P::one_if_zero(P::load(im + i));
            return static_cast<int>(P::sum(sum));
        };
        const int most = run(packet<Scalar>());
        return most + run(single<Scalar>());
    }

    [[gnu::flatten]] void scale(int first, int last, const number& factor) const {
        int i = first;
        const auto run = [&]<class P>(P) {
            const auto a = P::all(factor.re), b = P::all(factor.im);
            for (; i + P::size <= last; i += P::size) {
                const auto x = P::load(re + i), y = P::load(im + i);
                P::store(re + i, x * a - y * b);
                P::store(im + i, x * b + y * a);
            }
        };
        run(packet<Scalar>());
        run(single<Scalar>());
    }

    template <int... k>
    void subtract(int first, int last, const complex_column* a, const number* m,
                  std::integer_sequence<int, k...>) const {
        int i = first;
        const auto run = [&]<class P>(P) {
            const Scalar *const x[] = {a[k].re...}, *const y[] = {a[k].im...};
            const typename P::type r[] = {P::all(m[k].re)...}, s[] = {P::all(m[k].im)...};
            for (; i + P::size <= last; i += P::size) {
                const auto u = ((P::load(x[k] + i) * r[k] - P::load(y[k] + i) * s[k]) + ...);
                const auto v = ((P::load(x[k] + i) * s[k] + P::load(y[k] + i) * r[k]) + ...);
                P::store(re + i, P::load(re + i) - u);
                P::store(im + i, P::load(im + i) - v);
            }
        };
        run(packet<Scalar>());
        run(single<Scalar>());
    }
};

}  // namespace stagecraft
