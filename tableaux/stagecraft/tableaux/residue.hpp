// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stdexcept>

namespace stagecraft::tableaux {

/// An element a + b sqrt(d) of the ring F_p[sqrt d], p = 2^61 - 1: the image of a number of Q(sqrt d) under
/// reduction modulo p. The map respects + - *, so a polynomial expression in the entries of a tableau whose
/// residue is not zero is not zero: a *refutation* that costs nanoseconds. A zero residue proves nothing.
class residue {
  public:
    static constexpr std::uint64_t modulus = (std::uint64_t{1} << 61) - 1;

    constexpr residue() = default;
    template <std::integral I>
    constexpr residue(I n)  // NOLINT: integers have residues
        : a_(reduce_signed(static_cast<std::int64_t>(n))) {}
    constexpr residue(std::uint64_t a, std::uint64_t b, std::uint64_t d)
        : a_(a % modulus), b_(b % modulus), d_(b_ == 0 ? 0 : d) {}

    constexpr std::uint64_t rational_part() const { return a_; }
    constexpr std::uint64_t surd_part() const { return b_; }

    constexpr residue operator-() const { return residue(0) - *this; }
    constexpr residue& operator+=(const residue& o) {
        a_ = fold(a_ + o.a_);
        b_ = fold(b_ + o.b_);
        d_ |= o.d_;  // one field at a time: equal, or zero where rational
        return *this;
    }
    constexpr residue& operator-=(const residue& o) {
        a_ = fold(a_ + modulus - o.a_);
        b_ = fold(b_ + modulus - o.b_);
        d_ |= o.d_;
        return *this;
    }
    constexpr residue& operator*=(const residue& o) {
        if (b_ == 0 && o.b_ == 0) {
            a_ = product(a_, o.a_);
            return *this;
        }
        d_ |= o.d_;
        const std::uint64_t a = fold(product(a_, o.a_) + product(d_ % modulus, product(b_, o.b_)));
        b_ = fold(product(a_, o.b_) + product(b_, o.a_));
        a_ = a;
        return *this;
    }
    /// Throws std::domain_error where o has no inverse.
    constexpr residue& operator/=(const residue& o) {
        const std::uint64_t norm =
            fold(product(o.a_, o.a_) + modulus - product(o.d_ % modulus, product(o.b_, o.b_)));
        if (norm == 0) throw std::domain_error("residue: not invertible");
        const std::uint64_t inverse = power(norm, modulus - 2);
        return *this *= residue(product(o.a_, inverse), product(fold(modulus - o.b_), inverse), o.d_);
    }
    friend constexpr residue operator+(residue x, const residue& y) { return x += y; }
    friend constexpr residue operator-(residue x, const residue& y) { return x -= y; }
    friend constexpr residue operator*(residue x, const residue& y) { return x *= y; }
    friend constexpr residue operator/(residue x, const residue& y) { return x /= y; }
    friend constexpr bool operator==(const residue& x, const residue& y) {
        return x.a_ == y.a_ && x.b_ == y.b_;
    }

  private:
    static constexpr std::uint64_t fold(std::uint64_t x) { return x >= modulus ? x - modulus : x; }
    static constexpr std::uint64_t reduce_signed(std::int64_t n) {
        const std::uint64_t size = n < 0 ? 0 - static_cast<std::uint64_t>(n) : static_cast<std::uint64_t>(n);
        return n < 0 ? fold(modulus - size % modulus) : size % modulus;
    }
    static constexpr std::uint64_t product(std::uint64_t x, std::uint64_t y) {
        __extension__ using wide = unsigned __int128;
        const wide p = static_cast<wide>(x) * y;
        return fold((static_cast<std::uint64_t>(p) & modulus) + static_cast<std::uint64_t>(p >> 61));
    }
    static constexpr std::uint64_t power(std::uint64_t x, std::uint64_t n) {
        std::uint64_t r = 1;
        for (; n > 0; n >>= 1, x = product(x, x))
            if (n & 1) r = product(r, x);
        return r;
    }

    std::uint64_t a_ = 0;
    std::uint64_t b_ = 0;
    std::uint64_t d_ = 0;
};

/// The residue of r; empty where p divides the denominator.
inline std::optional<residue> residue_of(const rational& r) {
    const integer p(residue::modulus);
    integer n = r.numerator() % p;
    if (n < 0) n += p;
    const integer d = r.denominator() % p;
    if (d == 0) return std::nullopt;
    return residue(static_cast<std::uint64_t>(n), 0, 0) / residue(static_cast<std::uint64_t>(d), 0, 0);
}

inline std::optional<residue> residue_of(const quadratic& x) {
    const auto a = residue_of(x.rational_part());
    const auto b = residue_of(x.surd_part());
    if (!a || !b) return std::nullopt;
    return residue(a->rational_part(), b->rational_part(), x.radicand());
}

}  // namespace stagecraft::tableaux
