// SPDX-License-Identifier: BSL-1.0
// Section 4.4: the limit cycle (sin t, cos t).
#include <problems/dense_once.hpp>
#include <stagecraft/bvp/periodic_orbit.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/last_return.hpp>

#include "../lecture/portrait.hpp"
#include "experiments.hpp"

namespace boundary_values {

chapter limit_cycle() {
    chapter out;
    using Eigen::Vector2d;
    const auto cycle = [](const auto&, const auto& x, auto& f) {
        const auto left = 1 - x[0] * x[0] - x[1] * x[1];
        f[0] = x[1] + x[0] * left;
        f[1] = x[1] * left - x[0];
    };
    const double multiplier = std::exp(-4 * pi);
    orbit_guess<Vector2d> guess;
    std::vector<plot::curve> orbits;
    for (const Vector2d& start : {Vector2d(1, 0), Vector2d(2, 1), Vector2d(-0.1, 0)}) {
        guess = last_return(radau_iia<3>(), cycle, start, 0.0, 20.0);
        const auto r = periodic_orbit(gauss<5>(), cycle, guess, {.rtol = 1e-12});
        const std::string which = "limit cycle from (" + number(start[0]) + ", " + number(start[1]) + "): ";
        out.find(which + "T", "2 pi", number(r.period, "%.13g"), number(2 * pi, "%.13g"),
                 r.ok() && near(r.period, 2 * pi, 1e-12));
        const auto least = r.multipliers.empty() ? floquet_multiplier<double>{} : r.multipliers.back();
        out.find(which + "multipliers", "-",
                 "1 + " + number(std::abs(r.multipliers[0].value - 1.0), "%.0e") + ", " +
                     number(least.value.real(), "%.13g"),
                 "1, e^(-4 pi) = " + number(multiplier, "%.13g"),
                 near(least.value.real(), multiplier, 1e-10) &&
                     std::abs(r.multipliers[0].value - 1.0) < 1e-10 &&
                     std::abs(least.value - multiplier) <= least.error);
        orbits.push_back(lecture::solution<2>(cycle, theory::state<double, 2>(start), 20, 2000, 10, true));
    }
    for (const double alpha : {0.0, 1.0}) {
        const auto r = periodic_orbit(gauss<5>(), cycle, guess,
                                      {.rtol = 1e-10, .phase_component = 0, .phase_value = alpha});
        // f_1 vanishes where x_1 = 1: that condition is tangential.
        const bool expected = alpha == 0 ? r.ok() && near(r.period, 2 * pi, 1e-9) : !r.ok();
        out.find("phase condition x_1(0) = " + number(alpha), alpha == 0 ? "alpha != 0" : "allowed",
                 name(r.status), alpha == 0 ? "success: f_1 = 1" : "not success: f_1 = 0", expected);
    }
    out.pictures.push_back(lecture::portrait("p74_limit_cycle",
                                             "x_1' = x_2 + x_1 (1 - r^2), x_2' = -x_1 + x_2 (1 - r^2)",
                                             orbits, {-1.5, 2.2, -1.5, 1.5}, {{0, 0}}));
    return out;
}

}  // namespace boundary_values
