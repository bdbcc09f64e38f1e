// SPDX-License-Identifier: BSL-1.0
#include "error_picture.hpp"

#include <stagecraft/integrate.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <stdexcept>

namespace stagecraft::tool {

namespace {

using vector = Eigen::VectorXd;
namespace plot = theory::plot;

/// y' = f(t, y) from t = 0 to `end`, with the Jacobian and the solution.
struct known_problem {
    const char* name;
    const char* equation;
    double end;
    std::function<void(double, const vector&, vector&)> f;
    std::function<void(double, const vector&, Eigen::MatrixXd&)> f_y;
    std::function<vector(double)> solution;

    void operator()(double t, const vector& y, vector& out) const { f(t, y, out); }
    void jacobian(double t, const vector& y, Eigen::MatrixXd& J) const { f_y(t, y, J); }
};

/// The last one is stiff: a method of order p and stage order q < p shows about q + 1 or q there (Prothero and Robinson).
const std::array<known_problem, 3>& problems() {
    static const std::array<known_problem, 3> all = {
        known_problem{"smooth", "y' = y cos t", 1,
                      [](double t, const vector& y, vector& f) { f[0] = y[0] * std::cos(t); },
                      [](double t, const vector&, Eigen::MatrixXd& J) { J(0, 0) = std::cos(t); },
                      [](double t) { return vector::Constant(1, std::exp(std::sin(t))).eval(); }},
        known_problem{"oscillator", "q' = p, p' = -q", 2,
                      [](double, const vector& y, vector& f) { f[0] = y[1], f[1] = -y[0]; },
                      [](double, const vector&, Eigen::MatrixXd& J) { J << 0, 1, -1, 0; },
                      [](double t) {
                          vector y(2);
                          y << std::cos(t), -std::sin(t);
                          return y;
                      }},
        known_problem{
            "prothero-robinson", "y' = -10^6 (y - cos t) - sin t", 1,
            [](double t, const vector& y, vector& f) { f[0] = -1e6 * (y[0] - std::cos(t)) - std::sin(t); },
            [](double, const vector&, Eigen::MatrixXd& J) { J(0, 0) = -1e6; },
            [](double t) { return vector::Constant(1, std::cos(t)).eval(); }}};
    return all;
}

/// Nothing where the run fails.
std::optional<double> error_of(const tableau<double>& method, const known_problem& p, int steps) {
    const vector y0 = p.solution(0);
    const auto r =
        integrate(method, p, y0, 0, p.end,
                  {.rtol = 1e-14, .atol = 1e-14, .fixed_step = p.end / steps, .max_steps = 1000000});
    if (!r.ok() || !r.y.allFinite()) return std::nullopt;
    return (r.y - p.solution(p.end)).norm();
}

struct line {
    plot::curve points;
    std::string slope = "no slope";
};

line line_of(const tableau<double>& method, const known_problem& p) {
    constexpr double noise = 1e-12, far = 0.1;
    line drawn;
    plot::complex before{0, 0};
    for (int steps = 1; steps <= 1024; steps *= 2) {
        const auto error = error_of(method, p, steps);
        if (!error || !(*error > noise / 100) || *error > 1e3) continue;
        const plot::complex here{p.end / steps, *error};
        if (before.real() > 0 && *error > noise && before.imag() < far) {
            char text[32];
            std::snprintf(text, sizeof text, "slope %.1f",
                          std::log2(before.imag() / here.imag()) / std::log2(before.real() / here.real()));
            drawn.slope = text;
        }
        drawn.points.points.push_back(here);
        before = here;
    }
    return drawn;
}

}  // namespace

std::string error_problems() {
    std::string names;
    for (const auto& p : problems()) names += (names.empty() ? "" : ", ") + std::string(p.name);
    return names;
}

plot::script error_picture(const std::vector<named_method>& methods, const std::string& problem) {
    static constexpr const char* colour[] = {"#b71c1c", "#2e7d32", "#1f4e79",
                                             "#e08e0b", "#6a1b9a", "#00838f"};
    const known_problem* chosen = nullptr;
    for (const auto& p : problems())
        if (p.name == problem) chosen = &p;
    if (!chosen)
        throw std::invalid_argument("problem: unknown '" + problem + "', allowed: " + error_problems());
    plot::script picture;
    picture.title("Error over step size: " + problem, chosen->equation);
    picture.set("set logscale xy").set("set format x '10^{%T}'").set("set format y '10^{%T}'");
    picture.set("set xlabel 'step size h'").set("set ylabel 'error at the end'").set("set grid");
    picture.set("set key below noenhanced");
    bool any = false;
    for (std::size_t k = 0; k < methods.size(); ++k) {
        const line drawn = line_of(methods[k].method, *chosen);
        if (drawn.points.points.empty()) continue;
        any = true;
        const std::string style = "lc rgb '" + std::string(colour[k % 6]) + "' ";
        picture.lines({drawn.points}, style + "lw 2 title " +
                                          plot::gnuplot_string(methods[k].name + " (" + drawn.slope + ")"));
        picture.points(drawn.points.points, style + "pt 7 ps 0.6");
    }
    if (!any) throw std::invalid_argument("METHOD: no run ends, with 1 to 1024 steps");
    return picture;
}

}  // namespace stagecraft::tool
