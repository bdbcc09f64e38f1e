// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/judging/certificate.hpp>
#include <stagecraft/theory/judging/subject.hpp>

namespace stagecraft::theory {

/// The radius of absolute monotonicity (ssp_radius) of every tableau among the enclosures: each of its conditions is a
/// polynomial in r known by enclosures. Stages that nothing uses are left out. Not decided where two stages may be the
/// same, of which only one counts. O(s^5) operations.
claim enclosed_ssp_radius(const subject<tableaux::ball>& s);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/enclosed_ssp-inl.hpp"
#endif
