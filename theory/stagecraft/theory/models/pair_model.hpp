// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/models/stage_algebra.hpp>
#include <stdexcept>
#include <utility>

namespace stagecraft::theory {

/// Two tableaux with the same number of stages as one stage algebra: the first is the model itself (A, b, c of
/// an expression), the second its hat() (A_hat, b_hat, c_hat). Both keep stage vectors in the same basis.
template <stage_algebra M>
class pair_model : public M {
  public:
    /// Throws std::invalid_argument where the numbers of stages differ.
    constexpr pair_model(M first, M second) : M(std::move(first)), hat_(std::move(second)) {
        if (this->stages() != hat_.stages())
            throw std::invalid_argument("second: has another number of stages than the first");
    }
    constexpr const M& hat() const { return hat_; }

  private:
    M hat_;
};

}  // namespace stagecraft::theory
