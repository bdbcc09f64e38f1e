// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/plot/coupled_region.hpp"

#include <Eigen/Dense>
#include <stdexcept>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory::plot {

STAGECRAFT_INLINE rational_function coupled_stability_function(const tableaux::partitioned_file& file,
                                                               double z_implicit) {
    const auto s = static_cast<Eigen::Index>(file.stages());
    const auto value = [](const tableaux::entry& e) { return to_double(e.enclosure.middle()); };
    const auto matrix = [&](const tableaux::tableau_file& t, Eigen::Index diagonal) {
        Eigen::MatrixXd a(s, s);
        for (Eigen::Index i = 0; i < s; ++i)
            for (Eigen::Index j = 0; j < s; ++j) {
                a(i, j) = value(t.A[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
                if (j >= i + diagonal && a(i, j) != 0)
                    throw std::invalid_argument(
                        "region: of several tableaux it is drawn for an explicit and a diagonally implicit "
                        "one");
            }
        return a;
    };
    if (file.coupling != tableaux::coupling::additive || file.partners.size() != 2)
        throw std::invalid_argument("region: of several tableaux it is drawn for additive pairs");
    const auto &e = file.partners[0], &im = file.partners[1];
    const Eigen::MatrixXd a_explicit = matrix(e, 0), a_implicit = matrix(im, 1);
    const Eigen::MatrixXd left = Eigen::MatrixXd::Identity(s, s) - z_implicit * a_implicit;
    for (Eigen::Index i = 0; i < s; ++i)
        if (left(i, i) == 0) throw std::invalid_argument("implicit: a stage has no solution there");
    const auto solve = left.triangularView<Eigen::Lower>();
    Eigen::VectorXd b_explicit(s), b_implicit(s);
    for (Eigen::Index i = 0; i < s; ++i) {
        b_explicit(i) = value(e.b[static_cast<std::size_t>(i)]);
        b_implicit(i) = value(im.b[static_cast<std::size_t>(i)]);
    }
    rational_function r{std::vector<double>(static_cast<std::size_t>(s) + 1, 0.0), {1.0}};
    r.numerator[0] = 1;
    Eigen::VectorXd y = solve.solve(Eigen::VectorXd::Ones(s));  // coefficient of z^k in the stages
    for (Eigen::Index k = 0; k < s; ++k) {
        r.numerator[static_cast<std::size_t>(k)] += z_implicit * b_implicit.dot(y);
        r.numerator[static_cast<std::size_t>(k) + 1] += b_explicit.dot(y);
        y = solve.solve(a_explicit * y);
    }
    while (r.numerator.size() > 1 && std::abs(r.numerator.back()) < 1e-14) r.numerator.pop_back();
    return r;
}

}  // namespace stagecraft::theory::plot
