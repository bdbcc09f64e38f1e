// SPDX-License-Identifier: BSL-1.0
// A pendulum in Cartesian coordinates for a thousand periods: the pair of Lobatto IIIA and IIIB keeps its constraints, and its
// energy does not drift; that of Radau IIA, which damps, does.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stagecraft/coefficients/lobatto_iiia.hpp>
#include <stagecraft/coefficients/lobatto_iiib.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>
#include <stagecraft/spark.hpp>
namespace sc = stagecraft;
const double end = 7416.3;  // a thousand periods of the pendulum that falls from the height of its pivot

int main() {
    const auto pendulum =
        sc::lagrangian<2, 1>([](const auto&, const auto& v) { return v.squaredNorm() / 2; },  // T
                             [](const auto& q) { return q[1]; },                              // V
                             [](const auto& q) { return q.squaredNorm() / 2 - 0.5; });        // 0 = g(q)
    double early = 0, late = 0, off = 0;
    const auto watch = [&](double t, const auto& y) {
        const double energy = (y[2] * y[2] + y[3] * y[3]) / 2 + y[1];
        if (t < end / 10) early = std::max(early, std::abs(energy));
        if (t > end * 9 / 10) late = std::max(late, std::abs(energy));
        off = std::max({off, std::abs(std::hypot(y[0], y[1]) - 1), std::abs(y[0] * y[2] + y[1] * y[3])});
    };
    const auto pair = sc::spark(sc::lobatto_iiia<2>(), sc::lobatto_iiib<2>());
    const auto r = sc::integrate(pair, sc::index_reduced(pendulum), Eigen::Vector4d(1, 0, 0, 0), 0, end,
                                 {.rtol = 1e-12, .atol = 1e-12, .fixed_step = 0.05}, watch);
    std::printf("RATTLE, %ld f: energy off by %.0e, later by %.0e, constraints by %s\n", r.report.f, early,
                late, off < 1e-13 ? "rounding" : "more");
    early = late = off = 0;
    const auto formulation = sc::stabilised_index_2(pendulum);
    const auto radau = sc::integrate(sc::radau_iia<3>(), formulation,
                                     formulation.initial_state(Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 0)),
                                     0, end, {.rtol = 1e-5, .atol = 1e-5}, watch);
    std::printf("Radau,  %ld f: energy off by %.0e, later by %.0e, constraints by %.0e\n", radau.report.f,
                early, late, off);
}
