// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SVD>
#include <algorithm>
#include <string>

#include <stagecraft/problem/mechanical.hpp>

namespace stagecraft {

/// The model assumptions of the thesis (section 1.2) as far as numbers at one position can show them.
struct model_assumptions {
    double asymmetry;          ///< max |M - M^T| / max |M|
    double smallest_pivot;     ///< of M = L D L^T, relative to the largest; positive definite if > 0
    double constraint_rank;    ///< smallest over largest singular value of G; full rank if > 0
    double inertia_condition;  ///< condition number of g_y f_lambda = -G M^-1 G^T in the 2-norm
    std::string singular;      ///< the position in the model's words if M is singular there, else empty

    /// True if M is symmetric positive definite, G of full rank and G M^-1 G^T regular, each to working
    /// precision: then the system has differentiation and perturbation index 2 here (HLR89 section 1).
    bool hold() const {
        const double eps = Eigen::NumTraits<double>::epsilon();
        return singular.empty() && asymmetry <= 16 * eps && smallest_pivot > eps && constraint_rank > eps &&
               inertia_condition < 1 / eps;
    }
};

/// Evaluates them at q.
template <mechanical_model Model>
model_assumptions check_assumptions(const Model& model, const coordinate_vector<double, Model>& q) {
    constexpr int n = Model::coordinates, m = Model::constraints;
    const Eigen::Matrix<double, n, n> M = model.M(q);
    const small_ldlt<double, n> factors(M);
    double least = factors.pivot(0), most = factors.pivot(0);
    for (int i = 1; i < n; ++i) {
        least = std::min(least, factors.pivot(i));
        most = std::max(most, factors.pivot(i));
    }
    const Eigen::MatrixXd G = Eigen::Matrix<double, m, n>(model.G(q)),
                          S = constraint_inertia<double>(model, q);
    const Eigen::VectorXd of_G = G.jacobiSvd().singularValues(), of_S = S.jacobiSvd().singularValues();
    return {(M - M.transpose()).cwiseAbs().maxCoeff() / M.cwiseAbs().maxCoeff(), least / most,
            of_G[m - 1] / of_G[0], of_S[0] / of_S[m - 1], singular_position(model, q)};
}

}  // namespace stagecraft
