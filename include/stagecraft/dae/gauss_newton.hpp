// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include <stagecraft/dae/matrix_pool.hpp>

namespace stagecraft::detail {

/// Damped Gauss-Newton for r(x) = 0: `step(x, r)` returns the correction and the scale of the rows it was
/// computed with. Ends when the correction is at the level of rounding, or below `noise` times the state and no
/// longer decreasing. States come from the pool.
template <class Vector, class Residual, class Step>
int gauss_newton(matrix_pool<Vector>& states, Vector& x, Residual&& residual, Step&& step, int most,
                 const typename Vector::Scalar& noise, const char* what) {
    using std::sqrt;
    using Scalar = typename Vector::Scalar;
    const Scalar eps = std::numeric_limits<Scalar>::epsilon();
    const auto fail = [&](const Scalar& left) {
        std::ostringstream text;
        text << what
             << ": Newton's iteration did not converge from the given values; the largest violation left is "
             << left;
        throw std::runtime_error(text.str());
    };
    Scalar before(-1);
    auto r = residual(x);
    for (int k = 1; k <= most; ++k) {
        if (!r.allFinite())
            throw std::domain_error(std::string(what) + ": the equations are not finite at the given values");
        const auto correction = step(x, r);
        const auto& change = correction.first;
        const auto& scale = correction.second;
        if (!change.allFinite())
            throw std::domain_error(std::string(what) + ": the derivatives are not finite");
        const Scalar size = change.norm(), state = x.norm();
        if (size == Scalar(0)) return k;
        const Scalar violation = scale.cwiseProduct(r).norm();
        auto next = states.take(x.size());
        std::optional<decltype(residual(x))> r_next;
        const auto move = [&](const Scalar& part) {
            next = x + part * change;
            r_next.reset();  // its storage serves again
            r_next.emplace(residual(next));
        };
        move(Scalar(1));
        const bool tiny = size <= noise * state;
        Scalar damping(1);
        while (!tiny && !(scale.cwiseProduct(*r_next).norm() <= violation) && damping > Scalar(1) / 1024) {
            damping /= 2;
            move(damping);
        }
        if (!r_next->allFinite()) fail(r.cwiseAbs().maxCoeff());
        const bool stalled = before >= Scalar(0) && size > before / 2;
        if (!tiny && damping <= Scalar(1) / 1024) {
            if (size <= sqrt(eps) * state) return k;  // the violation is rounding: no step can reduce it
            fail(r.cwiseAbs().maxCoeff());
        }
        x = static_cast<const Vector&>(next);
        r = *r_next;
        if (size <= 8 * eps * state || (tiny && stalled)) return k;
        before = size;
    }
    fail(r.cwiseAbs().maxCoeff());
    return most;
}

}  // namespace stagecraft::detail
