// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <limits>
#include <stdexcept>

namespace stagecraft::tableaux {

/// Thrown where enclosures are too wide to decide a question at the working precision: the caller widens
/// the precision and repeats, or gives up with this error.
struct undecided : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Bits that hold `digits` decimal digits: more than digits * log2(10).
constexpr int bits_for_digits(int digits) { return digits * 3322 / 1000 + 2; }

/// Non-negative error bounds. Their exponents reach 2^-16000, far below any precision asked for here, and a
/// result of a few operations is made an upper bound by one multiplication (`upward`).
using bound = long double;
static_assert(std::numeric_limits<bound>::max_exponent >= 16384, "error bounds need the range of x87");

/// An upper bound of a non-negative expression whose computed value x has been through at most 32 roundings
/// and underflows. Infinity means that nothing is known.
bound upward(bound r);

/// A lower bound in the same sense, at least 0.
bound downward(bound r);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/precision-inl.hpp"
#endif
