// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/theory/judging/subject.hpp>

namespace stagecraft::theory {

/// Bits that the coefficients of det(I - zA) may have: a row's longest entry, summed over the rows.
int determinant_bits(const subject<tableaux::quadratic>& s);

/// Beyond this the stability function is enclosed: Sturm chains over such fractions take seconds. Published
/// methods stay far below.
inline constexpr int longest_exact_determinant = 1200;

/// Whether exact stability takes a second or more: a full A of ten stages whose fractions have no structure.
inline bool is_costly(const subject<tableaux::quadratic>& s) { return !s.lower && s.stages() >= 8; }

/// The same tableau in enclosures of its exact entries.
subject<tableaux::ball> enclosed(const subject<tableaux::quadratic>& s);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/exact_cost-inl.hpp"
#endif
