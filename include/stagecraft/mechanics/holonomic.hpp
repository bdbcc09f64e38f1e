// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <utility>

#include <stagecraft/mechanics/another_size.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>

namespace stagecraft {

namespace detail {

/// The part that both forms share: the model, and states (q, v, lambda, ...) with Multipliers vectors of the size of
/// lambda.
template <class Model, class Scalar, int Multipliers>
class holonomic_form : start_of_another_size<Model, Multipliers> {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n + Multipliers * m;
    using state = Eigen::Matrix<Scalar, size, 1>;

    explicit holonomic_form(Model model) : model_(std::move(model)) {}

    Eigen::Matrix<Scalar, size, size> mass() const { return leading_identity<Scalar, size>(2 * n); }

    /// (q, v, lambda, 0); see index_2_dae::initial_state.
    state initial_state(const coordinate_vector<Scalar, Model>& q, const coordinate_vector<Scalar, Model>& v,
                        const Scalar& t = Scalar(0)) const {
        check_start(model_, q, v, t);
        return joined<size>(q, v, consistent_multiplier(model_, q, v, t));
    }
    using start_of_another_size<Model, Multipliers>::initial_state;
    /// The multiplier in a state.
    multiplier_vector<Scalar, Model> multiplier(const state& y, const Scalar& = Scalar(0)) const {
        return part<m>(y, 2 * n);
    }
    const Model& model() const { return model_; }

  protected:
    Model model_;
};

/// 1/|G_k|, by which the rows of G become unit vectors.
template <class S, int m, int n>
Eigen::Matrix<S, m, 1> inverse_lengths(const Eigen::Matrix<S, m, n>& G) {
    using std::sqrt;
    Eigen::Matrix<S, m, 1> result;
    for (int k = 0; k < m; ++k) {
        S square(0);
        for (int j = 0; j < n; ++j) square += G(k, j) * G(k, j);
        result[k] = S(1) / S(sqrt(square));
    }
    return result;
}

}  // namespace detail

/// The equations of motion of a holonomic model as they are, index 3: state (q, v, lambda), 0 = g(q); q has
/// index 1, v 2, lambda 3. v and lambda are poor, and q accumulates their errors (measured, in tolerances: four-bar
/// linkage at 1e-10, q 4,200 and v 5e4; chain of 60 links at 1e-8, q 255). Made by `index_3`.
template <holonomic_model Model, class Scalar = double>
class index_3_dae : public detail::holonomic_form<Model, Scalar, 1> {
    using base = detail::holonomic_form<Model, Scalar, 1>;
    using base::model_;

  public:
    using base::base, base::n, base::m, base::size;

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = detail::part<n>(y, 0);
        const Eigen::Matrix<S, m, n> G = constraint_gradient<S>(model_, q, t);
        detail::motion<S, Model>(model_, t, y, G, detail::part<m>(y, 2 * n), f);
        detail::put(position_constraint<S>(model_, q, t), f, 2 * n);
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const acceleration_jacobian<S, Model> d(model_, detail::part<n>(y, 0), detail::part<n>(y, n),
                                                detail::part<m>(y, 2 * n), t);
        detail::motion_jacobian(d, 2 * n, J);
        detail::put(d.G, J, 2 * n, 0);
    }

    std::array<int, size> index() const { return detail::index_flags<size>(n, 2 * n); }
};

/// The stabilised index-2 formulation of Gear, Gupta and Leimkuhler (Hairer-Wanner II, (VII.1.48)): state
/// (q, v, lambda, mu) with
///
///     q' = v - N^T mu,   v' = M^-1 (F - G^T lambda),   0 = G v + b,   0 = g(q);
///
/// the rows of N are those of G divided by their lengths, so that mu is a velocity whatever the units of g: where G is
/// small, rounding errors of g in it would otherwise be larger than a tight tolerance. mu vanishes on the exact
/// solution, and both constraints are kept. lambda and mu have index 2. Made by `stabilised_index_2`.
template <holonomic_model Model, class Scalar = double>
class stabilised_dae : public detail::holonomic_form<Model, Scalar, 2> {
    using base = detail::holonomic_form<Model, Scalar, 2>;
    using base::model_;

  public:
    using base::base, base::n, base::m, base::size;

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = detail::part<n>(y, 0);
        coordinate_vector<S, Model> rate = detail::part<n>(y, n);
        const Eigen::Matrix<S, m, n> G = constraint_gradient<S>(model_, q, t);
        detail::motion<S, Model>(model_, t, y, G, detail::part<m>(y, 2 * n), f);
        detail::put(velocity_constraint<S>(model_, G, q, rate, t), f, 2 * n);
        detail::put(position_constraint<S>(model_, q, t), f, 2 * n + m);
        multiplier_vector<S, Model> mu = detail::part<m>(y, 2 * n + m);
        const multiplier_vector<S, Model> unit = detail::inverse_lengths(G);
        for (int k = 0; k < m; ++k) mu[k] *= unit[k];
        detail::subtract_transposed(G, mu, rate);
        detail::put(rate, f, 0);
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const acceleration_jacobian<S, Model> d(model_, detail::part<n>(y, 0), detail::part<n>(y, n),
                                                detail::part<m>(y, 2 * n), t);
        multiplier_vector<S, Model> mu = detail::part<m>(y, 2 * n + m);
        const multiplier_vector<S, Model> unit = detail::inverse_lengths(d.G);
        for (int k = 0; k < m; ++k) mu[k] *= unit[k];
        const Eigen::Matrix<S, n, n> moved = d.force_derivative(mu);
        detail::motion_jacobian(d, 2 * n, J);
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) J(i, j) = -moved(i, j);
        for (int k = 0; k < m; ++k)
            for (int i = 0; i < n; ++i) {
                J(i, 2 * n + m + k) = -d.G(k, i) * unit[k];
                S turned(0);  // mu_k d log|G_k|/dq_i
                for (int j = 0; j < n; ++j) turned += d.G(k, j) * d.dG(k, j).derivatives()[i];
                turned *= unit[k] * unit[k] * mu[k];
                for (int j = 0; j < n; ++j) J(j, i) += d.G(k, j) * turned;
            }
        detail::put(d.Gv_q, J, 2 * n, 0);
        detail::put(d.G, J, 2 * n, n);
        detail::put(d.G, J, 2 * n + m, 0);
    }

    std::array<int, size> index() const { return detail::index_flags<size>(2 * n); }
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

/// Of constraints of velocity there are no others to stabilise by.
template <class Scalar = double, mechanical_model Model>
requires(!holonomic_model<Model>) index_2_dae<Model, Scalar> stabilised_index_2(Model model) {
    static_assert(detail::never<Model>,
                  "stabilised_index_2: the model has constraints of velocity only, G v = 0, no g(q): take "
                  "index_2(model), which keeps these");
    return index_2<Scalar>(std::move(model));
}
template <class Scalar = double, mechanical_model Model>
requires(!holonomic_model<Model>) index_2_dae<Model, Scalar> index_3(Model model) {
    static_assert(detail::never<Model>,
                  "index_3: the model has constraints of velocity only, G v = 0, no g(q): take "
                  "index_2(model)");
    return index_2<Scalar>(std::move(model));
}

/// Without constraints there is nothing to choose a formulation for.
template <class Scalar = double, free_model Model>
free_motion_ode<Model, Scalar> stabilised_index_2(Model model) {
    static_assert(detail::never<Model>,
                  "stabilised_index_2: the model has no constraints: take free_motion(model)");
    return free_motion_ode<Model, Scalar>(std::move(model));
}
template <class Scalar = double, free_model Model>
free_motion_ode<Model, Scalar> index_3(Model model) {
    static_assert(detail::never<Model>, "index_3: the model has no constraints: take free_motion(model)");
    return free_motion_ode<Model, Scalar>(std::move(model));
}

}  // namespace stagecraft
