// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <stdexcept>
#include <utility>

#include <stagecraft/mechanics/regularisation/regularised.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>

namespace stagecraft {

/// The contact of `regularised` at a constraint of position: lambda = (c/eps) g(q, t) + (d/eps^kappa) w with
/// w = G v + b = dg/dt, a joint with a spring and a damper. State (q, v, lambda),
///
///     q' = v,   v' = M^-1 (F - G^T lambda),   0 = g + (d/c) eps^(1-kappa) w - (eps/c) lambda.
///
/// No entry grows as eps -> 0. The limit is the index-2 system with 0 = g + (d/c) w for kappa = 1, and that of
/// index 3 for kappa < 1; v and lambda are flagged accordingly. g does not drift: it stays (eps/c) lambda to
/// O(eps^(2-kappa)). Made by `regularised_position`.
template <holonomic_model Model, class Scalar = double>
class regularised_position_problem : public detail::regularised_form<Model, Scalar, 1> {
    using base = detail::regularised_form<Model, Scalar, 1>;
    using base::contact_, base::model_;

  public:
    using base::n, base::m, base::size;
    using typename base::force, typename base::position, typename base::state;

    regularised_position_problem(Model model, contact<Scalar> k)
        : base(std::move(model), std::move(k)),
          compliance_(Scalar(1) / contact_.stiffness),
          relaxation_(contact_.damping / contact_.stiffness) {}

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const multiplier_vector<S, Model> lambda = y.template tail<m>();
        const Eigen::Matrix<S, m, n> G = base::G(t, y);
        const multiplier_vector<S, Model> creep = base::creep(t, y, G),
                                          g = position_constraint<S>(
                                              model_, coordinate_vector<S, Model>(y.template head<n>()), t);
        detail::motion<S, Model>(model_, t, y, G, lambda, f);
        for (int i = 0; i < m; ++i)
            f[2 * n + i] = g[i] + S(relaxation_) * creep[i] - S(compliance_) * lambda[i];
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const auto d =
            base::template derivatives<acceleration_jacobian<S, Model>, S>(t, y, y.template tail<m>());
        const S relaxation(relaxation_);
        detail::motion_jacobian(d, 2 * n, J);
        J.template block<m, n>(2 * n, 0) = d.G + relaxation * d.Gv_q;
        J.template block<m, n>(2 * n, n) = relaxation * d.G;
        for (int i = 0; i < m; ++i) J(2 * n + i, 2 * n + i) = S(-compliance_);
    }

    Eigen::Matrix<Scalar, size, size> mass() const { return detail::leading_identity<Scalar, size>(2 * n); }
    std::array<int, size> index() const {
        return contact_.kappa == Scalar(1) ? detail::index_flags<size>(2 * n)
                                           : detail::index_flags<size>(n, 2 * n);
    }

    /// The state near (q, v) that carries lambda without a jerk: q is moved, by the smallest change in the
    /// 2-norm, until the springs are deflected by what lambda asks of them; the change is O(eps) where q and v
    /// satisfy the constraints. Throws std::runtime_error if no such position is found near q.
    state initial_state(const position& q, const position& v, const force& lambda,
                        const Scalar& t = Scalar(0)) const {
        state y = (state() << q, v, lambda).finished();
        for (int k = 0; k < 20; ++k) {
            state r;
            (*this)(t, y, r);
            const auto d = base::template derivatives<acceleration_jacobian<Scalar, Model>>(t, y, lambda);
            const Eigen::Matrix<Scalar, m, n> A = d.G + relaxation_ * d.Gv_q;
            const multiplier_matrix<Scalar, Model> square = A * A.transpose();
            const force defect = r.template tail<m>();
            const position change = A.transpose() * small_ldlt<Scalar, m>(square).solve(defect);
            y.template head<n>() -= change;
            if (change.cwiseAbs().maxCoeff() <=
                Scalar(16) * Eigen::NumTraits<Scalar>::epsilon() * (Scalar(1) + q.cwiseAbs().maxCoeff()))
                return y;
        }
        throw std::runtime_error("regularised_position: no position near q carries lambda");
    }
    /// The same with the multiplier of the constraint itself at (q, v).
    state initial_state(const position& q, const position& v, const Scalar& t = Scalar(0)) const {
        return initial_state(q, v, consistent_multiplier(model_, q, v, t), t);
    }
    using base::initial_state;
    /// The contact force in a state.
    force multiplier(const state& y, const Scalar& = Scalar(0)) const { return y.template tail<m>(); }

  private:
    Scalar compliance_, relaxation_;  // eps/c and (d/c) eps^(1-kappa)
};

/// The regularised problem of a model with position constraints, on the level of position. Throws
/// std::invalid_argument as `regularised` does.
template <holonomic_model Model, class Eps, class Kappa, class C, class D>
auto regularised_position(Model model, Eps eps, Kappa kappa, C c, D d) {
    const auto k = detail::contact_of(eps, kappa, c, d);
    return regularised_position_problem<Model, typename decltype(k)::scalar>(std::move(model), k);
}

/// Of constraints of velocity there is no position.
template <mechanical_model Model, class Eps, class Kappa, class C, class D>
requires(!holonomic_model<Model>) auto regularised_position(Model model, Eps eps, Kappa kappa, C c, D d) {
    static_assert(detail::never<Model>,
                  "regularised_position: the model has constraints of velocity only, G v = 0, no g(q): take "
                  "regularised(model, eps, kappa, c, d)");
    return regularised(std::move(model), eps, kappa, c, d);
}

}  // namespace stagecraft
