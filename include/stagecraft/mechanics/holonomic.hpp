// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>

#include <stagecraft/mechanics/formulations.hpp>

namespace stagecraft {

/// The equations of motion of a holonomic model as they are, index 3: state (q, v, lambda), 0 = g(q); q has
/// index 1, v 2, lambda 3. Made by `index_3`.
template <holonomic_model Model, class Scalar = double>
class index_3_dae {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n + m;
    using state = Eigen::Matrix<Scalar, size, 1>;

    explicit index_3_dae(Model model) : model_(std::move(model)) {}

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = y.template head<n>();
        const Eigen::Matrix<S, m, n> G = constraint_gradient<S>(model_, q, t);
        detail::motion<S, Model>(model_, t, y, G, y.template tail<m>(), f);
        f.template tail<m>() = position_constraint<S>(model_, q, t);
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const acceleration_jacobian<S, Model> d(model_, y.template head<n>(), y.template segment<n>(n),
                                                y.template tail<m>(), t);
        detail::motion_jacobian(d, 2 * n, J);
        J.template block<m, n>(2 * n, 0) = d.G;
    }

    Eigen::Matrix<Scalar, size, size> mass() const { return detail::leading_identity<Scalar, size>(2 * n); }
    std::array<int, size> index() const { return detail::index_flags<size>(n, 2 * n); }

    /// (q, v, lambda); see index_2_dae::initial_state.
    state initial_state(const coordinate_vector<Scalar, Model>& q, const coordinate_vector<Scalar, Model>& v,
                        const Scalar& t = Scalar(0)) const {
        detail::check_start(model_, q, v, t);
        const multiplier_vector<Scalar, Model> lambda = consistent_multiplier(model_, q, v, t);
        return (state() << q, v, lambda).finished();
    }
    /// The multiplier in a state.
    multiplier_vector<Scalar, Model> multiplier(const state& y, const Scalar& = Scalar(0)) const {
        return y.template tail<m>();
    }
    const Model& model() const { return model_; }

  private:
    Model model_;
};

/// The stabilised index-2 formulation of Gear, Gupta and Leimkuhler (Hairer-Wanner II, (VII.1.48)): state
/// (q, v, lambda, mu) with
///
///     q' = v - G^T mu,   v' = M^-1 (F - G^T lambda),   0 = G v + b,   0 = g(q);
///
/// mu vanishes on the exact solution, and both constraints are kept. lambda and mu have index 2.
/// Made by `stabilised_index_2`.
template <holonomic_model Model, class Scalar = double>
class stabilised_dae {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n + 2 * m;
    using state = Eigen::Matrix<Scalar, size, 1>;

    explicit stabilised_dae(Model model) : model_(std::move(model)) {}

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = y.template head<n>();
        const Eigen::Matrix<S, m, n> G = constraint_gradient<S>(model_, q, t);
        detail::motion<S, Model>(model_, t, y, G, y.template segment<m>(2 * n), f);
        f.template head<n>() -= G.transpose() * y.template tail<m>();
        const multiplier_vector<S, Model> b = prescribed_velocity<S>(model_, q, t);
        f.template segment<m>(2 * n) = G * y.template segment<n>(n) + b;
        f.template tail<m>() = position_constraint<S>(model_, q, t);
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const coordinate_vector<S, Model> q = y.template head<n>();
        const acceleration_jacobian<S, Model> d(model_, q, y.template segment<n>(n),
                                                y.template segment<m>(2 * n), t);
        detail::motion_jacobian(d, 2 * n, J);
        J.template block<n, n>(0, 0) = -d.force_derivative(y.template tail<m>());
        J.template block<n, m>(0, 2 * n + m) = -d.G.transpose();
        J.template block<m, n>(2 * n, 0) = d.Gv_q;
        J.template block<m, n>(2 * n, n) = d.G;
        J.template block<m, n>(2 * n + m, 0) = d.G;
    }

    Eigen::Matrix<Scalar, size, size> mass() const { return detail::leading_identity<Scalar, size>(2 * n); }
    std::array<int, size> index() const { return detail::index_flags<size>(2 * n); }

    /// (q, v, lambda, 0); see index_2_dae::initial_state.
    state initial_state(const coordinate_vector<Scalar, Model>& q, const coordinate_vector<Scalar, Model>& v,
                        const Scalar& t = Scalar(0)) const {
        detail::check_start(model_, q, v, t);
        const multiplier_vector<Scalar, Model> lambda = consistent_multiplier(model_, q, v, t);
        return (state() << q, v, lambda, multiplier_vector<Scalar, Model>::Constant(Scalar(0))).finished();
    }
    /// The multiplier in a state.
    multiplier_vector<Scalar, Model> multiplier(const state& y, const Scalar& = Scalar(0)) const {
        return y.template segment<m>(2 * n);
    }
    const Model& model() const { return model_; }

  private:
    Model model_;
};

/// The index-3 system of a holonomic model, state (q, v, lambda).
template <class Scalar = double, holonomic_model Model>
index_3_dae<Model, Scalar> index_3(Model model) {
    return index_3_dae<Model, Scalar>(std::move(model));
}

/// Its stabilised index-2 formulation, state (q, v, lambda, mu), mu(0) = 0.
template <class Scalar = double, holonomic_model Model>
stabilised_dae<Model, Scalar> stabilised_index_2(Model model) {
    return stabilised_dae<Model, Scalar>(std::move(model));
}

}  // namespace stagecraft
