// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE lemmas
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include <problems/thesis/solve.hpp>

#include "radau_stages.hpp"

using namespace thesis;

namespace {

struct by_h {
    double y, lambda;
};

}  // namespace

namespace {

// Slopes in h, stage by stage, of what `disturb(h)` makes of the stages of one step of Radau IIA-3.
template <class Disturb>
std::array<by_h, 3> effect(const setup& exact, Disturb disturb) {
    std::vector<double> h, y[3], lambda[3];
    for (double step = 1e-3; step > 1e-4; step /= 2) {
        const auto calm = stages(exact, step), moved = stages(disturb(step), step);
        h.push_back(step);
        for (int i = 0; i < 3; ++i) {
            y[i].push_back((moved[i] - calm[i]).head(10).norm());
            lambda[i].push_back((moved[i] - calm[i]).tail(2).norm());
        }
    }
    std::array<by_h, 3> out;
    for (int i = 0; i < 3; ++i) out[i] = {slope(h, y[i]), slope(h, lambda[i])};
    return out;
}

void all_stages(const std::array<by_h, 3>& seen, double y, double lambda) {
    for (const by_h& stage : seen) {
        BOOST_TEST(std::abs(stage.y - y) < 0.1);
        BOOST_TEST(std::abs(stage.lambda - lambda) < 0.1);
    }
}

// The disc with delta_i in f and theta_i in g, different at each stage of the step.
setup perturbed_stages(const setup& exact, double h, double delta, double theta) {
    setup disturbed = exact;
    disturbed.problem.f = [=, &exact](double t, const vector& y, vector& f) {
        exact.problem(t, y, f);
        f.segment(5, 5).array() += delta * (1 + t / h);
        f.tail(2).array() += theta * (2 - t / h);
    };
    return disturbed;
}

// y' = sin(lambda) + delta, 0 = y + theta, from y(0) = start: implicit Euler has sin(Lambda) = -(start + h delta + theta)/h.
double multiplier_of_sine(double h, double start, double delta, double theta) {
    setup s;
    s.problem.M = Eigen::Vector2d(1, 0).asDiagonal();
    s.problem.flags = {1, 2};
    s.problem.f = [=](double, const vector& y, vector& f) {
        f[0] = std::sin(y[1]) + delta;
        f[1] = y[0] + theta;
    };
    s.problem.df = [](double, const vector& y, Eigen::MatrixXd& J) { J << 0, std::cos(y[1]), 1, 0; };
    s.y0 = Eigen::Vector2d(start, 0);
    return solve(s, {.stages = 1, .tolerance = 1e-12, .steps = 1, .end = h}).path.back().y[1];
}

}  // namespace

BOOST_AUTO_TEST_CASE(lemma_1_every_stage_moves_by_h_delta_plus_theta_and_lambda_by_that_over_h) {
    const setup exact = restarted(disc_dae(), 0.25);
    // Fixed delta and theta first: (2.17) h |delta| and |theta|, (2.18) |delta| and |theta|/h, which are sharp.
    all_stages(effect(exact, [&](double h) { return perturbed_stages(exact, h, 1e-3, 0); }), 1, 0);
    all_stages(effect(exact, [&](double h) { return perturbed_stages(exact, h, 0, 1e-6); }), 0, -1);
    // delta = O(h), theta = O(h^2), as the lemma wants them
    all_stages(effect(exact, [&](double h) { return perturbed_stages(exact, h, h, 0); }), 2, 1);
    all_stages(effect(exact, [&](double h) { return perturbed_stages(exact, h, 0, h * h); }), 2, 1);
}

BOOST_AUTO_TEST_CASE(lemma_1_perturbed_starts_move_lambda_by_their_normal_part_over_h) {
    const setup exact = restarted(disc_dae(), 0.25);
    using velocities = Eigen::Matrix<double, 5, 1>;
    const auto moved = [&](const velocities& by) {
        setup s = exact;
        s.y0.segment(5, 5) += by;
        return s;
    };
    velocities along, across;
    along << 0.1, 0, 0, 0, 1;  // x' = R gamma' is kept: g_y (y^ - y) = 0
    across << 1, 0, 0, 0, 0;
    // (2.17) |y^ - y|; (2.18) h |y^ - y|/h along the constraint, |g_y (y^ - y)|/h across it
    all_stages(effect(exact, [&](double) { return moved(1e-6 * along); }), 0, 0);
    all_stages(effect(exact, [&](double) { return moved(1e-6 * across); }), 0, -1);
    all_stages(effect(exact, [&](double h) { return moved(h * h * across); }), 2, 1);  // y^ - y = O(h^2)
}

BOOST_AUTO_TEST_CASE(lemma_1_without_one_of_its_three_hypotheses_the_stages_need_not_exist) {
    for (const double h : {1e-2, 1e-4}) {
        BOOST_TEST(std::abs(multiplier_of_sine(h, h * h, 0, 0) + std::asin(h)) < 1e-8);
        BOOST_TEST(std::abs(multiplier_of_sine(h, 0, h, 0) + std::asin(h)) < 1e-8);
        BOOST_TEST(std::abs(multiplier_of_sine(h, 0, 0, h * h) + std::asin(h)) < 1e-8);
        // y^ - y = 2 h, delta = 2, theta = 2 h: sin(Lambda) = -2
        BOOST_CHECK_THROW(multiplier_of_sine(h, 2 * h, 0, 0), std::runtime_error);
        BOOST_CHECK_THROW(multiplier_of_sine(h, 0, 2, 0), std::runtime_error);
        BOOST_CHECK_THROW(multiplier_of_sine(h, 0, 0, 2 * h), std::runtime_error);
    }
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
