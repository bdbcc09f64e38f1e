// SPDX-License-Identifier: BSL-1.0
// Problems of which something is known that a user can say: when f jumps, what is added when, where f is defined.
#include <limits>

#include "problem.hpp"

namespace campaign {

namespace {

/// y' = Q Lambda (Q^T y - level_k) from begins[k] on, behind y += dose_k there.
struct pieces {
    MatrixXd Q;
    VectorXd lambda, start;
    std::vector<double> begins;
    std::vector<VectorXd> level, dose;

    std::size_t at(double t) const {
        return static_cast<std::size_t>(std::upper_bound(begins.begin(), begins.end(), t) - begins.begin() -
                                        1);
    }
    /// Before the dose, where there is one at t.
    VectorXd exact(double t) const {
        VectorXd u = start;
        for (std::size_t k = 0; k < begins.size() && (k == 0 || begins[k] < t); ++k) {
            const double end = k + 1 < begins.size() ? std::min(begins[k + 1], t) : t;
            u += dose[k];
            u = level[k] + ((lambda * (end - begins[k])).array().exp() * (u - level[k]).array()).matrix();
        }
        return Q * u;
    }
};

problem in_pieces(dice& d, bool jumps) {
    problem p;
    const int n = d.integer(1, 3), count = d.integer(2, 12);
    pieces all{d.rotation(n), VectorXd(n), d.vector(n), {0}, {}, {}};
    for (int i = 0; i < n; ++i) all.lambda[i] = -d.log_between(1, 1e7);
    for (int k = 1; k < count; ++k) all.begins.push_back(d.between(0, 1));
    std::sort(all.begins.begin(), all.begins.end());
    const VectorXd level = d.vector(n);
    for (int k = 0; k < count; ++k) {
        all.level.push_back(jumps ? d.vector(n) : level);
        all.dose.push_back(jumps || k == 0 ? VectorXd(VectorXd::Zero(n)) : d.vector(n));
    }
    p.t1 = 1.2;
    p.exact = [all](double t) { return all.exact(t); };
    p.y0 = p.exact(0);
    p.f = [all](double t, const VectorXd& y, VectorXd& f) {
        f = all.Q * all.lambda.cwiseProduct(all.Q.transpose() * y - all.level[all.at(t)]);
    };
    p.jacobian = [J = MatrixXd(all.Q * all.lambda.asDiagonal() * all.Q.transpose())](
                     double, const VectorXd&, MatrixXd& out) { out = J; };
    const std::vector<double> times(all.begins.begin() + 1, all.begins.end());
    (jumps ? p.known : p.doses) = times;
    p.dose = [all](double t, VectorXd& y) { y += all.Q * all.dose[all.at(t)]; };
    p.description = "n = " + std::to_string(n) + ", fastest " + std::to_string(all.lambda.minCoeff()) + ", " +
                    std::to_string(count - 1) + " times";
    return p;
}

}  // namespace

/// Levels that jump at known times, eigenvalues to -1e7.
problem schedules(dice d) { return in_pieces(d, true); }

/// Doses at random times, eigenvalues to -1e7.
problem doses(dice d) { return in_pieces(d, false); }

/// y_i' = -k_i y_i^{b_i}, b_i from 1 to 3, k_i to 1e6, which is not defined for negative y.
problem domains(dice d) {
    problem p;
    const int n = d.integer(1, 3);
    VectorXd k(n), b(n), y0(n);
    for (int i = 0; i < n; ++i) {
        k[i] = d.log_between(1e-2, 1e6);
        b[i] = d.coin() ? 1 : d.between(1.1, 3);
        y0[i] = d.log_between(1e-3, 10);
    }
    p.t1 = d.log_between(0.1, 100);
    p.domain = [](double, const VectorXd& y) { return (y.array() >= 0).all(); };
    p.f = [=](double, const VectorXd& y, VectorXd& f) {
        for (int i = 0; i < n; ++i)
            f[i] = y[i] < 0 ? std::numeric_limits<double>::quiet_NaN() : -k[i] * std::pow(y[i], b[i]);
    };
    p.jacobian = [=](double, const VectorXd& y, MatrixXd& J) {
        J.setZero();
        for (int i = 0; i < n; ++i) J(i, i) = -k[i] * b[i] * std::pow(std::max(y[i], 0.0), b[i] - 1);
    };
    p.exact = [=](double t) {
        VectorXd y(n);
        for (int i = 0; i < n; ++i)
            y[i] = b[i] == 1 ? y0[i] * std::exp(-k[i] * t)
                             : std::pow(std::pow(y0[i], 1 - b[i]) + (b[i] - 1) * k[i] * t, -1 / (b[i] - 1));
        return y;
    };
    p.y0 = y0;
    p.description = "n = " + std::to_string(n) + ", fastest " + std::to_string(k.maxCoeff());
    return p;
}

}  // namespace campaign
