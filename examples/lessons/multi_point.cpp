// SPDX-License-Identifier: BSL-1.0
// Conditions inside the interval: a beam y'''' = -p on three supports, of which one is at 0.4, and whose load p is found from
// a deflection that is measured at 0.7.
#include <cstdio>
#include <stagecraft/bvp/multipoint.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using namespace stagecraft;
using Eigen::Vector4d;

int main() {
    const auto beam = [](const auto&, const auto& y, const auto& p, auto& f) {
        for (int k = 0; k < 3; ++k) f[k] = y[k + 1];
        f[3] = -p[0] + 0 * y[0];
    };
    // Supported at both ends: no deflection and no moment.
    const auto ends = [](const auto& left, const auto& right, const auto&, auto& r) {
        r[0] = left[0], r[1] = left[2], r[2] = right[0], r[3] = right[2];
    };
    // At the support y is zero on both sides, slope and moment pass, the shear force jumps by what the support bears.
    const auto support = [](const auto& before, const auto& after, auto& r) {
        r[0] = before[0], r[1] = after[0], r[2] = after[1] - before[1], r[3] = after[2] - before[2];
    };
    const auto measured = [](const auto& y) { return y[0] + 0.0009; };

    const auto problem = two_point(beam, ends, jump_at(0.4, support), interior(0.7, measured));
    const Eigen::Matrix<double, 1, 1> load(0.5);
    const auto r = solve_bvp(gauss<5>(), problem, 0, 1, Vector4d(0, 0, 0, 0), load, {.rtol = 1e-9});
    if (!r.ok()) return std::printf("%s: %s\n", name(r.status), r.message.c_str());
    // By the theorem of three moments: p = 1, moment (0.4^3 + 0.6^3) / 8 and reaction 1/2 + moment (1/0.4 + 1/0.6).
    std::printf("load %.6f, moment %.6f, reaction %.6f\n", r.p[0], -r.y(0.4)[2],
                r.y(0.4)[3] - r.y.before(0.4)[3]);
}
