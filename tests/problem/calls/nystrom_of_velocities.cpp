// SPDX-License-Identifier: BSL-1.0
// says: this Nystrom method is for q'' = f(t, q): with f(t, q, v) it would have order 1
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
    const auto damped = [](double, const Vector2d& q, const Vector2d& v) -> Vector2d { return -q - v; };
    return integrate(verlet(), stagecraft::second_order(damped), Vector4d(1, 1, 0, 0), 0, 1,
                     {.fixed_step = 0.1});
}
