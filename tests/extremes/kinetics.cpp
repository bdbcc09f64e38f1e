// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE kinetics
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/equations.hpp>
#include <problems/stored.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/tableaux/rounded.hpp>

// Robertson, OREGO and HIRES over stage numbers and tolerances, and Robertson's problem to 1e20.

namespace sc = stagecraft;
using enum sc::tableaux::family;

namespace {

using method = sc::transformed_tableau<double>;

template <class Problem, class Vector>
void within(const Problem& problem, const Vector& y0, double t1, const std::string& reference, double floor,
            double factor) {
    const Eigen::VectorXd exact = problems::reference(reference);
    for (const auto& [f, s] : {std::pair{radau_iia, 3}, std::pair{radau_iia, 4}, std::pair{radau_iia, 5},
                               std::pair{radau_iia, 7}, std::pair{lobatto_iiic, 4}}) {
        const method m = sc::tableaux::transformed<double>(f, s);
        for (int digits = 3; digits <= 10; ++digits) {
            const double tol = std::pow(10.0, -digits);
            if (f == lobatto_iiic && digits > 7) continue;  // an estimate of order s takes many steps
            const auto r = sc::integrate(m, problem, y0, 0, t1, {.rtol = tol, .atol = tol * floor});
            BOOST_TEST_CONTEXT(name(f) << " s = " << s << " tol = 1e-" << digits) {
                BOOST_TEST(sc::name(r.status) == "success");
                BOOST_TEST(problems::error(r.y, exact, floor) < factor * tol);
            }
        }
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(robertson_to_1e11) {
    within(equations::robertson{}, Eigen::Vector3d(1, 0, 0), 1e11, "rober", 1e-6, 20);
}

BOOST_AUTO_TEST_CASE(oregonator) {
    within(equations::oregonator{}, Eigen::Vector3d(1, 2, 3), 360, "orego", 1e-6, 50);
}

BOOST_AUTO_TEST_CASE(hires) {
    Eigen::Matrix<double, 8, 1> y0 = Eigen::Matrix<double, 8, 1>::Zero();
    y0[0] = 1;
    y0[7] = 0.0057;
    within(equations::hires{}, y0, 321.8122, "hires", 1e-4, 50);
}

// For y1 -> 0 the second component is quasi-stationary, y2 = 4e-6 y1, and y1' + y2' = -3e7 y2^2:
// y1 = (1 + 4e-6) / (4.8e-4 t) up to a relative O(log t / t).
BOOST_AUTO_TEST_CASE(robertson_to_1e20) {
    for (const int s : {3, 5, 7}) {
        const method m = sc::tableaux::transformed<double>(radau_iia, s);
        for (const double tol : {1e-4, 1e-7, 1e-10}) {
            const auto r = sc::integrate(m, equations::robertson{}, Eigen::Vector3d(1, 0, 0), 0, 1e20,
                                         {.rtol = tol, .atol = tol * 1e-24});
            BOOST_TEST_CONTEXT("s = " << s << " tol = " << tol) {
                BOOST_TEST(sc::name(r.status) == "success");
                BOOST_TEST(r.t == 1e20);
                BOOST_TEST(std::abs(r.y[0] * 4.8e-4 * 1e20 / (1 + 4e-6) - 1) < 50 * tol);
                BOOST_TEST(std::abs(r.y[1] / (4e-6 * r.y[0]) - 1) < 50 * tol);
                BOOST_TEST(std::abs(r.y.sum() - 1) < 50 * tol);
            }
        }
    }
}

namespace {

// The law of mass action ends at concentrations below zero by more than the tolerance: there f is not a
// number. (Without this the system itself runs away: solutions that start at y1 = -1e-9 tend to minus
// infinity, and an exact solution through a state within atol of the true one may do that.)
struct with_domain : equations::robertson {
    double atol;
    explicit with_domain(double tolerance) : atol(tolerance) {}
    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, 3, 1>& y, Eigen::Matrix<S, 3, 1>& f) const {
        equations::robertson::operator()(t, y, f);
        if (y.minCoeff() < -atol) f[0] = f[1] = f[2] = S(std::nan(""));
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(robertson_with_its_domain_is_right_or_no_success_whatever_the_absolute_tolerance) {
    int successes = 0;
    for (const int s : {3, 5, 7}) {
        const method m = sc::tableaux::transformed<double>(radau_iia, s);
        for (const double atol : {1e-4, 1e-6, 1e-8, 1e-12})
            for (const double t1 : {1e6, 1e11, 1e20}) {
                const auto r = sc::integrate(m, with_domain(atol), Eigen::Vector3d(1, 0, 0), 0, t1,
                                             {.rtol = 1e-4, .atol = atol});
                BOOST_TEST_CONTEXT("s = " << s << " atol = " << atol << " t1 = " << t1 << " "
                                          << sc::name(r.status) << " t = " << r.t
                                          << " y = " << r.y.transpose()) {
                    BOOST_TEST(r.y.minCoeff() >= -2 * atol);
                    BOOST_TEST(std::abs(r.y.sum() - 1) < 20 * (1e-4 + atol));
                    if (r.ok() && t1 > 1e6)
                        BOOST_TEST((r.y - Eigen::Vector3d(0, 0, 1)).norm() < 20 * (1e-4 + atol));
                    successes += r.ok();
                }
            }
    }
    BOOST_TEST(successes > 18);
}
