// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "solve.hpp"

namespace thesis {

namespace {

// Slope between the two smallest steps whose error is above 1e-10: below, rounding errors accumulated over
// the run rule.
double order_above_rounding(const std::vector<double>& h, const std::vector<double>& error) {
    std::size_t k = error.size() - 1;
    while (k > 1 && error[k] < 1e-10) --k;
    return slope({h[k - 1], h[k]}, {error[k - 1], error[k]});
}

}  // namespace

outcome other_methods() {
    outcome o{"Beyond the thesis: other families and more stages on the index-2 system", {}, {}, {}};
    const setup dae = disc_dae();
    constexpr int marks = 50;
    const trajectory reference = solve(dae, {.stages = 9, .tolerance = 1e-13, .steps = 800});
    struct method {
        family f;
        int stages;
        long first, last;
        double y, lambda;
        const char* reason;
    };
    // Hairer, Lubich and Roche (1989), table of section 4 and theorems 4.6, 4.8 to 4.10.
    const method methods[] = {
        {family::radau_iia, 4, 100, 800, 7, 4, "all hypotheses hold"},
        {family::gauss, 2, 400, 3200, 2, 0, "not stiffly accurate, R(inf) = 1: lambda need not converge"},
        {family::gauss, 3, 400, 1600, 4, 2, "not stiffly accurate, R(inf) = -1"},
        {family::radau_ia, 3, 400, 3200, 3, 2, "not stiffly accurate"},
        {family::lobatto_iiic, 3, 400, 3200, 4, 2, "stiffly accurate, stage order s - 1 only"},
        {family::lobatto_iiic, 4, 100, 800, 6, 3, "stiffly accurate, stage order s - 1 only"}};
    figure fy{
        "fig_families_y", "Index-2 system, error in q, q' over t", "h [s]", "maximum error", true, true, {}};
    figure fl{
        "fig_families_lambda", "Index-2 system, error in λ over t", "h [s]", "maximum error", true, true, {}};
    for (const method& m : methods) {
        std::vector<double> h, ey, el;
        for (long steps = m.first; steps <= m.last; steps *= 2) {
            const trajectory run =
                solve(dae, {.method = m.f, .stages = m.stages, .tolerance = 1e-13, .steps = steps});
            double y = 0, lambda = 0;
            for (std::size_t k = 1; k <= marks; ++k) {
                const vector &a = run.path[k * (run.path.size() - 1) / marks].y,
                             &b = reference.path[k * (reference.path.size() - 1) / marks].y;
                y = std::max(y, (a - b).head(10).cwiseAbs().maxCoeff());
                lambda = std::max(lambda, (a - b).tail(2).cwiseAbs().maxCoeff());
            }
            h.push_back(1.0 / static_cast<double>(steps));
            ey.push_back(y);
            el.push_back(lambda);
        }
        const std::string label =
            std::string(stagecraft::tableaux::name(m.f)) + " " + std::to_string(m.stages);
        const double sy = order_above_rounding(h, ey), sl = order_above_rounding(h, el);
        o.text += label + ": ";
        for (std::size_t k = 0; k < h.size(); ++k)
            o.text += scientific(ey[k]) + "/" + scientific(el[k]) + "  ";
        o.text += "\n    orders y " + decimal(sy) + ", lambda " + decimal(sl) + " (" + m.reason + ")\n";
        fy.curves.push_back({label, h, ey, true});
        fl.curves.push_back({label, h, el, true});
        o.findings.push_back({"order of y, " + label, "", decimal(sy), ">= " + decimal(m.y), sy > m.y - 0.1});
        o.findings.push_back(
            {"order of lambda, " + label, "", decimal(sl), ">= " + decimal(m.lambda), sl > m.lambda - 0.1});
    }
    o.text += "\nequal steps 1/200, stages s: error of y over t\n";
    curve stages{"h = 1/200", {}, {}, true};
    for (int s = 1; s <= 7; ++s) {
        const trajectory run = solve(dae, {.stages = s, .tolerance = 1e-13, .steps = 200});
        double y = 0;
        for (std::size_t k = 1; k <= 200; ++k)
            y = std::max(y, (run.path[k].y - reference.path[4 * k].y).head(10).cwiseAbs().maxCoeff());
        stages.x.push_back(s);
        stages.y.push_back(y);
        o.text += "  Radau IIA-" + std::to_string(s) + "  " + scientific(y) + "\n";
    }
    o.figures = {fy,
                 fl,
                 {"fig_stages",
                  "Radau IIA with s stages, 200 equal steps",
                  "s",
                  "maximum error",
                  false,
                  true,
                  {stages}}};
    o.findings.push_back({"error falls with every stage, s = 1 ... 6, h = 1/200", "", scientific(stages.y[5]),
                          "h^(2s-1)", std::is_sorted(stages.y.rbegin() + 1, stages.y.rend())});
    return o;
}

}  // namespace thesis
