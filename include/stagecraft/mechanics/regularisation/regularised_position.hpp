// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <utility>

#include <stagecraft/mechanics/regularisation/regularised.hpp>
#include <stagecraft/mechanics/spring_joints.hpp>

namespace stagecraft {

/// The regularised problem of a model with position constraints, on the level of position. Throws
/// std::invalid_argument as `regularised` does.
template <fixed_size_model Model, class Eps, class Kappa, class C, class D>
requires holonomic_model<Model>
auto regularised_position(Model model, Eps eps, Kappa kappa, C c, D d) {
    const auto k = detail::contact_of(eps, kappa, c, d);
    return regularised_position_problem<Model, typename decltype(k)::scalar>(std::move(model), k);
}

}  // namespace stagecraft
