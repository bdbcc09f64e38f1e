// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/tableaux/family.hpp>
#include <stagecraft/tableaux/nodal.hpp>
#include <stagecraft/tableaux/quadratic.hpp>
#include <vector>

namespace stagecraft::tableaux {

/// The nodes as elements of one quadratic field, increasing, or nothing where they do not lie in one: all but
/// two of them must be rational. (Gauss and Radau up to s = 3, Lobatto up to s = 5, any rational nodes.)
std::optional<std::vector<quadratic>> exact_nodes(const nodal_polynomial& w);

/// The tableau in exact surds, or nothing where the nodes lie in no quadratic field. By integration of the
/// Lagrange polynomials themselves: another way than that of `enclose`.
std::optional<tableau<quadratic>> exact_tableau(const nodal_polynomial& w, construction rule);

std::optional<tableau<quadratic>> exact_tableau(family f, int s);

/// The inverse of a regular matrix over a field, by elimination. Throws std::domain_error where it is
/// singular.
tableau<quadratic>::matrix exact_inverse(tableau<quadratic>::matrix m);

/// A sum of surds as a ball of about `bits` bits.
ball to_ball(const quadratic& x, int bits);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/exact_tableau-inl.hpp"
#endif
