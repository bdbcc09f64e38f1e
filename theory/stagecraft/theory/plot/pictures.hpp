// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/plot/gnuplot.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace stagecraft::theory::plot {

namespace colours {
inline constexpr const char* inside = "#d7e5f3";
}  // namespace colours

/// A function and what the legend calls it.
struct named_function {
    std::string name;
    rational_function r;
};

/// Zeros (o) and poles (x) of R, with a legend below.
void zeros_and_poles(script& p, const rational_function& r);

/// The stability region {|R| <= 1}: filled, its traced boundary, zeros (o) and poles (x) of R; the legend names the method.
script region_picture(const std::string& name, const rational_function& r, const window& view,
                      const std::string& subtitle = {});

/// The most methods that one picture of regions takes.
inline constexpr std::size_t most_regions = 8;

/// How the boundary of the k-th region is drawn: a colour "#rrggbb", and lengths of dashes and gaps, none for a solid line.
struct line_style {
    const char* colour;
    std::vector<int> dashes;
};
line_style region_line(std::size_t k);

/// The colour of points that lie in `of_them` of `all` regions, the darker the more.
std::string region_shade(std::size_t of_them, std::size_t all);

/// Throws std::invalid_argument for no method, and for more than `most_regions`.
void require_regions(const std::vector<named_function>& methods);

/// Patches of the regions; their level is the number of methods with |R| > 1.
std::vector<patch> region_patches(const std::vector<named_function>& methods, const window& view, int columns,
                                  int rows);

/// The stability regions of several methods in one window, each with a boundary of its own; the more methods are stable
/// at z, the darker. Throws std::invalid_argument for none, and for more than `most_regions`.
script regions_picture(const std::vector<named_function>& methods, const window& view);

/// A window that shows what the windows of all of them do.
window common_window(const std::vector<named_function>& methods);

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
