// SPDX-License-Identifier: BSL-1.0
// A ball thrown without spin slides (Coulomb friction) until its point of contact rests; then it rolls (a constraint), and
// slides again when the tilting table asks for more friction than there is.
#include <cmath>
#include <iostream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>
#include <stagecraft/mechanics/regularisation/regularised.hpp>
#include <stagecraft/observe/event.hpp>

using namespace stagecraft;
using Eigen::Vector2d, Eigen::Vector4d;
constexpr double R = 0.1, I = 0.4 * R * R, mu = 0.2, g = 9.81, v0 = 3, rate = 0.1;  // mass 1, inertia I
constexpr event_options end{.direction = crossing::falling, .terminal = true};

// The ball rolls until friction, which is the multiplier, is mu times the normal force.
void roll(const char* how, const auto& f, const auto& start) {
    const auto y0 = f.initial_state(start.q, start.v);
    const auto grip = [&](double t, auto& y) { return mu * g * cos(rate * t) - f.multiplier(y, t).norm(); };
    auto slips = events<std::decay_t<decltype(y0)>>(event(grip, end));
    const auto r = integrate(radau_iia<3>(), f, y0, 0, 15, {.rtol = 1e-8, .atol = 1e-8}, slips);
    std::cout << how << name(r.status) << " where tan(tilt)/mu = " << tan(rate * r.t) / mu << " (7/2)\n";
}

int main() {  // states are the place of the ball, its angle, and their rates
    const auto slide = [](double, Vector4d y) { return Vector4d(y[2], y[3], -mu * g, mu * g * R / I); };
    auto rests = events<Vector4d>(event([](double, Vector4d y) { return y[2] - R * y[3]; }, end));
    const auto r = integrate(radau_iia<3>(), slide, Vector4d(0, 0, v0, 0), 0, 10, {}, rests);
    std::cout << "rolls at t = " << r.t << " (2 v0/(7 mu g) = " << 2 * v0 / (7 * mu * g) << ") with "
              << r.y[2] / v0 << " v0 (5/7 = " << 5.0 / 7 << ")\n";
    const auto T = [](auto, auto v) { return 0.5 * (v[0] * v[0] + I * v[1] * v[1]); };
    const auto V = [](auto q) { return 0 * q[0]; };
    const auto rolling = [](auto q) { return (0 * q + Vector2d(1, -R)).transpose().eval(); };
    const auto pull = [](auto q, auto, auto t) { return (0 * q + Vector2d(g, 0) * sin(rate * t)).eval(); };
    const auto ball = lagrangian<2, 1>(T, V, rolling, pull);
    const auto start = assemble(ball, r.y.head<2>(), r.y.tail<2>());  // the event is exact to rounding only
    roll("rigid contact: ", index_2(ball), start);
    roll("elastic contact: ", regularised(ball, 1e-8, 1.0, 1.0, 1.0), start);
}
