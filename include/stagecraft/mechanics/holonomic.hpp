// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <utility>

#include <stagecraft/mechanics/formulations.hpp>

namespace stagecraft {

/// The index-3 system of a holonomic model, state (q, v, lambda).
template <class Scalar = double, fixed_size_model Model>
requires holonomic_model<Model> index_3_dae<Model, Scalar> index_3(Model model) {
    return index_3_dae<Model, Scalar>(std::move(model));
}

/// Its stabilised index-2 formulation, state (q, v, lambda, mu), mu(0) = 0.
template <class Scalar = double, fixed_size_model Model>
requires holonomic_model<Model> stabilised_dae<Model, Scalar> stabilised_index_2(Model model) {
    return stabilised_dae<Model, Scalar>(std::move(model));
}

}  // namespace stagecraft
