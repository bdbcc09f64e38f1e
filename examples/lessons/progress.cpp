// SPDX-License-Identifier: BSL-1.0
// Progress and cancelling: an observer is called after every accepted step, and ends the run by returning
// false. What it returns may come from a clock, a signal handler, or a button in another thread.
#include <atomic>
#include <cstdio>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

std::atomic<bool> cancelled{false};

int main() {
    using Eigen::Vector2d;
    const double t1 = 100;
    const auto oscillator = [](double, const Vector2d& y, Vector2d& f) { f << y[1], -y[0]; };
    int shown = 0;
    const auto progress = [&](double t, const Vector2d&) {
        for (; shown <= 10 * t / t1; ++shown) std::printf("%3d %%\n", 10 * shown);
        if (t > 42) cancelled = true;  // here: as if somebody had pressed the button
        return !cancelled;
    };
    const auto r = stagecraft::integrate(stagecraft::radau_iia<3>(), oscillator, Vector2d(0, 1), 0, t1,
                                         {.max_step = 1}, progress);
    std::printf("%s between 42 and 43: %s\n", name(r.status), r.t > 42 && r.t < 43 ? "yes" : "no");
}
