// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <limits>
#include <type_traits>

namespace stagecraft {

/// To be called with the vector that a right-hand side is about to write. In builds with assertions (without
/// NDEBUG) it fills the vector with NaN, so that a component which is never written ends the run with
/// status::non_finite rather than with whatever was there before; in others it does nothing.
template <class Vector>
[[gnu::always_inline]] inline void expect_written([[maybe_unused]] Vector& f) {
#ifndef NDEBUG
    using scalar = typename Vector::Scalar;
    if constexpr (std::is_floating_point_v<scalar>) {  // without a division
        scalar* const to = f.data();
        for (auto i = f.size(); i-- > 0;) to[i] = std::numeric_limits<scalar>::quiet_NaN();
    } else {
        const scalar zero(0);  // of any kind of number, dual ones too
        for (auto i = f.size(); i-- > 0;) f[i] = zero / zero;
    }
#endif
}

}  // namespace stagecraft
