// SPDX-License-Identifier: BSL-1.0
// Fixed points of methods as the step size changes: folds, flips and pitchforks.
#define BOOST_TEST_MODULE branches
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/dense_once.hpp>
#include <stagecraft/theory/dynamics/branches.hpp>
#include <stagecraft/theory/dynamics/ghosts.hpp>

using namespace stagecraft;
using namespace stagecraft::theory;

namespace {

tableau<rational> two_stages(const rational& c, const rational& b1) {
    tableau<rational> t;
    t.A = tableaux::dense<rational>::Constant(2, 2, rational(0));
    t.A(1, 0) = c;
    t.b.resize(2);
    t.c.resize(2);
    t.b[0] = b1;
    t.b[1] = 1 - b1;
    t.c[0] = 0;
    t.c[1] = c;
    return t;
}

state<double, 1> at(double x) { return state<double, 1>(x); }

const auto cubic = [](const auto&, const auto& x, auto& f) { f[0] = x[0] - x[0] * x[0] * x[0]; };
const auto witch = [](const auto&, const auto& x, auto& f) { f[0] = -x[0] / (1 + x[0] * x[0]); };

}  // namespace

BOOST_AUTO_TEST_CASE(the_lectures_ghosts_are_born_in_a_pitchfork_at_h_lambda_1_and_flip_at_2) {
    const auto m = in_doubles(two_stages(1, 0));
    const auto trivial = follow<1>(m, witch, 0.5, at(0), 0.1, 1.5);
    BOOST_REQUIRE(trivial.events.size() == 1u);
    BOOST_TEST((trivial.events[0].kind == branch_event::branching));
    BOOST_TEST(std::abs(trivial.events[0].h - 1) < 1e-6);
    const auto ghost = follow<1>(m, witch, 1.5, at(std::sqrt(0.5)), 1.05, 2.6);
    BOOST_REQUIRE(ghost.events.size() == 1u);
    BOOST_TEST((ghost.events[0].kind == branch_event::flip));
    BOOST_TEST(std::abs(ghost.events[0].h - 2) < 1e-6);
    for (const auto& z : ghost.points) BOOST_TEST(std::abs(z[1] - std::sqrt(z[0] - 1)) < 1e-8);
}

BOOST_AUTO_TEST_CASE(a_ghost_of_the_improved_euler_method_crosses_the_equilibrium_1_at_h_1) {
    // f(X_2) = 0 at x = (-1 + sqrt(1 + 8/h))/2, which is 1 at h = 1
    const auto m = in_doubles(two_stages(rational(1, 2), 0));
    const auto b = follow<1>(m, cubic, 0.5, at(1), 0.4, 1.7, 0.05);
    BOOST_REQUIRE(b.events.size() == 1u);
    BOOST_TEST((b.events[0].kind == branch_event::branching));
    BOOST_TEST(std::abs(b.events[0].h - 1) < 1e-6);
    for (const auto& z : b.points) BOOST_TEST(std::abs(z[1] - 1) < 1e-9);
}

BOOST_AUTO_TEST_CASE(at_a_fold_of_rk4_the_exact_count_of_fixed_points_changes_by_two_or_four) {
    tableau<rational> exact;
    exact.A = tableaux::dense<rational>::Constant(4, 4, rational(0));
    exact.A(1, 0) = exact.A(2, 1) = rational(1, 2);
    exact.A(3, 2) = 1;
    exact.b.resize(4);
    exact.c.resize(4);
    exact.b << rational(1, 6), rational(1, 3), rational(1, 3), rational(1, 6);
    exact.c << rational(0), rational(1, 2), rational(1, 2), rational(1);
    const auto m = in_doubles(exact);
    std::vector<double> folds;
    for (const auto& p : ghosts(exact, cubic, rational(3, 2)).points)
        for (const auto& e : follow<1>(m, cubic, 1.5, at(p.value()), 1.0, 1.5, -0.01).events)
            if (e.kind == branch_event::fold) folds.push_back(e.h);
    BOOST_REQUIRE(!folds.empty());
    const double h = *std::max_element(folds.begin(), folds.end());
    const auto below = ghosts(exact, cubic, exactly(h - 1e-4)).points.size();
    const auto above = ghosts(exact, cubic, exactly(h + 1e-4)).points.size();
    BOOST_TEST((above == below + 2 || above == below + 4));  // x and -x together
}

BOOST_AUTO_TEST_CASE(in_the_plane_a_product_of_two_equations_has_the_events_of_both) {
    // x' = -x/(1 + x^2), y' = -y/(2 (1 + y^2)): pitchforks at h = 1 and 2, where the y-equation has half the speed
    const auto f = [](const auto&, const auto& x, auto& out) {
        out[0] = -x[0] / (1 + x[0] * x[0]);
        out[1] = -x[1] / (2 + 2 * x[1] * x[1]);
    };
    const auto m = in_doubles(two_stages(1, 0));
    const auto trivial = follow<2>(m, f, 0.53, state<double, 2>(0, 0), 0.1, 2.4, 0.05);
    BOOST_REQUIRE(trivial.events.size() == 2u);
    for (int k = 0; k < 2; ++k) {
        const auto& e = trivial.events[static_cast<std::size_t>(k)];
        BOOST_TEST((e.kind == branch_event::branching));
        BOOST_TEST(std::abs(e.h - (k + 1)) < 1e-5);
    }
    const auto ghost = follow<2>(m, f, 1.5, state<double, 2>(std::sqrt(0.5), 0), 1.05, 1.95, 0.05);
    BOOST_TEST(ghost.events.empty());
    for (const auto& z : ghost.points) BOOST_TEST(std::abs(z[1] - std::sqrt(z[0] - 1)) < 1e-8);
}

BOOST_AUTO_TEST_CASE(what_is_no_fixed_point_or_no_range_is_refused) {
    const auto m = in_doubles(two_stages(1, 0));
    BOOST_CHECK_THROW(follow<1>(m, witch, 0.5, at(0.3), 0.1, 1.5), std::invalid_argument);
    BOOST_CHECK_THROW(follow<1>(m, witch, 0.5, at(0), 0.6, 1.5), std::invalid_argument);
    BOOST_CHECK_THROW(follow<1>(m, witch, 0.5, at(0), 0.1, 1.5, 0.0), std::invalid_argument);
}
