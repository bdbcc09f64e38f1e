// SPDX-License-Identifier: BSL-1.0
// Lecture, section 1.3: fixed points of methods. Which are equilibria of the differential equation, which are
// ghosts.
#define BOOST_TEST_MODULE ghosts
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/dense_once.hpp>
#include <random>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/theory/dynamics/ghosts.hpp>
#include <stagecraft/theory/dynamics/ghosts_in_box.hpp>
#include <stagecraft/theory/dynamics/one_sided_lipschitz.hpp>
#include <stagecraft/theory/dynamics/rk_map.hpp>

#include "../catalogue.hpp"
#include "../message.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;
using tableaux::family;
using tableaux::quadratic;

namespace {

using read_once::exact_methods;

tableau<rational> method(const std::string& name) {
    return tableaux::to_rational(read_once::catalogue().at(name));
}

/// The whole catalogue; of rounded entries the middle of what they can be.
const std::vector<std::pair<std::string, tableau<rational>>>& all_methods() {
    static const auto all = [] {
        std::vector<std::pair<std::string, tableau<rational>>> found;
        for (const auto& [name, f] : read_once::catalogue()) {
            tableau<rational> t;
            const auto s = static_cast<Eigen::Index>(f.b.size());
            t.A.resize(s, s);
            t.b.resize(s);
            t.c = tableaux::column<rational>::Constant(s, rational(0));
            for (Eigen::Index i = 0; i < s; ++i) {
                t.b[i] = f.b[static_cast<std::size_t>(i)].enclosure.middle();
                for (Eigen::Index j = 0; j < s; ++j) {
                    t.A(i, j) =
                        f.A[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].enclosure.middle();
                    t.c[i] += t.A(i, j);
                }
            }
            found.emplace_back(name, t);
        }
        return found;
    }();
    return all;
}

/// The ghost example's method: c = (0, 1), b = (0, 1), a_21 = 1.
tableau<rational> example_method() {
    tableau<rational> t;
    t.A = tableaux::dense<rational>::Constant(2, 2, rational(0));
    t.A(1, 0) = 1;
    t.b = t.c = tableaux::column<rational>::Constant(2, rational(0));
    t.b[1] = t.c[1] = 1;
    return t;
}

const auto cubic = [](const auto&, const auto& x, auto& f) { f[0] = x[0] - x[0] * x[0] * x[0]; };
/// -lambda x/(1 + x^2); lambda = 1, so h is h lambda.
const auto witch = [](const auto&, const auto& x, auto& f) { f[0] = -x[0] / (1 + x[0] * x[0]); };

}  // namespace

BOOST_AUTO_TEST_CASE(real_fixed_points_of_four_explicit_methods_on_x_minus_x_cubed_are_counted) {
    const std::vector<rational> steps{rational(1, 10), 1, rational(3, 2), 2, rational(5, 2), 3, 4};
    const std::vector<std::pair<std::string, std::vector<int>>> expected{
        {"explicit_euler", {3, 3, 3, 3, 3, 3, 3}},
        {"heun_2", {5, 5, 9, 9, 9, 9, 9}},
        {"explicit_midpoint", {9, 7, 9, 9, 9, 9, 9}},
        {"classical_rk4", {5, 5, 13, 13, 13, 17, 21}}};
    for (const auto& [name, counts] : expected) {
        for (std::size_t k = 0; k < steps.size(); ++k) {
            const auto found = ghosts(method(name), cubic, steps[k]);
            BOOST_TEST(found.verdict.is_proved());
            BOOST_TEST(static_cast<int>(found.points.size()) == counts[k], name << ", h = " << steps[k]);
            BOOST_TEST(found.ghosts() == counts[k] - 3, name << ", h = " << steps[k]);
        }
    }
}

BOOST_AUTO_TEST_CASE(every_ghost_is_a_fixed_point_of_the_map_and_its_multiplier_a_difference_quotient) {
    const auto rk4 = in_doubles(method("classical_rk4"));
    for (const auto& p : ghosts(method("classical_rk4"), cubic, 3).points) {
        const auto at = [&](double x) { return (*rk_step<1>(rk4, cubic, state<double, 1>(x), 3.0))[0]; };
        const double x = p.value(), d = 1e-6, slope = (at(x + d) - at(x - d)) / (2 * d);
        BOOST_TEST(std::abs(at(x) - x) <= 1e-11 * (1 + p.multiplier.magnitude()));
        BOOST_TEST(std::abs(slope - p.multiplier.middle()) <= 1e-4 * (1 + p.multiplier.magnitude()));
        BOOST_TEST(p.equilibrium == (std::abs(x * (1 - x * x)) < 1e-12));
    }
}

BOOST_AUTO_TEST_CASE(the_lectures_example_has_the_ghosts_plus_minus_root_of_h_lambda_minus_1) {
    for (const rational& h : {rational(5, 4), rational(3, 2), rational(19, 10), rational(3), rational(10)}) {
        const auto found = ghosts(example_method(), witch, h);
        const double hl = h.to<double>(), root = std::sqrt(hl - 1);
        BOOST_REQUIRE(found.points.size() == 3u);
        BOOST_TEST(found.ghosts() == 2);
        BOOST_TEST(std::abs(found.points[0].value() + root) < 1e-12);
        BOOST_TEST((found.points[1].value() == 0 && found.points[1].equilibrium));
        BOOST_TEST(std::abs(found.points[2].value() - root) < 1e-12);
        BOOST_TEST(std::abs(found.points[2].multiplier.middle() - (3 - 2 * hl)) < 1e-9);
        BOOST_TEST(found.points[2].attracting() == (hl < 2));
    }
    for (const rational& h : {rational(1, 2), rational(1)})  // no ghosts up to h lambda = 1
        BOOST_TEST(ghosts(example_method(), witch, h).ghosts() == 0);
}

BOOST_AUTO_TEST_CASE(a_run_of_the_example_ends_at_its_ghost_and_at_h_lambda_3_in_a_cycle) {
    const auto m = in_doubles(example_method());
    state<double, 1> x(0.3);
    for (int n = 0; n < 200; ++n) x = *rk_step<1>(m, witch, x, 1.5);
    BOOST_TEST(std::abs(x[0] - std::sqrt(0.5)) < 1e-12);
    const auto cycle = two_cycles(example_method(), witch, 3);
    BOOST_TEST(cycle.verdict.is_proved());
    const double pi = 3.141592653589793;
    for (const double expected : {2 * std::cos(pi / 12), 2 * std::sin(pi / 12)}) {
        const auto p = std::find_if(cycle.points.begin(), cycle.points.end(),
                                    [&](const auto& q) { return std::abs(q.value() - expected) < 1e-12; });
        BOOST_REQUIRE((p != cycle.points.end()));
        const auto twice = rk_step<1>(m, witch, *rk_step<1>(m, witch, state<double, 1>(expected), 3), 3);
        BOOST_TEST(std::abs((*twice)[0] - expected) < 1e-12);
    }
    BOOST_TEST(two_cycles(method("classical_rk4"), cubic, 1).verdict.is_consistent());  // degree 81^2
}

BOOST_AUTO_TEST_CASE(no_point_is_fixed_or_periodic_at_which_a_stage_meets_a_pole) {
    const auto inverse = [](const auto&, const auto& x, auto& f) { f[0] = 1 / x[0]; };
    // k_1 = f(0) has no value; the map x + x/(x^2 + 1/2) has one
    const auto none = ghosts(method("explicit_midpoint"), inverse, 1);
    BOOST_TEST(none.verdict.is_proved());
    BOOST_TEST(none.points.empty());
    BOOST_TEST(none.verdict.reason().ends_with("excluded: 0, where a stage divides by zero"),
               none.verdict.text());
    // x/(x^2 - 1): X_2 = +-1/sqrt 2 + k_1/2 = 0
    const auto poles = [](const auto&, const auto& x, auto& f) { f[0] = x[0] / (x[0] * x[0] - 1); };
    const auto two = ghosts(method("explicit_midpoint"), poles, 1);
    BOOST_REQUIRE(two.points.size() == 3u);
    BOOST_TEST(two.ghosts() == 2);
    BOOST_TEST(two.points[1].value() == 0);
    for (const int k : {0, 2})
        BOOST_TEST(std::abs(std::abs(two.points[static_cast<std::size_t>(k)].value()) - std::sqrt(0.5)) <
                   1e-14);
    // u = x - 1: u_1 = u^-3, so u_2 = u^9 = u for u = +-1 only, which are fixed
    const auto cube = [](const auto&, const auto& x, auto& f) {
        f[0] = -x[0] + 1 + 1 / ((x[0] - 1) * (x[0] - 1) * (x[0] - 1));
    };
    const auto cycles = two_cycles(method("explicit_euler"), cube, 1);
    BOOST_TEST(cycles.verdict.is_proved());
    BOOST_TEST(cycles.points.empty(), cycles.verdict.text());
    BOOST_TEST(ghosts(method("explicit_euler"), cube, 1).points.size() == 2u);
    // Also where the first step ends in a pole: x_1 = -1/x + x sends +-1 to 0, and the second step does not exist
    const auto minus = [](const auto&, const auto& x, auto& f) { f[0] = -1 / x[0]; };
    for (const auto& p : two_cycles(method("explicit_euler"), minus, 1).points)
        BOOST_TEST(std::abs(std::abs(p.value()) - std::sqrt(0.5)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(what_f_divides_by_must_not_vanish_although_it_cancels_nor_in_a_stage_without_weight) {
    const auto cancelled = [](const auto&, const auto& x, auto& f) { f[0] = x[0] * (1 - x[0]) / x[0]; };
    const auto one = ghosts(method("explicit_euler"), cancelled, 1);
    BOOST_REQUIRE(one.points.size() == 1u);
    BOOST_TEST((one.points[0].value() == 1 && one.points[0].equilibrium));
    BOOST_TEST(message([&] { one_sided_lipschitz<1>(cancelled); }).starts_with("f: divides through zero"));
    BOOST_TEST(message([&] { refuting_pair(cancelled, 0); }).starts_with("f: divides through zero"));
    BOOST_CHECK_THROW(as_rational_function(cancelled)(rational(0)), std::domain_error);
    BOOST_TEST((as_rational_function(cancelled)(rational(3)) == -2));
    // The midpoint rule's ghost -1 of 2 (x - 1)/x: k_1 = 4, X_2 = 1; a third stage that nothing uses lies at the pole.
    const auto f = [](const auto&, const auto& x, auto& out) { out[0] = 2 * (x[0] - 1) / x[0]; };
    BOOST_TEST(ghosts(method("explicit_midpoint"), f, 1).ghosts() == 1);
    tableau<rational> three;
    three.A = tableaux::dense<rational>::Constant(3, 3, rational(0));
    three.b = three.c = tableaux::column<rational>::Constant(3, rational(0));
    three.A(1, 0) = three.c[1] = rational(1, 2);
    three.A(2, 0) = three.c[2] = rational(1, 4);
    three.b[1] = 1;
    BOOST_TEST(ghosts(three, f, 1).ghosts() == 0);
    auto idle = example_method();
    idle.A(1, 0) = idle.c[1] = 0;
    idle.b << rational(1), rational(0);
    const auto hidden = [](const auto&, const auto& x, auto& out) { out[0] = (1 - x[0]) * x[0] / x[0]; };
    BOOST_TEST(ghosts_in<1>(idle, hidden, 1, box<1>(interval(0.5, 2))).zeros.size() == 1u);
    BOOST_TEST(
        ghosts_in<1>(idle, hidden, 1, box<1>(interval(-0.5, 2)), {.boxes = 500}).verdict.is_consistent());
}

BOOST_AUTO_TEST_CASE(fixed_points_of_random_rational_fields_are_those_of_the_stages_in_exact_arithmetic) {
    // f = p/q with linear and quadratic q whose zeros are rational: every reported point has stages away from them.
    std::mt19937 random(5);
    std::uniform_int_distribution<int> pick(-3, 3);
    int points = 0, excluded = 0;
    for (int k = 0; k < 60; ++k) {
        const int a = pick(random), b = pick(random), c = pick(random), d = pick(random);
        const auto f = [&](const auto&, const auto& x, auto& out) {
            out[0] = (x[0] + a) * (x[0] + b) / ((x[0] + c) * (x[0] + d));
        };
        for (const char* name : {"explicit_euler", "explicit_midpoint", "heun_2"}) {
            if (a == c && b == d) continue;
            const auto t = method(name);
            const auto found = ghosts(t, f, 1);
            excluded += found.verdict.reason().find("excluded") != std::string::npos ? 1 : 0;
            for (const auto& p : found.points) {
                ++points;
                BOOST_TEST(p.multiplier.bounded());
                std::vector<double> slopes;
                double sum = 0;
                for (Eigen::Index i = 0; i < t.b.size(); ++i) {
                    double x = p.value();
                    for (Eigen::Index j = 0; j < i; ++j)
                        x += t.A(i, j).to<double>() * slopes[static_cast<std::size_t>(j)];
                    BOOST_TEST(std::abs((x + c) * (x + d)) > 1e-9, name);
                    slopes.push_back((x + a) * (x + b) / ((x + c) * (x + d)));
                    sum += t.b[i].to<double>() * slopes.back();
                }
                BOOST_TEST(std::abs(sum) < 1e-6 * (1 + std::abs(slopes[0])), name);
            }
        }
    }
    BOOST_TEST(points > 100);
    BOOST_TEST(excluded >= 3);
}

BOOST_AUTO_TEST_CASE(linear_problems_have_no_ghosts_for_gauss_1_and_2_and_for_no_method_of_order_above_4) {
    for (const int s : {1, 2})
        BOOST_TEST(no_linear_ghosts(stability_function_of(*tableaux::exact_tableau(family::gauss, s))));
    const auto gauss_3 = stability_function_of(*tableaux::exact_tableau(family::gauss, 3));
    BOOST_TEST(!no_linear_ghosts(gauss_3));
    // P - Q is a multiple of z (z^2 + 60): h lambda = +-i sqrt 60
    const auto p = monic(fixed_point_equation(gauss_3));
    BOOST_TEST((p == polynomial<quadratic>{quadratic(0), quadratic(60), quadratic(0), quadratic(1)}));
    int with_property = 0, above_4 = 0;
    for (const auto& [name, t] : exact_methods())
        with_property += no_linear_ghosts(stability_function_of(t)) ? 1 : 0;
    BOOST_TEST(with_property >= 3);
    // Rounded tables as well: a coefficient of P - Q other than that of z is far from 0.
    for (const auto& [name, t] : all_methods()) {
        const auto order = read_once::catalogue().at(name).claims.order;
        if (!order || *order <= 4) continue;
        ++above_4;
        const auto equation = fixed_point_equation(stability_function_of(t));
        bool another = false;
        for (int k = 2; k <= equation.degree(); ++k)
            another = another || abs(equation[k]) > rational(1, 100'000);
        BOOST_TEST(another, name);
    }
    BOOST_TEST(above_4 >= 30);
}

BOOST_AUTO_TEST_CASE(krawczyk_finds_the_same_fixed_points_as_sturm) {
    const auto midpoint = method("explicit_midpoint");
    box<1> where(interval(-9, 9));
    const auto exact = ghosts(midpoint, cubic, 2);
    const auto found = ghosts_in<1>(midpoint, cubic, 2, where);
    BOOST_TEST(found.verdict.is_proved(), found.verdict.text());
    BOOST_TEST(found.zeros.size() == exact.points.size());
    for (const auto& p : exact.points) {
        const auto here = [&](const interval_vector& z) {
            return z[0].low() <= p.value() + 1e-12 && p.value() - 1e-12 <= z[0].high();
        };
        BOOST_TEST(std::count_if(found.zeros.begin(), found.zeros.end(), here) == 1);
    }
}

BOOST_AUTO_TEST_CASE(methods_of_one_stage_have_no_ghosts_and_lobatto_iiic_has_some) {
    box<1> where(interval(-4, 4));
    for (const char* name : {"implicit_euler", "implicit_midpoint"}) {
        const auto found = ghosts_in<1>(method(name), cubic, 3, where);
        BOOST_TEST(found.verdict.is_proved());
        BOOST_TEST(found.zeros.size() == 3u);
        BOOST_TEST(found.ghosts() == 0);
        BOOST_TEST(found.count(fixed_point_kind::equilibrium) == 3);
        for (const auto& z : found.zeros) BOOST_TEST((z[0] - z[0] * z[0] * z[0]).contains(0.0));
    }
    const auto found =
        ghosts_in<1>(*tableaux::exact_tableau(family::lobatto_iiic, 2), cubic, rational(5, 2), where);
    BOOST_TEST(found.verdict.is_proved(), found.verdict.text());
    BOOST_TEST(found.zeros.size() == 5u);
    BOOST_TEST(found.ghosts() == 2);
    BOOST_TEST(found.count(fixed_point_kind::equilibrium) == 3);
    for (const auto& z : found.zeros) {  // the stage equations in doubles
        const double x = z[0].middle(), u = z[1].middle(), v = z[2].middle();
        const auto f = [](double y) { return y - y * y * y; };
        BOOST_TEST(std::abs(f(u) + f(v)) < 1e-9);
        BOOST_TEST(std::abs(u - x - 1.25 * (f(u) - f(v))) < 1e-9);
        BOOST_TEST(std::abs(v - x - 1.25 * (f(u) + f(v))) < 1e-9);
    }
    // At h = 3 the ghosts lie where f' = 0, as double zeros: not decided, and said where.
    const auto touching =
        ghosts_in<1>(*tableaux::exact_tableau(family::lobatto_iiic, 2), cubic, 3, where, {.boxes = 3000});
    BOOST_TEST(touching.verdict.is_consistent());
    BOOST_TEST(
        std::any_of(touching.undecided.begin(), touching.undecided.end(), [](const interval_vector& x) {
            return x[0].low() <= -std::sqrt(1.0 / 3) && -std::sqrt(1.0 / 3) <= x[0].high();
        }));
}

BOOST_AUTO_TEST_CASE(cycles_of_period_two_are_found_in_a_box_and_excluded_for_the_implicit_midpoint_rule) {
    // the lecture's example, h lambda = 3: 2 cos 15 deg and 2 sin 15 deg
    const double pi = 3.141592653589793;
    const auto cycle = two_cycles_in<1>(example_method(), witch, 3, box<1>(interval(-0.8, 2)));
    BOOST_TEST(cycle.verdict.is_proved(), cycle.verdict.text());
    BOOST_TEST(cycle.zeros.size() == 2u);
    for (const auto& z : cycle.zeros)
        BOOST_TEST(std::min(std::abs(z[0].middle() - 2 * std::cos(pi / 12)),
                            std::abs(z[0].middle() - 2 * std::sin(pi / 12))) < 1e-9);
    // x_1 - x_0 = h f((x_0 + x_1)/2) = x_0 - x_1: there is none
    const auto none = two_cycles_in<1>(method("implicit_midpoint"), cubic, 3, box<1>(interval(-4, 4)));
    BOOST_TEST(none.verdict.is_proved(), none.verdict.text());
    BOOST_TEST(none.zeros.empty());
}

BOOST_AUTO_TEST_CASE(satz_1_6_3_a_contractive_field_has_one_equilibrium_and_the_rate_is_met) {
    const auto f = [](const auto&, const auto& x, auto& out) {
        out[0] = 1 - 2 * x[0] + x[1] - x[0] * x[0] * x[0];
        out[1] = -x[0] - 2 * x[1];
    };
    const auto gamma = one_sided_lipschitz<2>(f);
    BOOST_TEST((gamma.verdict.is_proved() && gamma.high == -2));
    box<2> where;
    where[0] = where[1] = interval(-50, 50);
    const auto e = equilibria<2>(f, where);
    BOOST_TEST(e.verdict.is_proved());
    BOOST_REQUIRE(e.zeros.size() == 1u);
    // x_1 of the equilibrium solves 1 = 5/2 x + x^3
    const double c = e.zeros[0][0].middle();
    BOOST_TEST(std::abs(2.5 * c + c * c * c - 1) < 1e-12);
    state<double, 2> x(3, -4), fx;
    const state<double, 2> centre(c, e.zeros[0][1].middle());
    const auto gauss_2 = in_doubles(*tableaux::exact_tableau(family::gauss, 2));
    const double first = (x - centre).norm();
    for (int n = 1; n <= 200; ++n) {
        f(0.0, x, fx);
        BOOST_TEST(fx.dot(centre - x) >= 0);  // f points towards c
        x = *rk_step<2>(gauss_2, f, x, 0.01);
        BOOST_TEST((x - centre).norm() <= first * std::exp(-2 * 0.01 * n) * (1 + 1e-6));
    }
}

BOOST_AUTO_TEST_CASE(satz_1_6_3_with_gamma_0_there_is_a_line_of_equilibria_or_none) {
    const auto rotation = [](const auto&, const auto& x, auto& f) {
        f[0] = -x[1];
        f[1] = x[0];
        f[2] = 0;
    };
    const auto constant = [](const auto&, const auto&, auto& f) { f[0] = 1; };
    box<3> cube;
    cube[0] = cube[1] = cube[2] = interval(-1, 1);
    const auto line = equilibria<3>(rotation, cube, {.boxes = 500});
    BOOST_TEST(line.verdict.is_consistent());  // not isolated: nothing is claimed to be unique
    BOOST_TEST(line.zeros.empty());
    BOOST_TEST(!line.undecided.empty());
    box<1> wide(interval(-1e6, 1e6));
    const auto none = equilibria<1>(constant, wide);
    BOOST_TEST((none.verdict.is_proved() && none.zeros.empty()));
}

BOOST_AUTO_TEST_CASE(rational_constants_of_f_serve_on_the_line_and_in_boxes) {
    const rational third(1, 3);
    const auto f = [&](const auto&, const auto& x, auto& out) {
        out[0] = (third - x[0]) * (x[0] + third) * third / (rational(2) + x[0] * x[0]) + x[0] * third -
                 third * x[0];
    };
    const box<1> where(interval(-1, 1));
    BOOST_TEST(ghosts(method("explicit_euler"), f, 1).points.size() == 2u);
    BOOST_TEST(ghosts_in<1>(method("explicit_euler"), f, 1, where).zeros.size() == 2u);
    const auto found = equilibria<1>(f, where);
    BOOST_TEST(found.verdict.is_proved());
    BOOST_REQUIRE(found.zeros.size() == 2u);
    for (const auto& z : found.zeros)
        BOOST_TEST((interval(third).contains(abs(z[0])) || abs(z[0]).contains(interval(third))));
    const auto exact = one_sided_lipschitz<1>(f), boxed = one_sided_lipschitz_on<1>(f, where);
    BOOST_TEST((exact.verdict.is_proved() && boxed.verdict.is_proved()));
    BOOST_TEST(std::abs(exact.high.to<double>() - boxed.high.to<double>()) < 1e-3);
}

BOOST_AUTO_TEST_CASE(bad_input_of_ghosts_is_named) {
    BOOST_TEST(
        message([] { ghosts(method("explicit_euler"), cubic, 0); }).starts_with("h: must be positive"));
    BOOST_TEST(
        message([] { ghosts(method("implicit_euler"), cubic, 1); }).starts_with("method: must be explicit"));
    box<1> open(interval::whole());
    BOOST_TEST(message([&] { ghosts_in<1>(method("implicit_euler"), cubic, 1, open); }).starts_with("box: "));
    BOOST_TEST(message([&] { equilibria<1>(cubic, open); }).starts_with("box: "));
    const auto nothing = [](const auto&, const auto&, auto& f) { f[0] = 0; };
    BOOST_TEST(message([&] { ghosts(method("explicit_euler"), nothing, 1); }).starts_with("f: every point"));
    box<1> few(interval(-4, 4));
    const auto early =
        ghosts_in<1>(*tableaux::exact_tableau(family::lobatto_iiic, 2), cubic, 3, few, {.boxes = 5});
    BOOST_TEST(early.verdict.is_consistent());
    BOOST_TEST(!early.undecided.empty());
}
