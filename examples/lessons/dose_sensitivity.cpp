// SPDX-License-Identifier: BSL-1.0
// How a drug's level depends on its dose and clearance, across doses; how a ball's height depends on its restitution, across
// bounces: at() and event() with actions that depend on p, and dy/dp that jumps there.
#include <cmath>
#include <cstdio>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/sensitivity/adjoint.hpp>
#include <stagecraft/sensitivity/forward.hpp>

int main() {
    using namespace stagecraft;
    using Eigen::Vector2d;
    const options<double> o{.rtol = 1e-9, .atol = 1e-9};
    const auto method = radau_iia<3>();

    const auto clears = [](const auto&, const auto& y, const auto& p, auto& f) { f << -p[0] * y[0], y[0]; };
    const auto doses = at({0.0, 24.0, 48.0}, [](const auto&, auto& y, const auto& p) { y[0] += p[1]; });
    const Vector2d p(0.05, 100), nothing(0, 0);
    const auto level = sensitivities_with_events(method, clears, nothing, p, 0, 72, doses, o);
    double y = 0;
    for (const double age : {24.0, 48.0, 72.0}) y += std::exp(-p[0] * age);
    std::printf("level by dose %.6f, exactly %.6f; by clearance %.3f\n", level.S(0, 1), y, level.S(0, 0));

    // The same of one number, back from the end, with an estimate of its error.
    const auto exposure = adjoint_gradient_with_events(
        method, clears, nothing, p, 0, 72, doses, [](const auto& x) { return x[1]; }, o);
    std::printf("exposure %.3f, by clearance %.2f, by dose %.5f\n", exposure.value, exposure.dp[0],
                exposure.dp[1]);

    const auto falls = [](const auto&, const auto& x, const auto& q, auto& f) { f << x[1], -q[0]; };
    const auto bounce =
        event([](const auto&, const auto& x) { return x[0]; }, {.direction = crossing::falling},
              [](const auto&, auto& x, const auto& q) { x[1] *= -q[1]; });
    const auto ball =
        sensitivities_with_events(method, falls, Vector2d(1, 0), Vector2d(8, 0.8), 0, 1, bounce, o);
    std::printf("it hits the floor at %.6f, by g %.6f; height at 1 by restitution %.6f\n", ball.events[0].t,
                ball.events[0].dt[0], ball.S(0, 1));
}
