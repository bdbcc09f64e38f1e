// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/integer.hpp"

#include <cstdint>
#include <numeric>
#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux {

namespace detail {

/// Bits shift .. shift + 63 of |a|.
STAGECRAFT_INLINE std::uint64_t bits_from(const integer& a, std::size_t shift) {
    static_assert(sizeof(boost::multiprecision::limb_type) == 8, "64-bit limbs");
    const auto* limbs = a.backend().limbs();
    const std::size_t size = a.backend().size(), at = shift / 64, off = shift % 64;
    std::uint64_t low = at < size ? limbs[at] >> off : 0;
    if (off > 0 && at + 1 < size) low |= limbs[at + 1] << (64 - off);
    return low;
}

}  // namespace detail

STAGECRAFT_INLINE integer gcd(integer a, integer b) {
    using boost::multiprecision::abs;
    a = abs(a);
    b = abs(b);
    if (a < b) std::swap(a, b);
    while (b.backend().size() > 1) {
        const std::size_t shift = msb(a) - 60;
        auto x = static_cast<std::int64_t>(detail::bits_from(a, shift));
        auto y = static_cast<std::int64_t>(detail::bits_from(b, shift));
        std::int64_t p = 1, q = 0, r = 0, s = 1;  // the true pair is (p a + q b, r a + s b)
        while (y + r != 0 && y + s != 0) {
            const std::int64_t quotient = (x + p) / (y + r);
            if (quotient != (x + q) / (y + s)) break;  // the leading bits no longer decide it
            p = std::exchange(r, p - quotient * r);
            q = std::exchange(s, q - quotient * s);
            x = std::exchange(y, x - quotient * y);
        }
        if (q == 0) {
            a %= b;
            std::swap(a, b);
        } else {
            integer first = a * p + b * q;
            b = a * r + b * s;
            a = std::move(first);
        }
    }
    if (b == 0) return a;
    const auto last = static_cast<std::uint64_t>(b);
    return std::gcd(static_cast<std::uint64_t>(integer(a % b)), last);
}

STAGECRAFT_INLINE integer lcm(const integer& a, const integer& b) {
    if (a == 0 || b == 0) return 0;
    return boost::multiprecision::abs(integer(a / gcd(a, b) * b));
}

}  // namespace stagecraft::tableaux
