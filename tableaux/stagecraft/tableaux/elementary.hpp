// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/integer.hpp>
#include <stagecraft/tableaux/range.hpp>

/// pi, cos and sin of entries, by enclosures.

namespace stagecraft::tableaux {

namespace detail {

/// x, known to much less than 2^-440, and 2^-440 to either side.
range around(const integer& x);

}  // namespace detail

/// pi, by Machin's formula 16 arctan(1/5) - 4 arctan(1/239).
range pi_range();

/// Encloses cos x and sin x. Throws std::invalid_argument for arguments beyond 1000.
range cos(const range& x);
range sin(const range& x);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/elementary-inl.hpp"
#endif
