// SPDX-License-Identifier: BSL-1.0
// Section 5.1: multiple shooting of a pendulum. Its segments before and after Newton's iteration.
#include <problems/dense_once.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/shooting.hpp>

#include "experiments.hpp"

namespace boundary_values {

namespace {

using Eigen::Vector2d;

/// The angle is x_2: 0 at the start, `end` at T; N intervals.
constexpr double T = 6, end = 2;
constexpr int N = 6;
const auto pendulum = [](const auto&, const auto& x, auto& f) {
    using std::sin;
    f[0] = -sin(x[1]), f[1] = x[0];
};

/// x(t; z_j, t_j) on each interval, and the largest jump between them.
struct segments {
    std::vector<plot::curve> curves;
    double jump = 0;
    segments(const std::vector<double>& nodes, const std::vector<Vector2d>& values) {
        for (std::size_t j = 0; j + 1 < nodes.size(); ++j) {
            auto c = lecture::solution<2>(pendulum, theory::state<double, 2>(values[j]),
                                          nodes[j + 1] - nodes[j], 50, 1e3);
            for (auto& point : c.points) point += nodes[j];
            jump = std::max(jump, std::abs(c.points.back().imag() - values[j + 1][1]));
            curves.push_back(std::move(c));
        }
    }
};

}  // namespace

chapter shooting_segments() {
    chapter out;
    const auto guess = [](double t) { return Vector2d(0, end * t / T); };
    const auto r = shooting(radau_iia<5>(),
                            two_point(pendulum, [](const auto& left, const auto& right,
                                                   auto& d) { d[0] = left[1], d[1] = right[1] - end; }),
                            0.0, T, guess, {.rtol = 1e-10, .intervals = N});
    std::vector<Vector2d> first;
    for (const double t : r.nodes) first.push_back(guess(t));
    const segments before(r.nodes, first), after(r.nodes, r.values);
    out.find("multiple shooting of a pendulum, N = 6: largest jump before, after Newton", "-",
             number(before.jump, "%.2f") + ", " + number(after.jump, "%.0e"), "> 0, 0",
             r.ok() && before.jump > 0.1 && after.jump < 1e-6);
    std::vector<plot::complex> starts;
    for (int j = 0; j < N; ++j) starts.emplace_back(r.nodes[j], first[j][1]);
    auto p = lecture::curves("p76_multiple_shooting", "x_1' = -sin x_2, x_2' = x_1: multiple shooting", {},
                             {0, T, -1, 4}, "t", "x_2");
    p.script.set("set key outside bottom center horizontal height 1");
    p.script.lines(before.curves, "lc rgb '#d55e00' lw 2 title 'before Newton''s iteration'")
        .lines(after.curves, "lc rgb '#1f4e79' lw 2 title 'after it'")
        .points(starts, "pt 6 ps 0.7 lc rgb '#d55e00' title 'start'");
    out.pictures.push_back(std::move(p));
    return out;
}

}  // namespace boundary_values
