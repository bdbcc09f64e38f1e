// SPDX-License-Identifier: BSL-1.0
// Andrews' squeezing mechanism: seven bodies in the plane, driven by a constant torque, one stiff spring
// (Hairer-Wanner II, section VII.7). q holds the angles beta, Theta, gamma, Phi, delta, Omega, epsilon; lengths
// in m, masses in kg.
#include <cmath>
#include <stagecraft/mechanics/lagrangian.hpp>

#include "body.hpp"

namespace mechanics {

namespace {

constexpr double d = 28e-3, da = 115e-4, e = 2e-2, ea = 1421e-5, rr = 7e-3, ra = 92e-5, ss = 35e-3, u = 4e-2,
                 zf = 2e-2, fa = 1421e-5, zt = 4e-2;  // along the bodies

template <class S>
struct point {
    S x, y;
    friend point operator+(const point& a, const point& b) { return {a.x + b.x, a.y + b.y}; }
    friend point operator*(const S& r, const point& a) { return {r * a.x, r * a.y}; }
    friend S square(const point& a) { return a.x * a.x + a.y * a.y; }
};
/// The unit vector at an angle, and the same turned by a right angle.
template <class S>
point<S> along(const S& angle) {
    using std::cos;
    using std::sin;
    return {S(cos(angle)), S(sin(angle))};
}
template <class S>
point<S> across(const S& angle) {
    using std::cos;
    using std::sin;
    return {S(-sin(angle)), S(cos(angle))};
}

/// The kinetic energy of a body: its centre of mass moves with `speed`, it turns with `rate`.
template <class S>
S moving(double mass, const point<S>& speed, double inertia, const S& rate) {
    return 0.5 * (mass * square(speed) + inertia * (rate * rate));
}
/// The same for a body that turns about a fixed point; its centre of mass is at (x, y) from there.
template <class S>
S turning(double mass, double x, double y, double inertia, const S& rate) {
    return 0.5 * (mass * (x * x + y * y) + inertia) * (rate * rate);
}

const auto kinetic = [](const auto& q, const auto& v) {
    using S = std::decay_t<decltype(q[0])>;
    const S rod = v[0] + v[1], right = v[3] + v[4], left = v[5] + v[6];
    const point<S> second = S(rr * v[0]) * across(q[0]) + S(-da * rod) * across(S(q[0] + q[1]));
    const point<S> fourth = S(zt * v[4]) * across(q[4]) + S((e - ea) * right) * along(S(q[3] + q[4]));
    const point<S> sixth = S(u * v[6]) * along(q[6]) + S((zf - fa) * left) * across(S(q[5] + q[6]));
    return S(turning(0.04325, ra, 0, 2.194e-6, v[0]) + moving(0.00365, second, 4.410e-7, rod) +
             turning(0.02373, 1874e-5, 1043e-5, 5.255e-6, v[2]) + moving(0.00706, fourth, 5.667e-7, right) +
             turning(0.07050, 2308e-5, 916e-5, 1.169e-5, v[4]) + moving(0.00706, sixth, 5.667e-7, left) +
             turning(0.05498, 1228e-5, 449e-5, 1.912e-5, v[6]));
};

/// The spring at the third body, and the torque of 0.033 N m on the crank.
const auto potential = [](const auto& q) {
    using std::sqrt;
    using S = std::decay_t<decltype(q[0])>;
    const point<S> from =
        S(2e-2) * along(q[2]) + S(-18e-3) * across(q[2]) + point<S>{S(-0.03635 - 0.014), S(0.03273 - 0.072)};
    const S stretch = sqrt(square(from)) - 7785e-5;
    return S(0.5 * 4530 * stretch * stretch - 33e-3 * q[0]);
};

/// Three bars meet at the end of the rod that the crank moves.
const auto closed = [](const auto& q) {
    using S = std::decay_t<decltype(q[0])>;
    const S right = q[3] + q[4], left = q[5] + q[6];
    const point<S> tip = S(rr) * along(q[0]) + S(-d) * along(S(q[0] + q[1]));
    const point<S> a{S(0.06934), S(0.00227)}, b{S(0.03635), S(-0.03273)};  // minus the fixed points
    const point<S> third = tip + S(ss) * across(q[2]) + b;
    const point<S> fourth = tip + S(e) * across(right) + S(-zt) * along(q[4]) + a;
    const point<S> sixth = tip + S(-zf) * along(left) + S(u) * across(q[6]) + a;
    Eigen::Matrix<S, 6, 1> g;
    g << third.x, third.y, fourth.x, fourth.y, sixth.x, sixth.y;
    return g;
};

}  // namespace

body squeezer() {
    Eigen::Matrix<double, 7, 1> q;
    q << -0.0617138900142764496358948458001, 0, 0.455279819163070380255912382449,
        0.222668390165885884674473185609, 0.487364979543842550225598953530, -0.222668390165885884674473185609,
        1.23054744454982119249735015568;
    const auto model = stagecraft::lagrangian<7, 6>(kinetic, potential, closed);
    body b = describe("squeezer", model, model, q, Eigen::Matrix<double, 7, 1>::Zero(), 0.03, {.rate = 500});
    // Test Set for Initial Value Problem Solvers, andrews.f: PSIDE with tolerance 1e-14.
    b.published.resize(14);
    b.published << 15.81077119629904, -15.75637105984298, 0.04082224013073101, -0.5347301163226948,
        0.5244099658805304, 0.5347301163226948, 1.048080741042263, 1139.920302151208, -1424.379294994111,
        11.03291221937134, 19.29337464421385, 0.5735699284790808, -19.29337464421385, 0.3231791658026955;
    return b;
}

}  // namespace mechanics
