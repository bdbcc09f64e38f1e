// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

#include <stagecraft/linear/packet.hpp>

namespace stagecraft {

/// out := c[0] in_0 + c[1] in_1 + ..., as many vectors of n numbers as there are j, one behind the other in
/// memory; added to what is in `out` if `Add`.
template <bool Add, class Scalar, int... j>
requires(built_in<Scalar>)
    [[gnu::flatten]] inline void combine(int n, const Scalar* c, const Scalar* in, Scalar* out,
                                         std::integer_sequence<int, j...>) {
    int i = 0;
    const auto run = [&]<class P>(P) {
        const typename P::type by[] = {P::all(c[j])...};
        for (; i + P::size <= n; i += P::size) {
            const auto sum = (... + (P::load(in + static_cast<std::ptrdiff_t>(j) * n + i) * by[j]));
            if constexpr (Add)
                P::store(out + i, P::load(out + i) + sum);
            else
                P::store(out + i, sum);
        }
    };
    run(packet<Scalar>());
    run(single<Scalar>());
}

/// The same for `count` vectors: Count, or any number where that is -1.
template <bool Add, int Count, class Scalar>
void combine(int n, int count, const Scalar* c, const Scalar* in, Scalar* out) {
    if constexpr (!built_in<Scalar>) {
        for (int i = 0; i < n; ++i) {
            Scalar sum = in[i] * c[0];
            for (int j = 1; j < count; ++j) sum += in[static_cast<std::ptrdiff_t>(j) * n + i] * c[j];
            out[i] = Add ? Scalar(out[i] + sum) : sum;
        }
    } else if constexpr (Count > 0) {
        combine<Add>(n, c, in, out, std::make_integer_sequence<int, Count>());
    } else {
        const auto from = [&](int j) { return in + static_cast<std::ptrdiff_t>(j) * n; };
        if constexpr (!Add) combine<false>(n, c, in, out, std::make_integer_sequence<int, 1>());
        int j = Add ? 0 : 1;
        for (; j + 4 <= count; j += 4)
            combine<true>(n, c + j, from(j), out, std::make_integer_sequence<int, 4>());
        for (; j < count; ++j) combine<true>(n, c + j, from(j), out, std::make_integer_sequence<int, 1>());
    }
}

/// A term of a linear combination: `factor` times the vector that begins `offset` numbers behind the first one.
template <class Scalar>
struct combination_term {
    Scalar factor;
    std::ptrdiff_t offset;
};

/// So many terms are summed in one pass: their factors and places fit the registers of usual processors.
inline constexpr std::size_t combined_terms = 12;

namespace detail {

/// So many terms.
template <bool Onto, class Scalar, int... j>
[[gnu::flatten]] inline void combine_these(int n, const combination_term<Scalar>* term, const Scalar& factor,
                                           const Scalar* in, const Scalar* base, Scalar* out,
                                           std::integer_sequence<int, j...>) {
    const Scalar* const x[] = {in + term[j].offset...};
    int i = 0;
    const auto run = [&]<class P>(P) {
        const typename P::type by[] = {P::all(term[j].factor)...}, all = P::all(factor);
        const auto one = [&] {
            const typename P::type sum = (... + (P::load(x[j] + i) * by[j])) * all;
            if constexpr (Onto)
                P::store(out + i, P::load(base + i) + sum);
            else
                P::store(out + i, sum);
            i += P::size;
        };
        while (i + 2 * P::size <= n) one(), one();
        if (i + P::size <= n) one();
    };
    run(packet<Scalar>());
    run(single<Scalar>());
}
template <bool Onto, class Scalar, int Count>
void combine_so_many(int n, const combination_term<Scalar>* term, const Scalar& factor, const Scalar* in,
                     const Scalar* base, Scalar* out) {
    combine_these<Onto>(n, term, factor, in, base, out, std::make_integer_sequence<int, Count>());
}

}  // namespace detail

/// out := `factor` times the sum of the terms, of vectors of n numbers from `in` on: at least one term, at most
/// `combined_terms`; on top of what is in `base` if `Onto`. `base` may be `out`.
template <bool Onto, class Scalar>
void combine_terms(int n, std::span<const combination_term<Scalar>> terms, const Scalar& factor,
                   const Scalar* in, const Scalar* base, Scalar* out) {
    if constexpr (!built_in<Scalar>) {
        for (int i = 0; i < n; ++i) {
            Scalar sum = in[terms[0].offset + i] * terms[0].factor;
            for (const auto& term : terms.subspan(1)) sum += in[term.offset + i] * term.factor;
            out[i] = Onto ? Scalar(base[i] + factor * sum) : Scalar(factor * sum);
        }
    } else {
        constexpr auto of_count = []<int... k>(std::integer_sequence<int, k...>) {
            return std::array{&detail::combine_so_many<Onto, Scalar, k + 1>...};
        }
        (std::make_integer_sequence<int, static_cast<int>(combined_terms)>());
        of_count[terms.size() - 1](n, terms.data(), factor, in, base, out);
    }
}
/// out := base + `factor` times the sum of any number of terms.
template <class Scalar>
void combine_onto(int n, std::span<const combination_term<Scalar>> terms, const Scalar& factor,
                  const Scalar* in, const Scalar* base, Scalar* out) {
    if (terms.empty()) std::copy_n(base, n, out);
    for (; !terms.empty(); base = out) {
        const std::size_t now = std::min(terms.size(), combined_terms);
        combine_terms<true>(n, terms.first(now), factor, in, base, out);
        terms = terms.subspan(now);
    }
}

/// out := c[0] from(0) + c[1] from(1) + ..., n being N or, where that is -1, any number; from(j) points at n
/// numbers, which may be those of `out`.
template <int N, class Scalar, class From, int... j>
requires(built_in<Scalar>)
    [[gnu::flatten]] inline void combine_from(int any, const Scalar* c, const From& from, Scalar* out,
                                              std::integer_sequence<int, j...>) {
    if constexpr (N >= 0 && N <= 4) {
        const auto one = [&](int i) { out[i] = (... + (from(j)[i] * c[j])); };
        [&]<int... i>(std::integer_sequence<int, i...>) { (one(i), ...); }
        (std::make_integer_sequence<int, N>());
    } else {
        const int n = N >= 0 ? N : any;
        int i = 0;
        const auto run = [&]<class P>(P) {
            const Scalar* const in[] = {from(j)...};
            const typename P::type by[] = {P::all(c[j])...};
            for (; i + P::size <= n; i += P::size) P::store(out + i, (... + (P::load(in[j] + i) * by[j])));
        };
        run(packet<Scalar>());
        run(single<Scalar>());
    }
}

/// Column k of z += sum_j C_kj column j of x, C row by row, and w += x; returns the sum of the squares of what
/// has been added to z, each times the square of its weight. All have Count columns of n numbers.
template <int N, int Count, class Scalar>
requires(built_in<Scalar>) [[gnu::flatten]] inline Scalar
    add_products(int any, const Scalar* C, const Scalar* x, const Scalar* weights, Scalar* w, Scalar* z) {
    const int n = N >= 0 ? N : any;
    int i = 0;
    const auto run = [&]<class P, int... j>(P, std::integer_sequence<int, j...>) {
        auto sum = P::all(Scalar(0));
        const auto one = [&] {
            const typename P::type in[] = {P::load(x + static_cast<std::ptrdiff_t>(j) * n + i)...};
            const auto at = [&](Scalar* to, const typename P::type& more) {
                P::store(to, P::load(to) + more);
                return more;
            };
            (at(w + static_cast<std::ptrdiff_t>(j) * n + i, in[j]), ...);
            const auto product = [&](const Scalar* row) { return (... + (in[j] * P::all(row[j]))); };
            const auto square = [](const auto& v) { return v * v; };
            const auto squares =
                (... + square(at(z + static_cast<std::ptrdiff_t>(j) * n + i, product(C + j * Count))));
            sum = sum + squares * square(P::load(weights + i));
        };
        if constexpr (N >= 0 && N <= 4) {
            [&]<int... k>(std::integer_sequence<int, k...>) { ((one(), i += P::size, void(k)), ...); }
            (std::make_integer_sequence<int, N>());
        } else {
            for (; i + P::size <= n; i += P::size) one();
        }
        return P::sum(sum);
    };
    constexpr std::make_integer_sequence<int, Count> columns;
    if constexpr (N >= 0 && N <= 4) {
        return run(single<Scalar>(), columns);
    } else {
        const Scalar most = run(packet<Scalar>(), columns);
        return most + run(single<Scalar>(), columns);
    }
}

/// The sum of (x_ij w_i)^2 over the columns j of x and i < n.
template <class Scalar, int... j>
requires(built_in<Scalar>) [[gnu::flatten]] inline Scalar
    weighted_squares(int n, const Scalar* x, const Scalar* w, std::integer_sequence<int, j...>) {
    int i = 0;
    const auto square = [](const auto& v) { return v * v; };
    const auto run = [&]<class P>(P) {
        auto sum = P::all(Scalar(0));
        for (; i + P::size <= n; i += P::size)
            sum = sum + (... + square(P::load(x + static_cast<std::ptrdiff_t>(j) * n + i))) *
                            square(P::load(w + i));
        return P::sum(sum);
    };
    const Scalar most = run(packet<Scalar>());
    return most + run(single<Scalar>());
}
template <int Count, class Scalar>
Scalar weighted_squares(int n, int count, const Scalar* x, const Scalar* w) {
    if constexpr (!built_in<Scalar>) {
        Scalar sum = Scalar(0);
        for (int j = 0; j < count; ++j)
            for (int i = 0; i < n; ++i) {
                const Scalar v = x[static_cast<std::ptrdiff_t>(j) * n + i] * w[i];
                sum += v * v;
            }
        return sum;
    } else if constexpr (Count > 0) {
        return weighted_squares(n, x, w, std::make_integer_sequence<int, Count>());
    } else {
        Scalar sum = Scalar(0);
        for (int j = 0; j < count; ++j)
            sum += weighted_squares(n, x + static_cast<std::ptrdiff_t>(j) * n, w,
                                    std::make_integer_sequence<int, 1>());
        return sum;
    }
}

}  // namespace stagecraft
