// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <problems/thesis/solve.hpp>
#include "drawing.hpp"
#include "experiments.hpp"

namespace thesis {

namespace {

// Figure 4.2, all twelve variables: positions, velocities and forces apart, for their sizes differ.
std::vector<figure> variables(const trajectory& run) {
    const char* const names[] = {"x", "y", "α", "β", "γ", "x'", "y'", "α'", "β'", "γ'", "λ_1", "λ_2"};
    std::vector<curve> curves;
    for (int i = 0; i < 12; ++i) {
        curve c{names[i], {}, {}, false};
        for (const auto& p : run.path) c.x.push_back(p.t), c.y.push_back(p.y[i]);
        curves.push_back(c);
    }
    const auto part = [&](const char* name, const char* what, const char* label, int from, int to) {
        return figure{name,
                      std::string("4.2 Solution of the index-2 system: ") + what,
                      "t [s]",
                      label,
                      false,
                      false,
                      {curves.begin() + from, curves.begin() + to}};
    };
    return {part("fig_4_2", "place of the contact point", "x, y [m]", 0, 2),
            part("fig_4_2_angles", "angles", "α, β, γ [rad]", 2, 5),
            part("fig_4_2_velocities", "velocity of the contact point", "x', y' [m/s]", 5, 7),
            part("fig_4_2_rates", "angular velocities", "α', β', γ' [rad/s]", 7, 10),
            part("fig_4_2_forces", "multipliers", "λ [N]", 10, 12)};
}

// Figure 4.5 over twenty seconds, where the drift shows.
void long_run(outcome& o) {
    const request how{.tolerance = 1e-12, .end = 20};
    const auto violation = [](const trajectory& run, const char* title, double& at_end) {
        curve c{title, {}, {}, false};
        double worst = 0;
        for (std::size_t k = 0; k < run.path.size(); ++k) {
            worst = std::max(worst, disc_constraint(run.path[k].y).cwiseAbs().maxCoeff());
            if (k % 50 != 0) continue;  // the largest since the last point that is drawn
            c.x.push_back(run.path[k].t);
            c.y.push_back(worst);
            worst = 0;
        }
        at_end = *std::max_element(c.y.end() - 20, c.y.end());
        return c;
    };
    double dae = 0, ode = 0;
    const curve direct = violation(solve(disc_dae(), how), "index-2 system", dae),
                reduced = violation(solve(disc_reduced(), how), "index-reduced", ode);
    o.figures.push_back({"fig_4_5_long",
                         "4.5 Constraint over 20 s, tol 10^{-12}",
                         "t [s]",
                         "max |G q'| [m/s]",
                         false,
                         true,
                         {direct, reduced}});
    o.text += "over 20 s: max|G q'| " + scientific(dae) + " m/s (index-2 system) and " + scientific(ode) +
              " m/s (index-reduced) at the end\n";
    o.findings.push_back(
        {"4.5 over 20 s: index-reduced", "", scientific(ode), "drifts, > 1e-12", ode > 1e-12});
    o.findings.push_back({"4.5 over 20 s: index-2 system", "", scientific(dae), "rounding", dae < 1e-12});
}

}  // namespace

outcome solution() {
    outcome o{"Solution, energy, constraint (figures 4.1 to 4.6)", {}, {}, {}};
    const trajectory dae = solve(disc_dae(), {.tolerance = 1e-12}),
                     ode = solve(disc_reduced(), {.tolerance = 1e-12});

    curve total{"total", {}, {}, false}, kinetic{"kinetic", {}, {}, false},
        potential{"potential", {}, {}, false};
    const char* const components[] = {"first component", "second component"};
    const auto constraint_of = [&](const trajectory& run, double& worst) {
        std::vector<curve> curves;
        for (int i = 0; i < 2; ++i) {
            curve c{components[i], {}, {}, false};
            for (const auto& p : run.path) {
                const double u = disc_constraint(p.y)[i];
                worst = std::max(worst, std::abs(u));
                c.x.push_back(p.t);
                c.y.push_back(u);
            }
            curves.push_back(c);
        }
        return curves;
    };
    curve steps{"tol 10^{-12}", {}, {}, false};
    const double energy0 = disc_energy(dae.path.front().y);
    double worst_energy = 0, worst_violation = 0, worst_drift = 0, smallest = 1, largest = 0;
    for (const auto& p : dae.path) {
        total.x.push_back(p.t);
        total.y.push_back(disc_energy(p.y));
        kinetic.x.push_back(p.t);
        kinetic.y.push_back(disc_kinetic_energy(p.y));
        potential.x.push_back(p.t);
        potential.y.push_back(total.y.back() - kinetic.y.back());
        worst_energy = std::max(worst_energy, std::abs(total.y.back() - energy0));
        if (p.h == 0) continue;
        steps.x.push_back(p.t);
        steps.y.push_back(p.h);
        smallest = std::min(smallest, p.h);
        largest = std::max(largest, p.h);
    }
    o.figures = variables(dae);
    const std::vector<curve> rounding = constraint_of(dae, worst_violation);  // one would hide the other
    const std::vector<figure> others{
        {"fig_4_3", "4.3 Energy", "t [s]", "energy [J]", false, false, {total, kinetic, potential}},
        {"fig_4_4",
         "4.4 Constraint of the index-2 system, first component",
         "t [s]",
         "G q' [m/s]",
         false,
         false,
         {rounding[0]}},
        {"fig_4_4_second",
         "4.4 Constraint of the index-2 system, second component",
         "t [s]",
         "G q' [m/s]",
         false,
         false,
         {rounding[1]}},
        {"fig_4_5", "4.5 Constraint after index reduction", "t [s]", "G q' [m/s]", false, false,
         constraint_of(ode, worst_drift)},
        {"fig_4_6",
         "4.6 Step sizes of the reference run, tol 10^{-12}",
         "t [s]",
         "h [s]",
         false,
         true,
         {steps}}};
    o.figures.insert(o.figures.end(), others.begin(), others.end());
    o.drawings = disc_drawings(solve(disc_dae(), {.tolerance = 1e-11, .steps = 1200}));
    const double end_drift = disc_constraint(ode.path.back().y).cwiseAbs().maxCoeff();
    o.text = "Radau IIA-3, tol 1e-12, " + std::to_string(dae.report.steps) + " steps\n" +
             "largest change of the energy       " + scientific(worst_energy) + " J\n" +
             "largest max|G q'|, index-2 system  " + scientific(worst_violation) + " m/s\n" +
             "largest max|G q'|, index-reduced   " + scientific(worst_drift) + " m/s, at the end " +
             scientific(end_drift) + "\nstep sizes " + scientific(smallest) + " to " + scientific(largest) +
             " s\n";
    o.findings = {
        {"4.3 energy constant, change", "0 (plot)", scientific(worst_energy), "0", worst_energy < 1e-9,
         compared(worst_energy < 1e-9)},
        {"4.4 constraint, index-2 system", "<= 1e-10", scientific(worst_violation), "rounding",
         worst_violation < 1e-12, compared(worst_violation <= 1e-10)},
        {"4.5 constraint drifts after index reduction", "drift", scientific(end_drift), "> index-2 system",
         end_drift > 10 * worst_violation, compared(end_drift > 10 * worst_violation)},
        {"4.6 step sizes", "1e-4 ... 1e-3", scientific(smallest) + " ... " + scientific(largest), "",
         smallest > 1e-5 && largest < 1e-2, compared(smallest > 0.5e-4 && largest < 5e-3)}};
    long_run(o);
    return o;
}

}  // namespace thesis
