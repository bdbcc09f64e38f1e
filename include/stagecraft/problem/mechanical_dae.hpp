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

namespace detail {

template <class Dual, class S>
Dual constant(const S& x) {
    Dual result;
    result.value() = x;
    for (int i = 0; i < result.derivatives().size(); ++i) result.derivatives()[i] = S(0);
    return result;
}

template <class Dual, class S, int N>
Eigen::Matrix<Dual, N, 1> constants(const Eigen::Matrix<S, N, 1>& x) {
    Eigen::Matrix<Dual, N, 1> result;
    for (int i = 0; i < N; ++i) result[i] = constant<Dual>(x[i]);
    return result;
}

template <class Dual, class S, int N>
Eigen::Matrix<Dual, N, 1> variables(const Eigen::Matrix<S, N, 1>& x) {
    Eigen::Matrix<Dual, N, 1> result = constants<Dual>(x);
    for (int i = 0; i < N; ++i) result[i].derivatives()[i] = S(1);
    return result;
}

}  // namespace detail

/// The acceleration a = M(q)^-1 (F - G^T lambda) with its derivatives, and those of the constraint. By the
/// implicit function theorem M da = d(F - M a - G^T lambda) with a and lambda held fixed on the right:
/// automatic differentiation never runs through the factorisation of M.
template <class S, class Model>
struct acceleration_jacobian {
    static constexpr int n = Model::coordinates, m = Model::constraints;
    coordinate_vector<S, Model> a;
    Eigen::Matrix<S, m, n> G;
    Eigen::Matrix<S, n, n> a_q, a_v;
    Eigen::Matrix<S, n, m> a_lambda;
    Eigen::Matrix<S, m, n> Gv_q;  ///< d(G(q) v)/dq
    Eigen::Matrix<S, m, n> Ga_q;  ///< d(G(q) a)/dq with a held fixed

    acceleration_jacobian(const Model& model, const coordinate_vector<S, Model>& q,
                          const coordinate_vector<S, Model>& v, const multiplier_vector<S, Model>& lambda,
                          const S& t)
        : G(model.G(q)) {
        const mass_inverse<S, Model> solve(model, q);
        a = solve(force<S>(model, q, v, t) - G.transpose() * lambda);
        const dual time = detail::constant<dual>(t);
        const dual_vector q_moving = detail::variables<dual>(q), q_fixed = detail::constants<dual>(q);
        const dual_vector v_moving = detail::variables<dual>(v), v_fixed = detail::constants<dual>(v);
        const dual_vector F_q = force<dual>(model, q_moving, v_fixed, time);
        const dual_vector F_v = force<dual>(model, q_fixed, v_moving, time);
        const Eigen::Matrix<dual, n, n> M = model.M(q_moving);
        const Eigen::Matrix<dual, m, n> dG = model.G(q_moving);
        for (int i = 0; i < n; ++i) {
            coordinate_vector<S, Model> row = F_q[i].derivatives();
            for (int j = 0; j < n; ++j) row -= a[j] * M(i, j).derivatives();
            for (int k = 0; k < m; ++k) row -= lambda[k] * dG(k, i).derivatives();
            a_q.row(i) = row.transpose();
            a_v.row(i) = F_v[i].derivatives().transpose();
        }
        for (int j = 0; j < n; ++j) {
            a_q.col(j) = solve(a_q.col(j));
            a_v.col(j) = solve(a_v.col(j));
        }
        for (int k = 0; k < m; ++k) {
            a_lambda.col(k) = -solve(G.row(k).transpose());
            Gv_q.row(k) = v[0] * dG(k, 0).derivatives().transpose();
            Ga_q.row(k) = a[0] * dG(k, 0).derivatives().transpose();
            for (int j = 1; j < n; ++j) {
                Gv_q.row(k) += v[j] * dG(k, j).derivatives().transpose();
                Ga_q.row(k) += a[j] * dG(k, j).derivatives().transpose();
            }
        }
    }

  private:
    using dual = Eigen::AutoDiffScalar<Eigen::Matrix<S, n, 1>>;
    using dual_vector = Eigen::Matrix<dual, n, 1>;
};

/// The once differentiated constraint Phi = d/dt (G v) = (dG/dt) v + G a, with its derivatives.
template <class S, class Model>
struct hidden_constraint_jacobian : acceleration_jacobian<S, Model> {
    using acceleration_jacobian<S, Model>::n;
    using acceleration_jacobian<S, Model>::m;
    Eigen::Matrix<S, m, n> phi_q, phi_v;
    multiplier_matrix<S, Model> phi_lambda;  ///< -G M^-1 G^T

    hidden_constraint_jacobian(const Model& model, const coordinate_vector<S, Model>& q,
                               const coordinate_vector<S, Model>& v,
                               const multiplier_vector<S, Model>& lambda, const S& t)
        : acceleration_jacobian<S, Model>(model, q, v, lambda, t) {
        using dual = Eigen::AutoDiffScalar<Eigen::Matrix<S, n, 1>>;
        const multiplier_vector<dual, Model> c_q =
            constraint_curvature<dual>(model, detail::variables<dual>(q), detail::constants<dual>(v));
        const multiplier_vector<dual, Model> c_v =
            constraint_curvature<dual>(model, detail::constants<dual>(q), detail::variables<dual>(v));
        phi_q = this->Ga_q + this->G * this->a_q;
        phi_v = this->G * this->a_v;
        phi_lambda = this->G * this->a_lambda;
        for (int k = 0; k < m; ++k) {
            phi_q.row(k) += c_q[k].derivatives().transpose();
            phi_v.row(k) += c_v[k].derivatives().transpose();
        }
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
    static constexpr int second_order_components = n;

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
        const acceleration_jacobian<S, Model> d(model_, y.template head<n>(), y.template segment<n>(n),
                                                y.template tail<m>(), t);
        J = Eigen::Matrix<S, size, size>::Constant(S(0));
        for (int j = 0; j < n; ++j) J(j, n + j) = S(1);
        J.template block<n, n>(n, 0) = d.a_q;
        J.template block<n, n>(n, n) = d.a_v;
        J.template block<n, m>(n, 2 * n) = d.a_lambda;
        J.template block<m, n>(2 * n, 0) = d.Gv_q;
        J.template block<m, n>(2 * n, n) = d.G;
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
    static constexpr int second_order_components = n;

    index_reduced_ode(Model model, Scalar r) : model_(std::move(model)), r_(std::move(r)) {}

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = y.template head<n>(), v = y.template tail<n>();
        const multiplier_vector<S, Model> lambda = multiplier(q, v, t);
        f.template head<n>() = v;
        f.template tail<n>() =
            mass_inverse<S, Model>(model_, q)(force<S>(model_, q, v, t) - model_.G(q).transpose() * lambda);
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const coordinate_vector<S, Model> q = y.template head<n>(), v = y.template tail<n>();
        const hidden_constraint_jacobian<S, Model> d(model_, q, v, multiplier(q, v, t), t);
        // 0 = Phi(q, v, lambda) + r G v gives d lambda = (G M^-1 G^T)^-1 (Phi_q + r (G v)_q, Phi_v + r G).
        const small_ldlt<S, m> inertia(multiplier_matrix<S, Model>(-d.phi_lambda));
        J = Eigen::Matrix<S, size, size>::Constant(S(0));
        for (int j = 0; j < n; ++j) {
            J(j, n + j) = S(1);
            const multiplier_vector<S, Model> by_q = d.phi_q.col(j) + S(r_) * d.Gv_q.col(j);
            const multiplier_vector<S, Model> by_v = d.phi_v.col(j) + S(r_) * d.G.col(j);
            J.template block<n, 1>(n, j) = d.a_q.col(j) + d.a_lambda * inertia.solve(by_q);
            J.template block<n, 1>(n, n + j) = d.a_v.col(j) + d.a_lambda * inertia.solve(by_v);
        }
    }

    /// The multiplier that the differential equation uses at (q, v).
    template <class S>
    multiplier_vector<S, Model> multiplier(const coordinate_vector<S, Model>& q,
                                           const coordinate_vector<S, Model>& v, const S& t) const {
        const mass_inverse<S, Model> solve(model_, q);
        const Eigen::Matrix<S, m, n> G = model_.G(q);
        const multiplier_vector<S, Model> curvature = constraint_curvature<S>(model_, q, v);
        const multiplier_vector<S, Model> rhs =
            G * solve(force<S>(model_, q, v, t)) + curvature + S(r_) * (G * v);
        return small_ldlt<S, m>(constraint_inertia<S>(model_, q)).solve(rhs);
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
