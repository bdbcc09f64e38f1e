// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/real_root.hpp"

#include <stdexcept>

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE integer integer_root(const integer& m, int n) {
    if (m < 2) return m;
    // Newton's iteration falls from above until it is there.
    integer x = integer(1) << (static_cast<int>(msb(m)) / n + 1);
    for (;;) {
        const integer y = ((n - 1) * x + m / pow(x, static_cast<unsigned>(n - 1))) / n;
        if (y >= x) return x;
        x = y;
    }
}

STAGECRAFT_INLINE range root(const range& x, int n) {
    if (x.upper < 0) throw std::domain_error("root of a negative number");
    const auto enclosed = [n](const rational& r) {  // floor(r^(1/n) 2^k) 2^-k, and the step 2^-k
        if (r <= 0) return range{0, 0};
        const int k = range::working_bits - binary_exponent(r) / n;
        const integer m = integer_root(floor(scaled(r, n * k)), n);
        return range{scaled(rational(m), -k), scaled(rational(integer(m + 1)), -k)};
    };
    return {enclosed(x.lower).lower, enclosed(x.upper).upper};
}

}  // namespace stagecraft::tableaux
