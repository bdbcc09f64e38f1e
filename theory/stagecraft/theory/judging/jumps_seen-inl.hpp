// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/jumps_seen.hpp"

#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE bool certainly_before(const tableaux::ball& x, const tableaux::ball& y) {
    return certainly_less(x, y);
}

}  // namespace detail

}  // namespace stagecraft::theory
