// SPDX-License-Identifier: BSL-1.0
// says: take index_2(model)
// lines: 8
#include <stagecraft/mechanics/holonomic.hpp>

#include "skate.hpp"

auto run() { return stagecraft::index_3(skate); }
