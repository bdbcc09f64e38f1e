// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE theorems
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/dense_once.hpp>

#include <problems/thesis/solve.hpp>

#include "radau_stages.hpp"

using namespace thesis;

namespace {

const Eigen::Matrix3d& radau_matrix() {
    static const double r = std::sqrt(6.0);
    static const Eigen::Matrix3d A = (Eigen::Matrix3d() << (88 - 7 * r) / 360, (296 - 169 * r) / 1800,
                                      (-2 + 3 * r) / 225, (296 + 169 * r) / 1800, (88 + 7 * r) / 360,
                                      (-2 - 3 * r) / 225, (16 - r) / 36, (16 + r) / 36, 1.0 / 9)
                                         .finished();
    return A;
}

// (2.41), I (x) M - h A (x) J for Radau IIA-3, at y_n and with J of each stage at the exact stage values. Unknowns and
// equations: those of y of all stages, then those of lambda.
struct newton_matrices {
    Eigen::MatrixXd at_start, at_stages;
    int ny = 10, nl = 2;
    newton_matrices(const setup& s, double h) : at_start(Eigen::MatrixXd::Zero(36, 36)), at_stages(at_start) {
        Eigen::MatrixXd J(12, 12), J0(12, 12);
        s.problem.jacobian(0, s.y0, J0);
        for (int j = 0; j < 3; ++j) {
            const vector Y =
                solve(s, {.stages = 5, .tolerance = 1e-13, .steps = 4, .end = radau_nodes[j] * h})
                    .path.back()
                    .y;
            s.problem.jacobian(0, Y, J);
            for (int i = 0; i < 3; ++i) {
                place(at_stages, i, j, (i == j) * s.problem.M - h * radau_matrix()(i, j) * J);
                place(at_start, i, j, (i == j) * s.problem.M - h * radau_matrix()(i, j) * J0);
            }
        }
    }
    void place(Eigen::MatrixXd& K, int i, int j, const Eigen::MatrixXd& block) const {
        K.block(i * ny, j * ny, ny, ny) = block.topLeftCorner(ny, ny);
        K.block(i * ny, 30 + j * nl, ny, nl) = block.topRightCorner(ny, nl);
        K.block(30 + i * nl, j * ny, nl, ny) = block.bottomLeftCorner(nl, ny);
        K.block(30 + i * nl, 30 + j * nl, nl, nl) = block.bottomRightCorner(nl, nl);
    }
};

double norm(const Eigen::MatrixXd& a) { return a.jacobiSvd().singularValues()[0]; }

Eigen::MatrixXd kronecker(const Eigen::Matrix3d& A, const Eigen::MatrixXd& B) {
    Eigen::MatrixXd K(3 * B.rows(), 3 * B.cols());
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) K.block(i * B.rows(), j * B.cols(), B.rows(), B.cols()) = A(i, j) * B;
    return K;
}

struct norms {
    double plain, scaled, kantorovich;
};

// Norm of the derivative of the simplified Newton iteration at the exact stage values, I - K(y0)^-1 K(Y), in the plain
// norm and in that of D = diag(1, h) (thesis 2.4), and the product that Kantorovich's theorem wants below 1/2.
norms iteration_derivative(const setup& s, double h) {
    newton_matrices k(s, h);
    const Eigen::MatrixXd inverse = k.at_start.inverse();
    const double kantorovich = norm(inverse) * norm(k.at_stages - k.at_start);
    // The rows of the algebraic equations are divided by h first, which changes nothing but the conditioning.
    k.at_start.bottomRows(6) /= h, k.at_stages.bottomRows(6) /= h;
    const Eigen::MatrixXd P =
        Eigen::MatrixXd::Identity(36, 36) - k.at_start.partialPivLu().solve(k.at_stages);
    Eigen::VectorXd D = Eigen::VectorXd::Ones(36);
    D.tail(6).setConstant(h);
    return {norm(P), norm(D.asDiagonal() * P * D.cwiseInverse().asDiagonal()), kantorovich};
}

// Slopes in h of errors in y, P y (P = I - f_lambda (g_y f_lambda)^-1 g_y), lambda and of |g(y)|.
struct orders {
    double y, projected, lambda, constraint;
};

struct measured {
    std::vector<double> h, y, projected, lambda, constraint;
    void add(const setup& s, double step, const vector& run, const vector& exact) {
        Eigen::MatrixXd J(12, 12);
        s.problem.jacobian(0, exact, J);
        const Eigen::MatrixXd g_y = J.block(10, 0, 2, 10), f_lambda = J.block(0, 10, 10, 2);
        const Eigen::VectorXd d = run - exact, dy = d.head(10),
                              rest = (g_y * f_lambda).partialPivLu().solve(g_y * dy);
        if (h.empty() || h.back() != step) {
            h.push_back(step);
            for (auto* e : {&y, &projected, &lambda, &constraint}) e->push_back(1e-300);
        }
        const auto raise = [](std::vector<double>& e, double x) { e.back() = std::max(e.back(), x); };
        raise(y, dy.norm());
        raise(projected, (dy - f_lambda * rest).norm());
        raise(lambda, d.tail(2).norm());
        raise(constraint, disc_constraint(run).norm());
    }
    orders slopes() const {
        return {slope(h, y), slope(h, projected), slope(h, lambda), slope(h, constraint)};
    }
};

// Of one step from the exact solution.
orders local(request method) {
    static const setup s = restarted(disc_dae(), 0.25);
    measured m;
    for (double step = 1e-2; step > 2e-3; step /= 2) {
        const vector exact =
            solve(s, {.stages = 5, .tolerance = 1e-13, .steps = 16, .end = step}).path.back().y;
        method.tolerance = 1e-13;
        method.steps = 1;
        method.end = step;
        m.add(s, step, solve(s, method).path.back().y, exact);
    }
    return m.slopes();
}

// In the maximum over every step of [0, 1/4].
orders global(request method, long first = 200) {
    static const setup s = disc_dae();
    static const trajectory exact = solve(s, {.stages = 7, .tolerance = 1e-13, .steps = 1600, .end = 0.25});
    measured m;
    for (long steps = first; steps <= 4 * first; steps *= 2) {
        method.tolerance = 1e-13;
        method.steps = steps;
        method.end = 0.25;
        const trajectory run = solve(s, method);
        const std::size_t stride = 1600 / static_cast<std::size_t>(steps);
        for (std::size_t k = 1; k < run.path.size(); ++k)
            m.add(s, 0.25 / static_cast<double>(steps), run.path[k].y, exact.path[k * stride].y);
    }
    return m.slopes();
}

// Orders of a stage.
struct by_stage {
    double y, lambda;
};

const request radau_iia_2{.stages = 2}, radau_iia_3{.stages = 3},
    radau_ia_3{.method = family::radau_ia, .stages = 3}, gauss_2{.method = family::gauss, .stages = 2};

// Collocation of order 3 with two nodes, c_2 < 1: not stiffly accurate, R(inf) = prod (c_i - 1)/c_i = 3/5 and
// 5/3.
using stagecraft::tableaux::rational;
const request damping{.nodes = {rational(1, 4), rational(5, 6)}},
    growing{.nodes = {rational(1, 6), rational(3, 4)}};

bool near(double order, double expected) { return std::abs(order - expected) < 0.2; }

}  // namespace

BOOST_AUTO_TEST_CASE(equation_2_41_the_inverse_has_blocks_of_order_1_1_over_h_1_over_h_and_1_over_h_squared) {
    const setup s = restarted(disc_dae(), 0.4);
    Eigen::MatrixXd J(12, 12);
    s.problem.jacobian(0, s.y0, J);
    const Eigen::MatrixXd g_y = J.block(10, 0, 2, 10), f_lambda = J.block(0, 10, 10, 2),
                          inner = (g_y * f_lambda).inverse(), unit = Eigen::MatrixXd::Identity(10, 10);
    const Eigen::Matrix3d one = Eigen::Matrix3d::Identity(), Ai = radau_matrix().inverse();
    // norms of the four blocks, and of what their leading terms leave
    std::vector<double> h, size[4], rest[4];
    for (double step = 1e-2; step > 5e-4; step /= 2) {
        const Eigen::MatrixXd K = newton_matrices(s, step).at_start.inverse();
        const Eigen::MatrixXd blocks[4] = {K.topLeftCorner(30, 30), K.topRightCorner(30, 6),
                                           K.bottomLeftCorner(6, 30), K.bottomRightCorner(6, 6)};
        const Eigen::MatrixXd leading[4] = {
            kronecker(one, unit - f_lambda * inner * g_y), -kronecker(Ai, f_lambda * inner) / step,
            -kronecker(Ai, inner * g_y) / step, -kronecker(Ai * Ai, inner) / (step * step)};
        h.push_back(step);
        for (int i = 0; i < 4; ++i) {
            size[i].push_back(norm(blocks[i]));
            rest[i].push_back(norm(blocks[i] - leading[i]));
        }
    }
    const double order[4] = {0, -1, -1, -2};
    for (int i = 0; i < 4; ++i) {
        BOOST_TEST(std::abs(slope(h, size[i]) - order[i]) < 0.05);
        BOOST_TEST(slope(h, rest[i]) > order[i] + 0.9);  // printed: one power of h more
    }
}

BOOST_AUTO_TEST_CASE(newton_contracts_in_the_norm_scaled_by_h_only) {
    const setup s = restarted(disc_dae(), 0.4);
    std::vector<double> h, plain, scaled, kantorovich;
    for (double step = 1e-3; step > 5e-5; step /= 2) {
        const norms n = iteration_derivative(s, step);
        h.push_back(step);
        plain.push_back(n.plain);
        scaled.push_back(n.scaled);
        kantorovich.push_back(n.kantorovich);
    }
    // "Unbounded, so Kantorovich fails": |K^-1| |K(Y) - K(y_n)| is O(1) and far above 1/2, however small h
    BOOST_TEST(std::abs(slope(h, kantorovich)) < 0.2);
    BOOST_TEST(*std::min_element(kantorovich.begin(), kantorovich.end()) > 0.5);
    BOOST_TEST(std::abs(slope(h, scaled) - 1) < 0.1);  // O(h)
    BOOST_TEST(std::abs(slope(h, plain)) < 0.1);       // O(1): however small h, no contraction
    BOOST_TEST(scaled.back() < 0.5);
    BOOST_TEST(plain.back() > 1);
}

BOOST_AUTO_TEST_CASE(corollary_2_stiffly_accurate_collocation_has_the_order_of_its_quadrature) {
    // With 200 steps of three stages the error would be 1e-13, no more than rounding leaves of the reference.
    const orders three = global(radau_iia_3, 25), two = global(radau_iia_2);
    BOOST_TEST(std::abs(three.y - 5) < 0.1);
    BOOST_TEST(std::abs(three.lambda - 3) < 0.1);
    BOOST_TEST(std::abs(two.y - 3) < 0.1);
    BOOST_TEST(std::abs(two.lambda - 2) < 0.1);
    // Stiff accuracy alone is not enough: Lobatto IIIC-3 (order 4, C(2), no collocation method) keeps its
    // order in y, but lambda has order 2 with 3 stages.
    const orders iiic = global({.method = family::lobatto_iiic, .stages = 3}, 100);
    BOOST_TEST(near(iiic.lambda, 2));
    // Neither is order p: Gauss-3 of order 6 is collocation without c_s = 1.
    BOOST_TEST(near(global({.method = family::gauss, .stages = 3}, 50).y, 4));
}

BOOST_AUTO_TEST_CASE(theorem_2_local_orders_with_and_without_the_projector) {
    // C(q): y O(h^{q+1}), P y O(h^{q+2}), lambda O(h^q). Radau IA-3 has C(2); what the quadrature gives to
    // P y beyond the theorem is no equality (5.9 is seen).
    const orders ia = local(radau_ia_3), two = local(damping);
    BOOST_TEST(near(ia.y, 3));
    BOOST_TEST(ia.projected > 3.8);
    BOOST_TEST(near(ia.lambda, 2));
    BOOST_TEST(near(two.y, 3));
    BOOST_TEST(near(two.projected, 4));
    BOOST_TEST(near(two.lambda, 2));
    // p > q is needed: the implicit Euler method has p = q = 1, and P y = O(h^2) as y itself, not O(h^3).
    const orders euler = local({.stages = 1});
    BOOST_TEST(near(euler.y, 2));
    BOOST_TEST(near(euler.projected, 2));
    BOOST_TEST(near(euler.lambda, 1));
}

BOOST_AUTO_TEST_CASE(theorem_3_local_errors_of_y_accumulate_to_their_projected_order) {
    // r = 3: delta y = O(h^3) and P delta y = O(h^4) give y = O(h^3), not O(h^2) as one would count; with r =
    // 2 the last sentence gives g(y_n) = O(h^3).
    for (const request& method : {damping, radau_ia_3}) {
        const orders seen = global(method);
        BOOST_TEST(near(seen.y, 3));
        BOOST_TEST(seen.constraint > 2.8);
    }
    // |R(inf)| < 1 is needed. Gauss-2 (R = 1) has the same local errors and loses an order, the other nodes
    // (R = 5/3) have them too and the run leaves the solution altogether.
    BOOST_TEST(near(local(gauss_2).y, 3));
    BOOST_TEST(local(gauss_2).projected > 3.8);
    BOOST_TEST(near(global(gauss_2).y, 2));
    BOOST_TEST(near(local(growing).y, 3));
    BOOST_TEST(local(growing).projected > 3.8);
    BOOST_CHECK_THROW(global(growing), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(theorem_4_lambda_converges_with_the_order_of_its_local_error) {
    for (const request& method : {damping, radau_ia_3}) {
        BOOST_TEST(near(local(method).lambda, 2));
        BOOST_TEST(near(global(method).lambda, 2));
    }
    BOOST_TEST(near(global(radau_iia_3).lambda, 3));
    // Without |R(inf)| < 1 the local errors of order 2 do not even fade: no convergence.
    BOOST_TEST(near(local(gauss_2).lambda, 2));
    BOOST_TEST(near(global(gauss_2).lambda, 0));
}

BOOST_AUTO_TEST_CASE(theorem_5_stiffly_accurate_collocation_has_the_local_order_of_its_quadrature) {
    BOOST_TEST(near(local(radau_iia_2).y, 4));
    BOOST_TEST(near(local(radau_iia_3).y, 6));
    // Quadratures of order 3 and 4, but c_s < 1.
    BOOST_TEST(near(local(damping).y, 3));
    BOOST_TEST(near(local(gauss_2).y, 3));
}

BOOST_AUTO_TEST_CASE(corollary_1_collocation_has_order_s_at_least) {
    for (const request& method : {radau_iia_2, damping}) {
        const orders seen = global(method);
        BOOST_TEST(seen.y > 1.8);
        BOOST_TEST(near(seen.lambda, 2));
    }
    // g(y_n) = O(h^{s+1}): to the Newton tolerance zero if stiffly accurate.
    BOOST_TEST(global(damping).constraint > 2.8);
    const trajectory run = solve(disc_dae(), {.stages = 2, .tolerance = 1e-13, .steps = 200});
    for (const auto& p : run.path) BOOST_TEST(disc_constraint(p.y).norm() < 1e-12);
    // The thesis does not repeat |R(inf)| < 1 of Theorem 3 here; Gauss-2, collocation of order 4 > 2, shows
    // that it has to be asked.
    BOOST_TEST(global(gauss_2).lambda < 0.2);
    BOOST_TEST(global(gauss_2).constraint < 2.2);
}

namespace {

// Slopes in h of Y_ni - y_n and Lambda_ni - lambda_n, i = 1, 2, 3, from starts that `disturb` moves.
template <class Disturb>
std::array<by_stage, 3> stage_orders(const setup& exact, Disturb disturb) {
    std::vector<double> h, y[3], lambda[3];
    for (double step = 1e-3; step > 1e-4; step /= 2) {
        setup s = exact;
        disturb(s.y0, step);
        const auto all = stages(s, step);
        h.push_back(step);
        for (int i = 0; i < 3; ++i) {
            y[i].push_back((all[i] - s.y0).head(10).norm());
            lambda[i].push_back((all[i] - s.y0).tail(2).norm());
        }
    }
    std::array<by_stage, 3> orders;
    for (int i = 0; i < 3; ++i) orders[i] = {slope(h, y[i]), slope(h, lambda[i])};
    return orders;
}

}  // namespace

BOOST_AUTO_TEST_CASE(theorem_1_every_stage_is_o_of_h_away) {
    const setup exact = restarted(disc_dae(), 0.25);
    // (2.9): g(y_n) = O(h^2) by the velocities, g_y f = O(h) by lambda.
    for (const auto& i : stage_orders(exact, [](vector&y, double h) {
             y[6] += 3 * h * h;
             y[10] += 2 * h;
             y[11] -= h;
         })) {
        BOOST_TEST(std::abs(i.y - 1) < 0.1);
        BOOST_TEST(std::abs(i.lambda - 1) < 0.1);
    }
    // g_y f = O(1), lambda_n off by a constant: Y stays O(h), Lambda does not come near lambda_n.
    for (const auto& i : stage_orders(exact, [](vector&y, double) { y[10] += 1; })) {
        BOOST_TEST(std::abs(i.y - 1) < 0.1);
        BOOST_TEST(std::abs(i.lambda) < 0.05);
    }
    // g(y_n) = O(h): lambda jumps by O(1). Hypothesis (2.9) is needed.
    for (const auto& i : stage_orders(exact, [](vector&y, double h) { y[6] += 3 * h; }))
        BOOST_TEST(std::abs(i.lambda) < 0.1);
}

BOOST_AUTO_TEST_CASE(theorem_1_the_stages_are_unique) {
    // lambda_n is not in (2.8), it is where Newton's iteration begins. From all around, as far off as h and as
    // far as 1, the same stages are reached.
    const setup exact = restarted(disc_dae(), 0.25);
    const double step = 1e-3;
    const auto expected = stages(exact, step);
    for (const double off : {step, 1.0})
        for (int corner = 0; corner < 4; ++corner) {
            setup s = exact;
            s.y0[10] += corner % 2 == 0 ? off : -off;
            s.y0[11] += corner < 2 ? off : -off;
            const auto seen = stages(s, step);
            for (int i = 0; i < 3; ++i) {
                BOOST_TEST((seen[i] - expected[i]).head(10).norm() < 1e-11);
                BOOST_TEST((seen[i] - expected[i]).tail(2).norm() < 1e-8);  // Newton's tolerance over h
            }
        }
}

BOOST_AUTO_TEST_CASE(section_2_4_steps_without_the_scaled_norm) {
    // All index flags 1: the norm in which the library's iteration and estimate are judged has no h.
    const auto steps = [](double tolerance, int flag) {
        setup s = disc_dae();
        s.problem.flags[10] = s.problem.flags[11] = flag;
        return static_cast<double>(solve(s, {.tolerance = tolerance}).report.steps);
    };
    // 92 -> 702 steps when this was first measured; 102 -> 702 now.
    const double scaled = steps(1e-6, 2), plain = steps(1e-6, 1);
    BOOST_TEST((scaled > 85 && scaled < 115));
    BOOST_TEST((plain > 630 && plain < 780));
    BOOST_CHECK_THROW(steps(1e-10, 1), std::runtime_error);  // 864 steps with the flags
    BOOST_TEST(steps(1e-10, 2) < 950);
}
