// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "solve.hpp"

namespace thesis {

namespace {

// Equal steps small enough that the method's own error stays below 1e-11, on the same grid for all runs.
constexpr long grid = 1000;
constexpr int stages = 5;

struct distance {
    double y = 0, y_end = 0, lambda = 0, constraint = 0;
};

// Largest distances over the grid between two runs, and the constraint violation of the first.
distance compare(const setup& s, const trajectory& a, const setup& reference, const trajectory& b,
                 double after) {
    distance d;
    for (std::size_t k = 1; k < a.path.size(); ++k) {
        d.constraint = std::max(d.constraint, disc_constraint(a.path[k].y).cwiseAbs().maxCoeff());
        d.y_end = (a.path[k].y.head(10) - b.path[k].y.head(10)).cwiseAbs().maxCoeff();
        d.y = std::max(d.y, d.y_end);
        if (a.path[k].t >= after)
            d.lambda =
                std::max(d.lambda, (s.multiplier(a.path[k].y) - reference.multiplier(b.path[k].y)).norm());
    }
    return d;
}

trajectory on_grid(const setup& s) { return solve(s, {.stages = stages, .tolerance = 1e-13, .steps = grid}); }

struct sweep {
    std::vector<double> eps, y, y_end, lambda, constraint;
};

sweep over_epsilon(double kappa, const setup& dae, const trajectory& reference, std::string& text) {
    sweep r;
    text += "kappa = " + decimal(kappa) +
            "        eps       max |y-y0|    / eps   at t = 1    / eps    |lambda-lambda0|  |G q'|\n";
    for (double eps : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
        const setup s = disc_regularised(form::mass_matrix, eps, kappa);
        const distance d = compare(s, on_grid(s), dae, reference, 0.05);
        r.eps.push_back(eps);
        r.y.push_back(d.y);
        r.y_end.push_back(d.y_end);
        r.lambda.push_back(d.lambda);
        r.constraint.push_back(d.constraint);
        text += "             " + scientific(eps) + "   " + scientific(d.y) + "   " + decimal(d.y / eps) +
                "    " + scientific(d.y_end) + "   " + decimal(d.y_end / eps) + "    " +
                scientific(d.lambda) + "    " + scientific(d.constraint) + "\n";
    }
    return r;
}

// The limit of y/eps as eps -> 0, its first correction being O(eps^(1-kappa)) for kappa < 1 (the damper acts
// at that order: G q' = (eps/c) lambda' + ...), else O(eps): one step of Richardson extrapolation.
double limit(const std::vector<double>& eps, const std::vector<double>& y, double kappa) {
    const std::size_t n = eps.size();
    const double fine = y[n - 1] / eps[n - 1], coarse = y[n - 2] / eps[n - 2];
    const double ratio = std::pow(eps[n - 1] / eps[n - 2], kappa < 1 ? 1 - kappa : 1);
    return (fine - ratio * coarse) / (1 - ratio);
}

// Slope over the last three decades, where the asymptotics rule.
double late_slope(const std::vector<double>& x, const std::vector<double>& y) {
    return slope({x.end() - 3, x.end()}, {y.end() - 3, y.end()});
}

}  // namespace

outcome regularisation_error() {
    outcome o{"Distance of the regularised motion to the index-2 motion (figures 4.13 to 4.16)", {}, {}, {}};
    const setup dae = disc_dae();
    const trajectory reference = on_grid(dae);
    figure fy{"fig_4_13", "4.13 Distance in q, q'", "ε", "maximum over t", true, true, {}};
    figure fl{"fig_4_14", "4.14 Distance in λ, t ≥ 0.05 s", "ε", "maximum over t", true, true, {}};
    figure fc{"fig_4_15", "4.15 Constraint violation", "ε", "max |G q'| [m/s]", true, true, {}};
    figure fk{"fig_4_16", "4.16 Distance in q, q' for other κ", "ε", "maximum over t", true, true, {}};
    struct printed {
        double kappa;
        const char *name, *y, *lambda, *constraint;
        double constant;
    };
    for (const printed& p : {printed{1.0, "strong damping", "0.99", "1.00", "0.99", 366},
                             printed{0.5, "principal damping", "1.17", "1.19", "0.99", 218}}) {
        const sweep s = over_epsilon(p.kappa, dae, reference, o.text);
        const double sy = late_slope(s.eps, s.y), sl = late_slope(s.eps, s.lambda),
                     sc = late_slope(s.eps, s.constraint);
        const double constant = limit(s.eps, s.y_end, p.kappa), se = slope(s.eps, s.y_end);
        o.text += "  slopes for eps <= 1e-6: y " + decimal(sy) + ", lambda " + decimal(sl) + ", constraint " +
                  decimal(sc) + "\n\n";
        const std::string label = std::string(", ") + p.name;
        fy.curves.push_back({p.name, s.eps, s.y, true});
        fl.curves.push_back({p.name, s.eps, s.lambda, true});
        fc.curves.push_back({p.name, s.eps, s.constraint, true});
        o.findings.push_back({"4.13 slope of y" + label, p.y,
                              decimal(sy) + " (t=1, all eps: " + decimal(se) + ")", "1",
                              std::abs(sy - 1) < 0.1});
        o.findings.push_back({"4.13 error of y at t=1" + label, "", decimal(constant) + " eps",
                              decimal(p.constant) + " eps", std::abs(constant / p.constant - 1) < 0.05});
        o.findings.push_back(
            {"4.14 slope of lambda" + label, p.lambda, decimal(sl), "1", std::abs(sl - 1) < 0.1});
        o.findings.push_back(
            {"4.15 slope of the violation" + label, p.constraint, decimal(sc), "1", std::abs(sc - 1) < 0.1});
    }
    for (const double kappa : {0.25, 0.75}) {
        const sweep s = over_epsilon(kappa, dae, reference, o.text);
        const double sy = late_slope(s.eps, s.y);
        o.text += "  slope for eps <= 1e-6: y " + decimal(sy) + "\n\n";
        fk.curves.push_back({"κ = " + decimal(kappa), s.eps, s.y, true});
        o.findings.push_back(
            {"4.16 slope of y, kappa = " + decimal(kappa), "1", decimal(sy), "1", std::abs(sy - 1) < 0.1});
    }
    o.figures = {fy, fl, fc, fk};
    return o;
}

outcome transformation() {
    outcome o{"Principal damping, transformed against untransformed (figure 4.17)", {}, {}, {}};
    figure f{"fig_4_17",
             "4.17 Distance between transformed and untransformed form, ε = 10^{-6}",
             "t [s]",
             "|difference|",
             false,
             true,
             {{"q, q'", {}, {}, false}, {"λ", {}, {}, false}}};
    const double eps = 1e-6;
    const setup plain = disc_regularised(form::multiplier, eps, 0.5),
                turned = disc_regularised(form::transformed, eps, 0.5);
    const request how{.tolerance = 1e-12, .steps = 2000};
    const trajectory a = solve(plain, how), b = solve(turned, how);
    double worst = 0;
    for (std::size_t k = 1; k < a.path.size(); ++k) {
        const double dy = (a.path[k].y.head(10) - b.path[k].y.head(10)).norm();
        const double dl = (plain.multiplier(a.path[k].y) - turned.multiplier(b.path[k].y)).norm();
        f.curves[0].x.push_back(a.path[k].t);
        f.curves[0].y.push_back(std::max(dy, 1e-17));
        f.curves[1].x.push_back(a.path[k].t);
        f.curves[1].y.push_back(std::max(dl, 1e-17));
        worst = std::max(worst, dy);
    }
    o.text = "eps = 1e-6, 2000 equal steps, Radau IIA-3: largest difference in q, q' " + scientific(worst) +
             ", to be compared with the modelling error 218 eps = " + scientific(218 * eps) + "\n";
    o.figures = {f};
    o.findings = {{"4.17 forms differ by less than the model", "<< 1e-4", scientific(worst),
                   "< " + scientific(218 * eps), worst < 218 * eps / 10}};
    return o;
}

}  // namespace thesis
