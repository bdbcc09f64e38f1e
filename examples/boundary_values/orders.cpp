// SPDX-License-Identifier: BSL-1.0
// Chapter 6: orders of collocation at mesh points and, by the lifted solution, between them; and what becomes of growing modes.
#include <stagecraft/families.hpp>

#include "experiments.hpp"

namespace boundary_values {

namespace {

/// Nodes 1 - c: the adjoint method.
tableau<double> reflected(const tableau<double>& m) {
    tableau<double> r = m;
    const int s = m.stages();
    for (int i = 0; i < s; ++i) {
        r.b[i] = m.b[s - 1 - i], r.c[i] = 1 - m.c[s - 1 - i];
        for (int j = 0; j < s; ++j) r.A(i, j) = m.b[s - 1 - j] - m.A(s - 1 - i, s - 1 - j);
    }
    r.facts = {};
    return r;
}

struct errors {
    double nodes = 0, between = 0;
};

/// y'' = y on [0, 2], y(0) = 1, y(2) = 0, on N equal intervals.
errors of(const tableau<double>& method, int N) {
    const linear_rhs f{[](double) {
                           return MatrixXd(Eigen::Matrix2d{{0, 1}, {1, 0}});
                       },
                       [](double) { return VectorXd(VectorXd::Zero(2)); }};
    const linear_conditions r{Eigen::Matrix2d{{1, 0}, {0, 0}}, Eigen::Matrix2d{{0, 0}, {1, 0}},
                              Eigen::Vector2d(1, 0)};
    const auto answer =
        solve(method, f, r, 2, {.rtol = 1e-12, .intervals = N, .adapt = false, .conditioning = false});
    errors e;
    for (int k = 0; k < 20 * N; ++k) {
        const double t = k % 20 == 0 ? answer.mesh[k / 20] : 2.0 * k / (20 * N);
        const double error = std::max(std::abs(answer.y(t)[0] - std::sinh(2 - t) / std::sinh(2.0)),
                                      std::abs(answer.y(t)[1] + std::cosh(2 - t) / std::sinh(2.0)));
        double& worst = k % 20 == 0 ? e.nodes : e.between;
        worst = std::max(worst, error);
    }
    return e;
}

}  // namespace

chapter orders() {
    chapter out;
    struct line {
        std::string name;
        tableau<double> method;
        int N, order;
    };
    for (const line& l :
         {line{"Gauss, s = 2", gauss(2), 16, 4}, line{"Gauss, s = 3", gauss(3), 8, 6},
          line{"Lobatto IIIA, s = 3", lobatto_iiia(3), 16, 4},
          line{"Lobatto IIIA, s = 4", lobatto_iiia(4), 8, 6}, line{"Radau IIA, s = 2", radau_iia(2), 64, 3},
          line{"Radau IIA, s = 3", radau_iia(3), 32, 5}}) {
        const errors coarse = of(l.method, l.N), fine = of(l.method, 2 * l.N);
        const double nodes = std::log2(coarse.nodes / fine.nodes),
                     between = std::log2(coarse.between / fine.between);
        out.find(l.name + ": order at mesh points, lifted between them",
                 l.name == "Lobatto IIIA, s = 3" ? "2s - 1 = 5" : "-",
                 number(nodes, "%.2f") + ", " + number(between, "%.2f"), std::to_string(l.order),
                 std::abs(nodes - l.order) < 0.05 && std::abs(between - l.order) < 0.15);
    }
    // x' = lambda (x - cos t) - sin t, x(1) given, lambda = 1e4, ten intervals: the mode that grows has to keep growing.
    const double lambda = 1e4;
    const linear_rhs f{
        [=](double) { return MatrixXd(MatrixXd::Constant(1, 1, lambda)); },
        [=](double t) { return VectorXd(VectorXd::Constant(1, -lambda * std::cos(t) - std::sin(t))); }};
    const MatrixXd one = MatrixXd::Identity(1, 1);
    const linear_conditions at_the_end{0 * one, one, VectorXd::Constant(1, std::cos(1.0))};
    for (const auto& [name, method, right] :
         {std::tuple{"Gauss-3", tableau<double>(gauss(3)), true},
          std::tuple{"Radau IIA-3", tableau<double>(radau_iia(3)), false},
          std::tuple{"Radau IIA-3 reflected", reflected(radau_iia(3)), true}}) {
        const auto answer = solve(method, f, at_the_end, 1,
                                  {.rtol = 1e-6, .intervals = 10, .adapt = false, .conditioning = false});
        double error = 0;
        for (const double t : answer.mesh) error = std::max(error, std::abs(answer.y(t)[0] - std::cos(t)));
        out.find(std::string("growing mode, lambda = 1e4, ten intervals: ") + name, "-",
                 number(error, "%.0e") + ", " + stagecraft::name(answer.status),
                 right ? "right: di-stable or |R| > 1" : "destroyed",
                 right ? error < 1e-5 : error > 1 && !answer.ok());
    }
    return out;
}

}  // namespace boundary_values
