// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/ball.hpp>
#include <vector>

namespace stagecraft::theory {

/// A part of [0, infinity) on which every polynomial among some has one sign.
struct sign_piece {
    int sign = 0;  ///< 1 or -1 between the ends, for every polynomial; 0 where that is open
    tableaux::bound from = 0;
    tableaux::bound to = 0;  ///< may be infinity
};

/// How far signs_on_half_line goes, and how finely.
struct sign_search {
    bool to_first_negative = false;  ///< ends behind the first piece with the sign -1
    tableaux::bound until = -1;      ///< and behind this point; negative: to infinity
    int most_cells = 20000;          ///< beyond so many parts the rest is open
};

/// The signs on [0, infinity) of all polynomials whose coefficients, ascending, lie in the enclosures p: neighbouring
/// pieces differ in sign. Decided by the coefficients in Bernstein's basis on [0, 1] and, of the reversed polynomial, on
/// [1, infinity), halving where these have no common sign: their enclosures do not widen by that, for each is the mean
/// of two. A part is open where rounding could explain all of its coefficients, or to 2^-44 of its position. A sign
/// found is certain; no point is a sample. O(degree^2) operations for each of the parts looked at.
std::vector<sign_piece> signs_on_half_line(std::vector<tableaux::ball> p, const sign_search& how = {});

/// Whether every polynomial is positive between 0 and infinity.
bool all_positive(const std::vector<sign_piece>& pieces);

/// The first piece with this sign, or nothing.
const sign_piece* first_with_sign(const std::vector<sign_piece>& pieces, int sign);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/stability/enclosed_signs-inl.hpp"
#endif
