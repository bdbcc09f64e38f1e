// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/tableau_numbers.hpp"

#include <stdexcept>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/simplifying.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE void require_step(const tableaux::rational& h) {
    if (!(h > 0)) throw std::invalid_argument("h: must be positive, is " + h.str());
}

}  // namespace detail

}  // namespace stagecraft::theory
