// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <utility>
#include <vector>

#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/mechanics/regularisation/erased_run.hpp>

namespace stagecraft {

/// What regularisation with kappa < 1 changes at order eps, at one time.
struct regularisation_term {
    double t;
    Eigen::VectorXd y0, Y;            ///< (q, v) of the index-2 system, and its correction
    Eigen::VectorXd lambda0, Lambda;  ///< the multiplier, and its correction
};

namespace detail {

/// The index-2 motion, and the system that its correction solves.
template <class Model>
class linearised_about_motion {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 4 * n + m;
    using position = coordinate_vector<double, Model>;
    using force = multiplier_vector<double, Model>;

    linearised_about_motion(Model model, double c) : motion_(std::move(model), 0.0), c_(c) {}

    /// (q, v, Y_q, Y_v, Lambda)' and the residual of g_y Y = lambda_0'/c.
    void operator()(double t, const Eigen::VectorXd& y, Eigen::VectorXd& f) const {
        const position q = y.head<n>(), v = y.segment<n>(n), Yq = y.segment<n>(2 * n),
                       Yv = y.segment<n>(3 * n);
        const auto d = derivatives(q, v, t);
        const force driven = creep(q, v, d.a, t);
        f << v, d.a, Yv, d.a_q * Yq + d.a_v * Yv + d.a_lambda * y.tail<m>(), d.Gv_q * Yq + d.G * Yv - driven;
    }
    force multiplier(const position& q, const position& v, double t) const {
        return motion_.multiplier(q, v, t);
    }
    Eigen::VectorXd start(const position& q, const position& v) const {
        const auto d = derivatives(q, v, 0);
        const small_ldlt<double, m> inertia(multiplier_matrix<double, Model>(-d.phi_lambda));
        const force driven = creep(q, v, d.a, 0);
        Eigen::VectorXd y(size);
        y << q, v, position::Zero(), -d.a_lambda * inertia.solve(driven), force::Zero();
        return y;
    }

  private:
    hidden_constraint_jacobian<double, Model> derivatives(const position& q, const position& v,
                                                          double t) const {
        return {motion_.model(), q, v, multiplier(q, v, t), t};
    }
    /// lambda_0'/c: eps times it is the velocity of the contact point.
    force creep(const position& q, const position& v, const position& a, double t) const {
        using moment = dual_number<double, 1>;
        Eigen::Matrix<moment, n, 1> moving_q = constants<moment>(q), moving_v = constants<moment>(v);
        moment time = constant<moment>(t);
        time.derivatives()[0] = 1;
        for (int i = 0; i < n; ++i) {
            moving_q[i].derivatives()[0] = v[i];
            moving_v[i].derivatives()[0] = a[i];
        }
        const multiplier_vector<moment, Model> lambda = motion_.multiplier(moving_q, moving_v, time);
        force rate;
        for (int k = 0; k < m; ++k) rate[k] = lambda[k].derivatives()[0] / c_;
        return rate;
    }

    index_reduced_ode<Model> motion_;
    double c_;
};

}  // namespace detail

/// The error of regularisation with kappa < 1 (principal damping and its like) to leading order, from
/// consistent initial values: past the boundary layer
///
///     y(t) = y_0(t) + eps Y(t) + O(eps^(2 - kappa)),   lambda(t) = lambda_0(t) + eps Lambda(t) + ...
///
/// with y = (q, v). The thesis expands in powers of sqrt(eps), (3.50) and (3.51), finds errors of order eps
/// and asks why. The reason: on the index-2 motion h(y_0, lambda_0) = d/dt g(y_0) = 0, so that (3.52),
/// (3.53) are homogeneous and y_1 = lambda_1 = 0. At order eps, eps lambda' = c g + d eps^(1 - kappa) dg/dt
/// leaves g_y Y = lambda_0'/c, neither kappa nor d in it:
///
///     Y' = f_y Y + f_lambda Lambda,   g_y Y = lambda_0'/c,   Y(0) = f_lambda (g_y f_lambda)^-1 lambda_0'(0)/c
///
/// where Y(0) is what the impulse of the layer leaves. For kappa = 1 see asymptotic_expansion: there d takes
/// part. Corollary 3 asks for g(y) = O(sqrt(eps) (y - y_0)); as g(y) is eps lambda_0'/c and y - y_0 is eps Y,
/// fixed c and d satisfy it only where lambda_0 is constant.
///
/// `times` increase from 0 on and need not hold 0. The system of index 2 is integrated with the three-stage
/// Radau IIA method at `tolerance`; Lambda is of no use at t = 0. Throws std::invalid_argument unless c > 0
/// and the times are in order, std::runtime_error if the run fails.
template <fixed_size_model Model>
std::vector<regularisation_term> regularisation_error(const Model& model,
                                                      const coordinate_vector<double, Model>& q,
                                                      const coordinate_vector<double, Model>& v, double c,
                                                      const std::vector<double>& times,
                                                      double tolerance = 1e-10) {
    constexpr int n = Model::coordinates, m = Model::constraints;
    if (!(c > 0)) throw std::invalid_argument("regularisation_error: c must be positive");
    std::vector<regularisation_term> terms;
    if (times.empty()) return terms;
    const detail::linearised_about_motion<Model> system(model, c);
    detail::erased_problem problem{system, Eigen::MatrixXd::Identity(system.size, system.size),
                                   std::vector<int>(system.size, 1)};
    for (int k = 4 * n; k < system.size; ++k) {
        problem.M(k, k) = 0;
        problem.flags[static_cast<std::size_t>(k)] = 2;
    }
    const Eigen::MatrixXd path =
        detail::run("regularisation_error", std::move(problem), system.start(q, v), times, tolerance);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Eigen::VectorXd y = path.col(static_cast<Eigen::Index>(i));
        terms.push_back({times[i], y.head<2 * n>(), y.segment<2 * n>(2 * n),
                         system.multiplier(y.head<n>(), y.segment<n>(n), times[i]), y.tail<m>()});
    }
    return terms;
}

}  // namespace stagecraft
