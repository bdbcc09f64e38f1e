// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <stagecraft/mechanics/consistent_multiplier.hpp>

// Checks of the initial values that the formulations are given.

namespace stagecraft {

/// A mechanical model whose constraint is one of position: `g(q)` or `g(q, t)` (a template on the scalar)
/// with 0 = g and G = dg/dq (and, where g depends on t, b = dg/dt). Its velocity constraint G v + b = 0 alone
/// makes it a mechanical_model already.
template <class Model>
concept holonomic_model = mechanical_model<Model> &&(
    requires(const Model& model, const coordinate_vector<double, Model>& q) {
        { model.g(q) } -> std::convertible_to<multiplier_vector<double, Model>>;
    } ||
    requires(const Model& model, const coordinate_vector<double, Model>& q, double t) {
        { model.g(q, t) } -> std::convertible_to<multiplier_vector<double, Model>>;
    });

/// g(q, t) or g(q), whichever the model has.
template <class S, holonomic_model Model, class Time>
multiplier_vector<S, Model> position_constraint(const Model& model, const coordinate_vector<S, Model>& q,
                                                const Time& t) {
    if constexpr (requires { model.g(q, S(t)); })
        return model.g(q, S(t));
    else
        return model.g(q);
}

namespace detail {

/// Throws std::invalid_argument, with the constraints that are violated and the time of the start.
template <class Scalar>
[[noreturn]] void refuse_start(const std::string& violated, const Scalar& t) {
    std::ostringstream text;
    text << "mechanical: the initial q and v must satisfy the constraints at t = " << t << violated
         << " (assemble(model, q, v, t) finds such q and v nearby)";
    throw std::invalid_argument(text.str());
}

template <class Vector, class Scalar>
void list_violations(std::ostringstream& text, const char* what, const Vector& r, const Scalar& allowed) {
    using std::abs;
    for (int i = 0; i < r.size(); ++i)
        if (!(abs(r[i]) <= allowed)) text << "; " << what << " " << i << " is " << r[i];
}

/// Throws std::invalid_argument for a kinetic energy that is not quadratic in v and, with the size of each
/// violation, unless q and v satisfy the constraints to rounding: 64 eps max|G| max(|v|, 1) for those of velocity,
/// 64 eps max(|q|, 1) for those of position.
template <class Model, class Scalar>
void check_start(const Model& model, const coordinate_vector<Scalar, Model>& q,
                 const coordinate_vector<Scalar, Model>& v, const Scalar& t) {
    const Scalar eps = Scalar(64) * Eigen::NumTraits<Scalar>::epsilon();
    const auto at_least = [](const Scalar& size, double least) {
        return size < Scalar(least) ? Scalar(least) : size;
    };
    check_kinetic_energy(model, q);
    std::ostringstream violated;
    if constexpr (holonomic_model<Model>)
        list_violations(violated, "position constraint", position_constraint<Scalar>(model, q, t),
                        Scalar(eps * at_least(largest(q), 1)));
    const Eigen::Matrix<Scalar, Model::constraints, Model::coordinates> G =
        constraint_gradient<Scalar>(model, q, t);
    list_violations(violated, "velocity constraint", velocity_constraint<Scalar>(model, G, q, v, t),
                    Scalar(eps * largest(G) * at_least(largest(v), 1)));
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

/// The position near q and the velocity near v that satisfy the constraints at time t, as a start of any
/// formulation: a mechanism assembled from rough coordinates, or the moment at which a constraint begins to act (v
/// then changes by the impulse along G^T that stops G v + b, as in a plastic impact). Distances are measured by M.
/// Newton's iteration; one factorisation of M each. Throws std::runtime_error with the violation that is left if
/// there is no such position near q, std::domain_error that names the constraint where one depends on others or
/// where M is not positive definite on the way.
template <mechanical_model Model, class DerivedQ, class DerivedV>
assembly<typename DerivedQ::Scalar, Model> assemble(const Model& model, const Eigen::MatrixBase<DerivedQ>& q,
                                                    const Eigen::MatrixBase<DerivedV>& v,
                                                    const typename DerivedQ::Scalar& t = 0) {
    using S = typename DerivedQ::Scalar;
    constexpr int n = Model::coordinates, m = Model::constraints;
    assembly<S, Model> at{q, v};
    const S eps = Eigen::NumTraits<S>::epsilon();
    multiplier_vector<S, Model> left;
    // The smallest change in the metric of M with G change = r.
    const auto change = [&](const multiplier_vector<S, Model>& r) {
        detail::check_mass<S, n>(model.M(at.q), detail::regular_by_constraints);
        const mass_inverse<S, Model> solve(model, at.q);
        const Eigen::Matrix<S, m, n> G = constraint_gradient<S>(model, at.q, t);
        Eigen::Matrix<S, n, m> W;
        for (int k = 0; k < m; ++k) W.col(k) = solve(coordinate_vector<S, Model>(G.row(k).transpose()));
        const multiplier_matrix<S, Model> inertia = G * W;
        return coordinate_vector<S, Model>(W * detail::independent_constraints(inertia, G).solve(r));
    };
    if constexpr (holonomic_model<Model>) {
        constexpr int most = 50;
        for (int k = 0;; ++k) {
            left = position_constraint<S>(model, at.q, t);
            const coordinate_vector<S, Model> d = change(left);
            if (k == most || !(d.squaredNorm() - d.squaredNorm() == S(0)))
                throw std::runtime_error(detail::no_position(left));
            at.q -= d;
            if (d.cwiseAbs().maxCoeff() <= S(8) * eps * (S(1) + at.q.cwiseAbs().maxCoeff())) break;
        }
    }
    for (int k = 0; k < 2; ++k) at.v -= change(velocity_constraint<S>(model, at.q, at.v, t));
    return at;
}

}  // namespace stagecraft
