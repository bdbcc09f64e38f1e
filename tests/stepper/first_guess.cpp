// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE first_guess
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/equations.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/tableaux/rounded.hpp>

namespace sc = stagecraft;
using sc::tableaux::family;
using enum sc::tableaux::family;
using vector = Eigen::VectorXd;

namespace {

// y = (t^3/3, t^2), with a second equation that is differential or algebraic; nonlinear off the solution.
struct polynomial {
    bool algebraic;
    template <class T, class Y>
    void operator()(const T& t, const Y& y, Y& f) const {
        const typename Y::Scalar off = y[0] - t * t * t / 3.0;
        f[0] = y[1] - (2.0 + y[0]) * off - off * off;
        if (algebraic)
            f[1] = y[1] - t * t + (y[1] + 1.0) * off;
        else
            f[1] = 2.0 * t - (y[1] + 1.0) * off;
    }
    Eigen::DiagonalMatrix<double, Eigen::Dynamic> mass() const {
        return Eigen::DiagonalMatrix<double, Eigen::Dynamic>(Eigen::Vector2d(1, algebraic ? 0 : 1));
    }
};

template <class Problem, class Vector>
auto run(family f, int s, const Problem& p, double t0, const Vector& y0, int steps, double h) {
    return sc::integrate(sc::tableaux::rounded<double>(f, s), p, y0, t0, t0 + steps * h,
                         {.rtol = 1e-10, .atol = 1e-10, .fixed_step = h});
}

// Of Jay's problem, equations::index_three.
const Eigen::Matrix<double, 5, 1> jay0 = Eigen::Matrix<double, 5, 1>::Ones();

}  // namespace

// Where the continuous solution is exact its extrapolation solves the next stage equations, and at most one
// more iteration tells so. The first step has nothing to start from.
BOOST_AUTO_TEST_CASE(an_exact_continuous_solution_leaves_nothing_to_iterate) {
    for (const family f : {radau_iia, lobatto_iiia})
        for (const bool algebraic : {false, true})
            for (const int s : {4, 5})
                BOOST_TEST_CONTEXT(sc::tableaux::name(f) << " " << s << " " << algebraic) {
                    const polynomial p{algebraic};
                    const vector y0 = Eigen::Vector2d(1.0 / 3, 1);
                    const auto one = run(f, s, p, 1, y0, 1, 0.125), five = run(f, s, p, 1, y0, 5, 0.125);
                    BOOST_TEST(one.ok());
                    BOOST_TEST(five.ok());
                    BOOST_TEST(std::abs(five.y[0] - std::pow(1.625, 3) / 3) < 1e-12);
                    BOOST_TEST(std::abs(five.y[1] - std::pow(1.625, 2)) < 1e-12);
                    BOOST_TEST(one.report.solves > 4);
                    BOOST_TEST(five.report.solves <= one.report.solves + 2 * 4);
                }
}

BOOST_AUTO_TEST_CASE(few_steps_of_lobatto_iiia_solve_a_problem_of_index_3) {
    for (const int s : {4, 5, 6, 7, 8}) BOOST_TEST_CONTEXT("s = " << s) {
            const auto r = run(lobatto_iiia, s, equations::index_three{}, 0, jay0, 4, 0.125);
            BOOST_TEST(sc::name(r.status) == "success");
            BOOST_TEST(r.report.factorisations == 4);  // none by continuation
            const double e = std::exp(0.5);
            BOOST_TEST(std::abs(r.y[0] - e * e) < 1e-7);
            BOOST_TEST(std::abs(r.y[2] - e * e) < 1e-5);
            BOOST_TEST(std::abs(r.y[4] - e) < 1e-3);
        }
}

// A step as long as this is solved in parts first, which Newton's iteration for index 3 would not be if it
// gave up where its second increment is as large as the first.
BOOST_AUTO_TEST_CASE(one_long_step_of_lobatto_iiia_solves_a_problem_of_index_3) {
    for (const int s : {5, 6, 7, 8}) BOOST_TEST_CONTEXT("s = " << s) {
            const auto r = run(lobatto_iiia, s, equations::index_three{}, 0, jay0, 1, 0.5);
            BOOST_TEST(sc::name(r.status) == "success");
            BOOST_TEST(r.report.factorisations > 1);
            const double e = std::exp(0.5);
            BOOST_TEST(std::abs(r.y[0] - e * e) < 1e-6);
            BOOST_TEST(std::abs(r.y[2] - e * e) < 1e-3);
            BOOST_TEST(std::abs(r.y[4] - e) < 1e-2);
        }
}
