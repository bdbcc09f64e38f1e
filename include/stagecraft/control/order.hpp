// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace stagecraft {

/// Chooses among `Count` methods ordered by stages; with one method there is nothing to hold and to decide.
template <class Scalar, int Count>
class order_controller {
  public:
    int current() const { return 0; }
};

}  // namespace stagecraft
