// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

namespace stagecraft::tableaux {

/// An integer of any size.
using integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

/// The greatest common divisor, >= 0, by Lehmer's method (Knuth, TAOCP 2, section 4.5.2, algorithm L): some
/// thirty quotients of Euclid's algorithm at a time from the leading 61 bits. O(n^2 / 60) limb operations
/// where the binary method of Boost before 1.76 needs O(n^2), and O(n) where one number fits a limb, which is
/// what exact tableaux spend their time on.
integer gcd(integer a, integer b);

/// The least common multiple, >= 0.
integer lcm(const integer& a, const integer& b);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/integer-inl.hpp"
#endif
