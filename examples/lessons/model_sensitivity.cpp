// SPDX-License-Identifier: BSL-1.0
// The sensitivity of a mechanical model: how a pendulum's motion depends on gravity. The formulation is built inside of the
// right-hand side, from parameters that may be dual numbers.
#include <cmath>
#include <iostream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>
#include <stagecraft/sensitivity/forward.hpp>

using namespace stagecraft;

struct pendulum {  // a unit mass on a rod of length 1
    static auto with(const auto& gravity) {
        const auto T = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
        const auto V = [gravity](const auto& q) { return gravity * q[1]; };
        const auto rod = [](const auto& q) {
            auto g = (0 * q.template head<1>()).eval();
            g[0] = q.squaredNorm() - 1;
            return g;
        };
        return index_2(lagrangian<2, 1>(T, V, rod));
    }
    void operator()(const auto& t, const auto& y, const auto& p, auto& f) const { with(p[0])(t, y, f); }
    auto mass() const { return with(0.0).mass(); }
    auto index() const { return with(0.0).index(); }
};

int main() {
    const Eigen::Matrix<double, 1, 1> p(9.81);
    const double t = 2;
    const auto y0 = pendulum::with(p[0]).initial_state(Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 0));
    const auto r = sensitivities(radau_iia<3>(), pendulum{}, y0, p, 0, t, {.rtol = 1e-10, .atol = 1e-10});
    // y(t; p) = y(t sqrt(p); 1) in the positions, so that dq/dp = t/(2 p) q'.
    const Eigen::Vector2d exact = t / (2 * p[0]) * r.y.segment<2>(2);
    std::cout << name(r.status) << "\ndq/dg = " << r.S.topRows<2>().transpose() << "\nexact  "
              << exact.transpose() << '\n';
}
