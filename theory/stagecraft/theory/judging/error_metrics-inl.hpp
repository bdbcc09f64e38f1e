// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/error_metrics.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/models/matrix_model.hpp"
#include "stagecraft/theory/trees/tree_weights.hpp"

namespace stagecraft::theory {

namespace detail {

using metric_ball = tableaux::ball;

/// Four digits, where all of the ball has them.
STAGECRAFT_INLINE std::string four_digits(const std::optional<metric_ball>& x) {
    if (!x || x->radius() > 1e-5L * x->magnitude()) return "not decided";
    char text[32];
    std::snprintf(text, sizeof text, "%.4Lg", x->middle().to<tableaux::bound>());
    return text;
}

/// The square root, or nothing where the ball reaches 0.
STAGECRAFT_INLINE std::optional<metric_ball> root_of(const metric_ball& square) {
    if (square.exactly_zero()) return square;
    if (!certainly_positive(square)) return std::nullopt;
    return sqrt(square);
}

/// The error terms of orders 1, ..., most.
template <class Weights>
std::vector<std::vector<metric_ball>> error_terms_to(const subject<metric_ball>& s, const Weights& weights,
                                                     int most) {
    const tree_table trees(most);
    const matrix_model<metric_ball> model(s.t, weights);
    tree_weights<matrix_model<metric_ball>> walk(model, trees.view(), most);
    std::vector<std::vector<metric_ball>> all(1);
    while (walk.advance()) {
        all.emplace_back();
        for (std::size_t i = 0; i < walk.weights().size(); ++i) {
            const auto& row = trees.view().rows[walk.first_row() + static_cast<std::uint32_t>(i)];
            all.back().push_back(walk.residual(i) / metric_ball(row.symmetry));
        }
    }
    return all;
}

STAGECRAFT_INLINE std::optional<metric_ball> norm_of(const std::vector<metric_ball>& terms) {
    metric_ball sum(0);
    for (const auto& x : terms) sum += x * x;
    return root_of(sum);
}

STAGECRAFT_INLINE std::optional<metric_ball> quotient(const std::optional<metric_ball>& x,
                                                      const std::optional<metric_ball>& y) {
    if (!x || !y || !certainly_nonzero(*y)) return std::nullopt;
    return *x / *y;
}

STAGECRAFT_INLINE metric_ball largest_coefficient(const tableau<metric_ball>& t) {
    metric_ball most(0);
    const auto take = [&](const metric_ball& x) {
        if (abs(x).middle() > most.middle()) most = abs(x);
    };
    for (int i = 0; i < t.stages(); ++i) {
        for (int j = 0; j < t.stages(); ++j) take(t.A(i, j));
        for (const auto* v : {&t.b, &t.c, &t.b_embedded}) take((*v)(i));
    }
    return most;
}

}  // namespace detail

STAGECRAFT_INLINE std::optional<error_metrics> error_metrics_of(const subject<tableaux::ball>& s, int order,
                                                                int embedded_order) {
    const int p = std::min(order, embedded_order), q = std::max(order, embedded_order);
    if (p == q || p < 1 || p + 2 > 10 || s.t.b_embedded.size() == 0) return std::nullopt;
    const int most = std::max(p + 2, std::min(q + 1, 10));
    auto high = detail::error_terms_to(s, s.t.b, most), low = detail::error_terms_to(s, s.t.b_embedded, most);
    if (embedded_order > order) std::swap(high, low);
    const auto first = static_cast<std::size_t>(p) + 1, second = first + 1;
    std::vector<tableaux::ball> difference;
    for (std::size_t i = 0; i < low[second].size(); ++i)
        difference.push_back(low[second][i] - high[second][i]);
    const auto scale = detail::norm_of(low[first]);
    const auto digits = [](const auto& x) { return detail::four_digits(x); };
    error_metrics m;
    m.order = q;
    m.lower_order = p;
    m.A = q + 1 > 10 ? "not looked at" : digits(detail::norm_of(high[static_cast<std::size_t>(q) + 1]));
    m.A_embedded = digits(scale);
    m.B = digits(detail::quotient(detail::norm_of(low[second]), scale));
    m.C = digits(detail::quotient(detail::norm_of(difference), scale));
    m.D = digits(std::optional(detail::largest_coefficient(s.t)));
    m.E = digits(detail::quotient(detail::norm_of(high[second]), scale));
    return m;
}

STAGECRAFT_INLINE std::string text(const error_metrics& m) {
    const auto power = [](int n) { return "^(" + std::to_string(n) + ") = "; };
    const auto last = power(m.lower_order + 2);
    return "error metrics: A" + power(m.order + 1) + m.A + ", A" + power(m.lower_order + 1) + m.A_embedded +
           ", B" + last + m.B + ", C" + last + m.C + ", D = " + m.D + ", E" + last + m.E;
}

STAGECRAFT_INLINE nlohmann::ordered_json to_json(const error_metrics& m) {
    return {{"order", m.order}, {"lower_order", m.lower_order},
            {"A", m.A},         {"A_embedded", m.A_embedded},
            {"B", m.B},         {"C", m.C},
            {"D", m.D},         {"E", m.E}};
}

}  // namespace stagecraft::theory
