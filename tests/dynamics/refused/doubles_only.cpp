// SPDX-License-Identifier: BSL-1.0
// says: take t, x and out as auto
#include <stagecraft/theory/dynamics/dissipativity.hpp>

using namespace stagecraft::theory;

int main() {
#ifdef RIGHT
    const auto f = [](const auto&, const auto& x, auto& out) { out[0] = -x[0]; };
#else
    const auto f = [](double, const Eigen::Matrix<double, 1, 1>& x, Eigen::Matrix<double, 1, 1>& out) {
        out[0] = -x[0];
    };
#endif
    return dissipativity_within<1>(f, 1, 1.0).verdict.is_proved() ? 0 : 1;
}
