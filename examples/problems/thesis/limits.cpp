// SPDX-License-Identifier: BSL-1.0
#include "limits.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace thesis {

namespace {
constexpr std::size_t first = 100;  // t = 0.1
}

trajectory thousand_steps(const setup& s) {
    return solve(s, {.stages = 5, .tolerance = 1e-13, .steps = 1000});
}

const trajectory& index_2_motion() {
    static const trajectory run = thousand_steps(disc_dae());
    return run;
}

limit_distance past_the_layer(const setup& soft) {
    const trajectory run = thousand_steps(soft);
    limit_distance d;
    for (std::size_t k = first; k < run.path.size(); ++k) {
        const vector &a = run.path[k].y, &b = index_2_motion().path[k].y;
        d.y = std::max(d.y, (a.head(10) - b.head(10)).norm());
        d.lambda = std::max(d.lambda, (soft.multiplier(a) - b.tail(2)).norm());
        d.creep = std::max(d.creep, disc_constraint(a).norm());
    }
    return d;
}

// Per component eta' = -S zeta, zeta' = c eta + d eta' with S = G M^-1 G^T = diag(3, 5/(5 - 4 cos^2 beta)).
Eigen::Vector2d layer_term(double beta, double xi, double c, double d) {
    const double S[] = {3, 5 / (5 - 4 * std::pow(std::cos(beta), 2))};
    Eigen::Vector2d zeta;
    for (int k = 0; k < 2; ++k) {
        const std::complex<double> root = std::sqrt(std::complex<double>(d * d * S[k] * S[k] - 4 * c * S[k]));
        const auto r = (-d * S[k] + root) / 2.0, q = (-d * S[k] - root) / 2.0;
        zeta[k] = std::real((r * std::exp(r * xi) - q * std::exp(q * xi)) / root);
    }
    return zeta;
}

layer_distance within_the_layer(double eps, double offset, double c, double d) {
    static const setup dae = restarted(disc_dae(), 0.25);
    const double root = std::sqrt(eps);
    setup soft = disc_regularised(form::mass_matrix, eps, 0.5, {0, 0}, c, d);
    soft.y0 << dae.y0.head(10), dae.y0.tail(2), dae.y0.tail(2);
    soft.y0.tail(4).array() += offset;
    const request how{.stages = 5, .tolerance = 1e-13, .steps = 400, .end = 4 * root};
    const trajectory a = solve(soft, how), b = solve(dae, how);
    layer_distance worst;
    for (std::size_t k = 0; k < a.path.size(); ++k) {
        const Eigen::Vector2d gap = soft.multiplier(a.path[k].y) - dae.multiplier(b.path[k].y);
        worst.y = std::max(worst.y, (a.path[k].y.head(10) - b.path[k].y.head(10)).norm());
        worst.lambda = std::max(worst.lambda, gap.norm());
        worst.corrected = std::max(worst.corrected,
                                   (gap - offset * layer_term(dae.y0[3], a.path[k].t / root, c, d)).norm());
    }
    return worst;
}

double hidden_residual() {
    const setup dae = disc_dae();
    double worst = 0;
    for (const auto& p : solve(dae, {.stages = 7, .tolerance = 1e-13, .steps = 1000}).path) {
        vector f(12);
        Eigen::MatrixXd J(12, 12);
        dae.problem(p.t, p.y, f);
        dae.problem.jacobian(p.t, p.y, J);
        worst = std::max(worst, (J.block(10, 0, 2, 10) * f.head(10)).norm());
    }
    return worst;
}

remainder after_eps_Y(double eps, double kappa) {
    static const std::vector<correction> predicted = [] {
        std::vector<double> times;
        for (int k = 1; k <= 1000; ++k) times.push_back(k / 1000.0);
        return disc_correction(2, times);
    }();
    const setup soft = disc_regularised(form::mass_matrix, eps, kappa);
    const trajectory run = thousand_steps(soft);
    double y = 0, lambda = 0, largest = 0, force = 0;
    for (std::size_t k = first; k < run.path.size(); ++k) {
        const vector &a = run.path[k].y, &b = index_2_motion().path[k].y;
        const correction& term = predicted[k - 1];
        y = std::max(y, (a.head(10) - b.head(10) - eps * term.Y).norm());
        lambda = std::max(lambda, (soft.multiplier(a) - b.tail(2) - eps * term.Lambda).norm());
        largest = std::max(largest, eps * term.Y.norm());
        force = std::max(force, eps * term.Lambda.norm());
    }
    return {y / largest, lambda / force};
}

defect_growth growth_with_frequency(int first, int rows) {
    const setup calm = disc_dae();
    const request how{.stages = 5, .tolerance = 1e-12, .steps = 1000, .end = 0.1};
    const trajectory undisturbed = solve(calm, how);
    const std::vector<double> w{80, 160, 320};
    std::vector<double> y, lambda;
    for (const double omega : w) {
        setup shaken = calm;
        shaken.problem.f = [&, omega](double t, const vector& x, vector& f) {
            calm.problem(t, x, f);
            f.segment(first, rows).array() += 1e-6 * std::sin(omega * t);
        };
        const trajectory run = solve(shaken, how);
        y.push_back(0);
        lambda.push_back(0);
        for (std::size_t k = 1; k < run.path.size(); ++k) {
            const vector d = run.path[k].y - undisturbed.path[k].y;
            y.back() = std::max(y.back(), d.head(10).norm());
            lambda.back() = std::max(lambda.back(), d.tail(2).norm());
        }
    }
    return {slope(w, y), slope(w, lambda)};
}

}  // namespace thesis
