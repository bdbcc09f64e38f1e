// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SVD>
#include <algorithm>
#include <string>

#include <stagecraft/mechanics/formulations.hpp>

namespace stagecraft {

/// The model assumptions of the thesis (section 1.2) as far as numbers at one state can show them.
struct model_assumptions {
    double asymmetry;              ///< 1: max |M - M^T| / max |M|
    double smallest_pivot;         ///< 1: of M = L D L^T, relative to the largest; positive definite if > 0
    double constraint_rank;        ///< 2: smallest over largest singular value of G; full rank if > 0
    double inertia_condition;      ///< 3: condition number of g_y f_lambda = -G M^-1 G^T in the 2-norm
    std::string singular;          ///< the position in the model's words if M is singular there, else empty
    double derivative_defect = 0;  ///< 4: the derivative along the motion against a central difference of f
                                   ///< and g, relative to the Jacobian; small where they are smooth
    double derivative_bound = 0;   ///< 5: largest entry of f_y, f_lambda and g_y

    /// True if M is symmetric positive definite, G of full rank and G M^-1 G^T regular, each to working
    /// precision, and f and g are as differentiable as a difference quotient can tell: then the system has
    /// differentiation and perturbation index 2 here (HLR89, section 1; dae/hessenberg.hpp decides that on
    /// its own).
    bool hold() const {
        const double eps = Eigen::NumTraits<double>::epsilon();
        return singular.empty() && asymmetry <= 16 * eps && smallest_pivot > eps && constraint_rank > eps &&
               inertia_condition < 1 / eps && derivative_defect < 1e-6 && derivative_bound < 1 / eps;
    }
};

/// Assumptions 1 to 3, at q.
template <fixed_size_model Model>
model_assumptions check_assumptions(const Model& model, const coordinate_vector<double, Model>& q,
                                    double t = 0) {
    constexpr int n = Model::coordinates, m = Model::constraints;
    const Eigen::Matrix<double, n, n> M = model.M(q);
    const small_ldlt<double, n> factors(M);
    double least = factors.pivot(0), most = factors.pivot(0);
    for (int i = 1; i < n; ++i) {
        least = std::min(least, factors.pivot(i));
        most = std::max(most, factors.pivot(i));
    }
    const Eigen::MatrixXd G = constraint_gradient<double>(model, q, t),
                          S = constraint_inertia<double>(model, q, t);
    const Eigen::VectorXd of_G = G.jacobiSvd().singularValues(), of_S = S.jacobiSvd().singularValues();
    return {(M - M.transpose()).cwiseAbs().maxCoeff() / M.cwiseAbs().maxCoeff(), least / most,
            of_G[m - 1] / of_G[0], of_S[0] / of_S[m - 1], singular_position(model, q)};
}

/// All five, at a state of the index-2 system.
template <fixed_size_model Model>
model_assumptions check_assumptions(const Model& model, const coordinate_vector<double, Model>& q,
                                    const coordinate_vector<double, Model>& v,
                                    const multiplier_vector<double, Model>& lambda, double t = 0) {
    constexpr int n = Model::coordinates, size = 2 * n + Model::constraints;
    using state = Eigen::Matrix<double, size, 1>;
    const auto system = index_2(model);
    const state y = (state() << q, v, lambda).finished();
    Eigen::Matrix<double, size, size> J;
    state motion, ahead, behind;
    system.jacobian(t, y, J);
    system(t, y, motion);
    motion.template tail<Model::constraints>().setZero();
    const double step = 1e-5 / (1 + motion.norm());  // error of the difference: step^2 and rounding / step
    system(t, state(y + step * motion), ahead);
    system(t, state(y - step * motion), behind);
    model_assumptions result = check_assumptions(model, q, t);
    result.derivative_defect =
        ((ahead - behind) / (2 * step) - J * motion).norm() / (J.norm() * (1 + motion.norm()));
    result.derivative_bound = J.cwiseAbs().maxCoeff();
    return result;
}

/// The worse value of each number at two states. Folded over a run it says what holds along all of it.
inline model_assumptions worst_of(const model_assumptions& a, const model_assumptions& b) {
    return {std::max(a.asymmetry, b.asymmetry),
            std::min(a.smallest_pivot, b.smallest_pivot),
            std::min(a.constraint_rank, b.constraint_rank),
            std::max(a.inertia_condition, b.inertia_condition),
            a.singular.empty() ? b.singular : a.singular,
            std::max(a.derivative_defect, b.derivative_defect),
            std::max(a.derivative_bound, b.derivative_bound)};
}

}  // namespace stagecraft
