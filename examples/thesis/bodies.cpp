// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/mechanics/singularity.hpp>

#include <problems/rolling_disc/disc.hpp>
#include <problems/thesis/nonholonomic.hpp>
#include <problems/thesis/solve.hpp>
#include "experiments.hpp"

namespace thesis {

namespace {

using rolling_disc::disc;
constexpr double tolerance = 1e-11;
using vector5 = Eigen::Matrix<double, 5, 1>;

template <class Model>
using coordinates = stagecraft::coordinate_vector<double, Model>;

template <class Model>
trajectory motion(const Model& model, const coordinates<Model>& q, const coordinates<Model>& v, request how) {
    const auto dae = stagecraft::index_2(model);
    return solve<double>({erased(dae), dae.initial_state(q, v), {}}, how);
}

// Energy and constraint along a run.
struct audit {
    curve energy;  // |change| over t
    double drift = 0, at_end = 0, violation = 0, speed = 0;
};

template <class Model>
audit audited(const Model& model, const trajectory& r, const std::string& title) {
    constexpr int n = Model::coordinates;
    audit a{{title, {}, {}, false}};
    double first = 0;
    for (const auto& p : r.path) {
        const coordinates<Model> q = p.y.head<n>(), v = p.y.segment<n>(n);
        const double energy = stagecraft::total_energy<double>(model, q, v);
        if (p.t == 0) first = energy;
        a.energy.x.push_back(p.t);
        a.energy.y.push_back(std::abs(energy - first));
        a.at_end = std::abs(energy - first);
        a.drift = std::max(a.drift, a.at_end);
        a.speed = std::max(a.speed, v.cwiseAbs().maxCoeff());
        a.violation = std::max(a.violation, stagecraft::constraint_violation<double>(model, q, v));
    }
    return a;
}

// What every body is asked: is its energy constant, does it obey its constraint.
void check(outcome& o, const audit& a, long steps) {
    o.text += "  " + std::to_string(steps) + " steps, energy constant to " + scientific(a.drift) +
              " J, largest |G q'| " + scientific(a.violation) + "\n";
    o.findings.push_back(
        {"energy of " + a.energy.title + ", change", "", scientific(a.drift), "0", a.drift < 1e-8});
    // Newton's iteration stops at a fraction of the tolerance, which is relative to the velocities.
    const double bound = tolerance * std::max(1.0, a.speed);
    o.findings.push_back({"constraint of " + a.energy.title + ", max |G q'|", "", scientific(a.violation),
                          "< " + scientific(bound), a.violation < bound});
}

// A curve over the share of its run, so that runs of different length fit in one picture.
curve over_share(curve c) {
    const double duration = c.x.back();
    for (double& t : c.x) t /= duration;
    c.title += ", " + general(duration) + " s";
    return c;
}

curve path(const trajectory& r, const std::string& title, int x, int y) {
    curve c{title, {}, {}, false};
    for (const auto& p : r.path) c.x.push_back(p.y[x]), c.y.push_back(p.y[y]);
    return c;
}

void knife(outcome& o, figure& paths, figure& energies) {
    const knife_edge model;
    const double omega = 2, k = model.fall / (2 * omega * omega);
    const trajectory r = motion(model, {0, 0, 0}, {0, 0, omega}, {.tolerance = tolerance, .end = 3});
    double worst = 0;
    for (const auto& p : r.path) {
        const double x = k * std::pow(std::sin(omega * p.t), 2);
        const double y = k * (omega * p.t - std::sin(2 * omega * p.t) / 2);
        worst = std::max(worst, std::hypot(p.y[0] - x, p.y[1] - y));
    }
    o.text += "Knife edge on a slope, 3 s: distance to its cycloid " + scientific(worst) + " m\n";
    o.findings.push_back({"knife edge, distance to the cycloid", "", scientific(worst), "0", worst < 1e-8});
    const audit a = audited(model, r, "knife edge");
    check(o, a, r.report.steps);
    paths.curves.push_back(path(r, "knife edge", 1, 0));
    energies.curves.push_back(over_share(a.energy));
}

void sleigh(outcome& o, figure& paths, figure& energies) {
    const chaplygin_sleigh model;
    const double u0 = 0.5, w0 = 3;
    const trajectory r = motion(model, {0, 0, 0}, {u0, 0, w0}, {.tolerance = tolerance, .end = 12});
    // Speed u along the blade and turning rate w obey u' = a w^2, w' = -m a u w/(J + m a^2): all energy ends
    // in u although no force does work.
    const vector& y = r.path.back().y;
    const double u = std::cos(y[2]) * y[3] + std::sin(y[2]) * y[4];
    const double all = model.mass * u0 * u0 + (model.inertia + model.mass * model.a * model.a) * w0 * w0;
    const double last = std::sqrt(all / model.mass);
    o.text += "Chaplygin sleigh, 12 s: speed along the blade " + decimal(u) +
              " m/s, at rest it turns no more " + scientific(y[5]) + " 1/s\n";
    o.findings.push_back({"Chaplygin sleigh, final speed [m/s]", "", decimal(u), decimal(last),
                          std::abs(u / last - 1) < 1e-4});
    const audit a = audited(model, r, "Chaplygin sleigh");
    check(o, a, r.report.steps);
    paths.curves.push_back(path(r, "Chaplygin sleigh", 0, 1));
    energies.curves.push_back(over_share(a.energy));
}

void ball(outcome& o, figure& heights, figure& energies) {
    const rolling_ball model;
    const double omega = 9, spin = 2;  // the Euler angles stay away from their singular position
    const trajectory r = motion(model, rolling_ball::initial_position(), model.initial_velocity(omega, spin),
                                {.tolerance = tolerance, .end = 2});
    double worst = 0, lowest = 0;
    for (const auto& p : r.path) {
        worst = std::max(worst, std::abs(p.y[1] - model.height(omega, spin, p.t)));
        lowest = std::min(lowest, p.y[1]);
    }
    o.text += "Ball rolling in an upright cylinder, 2 s: falls to " + decimal(lowest) +
              " m and comes back, distance to the closed form " + scientific(worst) + " m\n";
    o.findings.push_back(
        {"rolling ball, distance to the closed form", "", scientific(worst), "0", worst < 1e-8});
    const audit a = audited(model, r, "rolling ball");
    check(o, a, r.report.steps);
    curve height{"height z [m]", {}, {}, false}, angle{"angle χ / 10", {}, {}, false};
    for (const auto& p : r.path) {
        height.x.push_back(p.t), height.y.push_back(p.y[1]);
        angle.x.push_back(p.t), angle.y.push_back(p.y[0] / 10);
    }
    heights.curves = {height, angle};
    energies.curves.push_back(over_share(a.energy));
}

// The misprint of the thesis: -4 alpha' y' where -4 alpha' y belongs. The constraint cannot tell, the energy
// can: a force that is not that of the Lagrangian does work.
void misprint(outcome& o, figure& energies) {
    disc<> corrected, printed;
    printed.printed_force = true;
    const auto run = [](const disc<>& body) {
        return motion(body, rolling_disc::initial_position(), rolling_disc::initial_velocity(),
                      {.tolerance = tolerance, .end = 0.25});
    };
    const audit good = audited(corrected, run(corrected), "disc, F corrected"),
                bad = audited(printed, run(printed), "disc, F as printed");
    o.text += "Disc with F_3 and F_4 as printed: energy off by " + scientific(bad.at_end) + " J at 0.25 s, " +
              scientific(bad.drift) + " J on the way (corrected: " + scientific(good.drift) +
              " J) while |G q'| stays at " + scientific(bad.violation) + "\n";
    o.findings.push_back(
        {"F as printed, energy change at 0.25 s [J]", "0 (4.3)", scientific(bad.at_end), "1.70e-02",
         std::abs(bad.at_end / 1.7e-2 - 1) < 0.05,
         compared(0, bad.at_end, 1e-9, "F_3, F_4 print -4 alpha' y' for -4 alpha' y", good.drift < 1e-9)});
    o.findings.push_back(
        {"F corrected, energy drift in 0.25 s [J]", "", scientific(good.drift), "0", good.drift < 1e-9});
    o.findings.push_back({"F as printed, the constraint does not see it", "", scientific(bad.violation),
                          "rounding", bad.violation < 1e-11});
    energies.curves.push_back(good.energy);
    energies.curves.push_back(bad.energy);
}

// A disc let go at rest falls flat, beta' = sqrt(8 g (cos beta(0) - cos beta)/(5 R)), and M(q) becomes
// singular.
void falling_disc(outcome& o) {
    const disc<> body;
    stagecraft::singularity_watch watch(body);
    request how{.tolerance = tolerance};
    how.watch = std::ref(watch);
    const vector5 q = rolling_disc::initial_position();
    const trajectory r = motion(body, q, vector5::Zero(), how);
    // With cos beta(0) - cos beta = 2 (sin^2(beta/2) - sin^2(beta(0)/2)) and sin(beta/2) = sin(beta(0)/2)
    // cosh u the integrand is smooth: Simpson's rule.
    const double low = std::sin(q[3] / 2), top = std::acosh(std::sin(watch.position()[3] / 2) / low);
    const auto f = [&](double u) {
        const double s = low * std::cosh(u);
        return 1 / std::sqrt(1 - s * s);
    };
    const int pieces = 400;
    double sum = f(0) + f(top);
    for (int k = 1; k < pieces; ++k) sum += (k % 2 == 1 ? 4 : 2) * f(top * k / pieces);
    const double expected = sum * top / (3 * pieces) * std::sqrt(5 * body.R / (4 * body.g));
    o.text += "Disc let go at rest: " + watch.message() + " (by quadrature " + std::to_string(expected) +
              "), stopped at beta = " + std::to_string(watch.position()[3]) + " after " +
              std::to_string(r.report.steps) + " steps\n";
    o.findings.push_back({"falling disc stopped before beta = pi/2, t [s]", "",
                          watch.found() ? std::to_string(watch.time()) : "not stopped",
                          std::to_string(expected),
                          watch.found() && std::abs(watch.time() - expected) < 1e-6});
}

}  // namespace

outcome nonholonomic_bodies() {
    outcome o{"Further nonholonomic systems: energy and constraint checks", {}, {}, {}};
    figure paths{
        "fig_knife_edge", "Path of the knife edge, 3 s", "y [m]", "x [m], downhill", false, false, {}, true};
    figure track{"fig_sleigh", "Path of Chaplygin's sleigh, 12 s", "x [m]", "y [m]", false, false, {}, true};
    figure heights{"fig_ball", "A ball rolling in an upright cylinder does not fall",
                   "t [s]",    "z [m], χ / 10",
                   false,      false,
                   {}};
    figure energies{"fig_energies",
                    "Change of the energy, tol 10^{-11}",
                    "t / duration of the run",
                    "|change| [J]",
                    false,
                    true,
                    {}};
    figure lost{"fig_misprint",
                "The disc with F as printed and corrected",
                "t [s]",
                "|change of the energy| [J]",
                false,
                true,
                {}};
    knife(o, paths, energies);
    sleigh(o, track, energies);
    ball(o, heights, energies);
    misprint(o, lost);
    falling_disc(o);
    o.figures = {paths, track, heights, energies, lost};
    return o;
}

}  // namespace thesis
