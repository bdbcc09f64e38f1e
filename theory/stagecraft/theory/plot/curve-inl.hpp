// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/plot/curve.hpp"

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory::plot {

STAGECRAFT_INLINE bool window::contains(complex z) const {
    return z.real() >= left && z.real() <= right && z.imag() >= bottom && z.imag() <= top;
}

STAGECRAFT_INLINE double window::distance(complex z) const {
    return std::hypot(std::max({left - z.real(), 0.0, z.real() - right}),
                      std::max({bottom - z.imag(), 0.0, z.imag() - top}));
}

STAGECRAFT_INLINE void require_window(const window& w) {
    if (!(w.width() > 0 && w.height() > 0 && std::isfinite(w.diagonal())))
        throw std::invalid_argument("window: needs left < right and bottom < top, all finite");
}

}  // namespace stagecraft::theory::plot
