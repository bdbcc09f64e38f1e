// SPDX-License-Identifier: BSL-1.0
// What needs Eigen alone: y' = -y over one unit of time.
#include <cmath>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

int main() {
    using state = Eigen::Matrix<double, 1, 1>;
    const auto decay = [](double, const state& y, state& f) { f = -y; };
    const auto run = stagecraft::integrate(stagecraft::radau_iia<3>(), decay, state(1.0), 0.0, 1.0,
                                           {.rtol = 1e-8, .atol = 1e-12});
    return run.status == stagecraft::status::success && std::abs(run.y[0] - std::exp(-1.0)) < 1e-6 ? 0 : 1;
}
