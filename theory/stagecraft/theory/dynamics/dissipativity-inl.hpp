// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/dissipativity.hpp"

#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE void require_beta(const rational& beta) {
    if (!(beta > 0)) throw std::invalid_argument("beta: must be positive, is " + beta.str());
}

}  // namespace detail

}  // namespace stagecraft::theory
