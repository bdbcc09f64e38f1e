// SPDX-License-Identifier: BSL-1.0
// Stabilised explicit methods on diffusion, beside our Radau IIA with a sparse factorisation. (ARKODE has such methods from 7.2
// on only.) All take the right-hand side as the same function.
#include <functional>

#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/linear/klu.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>
#include <stagecraft/stabilised.hpp>

#include "compete.hpp"

namespace {

using Eigen::VectorXd;
using right_hand_side = std::function<void(double, const VectorXd&, VectorXd&)>;

struct diffusive_problem {
    std::string name;
    int m, species;  // a grid of m x m, the species of a cell after each other
    double t1;
    VectorXd start;
    right_hand_side f;
};

/// A front that moves and diffuses, u_t = 0.05 Lap u + 10 u^2 (1 - u), without flux.
diffusive_problem front(int m) {
    const double d = 0.05 * m * m;
    const auto f = [=](double, const VectorXd& u, VectorXd& out) {
        for (int j = 0; j < m; ++j)
            for (int i = 0; i < m; ++i) {
                const int at = i + m * j;
                const double here = u[at];
                const double around = (i > 0 ? u[at - 1] : here) + (i < m - 1 ? u[at + 1] : here) +
                                      (j > 0 ? u[at - m] : here) + (j < m - 1 ? u[at + m] : here);
                out[at] = d * (around - 4 * here) + 10 * here * here * (1 - here);
            }
    };
    VectorXd start(m * m);
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < m; ++i)
            start[i + m * j] = std::exp(-20 * (std::pow((i + 0.5) / m, 2) + std::pow((j + 0.5) / m, 2)));
    return {"front-2d", m, 1, 1.0, start, f};
}

/// A fuel c that burns at the temperature T: the combustion problem of Sommeijer, Shampine and Verwer (1998) in two
/// dimensions, c_t = Lap c - D c e^(-20/T), 0.9 T_t = Lap T + D c e^(-20/T), D = 5 e^20/20; c = T = 1 on the far sides, no flux
/// on the near ones.
diffusive_problem combustion(int m) {
    const double d = 1.0 * m * m, D = 5 * std::exp(20.0) / 20;
    const auto f = [=](double, const VectorXd& y, VectorXd& out) {
        const auto species = [&](int at, int i, int j) {
            const double here = y[at];
            return d * ((i > 0 ? y[at - 2] : here) + (i < m - 1 ? y[at + 2] : 1) +
                        (j > 0 ? y[at - 2 * m] : here) + (j < m - 1 ? y[at + 2 * m] : 1) - 4 * here);
        };
        for (int j = 0; j < m; ++j)
            for (int i = 0; i < m; ++i) {
                const int at = 2 * (i + m * j);
                const double burnt = D * y[at] * std::exp(-20 / y[at + 1]);
                out[at] = species(at, i, j) - burnt;
                out[at + 1] = (species(at + 1, i, j) + burnt) / 0.9;
            }
    };
    return {"combustion-2d", m, 2, 0.3, VectorXd::Ones(2 * m * m), f};
}

struct with_pattern {
    using linear_solver = stagecraft::klu_blocks;
    const diffusive_problem* p;
    void operator()(double t, const VectorXd& y, VectorXd& f) const { p->f(t, y, f); }
    Eigen::SparseMatrix<double> sparsity() const {
        std::vector<Eigen::Triplet<double>> entries;
        const int s = p->species, m = p->m, n = s * m * m;
        for (int row = 0; row < n; ++row) {
            const int cell = row / s, i = cell % m;
            for (int k = 0; k < s; ++k) entries.emplace_back(row, cell * s + k, 1);
            if (i > 0) entries.emplace_back(row, row - s, 1);
            if (i < m - 1) entries.emplace_back(row, row + s, 1);
            if (cell >= m) entries.emplace_back(row, row - s * m, 1);
            if (cell < m * (m - 1)) entries.emplace_back(row, row + s * m, 1);
        }
        Eigen::SparseMatrix<double> pattern(n, n);
        pattern.setFromTriplets(entries.begin(), entries.end());
        return pattern;
    }
};

template <class Method, class Rhs>
outcome run_on(const Method& method, const Rhs& f, const diffusive_problem& p, double tolerance) {
    const auto r = stagecraft::integrate(method, f, p.start, 0.0, p.t1,
                                         {.rtol = tolerance, .atol = tolerance, .max_steps = 1000000});
    outcome out = outcome_of(r);
    out.f += r.report.f_jacobian;
    return out;
}

void compete_on(const diffusive_problem& p, const settings& set, std::vector<curve>& curves) {
    if (!wanted(set.problems, p.name)) return;
    const with_pattern sparse{&p};
    const auto exact = run_on(stagecraft::radau_iia<3>(), sparse, p, 1e-9).y;
    const auto error = [&](const VectorXd& y) { return scaled_error(y, exact, 1); };
    std::vector<entrant> all = {
        {"stagecraft rkc2", [&](double tol, double) { return run_on(stagecraft::rkc2(), p.f, p, tol); }},
        {"stagecraft rkl2", [&](double tol, double) { return run_on(stagecraft::rkl2(), p.f, p, tol); }},
        {"stagecraft rkg2", [&](double tol, double) { return run_on(stagecraft::rkg2(), p.f, p, tol); }},
        {"stagecraft s=3",
         [&](double tol, double) { return run_on(stagecraft::radau_iia<3>(), sparse, p, tol); }}};
    const curve kind{p.name, "", static_cast<int>(exact.size()), false, false, {}};
    measure_all(kind, all, p.t1, 1e-6, error, set, curves);
}

}  // namespace

void compete_on_stabilised(const settings& set, std::vector<curve>& curves) {
    compete_on(front(64), set, curves);
    compete_on(combustion(40), set, curves);
}
