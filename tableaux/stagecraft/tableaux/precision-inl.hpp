// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/precision.hpp"

#include <cmath>

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE bound upward(bound r) {
    constexpr bound grow = 1 + 64 * std::numeric_limits<bound>::epsilon();
    if (!(r <= std::numeric_limits<bound>::max() / 2)) return std::numeric_limits<bound>::infinity();
    return r * grow + std::numeric_limits<bound>::min();
}

STAGECRAFT_INLINE bound downward(bound r) {
    constexpr bound shrink = 1 - 64 * std::numeric_limits<bound>::epsilon();
    if (r > std::numeric_limits<bound>::max() / 2) return std::numeric_limits<bound>::max() / 4;
    const bound s = r * shrink - std::numeric_limits<bound>::min();
    return s > 0 ? s : 0;
}

}  // namespace stagecraft::tableaux
