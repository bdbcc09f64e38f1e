// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>

#include <problems/thesis/solve.hpp>
#include "experiments.hpp"

namespace thesis {

namespace {

// How fast a disturbance of a component of lambda dies near t = 0. With u = G q', delta lambda = l and S = G M^-1
// G^T = diag(3, S_2), frozen at t = 0, u' = -S l and l' = (c/eps) u + (d/eps^kappa) u': the slower root r of r^2 +
// (d S/eps^kappa) r + c S/eps = 0 belonging to the layer. For kappa = 1 the layer is the fast root, about -d
// S/eps, the other one, -c/d, being no layer.
double predicted_rate(double eps, double kappa, double S) {
    const double b = 2 * S / std::pow(eps, kappa), c = 2 * S / eps;
    const double root = std::sqrt(b * b - 4 * c);
    return kappa == 1 ? -(b + root) / 2 : -2 * c / (b + root);
}

// G M^-1 G^T = diag(3, 5/(5 - 4 cos^2 beta)) at the start.
std::array<double, 2> inertias() { return {3, 5 / (5 - 4 * std::pow(std::cos(disc_dae().y0[3]), 2))}; }

// R(z) of Radau IIA-3: what one step of length h makes of a mode e^{rt}, z = h r.
double stability_function(double z) {
    return (1 + z * (0.4 + z / 20)) / (1 - z * (0.6 - z * (0.15 - z / 60)));
}

using forces = std::vector<Eigen::Vector2d>;

// lambda at the given times, from a run with tight tolerance that resolves the layer.
forces resolved(const setup& s, const std::vector<double>& times) {
    forces values;
    request how{.tolerance = 1e-12, .end = times.back()};
    how.watch = [&](double t, const vector&, double, const piece& p) {
        while (values.size() < times.size() && times[values.size()] <= t)
            values.push_back(s.multiplier(p(times[values.size()])));
        return true;
    };
    solve(s, how);
    return values;
}

struct layer {
    double length;  ///< first time at which |lambda - lambda_DAE| is below twice its level at the end of the
                    ///< window
    double level;
    double slope;  ///< of the first component between the first steps
    curve disturbed, calm;
};

// As the thesis looks at it: equal steps of 1e-6 s.
layer measure(double eps, double kappa, double window, long steps) {
    const setup dae = disc_dae(), disturbed = disc_regularised(form::mass_matrix, eps, kappa, {1, 1}),
                calm = disc_regularised(form::mass_matrix, eps, kappa);
    const request how{.tolerance = 1e-12, .steps = steps, .end = window};
    const trajectory a = solve(disturbed, how), b = solve(dae, how), c = solve(calm, how);
    layer r{0, 0, 0, {"disturbed, h = 10^{-6}", {}, {}, true}, {"undisturbed, h = 10^{-6}", {}, {}, false}};
    double first = 0;
    for (std::size_t k = 0; k < a.path.size(); ++k) {
        const Eigen::Vector2d exact = dae.multiplier(b.path[k].y);
        const Eigen::Vector2d gap = disturbed.multiplier(a.path[k].y) - exact;
        for (curve* plot : {&r.disturbed, &r.calm}) plot->x.push_back(a.path[k].t);
        r.disturbed.y.push_back(gap.norm());
        r.calm.y.push_back((calm.multiplier(c.path[k].y) - exact).norm());
        if (k == 0) first = std::abs(gap[0]);
        if (k == 1) r.slope = std::log(std::abs(gap[0]) / first) / a.path[1].t;
    }
    r.level = r.disturbed.y.back();
    std::size_t k = r.disturbed.y.size();
    while (k > 0 && r.disturbed.y[k - 1] <= 2 * r.level) --k;
    r.length = k < r.disturbed.x.size() ? r.disturbed.x[k] : window;
    r.disturbed.points = steps <= 100;
    if (kappa < 1) r.disturbed.title += ": resolved";
    return r;
}

// The decay rate of a component of the disturbance, from a run whose steps resolve it.
double measured_rate(double eps, double kappa, int component, double rate) {
    const double window = 6 / std::abs(rate);
    const setup calm = disc_regularised(form::mass_matrix, eps, kappa),
                disturbed = disc_regularised(form::mass_matrix, eps, kappa, {1, 1});
    const request how{.tolerance = 1e-12, .steps = 600, .end = window};
    const trajectory a = solve(disturbed, how), b = solve(calm, how);
    const auto gap = [&](std::size_t k) {
        return std::abs((disturbed.multiplier(a.path[k].y) - calm.multiplier(b.path[k].y))[component]);
    };
    return std::log(gap(600) / gap(400)) / (a.path[600].t - a.path[400].t);
}

// |lambda - lambda_DAE| on a logarithmic scale of t, the layer resolved.
curve true_layer(double eps, double kappa, double window) {
    const setup disturbed = disc_regularised(form::mass_matrix, eps, kappa, {1, 1});
    std::vector<double> times;
    const double rate = predicted_rate(eps, kappa, 3);
    for (double t = 0.02 / std::abs(rate); t < window; t *= 1.05) times.push_back(t);
    const forces a = resolved(disturbed, times), b = resolved(disc_dae(), times);
    curve c{"disturbed, layer resolved", times, {}, false};
    for (std::size_t k = 0; k < times.size(); ++k) c.y.push_back((a[k] - b[k]).norm());
    return c;
}

struct layer_case {
    const char *figure, *name, *printed;
    double eps, kappa, window;
    long steps;
};

void one_layer(outcome& o, const layer_case& c) {
    const layer l = measure(c.eps, c.kappa, c.window, c.steps);
    const std::string eps = c.eps == 1e-8 ? "1e-8" : "1e-6", number = c.figure;
    const auto S = inertias();
    double rate[2];
    for (int k = 0; k < 2; ++k) rate[k] = predicted_rate(c.eps, c.kappa, S[k]);
    const int slowest = rate[0] > rate[1] ? 0 : 1;
    o.text += number + " " + c.name + ", eps = " + eps + ": layer of " + scientific(l.length) +
              " s at steps of 1e-6 s, then |lambda - lambda_DAE| = " + scientific(l.level) + "\n";
    for (int k = 0; k < 2; ++k) {
        const double seen = measured_rate(c.eps, c.kappa, k, rate[k]);
        const std::string which =
            std::to_string(k + 1) + std::string(k == slowest ? " (the slowest mode)" : "");
        o.text += "     component " + which + ": decay rate " + scientific(seen) + " 1/s, predicted " +
                  scientific(rate[k]) + "\n";
        o.findings.push_back({number + " decay rate of component " + which + ", " + c.name + ", " + eps, "",
                              scientific(seen), scientific(rate[k]), std::abs(seen / rate[k] - 1) < 0.05});
    }
    if (c.kappa == 1) {
        const double z = 1e-6 * rate[0], damping = std::log(std::abs(stability_function(z))) / 1e-6;
        o.text += "     steps of 1e-6 s damp component 1 at " + scientific(l.slope) +
                  " 1/s, ln |R(h r)| / h = " + scientific(damping) + ": not the layer\n";
        o.findings.push_back({number + " slope shown at h = 1e-6, " + c.name + ", " + eps, "",
                              scientific(l.slope), scientific(damping),
                              std::abs(l.slope / damping - 1) < 0.05});
    }
    std::string name = "fig_" + number;
    std::replace(name.begin(), name.end(), '.', '_');
    o.figures.push_back({name,
                         number + " Boundary layer, " + c.name + ", ε = 10^{" + eps.substr(2) + "}",
                         "t [s]",
                         "|λ - λ_{DAE}| [N]",
                         true,
                         true,
                         {l.disturbed, l.calm}});
    // For kappa = 1/2 steps of 1e-6 s resolve the layer: the two curves would be one.
    if (c.kappa == 1) o.figures.back().curves.push_back(true_layer(c.eps, c.kappa, c.window));
    curve& resolved = o.figures.back().curves[c.kappa == 1 ? 2 : 0];
    resolved.title +=
        "; slowest mode λ_" + std::to_string(slowest + 1) + ", rate " + scientific(rate[slowest]) + " 1/s";
    const double printed = std::stod(c.printed);
    o.findings.push_back({number + " length of the layer [s]", c.printed, scientific(l.length), "",
                          l.length < 3 * printed && l.length > printed / 5,
                          compared(printed, l.length, std::max(1e-6, 0.1 * printed))});
}

}  // namespace

outcome boundary_layers() {
    outcome o{"Boundary layers after a disturbed lambda(0) (figures 4.18 to 4.21)", {}, {}, {}};
    for (const layer_case& c : {layer_case{"4.18", "strong damping", "4e-6 (4 steps)", 1e-8, 1.0, 2e-5, 20},
                                layer_case{"4.19", "principal damping", "1.2e-3", 1e-8, 0.5, 3e-3, 3000},
                                layer_case{"4.20", "strong damping", "4e-6", 1e-6, 1.0, 1e-4, 100},
                                layer_case{"4.21", "principal damping", "8e-3", 1e-6, 0.5, 2e-2, 20000}})
        one_layer(o, c);
    return o;
}

}  // namespace thesis
