// SPDX-License-Identifier: BSL-1.0
// An implicit-explicit method: Burgers' equation u_t + u u_x = nu u_xx, of which the diffusion, stiff and linear, is the
// implicit part and the transport the explicit one. One Jacobian serves the run, and no stage iterates twice.
#include <cmath>
#include <cstdio>
#include <stagecraft/additive.hpp>
#include <stagecraft/coefficients/additive.hpp>
#include <stagecraft/linear/banded_blocks.hpp>

using Eigen::VectorXd;
constexpr int n = 400;  // cells of size h between x = -1 and x = 3
constexpr double h = 4.0 / n, nu = 0.1;

double wave(double t, double x) { return 0.5 - 0.5 * std::tanh((x - t / 2) / (4 * nu)); }  // a solution
double x_of(int i) { return -1 + (i + 0.5) * h; }

struct transport {
    void operator()(double t, const VectorXd& u, VectorXd& f) const {
        const auto at = [&](int i) { return i < 0 || i >= n ? wave(t, x_of(i)) : u[i]; };
        for (int i = 0; i < n; ++i) f[i] = (at(i - 1) * at(i - 1) - at(i + 1) * at(i + 1)) / (4 * h);
    }
};
struct diffusion {
    void operator()(double t, const VectorXd& u, VectorXd& f) const {
        const auto at = [&](int i) { return i < 0 || i >= n ? wave(t, x_of(i)) : u[i]; };
        for (int i = 0; i < n; ++i) f[i] = nu * (at(i - 1) - 2 * at(i) + at(i + 1)) / (h * h);
    }
    stagecraft::bandwidth bandwidth() const { return {1, 1}; }
    bool constant_jacobian() const { return true; }
};

int main() {
    const VectorXd u0 = VectorXd::NullaryExpr(n, [](Eigen::Index i) { return wave(0, x_of(int(i))); });
    const auto r =
        stagecraft::integrate(stagecraft::ark4(), stagecraft::split(transport(), diffusion()), u0, 0, 2);
    std::printf("%s: u(2, 1) = %.3f, the wave %.3f\n", name(r.status), r.y[n / 2], wave(2, x_of(n / 2)));
    std::printf("steps %ld, f_explicit %ld, f_implicit %ld, Jacobians %ld\n", r.report.steps,
                r.report.f_explicit, r.report.f_implicit, r.report.jacobians);
}
