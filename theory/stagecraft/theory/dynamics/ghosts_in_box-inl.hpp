// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/ghosts_in_box.hpp"

#include <algorithm>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE int fixed_points_in_box::count(fixed_point_kind kind) const {
    return static_cast<int>(std::count(kinds.begin(), kinds.end(), kind));
}

namespace detail {

STAGECRAFT_INLINE interval_vector hull_of_parts(const interval_vector& z, Eigen::Index length) {
    interval_vector x = z.head(length);
    for (Eigen::Index p = length; p < z.size(); p += length)
        for (Eigen::Index k = 0; k < length; ++k) x[k] = hull(x[k], z[p + k]);
    for (Eigen::Index k = 0; k < length; ++k) {
        const double margin = 1e-7 * (1 + x[k].magnitude());
        x[k] = x[k] + interval(-margin, margin);
    }
    return x;
}

}  // namespace detail

}  // namespace stagecraft::theory
