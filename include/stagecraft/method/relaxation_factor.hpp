// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>

namespace stagecraft {

/// The root of `defect` next to 1, which has another one at 0; NaN if there is none between 1/2 and 3/2. By the secant
/// method: some three to five evaluations. `size` is that of the numbers whose difference the defect is, so that what
/// rounding leaves of it is known.
template <class Scalar, class Defect>
Scalar relaxation_factor(const Scalar& size, Defect&& defect) {
    using std::abs;
    const Scalar eps = std::numeric_limits<Scalar>::epsilon(), first = defect(Scalar(1));
    if (abs(first) <= 4 * eps * size) return Scalar(1);
    Scalar x0(1), d0 = first, x = Scalar(1) + Scalar(1) / 1024, best = x0, least = abs(first);
    for (int k = 0; k < 20; ++k) {
        const Scalar d = defect(x);
        if (abs(d) < least) least = abs(d), best = x;
        const Scalar change = d * (x - x0) / (d - d0);
        if (abs(d) <= 4 * eps * size || abs(change) <= 4 * eps) return best;
        x0 = x;
        d0 = d;
        x -= change;
        if (!(abs(x - Scalar(1)) <= Scalar(1) / 2)) break;
    }
    // A defect that is nothing but rounding has no root to be found.
    return least <= 1000 * eps * size ? best : std::numeric_limits<Scalar>::quiet_NaN();
}

}  // namespace stagecraft
