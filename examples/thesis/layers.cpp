// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <complex>

#include <problems/thesis/solve.hpp>
#include "experiments.hpp"

namespace thesis {

namespace {

// How fast a disturbance of lambda dies near t = 0. With u = G q', delta lambda = l and S = G M^-1 G^T =
// diag(3, S_2), frozen at t = 0, u' = -S l and l' = (c/eps) u + (d/eps^kappa) u': the slower root r of r^2 +
// (d S/eps^kappa) r + c S/eps = 0 belonging to the layer. For kappa = 1 the layer is the fast root, about -d
// S/eps, the other one, -c/d, being no layer.
double predicted_rate(double eps, double kappa, double S) {
    const double b = 2 * S / std::pow(eps, kappa), c = 2 * S / eps;
    const double root = std::sqrt(b * b - 4 * c);
    return kappa == 1 ? -(b + root) / 2 : -2 * c / (b + root);
}

struct layer {
    double length;  ///< first time at which |lambda - lambda_DAE| is below twice its level at the end of the
                    ///< window
    double level;
    curve plot;
};

layer measure(double eps, double kappa, double window, long steps) {
    const setup dae = disc_dae(), disturbed = disc_regularised(form::mass_matrix, eps, kappa, {1, 1});
    const request how{.tolerance = 1e-12, .steps = steps, .end = window};
    const trajectory a = solve(disturbed, how), b = solve(dae, how);
    layer r{0, 0, {}};
    for (std::size_t k = 0; k < a.path.size(); ++k) {
        r.plot.x.push_back(a.path[k].t);
        r.plot.y.push_back((disturbed.multiplier(a.path[k].y) - dae.multiplier(b.path[k].y)).norm());
    }
    r.level = r.plot.y.back();
    std::size_t k = r.plot.y.size();
    while (k > 0 && r.plot.y[k - 1] <= 2 * r.level) --k;
    r.length = k < r.plot.x.size() ? r.plot.x[k] : window;
    return r;
}

// The decay rate of the first component of the disturbance, from a run whose steps resolve it.
double measured_rate(double eps, double kappa, double rate) {
    const double window = 6 / std::abs(rate);
    const setup calm = disc_regularised(form::mass_matrix, eps, kappa),
                disturbed = disc_regularised(form::mass_matrix, eps, kappa, {1, 1});
    const request how{.tolerance = 1e-12, .steps = 600, .end = window};
    const trajectory a = solve(disturbed, how), b = solve(calm, how);
    const auto gap = [&](std::size_t k) {
        return std::abs((disturbed.multiplier(a.path[k].y) - calm.multiplier(b.path[k].y))[0]);
    };
    return std::log(gap(600) / gap(400)) / (a.path[600].t - a.path[400].t);
}

}  // namespace

outcome boundary_layers() {
    outcome o{"Boundary layers after a disturbed lambda(0) (figures 4.18 to 4.21)", {}, {}, {}};
    struct layer_case {
        const char *figure, *name, *printed;
        double eps, kappa, window;
        long steps;
    };
    const layer_case cases[] = {{"4.18", "strong damping", "4e-6 (4 steps)", 1e-8, 1.0, 2e-5, 20},
                                {"4.19", "principal damping", "1.2e-3", 1e-8, 0.5, 3e-3, 3000},
                                {"4.20", "strong damping", "4e-6", 1e-6, 1.0, 1e-4, 100},
                                {"4.21", "principal damping", "8e-3", 1e-6, 0.5, 2e-2, 20000}};
    for (const layer_case& c : cases) {
        layer l = measure(c.eps, c.kappa, c.window, c.steps);
        const std::string eps = c.eps == 1e-8 ? "1e-8" : "1e-6";
        const std::string label = std::string(c.name) + ", ε = 10^{" + eps.substr(2) + "}";
        const double rate = predicted_rate(c.eps, c.kappa, 3), seen = measured_rate(c.eps, c.kappa, rate);
        o.text += std::string(c.figure) + " " + c.name + ", eps = " + eps + ": layer of " +
                  scientific(l.length) +
                  " s at steps of 1e-6 s, then |lambda - lambda_DAE| = " + scientific(l.level) +
                  "\n     decay rate " + scientific(seen) + " 1/s, predicted " + scientific(rate) + " 1/s\n";
        l.plot.points = c.kappa == 1;
        std::string name = "fig_" + std::string(c.figure);
        std::replace(name.begin(), name.end(), '.', '_');
        o.figures.push_back({name,
                             std::string(c.figure) + " Boundary layer, " + label,
                             "t [s]",
                             "|λ - λ_{DAE}| [N]",
                             false,
                             true,
                             {l.plot}});
        o.findings.push_back({std::string(c.figure) + " decay rate, " + c.name + ", " + eps, "",
                              scientific(seen), scientific(rate), std::abs(seen / rate - 1) < 0.05});
        const double printed = std::stod(c.printed);
        o.findings.push_back({std::string(c.figure) + " length of the layer [s]", c.printed,
                              scientific(l.length), "", l.length < 3 * printed && l.length > printed / 5,
                              compared(printed, l.length, std::max(1e-6, 0.1 * printed))});
    }
    return o;
}

outcome regularised_runs() {
    outcome o{"Regularised runs at eps = 1e-8 (figures 4.22 to 4.25)", {}, {}, {}};
    const trajectory dae = solve(disc_dae(), {.tolerance = 1e-10});
    const auto steps_of = [](const std::string& title, const trajectory& run) {
        curve c{title, {}, {}, false};
        for (std::size_t k = 1; k < run.path.size(); ++k)
            c.x.push_back(run.path[k].t), c.y.push_back(run.path[k].h);
        return c;
    };
    std::vector<figure> violations, steps;
    for (const double kappa : {1.0, 0.5}) {
        const std::string title = kappa == 1 ? "strong damping" : "principal damping";
        const trajectory run = solve(disc_regularised(form::mass_matrix, 1e-8, kappa), {.tolerance = 1e-10});
        curve c{title, {}, {}, false};
        double first_half = 0, second_half = 0;
        for (const auto& p : run.path) {
            const double u = disc_constraint(p.y).norm();
            (p.t < 0.7 ? first_half : second_half) = std::max(p.t < 0.7 ? first_half : second_half, u);
            c.x.push_back(p.t);
            c.y.push_back(std::max(u, 1e-17));
        }
        const std::string v = kappa == 1 ? "4.22" : "4.23", h = kappa == 1 ? "4.24" : "4.25";
        violations.push_back({"fig_4_" + v.substr(2),
                              v + " Constraint violation, " + title + ", ε = 10^{-8}",
                              "t [s]",
                              "|G q'| [m/s]",
                              false,
                              true,
                              {c}});
        steps.push_back({"fig_4_" + h.substr(2),
                         h + " Step sizes, " + title + ", ε = 10^{-8}, tol 10^{-10}",
                         "t [s]",
                         "h [s]",
                         false,
                         true,
                         {steps_of(title, run), steps_of("index-2 system", dae)}});
        o.text += title + ": " + std::to_string(run.report.steps) + " steps (index-2 system " +
                  std::to_string(dae.report.steps) + "), largest |G q'| " + scientific(first_half) +
                  ", after t = 0.7 " + scientific(second_half) + "\n";
        o.findings.push_back({v + " violation returns, no drift, " + title, "periodic",
                              scientific(second_half) + " late", "< largest " + scientific(first_half),
                              second_half < first_half, compared(second_half < first_half)});
        o.findings.push_back({h + " steps, " + title, "comparable", std::to_string(run.report.steps),
                              std::to_string(dae.report.steps) + " (DAE)",
                              run.report.steps < 2 * dae.report.steps,
                              compared(run.report.steps < 2 * dae.report.steps)});
    }
    o.figures = {violations[0], violations[1], steps[0], steps[1]};
    return o;
}

outcome run_times() {
    outcome o{"Cost against eps, tol 2e-8 (figure 4.26)", {}, {}, {}};
    const double tolerance = 2e-8;
    const auto fastest = [&](const setup& s) {
        trajectory best = solve(s, {.tolerance = tolerance});
        for (int k = 0; k < 4 && best.microseconds < 2e4; ++k) {
            trajectory again = solve(s, {.tolerance = tolerance});
            if (again.microseconds < best.microseconds) best = again;
        }
        return best;
    };
    const trajectory dae = fastest(disc_dae());
    const std::vector<double> all_eps{1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16};
    figure times{"fig_4_26", "4.26 Run time, tol 2·10^{-8}", "ε", "run time [µs]", true, true, {}};
    figure counts{"fig_4_26_steps", "4.26 Accepted steps, tol 2·10^{-8}", "ε", "steps", true, true, {}};
    o.text = "index-2 system: " + std::to_string(dae.report.steps) + " steps, " + decimal(dae.microseconds) +
             " us\n";
    struct variant {
        form f;
        double kappa, smallest;
        const char* name;
    };
    for (const variant& v : {variant{form::mass_matrix, 1, 1e-16, "mass matrix, strong"},
                             variant{form::mass_matrix, 0.5, 1e-16, "mass matrix, principal"},
                             variant{form::multiplier, 1, 1e-16, "(y, λ), strong"},
                             variant{form::multiplier, 0.5, 1e-16, "(y, λ), principal"},
                             variant{form::transformed, 0.5, 1e-16, "transformed, principal"},
                             variant{form::creep, 1, 1e-10, "(y, z), strong"},
                             variant{form::creep, 0.5, 1e-16, "(y, z), principal"}}) {
        curve time{v.name, {}, {}, true}, count{v.name, {}, {}, true};
        double least = 1e300, most = 0;  // solutions of linear systems, what the run time consists of
        std::string line = std::string(v.name) + ":";
        for (const double eps : all_eps) {
            if (eps < v.smallest) continue;
            const trajectory run = fastest(disc_regularised(v.f, eps, v.kappa));
            time.x.push_back(eps);
            time.y.push_back(run.microseconds);
            count.x.push_back(eps);
            count.y.push_back(static_cast<double>(run.report.steps));
            if (eps <= 1e-8) {
                least = std::min(least, static_cast<double>(run.report.solves));
                most = std::max(most, static_cast<double>(run.report.solves));
            }
            line += "  " + scientific(eps) + ": " + std::to_string(run.report.steps) + " steps " +
                    decimal(run.microseconds) + " us";
        }
        o.text += line + "\n";
        if (v.f == form::mass_matrix) {
            const double worst = *std::max_element(count.y.begin(), count.y.end());
            o.findings.push_back(
                {"4.26 steps of the mass-matrix form, " + std::string(v.kappa == 1 ? "strong" : "principal"),
                 "", "<= " + std::to_string(static_cast<long>(worst)),
                 "flat, DAE: " + std::to_string(dae.report.steps),
                 worst < 1.15 * static_cast<double>(dae.report.steps)});
            o.findings.push_back({"4.26 its solves for eps <= 1e-8, largest / smallest", "",
                                  decimal(most / least), "1 (flat)", most < 1.2 * least});
        } else {
            const double growth = count.y.back() / count.y.front();
            const bool grows = v.f == form::creep || (v.f == form::multiplier && v.kappa < 1);
            o.findings.push_back(
                {std::string("4.26 steps of ") + name(v.f) + (v.kappa == 1 ? ", strong" : ", principal") +
                     ", smallest / largest eps",
                 v.f == form::creep ? ""
                 : grows            ? "grows"
                                    : "nearly flat",
                 decimal(growth), grows ? "grows" : "1 (flat)", grows ? growth > 2 : growth < 1.5,
                 compared(grows ? growth > 2 : growth < 1.5)});
        }
        times.curves.push_back(time);
        counts.curves.push_back(count);
    }
    const double reference_steps = static_cast<double>(dae.report.steps);
    times.curves.push_back({"index-2 system", {1e-16, 1e-4}, {dae.microseconds, dae.microseconds}, false});
    counts.curves.push_back({"index-2 system", {1e-16, 1e-4}, {reference_steps, reference_steps}, false});
    o.figures = {times, counts};
    return o;
}

}  // namespace thesis
