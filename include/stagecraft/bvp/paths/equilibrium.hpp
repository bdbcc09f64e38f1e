// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <limits>

namespace stagecraft::detail {

/// An equilibrium of y' = f(y, p), the functions being T f(y, p) with the parameters (T, p).
template <class Vector, class Parameters, class Functions>
class equilibrium {
    using scalar = typename Vector::Scalar;
    using dense = Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic>;

  public:
    Vector y;
    dense f_y;  ///< at y

    explicit equilibrium(Functions& system) : n_(system.size()), system_(system) {}

    /// Newton's iteration for f(y, p) = 0 at fixed p, from y.
    bool find(const scalar& p) {
        scalar last = std::numeric_limits<scalar>::infinity();
        for (int k = 0; k < 30; ++k) {
            const Vector f = at(p);
            const Vector step = f_y.partialPivLu().solve(f);
            const scalar size = step.norm();
            if (!(size < scalar(10) * (1 + y.norm()))) return false;
            y -= step;
            const bool small = size <= scalar(1e-6) * (1 + y.norm());
            if (size == scalar(0) || (small && size >= last / 2)) return at(p), true;
            last = size;
        }
        return false;
    }

  private:
    /// f and f_y at y.
    Vector at(const scalar& p) {
        const Vector f = system_.f(scalar(0), y, Parameters(scalar(1), p)).head(n_);
        f_y = system_.jacobian(scalar(0)).topLeftCorner(n_, n_);
        return f;
    }

    int n_;
    Functions& system_;
};

}  // namespace stagecraft::detail
