// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/rounded.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE int working_bits(int target, const nodal_polynomial& w) {
    const int s = w.degree();
    return target + (w.family() ? 24 + 5 * std::bit_width(static_cast<unsigned>(s)) : 32 + 3 * s / 2);
}

namespace rounding {

STAGECRAFT_INLINE void sharpen_basic(const std::optional<tableau<quadratic>>& exact, tableau<ball>& t,
                                     int bits) {
    if (!exact) return;
    sharpen(exact->A, t.A, bits);
    sharpen(exact->b, t.b, bits);
    sharpen(exact->c, t.c, bits);
}

}  // namespace rounding

}  // namespace stagecraft::tableaux
