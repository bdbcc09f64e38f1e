// SPDX-License-Identifier: BSL-1.0
// A Hamiltonian split into T(p) + V(q): Kepler's orbit of eccentricity 0.6. The force is the derivative of V, taken by
// automatic differentiation. Symplectic pairs keep the energy for ever; RK4 loses it, however small its error is at first.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stagecraft/coefficients/partitioned.hpp>
#include <stagecraft/partitioned.hpp>

using namespace stagecraft;
using Eigen::Vector4d;

tableau<double, 4> rk4() {
    tableau<double, 4> m;
    m.A << 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1, 0;
    m.b << 1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6;
    m.c << 0, 0.5, 0.5, 1;
    return m;
}

int main() {
    const auto orbit = hamiltonian<2>([](const auto& p) { return p.squaredNorm() / 2; },
                                      [](const auto& q) { return -1 / q.norm(); });
    const Vector4d perihelion(0.4, 0, 0, 2);  // y = (q, p), energy -1/2
    const double period = 8 * std::atan(1.0);
    const auto tell = [&](const char* name, const auto& method, int steps) {
        for (const int periods : {10, 100, 1000}) {
            double worst = 0;
            const auto watch = [&](double t, const Vector4d& y) {
                worst = std::max(worst, std::abs(orbit.energy(t, y) + 0.5));
            };
            const auto r = integrate(method, orbit, perihelion, 0, periods * period,
                                     {.fixed_step = period / steps}, watch);
            std::printf("%-15s %4d periods, %6ld forces: error %.0e\n", name, periods, r.report.f, worst);
        }
    };
    tell("Stoermer-Verlet", stoermer_verlet(), 800);
    tell("Forest-Ruth", forest_ruth_4(), 260);
    tell("RK4", rk4(), 200);
}
