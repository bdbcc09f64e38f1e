// SPDX-License-Identifier: BSL-1.0
// Nodes of your own: collocation at 1/5, 3/5 and 1, constructed exactly, rounded once, and run on a stiff
// problem. The last node is 1, hence the method is stiffly accurate; transformed() needs nodes without 0.
#include <cmath>
#include <iostream>
#include <stagecraft/integrate.hpp>
#include <stagecraft/tableaux/rounded.hpp>

int main() {
    using namespace stagecraft::tableaux;
    const auto nodes = nodal_polynomial::from_nodes({rational(1, 5), rational(3, 5), 1});
    const auto method = transformed<double>(nodes, construction::collocation);
    std::cout << "b = " << method.b.transpose() << "\nA =\n" << method.A << '\n';

    // Prothero and Robinson's problem: y = cos t, whatever the stiffness is.
    const auto stiff = [](double t, const auto& y, auto& f) { f[0] = -1e6 * (y[0] - cos(t)) - sin(t); };
    const Eigen::Matrix<double, 1, 1> y0(1.0);
    for (const double h : {0.2, 0.1, 0.05}) {
        const auto r = stagecraft::integrate(method, stiff, y0, 0, 1, {.fixed_step = h});
        std::cout << "h = " << h << ": error " << std::abs(r.y[0] - std::cos(1.0)) << '\n';
    }
}
