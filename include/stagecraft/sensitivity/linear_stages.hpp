// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <tuple>

#include <stagecraft/linear/norms.hpp>
#include <stagecraft/stages/newton.hpp>
#include <stagecraft/tableau.hpp>
#include <stagecraft/work.hpp>

namespace stagecraft {

/// The linear system that the stages of a derivative of the solution obey, in the form in which
/// transformed_stages::solve takes a problem: right-hand side number i, in turn, is add(i, v, f).
template <class Scalar, class Mass, class Add>
class linear_stage_system {
  public:
    linear_stage_system(const Mass& mass, int stages, const Add& add)
        : mass_(mass), stages_(stages), add_(add) {}

    template <class Vector>
    void operator()(const Scalar&, const Vector& v, Vector& f) {
        f.setZero();
        add_(next_, v, f);
        next_ = (next_ + 1) % stages_;
    }
    const Mass& mass() const { return mass_; }
    static complete_sums sums() { return {}; }
    template <class F>
    static decltype(auto) measure(work, F&& f) {
        return f();
    }

  private:
    const Mass& mass_;
    int stages_, next_ = 0;
    const Add& add_;
};

/// Iterations for a linear system to rounding; its factors have served Newton's iteration of the same step, or the
/// Jacobians of its stages are near them.
inline constexpr int most_linear_iterations = 200;

/// Solves for Z the stage equations of a step h from `x` whose right-hand sides are linear (add), with the factors
/// that `stages` has, to rounding relative to x and Z in the weighted norm, absolute where that nearly
/// underflows. Where h f_y is so large that rounding errors of its products are larger, the iteration may end with
/// increments below `tolerance`, or below sqrt(eps) where that is more: an iteration that has come so far down, from
/// one, and no further contracts, and the rest is rounding. False if it does not converge.
template <class Stages, class Mass, class Add, class Vector, class StageMatrix>
bool solve_linear_stages(Stages& stages, const Mass& mass, const Add& add, const Vector& x,
                         const typename Vector::Scalar& h, Vector weights,
                         const typename Vector::Scalar& tolerance, StageMatrix& Z) {
    using std::sqrt;
    using scalar = typename Vector::Scalar;
    const int s = stages.stages();
    const scalar eps = std::numeric_limits<scalar>::epsilon();
    linear_stage_system<scalar, Mass, Add> system(mass, s, add);
    long solves = 0;
    Z.setZero();
    const weighted_root_mean_square<Vector> norm(weights);
    // A first iteration shows how large the solution is.
    newton_limits<scalar> limits{scalar(0), scalar(0), scalar(0), 1, true};
    if (stages.solve(system, scalar(0), x, h, norm, limits, Z, solves).end == newton_end::non_finite)
        return false;
    scalar size = x.cwiseProduct(weights).template lpNorm<Eigen::Infinity>();
    for (int i = 0; i < s; ++i) {
        const scalar one = Z.col(i).cwiseProduct(weights).template lpNorm<Eigen::Infinity>();
        if (!(one <= size)) size = one;
    }
    if (size == scalar(0)) return true;
    // What has decayed to the smallest numbers has no relative accuracy left, and 1/size would overflow.
    const scalar smallest = std::numeric_limits<scalar>::min() / (eps * eps);
    weights /= size < smallest ? smallest : size;
    limits = {2 * eps, 4 * eps, 10000 * eps, most_linear_iterations, false, 3};
    const auto converged = [&] {
        return stages.solve(system, scalar(0), x, h, norm, limits, Z, solves).end == newton_end::converged;
    };
    if (converged()) return true;
    const scalar far_down = sqrt(eps);
    limits.noise = tolerance < far_down ? far_down : tolerance;
    return converged();
}

/// The weights d of y1 = y + sum_j d_j Z_j, d = A^-T b.
template <class Tableau>
typename Tableau::vector update_weights(const Tableau& method) {
    using scalar = typename Tableau::scalar;
    const int s = method.stages();
    typename Tableau::vector d(s);
    d.setZero();
    bool last = true;
    for (int j = 0; j < s; ++j) last = last && method.A(s - 1, j) == method.b[j];
    if (last)
        d[s - 1] = scalar(1);
    else
        d.noalias() = method.A_inverse.transpose() * method.b;
    return d;
}

/// The method with A^-T in place of A^-1, and its transformation; b and c are not changed.
template <class Scalar, int Stages>
transformed_tableau<Scalar, Stages> transposed(const transformed_tableau<Scalar, Stages>& method) {
    transformed_tableau<Scalar, Stages> result = method;
    result.A_inverse = method.A_inverse.transpose();
    result.T = method.T_inverse.transpose();
    result.T_inverse = method.T.transpose();
    // Transposed, a pair reads [alpha -beta; beta alpha]: the other sign of its second vector is the usual form.
    for (Eigen::Index k = method.gamma.size() + 1; k < method.stages(); k += 2) {
        result.T.col(k) *= Scalar(-1);
        result.T_inverse.row(k) *= Scalar(-1);
    }
    return result;
}

namespace detail {

/// True if a method damps what a start leaves in algebraic components: |R(infinity)| < 1.
template <class Scalar, int Stages>
bool forgets(const transformed_tableau<Scalar, Stages>& method) {
    using std::abs;
    return abs(Scalar(1) - update_weights(method).sum()) < Scalar(99) / 100;
}
template <class... Methods>
bool forgets(const std::tuple<Methods...>& methods) {
    return std::apply([](const auto&... m) { return (forgets(m) && ...); }, methods);
}

}  // namespace detail

}  // namespace stagecraft
