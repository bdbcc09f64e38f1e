// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE nystrom
// Embedded pairs hold their tolerance, and what a run of a second order system is given and gives.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/nystrom.hpp>
#include <stagecraft/coefficients/partitioned.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/nystrom.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/tableaux/read_method.hpp>
#include <string>
#include <tuple>
#include <utility>

#include "../message.hpp"
#include "../stepper/interrupt.hpp"

using namespace stagecraft;
using Eigen::Vector2d, Eigen::Vector4d, Eigen::VectorXd;

namespace {

velocity_nystrom_method<double> file(const std::string& name) {
    return tableaux::read_nystrom(STAGECRAFT_SOURCE_DIR "/tableaux/pairs/" + name + ".json");
}

const double pi = 4 * std::atan(1.0), eccentricity = 0.6;
const Vector4d perihelion(1 - eccentricity, 0, 0, std::sqrt((1 + eccentricity) / (1 - eccentricity)));
const auto kepler = second_order([](double, const Vector2d& q) -> Vector2d {
    const double r = q.norm();
    return -q / (r * r * r);
});
const Vector4d aphelion(-1 - eccentricity, 0, 0, -std::sqrt((1 - eccentricity) / (1 + eccentricity)));

}  // namespace

BOOST_AUTO_TEST_CASE(pairs_hold_the_tolerance_and_their_order_of_cost) {
    for (const auto& [name, order] : {std::pair<std::string, int>{"dormand_prince_rkn_4_3", 4},
                                      {"dormand_prince_rkn_5_4", 5},
                                      {"dormand_prince_rkn_6_4", 6},
                                      {"dormand_prince_rkn_8_6", 8}}) {
        const auto m = file(name);
        double last_error = 1;
        for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
            const auto r =
                integrate(m, kepler, perihelion, 0, 3 * pi, {.rtol = tolerance, .atol = tolerance});
            BOOST_TEST(r.ok());
            const double error = (r.y - aphelion).norm();
            BOOST_TEST(error < 100 * tolerance, name << ": " << error << " at " << tolerance);
            BOOST_TEST(error < last_error);
            BOOST_TEST(r.report.rejected_error < r.report.steps / 2);
            last_error = error;
        }
    }
}

BOOST_AUTO_TEST_CASE(a_last_stage_that_is_the_next_first_costs_nothing) {
    const auto cost = [](const char* name) {
        const auto r = integrate(file(name), kepler, perihelion, 0, 1, {.fixed_step = 0.01});
        return std::pair(r.report.steps, r.report.f);
    };
    BOOST_TEST((cost("dormand_prince_rkn_4_3") == std::pair(100L, 1 + 3 * 100L)));
    BOOST_TEST((cost("stoermer_verlet_nystrom") == std::pair(100L, 1 + 100L)));
    BOOST_TEST((cost("nystrom_5") == std::pair(100L, 4 * 100L)));
}

BOOST_AUTO_TEST_CASE(the_solution_between_steps_and_events) {
    const auto m = file("dormand_prince_rkn_6_4");
    const options<> o{.rtol = 1e-9, .atol = 1e-9};
    solution<Vector4d> y;
    const auto r = integrate(m, kepler, perihelion, 0, 2 * pi, o, y);
    BOOST_TEST(r.ok());
    for (const double t : {0.3, 1.1, 2.9, 4.4}) {
        const auto there = integrate(m, kepler, perihelion, 0, t, {.rtol = 1e-13, .atol = 1e-13});
        BOOST_TEST((y(t) - there.y).norm() < 3e-6);
        BOOST_TEST((y.derivative(t).head(2) - y(t).tail(2)).norm() < 1e-12);  // q' = v
    }
    const auto crossing = event([](double, const Vector4d& x) { return x[1]; },
                                {.direction = crossing::falling, .terminal = true});
    const auto half = integrate(m, kepler, perihelion, 0, 2 * pi, o, events<Vector4d>(crossing));
    BOOST_TEST(std::abs(half.t - pi) < 1e-6);
}

BOOST_AUTO_TEST_CASE(a_run_that_is_cut_goes_on_with_the_same_bits) {
    interrupted::at_five_places(file("dormand_prince_rkn_4_3"), kepler, perihelion, 2, {.rtol = 1e-8});
    interrupted::at_five_places(file("nystrom_5"), kepler, perihelion, 2, {.fixed_step = 0.01});
}

BOOST_AUTO_TEST_CASE(velocities_where_the_method_is_for_them) {
    const auto damped =
        second_order([](double, const auto& q, const auto& v) { return (-q - v).eval(); });  // D = 1/2
    const VectorXd y0 = Vector2d(1, 0);
    const double w = std::sqrt(0.75);
    const double exact = std::exp(-0.5) * (std::cos(w) + std::sin(w) / (2 * w));
    BOOST_TEST(std::abs(integrate(file("nystrom_4"), damped, y0, 0, 1, {.fixed_step = 0.01}).y[0] - exact) <
               1e-9);
    BOOST_TEST(
        message([&] { integrate(file("nystrom_5"), damped, y0, 0, 1, {.fixed_step = 0.01}); }) ==
        "integrate: this Nystrom method is for q'' = f(t, q): with f(t, q, v) it would have order 1; take "
        "one with A, or a Runge-Kutta tableau");
    // Other methods take it as well, in matrices of half the size.
    const auto stiff = integrate(radau_iia<3>(), damped, y0, 0, 1, {.rtol = 1e-9, .atol = 1e-9});
    BOOST_TEST(std::abs(stiff.y[0] - exact) < 1e-8);
    BOOST_TEST(stiff.report.found.has(capability::second_order_components));
}

BOOST_AUTO_TEST_CASE(what_a_method_cannot_do_is_said) {
    const auto spring = second_order([](double, const VectorXd& q) -> VectorXd { return -q; });
    const auto says = [&](const auto& m, int n, const options<>& o) {
        return message([&] { integrate(m, spring, VectorXd(VectorXd::Ones(n)), 0, 1, o); });
    };
    BOOST_TEST(says(file("nystrom_5"), 2, {}) ==
               "integrate: method has no embedded weights to estimate errors with; use options.fixed_step");
    BOOST_TEST(says(file("dormand_prince_rkn_4_3"), 3, {}) ==
               "integrate: y0 = (q, v) must have an even number of components, as many q as v");
    auto implicit = file("nystrom_5");
    implicit.A_bar(0, 0) = 0.1;
    BOOST_TEST(says(implicit, 2, {}) ==
               "integrate: Nystrom method: A_bar and A must be strictly lower triangular");
    auto uneven = file("nystrom_5");
    uneven.c.conservativeResize(3);
    BOOST_TEST(says(uneven, 2, {}) ==
               "integrate: Nystrom method: c, A_bar, b_bar and b must have the same number of stages");
    BOOST_TEST(message<tableaux::unusable_input>([] {
                   file("ark3");
               }).ends_with("has the form \"additive\", not \"nystrom\""));
    BOOST_TEST(message<tableaux::unusable_input>([] { file("../catalogue/rk4"); }) != "no exception");
    BOOST_TEST(message<tableaux::unusable_input>([] {
                   tableaux::read_partitioned(STAGECRAFT_SOURCE_DIR "/tableaux/pairs/nystrom_4.json");
               }).ends_with("has the form \"nystrom\", not \"partitioned\" or \"separable\""));
}

BOOST_AUTO_TEST_CASE(orders_by_trees_are_those_of_the_files) {
    for (const auto& [name, p, embedded] : {std::tuple<std::string, int, int>{"dormand_prince_rkn_4_3", 4, 3},
                                            {"dormand_prince_rkn_5_4", 5, 4},
                                            {"dormand_prince_rkn_6_4", 6, 4},
                                            {"dormand_prince_rkn_8_6", 8, 6},
                                            {"nystrom_4", 4, -1},
                                            {"nystrom_5", 5, -1},
                                            {"stoermer_verlet_nystrom", 2, -1}}) {
        const auto m = file(name);
        const nystrom_trees<double> trees(m.c, m.A_bar, m.A, 9);
        BOOST_TEST(trees.order(m.b_bar, m.b) == p, name);
        if (embedded > 0) BOOST_TEST(trees.order(m.b_bar_embedded, m.b_embedded) == embedded, name);
    }
}

BOOST_AUTO_TEST_CASE(generated_methods_are_those_of_the_files) {
    const auto same = [](const auto& m, const std::string& name) {
        const auto read = file(name);
        BOOST_TEST((m.c == read.c && m.A_bar == read.A_bar && m.b_bar == read.b_bar && m.b == read.b), name);
        BOOST_TEST((m.b_embedded == read.b_embedded && m.b_bar_embedded == read.b_bar_embedded), name);
        BOOST_TEST(m.order == read.order);
        if constexpr (requires { m.A; }) BOOST_TEST((m.A == read.A), name);
    };
    same(stoermer_verlet_nystrom(), "stoermer_verlet_nystrom");
    same(nystrom_4(), "nystrom_4");
    same(nystrom_5(), "nystrom_5");
    same(dormand_prince_rkn_4_3(), "dormand_prince_rkn_4_3");
    same(dormand_prince_rkn_5_4(), "dormand_prince_rkn_5_4");
    same(dormand_prince_rkn_6_4(), "dormand_prince_rkn_6_4");
    same(dormand_prince_rkn_8_6(), "dormand_prince_rkn_8_6");
    const auto same_pair = [](const auto& m, const std::string& name) {
        const auto read =
            tableaux::read_partitioned(STAGECRAFT_SOURCE_DIR "/tableaux/pairs/" + name + ".json");
        for (const auto& [a, b] : {std::pair(detail::with_stages<double, dynamic>(m.first), read.first),
                                   std::pair(detail::with_stages<double, dynamic>(m.second), read.second)})
            BOOST_TEST((a.A == b.A && a.b == b.b && a.c == b.c), name);
        BOOST_TEST(m.separable == read.separable, name);
    };
    same_pair(symplectic_euler(), "symplectic_euler");
    same_pair(stoermer_verlet(), "stoermer_verlet");
    same_pair(ruth_3(), "ruth_3");
    same_pair(forest_ruth_4(), "forest_ruth_4");
    same_pair(mclachlan_4(), "mclachlan_4");
    same_pair(blanes_moan_4(), "blanes_moan_4");
    static_assert(std::is_same_v<decltype(ruth_3()), separable_method<double, 3>>);
}
