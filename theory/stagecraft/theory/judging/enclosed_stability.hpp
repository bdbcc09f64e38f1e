// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <limits>
#include <stagecraft/theory/judging/certificate.hpp>
#include <stagecraft/theory/judging/enclosed_function.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <stagecraft/theory/statements/verdict.hpp>
#include <vector>

/// Stability of every tableau among enclosures. A number is an interval that holds the number of each of them; no
/// verdict rests on points that were sampled. Where an equality is needed that the digits cannot prove (R agrees with
/// e^z to the order p, P has no higher degree than Q, |R(iy)| = 1), it is said, and the verdict is consistent with its
/// residual and bound; without one it is proved.

namespace stagecraft::theory {

/// |R(z)| <= 1 for Re z <= 0. Refuted by a y with |R(iy)| > 1 of every tableau among the enclosures, or a pole in the
/// left half-plane of each. Else |R(iy)| < 1 is decided for all y: near 0 it needs the order of R, near infinity that
/// P has no higher degree than Q; the poles are counted for one tableau, as none can cross the axis.
verdict rounded_a_stable(const subject<ball>& s);

/// A-stable with R(infinity) = 0, that is degree P < degree Q.
verdict rounded_l_stable(const subject<ball>& s);

/// A(alpha)-stable up to ... degrees: cos(alpha) by bisection between a ray on which |R| < 1 of every tableau (and no
/// pole in the sector) and one on which |R| > 1 somewhere of every tableau.
claim enclosed_sector(const subject<ball>& s, const enclosed_stability_function& f);

/// The intervals of stability on the negative real and on the imaginary axis.
claim enclosed_real_interval(const enclosed_stability_function& f);
claim enclosed_imaginary_interval(const enclosed_stability_function& f);

/// R(infinity), with what it would be by an equality.
claim enclosed_limit(const subject<ball>& s, const enclosed_stability_function& f);

namespace detail {

/// Of a number that is infinite.
inline constexpr number_range no_end{std::numeric_limits<bound>::infinity(),
                                     std::numeric_limits<bound>::infinity()};

/// "4.81975435359" or "3.5049 to 3.5068", and "between 4.8197543535934 and 4.8197543535935".
std::string in_digits(const number_range& x);
std::string between(const number_range& x);

inline constexpr const char* every_table = "for every table within the rounding";

}  // namespace detail

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/enclosed_stability-inl.hpp"
#endif
