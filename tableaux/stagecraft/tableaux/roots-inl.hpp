// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/roots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/range.hpp"
#include "stagecraft/tableaux/rough_ball.hpp"
#include "stagecraft/tableaux/sturm.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE legendre_table legendre_values(const ball& x, int n, bool slopes) {
    const ball doubled = x.midpoint().times(2) - ball(1);
    const ball t = doubled.midpoint();
    if (compare(abs(t), ball(1)) > 0) throw undecided("legendre_values: a point outside of [0, 1]");
    legendre_table p;
    p.value.reserve(static_cast<std::size_t>(n) + 1);
    p.value.push_back(ball(1));
    if (n > 0) p.value.push_back(t);
    ball before = 1, here = t;
    bound rounding = 0;
    for (int k = 1; k < n; ++k) {
        const ball next = ((t * here).times(2 * k + 1) - before.times(k)).over(k + 1);
        rounding = std::max(rounding, next.radius());
        before = std::exchange(here, next.midpoint());
        const bound j = k + 1;
        p.value.push_back(rounding == 0 ? here : here.widened(upward(rounding * (j + 1) * (j + 2) / 4)));
    }
    if (slopes) {
        p.slope.push_back(ball(0));
        if (n > 0) p.slope.push_back(ball(2));
        for (int k = 1; k < n; ++k) {
            const auto at = static_cast<std::size_t>(k);
            p.slope.push_back(p.slope[at - 1] + p.value[at].times(4 * k + 2));
        }
    }
    if (x.exact() && doubled.exact()) return p;
    const bound off = upward(x.radius() + doubled.radius() / 2);
    for (int k = 1; k <= n; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const bound j = k;
        p.value[at] = p.value[at].widened(upward(off * j * (j + 1)));
        if (slopes) p.slope[at] = p.slope[at].widened(upward(off * (j - 1) * j * (j + 1) * (j + 2) / 2));
    }
    return p;
}

STAGECRAFT_INLINE std::vector<ball> enclosed(const std::vector<rational>& v, int bits) {
    std::vector<ball> u;
    u.reserve(v.size());
    for (const rational& q : v) u.emplace_back(q, bits);
    return u;
}

STAGECRAFT_INLINE ball legendre_sum(const std::vector<ball>& u, const std::vector<ball>& p) {
    ball sum = 0;
    for (std::size_t k = 0; k < u.size(); ++k)
        if (!u[k].exactly_zero()) sum += u[k] * p[k];
    return sum;
}

namespace zeros {

STAGECRAFT_INLINE std::vector<double> approximate(const std::vector<double>& w, std::size_t expected) {
    const auto at = [&](double x) {
        double before = 0, p = 1, sum = w[0];
        for (std::size_t k = 0; k + 1 < w.size(); ++k) {
            const double n = static_cast<double>(k);
            const double next = ((2 * n + 1) * (2 * x - 1) * p - n * before) / (n + 1);
            before = p;
            p = next;
            sum += w[k + 1] * p;
        }
        return sum;
    };
    const auto point = [](double theta) { return std::pow(std::sin(theta / 2), 2); };
    std::vector<double> found;
    // An odd number of cells, so that 1/2 is no grid point; the ends, where w may vanish, are left out.
    const std::size_t cells = 16 * w.size() + 1;
    double low = std::numbers::pi / static_cast<double>(8 * cells);
    for (std::size_t i = 1; i <= cells; ++i) {
        double high = std::numbers::pi * (static_cast<double>(i) / static_cast<double>(cells));
        if (i == cells) high -= std::numbers::pi / static_cast<double>(8 * cells);
        double a = low, b = high;
        low = high;
        if ((at(point(a)) < 0) == (at(point(b)) < 0)) continue;
        const bool below = at(point(a)) < 0;
        for (int halving = 0; halving < 46; ++halving) {
            const double middle = (a + b) / 2;
            ((at(point(middle)) < 0) == below ? a : b) = middle;
        }
        found.push_back(point((a + b) / 2));
    }
    if (found.size() != expected) throw undecided("nodes: the search in double missed a zero");
    return found;
}

/// The double x as a ball of radius 0.
STAGECRAFT_INLINE ball exact_ball(double x, int bits) {
    int e = 0;
    const double f = std::frexp(x, &e);
    return {ball::mantissa(static_cast<std::int64_t>(std::ldexp(f, 53))), e - 53, 0, bits};
}

/// The real zeros in (0, 1) as intervals so narrow that no two of them, 0 and 1 are nearer than 2^-apart, and their
/// width is 2^-80 of that at most.
struct separated {
    std::vector<isolated_root<rational>> roots;
    int apart = 0;
    explicit separated(polynomial<rational> w) {
        for (const int end : {0, 1})
            if (w(rational(end)) == 0) w = w / polynomial<rational>{-end, 1};
        roots = isolate_real_roots(w);
        for (int fine = 100;; fine *= 2) {
            for (auto& r : roots) r = refine(w, r, scaled(rational(1), -fine));
            apart = 1;
            for (std::size_t i = 0; i <= roots.size(); ++i) {
                const rational gap = (i < roots.size() ? roots[i].low : rational(1)) -
                                     (i > 0 ? roots[i - 1].high : rational(0));
                apart = std::max(apart, gap > 0 ? 1 - binary_exponent(gap) : fine);
            }
            if (apart + 80 <= fine) break;
        }
    }
};

STAGECRAFT_INLINE std::vector<start> starts(const polynomial<rational>& w, int bits) {
    const separated all(w);
    const auto slope = derivative(w);
    std::vector<start> found;
    for (const auto& r : all.roots) {
        const rational x = (r.low + r.high) / 2, steep = slope(x);
        const int flat = steep == 0 ? all.apart : std::max(0, 1 - binary_exponent(steep));
        found.push_back(
            {ball(x, std::max(bits, 4 * all.apart)).midpoint(), 128 + all.apart + flat, all.apart});
    }
    return found;
}

STAGECRAFT_INLINE ball certified(const std::vector<ball>& w, const start& from, int bits) {
    const int s = static_cast<int>(w.size()) - 1, first = std::min(from.bits, bits);
    int last = 2;  // steps with all bits: the digits double from 128 bits below the distance, not from 0
    for (int p = first; p > 128; p /= 2) ++last;
    ball x = from.x;
    for (int p = first;; p = std::min(2 * p, bits)) {  // Newton, the precision doubling with the digits
        for (int repeat = 0; repeat < (p == bits ? last : p == first ? 2 : 1); ++repeat) {
            const auto table = legendre_values(x.with_bits(p + 64).midpoint(), s, true);
            const ball slope = legendre_sum(w, table.slope).midpoint();
            if (!certainly_nonzero(slope)) throw undecided("nodes: Newton's method met a zero slope");
            x = (x - legendre_sum(w, table.value).midpoint() / slope).with_bits(p + 64).midpoint();
        }
        if (p == bits) break;
    }
    x = x.with_bits(bits).midpoint();
    const auto table = legendre_values(x, s, true);
    const ball value = legendre_sum(w, table.value);
    if (value.exactly_zero()) return x;  // a dyadic zero, met exactly
    const bound slope = legendre_sum(w, table.slope).lower_magnitude();
    if (!(slope > 0)) throw undecided("nodes: the slope at a zero is undecided");
    bound r = upward(2 * value.upper_magnitude() / slope);
    for (int attempt = 0; attempt < 4; ++attempt, r *= 256) {
        const auto [m, e] = ball::bound_parts(r);
        const ball half(m, e, 0, bits);
        const ball below = legendre_sum(w, legendre_values((x - half).midpoint(), s).value);
        const ball above = legendre_sum(w, legendre_values((x + half).midpoint(), s).value);
        const bool crosses = (certainly_negative(below) && certainly_positive(above)) ||
                             (certainly_positive(below) && certainly_negative(above));
        // the end points were rounded to `bits` bits: one more unit there covers that
        if (crosses) return x.widened(upward(r + (x - half).radius() + (x + half).radius()));
    }
    throw undecided("nodes: no certain change of sign around a zero");
}

}  // namespace zeros

STAGECRAFT_INLINE std::vector<ball> enclose_nodes(const nodal_polynomial& w, int bits) {
    const int s = w.degree();
    const auto vanishes = [&](const rational& x) { return w.monomial()(x) == 0; };
    const bool left = vanishes(0), right = vanishes(1), middle = vanishes(rational(1, 2));
    std::vector<zeros::start> found;
    if (w.family()) {
        std::vector<double> approximate_w;
        for (const rational& q : w.legendre()) approximate_w.push_back(q.to<double>());
        const auto interior = static_cast<std::size_t>(s - (left ? 1 : 0) - (right ? 1 : 0));
        for (const double x : zeros::approximate(approximate_w, interior))
            found.push_back({zeros::exact_ball(x, bits)});
    } else {
        found = zeros::starts(w.monomial(), bits);
        for (const auto& start : found) bits = std::max(bits, start.bits);
    }
    const std::vector<ball> coordinates = enclosed(w.legendre(), bits);
    std::vector<ball> nodes;
    if (left) nodes.push_back(ball(0).with_bits(bits));
    for (const auto& start : found) {
        const ball half = ball(1).scaled(-1).with_bits(bits);
        const bool met = middle && compare(abs(start.x - half), ball(1).scaled(-start.apart - 1)) < 0;
        nodes.push_back(met ? half : zeros::certified(coordinates, start, bits));
    }
    if (right) nodes.push_back(ball(1).with_bits(bits));
    if (static_cast<int>(nodes.size()) != s) throw undecided("nodes: a zero is missing");
    for (int i = 0; i < s; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (i > 0 && !certainly_less(nodes[at - 1], nodes[at]))
            throw undecided("nodes: the enclosures of two nodes overlap");
        if (!left && i == 0 && !certainly_positive(nodes[at])) throw undecided("nodes: c_1 > 0 is undecided");
        if (!right && i == s - 1 && !certainly_less(nodes[at], ball(1)))
            throw undecided("nodes: c_s < 1 is undecided");
    }
    return nodes;
}

}  // namespace stagecraft::tableaux
