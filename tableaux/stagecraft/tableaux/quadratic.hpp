// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <map>
#include <numeric>
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

/// sqrt(d) sqrt(e) = root sqrt(core) for squarefree d and e. Throws mixed_surds where core exceeds
/// largest_radicand.
inline square_split product_of_surds(std::uint64_t d, std::uint64_t e) {
    const std::uint64_t g = std::gcd(d, e);
    if (d / g > largest_radicand / (e / g)) throw mixed_surds("quadratic: too large a radicand");
    return {g, (d / g) * (e / g)};
}

/// Whether all these squarefree radicands > 1, increasing, lie in one field Q(sqrt d, sqrt e) that `quadratic` can
/// hold: at most two, or three of which the last is the product of the others but for squares.
inline bool in_one_field(const std::vector<std::uint64_t>& radicands) {
    if (radicands.size() < 2) return true;
    if (radicands.size() > 3) return false;
    const std::uint64_t g = std::gcd(radicands[0], radicands[1]);
    if (radicands[0] / g > largest_radicand / (radicands[1] / g)) return false;
    return radicands.size() == 2 || product_of_surds(radicands[0], radicands[1]).core == radicands[2];
}

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
    const rational& surd_part() const { return b_; }  ///< the factor of the surd with the least radicand
    /// The least squarefree d, or 0 for a rational number.
    std::uint64_t radicand() const { return d_; }
    bool is_rational() const { return d_ == 0; }
    bool has_one_surd() const { return d_ != 0 && more_.empty(); }
    /// All of them, radicands increasing.
    std::vector<surd> surds() const {
        std::vector<surd> all;
        if (d_ != 0) all.push_back({b_, d_});
        all.insert(all.end(), more_.begin(), more_.end());
        return all;
    }
    /// The least common denominator of its rational components.
    integer denominator() const {
        integer n = lcm(a_.denominator(), b_.denominator());
        for (const surd& x : more_) n = lcm(n, x.factor.denominator());
        return n;
    }

    /// The sign of the surd with the second radicand changed (with a single one, of that), and of the third with it.
    quadratic conjugate() const {
        if (more_.empty()) return {a_, -b_, d_, {}};
        quadratic x = *this;
        for (surd& y : x.more_) y.factor = -y.factor;
        return x;
    }
    /// x times its conjugate: rational for one surd, in Q(sqrt d) for two.
    quadratic norm() const {
        if (more_.empty()) return a_ * a_ - rational(d_) * b_ * b_;
        return *this * conjugate();
    }

    quadratic operator-() const {
        quadratic x{-a_, -b_, d_, more_};
        for (surd& y : x.more_) y.factor = -y.factor;
        return x;
    }
    quadratic& operator+=(const quadratic& o) {
        if (!one_field(o)) return *this = from_terms(sum(terms(), o.terms()));
        a_ += o.a_;
        if (o.d_ == 0) return *this;
        b_ += o.b_;
        d_ = b_ == 0 ? 0 : o.d_;
        return *this;
    }
    quadratic& operator-=(const quadratic& o) {
        if (!one_field(o)) return *this += -o;
        a_ -= o.a_;
        if (o.d_ == 0) return *this;
        b_ -= o.b_;
        d_ = b_ == 0 ? 0 : o.d_;
        return *this;
    }
    quadratic& operator*=(const quadratic& o) {
        if (!one_field(o)) return *this = from_terms(product(terms(), o.terms()));
        if (o.d_ == 0) {  // rational numbers pay for rational arithmetic only
            a_ *= o.a_;
            if (d_ != 0) b_ *= o.a_;
            d_ = b_ == 0 ? 0 : d_;
            return *this;
        }
        rational a = a_ * o.a_ + (d_ == 0 ? rational(0) : rational(d_) * b_ * o.b_);
        b_ = a_ * o.b_ + b_ * o.a_;
        a_ = std::move(a);
        d_ = b_ == 0 ? 0 : o.d_;
        return *this;
    }
    /// Throws std::domain_error for o = 0.
    quadratic& operator/=(const quadratic& o) {
        if (o.is_rational()) {
            a_ /= o.a_;
            if (d_ != 0) b_ /= o.a_;
            for (surd& x : more_) x.factor /= o.a_;
            return *this;
        }
        const quadratic n = o.norm();
        *this *= o.conjugate();
        return *this /= n;
    }
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
    std::string str() const {
        std::string s = a_ == 0 && d_ != 0 ? "" : a_.str();
        for (const surd& x : surds()) {
            const std::string root = "sqrt(" + std::to_string(x.radicand) + ")";
            const rational size = abs(x.factor);
            if (x.factor < 0)
                s += "-";
            else if (!s.empty())
                s += "+";
            s += size == 1 ? root : size.str() + "*" + root;
        }
        return s;
    }
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

    bool one_field(const quadratic& o) const {
        return more_.empty() && o.more_.empty() && (d_ == 0 || o.d_ == 0 || d_ == o.d_);
    }
    components terms() const {
        components all{{1, a_}};
        for (const surd& x : surds()) all[x.radicand] = x.factor;
        return all;
    }
    static components sum(components x, const components& y) {
        for (const auto& [radicand, factor] : y) x[radicand] += factor;
        return x;
    }
    static components product(const components& x, const components& y) {
        components all;
        for (const auto& [d, p] : x)
            for (const auto& [e, q] : y) {
                const auto [root, core] = product_of_surds(d, e);
                all[core] += rational(root) * p * q;
            }
        return all;
    }
    static quadratic from_terms(const components& all) {
        quadratic x;
        std::vector<std::uint64_t> radicands;
        for (const auto& [radicand, factor] : all) {
            if (factor == 0) continue;
            if (radicand == 1) {
                x.a_ = factor;
                continue;
            }
            radicands.push_back(radicand);
            if (x.d_ == 0)
                x.b_ = factor, x.d_ = radicand;
            else
                x.more_.push_back({factor, radicand});
        }
        if (!in_one_field(radicands)) throw mixed_surds("quadratic: three independent surds meet");
        return x;
    }
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

inline quadratic::step_of_tower quadratic::tower() const {
    if (more_.empty()) return {a_, b_, d_};
    const auto [factor, e] = more_.front();
    quadratic v = factor;
    if (more_.size() == 2)  // sqrt(d) sqrt(e) = root sqrt(core)
        v += quadratic(0, more_.back().factor / rational(product_of_surds(d_, e).root), d_);
    return {{a_, b_, d_, {}}, std::move(v), e};
}

template <class Real>
Real quadratic::to() const {
    using std::sqrt;
    if (is_rational()) return a_.to<Real>();
    const auto [u, v, d] = tower();
    const Real left = u.to<Real>(), right = v.to<Real>() * sqrt(static_cast<Real>(d));
    if (u.sign_() * v.sign_() >= 0) return left + right;
    return norm().to<Real>() / (left - right);
}

inline int quadratic::sign_() const {
    if (is_rational()) return stagecraft::tableaux::sign(a_);
    const auto [u, v, d] = tower();
    const int su = u.sign_(), sv = v.sign_();
    if (su == 0 || sv == 0 || su == sv) return su != 0 ? su : sv;
    return su * norm().sign_();  // |u| > |v| sqrt(d) exactly when the norm is positive
}

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

/// sqrt(x) where it is a sum of surds: for a rational x as above, and for x = a + b sqrt(d) whose norm is a
/// square n^2, when it is sqrt((a + n)/2) + sqrt((a - n)/2) or the difference (denesting). Empty otherwise.
inline std::optional<quadratic> exact_sqrt(const quadratic& x) {
    if (x.is_rational()) return exact_sqrt(x.rational_part());
    if (!x.has_one_surd() || sign(x) < 0) return std::nullopt;
    const auto n = exact_sqrt(x.norm().rational_part());
    if (!n || !n->is_rational()) return std::nullopt;
    const auto p = exact_sqrt((x.rational_part() + n->rational_part()) / rational(2));
    const auto q = exact_sqrt((x.rational_part() - n->rational_part()) / rational(2));
    if (!p || !q) return std::nullopt;
    return x.surd_part() > 0 ? *p + *q : *p - *q;
}

}  // namespace stagecraft::tableaux

template <>
struct Eigen::NumTraits<stagecraft::tableaux::quadratic>
    : stagecraft::tableaux::number_traits<stagecraft::tableaux::quadratic> {};
