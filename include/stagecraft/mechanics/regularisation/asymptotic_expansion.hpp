// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <stagecraft/mechanics/regularisation/erased_run.hpp>
#include <stagecraft/mechanics/regularisation/singular_perturbation.hpp>

namespace stagecraft {

/// The expansion of Hairer-Wanner II, Theorem VI.3.2 (thesis, Theorem 6) up to N = 1,
///
///     y(t) = y_0(t) + eps (y_1(t) + eta_0(t/eps)) + O(eps^2)
///     z(t) = z_0(t) + zeta_0(t/eps) + eps (z_1(t) + zeta_1(t/eps)) + O(eps^2),
///
/// for initial values y(0), z(0) that may depend on eps: expanded in its powers as well. The outer coefficients solve a
/// differential-algebraic system of index 1, the layer terms an initial value problem in xi = t/eps; both are
/// integrated with the three-stage Radau IIA method when they are first needed. N = 0 takes y_0, z_0, zeta_0
/// only.
template <singular_perturbation Problem>
class asymptotic_expansion {
  public:
    static constexpr int n = Problem::slow, m = Problem::fast;
    using slow_vector = Eigen::Matrix<double, n, 1>;
    using fast_vector = Eigen::Matrix<double, m, 1>;
    using fast_matrix = Eigen::Matrix<double, m, m>;

    struct outer_terms {
        slow_vector y0, y1;
        fast_vector z0, z1;
    };
    struct layer_terms {
        slow_vector eta0;
        fast_vector zeta0, zeta1;
    };

    /// `layer_end` is a xi at which the layer has died out to `tolerance` (exp(-layer_end |mu(g_z)|) is
    /// small). Throws std::runtime_error if 0 = g(y(0), z) has no solution near z(0), or if a run fails, and
    /// std::domain_error where the hypothesis mu(g_z) < 0 fails in the norm sqrt(z^T D z), D symmetric positive
    /// definite, the Euclidean one unless D is given: at the initial values, at the end of the layer, or where
    /// `outer` is asked for. A g_z whose eigenvalues lie to the left of 0 satisfies it with the D of
    /// D g_z + g_z^T D = -I.
    asymptotic_expansion(Problem problem, const slow_vector& y, const fast_vector& z, double layer_end = 40,
                         double tolerance = 1e-11, const fast_matrix& D = fast_matrix::Identity())
        : asymptotic_expansion(std::move(problem), std::array<slow_vector, 2>{y, slow_vector::Zero()},
                               std::array<fast_vector, 2>{z, fast_vector::Zero()}, layer_end, tolerance, D) {}

    /// The same from y(0) = y[0] + eps y[1], z(0) = z[0] + eps z[1].
    asymptotic_expansion(Problem problem, const std::array<slow_vector, 2>& y,
                         const std::array<fast_vector, 2>& z, double layer_end = 40, double tolerance = 1e-11,
                         const fast_matrix& D = fast_matrix::Identity())
        : problem_(std::move(problem)), tolerance_(tolerance), D_(D), y_(y[0]), z_(z[0]) {
        if (D != D.transpose() || !positive(D))
            throw std::invalid_argument("asymptotic_expansion: D must be symmetric positive definite");
        check_hypothesis(y_, z_);
        for (int k = 0;; ++k) {
            const fast_vector step = g_z(y_, z_).lu().solve(problem_.g(y_, z_));
            z_ -= step;
            if (!(step.norm() < 1e300) || k == 50)
                throw std::runtime_error("asymptotic_expansion: no z near z(0) solves 0 = g(y(0), z)");
            if (step.norm() <= 1e-14 * (1 + z_.norm())) break;
        }
        check_hypothesis(y_, z_);
        zeta_ = z[0] - z_;
        slope_y_ = problem_.f(y_, z_);
        slope_z_ = slope_of_z(y_, z_);
        total_.setZero();
        total_ = integral(layer_state(layer_end));
        y1_ = y[1] + total_;  // y_1(0) + eta_0(0) = y[1] and eta_0(0) = -integral
        z1_ = first_z(y_, z_, y1_);
        zeta1_ = z[1] - z1_;
    }

    /// y_0, z_0, y_1, z_1 at time t.
    outer_terms outer(double t) const {
        Eigen::VectorXd start(2 * (n + m));
        start << y_, z_, y1_, z1_;
        detail::erased_problem system;
        system.M = Eigen::MatrixXd::Zero(2 * (n + m), 2 * (n + m));
        for (int i = 0; i < n; ++i) system.M(i, i) = system.M(n + m + i, n + m + i) = 1;
        system.f = [this](double, const Eigen::VectorXd& u, Eigen::VectorXd& out) {
            const slow_vector y0 = u.head<n>(), y1 = u.segment<n>(n + m);
            const fast_vector z0 = u.segment<m>(n), z1 = u.tail<m>();
            out.head<n>() = problem_.f(y0, z0);
            out.segment<m>(n) = problem_.g(y0, z0);
            out.segment<n>(n + m) = f_along(y0, z0, y1, z1);
            out.tail<m>() = g_along(y0, z0, y1, z1) - slope_of_z(y0, z0);
        };
        const Eigen::VectorXd u = detail::run("asymptotic_expansion", system, start, {t}, tolerance_);
        check_hypothesis(u.head<n>(), u.segment<m>(n));
        return {u.head<n>(), u.segment<n>(n + m), u.segment<m>(n), u.tail<m>()};
    }

    /// eta_0, zeta_0, zeta_1 at xi = t/eps.
    layer_terms layer(double xi) const {
        const Eigen::VectorXd u = layer_state(xi);
        return {integral(u) - total_, u.head<m>(), u.tail<m>()};
    }

    /// The truncated expansion (y, z) for N = 0 or 1. Throws std::invalid_argument for any other N or eps <=
    /// 0.
    std::pair<slow_vector, fast_vector> operator()(int N, double eps, double t) const {
        if (N != 0 && N != 1) throw std::invalid_argument("asymptotic_expansion: N must be 0 or 1");
        if (!(eps > 0)) throw std::invalid_argument("asymptotic_expansion: eps must be positive");
        const outer_terms o = outer(t);
        const layer_terms l = layer(t / eps);
        if (N == 0) return {o.y0, o.z0 + l.zeta0};
        return {o.y0 + eps * (o.y1 + l.eta0), o.z0 + l.zeta0 + eps * (o.z1 + l.zeta1)};
    }

  private:
    using dual = dual_number<double, 1>;

    template <int N>
    static Eigen::Matrix<dual, N, 1> moving(const Eigen::Matrix<double, N, 1>& x,
                                            const Eigen::Matrix<double, N, 1>& d) {
        Eigen::Matrix<dual, N, 1> result;
        for (int i = 0; i < N; ++i) {
            result[i].value() = x[i];
            result[i].derivatives()[0] = d[i];
        }
        return result;
    }
    template <int N>
    static Eigen::Matrix<double, N, 1> derivative(const Eigen::Matrix<dual, N, 1>& x) {
        Eigen::Matrix<double, N, 1> result;
        for (int i = 0; i < N; ++i) result[i] = x[i].derivatives()[0];
        return result;
    }
    /// f_y a + f_z b and g_y a + g_z b at (y, z).
    slow_vector f_along(const slow_vector& y, const fast_vector& z, const slow_vector& a,
                        const fast_vector& b) const {
        return derivative<n>(problem_.f(moving<n>(y, a), moving<m>(z, b)));
    }
    fast_vector g_along(const slow_vector& y, const fast_vector& z, const slow_vector& a,
                        const fast_vector& b) const {
        return derivative<m>(problem_.g(moving<n>(y, a), moving<m>(z, b)));
    }
    fast_matrix g_z(const slow_vector& y, const fast_vector& z) const {
        fast_matrix result;
        for (int j = 0; j < m; ++j)
            result.col(j) = g_along(y, z, slow_vector::Zero(), fast_vector(fast_matrix::Identity().col(j)));
        return result;
    }
    static bool positive(const fast_matrix& A) {
        const small_ldlt<double, m> factors(A);
        for (int i = 0; i < m; ++i)
            if (!(factors.pivot(i) > 0)) return false;
        return true;
    }
    /// mu(g_z) < 0 in the norm of D is -(D g_z + g_z^T D) > 0.
    void check_hypothesis(const slow_vector& y, const fast_vector& z) const {
        const fast_matrix A = D_ * g_z(y, z);
        if (positive(-(A + A.transpose()))) return;
        std::ostringstream text;
        text << "asymptotic_expansion: mu(g_z) must be negative in the norm of D (Euclidean if none is "
                "given), and "
                "is not at y = "
             << y.transpose() << ", z = " << z.transpose();
        throw std::domain_error(text.str());
    }
    /// z_0' on 0 = g(y_0, z_0).
    fast_vector slope_of_z(const slow_vector& y, const fast_vector& z) const {
        const fast_vector rhs = g_along(y, z, problem_.f(y, z), fast_vector::Zero());
        return -g_z(y, z).lu().solve(rhs);
    }
    /// z_1 of z_0' = g_y y_1 + g_z z_1.
    fast_vector first_z(const slow_vector& y, const fast_vector& z, const slow_vector& y1) const {
        const fast_vector rhs = slope_of_z(y, z) - g_along(y, z, y1, fast_vector::Zero());
        return g_z(y, z).lu().solve(rhs);
    }

    static slow_vector integral(const Eigen::VectorXd& layer) { return layer.segment<n>(m); }

    /// (zeta_0, integral of f(y, z + zeta_0) - f(y, z) from 0, zeta_1) at xi.
    Eigen::VectorXd layer_state(double xi) const {
        Eigen::VectorXd start(n + 2 * m);
        start << zeta_, slow_vector::Zero(), zeta1_;
        detail::erased_problem system;
        system.M = Eigen::MatrixXd::Identity(n + 2 * m, n + 2 * m);
        system.f = [this](double s, const Eigen::VectorXd& u, Eigen::VectorXd& out) {
            const fast_vector z = z_ + u.head<m>(), zeta1 = u.tail<m>();
            const slow_vector eta = integral(u) - total_, a = y1_ + s * slope_y_;
            const fast_vector b = z1_ + s * slope_z_;
            // g(y_0 + eps (y_1 + eta_0), z_0 + zeta_0 + eps (z_1 + zeta_1)) - g(y_0 + eps y_1, z_0 + eps z_1)
            // at order eps
            out.head<m>() = problem_.g(y_, z) - problem_.g(y_, z_);
            out.segment<n>(m) = problem_.f(y_, z) - problem_.f(y_, z_);
            out.tail<m>() = g_along(y_, z, a + eta, b + zeta1) - g_along(y_, z_, a, b);
        };
        return detail::run("asymptotic_expansion", system, start, {xi}, tolerance_);
    }

    Problem problem_;
    double tolerance_;
    fast_matrix D_;
    slow_vector y_, y1_ = slow_vector::Zero(), slope_y_ = slow_vector::Zero(), total_ = slow_vector::Zero();
    fast_vector z_, zeta_ = fast_vector::Zero(), z1_ = fast_vector::Zero(), zeta1_ = fast_vector::Zero(),
                    slope_z_ = fast_vector::Zero();
};

}  // namespace stagecraft
