// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <problems/thesis/solve.hpp>
#include "experiments.hpp"

namespace thesis {

namespace {

constexpr int marks = 200;  // times t = k/200 at which runs with equal steps are compared

struct errors {
    double y_end = 0, lambda_end = 0, y_max = 0, lambda_max = 0;
};

trajectory equal_steps(const setup& s, family method, int stages, long steps) {
    return solve(s, {.method = method, .stages = stages, .tolerance = 1e-13, .steps = steps});
}

errors compare(const setup& s, const trajectory& run, const trajectory& reference) {
    errors e;
    const std::size_t stride = (run.path.size() - 1) / marks, fine = (reference.path.size() - 1) / marks;
    for (std::size_t k = 1; k <= marks; ++k) {
        const vector &a = run.path[k * stride].y, &b = reference.path[k * fine].y;
        e.y_end = (a.head(10) - b.head(10)).cwiseAbs().maxCoeff();
        e.lambda_end = (s.multiplier(a) - s.multiplier(b)).cwiseAbs().maxCoeff();
        e.y_max = std::max(e.y_max, e.y_end);
        e.lambda_max = std::max(e.lambda_max, e.lambda_end);
    }
    return e;
}

}  // namespace

outcome orders_of_convergence() {
    outcome o{"Orders with equal steps (figures 4.7 to 4.12)", {}, {}, {}};
    const setup dae = disc_dae();
    const trajectory reference = equal_steps(dae, family::radau_iia, 7, 2000);
    struct method {
        int stages;
        long first, last;
        const char *figure_y, *figure_lambda, *printed_y, *printed_lambda;
        double theory_y, theory_lambda;
    };
    // Implicit Euler is asymptotic only below h = 5e-4.
    const method methods[] = {{3, 200, 1600, "4.7", "4.8", "4.82", "4.79", 5, 3},
                              {1, 3200, 25600, "4.9", "4.10", "1.198", "1.379", 1, 1},
                              {2, 400, 6400, "4.11", "4.12", "3.016", "2.661", 3, 2}};
    for (const method& m : methods) {
        std::vector<double> h, y_end, lambda_end, y_max, lambda_max;
        o.text += "Radau IIA-" + std::to_string(m.stages) +
                  "          h    y at t=1    lambda at t=1    max y    max lambda\n";
        for (long steps = m.first; steps <= m.last; steps *= 2) {
            const errors e = compare(dae, equal_steps(dae, family::radau_iia, m.stages, steps), reference);
            h.push_back(1.0 / static_cast<double>(steps));
            y_end.push_back(e.y_end);
            lambda_end.push_back(e.lambda_end);
            y_max.push_back(e.y_max);
            lambda_max.push_back(e.lambda_max);
            o.text += "             " + scientific(h.back()) + "   " + scientific(e.y_end) + "   " +
                      scientific(e.lambda_end) + "   " + scientific(e.y_max) + "   " +
                      scientific(e.lambda_max) + "\n";
        }
        const std::string label = "Radau IIA-" + std::to_string(m.stages);
        const auto draw = [&](const std::string& number, const char* what, const std::vector<double>& over_t,
                              const std::vector<double>& at_end) {
            std::string name = "fig_" + number;
            std::replace(name.begin(), name.end(), '.', '_');
            o.figures.push_back({name,
                                 number + " " + label + ", error in " + what,
                                 "h [s]",
                                 "error",
                                 true,
                                 true,
                                 {{"maximum over t", h, over_t, true}, {"at t = 1", h, at_end, true}}});
        };
        draw(m.figure_y, "q, q'", y_max, y_end);
        draw(m.figure_lambda, "λ", lambda_max, lambda_end);
        const double by = slope(h, y_max), bl = slope(h, lambda_max);
        o.text += "  slopes at t = 1: y " + decimal(slope(h, y_end)) + ", lambda " +
                  decimal(slope(h, lambda_end)) + "; in the maximum over t: y " + decimal(by) + ", lambda " +
                  decimal(bl) + "\n\n";
        o.findings.push_back({std::string(m.figure_y) + " order of y, " + label, m.printed_y,
                              decimal(by) + " (t=1: " + decimal(slope(h, y_end)) + ")", decimal(m.theory_y),
                              std::abs(by - m.theory_y) < 0.1});
        o.findings.push_back({std::string(m.figure_lambda) + " order of lambda, " + label, m.printed_lambda,
                              decimal(bl) + " (t=1: " + decimal(slope(h, lambda_end)) + ")",
                              decimal(m.theory_lambda), std::abs(bl - m.theory_lambda) < 0.1});
    }
    return o;
}

}  // namespace thesis
