// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE variable_order
#include <boost/test/unit_test.hpp>
#include <problems/equations.hpp>
#include <problems/stored.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/radau_iia_variable.hpp>

#include "interrupt.hpp"

namespace sc = stagecraft;

namespace {

const Eigen::Vector2d vdp0(2, -0.66);
const Eigen::Vector3d rober0(1, 0, 0);

template <class Method>
auto robertson(const Method& method, double tol) {
    return sc::integrate(method, equations::robertson{}, rober0, 0, 1e11, {.rtol = tol, .atol = 1e-6 * tol});
}

}  // namespace

BOOST_AUTO_TEST_CASE(variable_order_solves_to_tolerance) {
    const Eigen::VectorXd vdp = problems::reference("vdpol"), rober = problems::reference("rober");
    for (const double tol : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
        BOOST_TEST_CONTEXT("tol = " << tol) {
            const auto v = sc::integrate(sc::radau_iia_variable(), equations::van_der_pol{}, vdp0, 0, 2,
                                         {.rtol = tol, .atol = tol});
            BOOST_TEST(v.ok());
            BOOST_TEST(problems::error(v.y, vdp, 1) < 10 * tol);
            const auto r = robertson(sc::radau_iia_variable(), tol);
            BOOST_TEST(r.ok());
            BOOST_TEST(problems::error(r.y, rober, 1e-6) < 10 * tol);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_tight_tolerance_raises_the_order_and_saves_work) {
    const auto fixed = robertson(sc::radau_iia<3>(), 1e-11);
    const auto chosen = robertson(sc::radau_iia_variable(), 1e-11);
    BOOST_TEST(chosen.report.largest_stages == 7);
    BOOST_TEST(chosen.report.smallest_stages == 3);
    BOOST_TEST(4 * chosen.report.steps < fixed.report.steps);
    BOOST_TEST(2 * chosen.report.f < fixed.report.f);
}

BOOST_AUTO_TEST_CASE(a_loose_tolerance_does_not_take_the_highest_order) {
    const auto chosen = robertson(sc::radau_iia_variable(), 1e-3);
    BOOST_TEST(chosen.report.largest_stages < 7);
}

BOOST_AUTO_TEST_CASE(nine_stages_are_chosen_where_the_tolerance_asks_for_them) {
    const auto largest = [](double tol) {
        return sc::integrate(sc::radau_iia_variable(), equations::van_der_pol{}, vdp0, 0, 2,
                             {.rtol = tol, .atol = tol})
            .report.largest_stages;
    };
    BOOST_TEST(largest(1e-12) == 9);
    BOOST_TEST(largest(1e-8) <= 7);
}

BOOST_AUTO_TEST_CASE(the_family_may_be_any_list_of_stages) {
    const auto r = robertson(sc::radau_iia_variable<1, 2, 3, 4, 5>(), 1e-8);
    BOOST_TEST(r.ok());
    BOOST_TEST(r.report.largest_stages > 3);
    BOOST_TEST(problems::error(r.y, problems::reference("rober"), 1e-6) < 1e-7);
}

BOOST_AUTO_TEST_CASE(a_run_goes_on_from_a_checkpoint_with_the_bits_it_would_have) {
    interrupted::at_five_places(sc::radau_iia_variable(), equations::van_der_pol{}, vdp0, 2,
                                {.rtol = 1e-8, .atol = 1e-8});
}

// Of two methods that promise steps of 0.95 and 1.9: what is paid once a step speaks for the longer one, what is paid for
// every stage does not.
BOOST_AUTO_TEST_CASE(the_order_follows_what_the_linear_systems_of_the_step_cost) {
    const auto chosen = [](const sc::step_work<double>& work) {
        sc::order_controller<double, 2> order;
        order.prepare(0, {3, 4, 1.0, {0, 0}}, 1e-6);
        order.prepare(1, {5, 6, 1.0, {0, 0}}, 1e-6);
        order.decide({1.0, 0.5, 0.1, 0.01, 3, work});
        return order.current();
    };
    BOOST_TEST(chosen({{1e3, 1}, {0, 1}}) == 1);
    BOOST_TEST(chosen({{0, 1}, {0, 1e3}}) == 0);
    BOOST_TEST(chosen({{0, 0}, {1e3, 0}}) == 0);
}

// The same steps, every second attempt of which Newton's iteration fails to solve with five stages: the order falls, does
// not rise at once, and does when the failures are long ago.
BOOST_AUTO_TEST_CASE(failed_iterations_lower_the_order) {
    sc::order_controller<double, 2> order;
    order.prepare(0, {3, 4, 1, {100, 10}}, 1e-6);
    order.prepare(1, {5, 6, 1, {160, 20}}, 1e-6);
    const sc::step_work<double> work{{}, {1000, 50}};
    const sc::order_evidence<double> with_three{1, 0.5, 0.03, 0.01, 3, work},
        with_five{1, 0.5, 0.3, 0.01, 3, work};
    BOOST_TEST(order.decide(with_three) > 1);
    BOOST_TEST(order.current() == 1);
    BOOST_TEST(order.decide(with_five) == 0);
    for (int k = 0; k < 10; ++k) order.newton_failed(false), order.accepted();
    BOOST_TEST(order.decide(with_five) < 1);
    BOOST_TEST(order.current() == 0);
    int steps = 0;
    for (; order.decide(with_three) == 0 && steps < 1000; ++steps) order.accepted();
    BOOST_TEST(steps > 5);
    BOOST_TEST(steps < 200);
}
