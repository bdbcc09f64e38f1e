// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <stdexcept>
#include <utility>

#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/owned_value.hpp>

namespace stagecraft {

/// A singular perturbation problem y' = f(y, z), eps z' = g(y, z) (Hairer-Wanner II, chapter VI; thesis
/// (3.1)) as a type with
///
///     static constexpr int slow = n, fast = m;
///     template <class S>
///     Eigen::Matrix<S, n, 1> f(const Eigen::Matrix<S, n, 1>& y, const Eigen::Matrix<S, m, 1>& z) const;
///     template <class S>
///     Eigen::Matrix<S, m, 1> g(const Eigen::Matrix<S, n, 1>& y, const Eigen::Matrix<S, m, 1>& z) const;
///
/// Theory asks for mu(g_z) < 0 near the solution of the reduced problem 0 = g(y, z).
template <class Problem>
concept singular_perturbation = Problem::slow >
0 && Problem::fast > 0 &&
    requires(const Problem& p, const Eigen::Matrix<double, Problem::slow, 1>& y,
             const Eigen::Matrix<double, Problem::fast, 1>& z) {
    { p.f(y, z) } -> std::convertible_to<Eigen::Matrix<double, Problem::slow, 1>>;
    { p.g(y, z) } -> std::convertible_to<Eigen::Matrix<double, Problem::fast, 1>>;
};

/// The problem for one eps in the state (y, z), M = diag(1, ..., eps, ...); eps = 0 is the reduced problem,
/// of index 1.
template <singular_perturbation Problem>
class perturbed_problem {
  public:
    static constexpr int n = Problem::slow, m = Problem::fast, size = n + m;

    perturbed_problem(Problem problem, double eps) : problem_(std::move(problem)), eps_(eps) {
        if (!(eps >= 0)) throw std::invalid_argument("perturbed: eps must not be negative");
    }

    template <class T, class S>
    void operator()(const T&, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const Eigen::Matrix<S, n, 1> slow = y.template head<n>();
        const Eigen::Matrix<S, m, 1> fast = y.template tail<m>();
        static_assert(
            detail::owns_numbers<decltype(problem_.f(slow, fast))> &&
                detail::owns_numbers<decltype(problem_.g(slow, fast))>,
            "perturbed: f or g of the problem returns an expression of Eigen's, whose operands may be "
            "gone: write its type, Eigen::Matrix<S, n, 1>, say, or .eval()");
        f.template head<n>() = problem_.f(slow, fast);
        f.template tail<m>() = problem_.g(slow, fast);
    }

    Eigen::Matrix<double, size, size> mass() const {
        Eigen::Matrix<double, size, size> M = Eigen::Matrix<double, size, size>::Identity();
        for (int i = n; i < size; ++i) M(i, i) = eps_;
        return M;
    }

  private:
    Problem problem_;
    double eps_;
};

/// The problem for a given eps >= 0, ready for `integrate`. Throws std::invalid_argument for eps < 0.
template <singular_perturbation Problem>
perturbed_problem<Problem> perturbed(Problem problem, double eps) {
    return {std::move(problem), eps};
}

/// Strong damping of a mechanical model as singular perturbation problem (thesis (3.13)-(3.14)): y = (q, q'),
/// z = lambda, g = c G q' + d ((dG/dt) q' + G M^-1 (F - G^T lambda)).
template <fixed_size_model Model>
struct strongly_damped {
    static constexpr int n = Model::coordinates, slow = 2 * n, fast = Model::constraints;
    Model model;
    double c = 1, d = 1;

    template <class S>
    Eigen::Matrix<S, slow, 1> f(const Eigen::Matrix<S, slow, 1>& y,
                                const Eigen::Matrix<S, fast, 1>& lambda) const {
        Eigen::Matrix<S, slow, 1> result;
        result.template head<n>() = y.template tail<n>();
        result.template tail<n>() = acceleration<S>(y.template head<n>(), y.template tail<n>(), lambda);
        return result;
    }

    template <class S>
    Eigen::Matrix<S, fast, 1> g(const Eigen::Matrix<S, slow, 1>& y,
                                const Eigen::Matrix<S, fast, 1>& lambda) const {
        const coordinate_vector<S, Model> q = y.template head<n>(), v = y.template tail<n>();
        const Eigen::Matrix<S, fast, n> G = model.G(q);
        const coordinate_vector<S, Model> a = acceleration<S>(q, v, lambda);
        const multiplier_vector<S, Model> creep = G * v, rest = G * a,
                                          curvature = constraint_curvature<S>(model, q, v);
        multiplier_vector<S, Model> result;
        for (int i = 0; i < fast; ++i) result[i] = S(c) * creep[i] + S(d) * (curvature[i] + rest[i]);
        return result;
    }

  private:
    template <class S>
    coordinate_vector<S, Model> acceleration(const coordinate_vector<S, Model>& q,
                                             const coordinate_vector<S, Model>& v,
                                             const multiplier_vector<S, Model>& lambda) const {
        const coordinate_vector<S, Model> r = force<S>(model, q, v, S(0)) - model.G(q).transpose() * lambda;
        return mass_inverse<S, Model>(model, q)(r);
    }
};

}  // namespace stagecraft
