// SPDX-License-Identifier: BSL-1.0
// says: sin: a statement on all of R^m needs a polynomial f, on the whole line a rational one; give a box
#include <stagecraft/theory/dynamics/dissipativity.hpp>

using namespace stagecraft::theory;

int main() {
    const auto f = [](const auto&, const auto& x, auto& out) {
        out[0] = x[1];
        out[1] = -sin(x[0]) - x[1];
    };
#ifdef RIGHT
    return dissipativity_within<2>(f, 1, 1.0).verdict.is_proved() ? 0 : 1;
#else
    return dissipativity<2>(f, 1).verdict.is_proved() ? 0 : 1;
#endif
}
