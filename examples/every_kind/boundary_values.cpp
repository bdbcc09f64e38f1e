// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <numbers>
#include <stagecraft/bvp/periodic_orbit.hpp>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/last_return.hpp>

#include "kinds.hpp"

namespace sc = stagecraft;
using Eigen::Vector2d, Eigen::VectorXd;

void boundary_values() {
    // Ascher-Mattheij-Russell: a layer of width 0.01 about the turning point 0 of eps y'' + x y' = ...;
    // y = cos(pi x) + erf(x/sqrt(2 eps)) to rounding.
    static constexpr double eps = 1e-4, pi = std::numbers::pi;
    const auto layer = sc::two_point(
        [](const auto& x, const auto& y, auto& f) {
            using std::cos;
            using std::sin;
            f[0] = y[1], f[1] = -x * y[1] / eps - pi * pi * cos(pi * x) - pi * x / eps * sin(pi * x);
        },
        [](const auto& left, const auto& right, auto& r) { r[0] = left[0] + 2, r[1] = right[0]; });
    const auto at = [](int k) { return 0.001 * k - 0.05; };
    VectorXd exact(101);
    for (int k = 0; k <= 100; ++k) exact[k] = std::cos(pi * at(k)) + std::erf(at(k) / std::sqrt(2 * eps));
    print("boundary values", "inner layer", "Gauss s = 5", 2, exact, [&](double tol) {
        const auto r =
            sc::solve_bvp(sc::gauss<5>(), layer, -1, 1, Vector2d(0, 0), {.rtol = tol, .atol = tol});
        VectorXd y(101);
        for (int k = 0; k <= 100; ++k) y[k] = r.y(at(k))[0];
        return outcome{.y = y, .ok = r.ok()};
    });
    const auto oscillator = [](const auto&, const auto& y, auto& f) {
        f[0] = y[1], f[1] = (1 - y[0] * y[0]) * y[1] - y[0];
    };
    const double period = 6.6632868593231302;  // known to 28 digits
    print("periodic orbit", "van der Pol", "Gauss s = 5", 2, VectorXd::Constant(1, period), [&](double tol) {
        const auto guess = sc::last_return(sc::radau_iia<3>(), oscillator, Vector2d(2, 0), 0.0, 30.0);
        const auto r = sc::periodic_orbit(sc::gauss<5>(), oscillator, guess, {.rtol = tol, .atol = tol});
        return outcome{.y = VectorXd::Constant(1, r.period), .ok = r.ok()};
    });
}
