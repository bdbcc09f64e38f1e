// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>

#include <stagecraft/mechanics/formulations.hpp>

namespace stagecraft {

/// A mechanical model whose constraint is one of position: `g(q)` (a template on the scalar) with 0 = g(q)
/// and G = dg/dq. Its velocity constraint G v = 0 alone makes it a mechanical_model already.
template <class Model>
concept holonomic_model = mechanical_model<Model> &&
    requires(const Model& model, const coordinate_vector<double, Model>& q) {
    { model.g(q) } -> std::convertible_to<multiplier_vector<double, Model>>;
};

/// The equations of motion of a holonomic model as they are, index 3: state (q, v, lambda), 0 = g(q); q has
/// index 1, v 2, lambda 3. Made by `index_3`.
template <holonomic_model Model>
class index_3_dae {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n + m;

    explicit index_3_dae(Model model) : model_(std::move(model)) {}

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = y.template head<n>();
        detail::motion<S, Model>(model_, t, y, model_.G(q), y.template tail<m>(), f);
        f.template tail<m>() = model_.g(q);
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const acceleration_jacobian<S, Model> d(model_, y.template head<n>(), y.template segment<n>(n),
                                                y.template tail<m>(), t);
        detail::motion_jacobian(d, 2 * n, J);
        J.template block<m, n>(2 * n, 0) = d.G;
    }

    Eigen::Matrix<double, size, size> mass() const { return detail::leading_identity<double, size>(2 * n); }
    std::array<int, size> index() const { return detail::index_flags<size>(n, 2 * n); }

  private:
    Model model_;
};

/// The stabilised index-2 formulation of Gear, Gupta and Leimkuhler (Hairer-Wanner II, (VII.1.48)): state
/// (q, v, lambda, mu) with
///
///     q' = v - G^T mu,   v' = M^-1 (F - G^T lambda),   0 = G v,   0 = g(q);
///
/// mu vanishes on the exact solution, and both constraints are kept. lambda and mu have index 2.
/// Made by `stabilised_index_2`.
template <holonomic_model Model>
class stabilised_dae {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n + 2 * m;

    explicit stabilised_dae(Model model) : model_(std::move(model)) {}

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = y.template head<n>();
        const Eigen::Matrix<S, m, n> G = model_.G(q);
        detail::motion<S, Model>(model_, t, y, G, y.template segment<m>(2 * n), f);
        f.template head<n>() -= G.transpose() * y.template tail<m>();
        f.template segment<m>(2 * n) = G * y.template segment<n>(n);
        f.template tail<m>() = model_.g(q);
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const coordinate_vector<S, Model> q = y.template head<n>();
        const acceleration_jacobian<S, Model> d(model_, q, y.template segment<n>(n),
                                                y.template segment<m>(2 * n), t);
        using dual = dual_number<S, n>;
        const Eigen::Matrix<dual, m, n> dG = model_.G(detail::variables<dual>(q));
        detail::motion_jacobian(d, 2 * n, J);
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < m; ++k)
                J.template block<1, n>(i, 0) -= y[2 * n + m + k] * dG(k, i).derivatives().transpose();
        J.template block<n, m>(0, 2 * n + m) = -d.G.transpose();
        J.template block<m, n>(2 * n, 0) = d.Gv_q;
        J.template block<m, n>(2 * n, n) = d.G;
        J.template block<m, n>(2 * n + m, 0) = d.G;
    }

    Eigen::Matrix<double, size, size> mass() const { return detail::leading_identity<double, size>(2 * n); }
    std::array<int, size> index() const { return detail::index_flags<size>(2 * n); }

  private:
    Model model_;
};

/// The index-3 system of a holonomic model, state (q, v, lambda).
template <holonomic_model Model>
index_3_dae<Model> index_3(Model model) {
    return index_3_dae<Model>(std::move(model));
}

/// Its stabilised index-2 formulation, state (q, v, lambda, mu), mu(0) = 0.
template <holonomic_model Model>
stabilised_dae<Model> stabilised_index_2(Model model) {
    return stabilised_dae<Model>(std::move(model));
}

}  // namespace stagecraft
