// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/range.hpp"
#include "stagecraft/tableaux/rational.hpp"

namespace stagecraft::tableaux {

/// The largest integer whose n-th power is not above m; m >= 0, n >= 2.
integer integer_root(const integer& m, int n);

/// n-th root of x >= 0, n >= 2, to range::working_bits; what is negative of x is cut off. Throws std::domain_error for an x
/// that is negative altogether.
range root(const range& x, int n);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/real_root-inl.hpp"
#endif
