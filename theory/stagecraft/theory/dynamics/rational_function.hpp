// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <concepts>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/number_traits.hpp"
#include "stagecraft/tableaux/polynomial.hpp"
#include "stagecraft/tableaux/range.hpp"
#include "stagecraft/tableaux/sturm.hpp"

namespace stagecraft::theory {

using tableaux::polynomial;
using tableaux::rational;

/// A quotient of polynomials in one unknown over the rationals, in lowest terms with a monic denominator:
/// what a scalar right-hand side becomes when it is evaluated at the unknown itself. It remembers what was divided by:
/// where a divisor vanishes the expression has no value, though the quotient in lowest terms may have one.
class rational_function {
  public:
    rational_function() : bottom_(rational(1)) {}
    template <std::integral I>
    rational_function(I n) : rational_function(rational(n)) {}               // NOLINT: integers are functions
    rational_function(const rational& q) : top_(q), bottom_(rational(1)) {}  // NOLINT: so are rationals
    template <std::floating_point F>
    rational_function(F) = delete;
    /// top/bottom. Throws std::invalid_argument for bottom = 0.
    explicit rational_function(polynomial<rational> top, const polynomial<rational>& bottom = rational(1))
        : rational_function(std::move(top), bottom, {bottom}) {}
    /// Likewise, where the divisors on the way were these; the zeros of bottom are among theirs.
    rational_function(polynomial<rational> top, polynomial<rational> bottom,
                      const std::vector<polynomial<rational>>& divisors)
        : top_(std::move(top)), bottom_(std::move(bottom)) {
        if (bottom_.is_zero()) throw std::invalid_argument("rational_function: f divides by zero");
        if (bottom_.degree() > 0) {
            const auto common = gcd(top_, bottom_);
            if (common.degree() > 0) {
                top_ = top_ / common;
                bottom_ = bottom_ / common;
            }
        }
        const polynomial<rational> scale(1 / bottom_.leading());
        top_ *= scale;
        bottom_ *= scale;
        for (const auto& d : divisors)
            if (d.degree() > 0) remember(monic(d));
    }
    static rational_function x() { return rational_function(polynomial<rational>::x()); }

    const polynomial<rational>& numerator() const { return top_; }
    const polynomial<rational>& denominator() const { return bottom_; }
    /// What was divided by, monic, each once and not constant.
    const std::vector<polynomial<rational>>& divisors() const { return divisors_; }
    /// Value at x. Throws std::domain_error where a divisor vanishes.
    rational operator()(const rational& x) const {
        for (const auto& d : divisors_)
            if (d(x) == 0) throw std::domain_error("rational_function: f divides by zero at " + x.str());
        return top_(x) / bottom_(x);
    }

    rational_function operator-() const { return {-top_, bottom_, divisors_}; }
    friend rational_function operator+(const rational_function& a, const rational_function& b) {
        if (a.bottom_ == b.bottom_) return {a.top_ + b.top_, a.bottom_, both(a, b)};
        return {a.top_ * b.bottom_ + b.top_ * a.bottom_, a.bottom_ * b.bottom_, both(a, b)};
    }
    friend rational_function operator-(const rational_function& a, const rational_function& b) {
        return a + -b;
    }
    friend rational_function operator*(const rational_function& a, const rational_function& b) {
        return {a.top_ * b.top_, a.bottom_ * b.bottom_, both(a, b)};
    }
    friend rational_function operator/(const rational_function& a, const rational_function& b) {
        auto divisors = both(a, b);
        divisors.push_back(b.top_);
        return {a.top_ * b.bottom_, a.bottom_ * b.top_, divisors};
    }
    rational_function& operator+=(const rational_function& o) { return *this = *this + o; }
    rational_function& operator-=(const rational_function& o) { return *this = *this - o; }
    rational_function& operator*=(const rational_function& o) { return *this = *this * o; }
    rational_function& operator/=(const rational_function& o) { return *this = *this / o; }
    /// The same quotient in lowest terms.
    friend bool operator==(const rational_function& a, const rational_function& b) {
        return a.top_ == b.top_ && a.bottom_ == b.bottom_;
    }

  private:
    void remember(polynomial<rational> divisor) {
        if (std::find(divisors_.begin(), divisors_.end(), divisor) == divisors_.end())
            divisors_.push_back(std::move(divisor));
    }
    static std::vector<polynomial<rational>> both(const rational_function& a, const rational_function& b) {
        auto all = a.divisors_;
        all.insert(all.end(), b.divisors_.begin(), b.divisors_.end());
        return all;
    }

    polynomial<rational> top_, bottom_;
    std::vector<polynomial<rational>> divisors_;
};

/// Throws std::invalid_argument where r divides by something that has a real zero, also one that cancels.
inline void require_defined_on_line(const rational_function& r) {
    for (const auto& d : r.divisors())
        if (tableaux::sturm_chain<rational>(d).count() > 0)
            throw std::invalid_argument("f: divides through zero on the real line");
}

inline rational_function derivative(const rational_function& r) {
    const auto &p = r.numerator(), &q = r.denominator();
    return {derivative(p) * q - p * derivative(q), q * q, r.divisors()};
}

/// The supremum of a real function: it lies in [low, high], low = high where it is known exactly. It is
/// attained at `point`, or near it where that is not a rational number; `point` is missing where it is a
/// limit at infinity.
struct supremum {
    rational low, high;
    std::optional<rational> point;
};

/// A point where r exceeds `level`, or nothing: exact (Sturm). r without real poles.
inline std::optional<rational> point_above(const rational_function& r, const rational& level) {
    // r's denominator is monic without real roots, hence positive.
    return tableaux::negative_point(polynomial<rational>(level) * r.denominator() - r.numerator());
}

/// sup of r over the real line, exact where it is attained at a rational point or at infinity and else to
/// `width`; nothing where r is unbounded above. One Sturm chain of the numerator of r' and one for the proof.
/// Throws std::invalid_argument where r divides through zero.
inline std::optional<supremum> supremum_on_line(const rational_function& r,
                                                const rational& width = rational(1, 1LL << 40)) {
    require_defined_on_line(r);
    const auto &p = r.numerator(), &q = r.denominator();
    if (p.degree() <= 0 && q.degree() == 0) return supremum{p[0], p[0], rational(0)};
    if (p.degree() > q.degree() && (p.leading() > 0 || (p.degree() - q.degree()) % 2 != 0)) return {};
    std::optional<supremum> best;
    if (p.degree() == q.degree()) best = supremum{p.leading(), p.leading(), {}};
    if (p.degree() < q.degree()) best = supremum{0, 0, {}};
    const auto slope = derivative(p) * q - p * derivative(q);
    const auto simple = squarefree(slope);
    for (auto root : tableaux::isolate_real_roots(slope)) {
        root = refine(simple, root, width * width);
        const rational c = tableaux::simplest_between(root.low, root.high);
        const rational value = r(c);
        if (!best || value > best->low || (value == best->low && !best->point))
            best = supremum{value, value, c};
    }
    for (rational slack = 0; point_above(r, best->high); slack = slack == 0 ? width : 2 * slack)
        best->high = best->low + slack;
    // A rational value at an irrational point: nothing lies above it, and it is met.
    if (best->low == best->high) return best;
    const rational v = tableaux::simplest_between(best->low, best->high);
    if (!point_above(r, v) && tableaux::sturm_chain<rational>(polynomial<rational>(v) * q - p).count() > 0)
        best->low = best->high = v;
    return best;
}

}  // namespace stagecraft::theory

template <>
struct Eigen::NumTraits<stagecraft::theory::rational_function>
    : stagecraft::tableaux::number_traits<stagecraft::theory::rational_function> {};
