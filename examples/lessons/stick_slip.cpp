// SPDX-License-Identifier: BSL-1.0
// Sliding and rolling: a ball thrown without spin slides (Coulomb friction) until its point of contact rests, rolls
// (a constraint), and slides again when the tilting table asks for more friction than there is.
#include <cmath>
#include <iostream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>
#include <stagecraft/mechanics/regularised.hpp>
#include <stagecraft/observe/event.hpp>

int main() {
    using namespace stagecraft;
    using Eigen::Vector2d, Eigen::Vector4d;
    const double R = 0.1, mu = 0.2, g = 9.81, v0 = 3, tilting = 0.1;
    const event_options ends{.direction = crossing::falling, .terminal = true};

    // Sliding is an ordinary differential equation for (x, angle, x', angle'), mass 1, inertia 2/5 R^2.
    const auto sliding = [=](double, const Vector4d& y, Vector4d& f) {
        f << y[2], y[3], -mu * g, mu * g / (0.4 * R);
    };
    auto grip = events<Vector4d>(event([=](double, const Vector4d& y) { return y[2] - R * y[3]; }, ends));
    const auto thrown = integrate(radau_iia<3>(), sliding, Vector4d(0, 0, v0, 0), 0, 10, {}, grip);
    std::cout << "rolls at t = " << thrown.t << " (2 v0/(7 mu g) = " << 2 * v0 / (7 * mu * g) << ") with "
              << thrown.y[2] / v0 << " v0 (5/7 = " << 5.0 / 7 << ")\n";

    // Rolling is a velocity constraint; its multiplier is the friction, which may be mu times the normal force.
    const auto T = [=](const auto&, const auto& v) {
        return 0.5 * (v[0] * v[0] + 0.4 * R * R * v[1] * v[1]);
    };
    const auto V = [](const auto& q) { return 0 * q[0]; };
    const auto rolling = [=](const auto& q) { return (0 * q + Vector2d(1, -R)).transpose().eval(); };
    const auto weight = [=](const auto& q, const auto&, const auto& t) {
        auto Q = (0 * q).eval();
        Q[0] = g * sin(tilting * t);
        return Q;
    };
    const auto ball = lagrangian<2, 1>(T, V, rolling, weight);
    const auto start =
        assemble(ball, thrown.y.head<2>(), thrown.y.tail<2>());  // the event is exact to rounding only
    const auto roll = [&]<class Problem>(const char* contact, const Problem& problem) {
        const auto y0 = problem.initial_state(start.q, start.v);
        using state = std::decay_t<decltype(y0)>;
        auto slip = events<state>(event(
            [&](double t, const state& y) {
                return mu * g * std::cos(tilting * t) - std::abs(problem.multiplier(y, t)[0]);
            },
            ends));
        const auto r = integrate(radau_iia<3>(), problem, y0, 0, 15, {.rtol = 1e-8, .atol = 1e-8}, slip);
        std::cout << contact << ": " << name(r.status)
                  << " where tan(tilt)/mu = " << std::tan(tilting * r.t) / mu << " (7/2)\n";
    };
    roll("rigid contact", index_2(ball));
    roll("elastic contact", regularised(ball, 1e-8, 1.0, 1.0, 1.0));
}
