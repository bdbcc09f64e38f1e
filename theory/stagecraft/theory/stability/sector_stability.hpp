// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/theory/stability/a_stability.hpp"

namespace stagecraft::theory {

namespace detail {

/// p(-t e^{i alpha}) = x(t) + i sin(alpha) y(t), u = cos(alpha): real polynomials in t by the Chebyshev
/// polynomials, cos(k alpha) = T_k(u), sin(k alpha) = sin(alpha) U_{k-1}(u).
template <class K>
tableaux::axis_parts<K> on_ray(const polynomial<K>& p, const K& u) {
    std::vector<K> x;
    std::vector<K> y;
    K t_now(1), t_before = u;  // T_0, T_{-1}
    K u_now(0), u_before(-1);  // U_{-1}, U_{-2}
    for (int k = 0; k <= p.degree(); ++k) {
        const K a = k % 2 == 0 ? p[k] : K(0) - p[k];
        x.push_back(a * t_now);
        y.push_back(a * u_now);
        t_before = std::exchange(t_now, K(2) * u * t_now - t_before);
        u_before = std::exchange(u_now, K(2) * u * u_now - u_before);
    }
    return {polynomial<K>(std::move(x)), polynomial<K>(std::move(y))};
}

/// |Q|^2 - |P|^2 on the ray arg(-z) = alpha as a polynomial in |z|.
template <class K>
polynomial<K> ray_polynomial(const stability_function<K>& r, const K& u) {
    const auto p = on_ray(r.numerator, u);
    const auto q = on_ray(r.denominator, u);
    const polynomial<K> sine_squared(K(1) - u * u);
    return q.real * q.real - p.real * p.real +
           sine_squared * (q.imaginary * q.imaginary - p.imaginary * p.imaginary);
}

/// Roots (with multiplicity) of q with |arg(-z)| < alpha, cos(alpha) = u in (0, 1), none of them on the ray:
/// the argument of q grows along the ray by n alpha - pi N; its half-turns are a Cauchy index.
template <class K>
int roots_in_sector(const polynomial<K>& q, const K& u) {
    const auto [x, y] = on_ray(q, u);
    // Half-turns of e^{i k alpha} for k = 0..n, one sign change of cos(k alpha) each (alpha < pi/2).
    int turns = 0;
    int last = 1;
    K now(1), before = u;
    for (int k = 0; k <= q.degree(); ++k) {
        const int s = tableaux::sign_of(now);
        if (s != 0 && s != last) ++turns;
        if (s != 0) last = s;
        before = std::exchange(now, K(2) * u * now - before);
    }
    const tableaux::remainder_chain<K> chain(x, y);
    int roots = turns + chain.variations(K(0)) - chain.variations_at_infinity(1);
    // cos(n alpha) = 0: both arguments end at an odd multiple of pi/2, q's from above where y/x < 0
    if (x.degree() < q.degree() && tableaux::sign_of(x.leading()) != tableaux::sign_of(y.leading())) ++roots;
    return roots;
}

/// cos(alpha) of the largest stable sector, to about double precision where the search goes well: the
/// largest |R| on a ray by a scan with golden sections, bisection of the angle. A guess only.
template <class K>
double guessed_cosine(const stability_function<K>& r) {
    const auto in_double = [](const polynomial<K>& p) {
        std::vector<double> v;
        for (const K& a : p.coefficients()) v.push_back(a.template to<double>());
        return v;
    };
    const auto top = in_double(r.numerator);
    const auto bottom = in_double(r.denominator);
    const auto growth = [&](double log_modulus, double alpha) {
        const auto value = [z = -std::polar(std::exp(log_modulus), alpha)](const std::vector<double>& p) {
            std::complex<double> sum = 0;
            for (auto k = p.size(); k-- > 0;) sum = sum * z + p[k];
            return std::abs(sum);
        };
        return std::log(value(top)) - std::log(value(bottom));
    };
    const auto largest = [&](double alpha) {
        constexpr double from = -6, step = 0.1, golden = 0.6180339887498949;
        constexpr int points = 160;
        double found = -1;
        double before = growth(from - step, alpha), here = growth(from, alpha);
        for (int k = 1; k <= points; ++k) {
            const double after = growth(from + k * step, alpha);
            if (here >= before && here >= after) {
                double a = from + (k - 2) * step, b = from + k * step;
                for (int n = 0; n < 60; ++n) {
                    const double x = b - golden * (b - a), y = a + golden * (b - a);
                    (growth(x, alpha) > growth(y, alpha) ? b : a) =
                        growth(x, alpha) > growth(y, alpha) ? y : x;
                }
                found = std::max(found, growth((a + b) / 2, alpha));
            }
            before = std::exchange(here, after);
        }
        return found;
    };
    double low = 0, high = std::acos(0.0);
    for (int n = 0; n < 55; ++n) {
        const double middle = (low + high) / 2;
        (largest(middle) > 1e-15 ? high : low) = middle;
    }
    return std::cos(low);
}

}  // namespace detail

/// |R| <= 1 in the closed sector |arg(-z)| <= alpha, u = cos(alpha) in (0, 1) rational. Exact: no pole
/// inside, and |Q|^2 - |P|^2 >= 0 on the ray (maximum principle).
template <class K>
bool stable_in_sector(const stability_function<K>& r, const K& u) {
    if (r.numerator.degree() > r.denominator.degree()) return false;
    const auto e = detail::ray_polynomial(r, u);
    if (!tableaux::is_nonnegative_from_zero(e)) return false;
    return detail::roots_in_sector(r.denominator, u) == 0;
}

/// The largest alpha with A(alpha)-stability, as an enclosure of its cosine and of the angle in degrees.
template <class K>
struct sector {
    bool exists = false;  ///< stable for some alpha > 0
    K cosine_low{};       ///< A(alpha)-stable is refuted for this cosine unless it is 0 (A-stable)
    K cosine_high{};      ///< A(alpha)-stable is proved for this cosine
    double degrees_low = 0;
    double degrees_high = 0;
};

/// A(alpha)-stability (Hairer-Wanner II, section IV.3; lecture, Definition 2.21): the supremum of alpha by
/// bisection of cos(alpha) with an exact decision in every step, to 2^-bits in the cosine (48: alpha to 12
/// digits and more); a search in double precision only saves steps. A-stable functions report exactly 90
/// degrees. An angle with cosine above 1 - 2^-bits is reported as none.
template <class K>
sector<K> largest_sector(const stability_function<K>& r, int bits = 48) {
    sector<K> out;
    if (a_stable(r).is_proved()) return {true, K(0), K(0), 90, 90};
    if (r.numerator.degree() > r.denominator.degree() || a0_stable(r).is_refuted()) return out;
    const K resolution = detail::two_to_minus<K>(bits);
    K low(0);
    K high = K(1) - resolution;
    if (!stable_in_sector(r, high)) return out;
    out.exists = true;
    // Stability is monotone in the angle: bracket the guess, however good it is, then bisect.
    const auto scaled = static_cast<long long>(std::ldexp(detail::guessed_cosine(r), 52));
    K guess(scaled);
    guess = guess * detail::two_to_minus<K>(52);
    for (K step = resolution / K(4); low < guess + step && guess + step < high; step = step * K(16)) {
        (stable_in_sector<K>(r, guess + step) ? high : low) = guess + step;
    }
    for (K step = resolution / K(4); low < guess - step && guess - step < high; step = step * K(16)) {
        (stable_in_sector<K>(r, guess - step) ? high : low) = guess - step;
    }
    while (resolution < high - low) {
        const K middle = (low + high) / K(2);
        (stable_in_sector(r, middle) ? high : low) = middle;
    }
    using wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                               boost::multiprecision::et_off>;
    const auto degrees = [](const K& u) {
        return wide(180) * acos(u.template to<wide>()) / boost::math::constants::pi<wide>();
    };
    out.cosine_low = low;
    out.cosine_high = high;
    const double infinity = std::numeric_limits<double>::infinity();
    out.degrees_low = std::nextafter(static_cast<double>(degrees(high)), -infinity);
    out.degrees_high = std::nextafter(static_cast<double>(degrees(low)), infinity);
    return out;
}

/// A(alpha)-stable for the given cosine of alpha, 0 <= cosine <= 1 (0: A-stable, 1: the negative axis only).
/// Throws std::invalid_argument for any other cosine.
template <class K>
verdict a_alpha_stable(const stability_function<K>& r, const K& cosine) {
    if (cosine < K(0) || K(1) < cosine) throw std::invalid_argument("a_alpha_stable: cosine not in [0, 1]");
    if (cosine == K(0)) return a_stable(r);
    if (cosine == K(1)) return a0_stable(r);
    if (stable_in_sector(r, cosine)) return verdict::proved("no pole in the sector, |R| <= 1 on its ray");
    if (r.numerator.degree() > r.denominator.degree()) return verdict::refuted("R(inf) is infinite");
    if (const auto t = tableaux::negative_point_from_zero(detail::ray_polynomial(r, cosine))) {
        return verdict::refuted("|R| > 1 on the ray at |z| = " + t->str());
    }
    return verdict::refuted("a pole in the sector, root of " + to_string(r.denominator, "z"));
}

}  // namespace stagecraft::theory
