// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE linear
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/lobatto_iiic.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/radau_iia_variable.hpp>
#include <string>

#include "../stepper/methods.hpp"

// y' = A y for eigenvalues at the ends of what double holds, on the imaginary axis, and for A far from
// normal.

namespace sc = stagecraft;
using V1 = Eigen::Matrix<double, 1, 1>;
using V2 = Eigen::Vector2d;

namespace {

template <int N>
struct linear {
    using vector = Eigen::Matrix<double, N, 1>;
    using matrix = Eigen::Matrix<double, N, N>;
    matrix A;
    void operator()(double, const vector& y, vector& f) const { f = A * y; }
    void jacobian(double, const vector&, matrix& J) const { J = A; }
    bool constant_jacobian() const { return true; }
};

linear<1> scalar(double lambda) { return {linear<1>::matrix(lambda)}; }

template <class Method>
void decays_or_says_why_not(const Method& method, double lambda) {
    for (const double step : {0.0, 0.25}) {
        const auto r = sc::integrate(method, scalar(lambda), V1(1.0), 0, 1, {.fixed_step = step});
        BOOST_TEST_CONTEXT("lambda = " << lambda << " step = " << step << " " << sc::name(r.status)) {
            BOOST_TEST(std::isfinite(r.y[0]));
            if (r.ok()) BOOST_TEST(std::abs(r.y[0] - std::exp(lambda)) < 1e-5);
        }
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(enormous_negative_eigenvalues_are_damped_to_zero) {
    for (const double lambda : {-1e8, -1e50, -1e150, -1e200, -1e300}) {
        const auto r = sc::integrate(sc::radau_iia<3>(), scalar(lambda), V1(1.0), 0, 1);
        BOOST_TEST_CONTEXT("lambda = " << lambda << " steps " << r.report.steps) {
            BOOST_TEST(sc::name(r.status) == "success");
            BOOST_TEST(std::abs(r.y[0]) < 1e-5);
            BOOST_TEST(r.report.steps < 400);  // they grow eightfold from 1 / |lambda| on
        }
        decays_or_says_why_not(sc::radau_iia<3>(), lambda);
        decays_or_says_why_not(sc::radau_iia<2>(), lambda);
        decays_or_says_why_not(sc::lobatto_iiic<3>(), lambda);
    }
    // f(y0) in units of the tolerance is beyond double: refused, with the state as it was.
    const auto r = sc::integrate(sc::radau_iia<3>(), scalar(-1e307), V1(1.0), 0, 1);
    BOOST_TEST(sc::name(r.status) == "non_finite");
    BOOST_TEST(r.y[0] == 1);
}

// Growth beyond what double holds is no success.
BOOST_AUTO_TEST_CASE(enormous_positive_eigenvalues_end_in_a_status) {
    for (const double lambda : {1e3, 1e8, 1e150, 1e300}) {
        const auto r = sc::integrate(sc::radau_iia<3>(), scalar(lambda), V1(1.0), 0, 1);
        BOOST_TEST_CONTEXT("lambda = " << lambda << " t = " << r.t << " " << sc::name(r.status)) {
            BOOST_TEST(!r.ok());
            BOOST_TEST(std::isfinite(r.y[0]));
            if (lambda < 1e100) {
                BOOST_TEST(r.t > 0);
                BOOST_TEST(std::log(r.y[0]) == lambda * r.t, boost::test_tools::tolerance(1e-3));
            }
        }
    }
    const auto r = sc::integrate(sc::radau_iia<3>(), scalar(700), V1(1.0), 0, 1);
    BOOST_TEST(r.ok());  // exp(700) = 1e304
    BOOST_TEST(r.y[0] == std::exp(700.0), boost::test_tools::tolerance(1e-2));
}

BOOST_AUTO_TEST_CASE(eigenvalues_near_zero_and_denormal_ones_change_nothing) {
    const double smallest = std::numeric_limits<double>::denorm_min();
    for (const double lambda : {1e-300, -1e-300, 1e-310, smallest, -smallest, 0.0}) {
        const auto r = sc::integrate(sc::radau_iia<3>(), scalar(lambda), V1(1.0), 0, 1);
        BOOST_TEST(sc::name(r.status) == "success");
        BOOST_TEST(r.y[0] == 1.0);
        BOOST_TEST(r.report.steps < 20);
    }
    // A state of denormals, and one that decays into them.
    const auto tiny = sc::integrate(sc::radau_iia<3>(), scalar(-1), V1(1e-310), 0, 1,
                                    {.rtol = 1e-8, .atol = std::numeric_limits<double>::min()});
    BOOST_TEST(sc::name(tiny.status) == "success");
    BOOST_TEST(std::abs(tiny.y[0] - 1e-310 * std::exp(-1.0)) <= std::numeric_limits<double>::min());
    const auto decayed = [](double atol) {
        return sc::integrate(sc::radau_iia<3>(), scalar(-1), V1(1.0), 0, 730, {.rtol = 1e-6, .atol = atol});
    };
    BOOST_TEST(decayed(std::numeric_limits<double>::min()).ok());
    BOOST_TEST(std::abs(decayed(std::numeric_limits<double>::min()).y[0]) < 1e-307);
    BOOST_CHECK_THROW(decayed(1e-320), std::invalid_argument);  // its inverse is infinite
}

// Equal steps show |R(iy)| of the method at h |lambda| = 1e6: 1 for Gauss, less for the others.
BOOST_AUTO_TEST_CASE(eigenvalues_of_1e8_i_keep_or_lose_the_amplitude_as_the_stability_function_says) {
    linear<2> rotation;
    rotation.A << 0, 1e8, -1e8, 0;
    const auto amplitude = [&](const auto& method, double h, double t1) {
        const auto r = sc::integrate(method, rotation, V2(1, 0), 0, t1, {.fixed_step = h});
        BOOST_TEST(r.ok());
        return r.y.norm();
    };
    BOOST_TEST(amplitude(sc::gauss<2>(), 0.01, 10) == 1, boost::test_tools::tolerance(1e-11));
    BOOST_TEST(amplitude(sc::gauss<3>(), 0.01, 10) == 1, boost::test_tools::tolerance(1e-11));
    BOOST_TEST(amplitude(sc::radau_iia<3>(), 0.01, 0.01) < 1e-5);
    BOOST_TEST(amplitude(sc::lobatto_iiic<3>(), 0.01, 0.01) < 1e-5);
}

// Error control, in contrast, has to resolve the oscillation: within the budget it does not get far, and says
// so with a good state; over a few periods it succeeds.
BOOST_AUTO_TEST_CASE(an_oscillation_is_resolved_or_the_step_budget_ends_the_run) {
    linear<2> rotation;
    rotation.A << 0, 1e8, -1e8, 0;
    const sc::options<double> o{.rtol = 1e-6, .atol = 1e-6, .max_steps = 2000};
    const auto good = [&](const auto& r) {
        const V2 exact(std::cos(1e8 * r.t), -std::sin(1e8 * r.t));
        return (r.y - exact).norm();
    };
    const auto whole = sc::integrate(sc::radau_iia<5>(), rotation, V2(1, 0), 0, 1, o);
    BOOST_TEST(sc::name(whole.status) == "too_many_steps");
    BOOST_TEST(whole.t > 0);
    BOOST_TEST(good(whole) < 1e-2);
    const auto periods = sc::integrate(sc::radau_iia<5>(), rotation, V2(1, 0), 0, 3e-7, o);
    BOOST_TEST(sc::name(periods.status) == "success");
    BOOST_TEST(good(periods) < 1e-4);
    const auto by_gauss = sc::integrate(sc::gauss<4>(), rotation, V2(1, 0), 0, 3e-7, o);
    BOOST_TEST(sc::name(by_gauss.status) == "success");
    BOOST_TEST(good(by_gauss) < 1e-4);
}

// A damped stiff oscillation, eigenvalues -1 +- 1e8 i: stiffly accurate methods pass over it only once it is
// gone, so nothing but the decay e^{-t} of the true solution counts as an error.
BOOST_AUTO_TEST_CASE(matrices_far_from_normal_grow_before_they_decay) {
    linear<2> shear;  // y1' = -y1 + 1e6 y2, y2' = -2 y2: y1 = e^{-t} + 1e6 (e^{-t} - e^{-2t})
    shear.A << -1, 1e6, 0, -2;
    const auto check = [&](const auto& method) {
        for (const double tol : {1e-4, 1e-8}) {
            double worst = 0;
            const auto look = [&](double t, const V2& y) {
                const double exact = std::exp(-t) + 1e6 * (std::exp(-t) - std::exp(-2 * t));
                worst = std::max(worst, std::abs(y[0] - exact) / (1 + std::abs(exact)) / tol);
            };
            const auto r =
                sc::integrate(method, shear, V2(1, 1), 0, 10, {.rtol = tol, .atol = 1e-6 * tol}, look);
            BOOST_TEST(sc::name(r.status) == "success");
            BOOST_TEST(worst < 30);
        }
    };
    check(sc::radau_iia<3>());
    check(sc::radau_iia<5>());
    check(sc::lobatto_iiic<3>());
    check(sc::gauss<3>());

    // The same with stiffness: eigenvalues -1 and -1e6, eigenvectors 1e-6 apart.
    linear<2> stiff;
    stiff.A << -1, 1e12, 0, -1e6;
    double worst = 0;
    const auto look = [&](double t, const V2& y) {
        const double exact = std::exp(-t) + 1e12 / (1e6 - 1) * (std::exp(-t) - std::exp(-1e6 * t));
        worst = std::max(worst, std::abs(y[0] - exact) / std::abs(exact));
    };
    const auto r =
        sc::integrate(sc::radau_iia<3>(), stiff, V2(1, 1), 0, 1, {.rtol = 1e-8, .atol = 1e-14}, look);
    BOOST_TEST(sc::name(r.status) == "success");
    BOOST_TEST(worst < 1e-6);
}

namespace {

/// Two modes that are not coupled, the first below every tolerance for most of the time.
template <class Method>
void follows_growth_from_below_the_tolerance(const Method& method, double span) {
    const linear<2> problem{(Eigen::Matrix2d() << 1, 0, 0, -100).finished()};
    for (const double t1 : {span, -span / 100}) {
        const double y0 = 1e-10 * (t1 > 0 ? 1 : 0.5);
        const linear<2> way{t1 > 0 ? problem.A : Eigen::Matrix2d(-100 * problem.A)};
        const double exact = std::log(y0) + (t1 > 0 ? t1 : -100 * t1);
        const auto r =
            sc::integrate(method, way, V2(y0, t1 > 0 ? 1 : 0), 0, t1, {.rtol = 1e-6, .atol = 1e-6});
        BOOST_TEST_CONTEXT("t1 = " << t1 << ": " << r.y.transpose()) {
            BOOST_TEST(sc::name(r.status) == "success");
            BOOST_TEST(std::abs(std::log(r.y[0]) / exact - 1) < 0.15);
        }
    }
}

}  // namespace

// R(z) is small where h lambda lies beyond its pole: a step that long would let a growing mode vanish that no
// error estimate sees, as it is far below atol. The sign of a determinant gives it away.
BOOST_AUTO_TEST_CASE(growth_from_below_the_tolerance_is_not_stepped_over) {
    follows_growth_from_below_the_tolerance(sc::radau_iia<3>(), 100);
    follows_growth_from_below_the_tolerance(sc::radau_iia<5>(), 100);
    follows_growth_from_below_the_tolerance(sc::gauss<3>(), 100);
    follows_growth_from_below_the_tolerance(sc::radau_iia_variable(), 100);
    follows_growth_from_below_the_tolerance(sc::radau_iia<4>(), 100);
    follows_growth_from_below_the_tolerance(sc::gauss<2>(), 100);
    follows_growth_from_below_the_tolerance(sc::lobatto_iiic<4>(), 100);
    follows_growth_from_below_the_tolerance(methods::sdirk_4_3(), 100);
}

// The unstable equilibrium itself is a solution, and so is what decays for ever: no status but success. What is exactly
// zero has nothing to grow from; what is not limits the steps, however little it is.
BOOST_AUTO_TEST_CASE(an_unstable_equilibrium_is_kept) {
    const linear<2> problem{(Eigen::Matrix2d() << 1, 0, 0, -100).finished()};
    const auto r = sc::integrate(sc::radau_iia<3>(), problem, V2(0, 1), 0, 100, {.rtol = 1e-6, .atol = 1e-6});
    BOOST_TEST(r.ok());
    BOOST_TEST(r.y[0] == 0);
    BOOST_TEST(r.report.largest_step > 10);
    const auto little =
        sc::integrate(sc::radau_iia<3>(), problem, V2(1e-60, 1), 0, 100, {.rtol = 1e-6, .atol = 1e-6});
    BOOST_TEST(little.ok());
    BOOST_TEST(little.report.largest_step < 3.7);
    const auto q = sc::integrate(sc::radau_iia<3>(), linear<2>{-problem.A.cwiseAbs()}, V2(0, 1), 0, 100,
                                 {.rtol = 1e-6, .atol = 1e-6});
    BOOST_TEST(q.ok());
    BOOST_TEST(q.report.largest_step > 10);
}
