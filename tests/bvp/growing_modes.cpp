// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE bvp_growing_modes
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference.hpp"

// x' = A(t) x + q(t) with modes e^{20 t} and e^{-18 t} that turn with t, x(0) + x(pi) = (1 + e^pi) (1, 1), solution
// e^t (1, 1) (Ascher-Mattheij-Russell, p. 151). The conditions are separated by two constants z3, z4 = x(0).

namespace {

struct turning_modes {
    template <class T, class Y>
    void operator()(const T& t, const Y& y, Y& f) const {
        using std::cos;
        using std::exp;
        using std::sin;
        const T c = 19 * cos(2 * t), s = 19 * sin(2 * t), e = exp(t);
        f[0] = y[0] * (1 - c) + y[1] * (s + 1) + (c - s - 1) * e;
        f[1] = y[0] * (s - 1) + y[1] * (c + 1) + (1 - s - c) * e;
        f[2] = 0 * y[2];
        f[3] = 0 * y[3];
    }
};

struct sum_of_ends {
    template <class Y, class R>
    void operator()(const Y& a, const Y& b, R& r) const {
        r[0] = a[0] - a[2];
        r[1] = a[1] - a[3];
        r[2] = b[0] + b[2] - (std::exp(pi) + 1);
        r[3] = b[1] + b[3] - (std::exp(pi) + 1);
    }
};

auto solve(const sc::bvp_options<double>& o) {
    return sc::solve_bvp(sc::gauss<5>(), sc::two_point(turning_modes{}, sum_of_ends{}), 0.0, pi,
                         Eigen::Vector4d(1, 1, 1, 1), o);
}

}  // namespace

BOOST_AUTO_TEST_CASE(between_the_mesh_points_the_answer_is_as_good_as_at_them) {
    const auto cases = problems::boundary_value_cases();
    const auto stored =
        std::find_if(cases.begin(), cases.end(), [](const auto& c) { return c.name == "amr_1"; });
    BOOST_REQUIRE(stored != cases.end());
    for (const double tolerance : {1e-5, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12}) {
        const auto answer = solve({.rtol = tolerance});
        check(*stored, tolerance, answer);
        // On ten intervals of 0.31, one of them multiplies errors by 500.
        Eigen::Vector4d largest = Eigen::Vector4d::Zero();
        double relative = 0;
        for (int k = 0; k <= 1000; ++k) {
            const double t = k < 1000 ? k * pi / 1000 : pi;
            const Eigen::Vector4d exact(std::exp(t), std::exp(t), 1, 1);
            const Eigen::Vector4d error = (answer.y(t) - exact).cwiseAbs();
            largest = largest.cwiseMax(error);
            relative = std::max(relative, (error.array() / (1 + exact.array())).maxCoeff());
        }
        BOOST_TEST_CONTEXT("tolerance " << tolerance) {
            BOOST_TEST(relative <= tolerance);
            BOOST_TEST(relative <= 1.5 * answer.error.global);
            BOOST_TEST(answer.error.global <= 1.5 * relative);
            for (int c = 0; c < 4; ++c) {
                BOOST_TEST(largest[c] <= 4 * answer.error.components[c]);
                BOOST_TEST(answer.error.components[c] <= 4 * largest[c]);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(the_reported_defect_is_that_of_the_answer) {
    for (const int intervals : {10, 20, 40}) {
        const auto answer = solve({.rtol = 1e-6, .intervals = intervals, .adapt = false});
        double largest = 0;
        for (int k = 0; k < 1000; ++k) {
            const double t = (k + 0.5) * pi / 1000;
            const Eigen::Vector4d y = answer.y(t), slope = answer.y.derivative(t);
            Eigen::Vector4d f;
            turning_modes()(t, y, f);
            largest = std::max(largest, ((slope - f).array() / (1 + f.array().abs())).abs().maxCoeff());
        }
        BOOST_TEST(largest <= 10 * (answer.error.defect + 1e-13));
        BOOST_TEST(answer.error.defect <= 10 * (largest + 1e-13));
    }
}

// Troesch's problem from zero: coarse solutions of y'' = n sinh(n y) have values between their points at which sinh overflows.
// With y' = 2 sinh(n y / 2), as it is but for exponentially small terms, tanh(n y / 4) = tanh(n / 4) exp(n (t - 1)).
BOOST_AUTO_TEST_CASE(coarse_solutions_that_lead_to_where_f_overflows_are_refined) {
    for (const double n : {30.0, 40.0, 50.0})
        for (const double tolerance : {1e-4, 1e-7}) {
            const auto troesch = [n](const auto&, const auto& y, auto& f) {
                using std::sinh;
                f[0] = y[1];
                f[1] = n * sinh(n * y[0]);
            };
            const auto ends = [](const auto& left, const auto& right, auto& r) {
                r[0] = left[0];
                r[1] = right[0] - 1;
            };
            const auto answer = sc::solve_bvp(sc::gauss<5>(), sc::two_point(troesch, ends), 0.0, 1.0,
                                              Eigen::Vector2d(0, 0), {.rtol = tolerance});
            BOOST_TEST(sc::name(answer.status) == "success");
            for (const double t : {0.5, 0.9, 0.99, 0.9999, 0.999999}) {
                const double y = 4 / n * std::atanh(std::tanh(n / 4) * std::exp(n * (t - 1)));
                BOOST_TEST(std::abs(answer.y(t)[0] - y) <= 2 * tolerance);
            }
        }
}
