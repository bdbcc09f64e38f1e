// SPDX-License-Identifier: BSL-1.0
// says: sin: a statement on all of R^m needs a polynomial f, on the whole line a rational one; give a box
#include <stagecraft/theory/dynamics/one_sided_lipschitz.hpp>

using namespace stagecraft::theory;

int main() {
    const auto f = [](const auto&, const auto& x, auto& out) { out[0] = sin(x[0]); };
#ifdef RIGHT
    const box<1> where(interval(-1, 1));
    return one_sided_lipschitz_on<1>(f, where).verdict.is_proved() ? 0 : 1;
#else
    return one_sided_lipschitz<1>(f).verdict.is_proved() ? 0 : 1;  // no polynomial: nothing holds on all of R
#endif
}
