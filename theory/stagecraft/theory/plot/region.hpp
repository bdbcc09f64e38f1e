// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/theory/plot/curve.hpp>
#include <stagecraft/theory/stability/stability_function.hpp>

#include <Eigen/Eigenvalues>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace stagecraft::theory::plot {

/// Nearest double of an exact number, also where numerator and denominator exceed the range of double.
inline double to_double(const tableaux::rational& x) {
    return x.to<boost::multiprecision::cpp_bin_float_100>().convert_to<double>();
}
inline double to_double(const tableaux::quadratic& x) {
    using wide = boost::multiprecision::cpp_bin_float_100;
    return x.to<wide>().convert_to<double>();
}

/// Zeros of a polynomial with complex coefficients (ascending): eigenvalues of its companion matrix, polished
/// by Newton's method. Trailing zero coefficients are dropped.
inline std::vector<complex> zeros(std::vector<complex> p) {
    while (!p.empty() && p.back() == complex(0)) p.pop_back();
    const auto n = static_cast<Eigen::Index>(p.size()) - 1;
    if (n < 1) return {};
    Eigen::MatrixXcd companion = Eigen::MatrixXcd::Zero(n, n);
    for (Eigen::Index k = 0; k < n; ++k) {
        if (k > 0) companion(k, k - 1) = 1;
        companion(k, n - 1) = -p[static_cast<std::size_t>(k)] / p.back();
    }
    // It is a Hessenberg matrix already; to compile a reduction to one would take seconds wherever this is included.
    Eigen::ComplexSchur<Eigen::MatrixXcd> schur(n);
    schur.computeFromHessenberg(companion, companion, false);
    const Eigen::VectorXcd values = schur.matrixT().diagonal();
    std::vector<complex> all(values.data(), values.data() + n);
    for (complex& z : all) {
        for (int k = 0; k < 3; ++k) {
            complex value = 0, slope = 0;
            for (auto j = p.size(); j-- > 0;) {
                slope = slope * z + value;
                value = value * z + p[j];
            }
            const complex move = value / slope;
            if (!(std::abs(move) < 0.1 * (std::abs(z) + 1e-3))) break;
            z -= move;
        }
    }
    return all;
}

/// R = P/Q in doubles, coefficients ascending, for pictures.
struct rational_function {
    std::vector<double> numerator;
    std::vector<double> denominator;

    complex operator()(complex z) const { return horner(numerator, z).first / horner(denominator, z).first; }
    /// log|R| and R'/R.
    log_value log(complex z) const {
        const auto [p, dp] = horner(numerator, z);
        const auto [q, dq] = horner(denominator, z);
        return {std::log(std::abs(p)) - std::log(std::abs(q)), dp / p - dq / q};
    }
    std::vector<complex> roots() const { return zeros({numerator.begin(), numerator.end()}); }
    std::vector<complex> poles() const { return zeros({denominator.begin(), denominator.end()}); }

    /// Where R(z) = e^(i theta).
    std::vector<complex> points_of_argument(double theta) const {
        std::vector<complex> p(std::max(numerator.size(), denominator.size()));
        for (std::size_t k = 0; k < numerator.size(); ++k) p[k] += numerator[k];
        for (std::size_t k = 0; k < denominator.size(); ++k) p[k] -= std::polar(denominator[k], theta);
        return zeros(std::move(p));
    }

  private:
    static std::pair<complex, complex> horner(const std::vector<double>& p, complex z) {
        complex value = 0, slope = 0;
        for (auto j = p.size(); j-- > 0;) {
            slope = slope * z + value;
            value = value * z + p[j];
        }
        return {value, slope};
    }
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
inline std::vector<curve> region_boundary(const rational_function& r, const window& view) {
    const double theta = 0.7;  // generic: not the argument of R at 0, at infinity or on an axis
    const auto starts = r.points_of_argument(theta);
    const auto f = [&r](complex z) { return r.log(z); };
    const level_tracer tracer(f, view, view.diagonal() / resolution, 50 * view.diagonal());
    return tracer.trace_all(starts);
}

/// A window that shows the boundary, the zeros and the poles where the boundary is bounded, and [-8, 8] x
/// [-8, 8] otherwise (the imaginary axis of the symmetric methods). Far zeros with the islands around them are
/// left out: what lies beyond a gap, a ring 0.6 times as wide as its inner radius and free of such points.
inline window region_window(const rational_function& r) {
    const double at_infinity =
        r.numerator.size() == r.denominator.size() ? std::abs(r.numerator.back() / r.denominator.back()) : 0;
    if (std::abs(at_infinity - 1) < 1e-9) return {-8, 8, -8, 8};
    std::vector<complex> points = r.roots(), poles = r.poles();
    points.insert(points.end(), poles.begin(), poles.end());
    for (int k = 0; k < 64; ++k) {
        const auto boundary = r.points_of_argument(0.05 + 0.1 * k);
        points.insert(points.end(), boundary.begin(), boundary.end());
    }
    std::sort(points.begin(), points.end(), [](complex x, complex y) { return std::abs(x) < std::abs(y); });
    window w{-1, 1, -1, 1};
    double reach = 1;
    for (const complex z : points) {
        if (std::abs(z) > 1.6 * reach && reach > 1) break;
        if (std::abs(z) > 1e3) break;
        reach = std::max(reach, std::abs(z));
        w = {std::min(w.left, z.real()), std::max(w.right, z.real()), std::min(w.bottom, z.imag()),
             std::max(w.top, z.imag())};
    }
    const double margin = 0.1 * std::max(w.width(), w.height());
    return {w.left - margin, w.right + margin, w.bottom - margin, w.top + margin};
}

/// The order star's data: R, and p and C of e^z - R(z) = C z^(p+1) + ...
struct star {
    rational_function r;
    int order;
    double error_constant;

    /// log of R(z) e^(-z): positive on the order star.
    log_value log(complex z) const {
        const log_value v = r.log(z);
        return {v.log_modulus - z.real(), v.log_derivative - 1.0};
    }
    /// Nearer to 0 than this, |R e^(-z)| - 1 is too small for doubles to know its sign.
    double blind_radius() const { return std::pow(1e-7 / std::abs(error_constant), 1.0 / (order + 1)); }
    /// A square about 0 with all zeros and poles of R well inside.
    window natural_window() const {
        double size = std::max(2.0, 1.5 * blind_radius());
        for (const auto& points : {r.roots(), r.poles()})
            for (const complex z : points) size = std::max(size, std::abs(z));
        return {-1.6 * size, 1.6 * size, -1.6 * size, 1.6 * size};
    }
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
inline std::vector<curve> order_star_boundary(const star& s, const window& view) {
    const auto f = [&s](complex z) { return s.log(z); };
    const auto level = [&](complex z) { return f(z).log_modulus; };
    std::vector<complex> starts;
    const auto search = [&](complex from, complex to, int parts) {
        double before = level(from);
        for (int k = 1; k <= parts; ++k) {
            const complex z = from + (to - from) * (double(k) / parts);
            const double here = level(z);
            if ((before > 0) != (here > 0)) {
                complex a = from + (to - from) * (double(k - 1) / parts), b = z;
                for (int i = 0; i < 30; ++i) {
                    const complex m = 0.5 * (a + b);
                    ((level(m) > 0) == (before > 0) ? a : b) = m;
                }
                starts.push_back(0.5 * (a + b));
            }
            before = here;
        }
    };
    const double hole = std::max(0.004 * view.diagonal(), s.blind_radius());
    const int rays = 24 * (s.order + 2);
    for (int k = 0; k < rays; ++k) {  // round 0 on a circle: 2(p + 1) crossings
        const double step = 2 * std::acos(-1.0) / rays;
        search(std::polar(1.01 * hole, k * step), std::polar(1.01 * hole, (k + 1) * step), 4);
    }
    const double far = view.diagonal();
    for (const complex z : s.r.poles()) search(z + 1e-6 * far, z + far, 400);
    for (const complex z : s.r.roots()) search(z - 1e-6 * far, z - far, 400);
    const complex corners[] = {
        {view.left, view.bottom}, {view.right, view.bottom}, {view.right, view.top}, {view.left, view.top}};
    for (int k = 0; k < 4; ++k) search(corners[k], corners[(k + 1) % 4], 800);
    const level_tracer tracer(f, view, view.diagonal() / resolution, 0.1 * view.diagonal(), hole);
    return tracer.trace_all(starts);
}

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
