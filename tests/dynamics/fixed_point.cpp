// SPDX-License-Identifier: BSL-1.0
// Lecture, (2.3) and section 2.4.2: the stage equations by fixed point iteration, where it converges and where not.
#define BOOST_TEST_MODULE fixed_point
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/fixed_point.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/solution.hpp>

using namespace stagecraft;
using Eigen::Vector2d;

namespace {

using field = std::function<void(double, const Vector2d&, Vector2d&)>;

field damped(double lambda) {
    return [lambda](double, const Vector2d& y, Vector2d& f) { f = lambda * y; };
}
const field pendulum = [](double, const Vector2d& y, Vector2d& f) { f << y[1], -std::sin(y[0]); };

template <class Method>
result<Vector2d> one_step(const Method& m, const field& f, double h) {
    return integrate(m, f, Vector2d(1, -0.5), 0.0, h, {.fixed_step = h, .newton_iterations = 20'000});
}

}  // namespace

BOOST_AUTO_TEST_CASE(fixed_point_steps_are_the_steps_of_newtons_iteration_without_any_jacobian) {
    const auto solve = [](const auto& method) {
        return integrate(method, pendulum, Vector2d(1, 0), 0.0, 5.0,
                         {.rtol = 1e-12, .atol = 1e-13, .fixed_step = 0.05});
    };
    const auto newton = solve(gauss<3>()), iterated = solve(fixed_point(gauss<3>()));
    BOOST_REQUIRE(newton.ok());
    BOOST_REQUIRE(iterated.ok());
    BOOST_TEST((newton.y - iterated.y).norm() < 1e-11);
    BOOST_TEST(iterated.report.jacobians == 0);
    BOOST_TEST(iterated.report.factorisations == 0);
    BOOST_TEST(iterated.report.steps == newton.report.steps);
}

BOOST_AUTO_TEST_CASE(the_continuous_solution_is_that_of_the_method) {
    solution<Vector2d> newton, iterated;
    const options<double> o{.rtol = 1e-12, .atol = 1e-13, .fixed_step = 0.1};
    integrate(gauss<3>(), pendulum, Vector2d(1, 0), 0.0, 2.0, o, newton);
    integrate(fixed_point(gauss<3>()), pendulum, Vector2d(1, 0), 0.0, 2.0, o, iterated);
    for (const double t : {0.0, 0.37, 1.11, 1.999}) BOOST_TEST((newton(t) - iterated(t)).norm() < 1e-10);
}

BOOST_AUTO_TEST_CASE(h_L_norm_of_A_below_1_suffices_and_beyond_h_lambda_rho_of_A_1_the_iteration_diverges) {
    const auto ends = [](const auto& method, double limit) {
        BOOST_TEST(one_step(fixed_point(method), damped(-1), 0.97 * limit).ok());
        const auto beyond = one_step(fixed_point(method), damped(-1), 1.03 * limit);
        BOOST_TEST((beyond.status == status::newton_failed || beyond.status == status::non_finite));
        BOOST_TEST(one_step(method, damped(-1), 1.03 * limit).ok());  // Newton's does not mind
        BOOST_TEST(one_step(method, damped(-1), 1e6 * limit).ok());
        const double sufficient = 0.99 / method.A.cwiseAbs().rowwise().sum().maxCoeff();
        BOOST_TEST(sufficient < limit);
        BOOST_TEST(one_step(fixed_point(method), damped(-1), sufficient).ok());
    };
    ends(gauss<2>(), std::sqrt(12.0));
    ends(radau_iia<3>(), 1 / radau_iia<3>().A.eigenvalues().cwiseAbs().maxCoeff());
}

BOOST_AUTO_TEST_CASE(
    section_2_4_2_norm_of_h_b_below_1_is_not_h_lambda_below_1_for_a_matrix_that_is_not_normal) {
    // x' = B x, B = (-1, k; 0, -1), implicit Euler: |h lambda| = h, and |hB| as large as k makes it. The printed "|hB| < 1, that
    // is |h lambda| < 1" holds from left to right only.
    const auto shear = [](double k) -> field {
        return [k](double, const Vector2d& y, Vector2d& f) { f << -y[0] + k * y[1], -y[1]; };
    };
    const auto method = fixed_point(radau_iia<1>());
    for (const double k : {0.0, 3.0}) {
        const Eigen::Matrix2d hB = (Eigen::Matrix2d() << -0.5, 0.5 * k, 0, -0.5).finished();
        BOOST_TEST((hB.jacobiSvd().singularValues()[0] > 1) == (k > 1));
        const auto r = one_step(method, shear(k), 0.5);
        BOOST_REQUIRE(r.ok());  // both converge: |h lambda| = 1/2
        const Vector2d exact = (Eigen::Matrix2d::Identity() - hB).inverse() * Vector2d(1, -0.5);
        BOOST_TEST((r.y - exact).norm() < 1e-5);
        BOOST_TEST(!one_step(method, shear(k), 1.1).ok());  // |h lambda| > 1: neither
    }
}

BOOST_AUTO_TEST_CASE(what_the_iteration_cannot_serve_is_refused) {
    const auto adaptive = [] { integrate(fixed_point(gauss<3>()), pendulum, Vector2d(1, 0), 0.0, 1.0); };
    BOOST_CHECK_THROW(adaptive(), std::invalid_argument);
    struct massive {
        void operator()(double, const Vector2d& y, Vector2d& f) const { f = -y; }
        Eigen::Matrix2d mass() const { return Eigen::Vector2d(1, 2).asDiagonal(); }
    };
    const auto with_mass = [] {
        integrate(fixed_point(gauss<2>()), massive{}, Vector2d(1, 0), 0.0, 1.0, {.fixed_step = 0.1});
    };
    BOOST_CHECK_THROW(with_mass(), std::invalid_argument);
}
