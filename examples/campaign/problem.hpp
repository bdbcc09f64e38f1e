// SPDX-License-Identifier: BSL-1.0
// A random problem with a known solution, and what became of a run.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace campaign {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// M y' = f(t, y) from y(t0) = exact(t0) to t1, M = diag(1, ..., 1, 0, ..., 0) with `differential` ones.
struct problem {
    std::string description;  ///< what was drawn, in a few words
    double t0 = 0, t1 = 1;
    VectorXd y0;
    std::function<void(double, const VectorXd&, VectorXd&)> f;
    std::function<void(double, const VectorXd&, MatrixXd&)> jacobian;
    std::function<VectorXd(double)> exact;
    /// Where errors grow along the run whatever a step does: the consistent state that y stands for, and is
    /// compared with instead.
    std::function<VectorXd(const VectorXd&)> consistent;
    bool exact_everywhere = true;  ///< false: exact(t1) only
    std::vector<int> index;        ///< of every component, in increasing order; empty where M = I
    int differential = 0;          ///< where M is not I

    // What is said of it, where anything is: times where f jumps, doses, where f is defined.
    std::vector<double> known, doses;
    std::function<void(double, VectorXd&)> dose;
    std::function<bool(double, const VectorXd&)> domain;

    bool ordinary() const { return index.empty(); }
    bool said() const { return !known.empty() || !doses.empty() || domain; }
};

/// What became of a run.
struct outcome {
    bool success = false;
    std::string status;
    double t = 0;      ///< where it ended
    double worst = 0;  ///< the largest error of an accepted step, in tolerances (errors_of)
    long steps = 0;
    double estimate =
        0;  ///< boundary values: the estimated error over the true one, where that is no rounding
};

/// The largest error at t, in units of the tolerance of its component, tol (1 + |y_i|); that of a component of
/// index k times |h|^(k-1), as its weight in the integrators is (HLR89 section 7). NaN counts as infinite.
inline double error_of(const problem& p, double t, const VectorXd& y, double h, double tol) {
    const VectorXd exact = p.consistent ? p.consistent(y) : p.exact(t);
    double worst = 0;
    for (Eigen::Index i = 0; i < y.size(); ++i) {
        const double power = p.ordinary() ? 0 : p.index[static_cast<std::size_t>(i)] - 1;
        const double e = std::abs(y[i] - exact[i]) / (tol * (1 + std::abs(exact[i]))) *
                         std::pow(std::min(std::abs(h), 1.0), std::max(power, 0.0));
        worst = std::max(worst, std::isnan(e) ? INFINITY : e);
    }
    return worst;
}

/// Random numbers of one problem: the same for the same seed and number, however many others are run.
class dice {
  public:
    dice(unsigned seed, int number) : engine_(seed * 1000003u + static_cast<unsigned>(number)) {}

    double between(double a, double b) { return std::uniform_real_distribution<>(a, b)(engine_); }
    double log_between(double a, double b) { return std::exp(between(std::log(a), std::log(b))); }
    int integer(int a, int b) { return std::uniform_int_distribution<>(a, b)(engine_); }
    bool coin() { return integer(0, 1) == 1; }
    double sign() { return coin() ? 1 : -1; }
    VectorXd vector(int n, double size = 1) { return matrix(n, 1, size); }
    MatrixXd matrix(int rows, int columns, double size = 1) {
        MatrixXd m(rows, columns);
        for (int j = 0; j < columns; ++j)
            for (int i = 0; i < rows; ++i) m(i, j) = between(-size, size);
        return m;
    }
    /// A random orthogonal matrix: a product of n reflections.
    MatrixXd rotation(int n) {
        MatrixXd q = MatrixXd::Identity(n, n);
        for (int k = 0; k < n; ++k) {
            const VectorXd v = vector(n).normalized();
            q -= 2 * v * (v.transpose() * q).eval();
        }
        return q;
    }

  private:
    std::mt19937_64 engine_;
};

/// s_i(t) = b_i + a_i sin(omega_i t + phi_i) with its derivatives.
class waves {
  public:
    waves(dice& d, int n, double fastest = 5)
        : b_(d.vector(n)), a_(d.vector(n)), omega_(n), phi_(d.vector(n, 3.2)) {
        for (int i = 0; i < n; ++i) omega_[i] = d.log_between(0.3, fastest);
    }
    VectorXd operator()(double t) const {
        return b_ + (a_.array() * (omega_ * t + phi_).array().sin()).matrix();
    }
    VectorXd rate(double t) const {
        return (a_.array() * omega_.array() * (omega_ * t + phi_).array().cos()).matrix();
    }
    VectorXd second(double t) const {
        return -(a_.array() * omega_.array().square() * (omega_ * t + phi_).array().sin()).matrix();
    }

  private:
    VectorXd b_, a_, omega_, phi_;
};

/// w -> L w + c (R w)^2, a linear map with a small curvature.
struct curved_map {
    MatrixXd L, R;
    VectorXd c;
    curved_map(dice& d, MatrixXd linear, double curvature)
        : L(std::move(linear)),
          R(d.matrix(static_cast<int>(L.rows()), static_cast<int>(L.cols()))),
          c(d.vector(static_cast<int>(L.rows()), curvature)) {}

    VectorXd operator()(const VectorXd& w) const {
        return L * w + (c.array() * (R * w).array().square()).matrix();
    }
    MatrixXd derivative(const VectorXd& w) const {
        return L + (2 * c.array() * (R * w).array()).matrix().asDiagonal() * R;
    }
    /// The derivative by w of derivative(w)^T lambda.
    MatrixXd second(const VectorXd& lambda) const {
        return R.transpose() * (2 * c.array() * lambda.array()).matrix().asDiagonal() * R;
    }
};

inline VectorXd joined(const VectorXd& a, const VectorXd& b) {
    VectorXd w(a.size() + b.size());
    w << a, b;
    return w;
}

// The classes.
problem linear(dice d);
problem nonlinear(dice d);
problem signal(dice d);
problem index_1(dice d);
problem index_2(dice d);
problem index_3(dice d);
problem pendulum(dice d);
problem jumps(dice d);
problem switching(dice d);
problem approximate(dice d);
problem schedules(dice d);
problem doses(dice d);
problem domains(dice d);

// The integrators: Radau IIA of s = 3, 5 or 7 stages, 0 for variable order; with at most so many steps.
outcome run_ordinary(int stages, const problem& p, double tol);
outcome run_algebraic(int stages, const problem& p, double tol);
outcome run_said(int stages, const problem& p, double tol);  // s = 3 or variable
/// The state at t1 by s = 7 at that tolerance; throws std::runtime_error if the run fails.
VectorXd end_state(const problem& p, double tol);
bool radau5_available();
outcome run_radau5(const problem& p, double tol);
inline outcome run(int stages, const problem& p, double tol) {
    if (p.said()) return run_said(stages, p, tol);
    return p.ordinary() ? run_ordinary(stages, p, tol) : run_algebraic(stages, p, tol);
}

/// Crossings of random levels by an oscillator, located in a run of s = 3: success says that all were found and
/// no other, `worst` how far off their times are.
outcome run_events(dice d, double tol);

// Boundary values by five Gauss nodes; `worst` is the largest error of y(t), of p and of an unknown end, `steps` counts f.
outcome run_interior(dice d, double tol);
outcome run_integral(dice d, double tol);
outcome run_free_length(dice d, double tol);
outcome run_semi_infinite(dice d, double tol);

}  // namespace campaign
