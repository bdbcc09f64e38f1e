// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE constrained
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/equations.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <string>

// Differential-algebraic problems of index 1, 2 and 3 with known solutions, adaptive steps.

namespace sc = stagecraft;
using enum sc::tableaux::family;
using V5 = Eigen::Matrix<double, 5, 1>;

namespace {

// x'' = -x u, y'' = -y u - 1 on the unit circle: the pendulum, released at rest beside its pivot; the
// constraint is given once (index 2) or twice (index 1) differentiated, or as it is (index 3).
template <int Index>
struct pendulum {
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 5, 1>& q, Eigen::Matrix<S, 5, 1>& f) const {
        f[0] = q[2];
        f[1] = q[3];
        f[2] = -q[0] * q[4];
        f[3] = -q[1] * q[4] - 1.0;
        if constexpr (Index == 3) f[4] = q[0] * q[0] + q[1] * q[1] - 1.0;
        if constexpr (Index == 2) f[4] = q[0] * q[2] + q[1] * q[3];
        if constexpr (Index == 1)
            f[4] = q[2] * q[2] + q[3] * q[3] - q[4] * (q[0] * q[0] + q[1] * q[1]) - q[1];
    }
    Eigen::DiagonalMatrix<double, 5> mass() const {
        Eigen::DiagonalMatrix<double, 5> m;
        m.diagonal() << 1, 1, 1, 1, 0;
        return m;
    }
    std::array<int, 5> index() const {
        if constexpr (Index == 3) return {1, 1, 2, 2, 3};
        return {1, 1, 1, 1, Index};
    }
};

// The index-3 pendulum without index flags.
struct unflagged {
    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, 5, 1>& q, Eigen::Matrix<S, 5, 1>& f) const {
        pendulum<3>{}(t, q, f);
    }
    auto mass() const { return pendulum<3>{}.mass(); }
};

// A quarter of the period is K(sin 45 deg); there the bob is at the bottom with speed sqrt 2 and u = 3.
template <int Index>
void swings_to_the_bottom(int s, double tol, double factor, double factor_u) {
    const auto m = sc::tableaux::transformed<double>(radau_iia, s);
    V5 start, bottom;
    start << 1, 0, 0, 0, 0;
    bottom << 0, -1, -std::sqrt(2.0), 0, 3;
    const double quarter = std::comp_ellint_1(std::sqrt(0.5));
    const auto r = sc::integrate(m, pendulum<Index>{}, start, 0, quarter, {.rtol = tol, .atol = tol});
    const V5 error = (r.y - bottom).cwiseAbs() / tol;
    BOOST_TEST_CONTEXT("index " << Index << " s = " << s << " tol = " << tol << ": " << error.transpose()
                                << ", h <= " << r.report.largest_step) {
        // Index 3 with steps of high order that are long for the tolerance: Newton's iteration may fail.
        if (Index == 3 && s >= 5 && tol > 1e-4 && !r.ok()) return;
        BOOST_TEST(sc::name(r.status) == "success");
        BOOST_TEST(error.head<2>().maxCoeff() < factor);
        // A component of index k is asked for to tol / h^{k - 1} only.
        const double h = std::max(std::sqrt(tol), r.report.smallest_step);
        BOOST_TEST(error.segment<2>(2).maxCoeff() < factor / (Index == 3 ? h : 1));
        BOOST_TEST(error[4] < factor_u / std::pow(h, Index - 1));
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_pendulum_as_index_1_2_and_3_swings_to_the_bottom_in_a_quarter_of_its_period) {
    for (const int s : {2, 3, 5, 7})
        for (const double tol : {1e-3, 1e-5, 1e-7, 1e-9}) {
            swings_to_the_bottom<1>(s, tol, 30, 100);
            swings_to_the_bottom<2>(s, tol, 30, 100);
            swings_to_the_bottom<3>(s, tol, 100, 100);
        }
}

BOOST_AUTO_TEST_CASE(jay_s_problem_of_index_3) {
    for (const int s : {2, 3, 5})
        for (const double tol : {1e-4, 1e-6, 1e-8}) {
            const auto m = sc::tableaux::transformed<double>(radau_iia, s);
            double y = 0, z = 0, u = 0;
            const auto look = [&](double t, const V5& x, double h) {
                const auto relative = [&](double a, double b) { return std::abs(a / b - 1) / tol; };
                y = std::max(y, relative(x[0], std::exp(2 * t)));
                z = std::max(z, relative(x[2], std::exp(2 * t)) * h);
                u = std::max(u, relative(x[4], std::exp(t)) * h * h);
            };
            const auto r = sc::integrate(m, equations::index_three{}, V5::Ones().eval(), 0, 1,
                                         {.rtol = tol, .atol = tol}, look);
            BOOST_TEST_CONTEXT("s = " << s << " tol = " << tol << ": y " << y << " z " << z << " u " << u) {
                BOOST_TEST(sc::name(r.status) == "success");
                BOOST_TEST(y < 50);
                BOOST_TEST(z < 500);
                BOOST_TEST(u < 1000);
            }
        }
}

// No theorem bounds what a method that is not stiffly accurate makes of index 3; Gauss methods were seen to
// end with success and a multiplier of wrong size.
BOOST_AUTO_TEST_CASE(index_3_is_refused_to_adaptive_steps_of_methods_that_are_not_stiffly_accurate) {
    const auto run = [](const auto f, int s, double step) -> std::string {
        try {
            const auto m = sc::tableaux::transformed<double>(f, s);
            return sc::name(sc::integrate(m, equations::index_three{}, V5::Ones().eval(), 0, 0.1,
                                          {.rtol = 1e-6, .atol = 1e-6, .fixed_step = step})
                                .status);
        } catch (const std::invalid_argument& e) {
            return e.what();
        }
    };
    for (const int s : {2, 3, 5}) {
        BOOST_TEST(run(gauss, s, 0).find("index()") != std::string::npos);
        BOOST_TEST(run(radau_ia, s, 0).find("index()") != std::string::npos);
        BOOST_TEST(run(radau_iia, s, 0) == "success");
        BOOST_TEST(run(gauss, s, 0.05).find("index()") == std::string::npos);  // equal steps promise nothing
    }
}

// Quadratic in z: 2 y2 z^2 - 3 z + y1^2 = 0 has the roots z = exp(2 t), the solution, and half of it. With
// ever smaller weights for z as the steps get smaller a run could end on the second.
BOOST_AUTO_TEST_CASE(the_problem_of_index_2) {
    for (const int s : {2, 3, 5, 7, 9})
        for (const double tol : {1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10}) {
            const auto m = sc::tableaux::transformed<double>(radau_iia, s);
            double y = 0, z = 0;
            const auto look = [&](double t, const Eigen::Vector3d& x, double h) {
                y = std::max(y, std::abs(x[0] / std::exp(t) - 1) / tol);
                z = std::max(z, std::abs(x[2] / std::exp(2 * t) - 1) / tol * std::max(h, std::sqrt(tol)));
            };
            const auto r = sc::integrate(m, equations::index_two{}, Eigen::Vector3d(1, 1, 1), 0, 1,
                                         {.rtol = tol, .atol = tol}, look);
            BOOST_TEST_CONTEXT("s = " << s << " tol = " << tol << ": y " << y << " z " << z) {
                BOOST_TEST(sc::name(r.status) == "success");
                BOOST_TEST(y < 20);
                BOOST_TEST(z < 200);  // the mapped tolerance: order s where y has 2 s - 1
                // Newton's iteration meets left-overs of the tolerance in z, not the other root.
                BOOST_TEST(r.report.rejected_newton <= r.report.steps);
                if (s >= 5) BOOST_TEST(r.report.steps < 100);
            }
        }
}

// Not flagged, components of index 3 are asked for more than h can give: the run may end early but does not
// end wrong.
BOOST_AUTO_TEST_CASE(without_index_flags_the_run_is_right_or_no_success) {
    V5 start;
    start << 1, 0, 0, 0, 0;
    const double quarter = std::comp_ellint_1(std::sqrt(0.5));
    for (const int s : {2, 3, 5})
        for (const double tol : {1e-3, 1e-6, 1e-9}) {
            const auto m = sc::tableaux::transformed<double>(radau_iia, s);
            const auto r = sc::integrate(m, unflagged{}, start, 0, quarter,
                                         {.rtol = tol, .atol = tol, .max_steps = 20000});
            BOOST_TEST_CONTEXT("s = " << s << " tol = " << tol << " " << sc::name(r.status)
                                      << " t = " << r.t) {
                BOOST_TEST(std::abs(std::hypot(r.y[0], r.y[1]) - 1) < 10 * tol);
                if (r.ok()) BOOST_TEST(std::abs(r.y[0]) < 100 * tol);
            }
        }
}

// 0 = e^z - 1 - y sin^2 t: a guess far above the solution throws the first iterate far below it, where f no longer
// depends on z; the second increment is small beside the first then, and nothing has converged.
BOOST_AUTO_TEST_CASE(an_iteration_that_is_thrown_far_off_is_not_taken_for_converged) {
    struct exponential {
        void operator()(double t, const Eigen::Vector2d& x, Eigen::Vector2d& f) const {
            f << std::cos(t) - x[0] * std::exp(x[1]), 1e3 * defect(t, x);
        }
        void jacobian(double t, const Eigen::Vector2d& x, Eigen::Matrix2d& J) const {
            J << -std::exp(x[1]), -x[0] * std::exp(x[1]), -1e3 * std::pow(std::sin(t), 2),
                1e3 * std::exp(x[1]);
        }
        Eigen::DiagonalMatrix<double, 2> mass() const { return Eigen::DiagonalMatrix<double, 2>(1, 0); }
        static double defect(double t, const Eigen::Vector2d& x) {
            return std::exp(x[1]) - 1 - std::pow(std::sin(t), 2) * x[0];
        }
    };
    for (const double tol : {1e-2, 3e-3, 1e-4}) {
        double most = 0;
        const auto r = sc::integrate(sc::tableaux::transformed<double>(radau_iia, 7), exponential{},
                                     Eigen::Vector2d(1, 0), 0, 10, {.rtol = tol, .atol = tol},
                                     [&](double t, const Eigen::Vector2d& x) {
                                         most = std::max(most, std::abs(exponential::defect(t, x)));
                                     });
        BOOST_TEST(sc::name(r.status) == "success");
        BOOST_TEST(most < tol);
    }
}
