// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE coupled
#include "methods.hpp"
#include "outcome.hpp"
#include "smooth.hpp"

#include <boost/test/unit_test.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/lobatto_iiia.hpp>
#include <stagecraft/coefficients/lobatto_iiib.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/method/step_doubling.hpp>
#include <stdexcept>
#include <string>

namespace sc = stagecraft;
using V1 = Eigen::Matrix<double, 1, 1>;
using method = sc::tableau<double>;

namespace {

// The plain tableau of a method whose number of stages is known to the compiler.
template <int S>
method plain(const sc::tableau<double, S>& m) {
    return {m.A, m.b, m.c, m.b_embedded, m.facts};
}

// y = exp(sin t); with an algebraic component z = y^2 from a constraint solved by no formula.
struct wave {
    void operator()(double t, const V1& y, V1& f) const {
        f[0] = y[0] * std::cos(t) - y[0] * y[0] + std::exp(2 * std::sin(t));
    }
    void jacobian(double t, const V1& y, Eigen::Matrix<double, 1, 1>& J) const {
        J(0, 0) = std::cos(t) - 2 * y[0];
    }
};

constexpr double tiny = 1e-14;

template <class Problem>
auto solve(const method& m, const Problem& p, double t1, double h) {
    constexpr int n = std::is_same_v<Problem, smooth::index_one> ? 2 : 1;
    const auto r = sc::integrate(m, p, Eigen::Matrix<double, n, 1>::Ones().eval(), 0, t1,
                                 {.rtol = tiny, .atol = tiny, .fixed_step = h});
    BOOST_TEST(r.ok());
    return r;
}
double wave_order(const method& m, double h) {
    return slope([&](double k) { return std::abs(solve(m, wave{}, 0.5, k).y[0] - std::exp(std::sin(0.5))); },
                 h);
}

}  // namespace

BOOST_AUTO_TEST_CASE(fixed_steps_show_the_order_of_methods_with_singular_matrix) {
    const auto shows = [](const method& m, double h, double tolerance) {
        BOOST_TEST(std::abs(wave_order(m, h) - m.facts.order) < tolerance);
    };
    shows(plain(sc::lobatto_iiia<2>()), 0.02, 0.05);
    shows(plain(sc::lobatto_iiia<3>()), 0.05, 0.05);
    shows(plain(sc::lobatto_iiia<4>()), 0.125, 0.25);  // sharper at 50 digits: catalogue_orders
    shows(plain(sc::lobatto_iiib<2>()), 0.02, 0.05);
    shows(plain(sc::lobatto_iiib<3>()), 0.05, 0.05);
    shows(plain(sc::lobatto_iiib<4>()), 0.125, 0.25);
    // one wrong entry and the order is gone
    auto m = plain(sc::lobatto_iiib<3>());
    m.A(1, 0) += 0.01;
    BOOST_TEST(wave_order(m, 0.05) < 2.5);
}

BOOST_AUTO_TEST_CASE(the_coupled_system_is_the_transformed_one) {
    const auto direct = sc::integrate(sc::radau_iia<3>(), wave{}, V1(1.0), 0, 2,
                                      {.rtol = tiny, .atol = tiny, .fixed_step = 0.1});
    BOOST_TEST(std::abs(solve(plain(sc::radau_iia<3>()), wave{}, 2, 0.1).y[0] - direct.y[0]) < 1e-13);
    BOOST_TEST(std::abs(solve(plain(sc::gauss<2>()), wave{}, 2, 0.1).y[0] - direct.y[0]) > 1e-9);
}

BOOST_AUTO_TEST_CASE(the_left_end_is_no_stage_of_lobatto_iiia) {
    const auto r = solve(plain(sc::lobatto_iiia<4>()), wave{}, 1, 0.125);
    BOOST_TEST(r.report.f == 3 * r.report.solves + 1);
    const auto b = solve(plain(sc::lobatto_iiib<4>()), wave{}, 1, 0.125);
    BOOST_TEST(b.report.f == 4 * b.report.solves);
}

// Symmetric methods go back the way they came.
BOOST_AUTO_TEST_CASE(symmetric_methods_return_to_where_they_started) {
    const auto away = [](const method& m) {
        const auto forth = solve(m, wave{}, 2, 0.125);
        const auto back =
            sc::integrate(m, wave{}, forth.y, 2, 0, {.rtol = tiny, .atol = tiny, .fixed_step = 0.125});
        BOOST_TEST(back.ok());
        return std::abs(back.y[0] - 1);
    };
    BOOST_TEST(away(plain(sc::lobatto_iiia<3>())) < 1e-11);
    BOOST_TEST(away(plain(sc::lobatto_iiib<3>())) < 1e-11);
    BOOST_TEST(away(plain(sc::radau_iia<2>())) > 1e-7);
}

BOOST_AUTO_TEST_CASE(an_index_1_problem_keeps_the_order_of_lobatto_iiia) {
    const auto order = [&](const method& m, int i, double h) {
        const double exact = std::exp((i + 1) * std::sin(0.5));
        return slope([&](double k) { return std::abs(solve(m, smooth::index_one{}, 0.5, k).y[i] - exact); },
                     h);
    };
    for (const int i : {0, 1}) {
        BOOST_TEST(std::abs(order(plain(sc::lobatto_iiia<3>()), i, 0.05) - 4) < 0.1);
        BOOST_TEST(std::abs(order(plain(sc::lobatto_iiia<2>()), i, 0.02) - 2) < 0.1);
        BOOST_TEST(std::abs(order(plain(sc::radau_iia<2>()), i, 0.02) - 3) < 0.1);
    }
    // not stiffly accurate, A regular: y keeps its order, z has that of the stages (s = 2: HLR89 table 2.3)
    BOOST_TEST(std::abs(order(plain(sc::gauss<2>()), 0, 0.05) - 4) < 0.1);
    BOOST_TEST(std::abs(order(plain(sc::gauss<2>()), 1, 0.05) - 2) < 0.1);
}

BOOST_AUTO_TEST_CASE(a_singular_mass_matrix_asks_for_more_of_the_method) {
    const auto said = [](const method& m, double step = 0.1) -> std::string {
        try {
            sc::integrate(m, smooth::index_one{}, Eigen::Vector2d(1, 1), 0, 1, {.fixed_step = step});
        } catch (const std::invalid_argument& e) {
            return e.what();
        }
        return "accepted";
    };
    BOOST_TEST(said(plain(sc::lobatto_iiib<3>())).find("problem.mass() is singular") != std::string::npos);
    BOOST_TEST(said(plain(sc::lobatto_iiia<3>())) == "accepted");
    BOOST_TEST(said(plain(sc::gauss<3>())) == "accepted");
    // Radau I: first stage explicit, y1 no stage
    const method radau_i = methods::rows<double>({{}, {1. / 3, 1. / 3}, {1. / 4, 3. / 4}});
    BOOST_TEST(said(radau_i).find("problem.mass() is singular") != std::string::npos);
    // Two half steps and the whole one leave the same error of z where |R(infinity)| = 1: no estimate.
    BOOST_TEST(said(sc::step_doubling(plain(sc::gauss<2>()))) == "accepted");
    BOOST_TEST(said(sc::step_doubling(plain(sc::gauss<2>())), 0).find("use options.fixed_step") !=
               std::string::npos);
    BOOST_TEST(said(sc::step_doubling(plain(sc::radau_iia<2>())), 0) == "accepted");
}

// The stage order s of IIIA carries the error to h^s and below, however stiff the equation is.
BOOST_AUTO_TEST_CASE(stiff_equations_are_solved_with_the_stage_order) {
    for (const double lambda : {-1e4, -1e8, -1e12}) {
        const auto r = solve(plain(sc::lobatto_iiia<3>()), smooth::prothero_robinson{lambda}, 2, 0.05);
        BOOST_TEST(std::abs(r.y[0] - std::cos(2.0)) < 1e-6);
    }
}

BOOST_AUTO_TEST_CASE(embedded_weights_control_the_error) {
    auto a = plain(sc::lobatto_iiia<3>());
    a.b_embedded = Eigen::Vector3d(0.5, 0, 0.5);
    auto g = plain(sc::radau_iia<3>());  // weights of order 2 in the last two nodes
    const double c2 = g.c[1];
    g.b_embedded = Eigen::Vector3d(0, 0.5 / (1 - c2), (0.5 - c2) / (1 - c2));
    for (const method& m : {a, g})
        for (const double tol : {1e-4, 1e-7}) {
            const auto r =
                sc::integrate(m, smooth::prothero_robinson{-1e3}, V1(1.5), 0, 2, {.rtol = tol, .atol = tol});
            BOOST_TEST(r.ok());
            BOOST_TEST(std::abs(r.y[0] - std::cos(2.0)) < tol);
            BOOST_TEST(r.report.largest_step > 10 * r.report.smallest_step);  // the transient is over
        }
}

BOOST_AUTO_TEST_CASE(the_continuous_solution_is_the_collocation_polynomial) {
    const auto inner_order = [](const method& m, double h, bool derivative) {
        return slope(
            [&](double k) {
                double worst = 0;
                const auto look = [&](double t, const V1&, double step, const auto& output) {
                    for (int i = 0; i < 8; ++i) {
                        const double x = t - step * i / 8, exact = std::exp(std::sin(x));
                        worst = std::max(worst,
                                         std::abs(derivative ? output.derivative(x)[0] - std::cos(x) * exact
                                                             : output(x)[0] - exact));
                    }
                };
                sc::integrate(m, wave{}, V1(1.0), 0, 0.5, {.rtol = tiny, .atol = tiny, .fixed_step = k},
                              look);
                return worst;
            },
            h);
    };
    BOOST_TEST(std::abs(inner_order(plain(sc::lobatto_iiia<4>()), 0.1, false) - 5) < 0.25);
    BOOST_TEST(std::abs(inner_order(plain(sc::lobatto_iiia<4>()), 0.1, true) - 4) < 0.25);
    BOOST_TEST(std::abs(inner_order(plain(sc::lobatto_iiia<3>()), 0.05, false) - 4) < 0.25);
    BOOST_TEST(std::abs(inner_order(plain(sc::gauss<3>()), 0.05, false) - 4) < 0.25);
    // no C(s): the weights of a cubic instead, of order 2 with three stages
    BOOST_TEST(std::abs(inner_order(plain(sc::lobatto_iiib<3>()), 0.025, false) - 3) < 0.3);
}
