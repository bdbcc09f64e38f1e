// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/theory/plot/curve.hpp>
#include <stagecraft/theory/stability/stability_function.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace stagecraft::theory::plot {

/// Nearest double of an exact number, also where numerator and denominator exceed the range of double.
double to_double(const tableaux::rational& x);
double to_double(const tableaux::quadratic& x);

/// Zeros of a polynomial with complex coefficients (ascending): eigenvalues of its companion matrix, polished
/// by Newton's method. Trailing zero coefficients are dropped.
std::vector<complex> zeros(std::vector<complex> p);

/// R = P/Q in doubles, coefficients ascending, for pictures.
struct rational_function {
    std::vector<double> numerator;
    std::vector<double> denominator;

    complex operator()(complex z) const { return horner(numerator, z).first / horner(denominator, z).first; }
    /// log|R| and R'/R.
    log_value log(complex z) const;
    std::vector<complex> roots() const { return zeros({numerator.begin(), numerator.end()}); }
    std::vector<complex> poles() const { return zeros({denominator.begin(), denominator.end()}); }

    /// Where R(z) = e^(i theta).
    std::vector<complex> points_of_argument(double theta) const;

  private:
    static std::pair<complex, complex> horner(const std::vector<double>& p, complex z);
};

template <class K>
rational_function in_doubles(const stability_function<K>& r) {
    rational_function f;
    for (const K& a : r.numerator.coefficients()) f.numerator.push_back(to_double(a));
    for (const K& a : r.denominator.coefficients()) f.denominator.push_back(to_double(a));
    return f;
}

/// Points per diagonal of the window.
inline constexpr double resolution = 600;

/// The boundary |R| = 1 of the stability region (Hairer-Wanner II.IV.2, lecture Definition 2.20) as far as
/// the window shows it. No component is missed: by the maximum principle a bounded component of |R| < 1
/// contains a zero of R and one of |R| > 1 a pole, so R takes every argument on every closed boundary curve,
/// and the zeros of P - e^(i theta) Q for one generic theta give a starting point on each.
std::vector<curve> region_boundary(const rational_function& r, const window& view);

/// A window that shows the boundary, the zeros and the poles where the boundary is bounded, and [-8, 8] x
/// [-8, 8] otherwise (the imaginary axis of the symmetric methods). Far zeros with the islands around them are
/// left out: what lies beyond a gap, a ring 0.6 times as wide as its inner radius and free of such points.
window region_window(const rational_function& r);

/// The order star's data: R, and p and C of e^z - R(z) = C z^(p+1) + ...
struct star {
    rational_function r;
    int order;
    double error_constant;

    /// log of R(z) e^(-z): positive on the order star.
    log_value log(complex z) const;
    /// Nearer to 0 than this, |R e^(-z)| - 1 is too small for doubles to know its sign.
    double blind_radius() const { return std::pow(1e-7 / std::abs(error_constant), 1.0 / (order + 1)); }
    /// A square about 0 with all zeros and poles of R well inside.
    window natural_window() const;
};

/// Coefficients of size at most `noise` (what rounded data leave where exact data give 0) are taken for 0.
template <class K>
star star_of(const stability_function<K>& r, const K& noise = K(0)) {
    const auto tiny = [&noise](const K& a) { return !(a > noise || K(0) - a > noise); };
    std::vector<K> inverse_factorial{K(1)};
    for (int n = 0;; ++n) {
        if (n > 0) inverse_factorial.push_back(inverse_factorial.back() / K(n));
        K coefficient = K(0) - r.numerator[n];  // of z^n in Q e^z - P, and Q(0) = 1
        for (int k = 0; k <= std::min(n, r.denominator.degree()); ++k)
            coefficient = coefficient + r.denominator[k] * inverse_factorial[static_cast<std::size_t>(n - k)];
        if (!tiny(coefficient)) return {in_doubles(r), n - 1, to_double(coefficient)};
        if (n > 100) throw std::invalid_argument("noise: hides the difference to the exponential");
    }
}

/// The curves |R(z) e^(-z)| = 1 that bound the order star (Hairer-Wanner II.IV.4) inside the window. Started
/// on the p + 1 curves through 0, right of the poles, left of the zeros (each bounded component contains
/// one of them), and where curves cross the rim of the window.
std::vector<curve> order_star_boundary(const star& s, const window& view);

/// A rectangle of one grey level, from 0 (value 0) to `levels`.
struct patch {
    double left, right, bottom, top;
    int level;
};

/// Grey patches of a real function with values clipped to [0, 1], cut into `levels` steps: neighbours of one
/// level in a row become one patch, those of the highest level (white) are left out.
template <class Value>
std::vector<patch> shades(Value value, const window& view, int columns, int rows, int levels) {
    std::vector<patch> all;
    const double dx = view.width() / columns, dy = view.height() / rows;
    for (int j = 0; j < rows; ++j) {
        const double y = view.bottom + j * dy;
        int run_level = levels, begin = 0;
        const auto end_run = [&](int i) {
            if (run_level < levels && i > begin)
                all.push_back({view.left + begin * dx, view.left + i * dx, y, y + dy, run_level});
        };
        for (int i = 0; i < columns; ++i) {
            const double v = value(complex(view.left + (i + 0.5) * dx, y + 0.5 * dy));
            const int level = v < 1 ? static_cast<int>(std::max(v, 0.0) * levels) : levels;
            if (level == run_level) continue;
            end_run(i);
            run_level = level;
            begin = i;
        }
        end_run(columns);
    }
    return all;
}

}  // namespace stagecraft::theory::plot

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/plot/region-inl.hpp"
#endif
