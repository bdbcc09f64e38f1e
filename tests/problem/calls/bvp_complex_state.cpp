// SPDX-License-Identifier: BSL-1.0
// says: solve_bvp: y is real
// lines: 9
#include <complex>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using stagecraft::gauss;

const auto f = [](const auto&, const auto& y, auto& d) {
    d[0] = y[1], d[1] = std::complex<double>(0, 1) * y[0];
};
const auto ends = [](const auto& left, const auto& right, auto& r) { r[0] = left[0] - 1., r[1] = right[0]; };

auto run() {
    return stagecraft::solve_bvp(gauss<3>(), stagecraft::two_point(f, ends), 0, 1, Eigen::Vector2cd(1, 0));
}
