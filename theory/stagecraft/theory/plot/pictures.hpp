// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/plot/gnuplot.hpp>

#include <string>
#include <vector>

namespace stagecraft::theory::plot {

namespace colours {
inline constexpr const char* inside = "#d7e5f3";
}  // namespace colours

/// Zeros (o) and poles (x) of R, with a legend below.
void zeros_and_poles(script& p, const rational_function& r);

/// The stability region {|R| <= 1}: filled, its traced boundary, zeros (o) and poles (x) of R.
script region_picture(const std::string& name, const rational_function& r, const window& view,
                      const std::string& subtitle = {});

/// The order star {|R(z)| > |e^z|}: filled, its traced boundary, zeros (o) and poles (x) of R.
script order_star_picture(const std::string& name, const star& s, const window& view,
                          const std::string& subtitle = {});

/// The lecture's pictures on p. 41: min(1, |R|), 1 white and smaller values darker.
script grey_picture(const std::string& name, const rational_function& r, const window& view);

/// A real function on an interval, cut into pieces where it leaves [bottom, top] (poles).
template <class Value>
std::vector<curve> graph(Value value, double from, double to, double bottom, double top, int parts = 800) {
    std::vector<curve> all(1);
    for (int k = 0; k <= parts; ++k) {
        const double x = from + (to - from) * k / parts, y = value(x);
        if (y >= bottom && y <= top) {
            all.back().points.emplace_back(x, y);
        } else if (!all.back().points.empty()) {
            all.emplace_back();
        }
    }
    if (all.back().points.empty()) all.pop_back();
    return all;
}

struct named_function {
    std::string name;
    rational_function r;
};

/// The lecture's picture on p. 40: stability functions against the exponential on the real axis.
script real_axis_picture(const std::vector<named_function>& methods, double from, double to, double bottom,
                         double top);

/// E(y) = |Q(iy)|^2 - |P(iy)|^2 for y >= 0, coefficients ascending: negative where |R(iy)| > 1. Drawn as far
/// as its real zeros and the size of the poles ask for.
script e_polynomial_picture(const std::string& name, const rational_function& r, const std::vector<double>& e,
                            const std::string& subtitle = {});

/// The numbers of a tableau as text, and their values for the colours.
struct cells {
    std::vector<std::vector<std::string>> A;
    std::vector<std::string> b, c, b_embedded;
    std::vector<std::vector<double>> values;  ///< of A
};

/// The Butcher tableau c | A over b (and b_embedded): entries of A shaded by sign and size.
script tableau_picture(const std::string& name, const cells& t, const std::string& subtitle = {});

}  // namespace stagecraft::theory::plot

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/plot/pictures-inl.hpp"
#endif
