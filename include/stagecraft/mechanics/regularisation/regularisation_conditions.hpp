// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <sstream>
#include <string>

#include <stagecraft/linear/logarithmic_norm.hpp>
#include <stagecraft/mechanics/regularisation/regularised.hpp>

namespace stagecraft {

/// The hypotheses of the convergence theorems (thesis, Theorem 6 and Corollary 4) at one position q, with the
/// logarithmic norms in them: mu(-G M^-1 G^T), mu(g_lambda) with g_lambda = -d G M^-1 G^T, and the bound
/// c/d^2. A theorem holds if its condition holds in one norm, all along the motion.
struct regularisation_conditions {
    logarithmic_norms constraint;  ///< of -G M^-1 G^T
    logarithmic_norms g_lambda;    ///< of -d G M^-1 G^T
    double bound;                  ///< c/d^2

    /// Theorem 6 (strong damping): mu(g_lambda) < 0, in the Euclidean norm.
    bool strong_damping() const { return g_lambda.euclidean < 0; }
    /// Corollary 4 (principal damping), (3.61): -mu(-G M^-1 G^T) > c/d^2, in the Euclidean norm.
    bool principal_damping() const { return -constraint.euclidean > bound; }

    /// Both conditions with the norm they were decided in, and what the 1- and the infinity-norm say.
    std::string report() const {
        const auto line = [](const char* what, const logarithmic_norms& mu, double limit, bool holds) {
            std::ostringstream out;
            const auto verdict = [&](double x) { return x < limit ? " < " : " >= "; };
            out << what << (holds ? " holds" : " fails") << " in the Euclidean norm: " << mu.euclidean
                << verdict(mu.euclidean) << limit << " (1-norm: " << mu.one << verdict(mu.one) << limit
                << ", infinity-norm: " << mu.infinity << verdict(mu.infinity) << limit << ")\n";
            return out.str();
        };
        return line("strong damping (Hairer-Wanner II, Theorem VI.3.2): mu(g_lambda) < 0", g_lambda, 0,
                    strong_damping()) +
               line("principal damping, the same in the transformed form: mu(-G M^-1 G^T) < -c/d^2",
                    constraint, -bound, principal_damping());
    }
};

/// Evaluates them at q for the spring c and the damper d.
template <fixed_size_model Model>
regularisation_conditions conditions(const Model& model, const coordinate_vector<double, Model>& q, double c,
                                     double d) {
    const multiplier_matrix<double, Model> S = constraint_inertia(model, q);
    return {logarithmic_norm(multiplier_matrix<double, Model>(-S)),
            logarithmic_norm(multiplier_matrix<double, Model>(-d * S)), c / (d * d)};
}

}  // namespace stagecraft
