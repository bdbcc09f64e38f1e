// SPDX-License-Identifier: BSL-1.0
// A tableau of your own, from a file to a run. Edit own_tableau.json: the orders are found again, in exact
// arithmetic, and the pair of methods is run with step size control.
#include <iostream>
#include <stagecraft/integrate.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/tableaux/tableau_from_file.hpp>
#include <stagecraft/theory/models/matrix_model.hpp>
#include <stagecraft/theory/trees/tree_order.hpp>

int main() {
    const auto file = stagecraft::tableaux::read_tableau_file("own_tableau.json");

    // What it is: the entries as rational numbers, and the order conditions of all rooted trees.
    using namespace stagecraft::theory;
    const auto exact = stagecraft::tableaux::to_rational(file);
    std::cout << file.name << "\norder " << order_of(matrix_model(exact), 10).order << ", embedded "
              << order_of(matrix_model(exact, exact.b_embedded), 10).order << '\n';

    // What it does: the nearest doubles, on the predator-prey equations.
    const auto method = stagecraft::tableaux::rounded(file);
    const auto rabbits_and_foxes = [](double, const Eigen::Vector2d& y, Eigen::Vector2d& f) {
        f << y[0] * (1 - y[1]), y[1] * (y[0] - 1);
    };
    const auto r = stagecraft::integrate(method, rabbits_and_foxes, Eigen::Vector2d(2, 1), 0, 10,
                                         {.rtol = 1e-6, .atol = 1e-8});
    std::cout << name(r.status) << ": " << r.y.transpose() << " at t = " << r.t << '\n';
}
