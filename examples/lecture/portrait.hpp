// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lecture.hpp"

namespace lecture {

/// The index of the point half way along the part of a curve that lies in the window, the last point left out; 0 where none
/// does.
inline std::size_t half_way(const plot::curve& c, const plot::window& view) {
    const auto seen = [&](std::size_t k) {
        const auto z = c.points[k];
        return z.real() > view.left && z.real() < view.right && z.imag() > view.bottom && z.imag() < view.top;
    };
    double length = 0;
    for (std::size_t k = 0; k + 1 < c.points.size(); ++k)
        if (seen(k)) length += std::abs(c.points[k + 1] - c.points[k]);
    double gone = 0;
    for (std::size_t k = 0; k + 1 < c.points.size(); ++k) {
        if (!seen(k)) continue;
        gone += std::abs(c.points[k + 1] - c.points[k]);
        if (2 * gone >= length) return k;
    }
    return 0;
}

/// Orbits in the plane, one scale for both axes: an arrow half way along each, a circle where it starts, a disc at each
/// equilibrium.
inline picture portrait(const std::string& name, const std::string& title,
                        const std::vector<plot::curve>& orbits, const plot::window& view,
                        const std::vector<plot::complex>& equilibria) {
    picture p = curves(name, title, orbits, view, "x_1", "x_2");
    p.script.set("set size ratio -1");
    const double height = (view.top - view.bottom) / (view.right - view.left);
    p.script.size = {620, 120 + static_cast<int>(500 * height)};
    std::vector<plot::complex> starts;
    for (const plot::curve& c : orbits) {
        if (c.points.size() < 2) continue;
        starts.push_back(c.points.front());
        const std::size_t k = half_way(c, view);
        const plot::complex from = c.points[k], along = c.points[k + 1] - from;
        if (along == plot::complex(0)) continue;
        const plot::complex to = from + 0.03 * (view.right - view.left) * along / std::abs(along);
        p.script.set("set arrow from " + number(from.real()) + "," + number(from.imag()) + " to " +
                     number(to.real()) + "," + number(to.imag()) +
                     " size graph 0.03,20,60 filled front lc rgb '#1f4e79' lw 1");
    }
    p.script.points(starts, "pt 6 ps 0.6 lc rgb '#1f4e79' title 'start'");
    p.script.points(equilibria, "pt 7 ps 0.7 lc rgb '#c03028' title 'equilibrium'");
    p.script.set("set key outside bottom center horizontal height 1");
    return p;
}

}  // namespace lecture
