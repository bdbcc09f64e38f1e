// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace stagecraft::detail {

/// What Floquet multipliers can decide, by their distances from where they change something and by their errors.
template <class Scalar>
struct multiplier_judge {
    /// One multiplier of every periodic orbit is 1. If none is found nearer to it than this, rounding errors times the largest
    /// are as large as 1, or the mesh shows nothing of them: none below the largest is known.
    static constexpr double far_from_1 = 0.1;
    /// An error below this leaves open on which side of the unit circle a multiplier is, but not that it is near.
    static constexpr double small_error = 1e-3;

    static bool lost(const Scalar& distance_from_1) { return !(distance_from_1 <= Scalar(far_from_1)); }
    /// `distance` from the point of the unit circle in question, relative to the modulus where that is above 1; so is `error`.
    static bool known(const Scalar& distance, const Scalar& error) {
        return error < distance || error <= Scalar(small_error);
    }
};

}  // namespace stagecraft::detail
