// SPDX-License-Identifier: BSL-1.0
// says: options have the names that they have for integrate()
// lines: 11
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/sensitivity/forward.hpp>

using Eigen::Vector2d;

const auto problem = [](const auto&, const auto& y, const auto& p, auto& f) { f = p[0] * y; };
const Eigen::Matrix<double, 1, 1> p(2.0);

auto run() {
    return stagecraft::sensitivities(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), p, 0, 1,
                                     {.tol = 1e-9});
}
