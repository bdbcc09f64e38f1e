// SPDX-License-Identifier: BSL-1.0
// says: a Nystrom method needs second_order(f) of stagecraft/nystrom.hpp
#include <stagecraft/nystrom.hpp>

using Eigen::Vector2d, Eigen::Vector4d;

stagecraft::nystrom_method<double, 2> verlet() {
    stagecraft::nystrom_method<double, 2> m;
    m.c << 0, 1;
    m.A_bar << 0, 0, 0.5, 0;
    m.b_bar << 0.5, 0;
    m.b << 0.5, 0.5;
    return m;
}

auto run() {
    const auto spring = [](double, const Vector4d& y) -> Vector4d { return -y; };
    return integrate(verlet(), spring, Vector4d(1, 1, 0, 0), 0, 1, {.fixed_step = 0.1});
}
