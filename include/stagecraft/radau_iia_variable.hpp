// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <tuple>

#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/step/method_set.hpp>

namespace stagecraft {

/// Radau IIA of variable order 2 s - 1, s = 3, 5, 7 (orders 5, 9, 13) or any increasing list of stage
/// numbers: integrate(radau_iia_variable(), ...) chooses among them step by step (control/order.hpp).
template <int... Stages>
requires(sizeof...(Stages) > 1) auto radau_iia_variable() {
    return variable_order{std::make_tuple(radau_iia<Stages>()...)};
}
inline auto radau_iia_variable() { return radau_iia_variable<3, 5, 7>(); }

}  // namespace stagecraft
