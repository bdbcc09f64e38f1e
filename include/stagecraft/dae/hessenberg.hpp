// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SVD>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include <stagecraft/problem/system.hpp>

namespace stagecraft {

/// The index of a semi-explicit system at one state, read off its Jacobian.
struct hessenberg_form {
    int differentiation_index;  ///< Hairer-Wanner II.VII.1; thesis, definition 1.1
    int perturbation_index;     ///< HLR89, section 1; thesis, definition 1.2; here the same number
    double condition;           ///< 2-norm condition of the matrix that must be regular; 1 for index 0
};

/// The differentiation and the perturbation index of M y' = f(t, y), M diagonal, in Hessenberg form (HLR89
/// section 1): with y the components where M is not zero and z the others, y' = f(y, z) and 0 = g(y, z) have
/// index 1 if g_z is regular, 2 if g_z = 0 and g_y f_z is regular, 3 if g_z = 0, g_y f_z = 0 and g_y f_y f_z
/// is regular (which is g_y f_z k_u in the structured form y' = f(y, z), z' = k(y, z, u), 0 = g(y)); index 0
/// if M is regular. This is a statement about one state; for a motion, ask at its states. Zero means zero to
/// rounding.
/// Throws std::invalid_argument unless M is diagonal, std::domain_error if the system has none of these
/// forms there.
template <class Problem, class Vector>
hessenberg_form hessenberg_index(const Problem& problem, double t, const Vector& y) {
    static_assert(std::is_same_v<typename Vector::Scalar, double>, "hessenberg_index: states are double");
    const Eigen::Index n = y.size();
    report<double> counts;
    system<const Problem, Vector> equations(problem, y, counts);
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(n);
    if constexpr (!std::decay_t<decltype(equations.mass())>::identity) {
        weights.setZero();
        for (const auto& e : equations.mass().entries()) {
            if (e.row != e.column && e.value != 0)
                throw std::invalid_argument("hessenberg_index: problem.mass() must be diagonal");
            weights[e.row] = e.value;
        }
    }
    std::vector<Eigen::Index> slow, fast;
    for (Eigen::Index i = 0; i < n; ++i) (weights[i] != 0 ? slow : fast).push_back(i);
    if (fast.empty()) return {0, 0, 1};

    Vector f0 = y;
    equations(t, y, f0);
    equations.take_jacobian();
    equations.evaluate_jacobian(t, y, f0, y);
    Eigen::MatrixXd J = equations.jacobian();
    for (const Eigen::Index i : slow) J.row(i) /= weights[i];
    const Eigen::MatrixXd f_y = J(slow, slow), f_z = J(slow, fast), g_y = J(fast, slow), g_z = J(fast, fast);
    const double rounding = 8 * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
    const auto condition = [](const Eigen::MatrixXd& a) {
        const Eigen::VectorXd s = a.jacobiSvd().singularValues();
        return s[0] / s[s.size() - 1];
    };
    const Eigen::MatrixXd second = g_y * f_z, third = g_y * (f_y * f_z);
    const Eigen::MatrixXd* const decisive[] = {&g_z, &second, &third};
    const double scale[] = {J.norm(), g_y.norm() * f_z.norm(), g_y.norm() * f_y.norm() * f_z.norm()};
    for (int index = 1; index <= 3; ++index) {
        if (decisive[index - 1]->norm() <= rounding * scale[index - 1]) continue;
        const double kappa = condition(*decisive[index - 1]);
        if (!(kappa * rounding < 1)) break;
        return {index, index, kappa};
    }
    throw std::domain_error("hessenberg_index: not a Hessenberg form of index 1, 2 or 3 at this state");
}

}  // namespace stagecraft
