// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/collocation.hpp"

#include <cstddef>
#include <stdexcept>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/roots.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE std::vector<lagrange_form> lagrange_forms(const nodal_polynomial& w,
                                                            const std::vector<ball>& nodes,
                                                            const std::vector<std::vector<ball>>& p,
                                                            int bits) {
    const int s = w.degree();
    std::vector<lagrange_form> forms;
    for (std::size_t j = 0; j < nodes.size(); ++j) {
        std::vector<ball> u(static_cast<std::size_t>(s));
        ball value = 0;  // of the sum of u_k P_k at c_j
        if (w.family()) {
            const bool lobatto = least_stages(*w.family()) == 2;
            for (int k = 0; k < s; ++k) {
                const auto at = static_cast<std::size_t>(k);
                u[at] = p[j][at].times(lobatto && k == s - 1 ? s - 1 : 2 * k + 1);
                value += u[at] * p[j][at];
            }
            forms.push_back({ball(1).with_bits(bits) / value, std::move(u)});
            continue;
        }
        const ball shift = nodes[j] - ball(1).scaled(-1);
        for (int k = s - 1; k >= 0; --k) {
            const auto at = static_cast<std::size_t>(k);
            ball q(w.legendre()[at + 1], bits);
            if (k + 1 < s) q += u[at + 1] * shift;
            if (k + 2 < s) q -= u[at + 2].times(k + 2).over(2 * (2 * k + 5));
            u[at] = q.times(2 * (2 * k + 1)).over(k + 1);
            value += u[at] * p[j][at];
        }
        forms.push_back({ball(1).with_bits(bits) / value, std::move(u)});
    }
    return forms;
}

STAGECRAFT_INLINE bool symmetric_nodes(const nodal_polynomial& w) {
    for (int k = w.degree() - 1; k >= 0; k -= 2)
        if (w.legendre()[static_cast<std::size_t>(k)] != 0) return false;
    return true;
}

STAGECRAFT_INLINE tableau<ball> enclose(const nodal_polynomial& w, construction rule, int bits) {
    const int s = w.degree();
    const std::vector<ball> nodes = enclose_nodes(w, bits);
    std::vector<std::vector<ball>> p;
    std::vector<ball::row> integrals, shapes;
    for (const ball& c : nodes) {
        p.push_back(legendre_values(c, s).value);
        const auto& value = p.back();
        std::vector<ball> row{c};
        for (int k = 1; k < s; ++k) {
            const auto at = static_cast<std::size_t>(k);
            row.push_back((value[at + 1] - value[at - 1]).over(2 * (2 * k + 1)));
        }
        if (rule == construction::lobatto_iiic) {
            const auto last = static_cast<std::size_t>(s) - 1;
            row[last] = (value[last] - value[last - 1]).over(2 * (s - 1));
        }
        integrals.emplace_back(std::move(row));
    }
    const auto lagrange = lagrange_forms(w, nodes, p, bits);
    for (const lagrange_form& form : lagrange) shapes.emplace_back(form.shape);
    tableau<ball> t;
    t.A.resize(s, s);
    t.b.resize(s);
    t.c.resize(s);
    for (int i = 0; i < s; ++i) {
        t.c(i) = nodes[static_cast<std::size_t>(i)];
        const auto& form = lagrange[static_cast<std::size_t>(i)];
        t.b(i) = form.factor * form.shape[0];
    }
    const bool adjoint = rule == construction::adjoint;
    const auto at_one = [&](int j) { return compare(t.c(j), ball(1)) == std::partial_ordering::equivalent; };
    const auto entry = [&](int i, int j) {
        const auto node = static_cast<std::size_t>(adjoint ? j : i);
        const auto basis = static_cast<std::size_t>(adjoint ? i : j);
        if (adjoint && at_one(j)) return ball(0);
        const ball sum = dot(integrals[node], shapes[basis]);
        return adjoint ? t.b(j) * (ball(1) - sum / lagrange[basis].shape[0]) : lagrange[basis].factor * sum;
    };
    // With symmetric nodes collocation and its adjoint are symmetric: a_ij + a_(s+1-i)(s+1-j) = b_j.
    const bool mirrored = rule != construction::lobatto_iiic && symmetric_nodes(w);
    const int rows = mirrored ? (s + 1) / 2 : s;
    constexpr int tile = 4;  // rows that stay in the cache while the columns pass
    for (int first = 0; first < rows; first += tile)
        for (int j = 0; j < s; ++j)
            for (int i = first; i < std::min(first + tile, rows); ++i) t.A(i, j) = entry(i, j);
    for (int i = rows; i < s; ++i)
        for (int j = 0; j < s; ++j)
            t.A(i, j) = adjoint && at_one(j) ? ball(0) : t.b(j) - t.A(s - 1 - i, s - 1 - j);
    return t;
}

}  // namespace stagecraft::tableaux
