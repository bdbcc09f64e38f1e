// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/exact_tableau.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/range.hpp"
#include "stagecraft/tableaux/roots.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE std::optional<std::vector<quadratic>> exact_nodes(const nodal_polynomial& w) {
    if (w.family() && w.degree() > 5) return {};  // more than two irrational nodes
    polynomial<rational> rest = monic(w.monomial());
    std::vector<quadratic> nodes;
    for (const ball& c : enclose_nodes(w, 192 + 2 * w.degree())) {
        const rational q = simplest_between(std::max(c.lower(), rational(0)), c.upper());
        if (rest(q) != 0) continue;
        nodes.emplace_back(q);
        rest = rest / polynomial<rational>{-q, 1};
    }
    if (rest.degree() > 2) return {};
    if (rest.degree() == 1) nodes.emplace_back(-rest[0]);
    if (rest.degree() == 2) {
        const auto root = exact_sqrt(rest[1] * rest[1] - 4 * rest[0]);
        if (!root) return {};
        nodes.push_back((quadratic(-rest[1]) - *root) / quadratic(2));
        nodes.push_back((quadratic(-rest[1]) + *root) / quadratic(2));
    }
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

STAGECRAFT_INLINE std::optional<tableau<quadratic>> exact_tableau(const nodal_polynomial& w,
                                                                  construction rule) {
    const auto nodes = exact_nodes(w);
    if (!nodes) return {};
    using poly = polynomial<quadratic>;
    const auto s = static_cast<Eigen::Index>(nodes->size());
    const auto c = [&](Eigen::Index i) { return (*nodes)[static_cast<std::size_t>(i)]; };
    const auto antiderivative = [&](Eigen::Index j, Eigen::Index from) {  // of the Lagrange polynomial of c_j
        poly lagrange(quadratic(1));
        for (Eigen::Index k = from; k < s; ++k)
            if (k != j) lagrange *= poly{-c(k) / (c(j) - c(k)), quadratic(1) / (c(j) - c(k))};
        return integral(lagrange);
    };
    tableau<quadratic> t;
    t.A.resize(s, s);
    t.b.resize(s);
    t.c.resize(s);
    for (Eigen::Index j = 0; j < s; ++j) {
        const poly whole = antiderivative(j, 0);
        t.c(j) = c(j);
        t.b(j) = whole(quadratic(1));
        for (Eigen::Index i = 0; i < s; ++i) t.A(i, j) = whole(c(i));
    }
    if (rule == construction::adjoint) {
        const auto collocation = t.A;
        for (Eigen::Index j = 0; j < s; ++j)
            for (Eigen::Index i = 0; i < s; ++i)
                t.A(i, j) = t.b(j) * (quadratic(1) - collocation(j, i) / t.b(i));
    } else if (rule == construction::lobatto_iiic) {
        for (Eigen::Index j = 0; j < s; ++j) {
            const poly inner = j == 0 ? poly() : antiderivative(j, 1);
            const quadratic at_left = j == 0 ? quadratic(-1) : derivative(inner)(quadratic(0));
            for (Eigen::Index i = 0; i < s; ++i) t.A(i, j) = inner(c(i)) - t.b(0) * at_left;
        }
    }
    return t;
}

STAGECRAFT_INLINE std::optional<tableau<quadratic>> exact_tableau(family f, int s) {
    return exact_tableau(nodal_polynomial(f, s), construction_of(f));
}

STAGECRAFT_INLINE tableau<quadratic>::matrix exact_inverse(tableau<quadratic>::matrix m) {
    const auto n = m.rows();
    tableau<quadratic>::matrix x(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) x(i, j) = i == j ? 1 : 0;
    for (Eigen::Index k = 0; k < n; ++k) {
        Eigen::Index pivot = k;
        while (pivot < n && m(pivot, k) == 0) ++pivot;
        if (pivot == n) throw std::domain_error("exact_inverse: the matrix is singular");
        for (Eigen::Index j = 0; j < n; ++j) {
            std::swap(m(k, j), m(pivot, j));
            std::swap(x(k, j), x(pivot, j));
        }
        const quadratic scale = quadratic(1) / m(k, k);
        for (Eigen::Index j = 0; j < n; ++j) {
            m(k, j) *= scale;
            x(k, j) *= scale;
        }
        for (Eigen::Index i = 0; i < n; ++i) {
            const quadratic f = m(i, k);
            if (i == k || f == 0) continue;
            for (Eigen::Index j = 0; j < n; ++j) {
                m(i, j) -= f * m(k, j);
                x(i, j) -= f * x(k, j);
            }
        }
    }
    return x;
}

STAGECRAFT_INLINE ball to_ball(const quadratic& x, int bits) {
    ball sum(x.rational_part(), bits);
    for (const auto& [factor, d] : x.surds()) sum += ball(factor, bits) * sqrt(ball(d).with_bits(bits));
    return sum;
}

}  // namespace stagecraft::tableaux
