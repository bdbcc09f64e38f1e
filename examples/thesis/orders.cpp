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

trajectory equal_steps(const setup& s, int stages, long steps) {
    return solve(s, {.stages = stages, .tolerance = 1e-13, .steps = steps});
}

errors at_end(const vector& run, const vector& reference) {
    const vector d = run - reference;
    return {d.head(10).cwiseAbs().maxCoeff(), d.tail(2).cwiseAbs().maxCoeff()};
}

errors compare(const trajectory& run, const trajectory& reference) {
    errors e;
    const std::size_t stride = (run.path.size() - 1) / marks, fine = (reference.path.size() - 1) / marks;
    for (std::size_t k = 1; k <= marks; ++k) {
        const errors here = at_end(run.path[k * stride].y, reference.path[k * fine].y);
        e = {here.y_end, here.lambda_end, std::max(e.y_max, here.y_end),
             std::max(e.lambda_max, here.lambda_end)};
    }
    return e;
}

struct method {
    int stages;
    long coarsest, first, last;  // numbers of steps: of the largest h, and of those that are fitted
    const char *figure_y, *figure_lambda;
    double printed_y, printed_lambda;
    double theory_y, theory_lambda;
};

// One of the two components: its errors over h.
struct component {
    const char* name;
    std::string number;
    double printed, theory;
    std::vector<double> over_t, at_end;  ///< over the h that are fitted
    curve whole = {};                    ///< the error at t = 1, from the coarsest h on
    double lowest = 1e300, highest = 0;  ///< slope at t = 1 between neighbouring h, the thesis' range of h
};

void note_slope(component& c, double coarser, double finer, double ratio) {
    const double local = std::log(coarser / finer) / std::log(ratio);
    c.lowest = std::min(c.lowest, local);
    c.highest = std::max(c.highest, local);
}

void note(component& y, component& lambda, long steps, const errors& e) {
    for (component* c : {&y, &lambda}) c->whole.x.push_back(1.0 / static_cast<double>(steps));
    y.whole.y.push_back(e.y_end);
    lambda.whole.y.push_back(e.lambda_end);
}

// The error at t = 1, which the thesis shows, at steps too long to be asymptotic.
void coarse_steps(const setup& dae, const method& m, const vector& exact, component& y, component& lambda) {
    errors last;
    long before = 0;
    for (double n = static_cast<double>(m.coarsest); n < static_cast<double>(m.first); n *= std::sqrt(2.0)) {
        const long steps = std::lround(n);
        const errors e = at_end(equal_steps(dae, m.stages, steps).path.back().y, exact);
        note(y, lambda, steps, e);
        if (before > 0) {
            const double ratio = static_cast<double>(steps) / static_cast<double>(before);
            note_slope(y, last.y_end, e.y_end, ratio);
            note_slope(lambda, last.lambda_end, e.lambda_end, ratio);
        }
        last = e;
        before = steps;
    }
}

void report(outcome& o, const component& c, const std::string& label, const std::vector<double>& h) {
    const double order = slope(h, c.over_t), end = slope(h, c.at_end);
    std::string file = "fig_" + c.number;
    std::replace(file.begin(), file.end(), '.', '_');
    figure f{file, c.number + " " + label + ", error in " + c.name, "h [s]", "error", true, true, {}};
    f.slopes = {{c.theory, 0}};
    f.curves.push_back({"maximum over t, order " + decimal(order), h, c.over_t, true});
    f.curves.push_back({"at t = 1, slope " + decimal(end), c.whole.x, c.whole.y, true});
    o.figures.push_back(f);
    // At t = 1 the disc is upright; a fit over h there need not be an order. As h -> 0 its local slopes tend
    // to the order in the maximum.
    const bool within = c.printed >= std::min(c.lowest, order) && c.printed <= c.highest;
    const std::string reason =
        "a fit at t = 1, where local slopes run from " + decimal(c.lowest) + " to " + decimal(c.highest);
    o.findings.push_back({c.number + " order of " + c.name + ", " + label, general(c.printed),
                          decimal(order) + " (t=1: " + decimal(end) + ")", decimal(c.theory),
                          std::abs(order - c.theory) < 0.1,
                          compared(c.printed, order, 0.05, reason, within)});
}

}  // namespace

outcome orders_of_convergence() {
    outcome o{"Orders with equal steps (figures 4.7 to 4.12)", {}, {}, {}};
    const setup dae = disc_dae();
    const trajectory reference = equal_steps(dae, 7, 2000);
    // The thesis goes from h = 10^-1.5 to 1e-4. Implicit Euler is asymptotic only below h = 5e-4.
    const method methods[] = {{3, 45, 200, 1600, "4.7", "4.8", 4.82, 4.79, 5, 3},
                              {1, 708, 3200, 25600, "4.9", "4.10", 1.198, 1.379, 1, 1},
                              {2, 45, 400, 25600, "4.11", "4.12", 3.016, 2.661, 3, 2}};
    for (const method& m : methods) {
        component y{"q, q'", m.figure_y, m.printed_y, m.theory_y, {}, {}},
            lambda{"λ", m.figure_lambda, m.printed_lambda, m.theory_lambda, {}, {}};
        std::vector<double> h;
        const std::string label = "Radau IIA-" + std::to_string(m.stages);
        o.text += label + "          h    y at t=1    lambda at t=1    max y    max lambda\n";
        coarse_steps(dae, m, reference.path.back().y, y, lambda);
        for (long steps = m.first; steps <= m.last; steps *= 2) {
            const errors e = compare(equal_steps(dae, m.stages, steps), reference);
            if (!h.empty()) {
                note_slope(y, y.at_end.back(), e.y_end, 2);
                note_slope(lambda, lambda.at_end.back(), e.lambda_end, 2);
            }
            h.push_back(1.0 / static_cast<double>(steps));
            note(y, lambda, steps, e);
            if (m.stages == 1 && steps < m.last) {  // between them the error of lambda dips
                const long between = std::lround(std::sqrt(2.0) * static_cast<double>(steps));
                note(y, lambda, between,
                     at_end(equal_steps(dae, 1, between).path.back().y, reference.path.back().y));
            }
            y.over_t.push_back(e.y_max);
            y.at_end.push_back(e.y_end);
            lambda.over_t.push_back(e.lambda_max);
            lambda.at_end.push_back(e.lambda_end);
            o.text += "             " + scientific(h.back()) + "   " + scientific(e.y_end) + "   " +
                      scientific(e.lambda_end) + "   " + scientific(e.y_max) + "   " +
                      scientific(e.lambda_max) + "\n";
        }
        o.text += "  local slopes at t = 1 from h = " + scientific(1.0 / static_cast<double>(m.coarsest)) +
                  " on: y " + decimal(y.lowest) + " to " + decimal(y.highest) + ", lambda " +
                  decimal(lambda.lowest) + " to " + decimal(lambda.highest) + "\n\n";
        report(o, y, label, h);
        report(o, lambda, label, h);
    }
    return o;
}

}  // namespace thesis
