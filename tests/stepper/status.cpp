// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE status
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <problems/sparse_once.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/banded_blocks.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>
#include <stagecraft/problem/with.hpp>
#include <stdexcept>
#include <string>

namespace sc = stagecraft;
using V1 = Eigen::Matrix<double, 1, 1>;

namespace {

const auto method = sc::radau_iia<3>();

const auto decay = [](double, const Eigen::Vector2d& y, Eigen::Vector2d& f) { f = -y; };

template <class Problem, class Vector>
std::string refusal(const Problem& problem, const Vector& y0, double t0, double t1,
                    const sc::options<double>& o) {
    try {
        sc::integrate(method, problem, y0, t0, t1, o);
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "accepted";
}

bool names(const std::string& message, const std::string& argument) {
    return message.find(argument) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_bad_argument_is_named) {
    const Eigen::Vector2d y0(1, 2);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    BOOST_TEST(refusal(decay, y0, 0, 1, {}) == "accepted");
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.rtol = 0}), "rtol"));
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.rtol = -1e-6}), "rtol"));
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.rtol = nan}), "rtol"));
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.rtol = 1e-16}), "rtol"));  // atol = 1e-6 does not help
    BOOST_TEST(refusal(decay, y0, 0, 1, {.rtol = 1e-15}) == "accepted");
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.atol = 0}), "atol"));
    // Its inverse, the weight of a component that is zero, overflows.
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.atol = 1e-320}), "atol"));
    BOOST_TEST(
        names(refusal(decay, y0, 0, 1, {.atol_components = Eigen::Vector3d(1, 1, 1)}), "atol_components"));
    BOOST_TEST(
        names(refusal(decay, y0, 0, 1, {.atol_components = Eigen::Vector2d(1, 0)}), "atol_components"));
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.fixed_step = -0.1}), "fixed_step"));
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.fixed_step = 1e-30}), "fixed_step"));
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.fixed_step = 0.1, .max_step = 0.2}), "max_step"));
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.initial_step = -0.1}), "initial_step"));
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.min_step = 1, .max_step = 0.1}), "max_step"));
    // What contradicts itself is not taken in silence, and what is said of NaN is true of it.
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.initial_step = 0.05, .min_step = 0.1}), "initial_step"));
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.initial_step = 0.5, .max_step = 0.1}), "initial_step"));
    BOOST_TEST(refusal(decay, y0, 0, 1, {.initial_step = 0.1, .max_step = 0.1}) == "accepted");
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.fixed_step = nan}), "fixed_step must be finite"));
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.max_step = nan}), "max_step must be a number"));
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.newton_factor = nan}), "newton_factor must be finite"));
    BOOST_TEST(names(refusal(decay, y0, 0, 1, {.max_steps = 0}), "max_steps"));
    BOOST_TEST(names(refusal(decay, y0, nan, 1, {}), "t0"));
    BOOST_TEST(names(refusal(decay, y0, 0, std::numeric_limits<double>::infinity(), {}), "t1"));
    BOOST_TEST(names(refusal(decay, Eigen::Vector2d(1, nan), 0, 1, {}), "y0"));
    const auto dynamic = [](double, const Eigen::VectorXd& y, Eigen::VectorXd& f) { f = -y; };
    const Eigen::VectorXd x0 = Eigen::VectorXd::Ones(2);
    const Eigen::MatrixXd three = Eigen::MatrixXd::Identity(3, 3);
    BOOST_TEST(names(refusal(sc::with_mass(dynamic, three), x0, 0, 1, {}), "mass()"));
    BOOST_TEST(names(refusal(sc::with_index(dynamic, std::array<int, 3>{1, 1, 2}), x0, 0, 1, {}), "index()"));
    BOOST_TEST(names(refusal(sc::with_index(dynamic, std::array<int, 2>{1, 4}), x0, 0, 1, {}), "index()"));
}

BOOST_AUTO_TEST_CASE(t1_equal_to_t0_is_success_without_a_step) {
    const auto r = sc::integrate(method, decay, Eigen::Vector2d(1, 2), 3, 3);
    BOOST_TEST(r.ok());
    BOOST_TEST(r.report.steps == 0);
    BOOST_TEST(r.report.f == 0);
    BOOST_TEST(r.y[1] == 2);
}

BOOST_AUTO_TEST_CASE(time_runs_both_ways) {
    const Eigen::Vector2d y0(1, 2);
    const auto forth = sc::integrate(method, decay, y0, 0, 2, {.rtol = 1e-10, .atol = 1e-10});
    BOOST_TEST(forth.y[0] == std::exp(-2.0), boost::test_tools::tolerance(1e-9));
    const auto back = sc::integrate(method, decay, forth.y, 2, 0, {.rtol = 1e-10, .atol = 1e-10});
    BOOST_TEST(back.ok());
    BOOST_TEST(back.t == 0);
    BOOST_TEST(back.y[1] == 2, boost::test_tools::tolerance(1e-8));
    const auto fixed = sc::integrate(method, decay, y0, 2, 0, {.rtol = 1e-12, .fixed_step = 0.1});
    BOOST_TEST(fixed.y[0] == std::exp(2.0), boost::test_tools::tolerance(1e-7));
}

// From t = 1 on f is not a number (or infinite): the run ends there, and says so.
BOOST_AUTO_TEST_CASE(a_right_hand_side_that_stops_being_finite_is_no_success) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        const auto f = [bad](double t, const Eigen::Vector2d& y, Eigen::Vector2d& out) {
            out = t > 1 ? Eigen::Vector2d(-y[0], bad) : Eigen::Vector2d(-y);
        };
        for (const double step : {0.0, 0.03}) {
            const auto r = sc::integrate(method, f, Eigen::Vector2d(1, 2), 0, 2, {.fixed_step = step});
            BOOST_TEST(sc::name(r.status) == "non_finite");
            BOOST_TEST(r.t <= 1);
            BOOST_TEST(r.t > 0.9);
            BOOST_TEST(r.y[1] == 2 * std::exp(-r.t), boost::test_tools::tolerance(1e-4));
        }
    }
}

BOOST_AUTO_TEST_CASE(a_right_hand_side_that_is_never_finite_ends_at_t0) {
    const auto f = [](double, const Eigen::Vector2d&, Eigen::Vector2d& out) {
        out.setConstant(std::sqrt(-1.0));
    };
    const auto r = sc::integrate(method, f, Eigen::Vector2d(1, 2), 0, 2);
    BOOST_TEST(sc::name(r.status) == "non_finite");
    BOOST_TEST(r.t == 0);
    BOOST_TEST(r.y[1] == 2);
}

// Differences towards y < 0 give NaN. y' = -1 - sqrt(y) from 1 has no solution behind its zero at t = 2 - 2 log 2, and y' =
// -sqrt(y) rests at its zero from t = 2 on.
BOOST_AUTO_TEST_CASE(a_jacobian_that_is_not_finite_is_not_a_singular_one) {
    using number = Eigen::Matrix<double, 1, 1>;
    using numbers = Eigen::VectorXd;
    struct root {
        double least;
        void operator()(double, const number& y, number& f) const { f[0] = -least - std::sqrt(y[0]); }
    };
    struct banded {
        double least;
        void operator()(double, const numbers& y, numbers& f) const { f = -y.cwiseSqrt().array() - least; }
        sc::bandwidth bandwidth() const { return {0, 0}; }
    };
    struct sparse {
        double least;
        void operator()(double, const numbers& y, numbers& f) const { f = -y.cwiseSqrt().array() - least; }
        Eigen::SparseMatrix<double> sparsity() const {
            Eigen::SparseMatrix<double> J(2, 2);
            J.setIdentity();
            return J;
        }
    };
    const auto ends = [](const auto& r) {
        BOOST_TEST(sc::name(r.status) == "non_finite");
        BOOST_TEST(r.t == 2 - 2 * std::log(2.0), boost::test_tools::tolerance(0.01));
    };
    ends(sc::integrate(method, root{1}, number(1.0), 0, 3));
    ends(sc::integrate(method, banded{1}, numbers::Ones(2), 0, 3));
    ends(sc::integrate(method, sparse{1}, numbers::Ones(2), 0, 3));
    const auto rests = [](const auto& r) {
        BOOST_TEST(sc::name(r.status) == "success");
        BOOST_TEST(r.t == 3);
        BOOST_TEST((r.y.array() >= 0 && r.y.array() < 1e-6).all());
    };
    rests(sc::integrate(method, root{0}, number(1.0), 0, 3));
    rests(sc::integrate(method, banded{0}, numbers::Ones(2), 0, 3));
    rests(sc::integrate(method, sparse{0}, numbers::Ones(2), 0, 3));
}

BOOST_AUTO_TEST_CASE(what_a_right_hand_side_throws_is_kept_with_the_last_good_state) {
    const auto f = [](double t, const Eigen::Vector2d& y, Eigen::Vector2d& out) {
        if (t > 1) throw std::domain_error("beyond the table");
        out = -y;
    };
    const auto r = sc::integrate(method, f, Eigen::Vector2d(1, 2), 0, 2);
    BOOST_TEST(sc::name(r.status) == "function_threw");
    BOOST_TEST(r.t > 0);
    BOOST_TEST(r.t <= 1);
    BOOST_TEST(r.y[0] == std::exp(-r.t), boost::test_tools::tolerance(1e-4));
    BOOST_CHECK_THROW(std::rethrow_exception(r.exception), std::domain_error);
}

// M = 0 and f without y: gamma/h M - J is singular whatever h.
BOOST_AUTO_TEST_CASE(a_singular_newton_matrix_is_a_status) {
    struct singular {
        void operator()(double, const Eigen::Vector2d& y, Eigen::Vector2d& f) const { f << -y[0], 1; }
        Eigen::DiagonalMatrix<double, 2> mass() const { return Eigen::DiagonalMatrix<double, 2>(1, 0); }
    };
    for (const double step : {0.0, 0.1}) {
        const auto r = sc::integrate(method, singular{}, Eigen::Vector2d(1, 2), 0, 1, {.fixed_step = step});
        BOOST_TEST(sc::name(r.status) == "singular_matrix");
        BOOST_TEST(r.t == 0);
    }
}

// 0 = z + u - y, 0 = z + (1 + e) u - y cos t: with a small e rounding in f is 1/e times as large in z and u, and
// Newton's iteration never ends; with e = 1/100 nothing is wrong.
BOOST_AUTO_TEST_CASE(constraints_that_hardly_determine_anything_are_singular) {
    struct parallel {
        double e;
        void operator()(double t, const Eigen::Vector3d& x, Eigen::Vector3d& f) const {
            f << x[1] - x[0], x[1] + x[2] - x[0], x[1] + (1 + e) * x[2] - x[0] * std::cos(t);
        }
        void jacobian(double t, const Eigen::Vector3d&, Eigen::Matrix3d& J) const {
            J << -1, 1, 0, -1, 1, 1, -std::cos(t), 1, 1 + e;
        }
        Eigen::DiagonalMatrix<double, 3> mass() const { return Eigen::DiagonalMatrix<double, 3>(1, 0, 0); }
    };
    for (const double e : {1e-12, 1e-15, 0.0}) {
        const auto r = sc::integrate(method, parallel{e}, Eigen::Vector3d(1, 0.5, 0.5), 0, 1,
                                     {.rtol = 1e-8, .atol = 1e-8});
        BOOST_TEST(sc::name(r.status) == "singular_matrix");
    }
    const auto r = sc::integrate(method, parallel{0.01}, Eigen::Vector3d(1, 1, 0), 0, 1);
    BOOST_TEST(r.ok());
}

// y' = y^2 has its pole at t = 1: steps shrink until t cannot be advanced.
BOOST_AUTO_TEST_CASE(a_pole_ends_in_a_status_before_it) {
    const auto f = [](const auto&, const auto& y, auto& out) { out[0] = y[0] * y[0]; };
    const auto r = sc::integrate(method, f, V1(1.0), 0, 2);
    BOOST_TEST(!r.ok());
    BOOST_TEST(r.t <= 1 + 1e-5);
    BOOST_TEST(r.t > 0.999);
    BOOST_TEST(std::isfinite(r.y[0]));
}

BOOST_AUTO_TEST_CASE(step_bounds_and_step_count_are_statuses) {
    const auto f = [](double t, const V1&, V1& out) { out[0] = 50 * std::cos(50 * t); };
    BOOST_TEST(
        sc::name(sc::integrate(method, f, V1(0.0), 0, 10, {.rtol = 1e-10, .atol = 1e-10, .max_steps = 5})
                     .status) == "too_many_steps");
    BOOST_TEST(
        sc::name(
            sc::integrate(method, f, V1(0.0), 0, 10, {.rtol = 1e-12, .atol = 1e-12, .min_step = 1}).status) ==
        "step_underflow");
    const auto bounded = sc::integrate(method, f, V1(0.0), 0, 1, {.max_step = 0.01});
    BOOST_TEST(bounded.ok());
    BOOST_TEST(bounded.report.largest_step <= 0.01 + 1e-12);
    BOOST_TEST(bounded.report.steps >= 100);
}

BOOST_AUTO_TEST_CASE(a_right_hand_side_that_changes_size_is_a_status) {
    const auto f = [](double t, const Eigen::VectorXd& y, Eigen::VectorXd& out) {
        if (t > 0.5) out.resize(3);
        out.setZero();
        out.head(2) = -y;
    };
    const auto r = sc::integrate(method, f, Eigen::VectorXd::Ones(2).eval(), 0, 1);
    BOOST_TEST(sc::name(r.status) == "size_changed");
    BOOST_TEST(r.t < 0.6);
}

BOOST_AUTO_TEST_CASE(an_observer_stops_the_run) {
    int calls = 0;
    const auto r = sc::integrate(method, decay, Eigen::Vector2d(1, 2), 0, 10, {},
                                 [&](double, const Eigen::Vector2d&) { return ++calls < 3; });
    BOOST_TEST(sc::name(r.status) == "stopped");
    BOOST_TEST(r.report.steps == 3);
}

BOOST_AUTO_TEST_CASE(an_index_without_a_mass_is_refused) {
    struct flagged {
        std::array<int, 2> flags;
        void operator()(double, const Eigen::Vector2d& y, Eigen::Vector2d& out) const { out = -y; }
        const std::array<int, 2>& index() const { return flags; }
    };
    const Eigen::Vector2d y0(1, 2);
    BOOST_TEST(names(refusal(flagged{{1, 2}}, y0, 0, 1, {}), "no problem.mass()"));
    BOOST_TEST(refusal(flagged{{1, 1}}, y0, 0, 1, {}) == "accepted");
}

BOOST_AUTO_TEST_CASE(the_last_step_is_not_a_tiny_one) {
    double last = 0, before = 0;
    sc::integrate(method, decay, Eigen::Vector2d(1, 2), 0, 1.0001, {},
                  [&](double, const Eigen::Vector2d&, double h) {
                      before = last;
                      last = h;
                  });
    BOOST_TEST(last > 0.3 * before);
}

// Tables, square roots and the like end where the run does.
BOOST_AUTO_TEST_CASE(f_is_evaluated_nowhere_outside_of_the_interval) {
    unsigned state = 1;
    const auto number = [&] { return (state = state * 1664525u + 1013904223u) / 4294967296.0 - 0.5; };
    for (int k = 0; k < 300; ++k) {
        const double t0 = number() * std::pow(10, 6 * number()), t1 = number() * std::pow(10, 6 * number());
        const double low = std::min(t0, t1), high = std::max(t0, t1);
        bool outside = false;
        const auto f = [&](double t, const Eigen::Vector2d& y, Eigen::Vector2d& out) {
            outside = outside || t < low || t > high;
            out = y * (t / (std::abs(low) + std::abs(high)) / (high - low));
        };
        for (const double step : {0.0, (high - low) / (1 + k % 17)}) {
            const auto r =
                sc::integrate(sc::radau_iia<3>(), f, Eigen::Vector2d(1, 2), t0, t1, {.fixed_step = step});
            BOOST_TEST(r.ok());
            BOOST_TEST(r.t == t1);
        }
        BOOST_TEST(!outside, "from " << t0 << " to " << t1);
    }
}
