// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/exercises/methods.hpp"

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/small_solve.hpp"

namespace stagecraft::theory::exercise_methods {

STAGECRAFT_INLINE method with_nodes(const std::vector<rational>& c) {
    const auto s = static_cast<Eigen::Index>(c.size());
    method t;
    t.A = tableaux::dense<rational>::Constant(s, s, rational(0));
    t.b = tableaux::column<rational>::Constant(s, rational(0));
    t.c.resize(s);
    for (Eigen::Index i = 0; i < s; ++i) t.c[i] = c[static_cast<std::size_t>(i)];
    return t;
}

STAGECRAFT_INLINE void set_row(method& t, Eigen::Index i, const std::vector<rational>& from_second) {
    t.A(i, 0) = t.c[i];
    for (std::size_t k = 0; k < from_second.size(); ++k) {
        t.A(i, static_cast<Eigen::Index>(k) + 1) = from_second[k];
        t.A(i, 0) -= from_second[k];
    }
}

STAGECRAFT_INLINE void set_interpolatory_weights(method& t) {
    const auto s = t.b.size();
    tableaux::dense<rational> V(s, s), right(s, 1);
    for (Eigen::Index k = 0; k < s; ++k) {
        right(k, 0) = rational(1, static_cast<int>(k) + 1);
        for (Eigen::Index i = 0; i < s; ++i) V(k, i) = k == 0 ? rational(1) : V(k - 1, i) * t.c[i];
    }
    const auto b = *tableaux::solve<rational>(V, right);
    for (Eigen::Index i = 0; i < s; ++i) t.b[i] = b(i, 0);
}

STAGECRAFT_INLINE std::pair<rational, rational> two_nodes(dice& d) {
    rational u = d.node(), v = d.node();
    while (u == rational(2, 3)) u = d.node();
    while (v == u) v = d.node();
    return {u, v};
}

STAGECRAFT_INLINE method explicit_2(dice& d) {
    const rational c2 = d.node();
    method t = with_nodes({0, c2});
    set_row(t, 1, {0});
    t.b[1] = 1 / (2 * c2);
    t.b[0] = 1 - t.b[1];
    return t;
}

STAGECRAFT_INLINE method explicit_3(dice& d) {
    const auto [u, v] = two_nodes(d);
    method t = with_nodes({0, u, v});
    set_interpolatory_weights(t);
    set_row(t, 1, {0, 0});
    set_row(t, 2, {1 / (6 * t.b[2] * u), 0});
    return t;
}

STAGECRAFT_INLINE std::optional<method> explicit_4(const rational& u, const rational& v) {
    if (u == v || u == 1 || v == 1) return {};
    method t = with_nodes({0, u, v, 1});
    set_interpolatory_weights(t);
    if (t.b[2] == 0 || t.b[3] == 0) return {};
    const rational a43 = t.b[2] * (1 - v) / t.b[3];
    tableaux::dense<rational> M(2, 2), right(2, 1);  // for a_32 and a_42
    M << t.b[2], t.b[3], t.b[2] * v * u, t.b[3] * u;
    right(0, 0) = t.b[1] * (1 - u);
    right(1, 0) = rational(1, 8) - t.b[3] * a43 * v;
    const auto a = tableaux::solve<rational>(M, right);
    if (!a) return {};
    set_row(t, 1, {0, 0, 0});
    set_row(t, 2, {(*a)(0, 0), 0, 0});
    set_row(t, 3, {(*a)(1, 0), a43, 0});
    return t;
}

STAGECRAFT_INLINE method explicit_4(dice& d) {
    for (;;) {
        const rational v = d.node(), u = d.node();
        if (const auto t = explicit_4(u, v)) return *t;
    }
}

STAGECRAFT_INLINE method sdirk_2(const rational& g) {
    method t = with_nodes({g, 1 - g});
    t.A(0, 0) = t.A(1, 1) = g;
    t.A(1, 0) = 1 - 2 * g;
    t.b[0] = t.b[1] = rational(1, 2);
    return t;
}

STAGECRAFT_INLINE method collocation(const std::vector<rational>& nodes) {
    method t = with_nodes(nodes);
    set_interpolatory_weights(t);
    const auto s = t.b.size();
    tableaux::dense<rational> V(s, s), right(s, s);
    for (Eigen::Index k = 0; k < s; ++k) {
        for (Eigen::Index i = 0; i < s; ++i) {
            V(k, i) = k == 0 ? rational(1) : V(k - 1, i) * t.c[i];
            right(k, i) = V(k, i) * t.c[i] / rational(static_cast<int>(k) + 1);  // column i: row i of A
        }
    }
    const auto rows = *tableaux::solve<rational>(V, right);
    for (Eigen::Index i = 0; i < s; ++i)
        for (Eigen::Index j = 0; j < s; ++j) t.A(i, j) = rows(j, i);
    return t;
}

STAGECRAFT_INLINE std::vector<rational> collocation_nodes(dice& d) {
    const int which = d.between(0, 5);
    if (which == 0) {
        static const std::vector<rational> first{0, {1, 3}, {1, 4}, {1, 6}};
        const rational u = d.pick(first);
        return {u, (2 - 3 * u) / (3 - 6 * u)};
    }
    static const std::vector<rational> grid{0,      {1, 6}, {1, 5}, {1, 4}, {1, 3}, {2, 5},
                                            {1, 2}, {3, 5}, {2, 3}, {3, 4}, {4, 5}, 1};
    const int last = static_cast<int>(grid.size()) - 1;
    const int i = d.between(0, last - 2), j = d.between(i + 1, last - 1), k = d.between(j + 1, last);
    const auto at = [](int n) { return grid[static_cast<std::size_t>(n)]; };
    if (which == 1) return {at(i), at(j), at(k)};
    return {at(i), at(d.coin() ? j : k)};
}

}  // namespace stagecraft::theory::exercise_methods
