// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/plot/region.hpp"

#include <Eigen/Eigenvalues>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <complex>
#include <type_traits>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory::plot {

STAGECRAFT_INLINE double to_double(const tableaux::rational& x) {
    return x.to<boost::multiprecision::cpp_bin_float_100>().convert_to<double>();
}

STAGECRAFT_INLINE double to_double(const tableaux::quadratic& x) {
    using wide = boost::multiprecision::cpp_bin_float_100;
    return x.to<wide>().convert_to<double>();
}

STAGECRAFT_INLINE std::vector<complex> zeros(std::vector<complex> p) {
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

STAGECRAFT_INLINE log_value rational_function::log(complex z) const {
    const auto [p, dp] = horner(numerator, z);
    const auto [q, dq] = horner(denominator, z);
    return {std::log(std::abs(p)) - std::log(std::abs(q)), dp / p - dq / q};
}

STAGECRAFT_INLINE std::vector<complex> rational_function::points_of_argument(double theta) const {
    std::vector<complex> p(std::max(numerator.size(), denominator.size()));
    for (std::size_t k = 0; k < numerator.size(); ++k) p[k] += numerator[k];
    for (std::size_t k = 0; k < denominator.size(); ++k) p[k] -= std::polar(denominator[k], theta);
    return zeros(std::move(p));
}

STAGECRAFT_INLINE std::pair<complex, complex> rational_function::horner(const std::vector<double>& p,
                                                                        complex z) {
    complex value = 0, slope = 0;
    for (auto j = p.size(); j-- > 0;) {
        slope = slope * z + value;
        value = value * z + p[j];
    }
    return {value, slope};
}

STAGECRAFT_INLINE std::vector<curve> region_boundary(const rational_function& r, const window& view) {
    const double theta = 0.7;  // generic: not the argument of R at 0, at infinity or on an axis
    const auto starts = r.points_of_argument(theta);
    const auto f = [&r](complex z) { return r.log(z); };
    const level_tracer tracer(f, view, view.diagonal() / resolution, 50 * view.diagonal());
    return tracer.trace_all(starts);
}

STAGECRAFT_INLINE window region_window(const rational_function& r) {
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

STAGECRAFT_INLINE log_value star::log(complex z) const {
    const log_value v = r.log(z);
    return {v.log_modulus - z.real(), v.log_derivative - 1.0};
}

STAGECRAFT_INLINE window star::natural_window() const {
    double size = std::max(2.0, 1.5 * blind_radius());
    for (const auto& points : {r.roots(), r.poles()})
        for (const complex z : points) size = std::max(size, std::abs(z));
    return {-1.6 * size, 1.6 * size, -1.6 * size, 1.6 * size};
}

STAGECRAFT_INLINE std::vector<curve> order_star_boundary(const star& s, const window& view) {
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

}  // namespace stagecraft::theory::plot
