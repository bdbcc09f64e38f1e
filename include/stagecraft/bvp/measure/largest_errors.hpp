// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <stagecraft/bvp/measure/error_estimate.hpp>
#include <stagecraft/bvp/result.hpp>
#include <stagecraft/method/legendre_rule.hpp>

namespace stagecraft::detail {

/// The largest estimated error of x relative to threshold + |y|, and of p likewise; the absolute ones are written to `out`.
template <class Equations, class Vector>
auto largest_errors(const error_estimate<Equations>& estimate, const typename Equations::iterate& x,
                    const typename Vector::Scalar& threshold, bvp_error<Vector>& out) {
    using scalar = typename Vector::Scalar;
    using std::abs;
    const int n = static_cast<int>(x.y.rows());
    out.components.setZero(n);
    scalar worst(0);
    const scalar eps = 4 * std::numeric_limits<scalar>::epsilon();
    for (int i = 0; i < x.intervals(); ++i)
        for (int c = 0; c < n; ++c) {
            const scalar bound = estimate.bound(i, c) + eps * abs(x.y(c, i));
            if (bound > out.components[c]) out.components[c] = bound;
            if (bound <= (worst - eps) * threshold) continue;  // nor is it larger relative to threshold + |y|
            const scalar relative = estimate.relative(x, i, c) + eps;
            if (!(relative <= worst))
                worst = relative == relative ? relative : std::numeric_limits<scalar>::infinity();
        }
    out.parameters = estimate.of_parameters();
    for (Eigen::Index k = 0; k < x.p.size(); ++k)
        worst = std::max(worst, scalar(out.parameters[k] / (threshold + abs(x.p[k]))));
    return worst;
}

/// Do all modes change by less than e^(5 s / 4) in an interval, as the Jacobian in its middle says? About that is what s
/// Gauss stages follow; faster ones are those of layers or of stiffness.
template <class Iterate, class System>
bool slow_beside(const Iterate& x, System& system, int s) {
    using std::abs;
    const Eigen::Index n = x.y.rows();
    const auto most = typename System::scalar(25 * s * s) / 16;
    for (int i = 0; i < x.intervals(); ++i) {
        const auto t = (x.t[i] + x.t[i + 1]) / 2;
        system.f(t, ((x.y.col(i) + x.y.col(i + 1)) / 2).eval(), x.p);
        const auto& J = system.jacobian(t);
        for (Eigen::Index c = 0; c < n; ++c) {
            typename System::scalar sum(0);
            for (Eigen::Index d = 0; d < n; ++d) {
                typename System::scalar square(0);
                for (Eigen::Index k = 0; k < n; ++k) square += J(c, k) * J(k, d);
                sum += abs(square);
            }
            if (!(x.h(i) * x.h(i) * sum <= most)) return false;
        }
    }
    return true;
}

/// An estimate of the error between mesh points that costs nothing: the integral of the last term of the Legendre series of
/// the slopes (by the method's own quadrature), largest relative to threshold + |y|.
template <class Equations, class Scalar>
Scalar unresolved(const Equations& equations, const typename Equations::iterate& x, const Scalar& threshold) {
    using std::abs;
    const auto& method = equations.method();
    const int s = equations.s();
    Eigen::Matrix<Scalar, Equations::stages, 1> weights(s);
    std::vector<Scalar> P(static_cast<std::size_t>(s));
    for (int j = 0; j < s; ++j) {
        legendre_values(Scalar(method.c[j]), s - 1, P.data());
        weights[j] = Scalar(2 * s - 1) * method.b[j] * P[s - 1] / Scalar(4 * s);
    }
    Scalar worst(0);
    for (int i = 0; i < x.intervals(); ++i)
        for (Eigen::Index c = 0; c < x.y.rows(); ++c) {
            Scalar last(0);
            for (int j = 0; j < s; ++j) last += weights[j] * x.Z(c, i * s + j);
            const Scalar size = threshold + std::max(abs(x.y(c, i)), abs(x.y(c, i + 1)));
            if (!(abs(last) <= worst * size)) worst = abs(last) / size;
        }
    return worst;
}

/// Can x be within the tolerance, as far as that says? Errors at mesh points are at best the squares of those between.
template <class Equations, class Scalar>
bool resolves(const Equations& equations, const typename Equations::iterate& x, const Scalar& threshold,
              const Scalar& rtol) {
    using std::sqrt;
    return unresolved(equations, x, threshold) <= sqrt(rtol);
}

}  // namespace stagecraft::detail
