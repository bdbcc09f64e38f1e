// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <stagecraft/mechanics/constraint_rank.hpp>
#include <stagecraft/mechanics/model.hpp>

// The multiplier of a start, and what is wrong with a model that has none.

namespace stagecraft {

namespace detail {

/// The factors of the inertia G M^-1 G^T. Throws std::domain_error with the rank of G and the constraints that depend on
/// others, to working precision, or that names the first whose row of G vanishes.
template <class S, int m, int n>
small_ldlt<S, m> independent_constraints(const Eigen::Matrix<S, m, m>& inertia,
                                         const Eigen::Matrix<S, m, n>& G) {
    small_ldlt<S, m> factors(inertia);
    for (int k = 0; k < m; ++k) {
        if (factors.pivot(k) > S(64) * Eigen::NumTraits<S>::epsilon() * inertia(k, k)) continue;
        const std::string which = "mechanical: constraint " + std::to_string(k);
        if (inertia(k, k) == S(0)) throw std::domain_error(which + " has a row of zeros in G here");
        if (!(inertia(k, k) > S(0)))
            throw std::domain_error(which + " has a G M^-1 G^T that is not positive, or not finite, here");
        refuse_dependent(G, k);
    }
    return factors;
}

/// What to do where M is singular in directions that the constraints exclude, as with Euler parameters.
inline constexpr const char* regular_by_constraints =
    "; if it is positive definite on all v with G v = 0, add a multiple of (G v + b)^2 to T: no motion "
    "changes";

/// Throws std::domain_error that says where M is not finite or, to working precision, not positive definite, and then
/// what to do.
template <class S, int n>
void check_mass(const Eigen::Matrix<S, n, n>& M, const char* remedy = "") {
    const small_ldlt<S, n> factors(M);
    for (int k = 0; k < n; ++k) {
        if (factors.pivot(k) > S(64) * Eigen::NumTraits<S>::epsilon() * M(k, k)) continue;
        const std::string row = std::to_string(k);
        S size(0);
        for (int j = 0; j <= k; ++j) size += M(k, j) * M(k, j);
        if (!(size - size == S(0)))
            throw std::domain_error("mechanical: M(q) is not finite here, in row " + row);
        throw std::domain_error("mechanical: M(q) is not positive definite here: " +
                                (M(k, k) > S(0) ? "with coordinate " + row + " it is singular or indefinite"
                                                : "the mass of coordinate " + row + " is not positive") +
                                remedy);
    }
}

/// Throws std::invalid_argument for a kinetic energy that is not quadratic in v.
template <class Model, class Vector>
void check_kinetic_energy(const Model& model, const Vector& q) {
    if constexpr (requires { model.quadratic_in_v(q); })
        if (!model.quadratic_in_v(q))
            throw std::invalid_argument(
                "mechanical: T(q, v) must be a quadratic polynomial in v, and finite");
}

/// Throws std::domain_error that names the first component of `values` that is not finite.
template <class Vector>
void check_finite(const Vector& values, const char* what) {
    for (int k = 0; k < values.size(); ++k)
        if (!(values[k] - values[k] == typename Vector::Scalar(0)))
            throw std::domain_error(std::string("mechanical: ") + what +
                                    " is not finite here, in component " + std::to_string(k));
}

}  // namespace detail

/// The multiplier consistent with (q, v) at time t: lambda of G M^-1 G^T lambda = G M^-1 F + (dG/dt) v, the
/// once differentiated constraint (thesis (3.17); the factor c belongs to G v only, and G v = 0 here). Throws
/// std::domain_error that says which of M, F, G and dG/dt is not finite here, where M(q) is not positive definite (in
/// the model's words where it has them), and which constraint depends on others.
template <class S, class Model>
multiplier_vector<S, Model> consistent_multiplier(const Model& model, const coordinate_vector<S, Model>& q,
                                                  const coordinate_vector<S, Model>& v,
                                                  const std::type_identity_t<S>& t = S(0)) {
    if constexpr (names_singular_positions<Model> && std::is_same_v<S, double>) {
        if (const std::string where = singular_position(model, q); !where.empty())
            throw std::domain_error("mechanical: M(q) is singular: " + where);
    }
    detail::check_mass<S, Model::coordinates>(model.M(q), detail::regular_by_constraints);
    const coordinate_vector<S, Model> F = force<S>(model, q, v, t);
    detail::check_finite(F, "F (with lagrangian: from Q and the derivatives of T and V)");
    const multiplier_vector<S, Model> curvature =
        constraint_curvature<S, Model, Model::coordinates>(model, q, v, t);
    detail::check_finite(curvature, "the derivative of G v + b along the motion");
    const mass_inverse<S, Model> solve(model, q);
    const Eigen::Matrix<S, Model::constraints, Model::coordinates> G = constraint_gradient<S>(model, q, t);
    multiplier_vector<S, Model> rhs = detail::times(G, solve(F));
    for (int k = 0; k < Model::constraints; ++k) rhs[k] += curvature[k];
    return detail::independent_constraints(detail::product(G, solve.of_transposed(G)), G).solve(rhs);
}

}  // namespace stagecraft
