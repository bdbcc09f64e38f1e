// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include <stagecraft/observe/solution.hpp>
#include <stagecraft/tableau.hpp>

namespace stagecraft::detail {

/// The matrix that takes v(t) to v(t + h) by one step of the method for v' = J(t) v.
template <class Scalar, int S, class Jacobian>
auto linear_step(const tableau<Scalar, S>& method, const Scalar& t, const Scalar& h, Eigen::Index n,
                 const Jacobian& J) {
    using dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    const int s = method.stages();
    dense M = dense::Identity(s * n, s * n), r(s * n, n), step = dense::Identity(n, n);
    for (int i = 0; i < s; ++i) {
        const dense at = J(Scalar(t + method.c[i] * h));
        r.middleRows(i * n, n) = at;
        for (int j = 0; j < s; ++j) M.block(i * n, j * n, n, n) -= h * method.A(i, j) * at;
    }
    const dense K = M.partialPivLu().solve(r);
    for (int i = 0; i < s; ++i) step += h * method.b[i] * K.middleRows(i * n, n);
    return step;
}

/// The direction in which orbits of twice the period leave one over [0, 1] that has the multiplier -1: v' = J v with
/// v(1) = -v(0), at the points of a mesh, its largest value being of norm 1. By inverse iteration for the whole orbit at once:
/// the product of the steps would lose it beside large multipliers.
template <class Scalar, int S, class Jacobian>
auto doubling_direction(const tableau<Scalar, S>& method, const std::vector<Scalar>& mesh, Eigen::Index n,
                        const Jacobian& J) {
    using dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    const auto intervals = static_cast<Eigen::Index>(mesh.size()) - 1;
    dense M = dense::Zero(n * intervals, n * intervals);
    for (Eigen::Index k = 0; k < intervals; ++k) {
        const Scalar t = mesh[static_cast<std::size_t>(k)], h = mesh[static_cast<std::size_t>(k) + 1] - t;
        M.block(k * n, k * n, n, n) = linear_step(method, t, h, n, J);
        const bool last = k + 1 == intervals;
        M.block(k * n, last ? 0 : (k + 1) * n, n, n) +=
            (last ? Scalar(1) : Scalar(-1)) * dense::Identity(n, n);
    }
    const auto factors = M.partialPivLu();
    const auto transposed = dense(M.transpose()).partialPivLu();
    column v = column::LinSpaced(M.rows(), Scalar(1), Scalar(2));
    for (int k = 0; k < 4; ++k) {
        v = transposed.solve(v).normalized();
        v = factors.solve(v).normalized();
    }
    dense values(n, intervals + 1);
    for (Eigen::Index k = 0; k < intervals; ++k) values.col(k) = v.segment(k * n, n);
    values.col(intervals) = -values.col(0);
    return dense(values / values.colwise().norm().maxCoeff());
}

/// An orbit run through twice, over [0, 1], and `amplitude` times that direction beside it, there and back.
template <class Vector>
struct doubled_orbit {
    using scalar = typename Vector::Scalar;
    const solution<Vector>& y;
    const std::vector<scalar>& mesh;
    Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic> direction;
    scalar amplitude;

    Vector operator()(const scalar& s) const {
        const scalar twice = std::clamp(scalar(2 * s), scalar(0), scalar(2));
        const bool second = twice > scalar(1);
        const scalar t = second ? scalar(twice - 1) : twice, side = second ? -amplitude : amplitude;
        const auto last = static_cast<std::ptrdiff_t>(mesh.size()) - 1;
        const auto i = std::clamp(std::upper_bound(mesh.begin(), mesh.end(), t) - mesh.begin() - 1,
                                  std::ptrdiff_t(0), last - 1);
        const scalar from = mesh[static_cast<std::size_t>(i)], to = mesh[static_cast<std::size_t>(i) + 1];
        const scalar part = (t - from) / (to - from);
        return y(t) + side * ((1 - part) * direction.col(i) + part * direction.col(i + 1));
    }
};

}  // namespace stagecraft::detail
