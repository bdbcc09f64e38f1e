// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE step_control
#include "methods.hpp"
#include "smooth.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/judge/inverse_root.hpp>
#include <stagecraft/method/order_conditions.hpp>
#include <stagecraft/method/step_doubling.hpp>
#include <stdexcept>

namespace sc = stagecraft;

namespace {

// Kepler's ellipse of eccentricity 1/2, started at the pericentre: period 2 pi.
const auto kepler = [](double, const Eigen::Vector4d& y, Eigen::Vector4d& f) {
    const double r = std::hypot(y[0], y[1]), c = 1 / (r * r * r);
    f << y[2], y[3], -c * y[0], -c * y[1];
};
const Eigen::Vector4d pericentre(0.5, 0, 0, std::sqrt(3.0));
const double period = 2 * std::acos(-1.0);

using V1 = Eigen::Matrix<double, 1, 1>;

double kepler_error(const sc::tableau<double>& m, double tol) {
    const auto r = sc::integrate(m, kepler, pericentre, 0, period, {.rtol = tol, .atol = tol});
    BOOST_TEST(r.ok());
    return (r.y - pericentre).norm();
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_root_that_a_step_size_takes_has_the_digits_it_needs_and_is_that_of_pow_elsewhere) {
    for (int q = 1; q <= 20; ++q) {
        for (int k = -4000; k <= 60; ++k) {  // from where 2^-q no longer matters to beyond 4/3
            const double x = std::pow(10.0, k / 400.0);
            BOOST_TEST(std::abs(sc::inverse_root(x, q) * std::pow(x, 1.0 / q) - 1) < 2e-4 / q);
        }
        using limits = std::numeric_limits<double>;
        for (const double x :
             {0.0, limits::denorm_min(), limits::min(), 1e-300, 1e300, limits::max(), limits::infinity()})
            BOOST_TEST(sc::inverse_root(x, q) == std::pow(x, -1.0 / q));
        for (const double x : {limits::quiet_NaN(), -limits::quiet_NaN(), -limits::infinity()})
            BOOST_TEST(std::isnan(sc::inverse_root(x, q)) == std::isnan(std::pow(x, -1.0 / q)));
        BOOST_TEST(sc::inverse_root(0.5L, q) == std::pow(0.5L, -1.0L / q));
    }
}

BOOST_AUTO_TEST_CASE(step_doubling_of_the_classical_method_has_its_order_and_eleven_stages) {
    const auto m = sc::step_doubling(methods::classical());
    BOOST_TEST(m.stages() == 11);  // of twelve, one is shared
    BOOST_TEST(sc::order_by_trees(m, m.b, 8) == 4);
    BOOST_TEST(sc::order_by_trees(m, m.b_embedded, 8) == 4);
    BOOST_TEST((m.b - m.b_embedded).norm() > 0.01);
    for (int i = 0; i < 11; ++i) BOOST_TEST(std::abs(m.A.row(i).sum() - m.c[i]) < 1e-15);
    // Two half steps are what they claim to be: bit for bit where halving is exact.
    const auto doubled = sc::integrate(m, kepler, pericentre, 0, 0.5, {.fixed_step = 0.5});
    const auto halves = sc::integrate(methods::classical(), kepler, pericentre, 0, 0.5, {.fixed_step = 0.25});
    BOOST_TEST((doubled.y - halves.y).norm() < 1e-15);
}

BOOST_AUTO_TEST_CASE(step_doubling_lets_a_method_without_embedded_weights_choose_its_steps) {
    BOOST_CHECK_THROW(sc::integrate(methods::classical(), kepler, pericentre, 0, period, {}),
                      std::invalid_argument);
    const auto m = sc::step_doubling(methods::classical());
    // The error of a step meets the tolerance, so the step is tol^{1/5} and the error at the end tol^{4/5}.
    const double coarse = kepler_error(m, 1e-6), fine = kepler_error(m, 1e-10);
    BOOST_TEST(coarse < 1e-3);
    BOOST_TEST(std::abs(std::log10(coarse / fine) / 4 - 0.8) < 0.05);
}

BOOST_AUTO_TEST_CASE(the_estimate_of_step_doubling_is_the_leading_term_of_the_error) {
    // One step of size h on a linear problem, whose solution is known.
    const auto linear = [](double, const V1& y, V1& f) { f = y; };
    const auto m = sc::step_doubling(methods::classical());
    for (const double h : {0.2, 0.1}) {
        auto embedded = m;
        embedded.b = m.b_embedded;
        embedded.b_embedded.resize(0);
        const V1 one(1.0);
        const double y = sc::integrate(m, linear, one, 0, h, {.fixed_step = h}).y[0];
        const double other = sc::integrate(embedded, linear, one, 0, h, {.fixed_step = h}).y[0];
        BOOST_TEST(std::abs((y - other) / (std::exp(h) - y) - 1) < h);
    }
}

BOOST_AUTO_TEST_CASE(step_doubling_of_diagonally_implicit_and_of_full_methods_runs_stiff_problems) {
    const auto radau = sc::radau_iia<2>();
    sc::tableau<double> full;
    full.A = radau.A, full.b = radau.b, full.c = radau.c, full.facts = radau.facts;
    auto diagonal = methods::sdirk_4_3();
    diagonal.b_embedded.resize(0);
    for (const auto& m : {sc::step_doubling(full), sc::step_doubling(diagonal)}) {
        const auto r =
            sc::integrate(m, smooth::prothero_robinson{-1e6}, V1(1.0), 0, 10, {.rtol = 1e-6, .atol = 1e-6});
        BOOST_TEST(r.ok());
        BOOST_TEST(r.report.steps < 500);
        BOOST_TEST(std::abs(r.y[0] - std::cos(10.0)) < 1e-5);
    }
}

BOOST_AUTO_TEST_CASE(half_steps_share_the_stage_between_them_so_that_singular_mass_matrices_are_served) {
    auto lobatto = methods::lobatto_iiia_3();
    lobatto.c(2) = 1;  // a sum of thirds and sixths is not
    const auto m = sc::step_doubling(lobatto);
    BOOST_TEST(m.stages() == 7);  // of nine, the first and the one in the middle are shared
    BOOST_TEST(sc::order_by_trees(m, m.b, 8) == 4);
    for (int i = 0; i < 7; ++i) BOOST_TEST(std::abs(m.A.row(i).sum() - m.c[i]) < 1e-15);
    const double tight = 1e-13;
    const auto doubled =
        sc::integrate(m, kepler, pericentre, 0, 0.5, {.rtol = tight, .atol = tight, .fixed_step = 0.5});
    const auto halves = sc::integrate(lobatto, kepler, pericentre, 0, 0.5,
                                      {.rtol = tight, .atol = tight, .fixed_step = 0.25});
    BOOST_TEST((doubled.y - halves.y).norm() < 1e-13);
    // y = exp(sin t), 0 = y^2 - z: adaptive steps of a method with singular A and no embedded weights.
    struct index_one {
        void operator()(double t, const Eigen::Vector2d& y, Eigen::Vector2d& f) const {
            f << y[1] / y[0] * std::cos(t), y[0] * y[0] - y[1];
        }
        Eigen::DiagonalMatrix<double, 2> mass() const { return Eigen::DiagonalMatrix<double, 2>(1, 0); }
    };
    const Eigen::Vector2d start(1, 1), end(std::exp(std::sin(5.0)), std::exp(2 * std::sin(5.0)));
    for (const double tol : {1e-4, 1e-8}) {
        const auto r = sc::integrate(m, index_one{}, start, 0, 5, {.rtol = tol, .atol = tol});
        BOOST_TEST(r.ok());
        BOOST_TEST(r.report.rejected() < r.report.steps / 5 + 5);
        BOOST_TEST((r.y - end).lpNorm<Eigen::Infinity>() < 20 * tol);
    }
    // The stage is not shared where y1 is none: Lobatto IIIB.
    BOOST_TEST(sc::step_doubling(methods::lobatto_iiib_3()).stages() == 9);
}

BOOST_AUTO_TEST_CASE(step_doubling_refuses_what_is_no_method) {
    sc::tableau<double> nothing;
    BOOST_CHECK_THROW(sc::step_doubling(nothing), std::invalid_argument);
    auto wrong = methods::classical();
    wrong.b *= 2;  // b^T 1 = 2: not even consistent
    BOOST_CHECK_THROW(sc::step_doubling(wrong), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(proportional_integral_control_rejects_less_where_stability_bounds_the_step) {
    // Dormand-Prince on a mildly stiff equation: its steps are those of stability, the estimate wavers.
    const smooth::prothero_robinson p{-500};
    const auto run = [&](sc::step_control control) {
        const auto r = sc::integrate(methods::dormand_prince(), p, V1(1.0), 0, 10,
                                     {.rtol = 1e-4, .atol = 1e-4, .control = control});
        BOOST_TEST(r.ok());
        BOOST_TEST(std::abs(r.y[0] - std::cos(10.0)) < 1e-3);
        return r.report;
    };
    const auto predictive = run(sc::step_control::predictive);
    const auto smooth = run(sc::step_control::proportional_integral);
    BOOST_TEST_MESSAGE("rejected " << predictive.rejected_error << " and " << smooth.rejected_error << " of "
                                   << predictive.steps << " and " << smooth.steps);
    BOOST_TEST(smooth.rejected_error < predictive.rejected_error / 2);
}

// What Newton's iteration told, contracting by theta with a Jacobian that is new.
struct told {
    struct system {
        static constexpr bool finite_difference = false, automatic = false;
        static void evaluate_jacobian(double, const V1&, const V1&, const V1&, double = 0) {}
        static int size() { return 1; }
    };
    sc::linearisation<system, V1> linear{1};
    told(int iterations, double theta, double cost) {
        system s;
        V1 y(1.0);
        linear.evaluate(s, 0.0, y, y, 0.1, static_cast<const sc::dense_output<V1, 3>*>(nullptr), false, {},
                        y);
        linear.solved({sc::newton_end::converged, iterations, theta}, cost, false);
    }
};

BOOST_AUTO_TEST_CASE(factors_and_step_are_held_where_a_factorisation_costs_many_iterations) {
    // Unknown cost: RADAU5's constants, 1/1000 and 6/5.
    BOOST_TEST(!told(4, 0.01, 0).linear.serves_well());
    BOOST_TEST(told(4, 0.01, 0).linear.hold() == 1);
    BOOST_TEST(told(4, 0.0005, 0).linear.serves_well());
    BOOST_TEST(told(4, 0.0005, 0).linear.hold() == 1.2);
    // If theta doubles a new Jacobian saves 1 - log(0.02) / log(0.01) = 0.15 of four iterations, ten times 0.6.
    BOOST_TEST(told(4, 0.01, 6.1).linear.serves_well());
    BOOST_TEST(!told(4, 0.01, 5.9).linear.serves_well());
    BOOST_TEST(!told(4, 0.3, 1e6).linear.serves_well());
    // Half of a factorisation of four iterations against four: 1 + 1/2.
    BOOST_TEST(told(4, 0.0005, 4).linear.hold() == 1.5);
    BOOST_TEST(told(4, 0.0005, 1e6).linear.hold() == 2);
}
