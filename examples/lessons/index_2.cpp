// SPDX-License-Identifier: BSL-1.0
// A differential-algebraic system of index 2: the pendulum with its constraint on the velocity,
//     q' = v,  v' = (0, -1) - lambda q,  0 = q^T v.
// The multiplier's initial value follows from the constraint that is hidden behind the one given.
#include <iostream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/dae/consistent.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/semi_explicit.hpp>

int main() {
    // Generic in the scalar type, so that the Jacobian comes from automatic differentiation.
    const auto f = [](const auto&, const auto& y, const auto& lambda, auto& out) {
        out << y[2], y[3], -lambda[0] * y[0], -lambda[0] * y[1] - 1.0;
    };
    const auto g = [](const auto&, const auto& y, auto& out) { out[0] = y[0] * y[2] + y[1] * y[3]; };
    const auto pendulum = stagecraft::semi_explicit<4, 1>(f, g);  // 4 components y, 1 component lambda

    const Eigen::Vector4d y0(1, 0, 0, -1);  // horizontal, moving down
    const auto guess = pendulum.state<double>(y0, Eigen::Matrix<double, 1, 1>(0.0));
    const auto start = stagecraft::consistent_initial_values(pendulum, 0, guess);
    std::cout << "lambda(0) = " << start.y[4] << '\n';

    const auto r = stagecraft::integrate(stagecraft::radau_iia<3>(), pendulum, start.y, 0, 10,
                                         {.rtol = 1e-9, .atol = 1e-9});
    const double energy = (r.y[2] * r.y[2] + r.y[3] * r.y[3]) / 2 + r.y[1];
    std::cout << name(r.status) << ": q = (" << r.y[0] << ", " << r.y[1] << "), lambda = " << r.y[4] << '\n'
              << "energy kept to 1e-6: " << (std::abs(energy - 0.5) < 1e-6 ? "yes" : "no") << '\n';
}
