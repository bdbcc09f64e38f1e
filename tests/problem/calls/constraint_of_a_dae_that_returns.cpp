// SPDX-License-Identifier: BSL-1.0
// says: semi_explicit: g must be callable as g(t, y, out) or g(t, y, z, out)
// lines: 15
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/semi_explicit.hpp>

const auto f = [](auto, const auto& y, const auto& z, auto& out) { out[0] = z[0] - 2 * y[0]; };
#ifdef RIGHT
const auto g = [](auto, const auto& y, const auto& z, auto& out) { out[0] = z[0] - y[0]; };
#else
const auto g = [](auto, const auto& y, const auto& z) { return z[0] - y[0]; };
#endif

auto run() {
    return stagecraft::integrate(stagecraft::radau_iia<3>(), stagecraft::semi_explicit<1, 1>(f, g),
                                 Eigen::Vector2d(1, 1), 0, 1);
}
