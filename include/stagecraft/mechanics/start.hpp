// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include <stagecraft/mechanics/consistent_multiplier.hpp>

// Checks of the initial values that the formulations are given.

namespace stagecraft {

namespace detail {

/// Throws std::invalid_argument, with the constraints that are violated and the time of the start.
template <class Scalar>
[[noreturn]] void refuse_start(const std::string& violated, const Scalar& t) {
    std::ostringstream text;
    text << "mechanical: the initial q and v must satisfy the constraints at t = " << t << violated
         << " (assemble(model, q, v, t) finds such q and v nearby)";
    throw std::invalid_argument(text.str());
}

/// The first few of them, of a model with hundreds.
template <class Vector, class Scalar>
void list_violations(std::ostringstream& text, const char* what, const Vector& r, const Scalar& allowed) {
    using std::abs;
    int left = 8;
    for (int i = 0; i < r.size() && left > 0; ++i)
        if (!(abs(r[i]) <= allowed)) text << "; " << what << " " << i << " is " << r[i], --left;
}

/// Throws std::invalid_argument for a kinetic energy that is not quadratic in v and, with the size of each
/// violation, unless q and v satisfy the constraints to rounding: 64 eps max|G| max(|v|, 1) for those of velocity,
/// 64 eps max(|q|, 1) for those of position. Of a size known at run time 1e-9 stands for 64 eps max|G|.
template <class Model, class Scalar>
void check_start(const Model& model, const coordinate_vector<Scalar, Model>& q,
                 const coordinate_vector<Scalar, Model>& v, const Scalar& t) {
    const auto at_least = [](const Scalar& size, double least) {
        return size < Scalar(least) ? Scalar(least) : size;
    };
    check_kinetic_energy(model, q);
    std::ostringstream violated;
    const auto G = constraint_gradient<Scalar>(model, q, t);
    Scalar of_position(1e-9), of_velocity(1e-9);
    if constexpr (fixed_size_model<Model>) {
        of_position = Scalar(64) * Eigen::NumTraits<Scalar>::epsilon();
        of_velocity = of_position * largest(G);
    }
    if constexpr (holonomic_model<Model>)
        list_violations(violated, "position constraint", position_constraint<Scalar>(model, q, t),
                        Scalar(of_position * at_least(largest(q), 1)));
    list_violations(violated, "velocity constraint", velocity_constraint<Scalar>(model, G, q, v, t),
                    Scalar(of_velocity * at_least(largest(v), 1)));
    if (const std::string text = violated.str(); !text.empty()) refuse_start(text, t);
}

template <class Vector>
std::string no_position(const Vector& left) {
    std::ostringstream text;
    text << "assemble: no position near q satisfies the constraints; max |g| is still "
         << left.cwiseAbs().maxCoeff();
    return text.str();
}

}  // namespace detail

/// A position and a velocity.
template <class S, class Model>
struct assembly {
    coordinate_vector<S, Model> q, v;
};

namespace detail {

/// change(q, r) is the smallest one, in the metric of M, with G(q) change = r.
template <class S, class Model, class Change>
assembly<S, Model> assembled(const Model& model, coordinate_vector<S, Model> q, coordinate_vector<S, Model> v,
                             const S& t, const Change& change) {
    if constexpr (holonomic_model<Model>) {
        const S eps = Eigen::NumTraits<S>::epsilon();
        constexpr int most = 50;
        for (int k = 0;; ++k) {
            const multiplier_vector<S, Model> left = position_constraint<S>(model, q, t);
            const coordinate_vector<S, Model> d = change(q, left);
            if (k == most || !(d.squaredNorm() - d.squaredNorm() == S(0)))
                throw std::runtime_error(no_position(left));
            q -= d;
            if (d.cwiseAbs().maxCoeff() <= S(8) * eps * (S(1) + q.cwiseAbs().maxCoeff())) break;
        }
    }
    for (int k = 0; k < 2; ++k) v -= change(q, velocity_constraint<S>(model, q, v, t));
    return {std::move(q), std::move(v)};
}

}  // namespace detail

/// The position near q and the velocity near v that satisfy the constraints at time t, as a start of any
/// formulation: a mechanism assembled from rough coordinates, or the moment at which a constraint begins to act (v
/// then changes by the impulse along G^T that stops G v + b, as in a plastic impact). Distances are measured by M.
/// Newton's iteration; one factorisation of M each. Throws std::runtime_error with the violation that is left if
/// there is no such position near q, std::domain_error that names the constraint where one depends on others or
/// where M is not positive definite on the way. Of a model whose size is known at run time: sized_model.hpp.
template <fixed_size_model Model, class DerivedQ, class DerivedV>
assembly<typename DerivedQ::Scalar, Model> assemble(const Model& model, const Eigen::MatrixBase<DerivedQ>& q,
                                                    const Eigen::MatrixBase<DerivedV>& v,
                                                    const typename DerivedQ::Scalar& t = 0) {
    using S = typename DerivedQ::Scalar;
    constexpr int n = Model::coordinates, m = Model::constraints;
    using position = coordinate_vector<S, Model>;
    return detail::assembled<S>(model, q, v, t,
                                [&](const position& at, const multiplier_vector<S, Model>& r) {
                                    detail::check_mass<S, n>(model.M(at), detail::regular_by_constraints);
                                    const mass_inverse<S, Model> solve(model, at);
                                    const Eigen::Matrix<S, m, n> G = constraint_gradient<S>(model, at, t);
                                    Eigen::Matrix<S, n, m> W;
                                    for (int k = 0; k < m; ++k)
                                        W.col(k) = solve(position(G.row(k).transpose()));
                                    const multiplier_matrix<S, Model> inertia = G * W;
                                    return position(W * detail::independent_constraints(inertia, G).solve(r));
                                });
}

}  // namespace stagecraft
