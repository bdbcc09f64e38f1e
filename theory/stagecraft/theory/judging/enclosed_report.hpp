// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/theory/judging/enclosed_function.hpp>
#include <stagecraft/theory/judging/stability_report.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <vector>

namespace stagecraft::theory {

/// The stability report of a tableau known by enclosures: R(infinity), A(alpha), the intervals on both axes, the
/// properties that a file can claim, the SSP radius (up to 16 stages), the orders for differential-algebraic problems.
/// Every number holds for each tableau among them, or it is not decided and the reason is told (enclosed_stability.hpp).
std::vector<report_section> enclosed_stability_report(const subject<tableaux::ball>& s);

namespace detail {

/// What the stability function decides, and f = R itself; nothing where that took more than its share of the time.
report_section enclosed_function_section(const subject<tableaux::ball>& s,
                                         std::optional<enclosed_stability_function>& f);

}  // namespace detail

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/enclosed_report-inl.hpp"
#endif
