// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <type_traits>
#include <vector>

namespace stagecraft::detail {

/// (k!)^2/((2 k)! (2 k + 1)!), order being 2 k: of y' = z y the Gauss method of k stages misses that times z^(2 k + 1).
template <class Scalar>
Scalar gauss_error_constant(int order) {
    Scalar constant(1);
    for (int k = 1; k <= order / 2; ++k) constant *= Scalar(k) / Scalar((4 * k - 2) * 2 * (2 * k + 1));
    return constant;
}

/// The eigenvalues of J, those of a 2 x 2 matrix left out where they are real.
template <class Square>
std::vector<std::complex<typename Square::Scalar>> turning_modes(const Square& J) {
    using std::sqrt;
    if constexpr (Square::RowsAtCompileTime == 2) {
        const auto half = (J(0, 0) - J(1, 1)) / 2;
        const typename Square::Scalar mean = J.trace() / 2, d = half * half + J(0, 1) * J(1, 0);
        if (d < 0) return {{mean, sqrt(-d)}};
        return {};
    } else {
        const Eigen::EigenSolver<Square> solver(J, false);
        const auto& z = solver.eigenvalues();
        return {z.data(), z.data() + z.size()};
    }
}

/// h f_y in the middle of interval i of x.
template <class Equations, class Iterate>
auto middle_jacobian(const Equations& equations, const Iterate& x, int i) {
    using scalar = std::decay_t<decltype(x.t[0])>;
    constexpr int N = Equations::wide::RowsAtCompileTime;
    const int n = equations.n(), width = n + equations.np();
    return Eigen::Matrix<scalar, N, N>(x.h(i) *
                                       equations.jacobians(i).middleCols(equations.s() / 2 * width, n));
}

/// No eigenvalue of J is larger: from J^2, which is no larger than it need be where J holds q' = v and fast forces.
template <class Square>
auto largest_rate(const Square& J) {
    using std::sqrt;
    return sqrt(typename Square::Scalar((J * J).cwiseAbs().rowwise().sum().maxCoeff()));
}

/// How far the fastest mode turns and the slowest one of these grows or decays.
template <class Scalar>
struct turn_of_modes {
    Scalar angle, growth;
};
/// Of the modes of J that turn by more than `counts`, and more than they grow or decay; no angle where there are none.
template <class Square>
turn_of_modes<typename Square::Scalar> fastest_turn(const Square& J, const typename Square::Scalar& counts) {
    using std::abs;
    using scalar = typename Square::Scalar;
    turn_of_modes<scalar> turn{scalar(0), std::numeric_limits<scalar>::infinity()};
    if (!(largest_rate(J) > counts)) return turn;
    for (const auto& z : turning_modes(J)) {
        if (!(z.imag() > counts && abs(z.real()) < z.imag())) continue;
        turn.angle = std::max(turn.angle, scalar(z.imag()));
        turn.growth = std::min(turn.growth, scalar(abs(z.real())));
    }
    return turn;
}

/// The angles that a method of this order misses of the modes exp(i w t) of f_y, from one end to the other: in an interval
/// those of Gauss methods miss gauss_error_constant (h w)^(order + 1). 0 where the modes that turn grow or decay, or mass()
/// stands before y'.
template <class Equations, class Iterate>
auto missed_phase(const Equations& equations, const Iterate& x, int order) {
    using std::abs;
    using std::pow;
    using scalar = std::decay_t<decltype(x.t[0])>;
    if (!equations.mass().identity()) return scalar(0);
    const scalar constant = gauss_error_constant<scalar>(order), power(order + 1),
                 counts = pow(scalar(1 / (constant * scalar(1000 * x.intervals()))), scalar(1 / power));
    scalar angle(0), growth(0);
    for (int i = 0; i < x.intervals(); ++i) {
        const auto turn = fastest_turn(middle_jacobian(equations, x, i), counts);
        if (!(turn.angle > scalar(0))) continue;
        angle += std::min(scalar(constant * pow(turn.angle, power)), scalar(1));
        growth += turn.growth;
    }
    return growth < scalar(10) ? angle : scalar(0);
}

}  // namespace stagecraft::detail
