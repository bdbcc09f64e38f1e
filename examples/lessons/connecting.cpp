// SPDX-License-Identifier: BSL-1.0
// A travelling wave as an orbit between two equilibria: u_t = u_xx + u (1 - u) (u - a) (Nagumo, a nerve) has a front u(x - c t)
// that goes from 1 far behind to 0 far ahead, at one speed c.
#include <cmath>
#include <cstdio>
#include <stagecraft/bvp/connecting_orbit.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using namespace stagecraft;
using Eigen::Vector2d;

int main() {
    const double a = 0.3;
    // u'' + c u' + u (1 - u) (u - a) = 0 along x - c t; p[0] is the speed.
    const auto front = [&](const auto&, const auto& y, const auto& p, auto& f) {
        f[0] = y[1];
        f[1] = -p[0] * y[1] - y[0] * (1 - y[0]) * (y[0] - a);
    };
    // On the whole line; it need not be near, but must come near both equilibria.
    const auto guess = [](double s) -> Vector2d {
        const double u = 1 / (1 + std::exp(s));
        return {u, -u * (1 - u)};
    };
    const Eigen::Matrix<double, 1, 1> speed(0.4);
    const auto r =
        connecting_orbit(gauss<5>(), front, Vector2d(1, 0), Vector2d(0, 0), guess, speed, {.rtol = 1e-10});
    if (!r.ok()) return std::printf("%s: %s\n", name(r.status), r.message.c_str());
    std::printf("speed %.10f, closed form %.10f\n", r.p[0], (1 - 2 * a) / std::sqrt(2.0));
    const double begin = 1 - r.y(r.y.t0())[0], end = r.y(r.y.t1())[0];
    std::printf("cut off within 1e-6 of both: %s\n", begin < 1e-6 && end < 1e-6 ? "yes" : "no");
    // Without an unknown the equation has no such orbit, and that is said.
    try {
        const auto resting = [&](const auto& t, const auto& y, const auto&, auto& f) {
            front(t, y, Vector2d(0, 0), f);
        };
        connecting_orbit(gauss<5>(), resting, Vector2d(1, 0), Vector2d(0, 0), guess, Eigen::VectorXd(0));
    } catch (const std::invalid_argument& e) {
        std::puts(e.what());
    }
}
