// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/principal_error.hpp"

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE std::string text(const principal_error& e) {
    return "principal error, of order " + std::to_string(e.order) + ": 2-norm " + e.norm + ", largest " +
           e.largest;
}

}  // namespace stagecraft::theory
