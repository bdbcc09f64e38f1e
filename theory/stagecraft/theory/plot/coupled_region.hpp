// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/partitioned_file.hpp>
#include <stagecraft/theory/plot/region.hpp>

namespace stagecraft::theory::plot {

/// R(z) of an additive pair on y' = (lambda_E + lambda_I) y with z = h lambda_E for a fixed real z_I = h lambda_I:
/// a polynomial, because the first tableau is explicit and the second lower triangular,
/// R(z) = 1 + (z_I b_I + z b_E)^T sum_k z^k (M A_E)^k M 1 with M = (I - z_I A_I)^{-1}
/// (Ascher, Ruuth and Spiteri 1997 draw its regions). Throws std::invalid_argument for other methods, and
/// where I - z_I A_I is singular.
rational_function coupled_stability_function(const tableaux::partitioned_file& file, double z_implicit);

}  // namespace stagecraft::theory::plot

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/plot/coupled_region-inl.hpp"
#endif
