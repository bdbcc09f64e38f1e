// SPDX-License-Identifier: BSL-1.0
// A stiff problem that brings its Jacobian: van der Pol's equation as a struct with a member jacobian().
// Without it the library differentiates by itself, which costs evaluations of f.
#include <iostream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

struct van_der_pol {
    double eps = 1e-6;
    void operator()(double, const Eigen::Vector2d& y, Eigen::Vector2d& f) const {
        f << y[1], ((1 - y[0] * y[0]) * y[1] - y[0]) / eps;
    }
    void jacobian(double, const Eigen::Vector2d& y, Eigen::Matrix2d& J) const {
        J << 0, 1, (-2 * y[0] * y[1] - 1) / eps, (1 - y[0] * y[0]) / eps;
    }
};

int main() {
    const Eigen::Vector2d y0(2, -0.66);
    const auto solve = [&](const auto& problem) {
        return stagecraft::integrate(stagecraft::radau_iia<3>(), problem, y0, 0, 2,
                                     {.rtol = 1e-6, .atol = 1e-6});
    };
    const auto with = solve(van_der_pol{});
    const van_der_pol p;
    const auto without = solve([&](double t, const Eigen::Vector2d& y, Eigen::Vector2d& f) { p(t, y, f); });
    std::cout.precision(5);
    std::cout << name(with.status) << ": y = " << with.y.transpose()
              << "\nf for each Jacobian: " << with.report.f_jacobian / with.report.jacobians
              << " with the member, " << without.report.f_jacobian / without.report.jacobians << " without\n";
}
