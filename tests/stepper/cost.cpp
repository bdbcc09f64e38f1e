// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE cost
#include "methods.hpp"

#include <boost/test/unit_test.hpp>
#include <memory>
#include <stagecraft/additive.hpp>
#include <stagecraft/coefficients/additive.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/output_times.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/problem/with.hpp>
#include <stagecraft/radau_iia_variable.hpp>

#include "../allocations.hpp"

namespace sc = stagecraft;

namespace {

template <class Vector>
void van_der_pol(const Vector& y, Vector& f) {
    f[0] = y[1];
    f[1] = ((1 - y[0] * y[0]) * y[1] - y[0]) * 1e3;
}

// Allocations between the third and the last step of a run.
template <class Method, class Problem, class Vector>
long allocations_after_warm_up(const Method& method, Problem& f, const Vector& y0) {
    sc::integrator<Method, Problem, Vector> run(method, f, y0, 0, 2, {.rtol = 1e-7, .atol = 1e-7});
    for (int i = 0; i < 3; ++i) run.step();
    const long before = allocations;
    while (run.step()) {
    }
    const long made = allocations - before;
    BOOST_TEST(run.counts().steps > 50);
    BOOST_TEST((run.status() == sc::status::success));
    return made;
}
template <class Method, class Vector>
long allocations_after_warm_up(const Method& method, const Vector& y0) {
    const auto f = [](double, const Vector& y, Vector& out) { van_der_pol(y, out); };
    return allocations_after_warm_up(method, f, y0);
}

// Counts what a run asks of it.
struct instrumented {
    mutable long* calls;
    mutable long* at_step_begin;
    double h;
    void operator()(double t, const Eigen::Vector2d& y, Eigen::Vector2d& f) const {
        ++*calls;
        const double steps = t / h;
        if (std::abs(steps - std::round(steps)) < 1e-9 && t < 0.5 * h) ++*at_step_begin;
        f = -y;
    }
    void jacobian(double, const Eigen::Vector2d&, Eigen::Matrix2d& J) const {
        J = -Eigen::Matrix2d::Identity();
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_step_of_a_fixed_size_problem_allocates_nothing) {
    BOOST_TEST(allocations_after_warm_up(sc::radau_iia<3>(), Eigen::Vector2d(2, -0.66)) == 0);
}

BOOST_AUTO_TEST_CASE(a_step_of_variable_order_allocates_nothing) {
    BOOST_TEST(allocations_after_warm_up(sc::radau_iia_variable(), Eigen::Vector2d(2, -0.66)) == 0);
    BOOST_TEST(
        allocations_after_warm_up(sc::radau_iia_variable(), Eigen::VectorXd(Eigen::Vector2d(2, -0.66))) == 0);
}

BOOST_AUTO_TEST_CASE(a_step_of_a_dense_dynamic_problem_allocates_nothing) {
    BOOST_TEST(allocations_after_warm_up(sc::radau_iia<3>(), Eigen::VectorXd(Eigen::Vector2d(2, -0.66))) ==
               0);
}

BOOST_AUTO_TEST_CASE(a_step_of_a_plain_tableau_allocates_nothing) {
    const Eigen::VectorXd y0 = Eigen::Vector2d(2, -0.66);
    BOOST_TEST(allocations_after_warm_up(methods::sdirk_4_3(), y0) == 0);
    BOOST_TEST(allocations_after_warm_up(methods::tr_bdf2(), y0) == 0);
    BOOST_TEST(allocations_after_warm_up(methods::dormand_prince(), y0) == 0);
    auto coupled = methods::lobatto_iiia_3();
    coupled.b_embedded = Eigen::Vector3d(0.5, 0, 0.5);
    BOOST_TEST(allocations_after_warm_up(coupled, y0) == 0);
}

BOOST_AUTO_TEST_CASE(a_step_of_an_additive_method_allocates_nothing) {
    using Eigen::VectorXd;
    const VectorXd y0 = Eigen::Vector2d(2, -0.66);
    const auto m = sc::ark4();
    const auto drift = [](double, const VectorXd& y, VectorXd& f) { f << y[1], 0; };
    const auto force = [](double, const VectorXd& y, VectorXd& f) {
        f << 0, ((1 - y[0] * y[0]) * y[1] - y[0]) * 1e3;
    };
    auto ordinary = sc::split(drift, force);
    BOOST_TEST(allocations_after_warm_up(m, ordinary, y0) == 0);
    auto algebraic = sc::split(  // 0 = y_1^2 - y_2
        [](double t, const VectorXd& y, VectorXd& f) { f << 20 * std::cos(20 * t) - y[0] * y[1], 0; },
        sc::with_mass([](double, const VectorXd& y, VectorXd& f) { f << -y[0], y[0] * y[0] - y[1]; },
                      Eigen::MatrixXd(Eigen::Vector2d(1, 0).asDiagonal())));
    BOOST_TEST(allocations_after_warm_up(m, algebraic, VectorXd(Eigen::Vector2d(1, 1))) == 0);
}

BOOST_AUTO_TEST_CASE(an_allocation_would_be_seen_made_with_new_or_by_eigen) {
    const long before = allocations;
    const Eigen::VectorXd x = Eigen::VectorXd::Ones(7);
    BOOST_TEST(x[3] == 1);
    BOOST_TEST(allocations > before);
    const long between = allocations;
    const auto p = std::make_unique<int>(static_cast<int>(x[3]));
    BOOST_TEST(*p == 1);
    BOOST_TEST(allocations > between);
}

// No error estimate: f is evaluated at stages only, never at the left end, and no solve is made for it.
BOOST_AUTO_TEST_CASE(a_fixed_step_run_computes_no_error_estimate) {
    long calls = 0, left = 0;
    const auto fixed = sc::integrate(sc::radau_iia<3>(), instrumented{&calls, &left, 0.1},
                                     Eigen::Vector2d(1, 2), 0, 1, {.fixed_step = 0.1});
    BOOST_TEST(fixed.report.steps == 10);
    BOOST_TEST(left == 0);
    BOOST_TEST(calls == 3 * fixed.report.solves);
    BOOST_TEST(fixed.report.error_solves == 0);
    BOOST_TEST(fixed.report.f == calls);

    calls = left = 0;
    const auto adaptive =
        sc::integrate(sc::radau_iia<3>(), instrumented{&calls, &left, 0.1}, Eigen::Vector2d(1, 2), 0, 1);
    BOOST_TEST(left > 0);
    BOOST_TEST(adaptive.report.error_solves >= adaptive.report.steps);
    BOOST_TEST(adaptive.report.f == calls);
}

BOOST_AUTO_TEST_CASE(a_constant_jacobian_is_evaluated_once) {
    struct linear : instrumented {
        bool constant_jacobian() const { return true; }
    };
    long calls = 0, left = 0;
    const linear p{{&calls, &left, 0.1}};
    const auto fixed = sc::integrate(sc::radau_iia<3>(), p, Eigen::Vector2d(1, 2), 0, 1, {.fixed_step = 0.1});
    BOOST_TEST(fixed.report.jacobians == 1);
    BOOST_TEST(fixed.report.factorisations == 1);
    BOOST_TEST(fixed.report.solves == fixed.report.steps + 1);  // the first step looks whether it is true
    BOOST_TEST(fixed.y[0] == std::exp(-1.0), boost::test_tools::tolerance(1e-8));
    const auto adaptive = sc::integrate(sc::radau_iia<3>(), p, Eigen::Vector2d(1, 2), 0, 1);
    BOOST_TEST(adaptive.report.jacobians == 1);
}

BOOST_AUTO_TEST_CASE(a_jacobian_that_is_not_constant_is_found_out) {
    using V1 = Eigen::Matrix<double, 1, 1>;
    struct square {
        void operator()(double, const V1& y, V1& f) const { f[0] = -y[0] * y[0]; }
        void jacobian(double, const V1& y, V1& J) const { J[0] = -2 * y[0]; }
        bool constant_jacobian() const { return true; }
    };
    for (const double tol : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const auto r = sc::integrate(sc::radau_iia<3>(), square{}, V1(1.0), 0, 3, {.rtol = tol, .atol = tol});
        BOOST_TEST(r.ok());
        BOOST_TEST(r.report.jacobians > 1);
        BOOST_TEST(std::abs(r.y[0] - 0.25) < 5 * tol);
    }
    // Not so where differences alone make the second increment, also of a stiff problem.
    struct stiff {
        void operator()(double, const Eigen::Vector2d& y, Eigen::Vector2d& f) const {
            f << -1e8 * y[0] + 1e7 * y[1], y[0] - y[1];
        }
        bool constant_jacobian() const { return true; }
    };
    const auto r = sc::integrate(sc::radau_iia<3>(), stiff{}, Eigen::Vector2d(1, 2), 0, 1);
    BOOST_TEST(r.ok());
    BOOST_TEST(r.report.jacobians == 1);
}

namespace {

// Allocations of a whole run of so many equal steps.
template <class Observer>
long allocations_of_run(long steps, Observer&& observer) {
    const auto f = [](double, const Eigen::VectorXd& y, Eigen::VectorXd& out) { out = -y; };
    const Eigen::VectorXd y0 = Eigen::VectorXd::Ones(5);
    const long before = allocations;
    const auto r = sc::integrate(sc::radau_iia<3>(), f, y0, 0, 1,
                                 {.fixed_step = 1. / static_cast<double>(steps)}, observer);
    const long made = allocations - before;
    BOOST_TEST(r.report.steps == steps);
    return made;
}

template <int N, int Stages>
constexpr std::size_t stepper_size() {
    using vector = Eigen::Matrix<double, N, 1>;
    using rhs = void (*)(double, const vector&, vector&);
    return sizeof(sc::integrator<sc::transformed_tableau<double, Stages>, rhs, vector>);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_run_keeps_its_continuous_solution_only_when_asked) {
    sc::no_observer none;
    BOOST_TEST(allocations_of_run(10, none) == allocations_of_run(1000, none));
    sc::solution<Eigen::VectorXd> few, many;
    const long of_few = allocations_of_run(10, few);
    BOOST_TEST(of_few < allocations_of_run(1000, many));
}

BOOST_AUTO_TEST_CASE(output_times_and_events_that_do_not_occur_allocate_nothing_per_step) {
    sc::output_times<Eigen::VectorXd> table({0.1, 0.5, 1}, true);
    auto watch = sc::events<Eigen::VectorXd>(sc::event([](double, const auto& y) { return y[0] + 1; }));
    allocations_of_run(10, table);  // warm-up: the table and the samples find their room
    allocations_of_run(10, watch);
    BOOST_TEST(allocations_of_run(10, table) == allocations_of_run(1000, table));
    BOOST_TEST(allocations_of_run(10, watch) == allocations_of_run(1000, watch));
}

// A budget in bytes, with everything a run holds: method, workspace, two continuous solutions that own their
// nodes, options, report with the tolerances, what is remembered of jumps, kinks, break points and the border of the domain of f,
// and t1 with the time that f is told there.
BOOST_AUTO_TEST_CASE(a_minimal_stepper_is_small) {
    BOOST_TEST((stepper_size<1, 1>()) <= 1656u);
    BOOST_TEST((stepper_size<3, 3>()) <= 3264u);
    BOOST_TEST((stepper_size<3, 3>()) < (stepper_size<3, 7>()));
}
