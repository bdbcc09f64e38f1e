// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE erased
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/erased.hpp>
#include <stdexcept>

// Problems of all kinds behind two types, each run by one integrator: what the engine does, compiled twice in all.

namespace sc = stagecraft;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

using watcher = std::function<bool(double, const VectorXd&)>;

sc::result<VectorXd> run(const sc::erased_ode& problem, const VectorXd& y0, double t1,
                         const sc::options<double>& o, const watcher& watch = {}) {
    return sc::integrate(sc::radau_iia<3>(), problem, y0, 0.0, t1, o,
                         [&](double t, const VectorXd& y) { return !watch || watch(t, y); });
}

// The turn (cos t, -sin t).
struct turning {
    int* calls;
    void operator()(double, const Vector2d& y, Vector2d& f) const { f << y[1], -y[0]; }
    void jacobian(double, const Vector2d&, Matrix2d& J) const {
        ++*calls;
        J << 0, 1, -1, 0;
    }
};

const auto generic_turning = [](const auto&, const auto& y, auto& f) { f[0] = y[1], f[1] = -y[0]; };
const auto returned_turning = [](double, const Vector2d& y) -> Vector2d { return Vector2d(y[1], -y[0]); };
const auto plain_turning = [](double, const Vector2d& y, Vector2d& f) { f << y[1], -y[0]; };

// y1' = y2, 0 = y2 - cos t.
struct integral_of_cosine {
    void operator()(double t, const VectorXd& y, VectorXd& f) const {
        f[0] = y[1];
        f[1] = y[1] - std::cos(t);
    }
    void jacobian(double, const VectorXd&, MatrixXd& J) const { J << 0, 1, 0, 1; }
    Eigen::DiagonalMatrix<double, 2> mass() const { return Vector2d(1, 0).asDiagonal(); }
};

double error_of(const sc::result<VectorXd>& r) {
    return std::max(std::abs(r.y[0] - std::cos(r.t)), std::abs(r.y[1] + std::sin(r.t)));
}

}  // namespace

BOOST_AUTO_TEST_CASE(problems_of_several_types_become_one) {
    int calls = 0;
    static_assert(std::same_as<decltype(sc::erased<Vector2d>(turning{&calls})), sc::erased_ode>);
    static_assert(std::same_as<decltype(sc::erased(generic_turning)), sc::erased_ode>);
    static_assert(std::same_as<decltype(sc::erased<Vector2d>(generic_turning)), sc::erased_ode>);
    static_assert(std::same_as<decltype(sc::erased(integral_of_cosine())), sc::erased_dae>);
    // Neither a Jacobian nor generic: differences are left to the engine.
    static_assert(std::same_as<decltype(sc::erased<Vector2d>(plain_turning)), sc::erased_function>);
    static_assert(std::same_as<decltype(sc::erased<Vector2d>(returned_turning)), sc::erased_function>);
    VectorXd f(2);
    sc::erased<Vector2d>(returned_turning)(0.0, Vector2d(3, 4), f);
    BOOST_TEST(f[0] == 4);
    BOOST_TEST(f[1] == -3);
}

BOOST_AUTO_TEST_CASE(a_jacobian_is_the_problems_own_or_that_of_its_automatic_differentiation) {
    int calls = 0;
    const sc::options<double> o{.rtol = 1e-8, .atol = 1e-8};
    const auto own = run(sc::erased<Vector2d>(turning{&calls}), Vector2d(1, 0), 3, o);
    const auto differentiated = run(sc::erased(generic_turning), Vector2d(1, 0), 3, o);
    const auto fixed = run(sc::erased<Vector2d>(generic_turning), Vector2d(1, 0), 3, o);
    BOOST_TEST(own.ok());
    BOOST_TEST(own.t == 3);
    BOOST_TEST(error_of(own) < 1e-7);
    BOOST_TEST(calls == own.report.jacobians);
    BOOST_TEST(calls > 0);
    BOOST_TEST(own.y == differentiated.y);
    BOOST_TEST(own.y == fixed.y);
    BOOST_TEST(own.report.f == differentiated.report.f);
}

BOOST_AUTO_TEST_CASE(equal_steps_converge_with_order_five) {
    const auto error = [](double h) {
        return error_of(run(sc::erased(generic_turning), Vector2d(1, 0), 2,
                            {.rtol = 1e-12, .atol = 1e-12, .fixed_step = h}));
    };
    BOOST_TEST(std::log2(error(0.5) / error(0.25)) == 5.0, boost::test_tools::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(a_mass_matrix_and_indices_are_kept) {
    const auto dae = sc::erased(integral_of_cosine());
    BOOST_TEST((dae.mass() == MatrixXd(Vector2d(1, 0).asDiagonal())));
    BOOST_TEST(dae.index() == std::vector<int>({1, 1}));
    const auto r = sc::integrate(sc::radau_iia<3>(), dae, VectorXd(Vector2d(0, 1)), 0.0, 2.0,
                                 {.rtol = 1e-8, .atol = 1e-8});
    BOOST_TEST(r.ok());
    BOOST_TEST(std::abs(r.y[0] - std::sin(2.0)) < 1e-7);
    BOOST_TEST(std::abs(r.y[1] - std::cos(2.0)) < 1e-7);
}

BOOST_AUTO_TEST_CASE(a_state_of_another_size_than_the_problem_is_written_for_ends_the_run) {
    int calls = 0;
    const auto r = run(sc::erased<Vector2d>(turning{&calls}), Eigen::Vector3d(1, 0, 0), 1, {});
    BOOST_TEST((r.status == sc::status::size_changed));
}

BOOST_AUTO_TEST_CASE(what_ends_a_run_says_so) {
    const auto grows = [](const auto&, const auto& y, auto& f) { f[0] = y[0] * y[0]; };  // infinite at t = 1
    const auto blown = run(sc::erased(grows), VectorXd::Ones(1), 2, {});
    BOOST_TEST(!blown.ok());
    BOOST_TEST(std::abs(blown.t - 1) < 1e-3);
    BOOST_TEST(blown.y.allFinite());

    const auto throws = [](const auto& t, const auto& y, auto& f) {
        if (t > 0.5) throw std::runtime_error("after a half");
        f = -y;
    };
    const auto thrown = run(sc::erased(throws), VectorXd::Ones(1), 1, {});
    BOOST_TEST((thrown.status == sc::status::function_threw));
    BOOST_TEST(thrown.t <= 0.5);
    BOOST_CHECK_THROW(std::rethrow_exception(thrown.exception), std::runtime_error);

    int steps = 0;
    const auto stopped = run(sc::erased(generic_turning), Vector2d(1, 0), 100, {},
                             [&](double, const VectorXd&) { return ++steps < 3; });
    BOOST_TEST((stopped.status == sc::status::stopped));
    BOOST_TEST(stopped.report.steps == 3);

    const auto nowhere = [](const auto&, const auto&, auto& f) {
        f[0] = std::numeric_limits<double>::quiet_NaN();
    };
    BOOST_TEST((run(sc::erased(nowhere), VectorXd::Ones(1), 1, {}).status == sc::status::non_finite));
}

BOOST_AUTO_TEST_CASE(bad_arguments_are_named) {
    BOOST_CHECK_THROW(run(sc::erased(generic_turning), Vector2d(1, 0), 1, {.rtol = -1}),
                      std::invalid_argument);
    BOOST_CHECK_THROW(run(sc::erased(generic_turning), Vector2d(1, 0), NAN, {}), std::invalid_argument);
}
