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

/// An element a + b i of the field F_p(i), p = 2^61 - 1, i^2 = -1: the image of a number of Q(sqrt d, sqrt e)
/// under reduction modulo p, where every square root exists: p = 3 modulo 4, so of q and -q one is a square in F_p.
/// The map respects + - *, so a polynomial expression in the entries of a tableau whose
/// residue is not zero is not zero: a *refutation* that costs nanoseconds. A zero residue proves nothing.
class residue {
  public:
    static constexpr std::uint64_t modulus = (std::uint64_t{1} << 61) - 1;

    constexpr residue() = default;
    template <std::integral I>
    constexpr residue(I n)  // NOLINT: integers have residues
        : a_(reduce_signed(static_cast<std::int64_t>(n))) {}
    /// sqrt(q) for a prime q < p: one of both, always the same.
    static constexpr residue root_of_prime(std::uint64_t q) {
        constexpr std::uint64_t quarter = (modulus + 1) / 4;
        residue r;
        r.a_ = power(q, quarter);
        if (product(r.a_, r.a_) == q) return r;
        r.b_ = power(modulus - q, quarter);
        r.a_ = 0;
        return r;
    }

    constexpr residue operator-() const { return residue(0) - *this; }
    constexpr residue& operator+=(const residue& o) {
        a_ = fold(a_ + o.a_);
        b_ = fold(b_ + o.b_);
        return *this;
    }
    constexpr residue& operator-=(const residue& o) {
        a_ = fold(a_ + modulus - o.a_);
        b_ = fold(b_ + modulus - o.b_);
        return *this;
    }
    constexpr residue& operator*=(const residue& o) {
        if (b_ == 0 && o.b_ == 0) {
            a_ = product(a_, o.a_);
            return *this;
        }
        const std::uint64_t a = fold(product(a_, o.a_) + modulus - product(b_, o.b_));
        b_ = fold(product(a_, o.b_) + product(b_, o.a_));
        a_ = a;
        return *this;
    }
    /// Throws std::domain_error for o = 0.
    constexpr residue& operator/=(const residue& o) {
        const std::uint64_t norm = fold(product(o.a_, o.a_) + product(o.b_, o.b_));
        if (norm == 0) throw std::domain_error("residue: not invertible");
        residue inverse;
        inverse.a_ = power(norm, modulus - 2);
        inverse.b_ = product(fold(modulus - o.b_), inverse.a_);
        inverse.a_ = product(o.a_, inverse.a_);
        return *this *= inverse;
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
};

/// The residue of r; empty where p divides the denominator.
inline std::optional<residue> residue_of(const rational& r) {
    const integer p(residue::modulus);
    integer n = r.numerator() % p;
    if (n < 0) n += p;
    const integer d = r.denominator() % p;
    if (d == 0) return std::nullopt;
    return residue(static_cast<std::uint64_t>(n)) / residue(static_cast<std::uint64_t>(d));
}

/// The residue of sqrt(d), the product of those of the prime factors of d; empty where trial division up to 4096
/// does not find them.
inline std::optional<residue> residue_of_root(std::uint64_t d) {
    residue root(1);
    for (std::uint64_t q = 2; q < 4096 && q * q <= d; ++q)
        for (; d % q == 0; d /= q) root *= residue::root_of_prime(q);
    if (d >= 4096 * 4096) return std::nullopt;
    return d == 1 ? root : root * residue::root_of_prime(d);
}

inline std::optional<residue> residue_of(const quadratic& x) {
    auto sum = residue_of(x.rational_part());
    for (const auto& [factor, d] : x.surds()) {
        const auto f = residue_of(factor), root = residue_of_root(d);
        if (!sum || !f || !root) return std::nullopt;
        *sum += *f * *root;
    }
    return sum;
}

}  // namespace stagecraft::tableaux
