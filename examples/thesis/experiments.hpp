// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "page.hpp"

namespace thesis {

/// Section 1.2 and (3.61) along the motion: model assumptions, logarithmic norms, indices.
outcome assumptions();

/// The experiments of the thesis' chapter 4, in its order.
outcome solution();  ///< figures 4.1-4.6: solution, energy, constraint with and without index reduction
outcome orders_of_convergence();  ///< figures 4.7-4.12: equal steps, Radau IIA with 3, 1 and 2 stages
outcome regularisation_error();   ///< figures 4.13-4.16: distance to the index-2 solution as eps -> 0
outcome root_expansion();         ///< (3.50) to (3.61): the error is eps Y; Corollaries 3 and 4
outcome transformation();         ///< figure 4.17: transformed against untransformed principal damping
outcome boundary_layers();        ///< figures 4.18-4.21: a perturbed lambda(0)
outcome regularised_runs();       ///< figures 4.22-4.25: constraint violation and step sizes at eps = 1e-8
outcome run_times();              ///< figure 4.26: cost of every form against eps

/// Beyond the thesis: Gauss, Radau IA, Lobatto IIIC, more stages, and which hypothesis fails.
outcome other_methods();
/// Beyond the thesis: knife edge, sleigh, rolling ball, F as printed, the disc falling flat.
outcome nonholonomic_bodies();

}  // namespace thesis
