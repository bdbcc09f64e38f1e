// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <utility>

#include <stagecraft/mechanics/contact.hpp>
#include <stagecraft/mechanics/formulations.hpp>

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
class regularised_position_problem
    : public detail::equations_of_motion<regularised_position_problem<Model, Scalar>, Model, Scalar, 1>,
      public detail::second_order<Model> {
    using base = detail::equations_of_motion<regularised_position_problem, Model, Scalar, 1>;
    friend base;

  public:
    using typename base::state;
    using position = coordinate_vector<Scalar, Model>;
    using force = multiplier_vector<Scalar, Model>;

    regularised_position_problem(Model model, contact<Scalar> k) requires fixed_size_model<Model>
        : base(std::move(model)), contact_(std::move(k)) {}
    /// q is a position that the model can be evaluated at.
    regularised_position_problem(Model model, const Eigen::VectorXd& q,
                                 contact<double> k) requires sized_mechanical_model<Model>
        : base(std::move(model), q), contact_(std::move(k)) {
        this->find_pattern(q);
    }

    auto index() const {
        const int first = this->coordinates();
        return contact_.kappa == Scalar(1) ? this->flags(2 * first) : this->flags(first, 2 * first);
    }

    /// The state near (q, v) that carries lambda without a jerk: q is moved, by the smallest change in the
    /// 2-norm, until the springs are deflected by what lambda asks of them; the change is O(eps) where q and v
    /// satisfy the constraints. Throws std::runtime_error if no such position is found near q.
    state initial_state(const position& q, const position& v, const force& lambda,
                        const Scalar& t = Scalar(0)) const requires fixed_size_model<Model> {
        state y = (state() << q, v, lambda).finished();
        for (int k = 0; k < 20; ++k) {
            state r;
            (*this)(t, y, r);
            const velocity_constraint_jacobian<Scalar, Model> d(this->model(), base::position(y), v, t);
            const Eigen::Matrix<Scalar, base::m, base::n> A = d.G + relaxation() * d.Gv_q;
            const multiplier_matrix<Scalar, Model> square = A * A.transpose();
            const force defect = r.template tail<base::m>();
            const position change = A.transpose() * small_ldlt<Scalar, base::m>(square).solve(defect);
            y.template head<base::n>() -= change;
            if (change.cwiseAbs().maxCoeff() <=
                Scalar(16) * Eigen::NumTraits<Scalar>::epsilon() * (Scalar(1) + q.cwiseAbs().maxCoeff()))
                return y;
        }
        throw std::runtime_error("regularised_position: no position near q carries lambda");
    }
    /// The same with the multiplier of the constraint itself at (q, v).
    state initial_state(const position& q, const position& v,
                        const Scalar& t = Scalar(0)) const requires fixed_size_model<Model> {
        return initial_state(q, v, consistent_multiplier(this->model(), q, v, t), t);
    }
    /// Of a size known at run time v is moved as well, until the dampers rest, and q and v must satisfy the constraints to
    /// 1e-9.
    using base::initial_state;
    const stagecraft::contact<Scalar>& contact() const { return contact_; }

  private:
    void settle(double t, Eigen::VectorXd& y) const requires sized_mechanical_model<Model> {
        this->deflect(y, contact_.stiffness, t);
    }
    Scalar relaxation() const { return contact_.damping / contact_.stiffness; }  // (d/c) eps^(1-kappa)

    template <class S, class Gradient, class State>
    void constrain(const S& t, const State& y, const Gradient& G, State& f) const {
        const auto q = base::position(y);
        const auto creep = velocity_constraint<S>(this->model(), G, q, this->velocity(y), t);
        const auto lambda = this->multipliers(y);
        auto r = position_constraint<S>(this->model(), q, t);
        for (int i = 0; i < r.size(); ++i)
            r[i] += S(relaxation()) * creep[i] - lambda[i] / S(contact_.stiffness);
        this->put_multipliers(r, f);
    }

    template <class S, int size>
    void differentiate(const acceleration_jacobian<S, Model>& d, const Eigen::Matrix<S, size, 1>&,
                       Eigen::Matrix<S, size, size>& J) const {
        const S relaxation = S(this->relaxation());
        J.template block<base::m, base::n>(2 * base::n, 0) = d.G + relaxation * d.Gv_q;
        J.template block<base::m, base::n>(2 * base::n, base::n) = relaxation * d.G;
        for (int i = 0; i < base::m; ++i) J(2 * base::n + i, 2 * base::n + i) = S(-1) / S(contact_.stiffness);
    }

    stagecraft::contact<Scalar> contact_;
};

}  // namespace stagecraft
