// SPDX-License-Identifier: BSL-1.0
// Threads: a run has no state outside of itself, so that each thread integrates for itself. Methods may be
// shared; problems may be if their members are const.
#include <cstdio>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <thread>
#include <vector>

int main() {
    using Eigen::Vector2d;
    const auto method = stagecraft::radau_iia<3>();
    const std::vector<double> mu{1, 10, 100, 1000};
    std::vector<double> end(mu.size());
    {
        std::vector<std::jthread> sweep;
        for (std::size_t k = 0; k < mu.size(); ++k)
            sweep.emplace_back([&, k] {
                const auto van_der_pol = [&](double, const Vector2d& y, Vector2d& f) {
                    f << y[1], mu[k] * (1 - y[0] * y[0]) * y[1] - y[0];
                };
                const auto r = stagecraft::integrate(method, van_der_pol, Vector2d(2, 0), 0, 1);
                end[k] = r.ok() ? r.y[0] : 0.0 / 0.0;
            });
    }  // a jthread joins where it ends
    for (std::size_t k = 0; k < mu.size(); ++k) std::printf("mu = %4.0f: y(1) = %.5f\n", mu[k], end[k]);
}
