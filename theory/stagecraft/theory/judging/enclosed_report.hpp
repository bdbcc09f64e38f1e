// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/judging/rounded_properties.hpp>
#include <stagecraft/theory/judging/stability_report.hpp>
#include <vector>

/// Stability of tableaux known by enclosures: what no method in the enclosure can have is refuted, with a
/// point; what is left was looked for on a grid, and is consistent.

namespace stagecraft::theory {

/// The stability report of a tableau known by enclosures: the properties that a file can claim, A(alpha), the
/// intervals on both axes, the SSP radius of the middle, the orders for differential-algebraic problems that a method
/// in the enclosures may have.
std::vector<report_section> enclosed_stability_report(const subject<ball>& s);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/enclosed_report-inl.hpp"
#endif
