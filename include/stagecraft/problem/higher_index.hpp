// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace stagecraft {

/// By what options.consistent_start finds the function for components of index 2 and 3, consistent_values(higher_index{},
/// problem, t, y), which costs 60 kB of machine code: where dae/consistent.hpp is included, and no program without it pays.
struct higher_index {};

}  // namespace stagecraft
