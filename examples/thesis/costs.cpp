// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <problems/thesis/solve.hpp>
#include "experiments.hpp"

namespace thesis {

namespace {

curve step_sizes(const std::string& title, const trajectory& run) {
    curve c{title, {}, {}, false};
    for (std::size_t k = 1; k < run.path.size(); ++k)
        c.x.push_back(run.path[k].t), c.y.push_back(run.path[k].h);
    return c;
}

// At every step of a run, its size over that of the step which another run takes there: the curves of both would
// hide each other.
curve step_ratio(const std::string& title, const trajectory& run, const trajectory& other) {
    curve c{title, {}, {}, false};
    std::size_t there = 1;
    for (std::size_t k = 1; k < run.path.size(); ++k) {
        while (other.path[there].t < run.path[k].t && there + 1 < other.path.size()) ++there;
        c.x.push_back(run.path[k].t);
        c.y.push_back(run.path[k].h / other.path[there].h);
    }
    return c;
}

}  // namespace

outcome regularised_runs() {
    outcome o{"Regularised runs at eps = 1e-8 (figures 4.22 to 4.25)", {}, {}, {}};
    const trajectory dae = solve(disc_dae(), {.tolerance = 1e-10});
    std::vector<figure> violations, steps;
    figure ratio{"fig_4_24_ratio",
                 "4.24, 4.25 Step sizes over those of the index-2 system at the same t",
                 "t [s]",
                 "h / h of the index-2 system",
                 false,
                 false,
                 {}};
    for (const double kappa : {1.0, 0.5}) {
        const std::string title = kappa == 1 ? "strong damping" : "principal damping";
        const setup soft = disc_regularised(form::mass_matrix, 1e-8, kappa);
        const trajectory run = solve(soft, {.tolerance = 1e-10}),
                         longer = solve(soft, {.tolerance = 1e-10, .end = 10});
        curve c{title, {}, {}, false};
        double early = 0, late = 0;  // largest in the first and in the last two seconds of ten
        for (const auto& p : longer.path) {
            const double u = disc_constraint(p.y).norm();
            if (p.t < 2) early = std::max(early, u);
            if (p.t > 8) late = std::max(late, u);
            c.x.push_back(p.t);
            c.y.push_back(u);
        }
        const std::string v = kappa == 1 ? "4.22" : "4.23", h = kappa == 1 ? "4.24" : "4.25";
        const auto over_time = [](const std::string& number, const std::string& what, const char* y,
                                  curve of) {
            return figure{
                "fig_4_" + number.substr(2), number + what, "t [s]", y, false, true, {std::move(of)}};
        };
        violations.push_back(
            over_time(v, " Constraint violation over 10 s, " + title + ", ε = 10^{-8}", "|G q'| [m/s]", c));
        steps.push_back(over_time(h, " Step sizes, " + title + ", ε = 10^{-8}, tol 10^{-10}", "h [s]",
                                  step_sizes(title, run)));
        ratio.curves.push_back(step_ratio(title, run, dae));
        o.text += title + ": " + std::to_string(run.report.steps) + " steps (index-2 system " +
                  std::to_string(dae.report.steps) + "); |G q'| over 10 s: largest " + scientific(early) +
                  " for t < 2, " + scientific(late) + " for t > 8\n";
        const bool periodic = late < 1.05 * early && late > 0.5 * early;
        o.findings.push_back({v + " largest violation, 8 to 10 s against 0 to 2 s, " + title, "periodic",
                              decimal(late / early), "1, no drift", periodic, compared(periodic)});
        o.findings.push_back({h + " steps, " + title, "comparable", std::to_string(run.report.steps),
                              std::to_string(dae.report.steps) + " (DAE)",
                              run.report.steps < 2 * dae.report.steps,
                              compared(run.report.steps < 2 * dae.report.steps)});
    }
    o.figures = {violations[0], violations[1], steps[0], steps[1], ratio};
    return o;
}

namespace {

constexpr double tolerance = 2e-8;

// The fastest of up to five runs.
trajectory fastest(const setup& s) {
    trajectory best = solve(s, {.tolerance = tolerance});
    for (int k = 0; k < 4 && best.microseconds < 2e4; ++k) {
        trajectory again = solve(s, {.tolerance = tolerance});
        if (again.microseconds < best.microseconds) best = again;
    }
    return best;
}

struct variant {
    form f;
    double kappa, smallest;
    const char* name;
    bool grows;  ///< its cost as eps -> 0
    bool in_print;
};

// Cost over that of the index-2 system, one value per eps.
struct costs {
    curve time, steps;
    double least = 1e300, most = 0;  ///< solutions of linear systems for eps <= 1e-8
};

costs measure(outcome& o, const variant& v, const trajectory& dae) {
    costs c{{v.name, {}, {}, true}, {v.name, {}, {}, true}};
    o.text += std::string(v.name) + ":";
    for (const double eps : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16}) {
        if (eps < v.smallest) continue;
        const trajectory run = fastest(disc_regularised(v.f, eps, v.kappa));
        const double solves = static_cast<double>(run.report.solves);
        for (curve* k : {&c.time, &c.steps}) k->x.push_back(eps);
        c.time.y.push_back(run.microseconds / dae.microseconds);
        c.steps.y.push_back(static_cast<double>(run.report.steps) / static_cast<double>(dae.report.steps));
        if (eps <= 1e-8) {
            c.least = std::min(c.least, solves);
            c.most = std::max(c.most, solves);
        }
        o.text += "  " + scientific(eps) + ": " + std::to_string(run.report.steps) + " steps " +
                  decimal(run.microseconds) + " us";
    }
    o.text += "\n";
    return c;
}

void judge(outcome& o, const variant& v, const costs& c) {
    if (v.f == form::mass_matrix) {
        const double worst = *std::max_element(c.steps.y.begin(), c.steps.y.end());
        o.findings.push_back({std::string("4.26 steps of the ") + v.name, "",
                              "<= " + decimal(worst) + " of the DAE's", "flat", worst < 1.15});
        o.findings.push_back({"4.26 its solves for eps <= 1e-8, largest / smallest", "",
                              decimal(c.most / c.least), "1 (flat)", c.most < 1.2 * c.least});
        return;
    }
    const double growth = c.steps.y.back() / c.steps.y.front();
    const bool as_expected = v.grows ? growth > 2 : growth < 1.5;
    o.findings.push_back({std::string("4.26 steps of ") + v.name + ", smallest / largest eps",
                          !v.in_print ? ""
                          : v.grows   ? "grows"
                                      : "nearly flat",
                          decimal(growth), v.grows ? "grows" : "1 (flat)", as_expected,
                          compared(as_expected)});
}

}  // namespace

outcome run_times() {
    outcome o{"Cost against eps, tol 2e-8 (figure 4.26)", {}, {}, {}};
    const trajectory dae = fastest(disc_dae());
    const figure blank{"", "", "ε", "run time / run time of the DAE", true, true, {}};
    figure times = blank, flat = blank, counts = blank, flat_counts = blank;
    times.name = "fig_4_26";
    times.title = "4.26 Run time over that of the index-2 system, tol 2·10^{-8}";
    flat.name = "fig_4_26_flat";
    flat.title = "4.26 The forms whose cost does not grow, on a linear scale";
    flat.log_y = false;
    counts.name = "fig_4_26_steps";
    counts.title = "4.26 Accepted steps over those of the index-2 system, tol 2·10^{-8}";
    counts.y_label = "steps / steps of the DAE";
    flat_counts.name = "fig_4_26_steps_flat";
    flat_counts.title = "4.26 Accepted steps of the forms whose cost does not grow, on a linear scale";
    flat_counts.y_label = counts.y_label;
    flat_counts.log_y = false;
    std::vector<double> plain, turned;  // steps of principal damping in (y, lambda) and transformed
    o.text = "index-2 system: " + std::to_string(dae.report.steps) + " steps, " + decimal(dae.microseconds) +
             " us\n";
    for (const variant& v : {variant{form::mass_matrix, 1, 1e-16, "mass matrix, strong", false, false},
                             variant{form::mass_matrix, 0.5, 1e-16, "mass matrix, principal", false, false},
                             variant{form::multiplier, 1, 1e-16, "(y, λ), strong", false, true},
                             variant{form::multiplier, 0.5, 1e-16, "(y, λ), principal", true, true},
                             variant{form::transformed, 0.5, 1e-16, "transformed, principal", false, true},
                             variant{form::creep, 1, 1e-10, "(y, z), strong", true, false},
                             variant{form::creep, 0.5, 1e-16, "(y, z), principal", true, false}}) {
        const costs c = measure(o, v, dae);
        judge(o, v, c);
        if (v.f == form::multiplier && v.kappa < 1) plain = c.steps.y;
        if (v.f == form::transformed) turned = c.steps.y;
        (v.grows ? times : flat).curves.push_back(c.time);
        (v.grows ? counts : flat_counts).curves.push_back(c.steps);
    }
    const double least = plain.front() / turned.front(), most = plain.back() / turned.back();
    o.findings.push_back(
        {"4.26 (y, λ) over transformed, principal, steps", "3 (time)",
         one_decimal(least) + " ... " + one_decimal(most), "grows", most > least,
         compared(3, most, 0.5,
                  "from " + one_decimal(least) + " at eps = 1e-4 to " + one_decimal(most) + " at 1e-16",
                  least < 3 && most > 3)});
    for (figure* f : {&times, &flat, &counts, &flat_counts})
        f->curves.push_back({"index-2 system", {1e-16, 1e-4}, {1, 1}, false});
    o.figures = {times, flat, counts, flat_counts};
    return o;
}

}  // namespace thesis
