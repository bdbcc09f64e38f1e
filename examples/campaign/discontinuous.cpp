// SPDX-License-Identifier: BSL-1.0
// Right-hand sides that jump in time.
#include "problem.hpp"

namespace campaign {

/// y' = Q Lambda (Q^T y - p(t)), p constant between one to three jumps, eigenvalues to -1e7: the exact solution
/// goes from piece to piece.
problem jumps(dice d) {
    problem p;
    const int n = d.integer(1, 3), pieces = d.integer(2, 4);
    VectorXd lambda(n);
    for (int i = 0; i < n; ++i) lambda[i] = -d.log_between(1, 1e7);
    const MatrixXd Q = d.rotation(n);
    std::vector<double> begins{0};
    std::vector<VectorXd> level{d.vector(n)};
    for (int k = 1; k < pieces; ++k) {
        begins.push_back(d.between(0, 1));
        level.push_back(d.vector(n));
    }
    std::sort(begins.begin(), begins.end());
    const auto piece = [=](double t) {
        return static_cast<std::size_t>(std::upper_bound(begins.begin(), begins.end(), t) - begins.begin() -
                                        1);
    };
    const VectorXd start = d.vector(n);
    p.exact = [=](double t) {
        VectorXd u = start;
        for (std::size_t k = 0; k < begins.size() && (k == 0 || begins[k] < t); ++k) {
            const double end = k + 1 < begins.size() ? std::min(begins[k + 1], t) : t;
            u = level[k] + ((lambda * (end - begins[k])).array().exp() * (u - level[k]).array()).matrix();
        }
        return VectorXd(Q * u);
    };
    p.t1 = 1.2;
    p.y0 = p.exact(0);
    p.f = [=](double t, const VectorXd& y, VectorXd& f) {
        f = Q * lambda.cwiseProduct(Q.transpose() * y - level[piece(t)]);
    };
    const MatrixXd J = Q * lambda.asDiagonal() * Q.transpose();
    p.jacobian = [J](double, const VectorXd&, MatrixXd& out) { out = J; };
    p.description = "n = " + std::to_string(n) + ", fastest " + std::to_string(lambda.minCoeff()) +
                    ", last jump at " + std::to_string(begins.back());
    return p;
}

/// y' = +-a, the sign changing every half period, beside a smooth component: a triangular wave over some to
/// hundreds of periods.
problem switching(dice d) {
    problem p;
    const double a = d.log_between(0.1, 10), half = d.log_between(0.05, 2), shift = d.between(0, 1),
                 rate = d.log_between(0.01, 1);
    p.t1 = half * d.log_between(4, 500);
    const auto phase = [=](double t) { return t / half + shift; };
    p.f = [=](double t, const VectorXd& y, VectorXd& f) {
        f[0] = std::fmod(std::floor(phase(t)), 2) == 0 ? a : -a;
        f[1] = -rate * y[1];
    };
    p.jacobian = [=](double, const VectorXd&, MatrixXd& J) { J << 0, 0, 0, -rate; };
    const auto wave = [=](double t) {
        const double x = std::fmod(phase(t), 2);
        return a * half * (x < 1 ? x : 2 - x);
    };
    p.exact = [=](double t) { return VectorXd(Eigen::Vector2d(wave(t) - wave(0), std::exp(-rate * t))); };
    p.y0 = p.exact(0);
    p.description = "slope " + std::to_string(a) + ", half period " + std::to_string(half) +
                    ", t1 = " + std::to_string(p.t1);
    return p;
}

}  // namespace campaign
