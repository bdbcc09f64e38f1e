// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <utility>

namespace stagecraft::detail {

/// Where two paths of solutions cross, G = 0 is singular, but the problem is regular once a condition r_k that depends on
/// the others there gives way to the amount a of the kernel's direction (Lyapunov-Schmidt). Its solutions form a
/// surface over (s, a), s being the arclength, and F(s, a) = r_k on it vanishes on the paths: they cross at a
/// saddle of F. Newton's iteration on grad F = 0; grad F comes from the factors, the second derivatives from
/// differences of it.
///
/// solve(s, a, grad) finds the solution, writes grad F and returns whether it could. On success `at` is the saddle
/// and `other` the direction in the plane (s, a) of the path that is not close to a = 0.
template <class Scalar>
class saddle_search {
  public:
    using pair = Eigen::Matrix<Scalar, 2, 1>;
    using square = Eigen::Matrix<Scalar, 2, 2>;

    pair at = pair::Zero(), other = pair::Zero();
    Scalar change{0};  ///< of F by the last step of the iteration

    template <class Solve>
    bool run(Solve&& solve, const Scalar& reach) {
        using std::abs;
        const Scalar d = Scalar(1) / 1000;
        square H;
        for (int c = 0; c < 2; ++c) {
            pair step = pair::Zero(), up, down;
            step[c] = d;
            if (!solve(step, up) || !solve(pair(-step), down)) return false;
            H.col(c) = (up - down) / (2 * d);
        }
        const Scalar mixed = (H(0, 1) + H(1, 0)) / 2;
        H(0, 1) = H(1, 0) = mixed;
        const Scalar determinant = H(0, 0) * H(1, 1) - mixed * mixed;
        if (!(determinant < Scalar(0))) return false;
        Scalar size = reach;
        for (int k = 0; k < 12; ++k) {
            pair gradient;
            if (!solve(at, gradient)) return false;
            const pair step((H(1, 1) * gradient[0] - mixed * gradient[1]) / determinant,
                            (H(0, 0) * gradient[1] - mixed * gradient[0]) / determinant);
            at -= step;
            change = abs(gradient.dot(step)) / 2;
            if (!(at.norm() <= reach)) return false;
            // Rounding errors end it, or the goal; divided differences make the convergence linear, but fast.
            const bool idle = k > 2 && step.norm() > size / 2;
            size = step.norm();
            if (size < Scalar(1e-9) || idle) break;
        }
        if (!(size < Scalar(1e-4))) return false;
        directions(H, determinant);
        return true;
    }

  private:
    /// Of the two lines on which the quadratic form H vanishes, the one farther from (1, 0).
    void directions(const square& H, const Scalar& determinant) {
        using std::abs;
        using std::sqrt;
        const Scalar root = sqrt(-determinant);
        // H00 x^2 + 2 H01 x y + H11 y^2 = 0 for (x, y) = (-H01 -+ root, H00) and (H11, -H01 -+ root).
        Scalar least(2);
        for (const Scalar& sign : {Scalar(1), Scalar(-1)}) {
            pair line(-H(0, 1) + sign * root, H(0, 0));
            const pair same(H(1, 1), -H(0, 1) - sign * root);
            if (same.squaredNorm() > line.squaredNorm()) line = same;
            line /= line.norm();
            if (abs(line[0]) < least) least = abs(line[0]), other = line;
        }
    }
};

}  // namespace stagecraft::detail
