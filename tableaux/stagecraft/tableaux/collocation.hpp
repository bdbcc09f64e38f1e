// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/tableaux/family.hpp>
#include <stagecraft/tableaux/nodal.hpp>
#include <stagecraft/tableaux/roots.hpp>
#include <stdexcept>
#include <vector>

namespace stagecraft::tableaux {

/// The Lagrange polynomial of a node: factor times the sum over k of shape[k] P_k.
struct lagrange_form {
    ball factor;
    std::vector<ball> shape;
};

/// The Lagrange polynomials of all nodes; p holds the values P_k(c_j), k <= s. For a family: shape[k] =
/// P_k(c_j) / G_k with the Gram entries G_k = 1/(2k+1) of b^T(uv), the last one 1/(s-1) for Lobatto, and
/// factor = b_j = 1 / sum P_k(c_j)^2 / G_k. For other nodes: w / (x - c_j) by back substitution in the
/// three-term recurrence, scaled to 1 at c_j. O(s^2).
inline std::vector<lagrange_form> lagrange_forms(const nodal_polynomial& w, const std::vector<ball>& nodes,
                                                 const std::vector<std::vector<ball>>& p, int bits) {
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

/// Whether the nodes are symmetric about 1/2: w has then Legendre coordinates of one parity alone.
inline bool symmetric_nodes(const nodal_polynomial& w) {
    for (int k = w.degree() - 1; k >= 0; k -= 2)
        if (w.legendre()[static_cast<std::size_t>(k)] != 0) return false;
    return true;
}

/// Enclosures of c, b and A of the method with nodal polynomial w and the given construction (Hairer-Wanner
/// II.IV.5), by closed forms and computed with `bits` bits: with I_k the integral of P_k from 0 to x
/// and l_j = factor_j sum over k of shape_j[k] P_k,
///     collocation   a_ij = factor_j sum over k of I_k(c_i) shape_j[k]
///     adjoint       a_ij = b_j (1 - sum over k of I_k(c_j) shape_i[k] / shape_i[0]),    that is D(s)
///     lobatto_iiic  as collocation, with (P_{s-1} - P_{s-2}) / (2(s-1)) in the place of I_{s-1}
/// Radii grow like a power of s for a family, by about 1.3 bits a stage for other nodes. s^3 multiplications,
/// half of them where symmetry gives half of the rows. Throws undecided where `bits` is too small.
inline tableau<ball> enclose(const nodal_polynomial& w, construction rule, int bits) {
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
