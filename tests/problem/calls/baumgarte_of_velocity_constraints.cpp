// SPDX-License-Identifier: BSL-1.0
// says: take index_reduced(model, r)
// lines: 8
#include <stagecraft/mechanics/formulations.hpp>

#include "skate.hpp"

auto run() { return stagecraft::baumgarte(skate, 1, 1); }
