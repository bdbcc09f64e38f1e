// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <utility>

#include <stagecraft/mechanics/contact.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/refuse/mechanics/another_size.hpp>

namespace stagecraft {

namespace detail {

/// The part that all forms share: the model, the contact, and states (q, v, ...) with Extra more vectors of
/// the size of lambda.
template <class Model, class Scalar, int Extra>
class regularised_form : start_of_another_size<Model, Extra> {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n + Extra * m;
    static constexpr int second_order_components = n;
    using position = coordinate_vector<Scalar, Model>;
    using force = multiplier_vector<Scalar, Model>;
    using state = Eigen::Matrix<Scalar, size, 1>;

    regularised_form(Model model, contact<Scalar> k) : model_(std::move(model)), contact_(std::move(k)) {}

    const Model& model() const { return model_; }
    const stagecraft::contact<Scalar>& contact() const { return contact_; }
    using start_of_another_size<Model, Extra>::initial_state;

  protected:
    template <class S>
    Eigen::Matrix<S, m, n> G(const S& t, const Eigen::Matrix<S, size, 1>& y) const {
        return constraint_gradient<S>(model_, coordinate_vector<S, Model>(y.template head<n>()), t);
    }
    /// G v + b.
    template <class S>
    multiplier_vector<S, Model> creep(const S& t, const Eigen::Matrix<S, size, 1>& y,
                                      const Eigen::Matrix<S, m, n>& G) const {
        const coordinate_vector<S, Model> q = y.template head<n>();
        const multiplier_vector<S, Model> b = prescribed_velocity<S>(model_, q, t);
        return G * y.template segment<n>(n) + b;
    }
    /// d/dt (G v + b) for the acceleration a.
    template <class S>
    multiplier_vector<S, Model> creep_rate(const S& t, const Eigen::Matrix<S, size, 1>& y,
                                           const Eigen::Matrix<S, m, n>& G,
                                           const coordinate_vector<S, Model>& a) const {
        const coordinate_vector<S, Model> q = y.template head<n>(), v = y.template segment<n>(n);
        const multiplier_vector<S, Model> curvature = constraint_curvature(model_, q, v, t), rest = G * a;
        return curvature + rest;
    }
    template <class Derivatives, class S>
    Derivatives derivatives(const S& t, const Eigen::Matrix<S, size, 1>& y,
                            const multiplier_vector<S, Model>& lambda) const {
        return {model_, y.template head<n>(), y.template segment<n>(n), lambda, t};
    }

    Model model_;
    stagecraft::contact<Scalar> contact_;
};

}  // namespace detail

/// The mass-matrix form of a regularised mechanical problem, state (q, v, zeta, lambda) with zeta = (c/eps)
/// z:
///
///     q' = v,  v' = M^-1 (F - G^T lambda),  (eps/c) zeta' = w,  0 = (eps^kappa/d) (lambda - zeta) - w,
///
/// where w = G v + b, zeta and lambda flagged index 2. No entry grows as eps -> 0, where the index-2 system with
/// lambda = zeta is the limit, and the number of steps tends to one near that of the limit. With tolerance 1e-10 and
/// eps = 1e-3 ... 1e-14 Chaplygin's sleigh takes 0.94 to 1.08 times the attempts of the limit for kappa = 1/2 and
/// 1.11 to 1.15 for kappa = 1, the rolling disc 0.70 to 1.07 and 0.84 to 0.98; from eps = 1e-11
/// on they change by less than 1 %.
///
/// Where h is some ten times sqrt(eps), what an estimate shows of lambda is mostly what the step before has left
/// there: measured, it goes with h_n^0.9 h_{n-1}^2.3. A predictive controller, which takes it for h_n^4, is unstable
/// once more than (3 - sqrt 5)/2 = 0.38 of the power is that of h_{n-1}: steps would go up and down by a factor of 4.
/// This is why each step is judged by its own share (`acceptance::weigh`), and they do not. The default form. Made by
/// `regularised`.
template <fixed_size_model Model, class Scalar = double>
class regularised_problem : public detail::regularised_form<Model, Scalar, 2> {
    using base = detail::regularised_form<Model, Scalar, 2>;
    using base::contact_, base::model_;

  public:
    using base::base, base::n, base::m, base::size;
    using typename base::force, typename base::position, typename base::state;

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const multiplier_vector<S, Model> zeta = y.template segment<m>(2 * n), lambda = y.template tail<m>();
        const Eigen::Matrix<S, m, n> G = base::G(t, y);
        const multiplier_vector<S, Model> creep = base::creep(t, y, G);
        detail::motion<S, Model>(model_, t, y, G, lambda, f);
        f.template segment<m>(2 * n) = creep;
        const S compliance = S(Scalar(1) / contact_.damping);
        for (int i = 0; i < m; ++i) f[2 * n + m + i] = compliance * (lambda[i] - zeta[i]) - creep[i];
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const auto d =
            base::template derivatives<acceleration_jacobian<S, Model>, S>(t, y, y.template tail<m>());
        const S compliance = S(Scalar(1) / contact_.damping);
        detail::motion_jacobian(d, 2 * n + m, J);
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
        auto M = detail::leading_identity<Scalar, size>(2 * n);
        for (int i = 0; i < m; ++i) M(2 * n + i, 2 * n + i) = Scalar(1) / contact_.stiffness;
        return M;
    }
    std::array<int, size> index() const { return detail::index_flags<size>(2 * n); }

    /// The state with contact force lambda at (q, v): zeta = lambda - (d/eps^kappa) G v.
    state initial_state(const position& q, const position& v, const force& lambda,
                        const Scalar& t = Scalar(0)) const {
        const force zeta = lambda - contact_.damping * velocity_constraint<Scalar>(model_, q, v, t);
        return (state() << q, v, zeta, lambda).finished();
    }
    state initial_state(const position& q, const position& v, const Scalar& t = Scalar(0)) const {
        return initial_state(q, v, consistent_multiplier(model_, q, v, t), t);
    }
    using base::initial_state;
    /// The contact force in a state.
    force multiplier(const state& y, const Scalar& = Scalar(0)) const { return y.template tail<m>(); }
};

/// The form (y, lambda) of thesis (3.7)-(3.8), state (q, v, lambda): an explicit differential equation,
///
///     lambda' = (c/eps) w + (d/eps^kappa) w',   w = G v + b.
///
/// Made by `regularised_multiplier_form`.
template <fixed_size_model Model, class Scalar = double>
class multiplier_form : public detail::regularised_form<Model, Scalar, 1> {
    using base = detail::regularised_form<Model, Scalar, 1>;
    using base::contact_, base::model_;

  public:
    using base::base, base::n, base::m, base::size;
    using typename base::force, typename base::position, typename base::state;

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const Eigen::Matrix<S, m, n> G = base::G(t, y);
        const auto a = detail::motion<S, Model>(model_, t, y, G, y.template tail<m>(), f);
        const multiplier_vector<S, Model> creep = base::creep(t, y, G),
                                          rate = base::template creep_rate<S>(t, y, G, a);
        for (int i = 0; i < m; ++i)
            f[2 * n + i] = S(contact_.stiffness) * creep[i] + S(contact_.damping) * rate[i];
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const auto d =
            base::template derivatives<hidden_constraint_jacobian<S, Model>, S>(t, y, y.template tail<m>());
        const S spring(contact_.stiffness), damper(contact_.damping);
        detail::motion_jacobian<S, Model>(d, 2 * n, J);
        J.template block<m, n>(2 * n, 0) = spring * d.Gv_q + damper * d.phi_q;
        J.template block<m, n>(2 * n, n) = spring * d.G + damper * d.phi_v;
        J.template block<m, m>(2 * n, 2 * n) = damper * d.phi_lambda;
    }

    state initial_state(const position& q, const position& v, const force& lambda,
                        const Scalar& = Scalar(0)) const {
        return (state() << q, v, lambda).finished();
    }
    state initial_state(const position& q, const position& v, const Scalar& t = Scalar(0)) const {
        return initial_state(q, v, consistent_multiplier(model_, q, v, t), t);
    }
    using base::initial_state;
    force multiplier(const state& y, const Scalar& = Scalar(0)) const { return y.template tail<m>(); }
};

/// The form (y, z) of thesis (3.10)-(3.12), state (q, v, z): index 0, no derivative of G needed,
///
///     v' = M^-1 (F - G^T ((c/eps) z + (d/eps^kappa) w)),   z' = w = G v + b.
///
/// The costliest form for small eps: with kappa = 1, eps = 1e-10 and a tolerance of 1e-8 it takes eight times
/// the steps of the others. Made by `regularised_creep_form`.
template <fixed_size_model Model, class Scalar = double>
class creep_form : public detail::regularised_form<Model, Scalar, 1> {
    using base = detail::regularised_form<Model, Scalar, 1>;
    using base::contact_, base::model_;

  public:
    using base::base, base::n, base::m, base::size;
    using typename base::force, typename base::position, typename base::state;

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const Eigen::Matrix<S, m, n> G = base::G(t, y);
        const multiplier_vector<S, Model> creep = base::creep(t, y, G);
        detail::motion<S, Model>(model_, t, y, G, contact_force(y, creep), f);
        f.template tail<m>() = creep;
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const S spring(contact_.stiffness), damper(contact_.damping);
        const multiplier_vector<S, Model> creep = base::creep(t, y, base::G(t, y));
        const auto d =
            base::template derivatives<acceleration_jacobian<S, Model>, S>(t, y, contact_force(y, creep));
        detail::motion_jacobian(d, 2 * n, J);
        J.template block<n, n>(n, 0) += damper * (d.a_lambda * d.Gv_q);
        J.template block<n, n>(n, n) += damper * (d.a_lambda * d.G);
        J.template block<n, m>(n, 2 * n) *= spring;
        J.template block<m, n>(2 * n, 0) = d.Gv_q;
        J.template block<m, n>(2 * n, n) = d.G;
    }

    state initial_state(const position& q, const position& v, const force& lambda,
                        const Scalar& t = Scalar(0)) const {
        const force z =
            (lambda - contact_.damping * velocity_constraint<Scalar>(model_, q, v, t)) / contact_.stiffness;
        return (state() << q, v, z).finished();
    }
    state initial_state(const position& q, const position& v, const Scalar& t = Scalar(0)) const {
        return initial_state(q, v, consistent_multiplier(model_, q, v, t), t);
    }
    using base::initial_state;
    force multiplier(const state& y, const Scalar& t = Scalar(0)) const {
        return contact_force(y, base::creep(t, y, base::G(t, y)));
    }

  private:
    template <class S>
    multiplier_vector<S, Model> contact_force(const Eigen::Matrix<S, size, 1>& y,
                                              const multiplier_vector<S, Model>& creep) const {
        multiplier_vector<S, Model> lambda;
        for (int i = 0; i < m; ++i)
            lambda[i] = S(contact_.stiffness) * y[2 * n + i] + S(contact_.damping) * creep[i];
        return lambda;
    }
};

/// Principal damping in the transformed form (3.60) of the thesis, state (q, v, lambda, theta), with
/// e = (d/c) sqrt(eps), w = G v + b, h = (d^2/c) w':
///
///     e lambda' = theta + h + lambda,   e theta' = -theta - lambda,   theta = (d^2/c) w / e - lambda,
///
/// a singular perturbation problem in the standard form in e, to which Theorem 6 applies under (3.61).
/// Made by `principal_damping_transformed`.
template <fixed_size_model Model, class Scalar = double>
class transformed_form : public detail::regularised_form<Model, Scalar, 2> {
    using base = detail::regularised_form<Model, Scalar, 2>;
    using base::contact_, base::model_;

  public:
    using base::n, base::m, base::size;
    using typename base::force, typename base::position, typename base::state;

    transformed_form(Model model, contact<Scalar> k) : base(std::move(model), std::move(k)) {
        using std::sqrt;
        e_ = contact_.d / contact_.c * sqrt(contact_.epsilon);
        weight_ = contact_.d * contact_.d / contact_.c;
    }

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const multiplier_vector<S, Model> lambda = y.template segment<m>(2 * n), theta = y.template tail<m>();
        const Eigen::Matrix<S, m, n> G = base::G(t, y);
        const auto a = detail::motion<S, Model>(model_, t, y, G, lambda, f);
        const multiplier_vector<S, Model> rate = base::template creep_rate<S>(t, y, G, a);
        for (int i = 0; i < m; ++i) {
            const S sum = theta[i] + lambda[i];
            f[2 * n + i] = (sum + S(weight_) * rate[i]) / S(e_);
            f[2 * n + m + i] = -sum / S(e_);
        }
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const auto d = base::template derivatives<hidden_constraint_jacobian<S, Model>, S>(
            t, y, y.template segment<m>(2 * n));
        const S rate = S(1) / S(e_), weight = S(weight_) / S(e_);
        detail::motion_jacobian<S, Model>(d, 2 * n, J);
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

    state initial_state(const position& q, const position& v, const force& lambda,
                        const Scalar& t = Scalar(0)) const {
        const force theta = weight_ / e_ * velocity_constraint<Scalar>(model_, q, v, t) - lambda;
        return (state() << q, v, lambda, theta).finished();
    }
    state initial_state(const position& q, const position& v, const Scalar& t = Scalar(0)) const {
        return initial_state(q, v, consistent_multiplier(model_, q, v, t), t);
    }
    using base::initial_state;
    force multiplier(const state& y, const Scalar& = Scalar(0)) const { return y.template segment<m>(2 * n); }

  private:
    Scalar e_{0}, weight_{0};
};

/// The regularised problem in its default, mass-matrix form; every form throws std::invalid_argument that
/// names the parameter unless eps, c, d > 0 and 0 < kappa <= 1; integers stand for those doubles. Each has
/// `initial_state(q, v, lambda)` and
/// `initial_state(q, v)`, which takes the multiplier that the constraint itself has there, so that no layer
/// is larger than O(eps); moving constraints take the time as the last argument. `multiplier(y, t)` is the
/// contact force. Constraints of position creep on the level of velocity; `regularised_position` holds g(q)
/// itself.
template <fixed_size_model Model, class Eps, class Kappa, class C, class D>
auto regularised(Model model, Eps eps, Kappa kappa, C c, D d) {
    const auto k = detail::contact_of(eps, kappa, c, d);
    return regularised_problem<Model, typename decltype(k)::scalar>(std::move(model), k);
}

/// The regularised problem as explicit differential equation in (q, v, lambda).
template <fixed_size_model Model, class Eps, class Kappa, class C, class D>
auto regularised_multiplier_form(Model model, Eps eps, Kappa kappa, C c, D d) {
    const auto k = detail::contact_of(eps, kappa, c, d);
    return multiplier_form<Model, typename decltype(k)::scalar>(std::move(model), k);
}

/// The regularised problem as explicit differential equation in (q, v, z).
template <fixed_size_model Model, class Eps, class Kappa, class C, class D>
auto regularised_creep_form(Model model, Eps eps, Kappa kappa, C c, D d) {
    const auto k = detail::contact_of(eps, kappa, c, d);
    return creep_form<Model, typename decltype(k)::scalar>(std::move(model), k);
}

/// Strong damping, kappa = 1.
template <fixed_size_model Model, class Eps, class C, class D>
auto strong_damping(Model model, Eps eps, C c, D d) {
    return regularised(std::move(model), eps, 1, c, d);
}

/// Principal damping, kappa = 1/2.
template <fixed_size_model Model, class Eps, class C, class D>
auto principal_damping(Model model, Eps eps, C c, D d) {
    using scalar = detail::real_scalar<Eps, C, D>;
    return regularised(std::move(model), eps, scalar(scalar(1) / scalar(2)), c, d);
}

/// Principal damping, kappa = 1/2, in the transformed form (3.60).
template <fixed_size_model Model, class Eps, class C, class D>
auto principal_damping_transformed(Model model, Eps eps, C c, D d) {
    using scalar = detail::real_scalar<Eps, C, D>;
    const auto k = detail::contact_of(eps, scalar(scalar(1) / scalar(2)), c, d);
    return transformed_form<Model, scalar>(std::move(model), k);
}

}  // namespace stagecraft
