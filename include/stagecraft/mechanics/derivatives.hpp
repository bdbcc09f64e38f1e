// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>

#include <stagecraft/mechanics/model.hpp>
#include <stagecraft/refuse/mechanics/checked_model.hpp>

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

/// F - M a in dual numbers, with the acceleration a held fixed.
template <class Dual, class S, class Model>
coordinate_vector<Dual, Model> balance(const Model& model, const coordinate_vector<Dual, Model>& q,
                                       const coordinate_vector<Dual, Model>& v,
                                       const coordinate_vector<S, Model>& a, const Dual& t) {
    constexpr int n = Model::coordinates;
    if constexpr (has_balance<Model>) {
        return model.balance(q, v, constants<Dual>(a), t);
    } else {
        coordinate_vector<Dual, Model> r = force<Dual>(model, q, v, t);
        const Eigen::Matrix<Dual, n, n> M = model.M(q);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) r[i] -= M(i, j) * a[j];
        return r;
    }
}

}  // namespace detail

/// G(q, t) and the derivatives of the velocity constraint G v + b by q and v (that by v is G).
template <class S, class Model>
struct velocity_constraint_jacobian {
    static constexpr int n = Model::coordinates, m = Model::constraints;
    using dual = dual_number<S, n>;
    using matrix = Eigen::Matrix<S, m, n>;
    static_assert(
        detail::fits_on_the_stack(sizeof(dual) * n * (has_balance<Model> ? m : n)),
        "mechanical_model: n is too large for matrices of dual numbers on the stack (25 fit by default); "
        "with M, F and G on Eigen::VectorXd it has any size (stagecraft/mechanics/sized_model.hpp)");
    Eigen::Matrix<dual, m, n> dG;  ///< G with its derivatives by q
    matrix G, Gv_q;

    velocity_constraint_jacobian(const Model& model, const coordinate_vector<S, Model>& q,
                                 const coordinate_vector<S, Model>& v, const S& t) {
        const Eigen::Matrix<dual, n, 1> moving = detail::variables<dual>(q);
        const dual time = detail::constant<dual>(t);
        dG = constraint_gradient<dual>(model, moving, time);
        for (int k = 0; k < m; ++k)
            for (int j = 0; j < n; ++j) G(k, j) = dG(k, j).value();
        Gv_q = derivative(v);
        if constexpr (has_prescribed_velocity<Model>) {
            const multiplier_vector<dual, Model> b = prescribed_velocity<dual>(model, moving, time);
            for (int k = 0; k < m; ++k)
                for (int i = 0; i < n; ++i) Gv_q(k, i) += b[k].derivatives()[i];
        }
    }
    /// d(G(q) w)/dq with w held fixed.
    matrix derivative(const coordinate_vector<S, Model>& w) const {
        matrix result;
        detail::fill(result, S(0));
        for (int k = 0; k < m; ++k)
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) result(k, i) += w[j] * dG(k, j).derivatives()[i];
        return result;
    }
    /// d(G(q)^T w)/dq with w held fixed.
    Eigen::Matrix<S, n, n> force_derivative(const multiplier_vector<S, Model>& w) const {
        Eigen::Matrix<S, n, n> result;
        detail::fill(result, S(0));
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < m; ++k)
                for (int j = 0; j < n; ++j) result(i, j) += w[k] * dG(k, i).derivatives()[j];
        return result;
    }
};

/// The acceleration a = M(q)^-1 (F - G^T lambda) with its derivatives, and those of the constraint. By the
/// implicit function theorem M da = d(F - M a - G^T lambda) with a and lambda held fixed on the right:
/// automatic differentiation never runs through the factorisation of M.
template <class S, class Model>
struct acceleration_jacobian : velocity_constraint_jacobian<S, Model> {
    using constraint = velocity_constraint_jacobian<S, Model>;
    using constraint::n, constraint::m, constraint::G;
    using typename constraint::dual;
    coordinate_vector<S, Model> a;
    Eigen::Matrix<S, n, n> a_q, a_v;
    Eigen::Matrix<S, n, m> a_lambda;
    Eigen::Matrix<S, m, n> Ga_q;  ///< d(G(q) a)/dq with a held fixed

    acceleration_jacobian(const Model& model, const coordinate_vector<S, Model>& q,
                          const coordinate_vector<S, Model>& v, const multiplier_vector<S, Model>& lambda,
                          const S& t)
        : constraint(model, q, v, t) {
        const mass_inverse<S, Model> solve(model, q);
        a = force<S>(model, q, v, t);
        detail::subtract_transposed(G, lambda, a);
        a = solve(a);
        const dual time = detail::constant<dual>(t);
        const dual_vector q_moving = detail::variables<dual>(q), q_fixed = detail::constants<dual>(q);
        const dual_vector v_moving = detail::variables<dual>(v), v_fixed = detail::constants<dual>(v);
        const dual_vector F_q = detail::balance<dual, S>(model, q_moving, v_fixed, a, time);
        const dual_vector F_v = force<dual>(model, q_fixed, v_moving, time);
        a_q = this->force_derivative(lambda);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                a_q(i, j) = F_q[i].derivatives()[j] - a_q(i, j);
                a_v(i, j) = F_v[i].derivatives()[j];
            }
        solve.in_place(a_q);
        solve.in_place(a_v);
        a_lambda = solve.of_transposed(G);
        for (int k = 0; k < m; ++k)
            for (int i = 0; i < n; ++i) a_lambda(i, k) = -a_lambda(i, k);
        Ga_q = this->derivative(a);
    }

  private:
    using dual_vector = Eigen::Matrix<dual, n, 1>;
};

/// The once differentiated constraint Phi = d/dt (G v + b) = (dG/dt) v + db/dt + G a, with its derivatives.
template <class S, class Model>
struct hidden_constraint_jacobian : acceleration_jacobian<S, Model> {
    using acceleration_jacobian<S, Model>::n;
    using acceleration_jacobian<S, Model>::m;
    using typename acceleration_jacobian<S, Model>::dual;
    Eigen::Matrix<S, m, n> phi_q, phi_v;
    multiplier_matrix<S, Model> phi_lambda;  ///< -G M^-1 G^T

    hidden_constraint_jacobian(const Model& model, const coordinate_vector<S, Model>& q,
                               const coordinate_vector<S, Model>& v,
                               const multiplier_vector<S, Model>& lambda, const S& t)
        : acceleration_jacobian<S, Model>(model, q, v, lambda, t) {
        const dual time = detail::constant<dual>(t);
        const multiplier_vector<dual, Model> c_q =
            constraint_curvature<dual>(model, detail::variables<dual>(q), detail::constants<dual>(v), time);
        const multiplier_vector<dual, Model> c_v =
            constraint_curvature<dual>(model, detail::constants<dual>(q), detail::variables<dual>(v), time);
        phi_q = this->Ga_q + this->G * this->a_q;
        phi_v = this->G * this->a_v;
        phi_lambda = this->G * this->a_lambda;
        for (int k = 0; k < m; ++k) {
            phi_q.row(k) += c_q[k].derivatives().transpose();
            phi_v.row(k) += c_v[k].derivatives().transpose();
        }
    }
};

namespace detail {

/// Writes the rows q' = v, v' = M^-1 (F - G^T lambda) that every form of the equations of motion begins with
/// into f, y = (q, v, ...); returns v'.
template <class S, class Model, int Size>
coordinate_vector<S, Model> motion(const Model& model, const S& t, const Eigen::Matrix<S, Size, 1>& y,
                                   const Eigen::Matrix<S, Model::constraints, Model::coordinates>& G,
                                   const multiplier_vector<S, Model>& lambda, Eigen::Matrix<S, Size, 1>& f) {
    constexpr int n = Model::coordinates;
    const coordinate_vector<S, Model> q = part<n>(y, 0), v = part<n>(y, n);
    coordinate_vector<S, Model> r = force<S>(model, q, v, t);
    subtract_transposed(G, lambda, r);
    const coordinate_vector<S, Model> a = mass_inverse<S, Model>(model, q)(r);
    put(v, f, 0);
    put(a, f, n);
    return a;
}

/// Writes their derivatives into a Jacobian that is zero elsewhere; lambda begins at component `at`.
template <class S, class Model, int Size>
void motion_jacobian(const acceleration_jacobian<S, Model>& d, int at, Eigen::Matrix<S, Size, Size>& J) {
    constexpr int n = Model::coordinates;
    fill(J, S(0));
    for (int j = 0; j < n; ++j) J(j, n + j) = S(1);
    put(d.a_q, J, n, 0);
    put(d.a_v, J, n, n);
    put(d.a_lambda, J, n, at);
}

/// diag(1, ..., 1, 0, ..., 0) with `ones` ones.
template <class Scalar, int Size>
Eigen::Matrix<Scalar, Size, Size> leading_identity(int ones) {
    Eigen::Matrix<Scalar, Size, Size> M;
    fill(M, Scalar(0));
    for (int i = 0; i < ones; ++i) M(i, i) = Scalar(1);
    return M;
}

/// Index 1 for the first components, 2 from `second` and 3 from `third` on.
template <int Size>
std::array<int, Size> index_flags(int second, int third = Size) {
    std::array<int, Size> flags{};
    for (int i = 0; i < Size; ++i) flags[i] = i < second ? 1 : i < third ? 2 : 3;
    return flags;
}

}  // namespace detail

}  // namespace stagecraft
