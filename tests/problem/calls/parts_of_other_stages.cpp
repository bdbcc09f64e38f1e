// SPDX-License-Identifier: BSL-1.0
// says: additive(explicit_part, implicit_part): both must have the same number of stages
// lines: 12
#include <stagecraft/additive.hpp>

auto make(const stagecraft::tableau<double, 2>& e, const stagecraft::tableau<double, 3>& i) {
    return stagecraft::additive(e, i);
}
