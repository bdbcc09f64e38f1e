// SPDX-License-Identifier: BSL-1.0
// says: centre
#include <stagecraft/theory/dynamics/dissipativity.hpp>

using namespace stagecraft::theory;

int main() {
    const auto f = [](const auto&, const auto& x, auto& out) {
        out[0] = -x[0];
        out[1] = -x[1];
    };
#ifdef RIGHT
    return dissipativity<2>(f, 1, origin<2>()).verdict.is_proved() ? 0 : 1;
#else
    return dissipativity<2>(f, 1, origin<3>()).verdict.is_proved() ? 0 : 1;
#endif
}
