// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

#include "stagecraft/tableaux/number_traits.hpp"
#include "stagecraft/tableaux/range.hpp"

namespace stagecraft::theory {

using tableaux::exactly;

/// A closed interval [low, high] of doubles that contains every result of its operands: the number in which a
/// right-hand side is enclosed on a box. Ends are computed to nearest and moved outwards where that was not
/// exact (exact sums and products stay exact), so neither a rounding mode nor a compiler flag is needed.
/// Where a function is not defined or not bounded the result is the whole line: nothing is proved then.
/// The other enclosures of the house serve other ends: tableaux::ball is narrow at many digits but loses the
/// shape of a wide box, tableaux::range carries rational ends.
class interval {
  public:
    using exact_number = tableaux::rational;  ///< may stand beside intervals, and dual numbers of them

    interval() = default;
    template <std::integral I>
    interval(I n) : interval(tableaux::rational(n)) {}  // NOLINT: integers are numbers
    interval(int n) : low_(n), high_(n) {}              // NOLINT
    interval(double x) : interval(x, x) {}              // NOLINT: a double is the number it is
    /// All x with low <= x <= high. Throws std::invalid_argument where there is none.
    interval(double low, double high) : low_(low), high_(high) {
        if (!(low <= high)) throw std::invalid_argument("interval: low must not exceed high, nor be NaN");
    }
    /// The narrowest around q: a point where q is a double, else two neighbours.
    interval(const tableaux::rational& q) : low_(q.to<double>()), high_(low_) {  // NOLINT
        if (std::isinf(low_)) {
            (low_ > 0 ? low_ : high_) = std::copysign(std::numeric_limits<double>::max(), low_);
        } else if (const auto order = exactly(low_) <=> q; order < 0) {
            high_ = std::nextafter(high_, infinity);
        } else if (order > 0) {
            low_ = std::nextafter(low_, -infinity);
        }
    }
    static interval whole() { return {-infinity, infinity}; }

    double low() const { return low_; }
    double high() const { return high_; }
    double width() const { return high_ - low_; }
    double middle() const { return std::clamp(low_ + (high_ - low_) / 2, low_, high_); }
    /// The largest and the smallest |x|.
    double magnitude() const { return std::max(std::abs(low_), std::abs(high_)); }
    double mignitude() const { return contains(0.0) ? 0.0 : std::min(std::abs(low_), std::abs(high_)); }
    bool contains(double x) const { return low_ <= x && x <= high_; }
    bool contains(const interval& x) const { return low_ <= x.low_ && x.high_ <= high_; }
    bool inside(const interval& x) const { return x.low_ < low_ && high_ < x.high_; }
    bool bounded() const { return std::isfinite(low_) && std::isfinite(high_); }

    friend interval operator+(const interval& a, const interval& b) {
        return ends(sum(a.low_, b.low_, -1), sum(a.high_, b.high_, 1));
    }
    friend interval operator-(const interval& a) { return {-a.high_, -a.low_}; }
    friend interval operator-(const interval& a, const interval& b) { return a + -b; }
    friend interval operator*(const interval& a, const interval& b) {
        const double l[]{product(a.low_, b.low_, -1), product(a.low_, b.high_, -1),
                         product(a.high_, b.low_, -1), product(a.high_, b.high_, -1)};
        const double h[]{product(a.low_, b.low_, 1), product(a.low_, b.high_, 1), product(a.high_, b.low_, 1),
                         product(a.high_, b.high_, 1)};
        return ends(std::min({l[0], l[1], l[2], l[3]}), std::max({h[0], h[1], h[2], h[3]}));
    }
    /// The whole line where b contains 0.
    friend interval operator/(const interval& a, const interval& b) {
        if (b.contains(0.0)) return whole();
        const double l[]{quotient(a.low_, b.low_, -1), quotient(a.low_, b.high_, -1),
                         quotient(a.high_, b.low_, -1), quotient(a.high_, b.high_, -1)};
        const double h[]{quotient(a.low_, b.low_, 1), quotient(a.low_, b.high_, 1),
                         quotient(a.high_, b.low_, 1), quotient(a.high_, b.high_, 1)};
        return ends(std::min({l[0], l[1], l[2], l[3]}), std::max({h[0], h[1], h[2], h[3]}));
    }
    interval& operator+=(const interval& b) { return *this = *this + b; }
    interval& operator-=(const interval& b) { return *this = *this - b; }
    interval& operator*=(const interval& b) { return *this = *this * b; }
    interval& operator/=(const interval& b) { return *this = *this / b; }
    friend bool operator==(const interval&, const interval&) = default;

    friend interval hull(const interval& a, const interval& b) {
        return {std::min(a.low_, b.low_), std::max(a.high_, b.high_)};
    }
    friend bool disjoint(const interval& a, const interval& b) {
        return a.high_ < b.low_ || b.high_ < a.low_;
    }
    /// Their common part. Throws std::invalid_argument where they have none.
    friend interval intersection(const interval& a, const interval& b) {
        return {std::max(a.low_, b.low_), std::min(a.high_, b.high_)};
    }
    friend interval abs(const interval& a) { return {a.mignitude(), a.magnitude()}; }
    friend interval square(const interval& a) {
        const double l = a.mignitude(), h = a.magnitude();
        return ends(std::max(0.0, product(l, l, -1)), product(h, h, 1));
    }
    /// The whole line where a reaches below 0.
    friend interval sqrt(const interval& a) {
        if (!(a.low_ >= 0)) return whole();
        const auto root = [](double x, int side) {
            const double r = std::sqrt(x);
            const bool exact = x == 0 || (x > 1e-290 && std::fma(r, r, -x) == 0);
            return exact ? r : towards(r, side);
        };
        return ends(root(a.low_, -1), root(a.high_, 1));
    }

    /// The neighbours of x, or doubles a little further off.
    static double below(double x) {
        if (x == infinity) return std::numeric_limits<double>::max();
        return x - (std::abs(x) * 0x1p-52 + 0x1p-1074);
    }
    static double above(double x) { return -below(-x); }

  private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    static interval ends(double low, double high) { return low <= high ? interval(low, high) : whole(); }
    static double towards(double x, int side) { return side < 0 ? below(x) : above(x); }
    // fma gives the error of a rounded result as long as that does not underflow: above 1e-290.
    static double sum(double a, double b, int side) {
        const double s = a + b, rest = s - a;
        if (!std::isfinite(s)) return std::isfinite(a) && std::isfinite(b) ? towards(s, side) : s;
        return (a - (s - rest)) + (b - rest) == 0 ? s : towards(s, side);  // Knuth's error of the sum
    }
    // 0 times an infinite end is 0: an infinite end stands for numbers that are finite.
    static double product(double a, double b, int side) {
        if (a == 0 || b == 0) return 0;
        const double p = a * b;
        if (std::isinf(p)) return std::isinf(a) || std::isinf(b) ? p : towards(p, side);
        return std::abs(p) > 1e-290 && std::fma(a, b, -p) == 0 ? p : towards(p, side);
    }
    static double quotient(double a, double b, int side) {
        if (a == 0) return 0;
        const double q = a / b;
        if (std::isinf(q)) return std::isinf(a) ? q : towards(q, side);
        return std::abs(q) > 1e-290 && std::abs(a) > 1e-290 && std::isfinite(b) && std::fma(q, b, -a) == 0
                   ? q
                   : towards(q, side);
    }

    double low_ = 0, high_ = 0;
};

namespace detail {

/// 1 + r/first (1 + r/(first + 1) (1 + ...)), the first `terms` quotients.
inline interval nested_series(const interval& r, int terms) {
    interval p = 1;
    for (int k = terms; k > 0; --k) p = 1 + r / k * p;
    return p;
}

/// e^x for one double, by x = k ln 2 + r, |r| < 0.35, and Taylor's polynomial of degree 16, whose remainder
/// is below |r|^17/17! e^|r| < 1e-22 (high part of ln 2 with 32 bits, so that k times it is exact).
inline interval exp_at(double x) {
    constexpr double largest = std::numeric_limits<double>::max();
    if (x > 709) return {x > 710 ? largest : 0x1.0p1022, std::numeric_limits<double>::infinity()};
    if (x < -708) return {0.0, 0x1p-1021};
    const double k = std::nearbyint(x / 0.6931471805599453);
    const double fine = 1.90821492927058770002e-10;
    const interval ln2_low(interval::below(fine), interval::above(fine));
    const interval r =
        interval(x) - interval(k) * interval(6.93147180369123816490e-01) - interval(k) * ln2_low;
    const interval e = nested_series(r, 16) + interval(-1e-22, 1e-22);
    return e * interval(std::ldexp(1.0, static_cast<int>(k)));
}

/// (sin r, cos r) for |r| < 0.8 by Taylor's polynomials; the remainders are below r^21/21! < 1e-21.
inline std::pair<interval, interval> sine_and_cosine_near_0(const interval& r) {
    const interval q = square(r);
    interval s = 1, c = 1;
    for (int k = 9; k > 0; --k) {
        s = 1 - q / (2 * k * (2 * k + 1)) * s;
        c = 1 - q / (2 * k * (2 * k - 1)) * c;
    }
    const interval rest(-1e-17, 1e-17);
    return {r * s + rest, c + rest};
}

/// sin(x + quarters pi/2) for one double, |x| < 1e6.
inline interval sine_at(double x, int quarters) {
    const double k = std::nearbyint(x / 1.5707963267948966);
    const double fine = 6.07710050650619224932e-11;  // pi/2 minus its first 33 bits
    const interval low(interval::below(fine), interval::above(fine));
    const interval r = interval(x) - interval(k) * interval(1.57079632673412561417e+00) - interval(k) * low;
    const auto [s, c] = sine_and_cosine_near_0(r);
    const int turn = ((static_cast<int>(k) + quarters) % 4 + 4) % 4;
    return turn == 0 ? s : turn == 1 ? c : turn == 2 ? -s : -c;
}

inline interval sine(const interval& a, int quarters) {
    constexpr double largest = 1e6, half_pi = 1.5707963267948966;
    if (!(a.magnitude() < largest) || a.width() > 6.3) return {-1.0, 1.0};
    interval s = hull(sine_at(a.low(), quarters), sine_at(a.high(), quarters));
    // Where an extremum may lie inside it is taken to: sin is 1 at odd quarters 1, 5, ..., -1 at 3, 7, ...
    const auto first = static_cast<long>(std::ceil(a.low() / half_pi - 1e-6));
    const auto last = static_cast<long>(std::floor(a.high() / half_pi + 1e-6));
    for (long k = first; k <= last; ++k) {
        const long turn = ((k + quarters) % 4 + 4) % 4;
        if (turn == 1) s = hull(s, interval(1));
        if (turn == 3) s = hull(s, interval(-1));
    }
    return {std::max(s.low(), -1.0), std::min(s.high(), 1.0)};
}

/// log x for one double x > 0: with y near it, log x = y + log(1 + u), u = x e^-y - 1 tiny, and
/// u/(1 + u) <= log(1 + u) <= u.
inline interval log_at(double x) {
    if (x < 1e-300) return interval(interval::whole().low(), -690);  // not looked at closer
    const interval y(std::log(x));
    const interval u = interval(x) * exp_at(-y.low()) - 1;
    return y + hull(u / (1 + u), u);
}

}  // namespace detail

/// e^x, proved (no trust in the mathematical library).
inline interval exp(const interval& a) {
    return {detail::exp_at(a.low()).low(), detail::exp_at(a.high()).high()};
}
inline interval sin(const interval& a) { return detail::sine(a, 0); }
inline interval cos(const interval& a) { return detail::sine(a, 1); }
/// Natural logarithm; the whole line where a reaches to 0 or below.
inline interval log(const interval& a) {
    if (!(a.low() > 0) || !a.bounded()) return interval::whole();
    return {detail::log_at(a.low()).low(), detail::log_at(a.high()).high()};
}

/// The shortest decimal that is read as x again: what is proved of x is not rounded away.
template <std::floating_point Number>
std::string shortest(Number x) {
    char text[32];
    if constexpr (requires { std::to_chars(text, text, x).ptr; }) {
        return {text, std::to_chars(text, text + sizeof text, x).ptr};
    } else {  // libc++ before 14
        int digits = 1;
        do {
            std::snprintf(text, sizeof text, "%.*g", digits, x);
        } while (std::strtod(text, nullptr) != x && ++digits <= 17);
        return text;
    }
}
/// "[low, high]".
inline std::string to_string(const interval& a) {
    return "[" + shortest(a.low()) + ", " + shortest(a.high()) + "]";
}

}  // namespace stagecraft::theory

template <>
struct Eigen::NumTraits<stagecraft::theory::interval>
    : stagecraft::tableaux::number_traits<stagecraft::theory::interval> {};
