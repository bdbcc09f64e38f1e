// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>

namespace stagecraft {

/// h, made a little smaller if t + h would lie beyond t1 by rounding: f need not exist there.
template <class Scalar>
Scalar not_beyond(const Scalar& t, Scalar h, const Scalar& t1) {
    const Scalar direction = Scalar(h < Scalar(0) ? -1 : 1);
    for (;;) {
        const Scalar over = direction * (t + h - t1),
                     least = std::numeric_limits<Scalar>::epsilon() * direction * h;
        if (!(over > Scalar(0))) return h;
        h -= direction * (over > least ? over : least);
    }
}

/// The times of a run with fixed steps. count = 0 where steps are chosen by their errors.
template <class Scalar>
struct equal_steps {
    long count = 0;
    Scalar first{0}, last{0}, h{0};  ///< h with the sign of last - first

    /// The end of step k = 1, ..., count: the last one to the bit.
    Scalar end(long k) const { return k == count ? last : Scalar(first + h * Scalar(k)); }
};

/// As few equal steps as keep each at most `largest` > 0, and one more where rounding leaves that open.
template <class Scalar>
equal_steps<Scalar> divide_equally(const Scalar& t0, const Scalar& t1, const Scalar& largest) {
    using std::abs;
    using std::ceil;
    const long count = static_cast<long>(ceil(abs(t1 - t0) / largest * (Scalar(1) - Scalar(1) / 1000000000)));
    const long n = count > 0 ? count : 1;
    return {n, t0, t1, (t1 - t0) / Scalar(n)};
}

/// The same for a whole run.
/// Throws std::invalid_argument (fixed_step) if their number or their size is beyond the arithmetic.
template <class Scalar>
equal_steps<Scalar> plan_equal_steps(const Scalar& t0, const Scalar& t1, const Scalar& largest) {
    using std::abs;
    using std::ceil;
    const Scalar eps = std::numeric_limits<Scalar>::epsilon(), start = abs(t0), end = abs(t1);
    const Scalar count = ceil(abs(t1 - t0) / largest * (Scalar(1) - Scalar(1) / 1000000000));
    if (!(count < Scalar(1) / eps && count < Scalar(std::numeric_limits<long>::max())))
        throw std::invalid_argument("integrate: fixed_step is too small for t1 - t0");
    const equal_steps<Scalar> steps = divide_equally(t0, t1, largest);
    if (t1 != t0 && !(abs(steps.h) > 4 * eps * (start < end ? start : end)))
        throw std::invalid_argument("integrate: fixed_step is below the resolution of t");
    return steps;
}

}  // namespace stagecraft
