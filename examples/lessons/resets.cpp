// SPDX-License-Identifier: BSL-1.0
// A ball bounces, and a thermostat switches: what is done at an event is its third argument, and the run goes on. Where the
// bounces of a ball that comes to rest follow each other without end, the run says so.
#include <cmath>
#include <cstdio>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>

int main() {
    using namespace stagecraft;
    using Eigen::Vector2d;
    const auto fall = [](double, const Vector2d& y, Vector2d& f) { f << y[1], -1; };
    auto bounces =
        events<Vector2d>(event([](double, const Vector2d& y) { return y[0]; },
                               {.direction = crossing::falling}, [](double, Vector2d& y) { y[1] *= -0.5; }));
    const auto ball =
        integrate(radau_iia<3>(), fall, Vector2d(1, 0), 0, 10, {.rtol = 1e-10, .atol = 1e-10}, bounces);
    for (int i = 0; i < 4; ++i)
        std::printf("bounce at %.6f\n", bounces.found()[static_cast<std::size_t>(i)].t);
    std::printf("%s at %.6f, where all bounces end: 3 sqrt(2) = %.6f\n", name(ball.status), ball.t,
                3 * std::sqrt(2.0));

    double heat = 1;  // held by reference: an action may change it instead of y
    const auto room = [&](double, const Vector2d& y, Vector2d& f) { f << heat * 30 - y[0], heat; };
    auto thermostat =
        events<Vector2d>(event([](double, const Vector2d& y) { return y[0] - 21; },
                               {.direction = crossing::rising}, [&](double, Vector2d&) { heat = 0; }),
                         event([](double, const Vector2d& y) { return y[0] - 19; },
                               {.direction = crossing::falling}, [&](double, Vector2d&) { heat = 1; }));
    const auto day =
        integrate(radau_iia<3>(), room, Vector2d(15, 0), 0, 24, {.rtol = 1e-9, .atol = 1e-9}, thermostat);
    const double off = std::log(21.0 / 19), on = std::log(11.0 / 9), warm_up = std::log(15.0 / 9);
    std::printf("%s; switched %zu times, heated for %.4f of 24 h\n", name(day.status),
                thermostat.found().size(), day.y[1]);
    std::printf("a period is %.6f, by the events %.6f\n", off + on,
                (thermostat.found()[20].t - thermostat.found()[0].t) / 10);
    std::printf("the first at %.6f, by the events %.6f\n", warm_up, thermostat.found()[0].t);
}
