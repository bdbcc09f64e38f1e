// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/absorbing.hpp"

#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE long absorbing_set::steps_from(double start) const {
    if (!(start >= 0)) throw std::invalid_argument("start: must not be negative");
    if (start <= radius) return 0;
    return static_cast<long>(
        std::ceil(((square(interval(start)) - square(interval(radius))) / decrease).high()));
}

}  // namespace stagecraft::theory
