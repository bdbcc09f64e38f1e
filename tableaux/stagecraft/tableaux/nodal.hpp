// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stagecraft/tableaux/family.hpp"
#include "stagecraft/tableaux/polynomial.hpp"
#include "stagecraft/tableaux/rational.hpp"

namespace stagecraft::tableaux {

/// Shifted Legendre coordinates w_0, ..., w_s of a family's nodal polynomial, w_s = 1 (Hairer-Wanner
/// II.IV.5): P_s (Gauss), P_s + P_{s-1} (Radau with c_1 = 0), P_s - P_{s-1} (Radau with c_s = 1),
/// P_s - P_{s-2} (Lobatto). Throws std::invalid_argument where the family has no member with s stages.
template <class K>
constexpr std::vector<K> nodal_legendre(family f, int s) {
    if (s < least_stages(f)) require_stages(f, s);
    std::vector<K> w(static_cast<std::size_t>(s) + 1, K(0));
    w[static_cast<std::size_t>(s)] = K(1);
    switch (f) {
        case family::gauss:
            break;
        case family::radau_i:
        case family::radau_ia:
            w[static_cast<std::size_t>(s) - 1] = K(1);
            break;
        case family::radau_ii:
        case family::radau_iia:
            w[static_cast<std::size_t>(s) - 1] = K(-1);
            break;
        case family::lobatto_iiia:
        case family::lobatto_iiib:
        case family::lobatto_iiic:
            w[static_cast<std::size_t>(s) - 2] = K(-1);
            break;
    }
    return w;
}

/// The polynomial w over the rationals whose roots are the nodes c_1 < ... < c_s: real, distinct, in [0, 1].
/// Immutable. Scaled so that its leading shifted Legendre coordinate is 1.
class nodal_polynomial {
  public:
    /// The nodal polynomial of a family. Its roots need no proof here, being those of classical orthogonal
    /// polynomials and the end points. Throws std::invalid_argument where the family has no member with s
    /// stages.
    nodal_polynomial(tableaux::family f, int s);

    /// From the coefficients of 1, x, x^2, ... in any scaling. Throws std::invalid_argument
    /// unless Sturm's theorem proves all roots real, distinct and in [0, 1].
    static nodal_polynomial from_coefficients(std::vector<rational> ascending, std::string name = "nodal");

    /// From distinct rational nodes in [0, 1], in any order. Throws std::invalid_argument if they are not so.
    static nodal_polynomial from_nodes(const std::vector<rational>& nodes, std::string name = "nodal");

    /// Number of nodes s.
    int degree() const { return monomial_.degree(); }
    /// Coordinates in P_0, ..., P_s; the last one is 1.
    const std::vector<rational>& legendre() const { return legendre_; }
    /// The same polynomial in powers of x; its leading coefficient is binom(2s, s).
    const polynomial<rational>& monomial() const { return monomial_; }
    /// The family, empty for other nodes.
    std::optional<tableaux::family> family() const { return family_; }
    const std::string& name() const { return name_; }

  private:
    nodal_polynomial(const polynomial<rational>& p, std::string name);

    std::vector<rational> legendre_;
    polynomial<rational> monomial_;
    std::optional<tableaux::family> family_;
    std::string name_;
};

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/nodal-inl.hpp"
#endif
