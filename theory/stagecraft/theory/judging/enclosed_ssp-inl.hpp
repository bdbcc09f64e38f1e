// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/enclosed_ssp.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/judging/enclosed_stability.hpp"
#include "stagecraft/theory/stability/enclosed_signs.hpp"

namespace stagecraft::theory {

namespace detail {

/// [A 0; b^T 0] of the stages that y_1 depends on: unless an entry vanishes exactly it counts as used.
STAGECRAFT_INLINE ball_matrix matrix_of_used_stages(const tableau<ball>& t) {
    std::vector<int> used;
    std::vector<bool> known(static_cast<std::size_t>(t.stages()));
    const auto use = [&](int j) {
        if (!known[static_cast<std::size_t>(j)]) used.push_back(j);
        known[static_cast<std::size_t>(j)] = true;
    };
    for (int j = 0; j < t.stages(); ++j)
        if (!t.b(j).exactly_zero()) use(j);
    for (std::size_t next = 0; next < used.size(); ++next)
        for (int j = 0; j < t.stages(); ++j)
            if (!t.A(used[next], j).exactly_zero()) use(j);
    std::sort(used.begin(), used.end());
    const auto n = static_cast<int>(used.size());
    ball_matrix k(n + 1, n + 1);
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
            k(i, j) = j == n   ? ball(0)
                      : i == n ? t.b(used[static_cast<std::size_t>(j)])
                               : t.A(used[static_cast<std::size_t>(i)], used[static_cast<std::size_t>(j)]);
    return k;
}

/// Whether no two stages of any tableau among the enclosures are the same: classes of stages that may be, refined by the
/// sums of their rows over each class, end as single ones.
STAGECRAFT_INLINE bool stages_certainly_differ(const ball_matrix& k) {
    const auto n = static_cast<std::size_t>(k.rows() - 1);
    std::vector<std::size_t> class_of(n, 0);
    for (;;) {
        std::vector<std::size_t> next(n);
        std::size_t count = 0;
        const auto same = [&](std::size_t i, std::size_t j) {
            if (class_of[i] != class_of[j]) return false;
            for (std::size_t m = 0; m < n; ++m) {
                ball left(0);
                for (std::size_t l = 0; l < n; ++l)
                    if (class_of[l] == m)
                        left += k(static_cast<int>(i), static_cast<int>(l)) -
                                k(static_cast<int>(j), static_cast<int>(l));
                if (certainly_nonzero(left)) return false;
            }
            return true;
        };
        for (std::size_t i = 0; i < n;
             ++i) {  // "may be the same" is no equivalence: what is linked by it is a class
            next[i] = i;
            for (std::size_t j = 0; j < i; ++j)
                if (next[i] != next[j] && same(i, j))
                    std::replace(next.begin(), next.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                 std::max(next[i], next[j]), std::min(next[i], next[j]));
        }
        for (std::size_t i = 0; i < n; ++i) count += next[i] == i ? 1 : 0;
        if (count == n) return true;
        if (next == class_of) return false;
        class_of = std::move(next);
    }
}

/// The polynomials that must not be negative up to the radius, the determinant first: with x = -1/r, adj(I + rK) =
/// sum_l (-1)^l N_l r^l from adj(xI - K) = sum_l N_l x^(n-1-l).
STAGECRAFT_INLINE std::vector<std::vector<ball>> monotonicity_conditions(const ball_matrix& k) {
    const auto n = static_cast<int>(k.rows());
    std::vector<ball_matrix> adjugate;
    std::vector<std::vector<ball>> all(1, {ball(1)});
    ball_matrix next(n, n), product(n, n);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) next(i, j) = ball(i == j ? 1 : 0);
    for (int l = 1; l <= n; ++l) {
        adjugate.push_back(next);
        ball trace(0);
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) {
                product(i, j) = ball(0);
                for (int m = 0; m < n; ++m) product(i, j) += k(i, m) * next(m, j);
            }
            trace += product(i, i);
        }
        const ball c = -trace.over(l);
        all.front().push_back(l % 2 == 0 ? c : -c);
        next = product;
        for (int i = 0; i < n; ++i) next(i, i) += c;
    }
    const auto add = [&](auto coefficient) {
        all.emplace_back();
        for (std::size_t l = 0; l < adjugate.size(); ++l)
            all.back().push_back(l % 2 == 0 ? coefficient(adjugate[l]) : -coefficient(adjugate[l]));
    };
    for (int i = 0; i < n; ++i) {
        add([&](const ball_matrix& a) { return ball(a.row(i).sum()); });
        for (int j = 0; j + 1 < n; ++j)
            add([&](const ball_matrix& a) {
                ball sum(0);
                for (int l = 0; l < n; ++l) sum += k(i, l) * a(l, j);
                return sum;
            });
    }
    return all;
}

}  // namespace detail

STAGECRAFT_INLINE claim enclosed_ssp_radius(const subject<tableaux::ball>& s) {
    constexpr auto infinity = std::numeric_limits<bound>::infinity();
    const std::string name = "SSP radius";
    const auto k = detail::matrix_of_used_stages(s.t);
    if (!detail::stages_certainly_differ(k))
        return {name, verdict::undecided("two stages may be the same, of which only one would count")};
    number_range radius{infinity, infinity};
    bool open_at_zero = false;
    for (const auto& p : detail::monotonicity_conditions(k)) {
        if (std::all_of(p.begin(), p.end(), [](const ball& x) { return x.exactly_zero(); })) continue;
        const bound until = std::isinf(radius.high) ? -1 : radius.high;
        const auto signs = signs_on_half_line(p, {.to_first_negative = true, .until = until});
        const bool positive = signs.front().sign > 0;
        radius.low = std::min(radius.low, positive ? tableaux::downward(signs.front().to) : 0);
        open_at_zero = open_at_zero || signs.front().sign == 0;
        if (const auto* loss = first_with_sign(signs, -1))
            radius.high = std::min(radius.high, loss->from == 0 ? 0 : tableaux::upward(loss->from));
    }
    if (radius.high == 0) return {name + " 0", verdict::proved(detail::every_table), number_range{0, 0}};
    if (std::isinf(radius.low))
        return {name + " infinite", verdict::proved(detail::every_table), detail::no_end};
    if (open_at_zero || std::isinf(radius.high))
        return {name, verdict::undecided((std::isinf(radius.high) ? "at least " + brief(radius.low)
                                                                  : "0, or up to " + brief(radius.high)) +
                                         ": a condition vanishes up to rounding")};
    return {name + " " + detail::in_digits(radius),
            verdict::proved(detail::between(radius) + " " + detail::every_table), radius};
}

}  // namespace stagecraft::theory
