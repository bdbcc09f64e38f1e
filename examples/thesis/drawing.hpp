// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <problems/thesis/solve.hpp>

#include "page.hpp"

namespace thesis {

/// Figure 4.1: the disc at equal times along its track, and the same as an animation, both as whole SVG files.
/// The motion is a run of the index-2 system with equal steps.
std::vector<drawing> disc_drawings(const trajectory& motion);

}  // namespace thesis
