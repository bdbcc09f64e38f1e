// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <stagecraft/tableaux/number_traits.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stdexcept>
#include <string>
#include <utility>

namespace stagecraft::tableaux {

/// Thrown by arithmetic between elements of two different fields Q(sqrt d1), Q(sqrt d2): the result has no
/// place in a quadratic field, and a caller that meets it must turn to enclosures.
struct mixed_surds : std::domain_error {
    using std::domain_error::domain_error;
};

/// n = root^2 * core with core squarefree.
struct square_split {
    std::uint64_t root;
    std::uint64_t core;
};

/// Largest radicand whose squarefree part is looked for; beyond it trial division becomes noticeable.
inline constexpr std::uint64_t largest_radicand = std::uint64_t{1} << 48;

/// The squarefree part of n, 1 <= n <= largest_radicand, by trial division up to the cube root: what is left
/// then has at most two prime factors, so it is a square or squarefree. At most 2^16 divisions.
/// Throws std::invalid_argument for n = 0 and std::overflow_error beyond the bound.
inline square_split split_square(std::uint64_t n) {
    if (n == 0) throw std::invalid_argument("split_square: n must be positive");
    if (n > largest_radicand) throw std::overflow_error("split_square: n exceeds 2^48");
    square_split s{1, 1};
    for (std::uint64_t p = 2; p * p * p <= n; ++p) {
        for (; n % (p * p) == 0; n /= p * p) s.root *= p;
        if (n % p == 0) {
            s.core *= p;
            n /= p;
        }
    }
    const integer r = sqrt(integer(n));
    if (r * r == n)
        s.root *= static_cast<std::uint64_t>(r);
    else
        s.core *= n;
    return s;
}

/// An element a + b sqrt(d) of the real quadratic field Q(sqrt d), d squarefree and known at run time: the
/// field of Gauss-2, Gauss-3, Radau IIA-3, Crouzeix' SDIRK and other tableaux with one surd. A rational (b =
/// 0, stored with d = 0) belongs to every such field and adapts to its partner; mixing two surds throws
/// mixed_surds. Always canonical, so == compares components; ordered by exact sign. No float converts to it.
class quadratic {
  public:
    quadratic() = default;
    template <std::integral I>
    quadratic(I n) : a_(n) {}                    // NOLINT: integers are elements
    quadratic(rational a) : a_(std::move(a)) {}  // NOLINT: so are rationals
    /// a + b sqrt(d) for any d >= 0; square factors of d move into b.
    /// Throws std::overflow_error when d exceeds largest_radicand.
    quadratic(rational a, rational b, std::uint64_t d) : a_(std::move(a)) {
        if (b == 0 || d == 0) return;
        const auto [root, core] = split_square(d);
        b *= rational(root);
        if (core == 1) {
            a_ += b;
        } else {
            b_ = std::move(b);
            d_ = core;
        }
    }
    template <std::floating_point F>
    quadratic(F) = delete;

    const rational& rational_part() const { return a_; }
    const rational& surd_part() const { return b_; }
    /// The squarefree d, or 0 for a rational number.
    std::uint64_t radicand() const { return d_; }
    bool is_rational() const { return d_ == 0; }
    /// The least common denominator of a and b.
    integer denominator() const { return lcm(a_.denominator(), b_.denominator()); }

    /// a - b sqrt(d).
    quadratic conjugate() const { return {a_, -b_, d_, canonical{}}; }
    /// a^2 - d b^2, the field norm.
    rational norm() const { return a_ * a_ - rational(d_) * b_ * b_; }

    quadratic operator-() const { return {-a_, -b_, d_, canonical{}}; }
    quadratic& operator+=(const quadratic& o) {
        const std::uint64_t d = common(o);
        a_ += o.a_;
        if (o.d_ == 0) return *this;
        b_ += o.b_;
        d_ = b_ == 0 ? 0 : d;
        return *this;
    }
    quadratic& operator-=(const quadratic& o) {
        const std::uint64_t d = common(o);
        a_ -= o.a_;
        if (o.d_ == 0) return *this;
        b_ -= o.b_;
        d_ = b_ == 0 ? 0 : d;
        return *this;
    }
    quadratic& operator*=(const quadratic& o) {
        const std::uint64_t d = common(o);
        if (o.d_ == 0) {  // rational numbers pay for rational arithmetic only
            a_ *= o.a_;
            if (d_ != 0) b_ *= o.a_;
            d_ = b_ == 0 ? 0 : d_;
            return *this;
        }
        rational a = a_ * o.a_ + rational(d) * b_ * o.b_;
        b_ = a_ * o.b_ + b_ * o.a_;
        a_ = std::move(a);
        d_ = b_ == 0 ? 0 : d;
        return *this;
    }
    /// Throws std::domain_error for o = 0.
    quadratic& operator/=(const quadratic& o) {
        if (o.is_rational()) {
            a_ /= o.a_;
            if (d_ != 0) b_ /= o.a_;
            return *this;
        }
        const rational n = o.norm();
        *this *= o.conjugate();
        return *this /= quadratic(n);
    }
    friend quadratic operator+(quadratic a, const quadratic& b) { return a += b; }
    friend quadratic operator-(quadratic a, const quadratic& b) { return a -= b; }
    friend quadratic operator*(quadratic a, const quadratic& b) { return a *= b; }
    friend quadratic operator/(quadratic a, const quadratic& b) { return a /= b; }
    friend bool operator==(const quadratic&, const quadratic&) = default;
    /// Order of the real numbers, exact. Throws mixed_surds for two different surds.
    friend std::strong_ordering operator<=>(const quadratic& a, const quadratic& b) {
        if (a.d_ == 0 && b.d_ == 0) return a.a_ <=> b.a_;
        return (a - b).sign_() <=> 0;
    }
    friend int sign(const quadratic& x) { return x.sign_(); }
    friend quadratic abs(const quadratic& x) { return x.sign_() < 0 ? -x : x; }

    /// "a+b*sqrt(d)" without empty parts: "1/2-1/6*sqrt(3)", "-sqrt(5)", "2/3". The tableau reader reads it.
    std::string str() const {
        if (is_rational()) return a_.str();
        const std::string surd = "sqrt(" + std::to_string(d_) + ")";
        const rational size = abs(b_);
        std::string s = a_ == 0 ? "" : a_.str();
        if (b_ < 0)
            s += "-";
        else if (!s.empty())
            s += "+";
        return s + (size == 1 ? surd : size.str() + "*" + surd);
    }
    template <class Traits>
    friend std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out,
                                                        const quadratic& x) {
        out << x.str();
        return out;
    }

    /// Value in a floating type, free of cancellation: with a and b sqrt(d) of opposite signs it is taken as
    /// norm / conjugate. A few units in the last place.
    template <class Real>
    Real to() const {
        using std::sqrt;
        if (is_rational()) return a_.to<Real>();
        const Real root = sqrt(static_cast<Real>(d_));
        const bool opposite = stagecraft::tableaux::sign(a_) * stagecraft::tableaux::sign(b_) < 0;
        if (!opposite) return a_.to<Real>() + b_.to<Real>() * root;
        return norm().to<Real>() / (a_.to<Real>() - b_.to<Real>() * root);
    }

  private:
    struct canonical {};
    quadratic(rational a, rational b, std::uint64_t d, canonical)
        : a_(std::move(a)), b_(std::move(b)), d_(d) {}

    std::uint64_t common(const quadratic& o) const {
        if (d_ != 0 && o.d_ != 0 && d_ != o.d_)
            throw mixed_surds("quadratic: sqrt(" + std::to_string(d_) + ") meets sqrt(" +
                              std::to_string(o.d_) + ")");
        return d_ != 0 ? d_ : o.d_;
    }
    int sign_() const {
        const int sa = stagecraft::tableaux::sign(a_);
        const int sb = stagecraft::tableaux::sign(b_);
        if (sa == 0 || sb == 0 || sa == sb) return sa != 0 ? sa : sb;
        return sa *
               stagecraft::tableaux::sign(norm());  // |a| > |b| sqrt(d) exactly when the norm is positive
    }

    rational a_;
    rational b_;
    std::uint64_t d_ = 0;
};

/// sqrt(r) as an element of a quadratic field; empty for r < 0 and when the radicand exceeds
/// largest_radicand.
inline std::optional<quadratic> exact_sqrt(const rational& r) {
    if (r < 0) return std::nullopt;
    const integer p = r.numerator();
    const integer q = r.denominator();
    const integer root_p = sqrt(p);
    const integer root_q = sqrt(q);
    if (root_p * root_p == p && root_q * root_q == q) return quadratic(rational(root_p, root_q));
    const integer n = p * q;  // sqrt(p/q) = sqrt(pq)/q
    if (n > largest_radicand) return std::nullopt;
    return quadratic(0, rational(integer(1), q), static_cast<std::uint64_t>(n));
}

/// sqrt(x) when it lies in a quadratic field: for a rational x as above, and for x = a + b sqrt(d) within
/// Q(sqrt d) itself (denesting: the norm must be a square n^2 and (a +- n)/2 too). Empty otherwise.
inline std::optional<quadratic> exact_sqrt(const quadratic& x) {
    if (x.is_rational()) return exact_sqrt(x.rational_part());
    if (sign(x) < 0) return std::nullopt;
    const auto n = exact_sqrt(x.norm());
    if (!n || !n->is_rational()) return std::nullopt;
    for (const rational& root : {n->rational_part(), -n->rational_part()}) {
        const auto u = exact_sqrt((x.rational_part() + root) / rational(2));
        if (!u || !u->is_rational() || *u == 0) continue;
        const quadratic y(u->rational_part(), x.surd_part() / (rational(2) * u->rational_part()),
                          x.radicand());
        return abs(y);
    }
    return std::nullopt;
}

}  // namespace stagecraft::tableaux

template <>
struct Eigen::NumTraits<stagecraft::tableaux::quadratic>
    : stagecraft::tableaux::number_traits<stagecraft::tableaux::quadratic> {};
