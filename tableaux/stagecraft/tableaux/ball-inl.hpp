// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/ball.hpp"

#include <bit>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/time_share.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE ball::ball(const rational& q, int bits) : m_(q.numerator()), bits_(std::max(bits, limb)) {
    if (q.denominator() != 1) *this /= ball(mantissa(q.denominator()), 0, 0, bits);
}

STAGECRAFT_INLINE ball::ball(mantissa m, long e, bound r, int bits)
    : m_(std::move(m)), e_(e), r_(r), bits_(std::max(bits, limb)) {
    const long odd = ((e_ % limb) + limb) % limb;
    m_ <<= static_cast<unsigned>(odd);
    e_ -= odd;
}

STAGECRAFT_INLINE ball ball::widened(bound r) const {
    ball x = *this;
    x.r_ = upward(x.r_ + r);
    return x;
}

STAGECRAFT_INLINE ball ball::with_bits(int bits) const {
    ball x = *this;
    x.bits_ = std::max(bits, limb);
    x.truncate();
    return x;
}

STAGECRAFT_INLINE ball ball::scaled(long k) const {
    const bound r = r_ == 0 ? 0 : upward(std::ldexp(r_, static_cast<int>(k)));
    return {m_, e_ + k, r, bits_};
}

STAGECRAFT_INLINE ball ball::operator-() const {
    ball x = *this;
    x.m_.backend().negate();
    return x;
}

STAGECRAFT_INLINE ball& ball::operator*=(const ball& o) {
    time_share::check();
    bits_ = std::max(bits_, o.bits_);
    if (exactly_zero() || o.exactly_zero()) return *this = ball(mantissa(0), 0, 0, bits_);
    if (r_ != 0 || o.r_ != 0) r_ = upward(magnitude() * o.r_ + o.magnitude() * r_ + r_ * o.r_);
    m_ *= o.m_;
    e_ += o.e_;
    truncate();
    return *this;
}

STAGECRAFT_INLINE ball& ball::operator/=(const ball& o) {
    if (this == &o) return *this /= ball(o);
    bits_ = std::max(bits_, o.bits_);
    const bound least = downward(o.magnitude_below() - o.r_);
    if (!(least > 0)) throw undecided("ball: division by an enclosure that contains 0");
    if (exactly_zero()) return *this;
    // |a/b - A/B| <= (|A/B| r_b + r_a) / (|B| - r_b), A and B the midpoints
    const bound ratio = magnitude() / o.magnitude_below();
    if (r_ != 0 || o.r_ != 0) r_ = upward((upward(ratio) * o.r_ + r_) / least);
    const long have = length(m_) - length(o.m_);
    const long shift = round_up(std::max(0L, bits_ + limb - have));
    mantissa rest;
    divide_qr(mantissa(m_ << static_cast<unsigned>(shift)), o.m_, m_, rest);
    e_ -= o.e_ + shift;
    if (!rest.is_zero()) r_ = upward(r_ + unit(e_));
    truncate();
    return *this;
}

STAGECRAFT_INLINE ball ball::times(std::int64_t n) const {
    ball x = *this;
    x.m_ *= n;
    if (r_ != 0) x.r_ = upward(r_ * std::abs(static_cast<bound>(n)));
    x.truncate();
    return x;
}

STAGECRAFT_INLINE ball ball::over(std::int64_t n) const {
    ball x = *this;
    const long shift = round_up(std::max(0L, bits_ + limb - length(m_)));
    x.m_ <<= static_cast<unsigned>(shift);
    x.e_ -= shift;
    const mantissa whole = x.m_;
    x.m_ /= n;
    if (r_ != 0) x.r_ = upward(r_ / std::abs(static_cast<bound>(n)));
    if (x.m_ * n != whole) x.r_ = upward(x.r_ + unit(x.e_));
    x.truncate();
    return x;
}

STAGECRAFT_INLINE bool ball::contains(const rational& q) const {
    const rational d = abs(q - to_rational(m_, e_));
    if (r_ == 0) return d == 0;
    return r_ > std::numeric_limits<bound>::max() || d <= bound_to_rational(r_);
}

STAGECRAFT_INLINE rational ball::to_rational(const mantissa& m, long e) {
    const integer n(m);
    return e < 0 ? rational(n, integer(1) << static_cast<unsigned>(-e))
                 : rational(integer(n << static_cast<unsigned>(e)));
}

STAGECRAFT_INLINE std::pair<ball::mantissa, long> ball::bound_parts(bound r) {
    int e = 0;
    const bound f = std::frexp(r, &e);
    constexpr int p = std::numeric_limits<bound>::digits;
    return {mantissa(std::ldexp(f, p)), e - p};
}

STAGECRAFT_INLINE rational ball::bound_to_rational(bound r) {
    if (r == 0) return 0;
    const auto [m, e] = bound_parts(r);
    return to_rational(m, e);
}

STAGECRAFT_INLINE long ball::length(const mantissa& m) {
    if (m.is_zero()) return 0;
    const auto& b = m.backend();
    return static_cast<long>(limb * (b.size() - 1)) +
           std::bit_width(static_cast<std::uint64_t>(b.limbs()[b.size() - 1]));
}

STAGECRAFT_INLINE bound ball::leading(const mantissa& m, long e) {
    const auto& b = m.backend();
    const auto n = b.size();
    bound x = static_cast<bound>(b.limbs()[n - 1]);
    if (n > 1) {
        x = x * 0x1p64L + static_cast<bound>(b.limbs()[n - 2]);
        e += static_cast<long>(limb * (n - 2));
    }
    return std::ldexp(x, static_cast<int>(e));
}

STAGECRAFT_INLINE long ball::lowest_bit(const mantissa& m) {
    const auto* limbs = m.backend().limbs();
    long k = 0;
    while (limbs[k] == 0) ++k;
    return k * limb + std::countr_zero(static_cast<std::uint64_t>(limbs[k]));
}

STAGECRAFT_INLINE void ball::truncate() {
    const long drop = (length(m_) - bits_) / limb * limb;
    if (drop <= 0) return;
    const bool loss = lowest_bit(m_) < drop;
    // Boost 1.74 shifts negative numbers by way of ++, which loses the sign where the lowest limb is 1.
    const bool negative = m_.sign() < 0;
    if (negative) m_.backend().negate();
    m_ >>= static_cast<unsigned>(drop);
    if (negative) m_.backend().negate();
    e_ += drop;
    if (loss) r_ = upward(r_ + unit(e_));
}

STAGECRAFT_INLINE ball& ball::add(const ball& o, bool subtract) {
    time_share::check();
    bits_ = std::max(bits_, o.bits_);
    if (o.m_.is_zero()) {
        if (o.r_ != 0) r_ = upward(r_ + o.r_);
        return *this;
    }
    const long top = length(m_) + e_;
    const long other = length(o.m_) + o.e_;
    if (!m_.is_zero() && other < top - bits_ - limb && o.e_ < e_) {  // o is below this one's last bit
        r_ = upward(r_ + o.magnitude() + o.r_);
        return *this;
    }
    if (m_.is_zero() || (top < other - bits_ - limb && e_ < o.e_)) {
        const bound r = m_.is_zero() ? r_ : upward(r_ + magnitude());
        m_ = o.m_;
        e_ = o.e_;
        if (subtract) m_.backend().negate();
        r_ = r == 0 && o.r_ == 0 ? 0 : upward(r + o.r_);
        truncate();
        return *this;
    }
    if (o.r_ != 0 || r_ != 0) r_ = upward(r_ + o.r_);
    if (o.e_ < e_) {
        m_ <<= static_cast<unsigned>(e_ - o.e_);
        e_ = o.e_;
    }
    if (o.e_ > e_) {
        const mantissa aligned = o.m_ << static_cast<unsigned>(o.e_ - e_);
        subtract ? m_ -= aligned : m_ += aligned;
    } else {
        subtract ? m_ -= o.m_ : m_ += o.m_;
    }
    truncate();
    return *this;
}

STAGECRAFT_INLINE ball ball::exact_difference(const ball& a, const ball& b) {
    const long e = std::min(a.e_, b.e_);
    ball d;
    d.m_ = (a.m_ << static_cast<unsigned>(a.e_ - e)) - (b.m_ << static_cast<unsigned>(b.e_ - e));
    d.e_ = e;
    return d;
}

}  // namespace stagecraft::tableaux
