// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/exercises/dice.hpp"

#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE int dice::between(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
}

STAGECRAFT_INLINE rational dice::node() {
    static const std::vector<rational> all{{1, 4}, {1, 3}, {2, 5}, {1, 2}, {3, 5}, {2, 3}, {3, 4}, 1};
    return pick(all);
}

}  // namespace stagecraft::theory
