// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <map>
#include <optional>
#include <stagecraft/tableaux/number_traits.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace stagecraft::tableaux {

/// Thrown by arithmetic whose result needs a third surd, independent of two others: it has no place in a
/// `quadratic`, and a caller that meets it must turn to enclosures.
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
square_split split_square(std::uint64_t n);

/// sqrt(d) sqrt(e) = root sqrt(core) for squarefree d and e. Throws mixed_surds where core exceeds
/// largest_radicand.
square_split product_of_surds(std::uint64_t d, std::uint64_t e);

/// Whether all these squarefree radicands > 1, increasing, lie in one field Q(sqrt d, sqrt e) that `quadratic` can
/// hold: at most two, or three of which the last is the product of the others but for squares.
bool in_one_field(const std::vector<std::uint64_t>& radicands);

/// An element a + b sqrt(d) of the real quadratic field Q(sqrt d), d squarefree and known at run time: the
/// field of Gauss-2, Gauss-3, Radau IIA-3, Crouzeix' SDIRK and other tableaux with one surd; or of a field
/// Q(sqrt d, sqrt e) with the basis 1, sqrt(d), sqrt(e), sqrt(d e), which two surds that meet generate. A rational (b =
/// 0, stored with d = 0) belongs to every such field and adapts to its partner; a third surd throws
/// mixed_surds. Always canonical, so == compares components (square roots of different squarefree numbers are
/// linearly independent over Q); ordered by exact sign. No float converts to it.
class quadratic {
  public:
    /// factor * sqrt(radicand), the radicand squarefree.
    struct surd {
        rational factor;
        std::uint64_t radicand;
        friend bool operator==(const surd&, const surd&) = default;
    };

    quadratic() = default;
    template <std::integral I>
    quadratic(I n) : a_(n) {}                    // NOLINT: integers are elements
    quadratic(rational a) : a_(std::move(a)) {}  // NOLINT: so are rationals
    /// a + b sqrt(d) for any d >= 0; square factors of d move into b.
    /// Throws std::overflow_error when d exceeds largest_radicand.
    quadratic(rational a, rational b, std::uint64_t d);
    template <std::floating_point F>
    quadratic(F) = delete;

    const rational& rational_part() const { return a_; }
    const rational& surd_part() const { return b_; }  ///< the factor of the surd with the least radicand
    /// The least squarefree d, or 0 for a rational number.
    std::uint64_t radicand() const { return d_; }
    bool is_rational() const { return d_ == 0; }
    bool has_one_surd() const { return d_ != 0 && more_.empty(); }
    /// All of them, radicands increasing.
    std::vector<surd> surds() const;
    /// The least common denominator of its rational components.
    integer denominator() const;

    /// The sign of the surd with the second radicand changed (with a single one, of that), and of the third with it.
    quadratic conjugate() const;
    /// x times its conjugate: rational for one surd, in Q(sqrt d) for two.
    quadratic norm() const;

    quadratic operator-() const;
    quadratic& operator+=(const quadratic& o);
    quadratic& operator-=(const quadratic& o);
    quadratic& operator*=(const quadratic& o);
    /// Throws std::domain_error for o = 0.
    quadratic& operator/=(const quadratic& o);
    friend quadratic operator+(quadratic a, const quadratic& b) { return a += b; }
    friend quadratic operator-(quadratic a, const quadratic& b) { return a -= b; }
    friend quadratic operator*(quadratic a, const quadratic& b) { return a *= b; }
    friend quadratic operator/(quadratic a, const quadratic& b) { return a /= b; }
    friend bool operator==(const quadratic&, const quadratic&) = default;
    /// Order of the real numbers, exact. Throws mixed_surds for more than two independent surds.
    friend std::strong_ordering operator<=>(const quadratic& a, const quadratic& b) {
        if (a.d_ == 0 && b.d_ == 0) return a.a_ <=> b.a_;
        return (a - b).sign_() <=> 0;
    }
    friend int sign(const quadratic& x) { return x.sign_(); }
    friend quadratic abs(const quadratic& x) { return x.sign_() < 0 ? -x : x; }

    /// "a+b*sqrt(d)" without empty parts: "1/2-1/6*sqrt(3)", "-sqrt(5)", "2/3". The tableau reader reads it.
    std::string str() const;
    template <class Traits>
    friend std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out,
                                                        const quadratic& x) {
        out << x.str();
        return out;
    }

    /// Value in a floating type, free of cancellation: with u and v sqrt(d) of opposite signs it is taken as
    /// norm / conjugate. A few units in the last place.
    template <class Real>
    Real to() const;

  private:
    using components = std::map<std::uint64_t, rational>;  // by radicand, 1 for the rational part

    quadratic(rational a, rational b, std::uint64_t d, std::vector<surd> more)
        : a_(std::move(a)), b_(std::move(b)), d_(d), more_(std::move(more)) {}

    bool one_field(const quadratic& o) const;
    components terms() const;
    static components sum(components x, const components& y);
    static components product(const components& x, const components& y);
    static quadratic from_terms(const components& all);
    struct step_of_tower;
    /// x = u + v sqrt(d): u and v rational for one surd; u and v in Q(sqrt d1) and d = d2 for two.
    step_of_tower tower() const;
    int sign_() const;

    rational a_;
    rational b_;
    std::uint64_t d_ = 0;
    std::vector<surd> more_;  // those with larger radicands: one or two, or none in a quadratic field
};

struct quadratic::step_of_tower {
    quadratic u, v;
    std::uint64_t d;
};

template <class Real>
Real quadratic::to() const {
    using std::sqrt;
    if (is_rational()) return a_.to<Real>();
    const auto [u, v, d] = tower();
    const Real left = u.to<Real>(), right = v.to<Real>() * sqrt(static_cast<Real>(d));
    if (u.sign_() * v.sign_() >= 0) return left + right;
    return norm().to<Real>() / (left - right);
}

/// sqrt(r) as an element of a quadratic field; empty for r < 0 and when the radicand exceeds
/// largest_radicand.
std::optional<quadratic> exact_sqrt(const rational& r);

/// sqrt(x) where it is a sum of surds: for a rational x as above, and for x = a + b sqrt(d) whose norm is a
/// square n^2, when it is sqrt((a + n)/2) + sqrt((a - n)/2) or the difference (denesting). Empty otherwise.
std::optional<quadratic> exact_sqrt(const quadratic& x);

}  // namespace stagecraft::tableaux

template <>
struct Eigen::NumTraits<stagecraft::tableaux::quadratic>
    : stagecraft::tableaux::number_traits<stagecraft::tableaux::quadratic> {};

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/quadratic-inl.hpp"
#endif
