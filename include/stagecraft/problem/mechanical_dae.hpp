// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <stdexcept>
#include <unsupported/Eigen/AutoDiff>
#include <utility>

#include <stagecraft/problem/mechanical.hpp>

namespace stagecraft {

/// Derivatives of the residual rho = F(q, v, t) - M(q) a - G(q)^T lambda with a and lambda held fixed, and of
/// G(q) v, with respect to q and v. By the implicit function theorem M(q) da = d rho: automatic
/// differentiation never runs through the factorisation of M.
template <class S, class Model>
struct mechanical_derivatives {
    static constexpr int n = Model::coordinates, m = Model::constraints;
    Eigen::Matrix<S, n, n> residual_q, residual_v;
    Eigen::Matrix<S, m, n> constraint_q;  ///< d(G(q) v)/dq, whose product with v is (dG/dt) v

    mechanical_derivatives(const Model& model, const coordinate_vector<S, Model>& q,
                           const coordinate_vector<S, Model>& v, const coordinate_vector<S, Model>& a,
                           const multiplier_vector<S, Model>& lambda, const S& t) {
        using dual = Eigen::AutoDiffScalar<Eigen::Matrix<S, n, 1>>;
        using std::swap;
        coordinate_vector<dual, Model> moving, fixed;
        const dual time = constant<dual>(t);
        for (int i = 0; i < n; ++i) {
            moving[i] = constant<dual>(q[i]);
            moving[i].derivatives()[i] = S(1);
            fixed[i] = constant<dual>(v[i]);
        }
        const coordinate_vector<dual, Model> f = force<dual>(model, moving, fixed, time);
        const Eigen::Matrix<dual, n, n> M = model.M(moving);
        const Eigen::Matrix<dual, m, n> G = model.G(moving);
        for (int i = 0; i < n; ++i) {
            coordinate_vector<S, Model> row = f[i].derivatives();
            for (int j = 0; j < n; ++j) row -= a[j] * M(i, j).derivatives();
            for (int k = 0; k < m; ++k) row -= lambda[k] * G(k, i).derivatives();
            residual_q.row(i) = row.transpose();
        }
        for (int k = 0; k < m; ++k) {
            coordinate_vector<S, Model> row = v[0] * G(k, 0).derivatives();
            for (int j = 1; j < n; ++j) row += v[j] * G(k, j).derivatives();
            constraint_q.row(k) = row.transpose();
        }
        for (int i = 0; i < n; ++i) {
            fixed[i] = constant<dual>(q[i]);
            moving[i].value() = v[i];
        }
        const coordinate_vector<dual, Model> g = force<dual>(model, fixed, moving, time);
        for (int i = 0; i < n; ++i) residual_v.row(i) = g[i].derivatives().transpose();
    }

  private:
    template <class Dual>
    static Dual constant(const S& x) {
        Dual result;
        result.value() = x;
        for (int i = 0; i < n; ++i) result.derivatives()[i] = S(0);
        return result;
    }
};

/// The index-2 system of a mechanical model in the state (q, v, lambda):
///
///     q' = v,   v' = M(q)^-1 (F - G(q)^T lambda),   0 = G(q) v
///
/// (thesis (1.10), a Hessenberg form: q and v have index 1, lambda index 2, HLR89 section 1). M is factored
/// once per evaluation, or never where the model brings `solve_mass`. Made by `index_2`.
template <mechanical_model Model, class Scalar = double>
class index_2_dae {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n + m;

    explicit index_2_dae(Model model) : model_(std::move(model)) {}

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = y.template head<n>(), v = y.template segment<n>(n);
        const multiplier_vector<S, Model> lambda = y.template tail<m>();
        const Eigen::Matrix<S, m, n> G = model_.G(q);
        f.template head<n>() = v;
        f.template segment<n>(n) =
            mass_inverse<S, Model>(model_, q)(force<S>(model_, q, v, t) - G.transpose() * lambda);
        f.template tail<m>() = G * v;
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const coordinate_vector<S, Model> q = y.template head<n>(), v = y.template segment<n>(n);
        const multiplier_vector<S, Model> lambda = y.template tail<m>();
        const Eigen::Matrix<S, m, n> G = model_.G(q);
        const mass_inverse<S, Model> solve(model_, q);
        const coordinate_vector<S, Model> a = solve(force<S>(model_, q, v, t) - G.transpose() * lambda);
        const mechanical_derivatives<S, Model> d(model_, q, v, a, lambda, t);
        J = Eigen::Matrix<S, size, size>::Constant(S(0));
        for (int j = 0; j < n; ++j) {
            J(j, n + j) = S(1);
            J.template block<n, 1>(n, j) = solve(d.residual_q.col(j));
            J.template block<n, 1>(n, n + j) = solve(d.residual_v.col(j));
        }
        for (int j = 0; j < m; ++j) J.template block<n, 1>(n, 2 * n + j) = -solve(G.row(j).transpose());
        J.template block<m, n>(2 * n, 0) = d.constraint_q;
        J.template block<m, n>(2 * n, n) = G;
    }

    /// diag(1, ..., 1, 0, ..., 0): singular in the rows of the constraint.
    Eigen::Matrix<Scalar, size, size> mass() const {
        Eigen::Matrix<Scalar, size, size> M = Eigen::Matrix<Scalar, size, size>::Constant(Scalar(0));
        for (int i = 0; i < 2 * n; ++i) M(i, i) = Scalar(1);
        return M;
    }

    std::array<int, size> index() const {
        std::array<int, size> flags{};
        for (int i = 0; i < size; ++i) flags[i] = i < 2 * n ? 1 : 2;
        return flags;
    }

    /// (q, v, lambda) with the multiplier consistent with q and v. Throws std::invalid_argument if G(q) v is
    /// not zero to rounding (a bound of 64 eps max|G| max|v| is allowed), std::domain_error at a singular
    /// position.
    Eigen::Matrix<Scalar, size, 1> initial_state(const coordinate_vector<Scalar, Model>& q,
                                                 const coordinate_vector<Scalar, Model>& v,
                                                 const Scalar& t = Scalar(0)) const {
        const Scalar scale = model_.G(q).cwiseAbs().maxCoeff() * v.cwiseAbs().maxCoeff();
        if (!(constraint_violation(model_, q, v) <= Scalar(64) * Eigen::NumTraits<Scalar>::epsilon() * scale))
            throw std::invalid_argument("mechanical: the initial v must satisfy G(q) v = 0");
        Eigen::Matrix<Scalar, size, 1> y;
        y << q, v, consistent_multiplier(model_, q, v, t);
        return y;
    }

    const Model& model() const { return model_; }

  private:
    Model model_;
};

/// The index-2 system q' = v, v' = M^-1 (F - G^T lambda), 0 = G v of a model, ready for `integrate`.
template <class Scalar = double, mechanical_model Model>
index_2_dae<Model, Scalar> index_2(Model model) {
    return index_2_dae<Model, Scalar>(std::move(model));
}

/// The ordinary differential equation left when the multiplier is eliminated by the once differentiated
/// constraint (thesis (3.17), corrected): state (q, v), lambda = (G M^-1 G^T)^-1 (G M^-1 F + (dG/dt) v + r G
/// v). With r = 0, G v is an invariant that no method keeps exactly: its drift is the price of index
/// reduction. With r = c/d > 0 the violation obeys u' = -r u (thesis (3.45)). Made by `index_reduced`.
template <mechanical_model Model, class Scalar = double>
class index_reduced_ode {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n;

    index_reduced_ode(Model model, Scalar r) : model_(std::move(model)), r_(std::move(r)) {}

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = y.template head<n>(), v = y.template tail<n>();
        const mass_inverse<S, Model> solve(model_, q);
        const Eigen::Matrix<S, m, n> G = model_.G(q);
        Eigen::Matrix<S, n, m> B;  // M^-1 G^T
        for (int j = 0; j < m; ++j) B.col(j) = solve(G.row(j).transpose());
        const coordinate_vector<S, Model> free = solve(force<S>(model_, q, v, t));
        const multiplier_vector<S, Model> curvature = constraint_curvature(model_, q, v), violation = G * v;
        multiplier_vector<S, Model> rhs = G * free;
        for (int i = 0; i < m; ++i) rhs[i] += curvature[i] + S(r_) * violation[i];
        const multiplier_matrix<S, Model> inertia = G * B;
        const multiplier_vector<S, Model> lambda = small_ldlt<S, m>(inertia).solve(rhs);
        f.template head<n>() = v;
        f.template tail<n>() = free - B * lambda;
    }

    const Model& model() const { return model_; }

  private:
    Model model_;
    Scalar r_;
};

/// The index-reduced differential equation of a model in (q, v); see `index_reduced_ode`. Throws
/// std::invalid_argument if r is negative.
template <class Scalar = double, mechanical_model Model>
index_reduced_ode<Model, Scalar> index_reduced(Model model, Scalar r = Scalar(0)) {
    if (!(r >= Scalar(0))) throw std::invalid_argument("index_reduced: r must not be negative");
    return index_reduced_ode<Model, Scalar>(std::move(model), std::move(r));
}

}  // namespace stagecraft
