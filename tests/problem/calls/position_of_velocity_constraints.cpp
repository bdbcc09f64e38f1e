// SPDX-License-Identifier: BSL-1.0
// says: take regularised(model, eps, kappa, c, d)
// lines: 8
#include <stagecraft/mechanics/regularisation/regularised_position.hpp>

#include "skate.hpp"

auto run() { return stagecraft::regularised_position(skate, 0.1, 1, 1, 1); }
