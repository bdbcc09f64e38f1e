// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <stagecraft/bvp/judge/regularity_judge.hpp>

namespace stagecraft::detail {

/// The dimension of the kernel of M, and whether the mesh shows it.
struct kernel_found {
    int dimension;
    bool certain;
};

/// Says of each mode whether M may take it to zero, as far as the mesh, rounding errors and, of a nonlinear problem, those of x
/// show. Sizes are those of the answers to conditions of size 1, parts are what an error makes of the mode itself.
template <class Scalar>
struct kernel_judge {
    Scalar epsilon, largest;  ///< largest: the size of the mode that answers most
    bool linear, turns;

    /// Modes that answer less than rounding errors of the largest are nothing but these errors.
    static constexpr int rounding_errors = 1000;
    /// A part of 1/100 by rounding errors, all with signs in favour, is as good as all of it.
    static constexpr double lost_to_rounding = 0.01;
    /// Of a nonlinear problem all modes vanish that answer like the largest: x is only near the family.
    static constexpr int like_the_largest = 1000;

    /// Does it have to be looked at? With a small answer M is regular there.
    bool may_vanish(const Scalar& size) const {
        return !(size < rounding_errors * epsilon * largest) &&
               (turns || !(size < Scalar(regularity_judge<Scalar>::small_answer)));
    }
    /// Is M's value for it lost, whatever the mesh says?
    bool lost(const Scalar& size, const Scalar& rounding_part) const {
        return rounding_part > Scalar(lost_to_rounding) || (!linear && like_the_largest * size > largest);
    }
    /// `part` is what the mesh makes of the mode: 1 where M is singular.
    static void count(const Scalar& part, kernel_found& found) {
        using std::abs;
        const Scalar safe(regularity_judge<Scalar>::safe_part);
        if (!(part < safe)) ++found.dimension;
        if (!(part < Scalar(regularity_judge<Scalar>::small_bound) || abs(part - 1) < safe))
            found.certain = false;
    }
};

}  // namespace stagecraft::detail
