// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE diagonally_implicit
#include "methods.hpp"
#include "outcome.hpp"
#include "smooth.hpp"

#include <Eigen/LU>
#include <boost/test/unit_test.hpp>
#include <problems/equations.hpp>
#include <problems/stored.hpp>
#include <stagecraft/integrate.hpp>
#include <string>

namespace sc = stagecraft;
using V1 = Eigen::Matrix<double, 1, 1>;
using method = sc::tableau<double>;

BOOST_AUTO_TEST_CASE(stiff_van_der_pol_is_solved_to_the_tolerance) {
    const Eigen::Vector2d y0(2, -0.66);
    const auto ref = problems::reference("vdpol");
    for (const double tol : {1e-4, 1e-7}) {
        for (const method& m : {methods::sdirk_4_3(), methods::tr_bdf2()}) {
            const auto r = sc::integrate(m, equations::van_der_pol{}, y0, 0, 2, {.rtol = tol, .atol = tol});
            BOOST_TEST(r.ok());
            BOOST_TEST(problems::error(r.y, ref, 1.0) < 200 * tol);
        }
    }
    // an explicit method pays with steps below the stability bound, and says so instead of lying
    const auto r = sc::integrate(methods::dormand_prince(), equations::van_der_pol{}, y0, 0, 2,
                                 {.rtol = 1e-4, .max_steps = 10000});
    BOOST_TEST(sc::name(r.status) == "too_many_steps");
}

BOOST_AUTO_TEST_CASE(an_index_1_problem_keeps_the_order_of_stiffly_accurate_methods) {
    const auto error = [](const method& m, int i) {
        return [m, i](double h) {
            const auto r = sc::integrate(m, smooth::index_one{}, Eigen::Vector2d(1, 1), 0, 0.5,
                                         {.rtol = 1e-14, .atol = 1e-14, .fixed_step = h});
            BOOST_TEST(r.ok());
            return std::abs(r.y[i] - std::exp((i + 1) * std::sin(0.5)));
        };
    };
    for (const int i : {0, 1}) {
        BOOST_TEST(slope(error(methods::sdirk_4_3(), i), 0.02) == 4, boost::test_tools::tolerance(0.05));
        BOOST_TEST(slope(error(methods::tr_bdf2(), i), 0.02) == 2, boost::test_tools::tolerance(0.05));
    }
    for (const method& m : {methods::sdirk_4_3(), methods::tr_bdf2()}) {
        const auto r =
            sc::integrate(m, smooth::index_one{}, Eigen::Vector2d(1, 1), 0, 3, {.rtol = 1e-7, .atol = 1e-7});
        BOOST_TEST(r.ok());
        BOOST_TEST(r.y[0] == std::exp(std::sin(3.0)), boost::test_tools::tolerance(1e-5));
        BOOST_TEST(r.y[1] == std::exp(2 * std::sin(3.0)), boost::test_tools::tolerance(1e-5));
    }
    const std::string refused =
        refusal(methods::classical(), smooth::index_one{}, Eigen::Vector2d(1, 1), 0.1);
    BOOST_TEST(has(refused, "mass()"));
    BOOST_TEST(has(refused, "method"));
}

// M dense and regular: the same as M^-1 f, which the test writes out.
BOOST_AUTO_TEST_CASE(explicit_stages_solve_with_a_regular_mass_matrix) {
    struct massive {
        Eigen::Matrix2d m;
        void operator()(double, const Eigen::Vector2d& y, Eigen::Vector2d& f) const { f << y[1], -y[0]; }
        Eigen::Matrix2d mass() const { return m; }
    };
    for (const bool diagonal : {true, false}) {
        Eigen::Matrix2d m;
        m << 2, diagonal ? 0 : 1, 0, 3;
        const auto plain = [&](double, const Eigen::Vector2d& y, Eigen::Vector2d& f) {
            f = m.inverse() * Eigen::Vector2d(y[1], -y[0]);
        };
        const Eigen::Vector2d y0(1, 2);
        for (const method& method : {methods::dormand_prince(), methods::classical(), methods::tr_bdf2()}) {
            const auto a = sc::integrate(method, massive{m}, y0, 0, 1, {.fixed_step = 0.1});
            const auto b = sc::integrate(method, plain, y0, 0, 1, {.fixed_step = 0.1});
            BOOST_TEST((a.y - b.y).norm() < 1e-9);
            BOOST_TEST((a.y - y0).norm() > 0.1);
        }
    }
    // singular but for rounding: 0.1 + 0.2 is not 0.3
    Eigen::Matrix2d nearly;
    nearly << 0.1 + 0.2, 0.3, 0.3, 0.3;
    BOOST_TEST(has(refusal(methods::classical(), massive{nearly}, Eigen::Vector2d(1, 2), 0.1), "mass()"));
}

namespace {
long factored = 0;
// A solver of the problem's own, which counts.
struct counting_blocks {
    struct real : sc::small_inverse<double, 1> {
        using sc::small_inverse<double, 1>::small_inverse;
        bool factor() {
            ++factored;
            return sc::small_inverse<double, 1>::factor();
        }
    };
    using complex = sc::small_complex_inverse<double, 1>;
};
struct linear {
    using linear_solver = counting_blocks;
    void operator()(double t, const V1& y, V1& f) const { f[0] = -50 * (y[0] - std::cos(t)); }
    void jacobian(double, const V1&, Eigen::Matrix<double, 1, 1>& J) const { J(0, 0) = -50; }
    bool constant_jacobian() const { return true; }
};
}  // namespace

BOOST_AUTO_TEST_CASE(equal_diagonal_entries_share_one_factorisation) {
    const auto count = [](const method& m) {
        factored = 0;
        const auto r = sc::integrate(m, linear{}, V1(1.0), 0, 1, {.fixed_step = 1.0 / 64});
        BOOST_TEST(r.ok());
        BOOST_TEST(r.report.factorisations == 1);
        return factored;
    };
    BOOST_TEST(count(methods::sdirk_4_3()) == 1);
    BOOST_TEST(count(methods::tr_bdf2()) == 1);
    BOOST_TEST(count(methods::dirk_of_two_diagonals()) == 2);
    const auto r = sc::integrate(methods::sdirk_4_3(), linear{}, V1(1.0), 0, 1, {.rtol = 1e-5});
    BOOST_TEST(r.ok());
    BOOST_TEST(r.report.factorisations <= r.report.steps + r.report.rejected());
}
