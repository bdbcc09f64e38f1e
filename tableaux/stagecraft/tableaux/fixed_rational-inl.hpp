// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/fixed_rational.hpp"

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE std::string fixed_rational::str() const {
    return denominator_ == 1 ? decimal(numerator_) : decimal(numerator_) + "/" + decimal(denominator_);
}

STAGECRAFT_INLINE std::string fixed_rational::decimal(int128 n) {
    std::string digits;
    const bool negative = n < 0;
    do {
        const int digit = static_cast<int>(n % 10);
        digits.insert(digits.begin(), static_cast<char>('0' + (digit < 0 ? -digit : digit)));
    } while ((n /= 10) != 0);
    return negative ? "-" + digits : digits;
}

}  // namespace stagecraft::tableaux
