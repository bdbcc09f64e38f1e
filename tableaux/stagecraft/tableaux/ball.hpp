// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <compare>
#include <concepts>
#include <cstdint>
#include <stagecraft/tableaux/number_traits.hpp>
#include <stagecraft/tableaux/precision.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <utility>
#include <vector>

namespace stagecraft::tableaux {

/// An enclosure of a real number: all x with |x - m 2^e| <= r, m an integer, r an upper bound. Every
/// operation returns a ball that contains all results for operands in the given balls. The precision is
/// chosen at run time, ball by ball: results keep at least the larger of their operands' `bits` significant
/// bits, and integers ask for 64. Zero with radius 0 stays exactly zero through products and sums, so
/// structural zeros of a tableau survive. Exponents are multiples of 64: alignment moves whole limbs.
class ball {
  public:
    using mantissa = boost::multiprecision::number<
        boost::multiprecision::cpp_int_backend<1024, 0, boost::multiprecision::signed_magnitude,
                                               boost::multiprecision::unchecked,
                                               std::allocator<boost::multiprecision::limb_type>>,
        boost::multiprecision::et_off>;
    static constexpr int limb = 64;

    ball() = default;
    /// The integer n, exactly.
    template <std::integral I>
    ball(I n) : m_(n) {}  // NOLINT: integers are numbers
    template <std::floating_point F>
    ball(F) = delete;
    /// The rational q, enclosed with `bits` significant bits (exactly where its denominator is 1).
    ball(const rational& q, int bits);
    /// All x with |x - m 2^e| <= r; results computed from it keep `bits` bits.
    ball(mantissa m, long e, bound r, int bits);

    int bits() const { return bits_; }
    bound radius() const { return r_; }
    bool exact() const { return r_ == 0; }
    bool exactly_zero() const { return r_ == 0 && m_.is_zero(); }
    /// The midpoint m 2^e, as a ball of radius 0 and by its parts.
    ball midpoint() const { return {m_, e_, 0, bits_}; }
    const mantissa& digits() const { return m_; }
    long exponent() const { return e_; }
    /// The same midpoint with radius at least r more: the set of all points within r of this ball.
    ball widened(bound r) const;
    /// The same set, computing with another number of bits from here on.
    ball with_bits(int bits) const;
    /// Times 2^k, exactly in the midpoint.
    ball scaled(long k) const;

    ball operator-() const;
    ball& operator+=(const ball& o) { return add(o, false); }
    ball& operator-=(const ball& o) { return add(o, true); }
    ball& operator*=(const ball& o);
    /// Throws undecided where o contains 0.
    ball& operator/=(const ball& o);
    friend ball operator+(ball a, const ball& b) { return a += b; }
    friend ball operator-(ball a, const ball& b) { return a -= b; }
    friend ball operator*(ball a, const ball& b) { return a *= b; }
    friend ball operator/(ball a, const ball& b) { return a /= b; }

    /// Times and divided by a small integer, cheaper than by a ball. n != 0 in the quotient.
    ball times(std::int64_t n) const;
    ball over(std::int64_t n) const;

    /// Upper and lower bounds of |midpoint|, and of |x| over the ball.
    bound magnitude() const { return upward(leading(m_, e_)); }
    bound magnitude_below() const { return downward(leading(m_, e_)); }
    bound upper_magnitude() const { return upward(magnitude() + r_); }
    bound lower_magnitude() const { return downward(magnitude_below() - r_); }

    /// The order that holds between all points of a and all points of b; unordered if the balls overlap,
    /// unless both are the same single point. What it says is certain.
    friend std::partial_ordering compare(const ball& a, const ball& b) {
        const ball d = exact_difference(a, b);
        const bound r = a.r_ == 0 && b.r_ == 0 ? 0 : upward(a.r_ + b.r_);
        if (d.m_.is_zero() && r == 0) return std::partial_ordering::equivalent;
        if (d.magnitude_below() <= r) return std::partial_ordering::unordered;
        return d.m_.sign() < 0 ? std::partial_ordering::less : std::partial_ordering::greater;
    }
    friend bool certainly_less(const ball& a, const ball& b) { return compare(a, b) < 0; }
    friend bool certainly_positive(const ball& a) { return a.m_.sign() > 0 && a.lower_magnitude() > 0; }
    friend bool certainly_negative(const ball& a) { return a.m_.sign() < 0 && a.lower_magnitude() > 0; }
    friend bool certainly_nonzero(const ball& a) { return a.lower_magnitude() > 0; }

    /// |x|.
    friend ball abs(const ball& x) { return x.m_.sign() < 0 ? -x : x; }

    /// Square root of a ball without negative points. Throws undecided where it has some.
    friend ball sqrt(const ball& x) {
        if (x.exactly_zero()) return x;
        if (!certainly_positive(x)) throw undecided("ball: square root of an enclosure that reaches 0");
        const long shift = round_up(std::max(0L, 2 * (x.bits_ + limb) - length(x.m_)) + limb);
        const long even = shift + ((x.e_ - shift) % (2 * limb) != 0 ? limb : 0);
        mantissa root = sqrt(mantissa(x.m_ << static_cast<unsigned>(even)));
        const bool whole = root * root == (x.m_ << static_cast<unsigned>(even));
        ball y;
        y.m_ = std::move(root);
        y.e_ = (x.e_ - even) / 2;
        y.bits_ = x.bits_;
        // |sqrt(a) - sqrt(b)| = |a - b| / (sqrt(a) + sqrt(b))
        if (x.r_ != 0) y.r_ = upward(x.r_ / y.magnitude_below());
        if (!whole) y.r_ = upward(y.r_ + unit(y.e_));
        const long odd = ((y.e_ % limb) + limb) % limb;
        y.m_ <<= static_cast<unsigned>(odd);
        y.e_ -= odd;
        y.truncate();
        return y;
    }

    /// A row of balls that takes part in many dot products: its largest entry and the sum of its radii are
    /// bounded once.
    struct row {
        std::vector<ball> entries;
        bound largest = 0;
        bound radii = 0;

        explicit row(std::vector<ball> v) : entries(std::move(v)) {
            for (const ball& x : entries) {
                if (x.r_ != 0) radii = upward(radii + x.r_);
                if (!x.m_.is_zero()) largest = std::max(largest, x.magnitude());
            }
        }
    };
    /// The sum of a_k b_k over equally many entries: products add up exactly and are rounded once. Its
    /// radius is bounded by Hoelder's inequality, |a|_max |r_b|_1 + |b|_max |r_a|_1 + |r_a|_1 |r_b|_1.
    friend ball dot(const row& a, const row& b) {
        const auto vanishes = [](const row& v) { return v.largest == 0 && v.radii == 0; };
        if (vanishes(a) || vanishes(b)) return 0;
        ball sum;
        bool first = true;
        for (std::size_t k = 0; k < a.entries.size(); ++k) {
            const ball &x = a.entries[k], &y = b.entries[k];
            sum.bits_ = std::max({sum.bits_, x.bits_, y.bits_});
            if (x.m_.is_zero() || y.m_.is_zero()) continue;
            if (first || x.e_ + y.e_ < sum.e_) sum.e_ = x.e_ + y.e_;
            first = false;
        }
        mantissa product;
        for (std::size_t k = 0; k < a.entries.size(); ++k) {
            const ball &x = a.entries[k], &y = b.entries[k];
            if (x.m_.is_zero() || y.m_.is_zero()) continue;
            multiply(product, x.m_, y.m_);
            if (x.e_ + y.e_ != sum.e_) product <<= static_cast<unsigned>(x.e_ + y.e_ - sum.e_);
            sum.m_ += product;
        }
        if (a.radii != 0 || b.radii != 0)
            sum.r_ = upward(a.largest * b.radii + b.largest * a.radii + a.radii * b.radii);
        sum.truncate();
        return sum;
    }

    /// Whether the rational q certainly lies in the ball (exact arithmetic, for tests and small cases).
    bool contains(const rational& q) const;
    /// Midpoint and ends as exact rationals.
    rational middle() const { return to_rational(m_, e_); }
    rational lower() const { return middle() - bound_to_rational(r_); }
    rational upper() const { return middle() + bound_to_rational(r_); }

    /// m 2^e, exactly.
    static rational to_rational(const mantissa& m, long e);
    /// r as an integer times a power of two, exactly; r finite.
    static std::pair<mantissa, long> bound_parts(bound r);
    static rational bound_to_rational(bound r);
    /// Number of bits of |m|.
    static long length(const mantissa& m);

  private:
    static_assert(sizeof(boost::multiprecision::limb_type) * 8 == limb, "64-bit limbs needed");

    static long round_up(long n) { return (n + limb - 1) / limb * limb; }
    /// 2^e, never rounded to zero.
    static bound unit(long e) { return upward(std::ldexp(bound(1), static_cast<int>(e))); }
    /// |m| 2^e from its two leading limbs, within a few units of the last place of `bound`.
    static bound leading(const mantissa& m, long e);
    /// Position of the lowest bit set of m != 0.
    static long lowest_bit(const mantissa& m);
    /// Drops low limbs beyond `bits_` bits and accounts for them.
    void truncate();
    ball& add(const ball& o, bool subtract);
    static ball exact_difference(const ball& a, const ball& b);

    mantissa m_ = 0;
    long e_ = 0;
    bound r_ = 0;
    int bits_ = limb;
};

}  // namespace stagecraft::tableaux

template <>
struct Eigen::NumTraits<stagecraft::tableaux::ball>
    : stagecraft::tableaux::number_traits<stagecraft::tableaux::ball> {};

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/ball-inl.hpp"
#endif
