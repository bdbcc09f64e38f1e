// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <utility>

#include <stagecraft/mechanics/derivatives.hpp>
#include <stagecraft/mechanics/start.hpp>

namespace stagecraft {

/// What index reduction loses: the equations 0 = g(q, t) (of a holonomic model) and 0 = G v + b as functions of
/// states that begin with (q, v), ready for `projection_onto` (dae/projection.hpp):
///
///     auto keep = projection_onto(invariants(model));
///     integrate(method, index_reduced(model), y0, t0, t1, options, keep);
///
/// Made by `invariants`.
template <fixed_size_model Model>
class model_invariants {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints;
    /// The number of equations: m of velocity, after m of position where there are some.
    static constexpr int count = holonomic_model<Model> ? 2 * m : m;

    explicit model_invariants(Model model) : model_(std::move(model)) {}

    template <class Scalar, class State, class Values>
    void operator()(const Scalar& t, const State& y, Values& r) const {
        const coordinate_vector<Scalar, Model> q = y.template head<n>(), v = y.template segment<n>(n);
        if constexpr (holonomic_model<Model>)
            r.template head<m>() = position_constraint<Scalar>(model_, q, t);
        r.template tail<m>() = velocity_constraint<Scalar>(model_, q, v, t);
    }
    template <class Scalar, class State, class Matrix>
    void jacobian(const Scalar& t, const State& y, Matrix& J) const {
        const coordinate_vector<Scalar, Model> q = y.template head<n>(), v = y.template segment<n>(n);
        const velocity_constraint_jacobian<Scalar, Model> d(model_, q, v, t);
        J.setZero();
        if constexpr (holonomic_model<Model>) J.template topLeftCorner<m, n>() = d.G;
        J.template block<m, n>(count - m, 0) = d.Gv_q;
        J.template block<m, n>(count - m, n) = d.G;
    }

  private:
    Model model_;
};

/// The equations that the motion of a model keeps and an index-reduced equation does not.
template <fixed_size_model Model>
model_invariants<Model> invariants(Model model) {
    return model_invariants<Model>(std::move(model));
}

}  // namespace stagecraft
