// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE model_assumptions
#include <Eigen/LU>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <stagecraft/dae/hessenberg.hpp>
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/model_assumptions.hpp>
#include <stagecraft/mechanics/singularity.hpp>

#include <problems/rolling_disc/disc.hpp>
#include <problems/thesis/limits.hpp>
#include <problems/thesis/nonholonomic.hpp>

using namespace stagecraft;
using thesis::vector;
using vector3 = Eigen::Vector3d;

namespace {

// A dry friction, F = -sign(v): no derivative where the knife edge stands still.
struct rubbing : thesis::knife_edge {
    template <class S>
    Eigen::Matrix<S, 3, 1> F(const Eigen::Matrix<S, 3, 1>& x, const Eigen::Matrix<S, 3, 1>& v) const {
        Eigen::Matrix<S, 3, 1> F = knife_edge::F(x, v);
        F[0] += S(v[0] > S(0) ? -1 : 1);
        return F;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_falling_disc_is_stopped_before_it_lies_flat) {
    const rolling_disc::disc<> body;
    const auto dae = index_2(body);
    const Eigen::Matrix<double, 5, 1> q = rolling_disc::initial_position(),
                                      rest = Eigen::Matrix<double, 5, 1>::Zero();
    const auto fall = [&](double margin) {
        singularity_watch watch(body, margin);
        const auto r = thesis::solve<double>({thesis::erased(dae), dae.initial_state(q, rest), {}},
                                             {.tolerance = 1e-9, .watch = std::ref(watch)});
        for (const auto& p : r.path) BOOST_TEST(std::cos(p.y[3]) > margin);
        return watch;
    };
    for (const double margin : {1e-1, 1e-3, 1e-6}) {
        const auto watch = fall(margin);
        BOOST_TEST(watch.found());
        BOOST_TEST(std::cos(watch.position()[3]) == margin, boost::test_tools::tolerance(1e-6));
        // Energy: beta'^2 = 8 g (cos beta(0) - cos beta)/(5 R).
        BOOST_TEST(watch.message().find("beta = +-pi/2: the disc lies flat, at t = 0.4") == 0);
    }
    // The thesis' motion stays upright: the watch sees nothing and the run goes to its end.
    singularity_watch watch(body);
    const auto r = thesis::solve<double>(
        {thesis::erased(dae), dae.initial_state(q, rolling_disc::initial_velocity()), {}},
        {.tolerance = 1e-6, .watch = std::ref(watch)});
    BOOST_TEST(!watch.found());
    BOOST_TEST(watch.message() == "");
    BOOST_TEST(r.path.back().t == 1.0);
    BOOST_CHECK_THROW(singularity_watch(body, 0), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_singular_position_passed_within_one_step_is_seen) {
    // Without other forces the angle grows linearly and a long step passes beta = pi/2: both ends are far
    // from it.
    struct output {
        double t0() const { return 0; }
        Eigen::Matrix<double, 5, 1> operator()(double t) const {
            return (Eigen::Matrix<double, 5, 1>() << 0, 0, 0, 3 * t, 0).finished();
        }
    };
    singularity_watch watch{rolling_disc::disc<>()};
    BOOST_TEST(watch(0.3, output()(0.3), 0.3, output()));
    BOOST_TEST(!watch(1.0, output()(1.0), 1.0, output()));
    BOOST_TEST(watch.position()[3] == std::acos(1e-3), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(hessenberg_forms_report_their_index) {
    const auto index = [](const thesis::any_problem& problem, const vector& y) {
        const auto form = hessenberg_index(problem, 0.0, y);
        return form.differentiation_index;
    };
    const thesis::setup dae = thesis::disc_dae(),
                        soft = thesis::disc_regularised(thesis::form::mass_matrix, 1e-6, 0.5);
    BOOST_TEST(index(dae.problem, dae.y0) == 2);
    const double c = std::cos(dae.y0[3]);
    BOOST_TEST(hessenberg_index(dae.problem, 0.0, dae.y0).condition == 5 / (5 - 4 * c * c) / 3,
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST(index(thesis::disc_reduced().problem, dae.y0.head(10)) == 0);
    // Regularised, the algebraic equation 0 = (eps^kappa/d)(lambda - zeta) - G v can be solved for lambda.
    BOOST_TEST(index(soft.problem, soft.y0) == 1);

    const thesis::pendulum swing;
    const vector horizontal = vector::Unit(5, 0), stabilised = vector::Unit(6, 0);
    BOOST_TEST(index(thesis::erased(index_3(swing)), horizontal) == 3);
    BOOST_TEST(index(thesis::erased(index_2(swing)), horizontal) == 2);
    BOOST_TEST(index(thesis::erased(stabilised_index_2(swing)), stabilised) == 2);
    // At x = y = 0 the rod has no direction, G = 0, and no index is to be had.
    BOOST_CHECK_THROW(index(thesis::erased(index_2(swing)), vector::Zero(5)), std::domain_error);
    thesis::any_problem coupled = thesis::erased(index_2(swing));
    coupled.M(0, 1) = 1;
    BOOST_CHECK_THROW(index(coupled, horizontal), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(
    remark_1_the_index_is_invariant_under_algebraic_transformations_and_not_under_differentiation) {
    // y = T w, lambda = L mu, and equations combined: T^-1 (f + H g) and S g in place of f and g.
    std::mt19937 random(1);
    std::normal_distribution<double> number;
    const auto matrix = [&](Eigen::Index rows, Eigen::Index columns) {
        Eigen::MatrixXd a(rows, columns);
        for (Eigen::Index k = 0; k < a.size(); ++k) a.data()[k] = number(random);
        return a;
    };
    const thesis::pendulum swing;
    const thesis::any_problem forms[] = {thesis::erased(index_2(swing)), thesis::erased(index_3(swing))};
    const vector horizontal = vector::Unit(5, 0);
    for (int k = 0; k < 20; ++k) {
        const Eigen::MatrixXd T = matrix(4, 4) + 3 * Eigen::MatrixXd::Identity(4, 4), H = matrix(4, 1);
        const double L = 1 + std::abs(number(random)), S = -1 - std::abs(number(random));
        for (const thesis::any_problem& form : forms) {
            thesis::any_problem moved = form;
            Eigen::MatrixXd inner = Eigen::MatrixXd::Zero(5, 5), outer = inner;
            inner.topLeftCorner(4, 4) = T, inner(4, 4) = L;
            outer.topLeftCorner(4, 4) = T.inverse(), outer.topRightCorner(4, 1) = T.inverse() * H,
                                   outer(4, 4) = S;
            moved.f = [=](double t, const vector& w, vector& out) {
                vector value(5);
                form(t, inner * w, value);
                out = outer * value;
            };
            moved.df = [=](double t, const vector& w, Eigen::MatrixXd& J) {
                Eigen::MatrixXd value(5, 5);
                form.jacobian(t, inner * w, value);
                J = outer * value * inner;
            };
            const auto before = hessenberg_index(form, 0.0, horizontal),
                       after = hessenberg_index(moved, 0.0, vector(inner.partialPivLu().solve(horizontal)));
            BOOST_TEST(before.differentiation_index == after.differentiation_index);
            BOOST_TEST(before.perturbation_index == after.perturbation_index);
        }
    }
    // The constraint differentiated once is equivalent for consistent values, and its index is one less.
    BOOST_TEST(hessenberg_index(forms[1], 0.0, horizontal).differentiation_index == 3);
    BOOST_TEST(hessenberg_index(forms[0], 0.0, horizontal).differentiation_index == 2);
}

BOOST_AUTO_TEST_CASE(perturbations_of_the_constraint_are_differentiated_index_minus_one_times) {
    // Definition 1.2, measured: with 0 = g + 1e-6 sin(w t) the multiplier is off by 1e-6 w for index 2, by
    // 1e-6 w^2 for index 3.
    const thesis::pendulum model;
    vector start(5);
    start << 1, 0, 0, 0, 0;
    const auto growth = [&](const thesis::any_problem& calm) {
        std::vector<double> w{40, 80, 160}, error;
        for (const double omega : w) {
            thesis::any_problem shaken = calm;
            shaken.f = [&, omega](double t, const vector& y, vector& f) {
                calm(t, y, f);
                f[4] += 1e-6 * std::sin(omega * t);
            };
            const thesis::request how{.stages = 5, .tolerance = 1e-12, .steps = 2000};
            const auto a = thesis::solve<double>({shaken, start, {}}, how),
                       b = thesis::solve<double>({calm, start, {}}, how);
            double worst = 0;
            for (std::size_t k = 100; k < a.path.size(); ++k)
                worst = std::max(worst, std::abs(a.path[k].y[4] - b.path[k].y[4]));
            error.push_back(worst);
        }
        return thesis::slope(w, error);
    };
    for (const auto& problem : {thesis::erased(index_2(model)), thesis::erased(index_3(model))})
        BOOST_TEST(std::abs(growth(problem) + 1 - hessenberg_index(problem, 0.0, start).perturbation_index) <
                   0.1);
}

BOOST_AUTO_TEST_CASE(definition_1_2_of_the_disc_for_both_equations) {
    // Defects 1e-6 sin(w t) in f or in g of the index-2 system. Of f none is differentiated: y is off by its
    // integral, O(1/w), lambda by itself. Of g one derivative reaches lambda, O(w), and none reaches y: the
    // perturbation index is 2.
    const auto of_f = thesis::growth_with_frequency(5, 5), of_g = thesis::growth_with_frequency(10, 2);
    BOOST_TEST(std::abs(of_f.y + 1) < 0.1);
    BOOST_TEST(std::abs(of_f.lambda) < 0.1);
    BOOST_TEST(std::abs(of_g.y) < 0.1);
    BOOST_TEST(std::abs(of_g.lambda - 1) < 0.1);
}

BOOST_AUTO_TEST_CASE(model_assumptions_hold_along_the_disc_and_fail_when_it_lies_flat) {
    const rolling_disc::disc<> body;
    const auto r = thesis::solve(thesis::disc_dae(), {.tolerance = 1e-8});
    auto all = check_assumptions(body, rolling_disc::initial_position());
    for (const auto& p : r.path) {
        const Eigen::Matrix<double, 5, 1> q = p.y.head<5>(), v = p.y.segment<5>(5);
        const auto a = check_assumptions(body, q, v, Eigen::Vector2d(p.y.tail<2>()));
        BOOST_TEST(a.hold());
        BOOST_TEST(a.derivative_defect < 1e-8);
        const double s = 5 / (5 - 4 * std::pow(std::cos(q[3]), 2));  // G M^-1 G^T = diag(3, s)
        BOOST_TEST(a.inertia_condition == std::max(s / 3, 3 / s), boost::test_tools::tolerance(1e-10));
        all = worst_of(all, a);
    }
    BOOST_TEST(all.hold());
    BOOST_TEST(all.smallest_pivot < check_assumptions(body, rolling_disc::initial_position()).smallest_pivot);
    Eigen::Matrix<double, 5, 1> flat = rolling_disc::initial_position();
    flat[3] = std::numbers::pi / 2;
    const auto a = check_assumptions(body, flat);
    BOOST_TEST(!a.hold());
    BOOST_TEST(a.singular == "beta = +-pi/2: the disc lies flat");
    const vector3 x(0, 0, 0), still(0, 0, 2);
    const Eigen::Matrix<double, 1, 1> none = Eigen::Matrix<double, 1, 1>::Zero();
    BOOST_TEST(check_assumptions(thesis::knife_edge(), x, still, none).hold());
    BOOST_TEST(!check_assumptions(rubbing(), x, still, none).hold());
}
