// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/nodal.hpp"

#include <stdexcept>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/legendre.hpp"
#include "stagecraft/tableaux/sturm.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE nodal_polynomial::nodal_polynomial(tableaux::family f, int s)
    : legendre_(nodal_legendre<rational>(f, s)),
      monomial_(from_legendre(legendre_)),
      family_(f),
      name_(tableaux::name(f)) {}

STAGECRAFT_INLINE nodal_polynomial nodal_polynomial::from_coefficients(std::vector<rational> ascending,
                                                                       std::string name) {
    polynomial<rational> p(std::move(ascending));
    if (p.degree() < 1) throw std::invalid_argument("coefficients: a nodal polynomial has degree at least 1");
    const sturm_chain<rational> chain(p);
    const int roots = chain.count(0, 1) + (p[0] == 0 ? 1 : 0);
    if (roots != p.degree())
        throw std::invalid_argument("coefficients: " + std::to_string(p.degree()) +
                                    " distinct real roots in [0, 1] needed, this polynomial has " +
                                    std::to_string(roots));
    return {p, std::move(name)};
}

STAGECRAFT_INLINE nodal_polynomial nodal_polynomial::from_nodes(const std::vector<rational>& nodes,
                                                                std::string name) {
    if (nodes.empty()) throw std::invalid_argument("nodes: at least one node needed");
    polynomial<rational> p(1);
    for (const rational& c : nodes) {
        if (c < 0 || c > 1)
            throw std::invalid_argument("nodes: must lie in [0, 1], one of them is " + c.str());
        if (p(c) == 0) throw std::invalid_argument("nodes: must be distinct, " + c.str() + " is repeated");
        p *= polynomial<rational>{-c, 1};
    }
    return {p, std::move(name)};
}

STAGECRAFT_INLINE nodal_polynomial::nodal_polynomial(const polynomial<rational>& p, std::string name)
    : legendre_(to_legendre(p)), name_(std::move(name)) {
    const rational leading = legendre_.back();
    for (rational& u : legendre_) u /= leading;
    monomial_ = p * polynomial<rational>(1 / leading);
}

}  // namespace stagecraft::tableaux
