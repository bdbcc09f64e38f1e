// SPDX-License-Identifier: BSL-1.0
// says: radau_iia<3>() has one
// lines: 8
#include <stagecraft/radau_iia_variable.hpp>

auto run() { return stagecraft::radau_iia_variable<3>(); }
