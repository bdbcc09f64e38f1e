// SPDX-License-Identifier: BSL-1.0
// Two four-bar linkages side by side (benchmark A02 of the library of multibody problems, N = 2; Gonzalez 2006): bars
// of 1 m and 1 kg hinged at (0, 0), (1, 0), (2, 0), upright, their ends joined by two more; the ends move with 1 m/s.
// q holds these three ends. Until 0.6 s; soon after all bars lie in a line, where G loses rank.
#include <cmath>
#include <stagecraft/mechanics/free_motion.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

#include "body.hpp"

namespace mechanics {

namespace {

using std::cos;
using std::sin;
constexpr double gravity = 9.81;

/// Uniform bars between their ends u and v: (u^2 + u v + v^2)/6.
const auto kinetic = [](const auto&, const auto& v) {
    auto twice = (v[0] * v[0] + v[1] * v[1]) / 3;
    for (int k = 2; k < 6; ++k) twice += v[k] * v[k] / 3;
    for (int k = 0; k < 4; ++k) twice += (v[k] * v[k] + v[k] * v[k + 2] + v[k + 2] * v[k + 2]) / 3;
    return decltype(twice)(twice / 2);
};
const auto potential = [](const auto& q) { return gravity * (q[1] + 1.5 * q[3] + q[5]); };
const auto lengths = [](const auto& q) {
    using S = std::decay_t<decltype(q[0])>;
    Eigen::Matrix<S, 5, 1> g;
    for (int k = 0; k < 3; ++k) g[k] = (q[2 * k] - k) * (q[2 * k] - k) + q[2 * k + 1] * q[2 * k + 1] - 1;
    for (int k = 0; k < 2; ++k) {
        const S x = q[2 * k + 2] - q[2 * k], y = q[2 * k + 3] - q[2 * k + 1];
        g[3 + k] = x * x + y * y - 1;
    }
    return g;
};

/// By one angle, that of the upright bars: these turn, the others move along with their ends.
const auto kinetic_alone = [](const auto&, const auto& v) { return 1.5 * v[0] * v[0]; };
const auto potential_alone = [](const auto& q) { return 3.5 * gravity * sin(q[0]); };

}  // namespace

body four_bar() {
    const auto model = stagecraft::lagrangian<6, 5>(kinetic, potential, lengths);
    Eigen::Matrix<double, 6, 1> q, v;
    q << 0, 1, 1, 1, 2, 1;
    v << 1, 0, 1, 0, 1, 0;
    body b = describe("four_bar", model, model, q, v, 0.6);
    const long double upright = std::acos(-1.0L) / 2;
    using one = Eigen::Matrix<long double, 1, 1>;
    b.alone = alone<1>(
        stagecraft::free_motion<long double>(stagecraft::lagrangian<1>(kinetic_alone, potential_alone)),
        one(upright), one(-1), [](const auto& at, const auto& rate) {
            thesis::vector_of<long double> y(12);
            const long double x = cos(at[0]), z = sin(at[0]);
            for (int k = 0; k < 3; ++k) {
                y[2 * k] = k + x, y[2 * k + 1] = z;
                y[6 + 2 * k] = -z * rate[0], y[7 + 2 * k] = x * rate[0];
            }
            return y;
        });
    return b;
}

}  // namespace mechanics
