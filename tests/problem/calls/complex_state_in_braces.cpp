// SPDX-License-Identifier: BSL-1.0
// says: y0 must be a vector with its type, a named Eigen::Vector2cd
// lines: 8
#include <complex>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() {
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem,
                                 {std::complex<double>(1, 0), std::complex<double>(0, 1)}, 0, 1);
}
