// SPDX-License-Identifier: BSL-1.0
// Sensitivities: how the end of Robertson's reaction depends on its three rates, forward and by the adjoint.
#include <cmath>
#include <iomanip>
#include <iostream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/sensitivity/adjoint.hpp>
#include <stagecraft/sensitivity/forward.hpp>

int main() {
    using namespace stagecraft;
    using Eigen::Vector3d;
    const auto robertson = [](const auto&, const auto& y, const auto& k, auto& f) {
        const auto a = k[0] * y[0], b = k[1] * y[1] * y[2], c = k[2] * y[1] * y[1];
        f << b - a, a - b - c, c;
    };
    const Vector3d y0(1, 0, 0), k(0.04, 1e4, 3e7);
    const options<double> o{.rtol = 1e-8, .atol = 1e-12};

    // dy/dk, three columns at the cost of some solves a step; times k: what a per cent changes.
    const auto forward = sensitivities(radau_iia<3>(), robertson, y0, k, 0, 40, o);
    std::cout << std::scientific << std::setprecision(3) << "k dy/dk =\n"
              << forward.S * k.asDiagonal() << '\n';

    // The gradient of one number at the end costs the same for any number of parameters. The steps are those of y, so it says
    // itself how accurate it is.
    const auto product = [](const auto& y) { return y[2]; };
    const auto back = adjoint_gradient(radau_iia<3>(), robertson, y0, k, 0, 40, product, o);
    const Vector3d difference = back.dp - forward.S.row(2).transpose();
    const bool near = (difference.array().abs() <= 3 * back.dp_error.array()).all();
    std::cout << "k dg/dk = " << back.dp.cwiseProduct(k).transpose() << '\n'
              << "the same as far as its error estimate says: " << (near ? "yes" : "no") << '\n';
}
