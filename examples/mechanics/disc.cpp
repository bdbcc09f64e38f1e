// SPDX-License-Identifier: BSL-1.0
// The thesis' disc that rolls without slip: velocity constraints.
#include <problems/rolling_disc/disc.hpp>

#include "body.hpp"

namespace mechanics {

body disc() {
    return describe("disc", rolling_disc::disc<>(), rolling_disc::disc<long double>(),
                    rolling_disc::initial_position(), rolling_disc::initial_velocity(), 1);
}

}  // namespace mechanics
