// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <stagecraft/dae/hessenberg.hpp>
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/model_assumptions.hpp>
#include <stagecraft/mechanics/regularisation/regularisation_conditions.hpp>

#include <problems/rolling_disc/disc.hpp>
#include <problems/thesis/limits.hpp>
#include <problems/thesis/nonholonomic.hpp>
#include "experiments.hpp"

namespace thesis {

namespace {

using vector5 = Eigen::Matrix<double, 5, 1>;

void indices(outcome& o) {
    const thesis::pendulum swing;
    struct system_case {
        const char* name;
        any_problem problem;
        vector y;
        int index;
    };
    const setup dae = disc_dae(), soft = disc_regularised(form::mass_matrix, 1e-8, 0.5),
                explicit_form = disc_regularised(form::multiplier, 1e-8, 0.5);
    const system_case cases[] = {
        {"disc, index-reduced", disc_reduced().problem, disc_reduced().y0, 0},
        {"disc, regularised, (y, lambda)", explicit_form.problem, explicit_form.y0, 0},
        {"disc, regularised, mass matrix, eps = 1e-8", soft.problem, soft.y0, 1},
        {"disc, 0 = G(q) q'", dae.problem, dae.y0, 2},
        {"pendulum, 0 = G(q) q'", erased(stagecraft::index_2(swing)), vector::Unit(5, 0), 2},
        {"pendulum, stabilised", erased(stagecraft::stabilised_index_2(swing)), vector::Unit(6, 0), 2},
        {"pendulum, 0 = g(q)", erased(stagecraft::index_3(swing)), vector::Unit(5, 0), 3}};
    o.text += "\nDifferentiation and perturbation index of the forms at their initial states\n";
    for (const system_case& c : cases) {
        const auto form = stagecraft::hessenberg_index(c.problem, 0.0, c.y);
        o.text += "  " + std::string(c.name) + ": " + std::to_string(form.differentiation_index) + " and " +
                  std::to_string(form.perturbation_index) + ", condition " + scientific(form.condition) +
                  "\n";
        o.findings.push_back({std::string("index, ") + c.name, c.index == 2 ? "2" : "",
                              std::to_string(form.differentiation_index), std::to_string(c.index),
                              form.differentiation_index == c.index && form.perturbation_index == c.index,
                              compared(form.differentiation_index == 2)});
    }
}

// Definition 1.2 on the disc: how y and lambda answer to a defect 1e-6 sin(w t) in f or in g, as powers of w. One
// derivative of the defect of g reaches lambda, and that makes the perturbation index 2.
void defects(outcome& o) {
    struct equation {
        const char* name;
        int first, rows;
        double theory_y, theory_lambda;
    };
    for (const equation& e : {equation{"f", 5, 5, -1, 0}, equation{"g", 10, 2, 0, 1}}) {
        const defect_growth seen = growth_with_frequency(e.first, e.rows);
        const auto line = [&](const char* what, double power, double theory) {
            o.findings.push_back({std::string("Definition 1.2, defect sin(w t) of ") + e.name + ": " + what,
                                  "", "w^" + decimal(power), "w^" + general(theory),
                                  std::abs(power - theory) < 0.1});
        };
        line("y", seen.y, e.theory_y);
        line("lambda", seen.lambda, e.theory_lambda);
    }
}

}  // namespace

outcome assumptions() {
    outcome o{"Model assumptions, logarithmic norms and indices along the motion", {}, {}, {}};
    const rolling_disc::disc<> body;
    const double c = 2, d = 2;
    const trajectory run = solve(disc_dae(), {.tolerance = 1e-8});
    auto worst = stagecraft::check_assumptions(body, vector5(run.path[0].y.head<5>()));
    auto tightest = stagecraft::conditions(body, vector5(run.path[0].y.head<5>()), c, d);
    curve condition{"condition of g_y f_λ", {}, {}, false}, mu{"-μ(-G M^{-1} G^T)", {}, {}, false},
        pivot{"smallest pivot of M / largest", {}, {}, false};
    bool all = true, norms_agree = true;
    double off = 0;  // from max(s/3, 3/s), s = 5/(5 - 4 cos^2 beta): G M^-1 G^T = diag(3, s)
    for (const auto& p : run.path) {
        const vector5 q = p.y.head<5>(), v = p.y.segment<5>(5);
        const auto a = stagecraft::check_assumptions(body, q, v, Eigen::Vector2d(p.y.tail<2>()), p.t);
        const auto r = stagecraft::conditions(body, q, c, d);
        all = all && a.hold();
        worst = worst_of(worst, a);
        if (r.constraint.euclidean > tightest.constraint.euclidean) tightest = r;
        const auto& m = r.constraint;
        norms_agree =
            norms_agree && std::abs(m.one - m.euclidean) < 1e-9 && std::abs(m.infinity - m.euclidean) < 1e-9;
        const double s = 5 / (5 - 4 * std::pow(std::cos(q[3]), 2));
        off = std::max(off, std::abs(a.inertia_condition - std::max(s / 3, 3 / s)));
        for (curve* k : {&condition, &mu, &pivot}) k->x.push_back(p.t);
        condition.y.push_back(a.inertia_condition);
        mu.y.push_back(-m.euclidean);
        pivot.y.push_back(a.smallest_pivot);
    }
    o.text = "Worst values over " + std::to_string(run.path.size()) + " states of the rolling disc\n" +
             "  1  asymmetry of M                      " + scientific(worst.asymmetry) + "\n" +
             "  1  smallest pivot of M / largest       " + scientific(worst.smallest_pivot) + "\n" +
             "  2  smallest singular value of G / largest  " + scientific(worst.constraint_rank) + "\n" +
             "  3  condition of g_y f_lambda           " + decimal(worst.inertia_condition) + "\n" +
             "  4  derivative against a difference     " + scientific(worst.derivative_defect) + "\n" +
             "  5  largest entry of f_y, f_lambda, g_y " + scientific(worst.derivative_bound) + "\n" +
             "Conditions on the damper, c = d = 2, where they are tightest\n  " + tightest.report();
    o.findings = {
        {"model assumptions 1 to 5 along the motion", "hold", all ? "hold" : "fail", "hold", all,
         compared(all)},
        {"condition of g_y f_lambda, largest", "", decimal(worst.inertia_condition), "< 3",
         worst.inertia_condition < 3 + 1e-9},
        {"  distance to that of diag(3, 5/(5 - 4 cos^2 beta))", "", scientific(off), "0", off < 1e-8},
        {"mu(-G M^-1 G^T), largest, Euclidean norm", "<= -1", decimal(tightest.constraint.euclidean), "<= -1",
         tightest.constraint.euclidean <= -1, compared(tightest.constraint.euclidean <= -1)},
        {"the same in the 1- and the infinity-norm", "", norms_agree ? "same" : "other", "same", norms_agree},
        {"mu(g_lambda) < 0 and (3.61)", "hold", tightest.principal_damping() ? "hold" : "fail", "hold",
         tightest.strong_damping() && tightest.principal_damping(), compared(tightest.principal_damping())}};
    o.figures = {{"fig_assumptions",
                  "Model assumptions along the motion",
                  "t [s]",
                  "condition, -μ [1/kg], pivot",
                  false,
                  true,
                  {condition, mu, pivot}}};
    indices(o);
    defects(o);
    return o;
}

}  // namespace thesis
