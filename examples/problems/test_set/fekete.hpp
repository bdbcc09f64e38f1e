// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

namespace problems::test_set {

/// Twenty points on the unit sphere that repel each other until they rest, with the largest product of their distances
/// (problem "fekete" of Mazzia-Magherini 2008; Bendtsen's formulation with the velocities stabilised). M y' = f, n = 160:
/// places p, velocities q, and for each point two multipliers, lambda of p^2 = 1 and mu of p q = 0, all of index 2.
///
///     p_i' = q_i + 2 mu_i p_i,   q_i' = -q_i / 2 + 2 lambda_i p_i + sum_j (p_i - p_j) / |p_i - p_j|^2
struct fekete {
    static constexpr const char* name = "fekete";
    static constexpr double t0 = 0, t1 = 1000;
    static constexpr int points = 20;

    void operator()(double, const auto& y, auto& f) const {
        using S = typename std::decay_t<decltype(y)>::Scalar;
        constexpr int N = points;
        const auto p = [](int i) { return 3 * i; };
        const auto q = [](int i) { return 3 * N + 3 * i; };
        for (int i = 0; i < N; ++i) {
            const S &lambda = y[6 * N + i], &mu = y[7 * N + i];
            S size(-1.0), radial(0.0);
            for (int k = 0; k < 3; ++k) {
                const S &place = y[p(i) + k], &velocity = y[q(i) + k];
                f[p(i) + k] = velocity + 2 * mu * place;
                f[q(i) + k] = 2 * lambda * place - 0.5 * velocity;
                size += place * place;
                radial += 2 * place * velocity;
            }
            f[6 * N + i] = size;
            f[7 * N + i] = radial;
        }
        for (int i = 0; i < N; ++i)
            for (int j = 0; j < i; ++j) {
                S squared(0.0);
                for (int k = 0; k < 3; ++k) {
                    const S apart = y[p(i) + k] - y[p(j) + k];
                    squared += apart * apart;
                }
                const S strength = 1.0 / squared;
                for (int k = 0; k < 3; ++k) {
                    const S force = (y[p(i) + k] - y[p(j) + k]) * strength;
                    f[q(i) + k] += force;
                    f[q(j) + k] -= force;
                }
            }
    }
    Eigen::MatrixXd mass() const {
        Eigen::VectorXd m = Eigen::VectorXd::Zero(8 * points);
        m.head(6 * points).setOnes();
        return m.asDiagonal().toDenseMatrix();
    }
    std::vector<int> index() const {
        std::vector<int> flags(6 * points, 1);
        flags.resize(8 * points, 2);
        return flags;
    }
    /// At rest on four circles of latitude; lambda keeps the points on the sphere.
    Eigen::VectorXd initial() const {
        constexpr double pi = std::numbers::pi;
        Eigen::VectorXd y = Eigen::VectorXd::Zero(8 * points), f(8 * points);
        int i = 0;
        const auto circle = [&](int count, int first, double turned, double latitude) {
            for (int k = first; k < first + count; ++k, ++i) {
                const double longitude = 2 * pi * k / count + turned;
                y.segment(3 * i, 3) << std::cos(longitude) * std::cos(latitude),
                    std::sin(longitude) * std::cos(latitude), std::sin(latitude);
            }
        };
        circle(3, 1, pi / 13, 3 * pi / 8);
        circle(7, 1, pi / 29, pi / 8);
        circle(6, 1, pi / 7, -2 * pi / 15);
        circle(4, 0, pi / 17, -3 * pi / 10);
        (*this)(0, y, f);
        for (i = 0; i < points; ++i)
            y[6 * points + i] = -y.segment(3 * i, 3).dot(f.segment(3 * (points + i), 3)) / 2;
        return y;
    }
    /// The published places at t1 (RADAU5, 1e-12). All rests there, and lambda is -(points - 1) / 4.
    Eigen::VectorXd reference() const {
        Eigen::VectorXd y = Eigen::VectorXd::Zero(8 * points);
        y.head(3 * points) << -0.4070263380333202, 0.3463758772791802, 0.8451942450030429,
            0.7752934752521549e-1, -0.2628662719972299, 0.9617122871829146, 0.7100577833343567,
            0.1212948055586120, 0.6936177005172217, 0.2348267744557627, 0.7449277976923311,
            0.6244509285956391, -0.4341114738782885, 0.8785430442262876, 0.1992720444237660,
            -0.9515059600312596, 0.2203508762787005, 0.2146669498274008, -0.6385191643609878,
            -0.4310833259390688, 0.6375425027722121, -0.1464175087914336, -0.9380871635228862,
            0.3139337298744690, 0.5666974065069942, -0.6739221885076542, 0.4740073135462156,
            0.9843259538440293, -0.1696995357819996, -0.4800504290609090e-1, 0.1464175087914331,
            0.9380871635228875, -0.3139337298744656, -0.7092757549979014, 0.5264062637139616,
            -0.4688542938854929, -0.8665731819284478, -0.4813878059756024, -0.1315929352982178,
            -0.2347897778700538, -0.8594340408013130, -0.4541441287957579, 0.5530976940074118,
            -0.7674370265615124, -0.3242273140037833, 0.7711050969896927, 0.6357041816577034,
            0.3573685519777001e-1, 0.7103951209379591, 0.2403570431280519, -0.6614886725910596,
            -0.3038208738735660e-1, 0.4501923293640461, -0.8924145871442046, -0.5772996158107093,
            -0.1766763414971813, -0.7971892020969544, 0.2414481766969039, -0.3416456818373135,
            -0.9082846503446250;
        y.segment(6 * points, points).setConstant(-(points - 1) / 4.0);
        return y;
    }
};

}  // namespace problems::test_set
