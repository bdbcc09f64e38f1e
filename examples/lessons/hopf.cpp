// SPDX-License-Identifier: BSL-1.0
// From an equilibrium by a Hopf point to orbits, their period doubling, and the doubled orbits: the feedback control system
// x''' + p x'' + x' + x = x^2 of MatCont's tutorials.
#include <cstdio>
#include <stagecraft/bvp/orbit_branches.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using namespace stagecraft;
using Eigen::Vector3d;

int main() {
    const auto control = [](const auto&, const auto& y, const auto& p, auto& f) {
        f[0] = y[1], f[1] = y[2];
        f[2] = -p[0] * y[2] - y[1] - y[0] + y[0] * y[0];
    };
    const auto show = [](const auto& path, point_kind kind) {
        auto found = path.back();
        for (const auto& point : path)
            if (point.kind == kind && point.ok()) found = point;
        std::printf("%-15s at p = %.9f, period %8.5f\n", name(found.kind), found.p[0], found.period);
        return found;
    };
    // The equilibrium 0 is stable for large p.
    const auto rest = equilibrium_continuation(control, Vector3d(0, 0, 0), {.from = 1.5, .to = 0.5});
    const auto hopf = show(rest, point_kind::hopf);

    // `step` is the amplitude of the first orbit; p follows.
    const auto orbits = orbit_continuation(gauss<5>(), control, hopf, {.to = 0.6, .step = 0.1});
    const auto doubling = show(orbits, point_kind::period_doubling);

    // The orbit that has doubled its period, and how far it goes before that doubles again.
    const auto doubled = orbit_continuation(gauss<5>(), control, doubling, {.to = 0.57, .step = 0.05});
    show(doubled, point_kind::period_doubling);
}
