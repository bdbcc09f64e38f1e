// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stagecraft/theory/judging/file_certificate.hpp>

namespace stagecraft::theory {

/// Deviations beyond this are no rounding errors of anything.
inline constexpr tableaux::bound farthest = 0.01L;
/// Families are compared up to this many stages.
inline constexpr int most_family_stages = 20;

/// The member of the known families nearest to rounded data, where it is near at all (all entries within
/// `farthest`). The error is counted in units in the last place given: 0.5 for data rounded correctly.
/// Costs an enclosure of the tableau for each family, milliseconds.
std::optional<nearest_family> nearest(const tableaux::tableau_file& file);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/nearest_family-inl.hpp"
#endif
