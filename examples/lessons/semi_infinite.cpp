// SPDX-License-Identifier: BSL-1.0
// A problem on [0, infinity): the boundary layer of a plate in a stream (Blasius 1908), f''' + f f''/2 = 0, f = f' = 0 at the
// plate, f' = 1 far away. There f is t - p, p being the displacement of the stream, which is unknown.
#include <cmath>
#include <cstdio>
#include <stagecraft/bvp/semi_infinite.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using namespace stagecraft;
using Eigen::Vector3d;

int main() {
    const auto layer = [](const auto&, const auto& y, const auto&, auto& f) {
        f[0] = y[1], f[1] = y[2];
        f[2] = -0.5 * y[0] * y[2];
    };
    // Three components and a parameter. Near the stream one direction decays, so that two conditions are left for the plate.
    const auto plate = [](const auto& left, const auto&, const auto&, auto& r) {
        r[0] = left[0], r[1] = left[1];
    };
    const auto stream = [](double t, const auto& p, auto& y) { y[0] = t - p[0], y[1] = 1, y[2] = 0; };

    const Eigen::Matrix<double, 1, 1> displacement(1);
    const auto r = solve_bvp(gauss<5>(), two_point(layer, plate, to_infinity(stream)), 0, INFINITY,
                             Vector3d(0, 0, 1), displacement, {.rtol = 1e-9});
    if (!r.ok()) return std::printf("%s: %s\n", name(r.status), r.message.c_str());
    std::printf("f''(0) = %.9f, displacement %.8f\n", r.y(0)[2], r.p[0]);
    std::printf("cut off at %.0f; that is less than the tolerance: %s\n", r.y.t1(),
                r.error.global < 1e-9 ? "yes" : "no");
}
