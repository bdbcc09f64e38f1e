// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE lemmas
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/linear/logarithmic_norm.hpp>

#include <problems/thesis/solve.hpp>

using namespace thesis;

namespace {

struct by_h {
    double y, lambda;
};

}  // namespace

BOOST_AUTO_TEST_CASE(lemma_1_perturbed_stages_move_by_h_delta_plus_theta_and_lambda_by_that_over_h) {
    const setup exact = restarted(disc_dae(), 0.25);
    // Slopes in h of what fixed perturbations delta of f and theta of g do to the last stage of Radau IIA-3.
    const auto effect = [&](double delta, double theta) {
        setup disturbed = exact;
        disturbed.problem.f = [&](double t, const vector& y, vector& f) {
            exact.problem(t, y, f);
            f.segment(5, 5).array() += delta;
            f.tail(2).array() += theta;
        };
        std::vector<double> h, y, lambda;
        for (double step = 1e-3; step > 1e-4; step /= 2) {
            const request one{.tolerance = 1e-13, .steps = 1, .end = step};
            const vector d = solve(disturbed, one).path.back().y - solve(exact, one).path.back().y;
            h.push_back(step);
            y.push_back(d.head(10).norm());
            lambda.push_back(d.tail(2).norm());
        }
        return by_h{slope(h, y), slope(h, lambda)};
    };
    const by_h of_delta = effect(1e-3, 0), of_theta = effect(0, 1e-6);
    BOOST_TEST(std::abs(of_delta.y - 1) < 0.1);       // (2.17): h |delta|
    BOOST_TEST(std::abs(of_delta.lambda) < 0.1);      // (2.18): |delta|
    BOOST_TEST(std::abs(of_theta.y) < 0.1);           // (2.17): |theta|
    BOOST_TEST(std::abs(of_theta.lambda + 1) < 0.1);  // (2.18): |theta|/h: no bound without the h below
}

BOOST_AUTO_TEST_CASE(lemma_1_perturbed_starts_move_lambda_by_their_normal_part_over_h) {
    const setup exact = restarted(disc_dae(), 0.25);
    // Slopes in h of what a fixed change of the velocities at the start does to the last stage.
    const auto effect = [&](const Eigen::Matrix<double, 5, 1>& direction) {
        setup moved = exact;
        moved.y0.segment(5, 5) += 1e-6 * direction;
        std::vector<double> h, y, lambda;
        for (double step = 1e-3; step > 1e-4; step /= 2) {
            const request one{.tolerance = 1e-13, .steps = 1, .end = step};
            const vector d = solve(moved, one).path.back().y - solve(exact, one).path.back().y;
            h.push_back(step);
            y.push_back(d.head(10).norm());
            lambda.push_back(d.tail(2).norm());
        }
        return by_h{slope(h, y), slope(h, lambda)};
    };
    Eigen::Matrix<double, 5, 1> along, across;
    along << 0.1, 0, 0, 0, 1;  // x' = R gamma' is kept: g_y (y^ - y) = 0
    across << 1, 0, 0, 0, 0;
    const by_h tangential = effect(along), normal = effect(across);
    BOOST_TEST(std::abs(tangential.y) < 0.1);       // (2.17): |y^ - y|
    BOOST_TEST(std::abs(tangential.lambda) < 0.1);  // (2.18): h |y^ - y| / h
    BOOST_TEST(std::abs(normal.y) < 0.1);
    BOOST_TEST(std::abs(normal.lambda + 1) < 0.1);  // (2.18): |g_y (y^ - y)| / h
}

BOOST_AUTO_TEST_CASE(lemma_2_1_the_collocation_polynomials_approximate_derivatives_as_well) {
    // |u^(k) - y^(k)| = O(h^{s+1-k}), |v^(k) - lambda^(k)| = O(h^{s-k}) for s = 3 and k = 0 ... 3; the
    // derivatives by divided differences between fixed points of the step.
    constexpr int s = 3;
    const setup start = restarted(disc_dae(), 0.25);
    const std::array theta{0.3, 0.5, 0.7, 0.9};
    std::vector<double> h, u[s + 1], v[s + 1];
    for (double step = 1e-2; step > 1e-3; step /= 2) {
        std::array<vector, s + 1> difference;
        request one{.tolerance = 1e-13, .steps = 1, .end = step};
        one.watch = [&](double, const vector&, double, const piece& p) {
            for (int i = 0; i <= s; ++i) difference[i] = p(theta[i] * step);
            return true;
        };
        solve(start, one);
        for (int i = 0; i <= s; ++i)
            difference[i] -=
                solve(start, {.stages = 5, .tolerance = 1e-13, .steps = 8, .end = theta[i] * step})
                    .path.back()
                    .y;
        h.push_back(step);
        for (int k = 0; k <= s; ++k) {
            u[k].push_back(difference[0].head(10).norm());
            v[k].push_back(difference[0].tail(2).norm());
            for (int i = 0; i + k < s; ++i)
                difference[i] = (difference[i + 1] - difference[i]) / ((theta[i + k + 1] - theta[i]) * step);
        }
    }
    for (int k = 0; k <= s; ++k) {
        BOOST_TEST(std::abs(slope(h, u[k]) - (s + 1 - k)) < 0.2);
        BOOST_TEST(std::abs(slope(h, v[k]) - (s - k)) < 0.2);
    }
}

namespace {

const Eigen::Matrix2d shear = (Eigen::Matrix2d() << -1, 4, 0, -2).finished();

// exp(shear t): eigenvalues -1 and -2.
Eigen::Matrix2d flow(double t) {
    const double a = std::exp(-t), b = std::exp(-2 * t);
    return (Eigen::Matrix2d() << a, 4 * (a - b), 0, b).finished();
}

double norm(const Eigen::Vector2d& x, int p) {
    return p == 1 ? x.lpNorm<1>() : p == 2 ? x.norm() : x.lpNorm<Eigen::Infinity>();
}

double mu(int p) {
    const auto all = stagecraft::logarithmic_norm(shear);
    return p == 1 ? all.one : p == 2 ? all.euclidean : all.infinity;
}

}  // namespace

BOOST_AUTO_TEST_CASE(lemma_3_4_the_logarithmic_norm_bounds_the_distance_to_a_perturbed_solution) {
    // y' = A y and v' = A v + d with |d| = delta: |y - v| <= e^{l t} C + delta (e^{l t} - 1)/l with l = mu(A)
    // in each norm. With the larger eigenvalue -1 in place of mu it fails: A is not normal.
    for (const int p : {1, 2, 0}) {
        double closest = 1e300;
        bool eigenvalue_suffices = true;
        for (double angle = 0; angle < 6.3; angle += 0.1) {
            const Eigen::Vector2d e(std::cos(angle), std::sin(angle)), gap = e / norm(e, p), d = 0.1 * gap;
            for (double t = 0.05; t < 3; t += 0.05) {
                const Eigen::Vector2d moved =
                    flow(t) * gap + shear.partialPivLu().solve((flow(t) - Eigen::Matrix2d::Identity()) * d);
                const auto bound = [&](double l) { return std::exp(l * t) + 0.1 * std::expm1(l * t) / l; };
                closest = std::min(closest, bound(mu(p)) - norm(moved, p));
                if (norm(moved, p) > bound(-1)) eigenvalue_suffices = false;
            }
        }
        BOOST_TEST(closest >= -1e-14);
        BOOST_TEST(!eigenvalue_suffices);
    }
}

BOOST_AUTO_TEST_CASE(definition_3_1_the_dini_derivative_of_a_norm_is_at_most_mu_times_it) {
    // D_+ |x| <= mu(A) |x| along x' = A x, with equality for some x; |x| itself has corners in the 1-norm.
    for (const int p : {1, 2, 0}) {
        double largest = -1e300;
        for (int k = 0; k < 2000; ++k) {
            const double angle = k * 3.14159265358979 / 1000, h = 1e-7;
            const Eigen::Vector2d x(std::cos(angle), std::sin(angle));
            largest = std::max(largest, (norm(x + h * (shear * x), p) / norm(x, p) - 1) / h);
        }
        BOOST_TEST(largest <= mu(p) + 1e-5);
        BOOST_TEST(largest > mu(p) - 1e-2);
    }
}

BOOST_AUTO_TEST_CASE(lemma_3_3_comparison_needs_a_quasi_monotone_system) {
    // m' <= g(m) and u' > g(u) from the same start give m <= u if g_i grows with the other components. Here
    // m' = B m and u' = B u + (1, 0.1) from (1, 1).
    const auto stays_below = [](double coupling) {
        Eigen::Matrix2d B;
        B << -1, coupling, coupling, -1;
        Eigen::Vector2d m(1, 1), u(1, 1);
        bool below = true;
        const double h = 1e-3;
        for (int k = 0; k < 3000; ++k) {
            m += h * (B * m);
            u += h * (B * u + Eigen::Vector2d(1, 0.1));
            below = below && m[0] <= u[0] && m[1] <= u[1];
        }
        return below;
    };
    BOOST_TEST(stays_below(0.5));
    BOOST_TEST(!stays_below(-0.5));
}
