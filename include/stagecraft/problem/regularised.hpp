// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <stagecraft/problem/mechanical_dae.hpp>

namespace stagecraft {

/// The Kelvin-Voigt contact that replaces the constraint 0 = G(q) q' (thesis (3.3)-(3.5)): the contact point
/// may creep, z' = G(q) q', against a spring and a damper, lambda = (c/eps) z + (d/eps^kappa) z'. kappa = 1
/// is strong damping, kappa = 1/2 principal damping. As eps -> 0 the motion tends to that of the index-2
/// system.
template <class Scalar>
struct contact {
    Scalar epsilon, kappa, c, d;
    Scalar stiffness, damping;  ///< c/eps and d/eps^kappa

    /// Throws std::invalid_argument that names the parameter unless eps, c, d > 0 and 0 < kappa <= 1.
    contact(Scalar eps, Scalar k, Scalar spring, Scalar damper)
        : epsilon(eps), kappa(k), c(spring), d(damper), stiffness(0), damping(0) {
        using std::pow;
        const auto positive = [](const Scalar& x, const char* what) {
            if (!(x > Scalar(0)) || !(x - x == Scalar(0))) throw std::invalid_argument(what);
        };
        positive(epsilon, "regularised: eps must be positive and finite");
        positive(c, "regularised: c must be positive and finite");
        positive(d, "regularised: d must be positive and finite");
        if (!(kappa > Scalar(0) && kappa <= Scalar(1)))
            throw std::invalid_argument("regularised: kappa must lie in (0, 1]");
        stiffness = c / epsilon;
        damping = d / (kappa == Scalar(1) ? epsilon : Scalar(pow(epsilon, kappa)));
    }
};

/// The mass-matrix form of a regularised mechanical problem, state (q, v, zeta, lambda) with zeta = (c/eps)
/// z:
///
///     q' = v,   v' = M^-1 (F - G^T lambda),   (eps/c) zeta' = G v,   0 = (eps^kappa/d) (lambda - zeta) - G v
///
/// with zeta and lambda flagged index 2. No entry grows as eps -> 0, where the index-2 system with lambda =
/// zeta is the limit, and the number of steps does not depend on eps. The default form. Made by
/// `regularised`.
template <mechanical_model Model, class Scalar = double>
class regularised_problem {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n + 2 * m;
    static constexpr int second_order_components = n;

    regularised_problem(Model model, contact<Scalar> k) : model_(std::move(model)), contact_(std::move(k)) {}

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = y.template head<n>(), v = y.template segment<n>(n);
        const multiplier_vector<S, Model> zeta = y.template segment<m>(2 * n), lambda = y.template tail<m>();
        const Eigen::Matrix<S, m, n> G = model_.G(q);
        const multiplier_vector<S, Model> creep = G * v;
        f.template head<n>() = v;
        f.template segment<n>(n) =
            mass_inverse<S, Model>(model_, q)(force<S>(model_, q, v, t) - G.transpose() * lambda);
        f.template segment<m>(2 * n) = creep;
        const S compliance = S(Scalar(1) / contact_.damping);
        for (int i = 0; i < m; ++i) f[2 * n + m + i] = compliance * (lambda[i] - zeta[i]) - creep[i];
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const acceleration_jacobian<S, Model> d(model_, y.template head<n>(), y.template segment<n>(n),
                                                y.template tail<m>(), t);
        const S compliance = S(Scalar(1) / contact_.damping);
        J = Eigen::Matrix<S, size, size>::Constant(S(0));
        for (int j = 0; j < n; ++j) J(j, n + j) = S(1);
        J.template block<n, n>(n, 0) = d.a_q;
        J.template block<n, n>(n, n) = d.a_v;
        J.template block<n, m>(n, 2 * n + m) = d.a_lambda;
        for (int j = 0; j < m; ++j) {
            J(2 * n + m + j, 2 * n + m + j) = compliance;
            J(2 * n + m + j, 2 * n + j) = -compliance;
        }
        J.template block<m, n>(2 * n, 0) = d.Gv_q;
        J.template block<m, n>(2 * n, n) = d.G;
        J.template block<m, n>(2 * n + m, 0) = -d.Gv_q;
        J.template block<m, n>(2 * n + m, n) = -d.G;
    }

    /// diag(1, ..., 1, eps/c, ..., 0, ...).
    Eigen::Matrix<Scalar, size, size> mass() const {
        Eigen::Matrix<Scalar, size, size> M = Eigen::Matrix<Scalar, size, size>::Constant(Scalar(0));
        for (int i = 0; i < 2 * n; ++i) M(i, i) = Scalar(1);
        for (int i = 0; i < m; ++i) M(2 * n + i, 2 * n + i) = Scalar(1) / contact_.stiffness;
        return M;
    }

    std::array<int, size> index() const {
        std::array<int, size> flags{};
        for (int i = 0; i < size; ++i) flags[i] = i < 2 * n ? 1 : 2;
        return flags;
    }

    /// The state with contact force lambda at (q, v): zeta = lambda - (d/eps^kappa) G v.
    Eigen::Matrix<Scalar, size, 1> initial_state(const coordinate_vector<Scalar, Model>& q,
                                                 const coordinate_vector<Scalar, Model>& v,
                                                 const multiplier_vector<Scalar, Model>& lambda) const {
        const multiplier_vector<Scalar, Model> zeta = lambda - contact_.damping * (model_.G(q) * v);
        Eigen::Matrix<Scalar, size, 1> y;
        y << q, v, zeta, lambda;
        return y;
    }

    /// The contact force in a state.
    multiplier_vector<Scalar, Model> multiplier(const Eigen::Matrix<Scalar, size, 1>& y) const {
        return y.template tail<m>();
    }

    const Model& model() const { return model_; }
    const stagecraft::contact<Scalar>& contact() const { return contact_; }

  private:
    Model model_;
    stagecraft::contact<Scalar> contact_;
};

/// The form (y, lambda) of thesis (3.7)-(3.8), state (q, v, lambda): an explicit differential equation,
///
///     lambda' = (c/eps) G v + (d/eps^kappa) ((dG/dt) v + G M^-1 (F - G^T lambda)).
///
/// Made by `regularised_multiplier_form`.
template <mechanical_model Model, class Scalar = double>
class multiplier_form {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n + m;
    static constexpr int second_order_components = n;

    multiplier_form(Model model, contact<Scalar> k) : model_(std::move(model)), contact_(std::move(k)) {}

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = y.template head<n>(), v = y.template segment<n>(n);
        const multiplier_vector<S, Model> lambda = y.template tail<m>();
        const Eigen::Matrix<S, m, n> G = model_.G(q);
        const coordinate_vector<S, Model> a =
            mass_inverse<S, Model>(model_, q)(force<S>(model_, q, v, t) - G.transpose() * lambda);
        f.template head<n>() = v;
        f.template segment<n>(n) = a;
        const multiplier_vector<S, Model> creep = G * v, curvature = constraint_curvature(model_, q, v),
                                          rest = G * a;
        for (int i = 0; i < m; ++i)
            f[2 * n + i] = S(contact_.stiffness) * creep[i] + S(contact_.damping) * (curvature[i] + rest[i]);
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const hidden_constraint_jacobian<S, Model> d(model_, y.template head<n>(), y.template segment<n>(n),
                                                     y.template tail<m>(), t);
        const S spring(contact_.stiffness), damper(contact_.damping);
        J = Eigen::Matrix<S, size, size>::Constant(S(0));
        for (int j = 0; j < n; ++j) J(j, n + j) = S(1);
        J.template block<n, n>(n, 0) = d.a_q;
        J.template block<n, n>(n, n) = d.a_v;
        J.template block<n, m>(n, 2 * n) = d.a_lambda;
        J.template block<m, n>(2 * n, 0) = spring * d.Gv_q + damper * d.phi_q;
        J.template block<m, n>(2 * n, n) = spring * d.G + damper * d.phi_v;
        J.template block<m, m>(2 * n, 2 * n) = damper * d.phi_lambda;
    }

    Eigen::Matrix<Scalar, size, 1> initial_state(const coordinate_vector<Scalar, Model>& q,
                                                 const coordinate_vector<Scalar, Model>& v,
                                                 const multiplier_vector<Scalar, Model>& lambda) const {
        Eigen::Matrix<Scalar, size, 1> y;
        y << q, v, lambda;
        return y;
    }
    multiplier_vector<Scalar, Model> multiplier(const Eigen::Matrix<Scalar, size, 1>& y) const {
        return y.template tail<m>();
    }
    const Model& model() const { return model_; }
    const stagecraft::contact<Scalar>& contact() const { return contact_; }

  private:
    Model model_;
    stagecraft::contact<Scalar> contact_;
};

/// The form (y, z) of thesis (3.10)-(3.12), state (q, v, z): index 0, no derivative of G needed,
///
///     v' = M^-1 (F - G^T ((c/eps) z + (d/eps^kappa) G v)),   z' = G v.
///
/// The costliest form for small eps: with kappa = 1 and eps = 1e-10 it takes some 70 times the steps of the
/// others. Made by `regularised_creep_form`.
template <mechanical_model Model, class Scalar = double>
class creep_form {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n + m;
    static constexpr int second_order_components = n;

    creep_form(Model model, contact<Scalar> k) : model_(std::move(model)), contact_(std::move(k)) {}

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = y.template head<n>(), v = y.template segment<n>(n);
        const multiplier_vector<S, Model> z = y.template tail<m>();
        const Eigen::Matrix<S, m, n> G = model_.G(q);
        const multiplier_vector<S, Model> creep = G * v;
        multiplier_vector<S, Model> lambda;
        for (int i = 0; i < m; ++i) lambda[i] = S(contact_.stiffness) * z[i] + S(contact_.damping) * creep[i];
        f.template head<n>() = v;
        f.template segment<n>(n) =
            mass_inverse<S, Model>(model_, q)(force<S>(model_, q, v, t) - G.transpose() * lambda);
        f.template tail<m>() = creep;
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const coordinate_vector<S, Model> q = y.template head<n>(), v = y.template segment<n>(n);
        const S spring(contact_.stiffness), damper(contact_.damping);
        const multiplier_vector<S, Model> lambda = spring * y.template tail<m>() + damper * (model_.G(q) * v);
        const acceleration_jacobian<S, Model> d(model_, q, v, lambda, t);
        J = Eigen::Matrix<S, size, size>::Constant(S(0));
        for (int j = 0; j < n; ++j) J(j, n + j) = S(1);
        J.template block<n, n>(n, 0) = d.a_q + damper * (d.a_lambda * d.Gv_q);
        J.template block<n, n>(n, n) = d.a_v + damper * (d.a_lambda * d.G);
        J.template block<n, m>(n, 2 * n) = spring * d.a_lambda;
        J.template block<m, n>(2 * n, 0) = d.Gv_q;
        J.template block<m, n>(2 * n, n) = d.G;
    }

    Eigen::Matrix<Scalar, size, 1> initial_state(const coordinate_vector<Scalar, Model>& q,
                                                 const coordinate_vector<Scalar, Model>& v,
                                                 const multiplier_vector<Scalar, Model>& lambda) const {
        const multiplier_vector<Scalar, Model> z =
            (lambda - contact_.damping * (model_.G(q) * v)) / contact_.stiffness;
        Eigen::Matrix<Scalar, size, 1> y;
        y << q, v, z;
        return y;
    }
    multiplier_vector<Scalar, Model> multiplier(const Eigen::Matrix<Scalar, size, 1>& y) const {
        const coordinate_vector<Scalar, Model> q = y.template head<n>(), v = y.template segment<n>(n);
        return contact_.stiffness * y.template tail<m>() + contact_.damping * (model_.G(q) * v);
    }
    const Model& model() const { return model_; }
    const stagecraft::contact<Scalar>& contact() const { return contact_; }

  private:
    Model model_;
    stagecraft::contact<Scalar> contact_;
};

/// Principal damping in the transformed form (3.60) of the thesis, state (q, v, lambda, theta), with
/// e = (d/c) sqrt(eps), h = (d^2/c) ((dG/dt) v + G M^-1 (F - G^T lambda)):
///
///     e lambda' = theta + h + lambda,   e theta' = -theta - lambda,   theta = (d^2/c) G v / e - lambda,
///
/// a singular perturbation problem in the standard form in e, to which Theorem 6 applies under (3.61).
/// Made by `principal_damping_transformed`.
template <mechanical_model Model, class Scalar = double>
class transformed_form {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n + 2 * m;
    static constexpr int second_order_components = n;

    transformed_form(Model model, contact<Scalar> k) : model_(std::move(model)), contact_(std::move(k)) {
        using std::sqrt;
        e_ = contact_.d / contact_.c * sqrt(contact_.epsilon);
        weight_ = contact_.d * contact_.d / contact_.c;
    }

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = y.template head<n>(), v = y.template segment<n>(n);
        const multiplier_vector<S, Model> lambda = y.template segment<m>(2 * n), theta = y.template tail<m>();
        const Eigen::Matrix<S, m, n> G = model_.G(q);
        const coordinate_vector<S, Model> a =
            mass_inverse<S, Model>(model_, q)(force<S>(model_, q, v, t) - G.transpose() * lambda);
        const multiplier_vector<S, Model> curvature = constraint_curvature(model_, q, v), rest = G * a;
        f.template head<n>() = v;
        f.template segment<n>(n) = a;
        for (int i = 0; i < m; ++i) {
            const S sum = theta[i] + lambda[i];
            f[2 * n + i] = (sum + S(weight_) * (curvature[i] + rest[i])) / S(e_);
            f[2 * n + m + i] = -sum / S(e_);
        }
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const hidden_constraint_jacobian<S, Model> d(model_, y.template head<n>(), y.template segment<n>(n),
                                                     y.template segment<m>(2 * n), t);
        const S rate = S(1) / S(e_), weight = S(weight_) / S(e_);
        J = Eigen::Matrix<S, size, size>::Constant(S(0));
        for (int j = 0; j < n; ++j) J(j, n + j) = S(1);
        J.template block<n, n>(n, 0) = d.a_q;
        J.template block<n, n>(n, n) = d.a_v;
        J.template block<n, m>(n, 2 * n) = d.a_lambda;
        J.template block<m, n>(2 * n, 0) = weight * d.phi_q;
        J.template block<m, n>(2 * n, n) = weight * d.phi_v;
        J.template block<m, m>(2 * n, 2 * n) = weight * d.phi_lambda;
        for (int j = 0; j < m; ++j) {
            J(2 * n + j, 2 * n + j) += rate;
            J(2 * n + j, 2 * n + m + j) = rate;
            J(2 * n + m + j, 2 * n + j) = -rate;
            J(2 * n + m + j, 2 * n + m + j) = -rate;
        }
    }

    Eigen::Matrix<Scalar, size, 1> initial_state(const coordinate_vector<Scalar, Model>& q,
                                                 const coordinate_vector<Scalar, Model>& v,
                                                 const multiplier_vector<Scalar, Model>& lambda) const {
        const multiplier_vector<Scalar, Model> theta = weight_ / e_ * (model_.G(q) * v) - lambda;
        Eigen::Matrix<Scalar, size, 1> y;
        y << q, v, lambda, theta;
        return y;
    }
    multiplier_vector<Scalar, Model> multiplier(const Eigen::Matrix<Scalar, size, 1>& y) const {
        return y.template segment<m>(2 * n);
    }
    const Model& model() const { return model_; }
    const stagecraft::contact<Scalar>& contact() const { return contact_; }

  private:
    Model model_;
    stagecraft::contact<Scalar> contact_;
    Scalar e_{0}, weight_{0};
};

/// The regularised problem in its default, mass-matrix form; every form throws std::invalid_argument that
/// names the parameter unless eps, c, d > 0 and 0 < kappa <= 1. Each has `initial_state(q, v, lambda)` and
/// `multiplier(y)`.
template <class Scalar = double, mechanical_model Model>
regularised_problem<Model, Scalar> regularised(Model model, Scalar eps, Scalar kappa, Scalar c, Scalar d) {
    return {std::move(model), contact<Scalar>(eps, kappa, c, d)};
}

/// The regularised problem as explicit differential equation in (q, v, lambda).
template <class Scalar = double, mechanical_model Model>
multiplier_form<Model, Scalar> regularised_multiplier_form(Model model, Scalar eps, Scalar kappa, Scalar c,
                                                           Scalar d) {
    return {std::move(model), contact<Scalar>(eps, kappa, c, d)};
}

/// The regularised problem as explicit differential equation in (q, v, z).
template <class Scalar = double, mechanical_model Model>
creep_form<Model, Scalar> regularised_creep_form(Model model, Scalar eps, Scalar kappa, Scalar c, Scalar d) {
    return {std::move(model), contact<Scalar>(eps, kappa, c, d)};
}

/// Strong damping, kappa = 1.
template <class Scalar = double, mechanical_model Model>
regularised_problem<Model, Scalar> strong_damping(Model model, Scalar eps, Scalar c, Scalar d) {
    return regularised<Scalar>(std::move(model), eps, Scalar(1), c, d);
}

/// Principal damping, kappa = 1/2.
template <class Scalar = double, mechanical_model Model>
regularised_problem<Model, Scalar> principal_damping(Model model, Scalar eps, Scalar c, Scalar d) {
    return regularised<Scalar>(std::move(model), eps, Scalar(1) / Scalar(2), c, d);
}

/// Principal damping, kappa = 1/2, in the transformed form (3.60).
template <class Scalar = double, mechanical_model Model>
transformed_form<Model, Scalar> principal_damping_transformed(Model model, Scalar eps, Scalar c, Scalar d) {
    return {std::move(model), contact<Scalar>(eps, Scalar(1) / Scalar(2), c, d)};
}

}  // namespace stagecraft
