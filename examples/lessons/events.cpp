// SPDX-License-Identifier: BSL-1.0
// Events: a ball that loses a fifth of its speed whenever it hits the ground. Each impact ends a run, and
// the next one starts from there.
#include <iostream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>

using Eigen::Vector2d;

int main() {
    using namespace stagecraft;
    const auto ball = [](double, const Vector2d& y, Vector2d& f) { f << y[1], -9.81; };
    const auto height = [](double, const Vector2d& y) { return y[0]; };
    const auto speed = [](double, const Vector2d& y) { return y[1]; };
    auto watch = events<Vector2d>(event(height, {.direction = crossing::falling, .terminal = true}),
                                  event(speed));  // the top of the flight is only recorded

    double t = 0;
    Vector2d y(1, 0);
    for (int bounce = 1; bounce <= 3; ++bounce) {
        const auto r = integrate(radau_iia<3>(), ball, y, t, 100, {}, watch);
        if (r.status != status::event) return 1;
        for (const auto& o : watch.found())
            if (o.event == 1) std::cout << "top " << o.y[0] << " m at t = " << o.t << " s\n";
        std::cout << "impact " << bounce << " at t = " << r.t << " s with " << r.y[1] << " m/s\n";
        t = r.t;
        y << 0, -0.8 * r.y[1];
    }
}
