// SPDX-License-Identifier: BSL-1.0
// An unknown final time: the curve of quickest descent from (0, 0) to (1, 1) under gravity, y down. On it the angle of the
// velocity turns at a constant rate, which is unknown as well (Bernoulli 1696): a cycloid.
#include <cmath>
#include <cstdio>
#include <stagecraft/bvp/multipoint.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using namespace stagecraft;
using Eigen::Vector4d;

int main() {
    const auto slide = [](const auto&, const auto& y, const auto& p, auto& f) {
        using std::cos;
        using std::sin;
        f[0] = y[2] * sin(y[3]), f[1] = y[2] * cos(y[3]);  // y = (x, y, speed, angle from the vertical)
        f[2] = 9.81 * cos(y[3]), f[3] = p[0] + 0 * y[0];
    };
    // Four components, a parameter and the time: six conditions.
    const auto ends = [](const auto& left, const auto& right, const auto&, auto& r) {
        for (int k = 0; k < 4; ++k) r[k] = left[k];
        r[4] = right[0] - 1, r[5] = right[1] - 1;
    };
    const auto straight = [](double t) { return Vector4d(2 * t, 2 * t, 8 * t, 2 * t); };

    const Eigen::Matrix<double, 1, 1> rate(3);
    const auto r = solve_bvp(gauss<5>(), two_point(slide, ends, free_length()), 0, 0.5, straight, rate);
    if (!r.ok()) return std::printf("%s: %s\n", name(r.status), r.message.c_str());
    // x = R (a - sin a), y = R (1 - cos a) from a = 0 to 2.4120111439: the time is a sqrt(R / g).
    const double a = 2.4120111439, R = 1 / (1 - std::cos(a));
    std::printf("time %.6f, cycloid %.6f\n", r.y.t1(), a * std::sqrt(R / 9.81));
}
