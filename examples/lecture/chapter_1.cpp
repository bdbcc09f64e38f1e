// SPDX-License-Identifier: BSL-1.0
// Chapter 1: qualitative behaviour. Solutions, dissipativity, B-stability, ghosts.
#include <stagecraft/theory/dynamics/absorbing.hpp>
#include <stagecraft/theory/dynamics/expansion_witness.hpp>
#include <stagecraft/theory/dynamics/ghosts.hpp>
#include <stagecraft/theory/dynamics/one_sided_lipschitz.hpp>

#include "lecture.hpp"

namespace lecture {

namespace {

using theory::state;

const auto cubic = [](const auto&, const auto& x, auto& f) { f[0] = x[0] - x[0] * x[0] * x[0]; };
const auto witch = [](const auto&, const auto& x, auto& f) { f[0] = -x[0] / (1 + x[0] * x[0]); };

/// Solutions of x' = f from `starts` at t = 0.
template <class F>
picture solutions(const std::string& name, const std::string& title, const F& f,
                  const std::vector<double>& starts, const plot::window& view) {
    std::vector<plot::curve> all;
    for (const double x : starts) all.push_back(solution<1>(f, state<double, 1>(x), view.right, 400, 1e3));
    return curves(name, title, all, view, "t", "x", named_by_start(starts));
}

void draw_solutions(chapter& out) {
    const auto decay = [](const auto&, const auto& x, auto& f) { f[0] = -x[0]; };
    const auto growth = [](const auto&, const auto& x, auto& f) { f[0] = x[0]; };
    const auto minus_cube = [](const auto&, const auto& x, auto& f) { f[0] = -x[0] * x[0] * x[0]; };
    const auto minus_tx = [](const auto& t, const auto& x, auto& f) { f[0] = -t * x[0]; };
    out.pictures.push_back(solutions("p06_decay", "x' = -x", decay, {-1, 0, 1, 2}, {0, 4, -1.2, 2.2}));
    out.pictures.push_back(solutions("p06_growth", "x' = x", growth, {-1, 0, 1, 2}, {0, 2, -8, 15}));
    out.pictures.push_back(
        solutions("p07_minus_cube", "x' = -x^3", minus_cube, {-1, 0, 1}, {0, 10, -1.1, 1.1}));
    out.pictures.push_back(
        solutions("p11_x_minus_cube", "x' = x - x^3", cubic, {-1, -0.2, 0, 0.1, 1, 1.5}, {0, 6, -1.2, 1.6}));
    out.pictures.push_back(solutions("p12_minus_tx", "x' = -t x", minus_tx, {-1, 1, 2}, {0, 4, -1.2, 2.2}));
}

/// Fixed points of the lecture's example over h: the equilibrium and its ghosts, full where attracting.
void draw_ghosts(chapter& out, const tableau<rational>& example) {
    std::vector<plot::complex> attracting, repelling;
    for (int k = 1; k <= 100; ++k) {
        const rational h(k, 25);
        for (const auto& p : theory::ghosts(example, witch, h).points)
            (p.attracting() ? attracting : repelling).emplace_back(h.to<double>(), p.value());
        for (const auto& p : theory::two_cycles(example, witch, h).points)
            (p.attracting() ? attracting : repelling).emplace_back(h.to<double>(), p.value());
    }
    plot::script p;
    p.size = {720, 480};
    p.set("set title " +
          plot::gnuplot_string("x' = -λ x/(1 + x^2): fixed points and cycles of period 2 of the method") +
          " enhanced");
    p.set("set xrange [0:4]").set("set yrange [-2.5:2.5]").set("set xlabel 'h λ'").set("set ylabel 'x'");
    p.set("set key outside bottom center horizontal height 1");
    p.points(repelling, "pt 6 ps 0.5 lc rgb '#b71c1c' title 'repelling'")
        .points(attracting, "pt 7 ps 0.5 lc rgb '#1f4e79' title 'attracting'");
    out.pictures.push_back({"p23_ghosts", std::move(p)});
}

void count_fixed_points(chapter& out) {
    const rational half(1, 2), sixth(1, 6), third(1, 3);
    const std::vector<std::pair<std::string, tableau<rational>>> methods{
        {"explicit Euler", method({{0}}, {1})},
        {"Heun", method({{0, 0}, {1, 0}}, {half, half})},
        {"improved Euler", method({{0, 0}, {half, 0}}, {0, 1})},
        {"RK4", method({{0, 0, 0, 0}, {half, 0, 0, 0}, {0, half, 0, 0}, {0, 0, 1, 0}},
                       {sixth, third, third, sixth})}};
    const std::vector<std::string> expected{"3 3 3 3 3 3 3", "5 5 9 9 9 9 9", "9 7 9 9 9 9 9",
                                            "5 5 13 13 13 17 21"};
    for (std::size_t k = 0; k < methods.size(); ++k) {
        std::string counts;
        for (const rational& h : {rational(1, 10), rational(1), rational(3, 2), rational(2), rational(5, 2),
                                  rational(3), rational(4)})
            counts += (counts.empty() ? "" : " ") +
                      std::to_string(theory::ghosts(methods[k].second, cubic, h).points.size());
        out.find("fixed points on x - x^3, h = 1/10 ... 4: " + methods[k].first, "not counted", counts,
                 expected[k], counts == expected[k]);
    }
}

}  // namespace

chapter chapter_1() {
    chapter out;
    draw_solutions(out);
    const auto gamma = theory::one_sided_lipschitz<1>(cubic);
    out.find("one-sided Lipschitz constant of x - x^3", "-", gamma.high.str(), "1",
             gamma.low == 1 && gamma.high == 1);

    const auto lorenz = [](const auto&, const auto& x, auto& f) {
        f[0] = 10 * (x[1] - x[0]);
        f[1] = 28 * x[0] - x[1] - x[0] * x[2];
        f[2] = x[0] * x[1] - 8 * x[2] / 3;
    };
    state<rational, 3> top;
    top << rational(0), rational(0), rational(38);
    const auto d = theory::dissipativity<3>(lorenz, 1, top);
    out.find("Lorenz around (0, 0, 38), beta = 1: alpha", "-", d.alpha.str(), "23104/15",
             d.alpha == rational(23104, 15));

    const rational half(1, 2);
    const auto amplification = [](const tableau<rational>& t, const rational& h) {
        const std::vector<rational> z(t.b.size(), -100'000 * h), none(t.b.size(), rational(0));
        return *theory::squared_amplification(t, z, none);
    };
    for (const auto& [name, t] : {std::pair{"explicit Euler", method({{0}}, {1})},
                                  std::pair{"improved Euler", method({{0, 0}, {half, 0}}, {0, 1})}}) {
        const bool exact = amplification(t, rational(2, 100'000)) == 1 &&
                           amplification(t, rational(2'000'001, 100'000'000'000)) > 1;
        out.find(std::string("x' = -1e5 x: largest step of ") + name, "restricted",
                 exact ? "2e-5" : "another", "2e-5", exact);
    }
    const bool unlimited = amplification(method({{1}}, {1}), 1'000'000) < 1;
    out.find("x' = -1e5 x: largest step of implicit Euler", "none", unlimited ? "none up to 1e6" : "limited",
             "none", unlimited);

    const auto jump = [](double, const auto& y, auto& f) {
        if (y[0] < 0)
            f[0] = -y[0] * y[0] * y[0];
        else
            f[0] = -y[0] * y[0];
    };
    const auto trapezoidal = theory::in_doubles(method({{0, 0}, {half, half}}, {half, half}));
    const double moved = (*theory::rk_step<1>(trapezoidal, jump, state<double, 1>(-3.0), 2.0))[0];
    out.find("trapezoidal rule on a monotone field, h = 2: |-3 - 0| becomes", "-", number(moved),
             number((std::sqrt(97.0) - 1) / 2), std::abs(moved - (std::sqrt(97.0) - 1) / 2) < 1e-12);

    const auto example = method({{0, 0}, {1, 0}}, {0, 1});
    const auto found = theory::ghosts(example, witch, rational(3, 2));
    const double ghost = found.points.back().value(), multiplier = found.points.back().multiplier.middle();
    out.find("ghost of -lambda x/(1 + x^2), h lambda = 3/2", "sqrt(h lambda - 1)", number(ghost),
             number(std::sqrt(0.5)), found.points.size() == 3 && std::abs(ghost - std::sqrt(0.5)) < 1e-12);
    out.find("its multiplier 3 - 2 h lambda", "-", number(std::abs(multiplier), "%.6f"), "0.000000",
             std::abs(multiplier) < 1e-9);
    const auto in_double = theory::in_doubles(example);
    state<double, 1> x(0.3);
    for (int n = 0; n < 100; ++n) x = *theory::rk_step<1>(in_double, witch, x, 1.5);
    out.find("a run from 0.3 ends at", "-", number(x[0]), "0.70710678",
             std::abs(x[0] - std::sqrt(0.5)) < 1e-9);
    double upper = 0, lower = 3;
    for (const auto& p : theory::two_cycles(example, witch, 3).points) {
        upper = std::max(upper, p.value());
        if (p.value() > 0) lower = std::min(lower, p.value());
    }
    const double angle = 3.141592653589793 / 12, high = 2 * std::cos(angle), low = 2 * std::sin(angle);
    out.find("cycle of period 2 at h lambda = 3", "-", number(lower) + ", " + number(upper),
             "2 sin 15, 2 cos 15 deg = " + number(low) + ", " + number(high),
             std::abs(upper - high) < 1e-12 && std::abs(lower - low) < 1e-12);
    // (2.3) and the example print t_n1 where t_ni is meant: x' = 2t, x(0) = 0, one step h = 1
    auto improved = theory::in_doubles(method({{0, 0}, {half, 0}}, {0, 1}));
    const auto clock = [](const auto& t, const auto&, auto& f) { f[0] = 2 * t; };
    const double meant = (*theory::rk_step<1>(improved, clock, state<double, 1>(0.0), 1.0))[0];
    improved.c.setZero();
    const double as_printed = (*theory::rk_step<1>(improved, clock, state<double, 1>(0.0), 1.0))[0];
    out.find("x' = 2t, improved Euler with f at t_ni (misprint: t_n1)", "x(1) = " + number(as_printed),
             number(meant), "1", meant == 1 && as_printed != 1);
    draw_ghosts(out, example);
    count_fixed_points(out);
    return out;
}

}  // namespace lecture
