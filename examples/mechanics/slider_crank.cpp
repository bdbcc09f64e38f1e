// SPDX-License-Identifier: BSL-1.0
// A slider crank with the bodies of Simeon's (Test Set for Initial Value Problem Solvers; lengths in m, masses in
// kg): its rod is as stiff along its axis as the steel rod there, by a spring between it and the slider, and turns and
// bends as a rigid one. The crank starts at 150 rad/s and is let go. q = (crank's angle, rod's angle, slider's place).
#include <cmath>
#include <stagecraft/mechanics/free_motion.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

#include "body.hpp"

namespace mechanics {

namespace {

constexpr double l1 = 0.15, l2 = 0.30, J1 = 0.002727, m2 = 0.151104, J2 = 0.0045339259, m3 = 0.075552,
                 omega = 150, stiffness = 2e11 * 0.008 * 0.008 / l2;

/// J2 and the product term are those of a uniform rod, about the end that the crank moves.
const auto kinetic = [](const auto& q, const auto& v) {
    using std::cos;
    using S = std::decay_t<decltype(q[0] * v[0])>;
    const S rod = S(m2 * l1 * l1) * v[0] * v[0] + S(m2 * l1 * l2) * S(cos(q[0] - q[1])) * v[0] * v[1] +
                  S(J2) * v[1] * v[1];
    return S((S(J1) * v[0] * v[0] + rod + S(m3) * v[2] * v[2]) / S(2));
};
const auto potential = [](const auto& q) {
    using std::cos;
    using S = std::decay_t<decltype(q[0])>;
    const S stretch = q[2] - S(l1) * S(cos(q[0])) - S(l2) * S(cos(q[1]));
    return S(S(stiffness / 2) * stretch * stretch);
};
/// The end of the rod stays on the slider's line.
const auto guided = [](const auto& q) {
    using std::sin;
    using S = std::decay_t<decltype(q[0])>;
    return S(S(l1) * S(sin(q[0])) + S(l2) * S(sin(q[1])));
};

/// The rod's angle follows from the crank's: the same mechanism without constraints, in (crank's angle, slider's place).
template <class S>
S rod_angle(const S& crank) {
    using std::asin;
    using std::sin;
    return S(asin(S(S(-l1 / l2) * S(sin(crank)))));
}
template <class S, class T>
S rod_rate(const S& crank, const T& rate) {
    using std::cos;
    return S(S(-l1 / l2) * S(cos(crank)) / S(cos(rod_angle(crank))) * rate);
}
const auto kinetic_alone = [](const auto& q, const auto& v) {
    using S = std::decay_t<decltype(q[0] * v[0])>;
    const S crank(q[0]);
    Eigen::Matrix<S, 3, 1> all(crank, rod_angle(crank), S(q[1])),
        rates(S(v[0]), rod_rate(crank, v[0]), S(v[1]));
    return kinetic(all, rates);
};
const auto potential_alone = [](const auto& q) {
    using S = std::decay_t<decltype(q[0])>;
    return potential(Eigen::Matrix<S, 3, 1>(q[0], rod_angle(S(q[0])), q[1]));
};

}  // namespace

body slider_crank() {
    const auto model = stagecraft::lagrangian<3, 1>(kinetic, potential, guided);
    // The spring starts as stretched as on the motion without oscillation, expanded in 1/stiffness; first of all
    // m3 (l1 + l1^2/l2) omega^2/stiffness = 8.9644e-6.
    const double stretch = 8.96804336045493e-6;
    const Eigen::Vector3d q(0, 0, l1 + l2 + stretch), v(omega, -l1 / l2 * omega, 0);
    body b = describe("slider_crank", model, model, q, v, 0.02, {.rate = 500});
    b.alone = alone<2>(
        stagecraft::free_motion<long double>(stagecraft::lagrangian<2>(kinetic_alone, potential_alone)),
        Eigen::Vector2d(q[0], q[2]), Eigen::Vector2d(v[0], v[2]), [](const auto& at, const auto& rate) {
            thesis::vector_of<long double> y(6);
            y << at[0], rod_angle(at[0]), at[1], rate[0], rod_rate(at[0], rate[0]), rate[1];
            return y;
        });
    return b;
}

}  // namespace mechanics
