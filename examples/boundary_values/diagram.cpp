// SPDX-License-Identifier: BSL-1.0
// The bifurcation diagram of the control system x''' + p x'' + x' + x = x^2 of MatCont's manual: rest, Hopf point, orbits, period
// doubling, orbits of twice the period, period doubling.
#include <problems/dense_once.hpp>
#include <stagecraft/bvp/orbit_branches.hpp>
#include <stagecraft/coefficients/gauss.hpp>

#include "experiments.hpp"

namespace boundary_values {

namespace {

/// A path as its highest values of x over p, in two parts that have the point in common where its stability changes.
struct branch {
    plot::curve stable, unstable;

    void add(double p, double top, bool is_stable) {
        if (!is_stable && unstable.points.empty() && !stable.points.empty())
            unstable.points.push_back(stable.points.back());
        (is_stable ? stable : unstable).points.emplace_back(p, top);
    }
};

double highest(const solution<Eigen::Vector3d>& y) {
    double top = y(0.0)[0];
    for (int k = 1; k < 400; ++k) top = std::max(top, y(k / 400.0)[0]);
    return top;
}

/// Of the multipliers one is 1, and the others decide. At a doubling one is -1, in rounding.
branch of_orbits(const std::vector<orbit_point<Eigen::Vector3d>>& path) {
    branch b;
    for (const auto& o : path) {
        const bool stable = std::none_of(o.multipliers.begin(), o.multipliers.end(),
                                         [](const auto& m) { return std::abs(m.value) > 1 + 1e-6; });
        b.add(o.p[0], highest(o.y), stable);
    }
    return b;
}

template <class Point>
const Point& only(const std::vector<Point>& path, point_kind kind) {
    const auto is = [kind](const Point& point) { return point.kind == kind && point.ok(); };
    if (std::count_if(path.begin(), path.end(), is) != 1)
        throw std::runtime_error(std::string("diagram: not one ") + name(kind) + " on the path");
    return *std::find_if(path.begin(), path.end(), is);
}

lecture::picture drawn(const branch& rest, const branch& once, const branch& twice,
                       const std::vector<plot::complex>& hopf, const std::vector<plot::complex>& doublings) {
    auto p = lecture::curves("bifurcations", "x^{(3)} + p x^{(2)} + x^{(1)} + x = x^2", {},
                             {0.55, 1.1, -0.05, 1.05}, "p", "the highest x");
    auto& s = p.script;
    const auto lines = [&s](const branch& b, const std::string& colour, const std::string& what) {
        const std::string line = "lc rgb '" + colour + "' lw 2 title '" + what;
        s.lines({b.stable}, line + ", stable'").lines({b.unstable}, "dt 2 " + line + ", unstable'");
    };
    s.set("set key outside bottom center horizontal height 1");
    lines(rest, "#777777", "equilibrium");
    lines(once, "#1f4e79", "periodic orbit");
    lines(twice, "#009e73", "orbit of twice the period");
    s.points(hopf, "pt 7 ps 0.9 lc rgb '#d55e00' title 'Hopf point'");
    s.points(doublings, "pt 9 ps 1.1 lc rgb '#d55e00' title 'period doubling'");
    return p;
}

}  // namespace

chapter bifurcations() {
    chapter out;
    const auto control = [](const auto&, const auto& y, const auto& p, auto& f) {
        f[0] = y[1], f[1] = y[2];
        f[2] = -p[0] * y[2] - y[1] - y[0] + y[0] * y[0];
    };
    const auto rests = equilibrium_continuation(control, Eigen::Vector3d(Eigen::Vector3d::Zero()),
                                                {.from = 1.2, .to = 0.55});
    const auto& hopf = only(rests, point_kind::hopf);
    const auto orbits =
        orbit_continuation(gauss<5>(), control, hopf, {.to = 0.57, .step = 0.05, .largest_step = 0.2});
    const auto& first = only(orbits, point_kind::period_doubling);
    const auto doubled =
        orbit_continuation(gauss<5>(), control, first, {.to = 0.575, .step = 0.05, .largest_step = 0.1});
    const auto& second = only(doubled, point_kind::period_doubling);

    // MatCont's test run "adapt" (Govaerts 2019) prints seven digits of the first two; eleven, and the third, by
    // shooting with Taylor series of degree 28 in 64 bits.
    const auto located = [&](const char* what, const char* printed, double p, double T, double p_known,
                             double T_known) {
        const auto text = [](double q, double period) {
            return "p = " + number(q, "%.11f") + ", T = " + number(period, "%.9f");
        };
        out.find(what, printed, text(p, T), text(p_known, T_known),
                 std::abs(p - p_known) < 1e-10 && std::abs(T - T_known) < 1e-9);
    };
    located("Hopf point", "p = 1.000002", hopf.p[0], hopf.period, 1, 2 * pi);
    located("its orbits double their period", "p = 0.6303020, T = 6.364071", first.p[0], first.period,
            0.63030200615962, 6.364071339441);
    located("and those again", "-", second.p[0], second.period, 0.57962984089559, 12.734365542206);

    branch rest;
    for (const auto& e : rests) rest.add(e.p[0], e.y[0], e.eigenvalues[0].real() < 1e-9);
    out.pictures.push_back(drawn(rest, of_orbits(orbits), of_orbits(doubled), {{hopf.p[0], hopf.y[0]}},
                                 {{first.p[0], highest(first.y)}, {second.p[0], highest(second.y)}}));
    return out;
}

}  // namespace boundary_values
