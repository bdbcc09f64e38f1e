// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <utility>

#include <stagecraft/mechanics/consistent_multiplier.hpp>
#include <stagecraft/mechanics/derivatives.hpp>
#include <stagecraft/refuse/mechanics/another_size.hpp>
#include <stagecraft/refuse/mechanics/checked_model.hpp>

namespace stagecraft {

/// The ordinary differential equation q' = v, v' = M(q)^-1 F(q, v, t) in the state (q, v), for any method; implicit ones
/// use its Jacobian. M is factored once per evaluation. Made by `free_motion`.
template <class Model, class Scalar = double>
class free_motion_ode : checked_model<Model>, detail::start_of_another_size<Model, 0> {
  public:
    static constexpr int n = Model::coordinates, size = 2 * n;
    static constexpr int second_order_components = n;

    explicit free_motion_ode(Model model) : model_(std::move(model)) {}

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = detail::part<n>(y, 0), v = detail::part<n>(y, n);
        detail::put(v, f, 0);
        detail::put(mass_inverse<S, Model>(model_, q)(force<S>(model_, q, v, t)), f, n);
    }

    /// By M da = d(F - M a) with a held fixed on the right.
    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        using dual = dual_number<S, n>;
        const coordinate_vector<S, Model> q = detail::part<n>(y, 0), v = detail::part<n>(y, n);
        const mass_inverse<S, Model> solve(model_, q);
        const coordinate_vector<S, Model> a = solve(force<S>(model_, q, v, t));
        const dual time = detail::constant<dual>(t);
        const coordinate_vector<dual, Model> by_q =
            detail::balance<dual, S>(model_, detail::variables<dual>(q), detail::constants<dual>(v), a, time);
        const coordinate_vector<dual, Model> by_v =
            force<dual>(model_, detail::constants<dual>(q), detail::variables<dual>(v), time);
        Eigen::Matrix<S, n, n> a_q, a_v;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                a_q(i, j) = by_q[i].derivatives()[j];
                a_v(i, j) = by_v[i].derivatives()[j];
            }
        solve.in_place(a_q);
        solve.in_place(a_v);
        detail::fill(J, S(0));
        for (int j = 0; j < n; ++j) J(j, n + j) = S(1);
        detail::put(a_q, J, n, 0);
        detail::put(a_v, J, n, n);
    }

    /// (q, v). Throws std::domain_error where M(q) is not positive definite or F not finite, std::invalid_argument for
    /// a kinetic energy that is not quadratic in v.
    Eigen::Matrix<Scalar, size, 1> initial_state(const coordinate_vector<Scalar, Model>& q,
                                                 const coordinate_vector<Scalar, Model>& v,
                                                 const Scalar& t = Scalar(0)) const {
        detail::check_kinetic_energy(model_, q);
        detail::check_mass<Scalar, n>(model_.M(q));
        detail::check_finite(force<Scalar>(model_, q, v, t),
                             "F (with lagrangian: from Q and the derivatives of T and V)");
        return detail::joined<size>(q, v);
    }
    using detail::start_of_another_size<Model, 0>::initial_state;
    const Model& model() const { return model_; }

  private:
    Model model_;
};

/// The equations of motion of a model without constraints, ready for `integrate`:
///
///     const auto pendulum = free_motion(lagrangian<1>(T, V));  // one angle
template <class Scalar = double, free_model Model>
free_motion_ode<Model, Scalar> free_motion(Model model) {
    return free_motion_ode<Model, Scalar>(std::move(model));
}

}  // namespace stagecraft

// The same name with models that have constraints.
#include <stagecraft/refuse/mechanics/formulations.hpp>
