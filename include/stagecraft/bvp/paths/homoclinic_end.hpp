// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <stagecraft/bvp/judge/growing_period.hpp>
#include <stagecraft/bvp/paths/equilibrium.hpp>
#include <stagecraft/bvp/paths/multipliers.hpp>

namespace stagecraft::detail {

/// How near the orbit y over [0, 1] with the parameters (T, p) comes to an equilibrium, looked for from where it is slowest.
template <class Vector, class Parameters, class Orbit, class Functions>
slow_passage<typename Vector::Scalar> passage_of(Functions& system, const Orbit& y, const Parameters& q,
                                                 const std::vector<typename Vector::Scalar>& mesh) {
    using scalar = typename Vector::Scalar;
    using dense = Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic>;
    constexpr int parts = 8;  // of an interval
    slow_passage<scalar> found;
    found.period = q[0], found.p = q[1];
    scalar slowest(-1), size(0);
    Vector at = y(scalar(0)), start = at;
    for (std::size_t i = 0; i + 1 < mesh.size(); ++i)
        for (int k = 0; k < parts; ++k) {
            const scalar s = mesh[i] + (mesh[i + 1] - mesh[i]) * scalar(k) / scalar(parts);
            const scalar speed = y.derivative(s).norm();
            size = std::max(size, scalar((y(s) - start).norm()));
            if (slowest < scalar(0) || speed < slowest) slowest = speed, at = y(s);
        }
    equilibrium<Vector, Parameters, Functions> rest(system);
    rest.y = at;
    if (!rest.find(q[1])) return found;
    found.distance = std::min(scalar(1), scalar((rest.y - at).norm() / size));
    const Eigen::EigenSolver<dense> solver(rest.f_y, false);
    if (solver.info() != Eigen::Success) return found;
    for (Eigen::Index k = 0; k < rest.y.size(); ++k) {
        const scalar rate = solver.eigenvalues()[k].real();
        scalar& side = rate < scalar(0) ? found.in : found.out;
        const scalar fast = rate < scalar(0) ? scalar(-rate) : rate;
        if (side == scalar(0) || fast < side) side = fast;
    }
    return found;
}

/// What a path of orbits says where it ends, the period growing without bound.
template <class Scalar>
std::string words_of_homoclinic(const Scalar& p) {
    std::ostringstream text;
    text.precision(7);
    text << "the period grows without bound at p = " << p << ", where the orbits become homoclinic";
    return text.str();
}

/// And where the multipliers are lost.
template <class Scalar>
std::string words_of_lost(const std::vector<floquet_multiplier<Scalar>>& multipliers) {
    std::ostringstream text;
    text.precision(2);
    text << "the multipliers are lost: the one that is 1 was found as "
         << multipliers[trivial(multipliers)].value.real() << " beside one of modulus "
         << std::abs(multipliers.front().value);
    return text.str();
}

}  // namespace stagecraft::detail
