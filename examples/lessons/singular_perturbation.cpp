// SPDX-License-Identifier: BSL-1.0
// A singular perturbation problem: an enzyme is fast, its substrate slow. y' = f(y, z), eps z' = g(y, z), with eps in the mass
// matrix and not under g, so that eps = 0, the reduced problem, is the same program: there 0 = g gives z = y / (y + 1).
#include <cmath>
#include <cstdio>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/regularisation/singular_perturbation.hpp>

struct enzyme {
    static constexpr int slow = 1, fast = 1;
    template <class V>
    V f(const V& y, const V& z) const {
        return V(-y[0] + (y[0] + 0.5) * z[0]);
    }
    template <class V>
    V g(const V& y, const V& z) const {
        return V(y[0] - (y[0] + 1.0) * z[0]);
    }
};

// The reduced problem is y' = -y / (2 (y + 1)), so that y + log y = 1 - t / 2 from y(0) = 1.
double reduced(double t) {
    double y = 1;
    for (int k = 0; k < 50; ++k) y -= (y + std::log(y) - 1 + t / 2) / (1 + 1 / y);
    return y;
}

int main() {
    std::puts("eps      steps   of them in t < 20 eps   off the reduced y(1)");
    for (const double eps : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 0.0}) {
        int in_layer = 0;  // z starts at 0 and jumps to 1/2 as exp(-2 t / eps)
        const auto count = [&](double t, const auto&) { in_layer += t < 20 * eps; };
        const auto r = stagecraft::integrate(
            stagecraft::radau_iia<3>(), stagecraft::perturbed(enzyme{}, eps), Eigen::Vector2d(1, 0), 0, 1,
            {.rtol = 1e-10, .atol = 1e-10, .consistent_start = eps == 0}, count);
        std::printf("%-8g %-7ld %-24d %.1e\n", eps, r.report.steps, in_layer, std::abs(r.y[0] - reduced(1)));
    }
}
