// SPDX-License-Identifier: BSL-1.0
// says: semi_explicit: f takes out by value, or const, and what it writes is lost: write `Vector& out` or `auto& out`
// says: semi_explicit: g takes out by value, or const, and what it writes is lost: write `Vector& out` or `auto& out`
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/semi_explicit.hpp>

using V1 = Eigen::Matrix<double, 1, 1>;
using Eigen::Vector2d;

#ifdef RIGHT
using written = Vector2d&;
using constraint_values = V1&;
#else
using written = Vector2d;
using constraint_values = V1;
#endif

const auto f = [](double, const Vector2d& y, const V1& z, written out) { out << y[1], z[0]; };
const auto f_in_place = [](double, const Vector2d& y, const V1& z, Vector2d& out) { out << y[1], z[0]; };
const auto g = [](double, const Vector2d& y, const V1& z, V1& out) { out[0] = y[0] - z[0]; };
const auto g_of_y = [](double, const Vector2d& y, constraint_values out) { out[0] = y[0]; };

auto with_f = stagecraft::semi_explicit<2, 1>(f, g);
auto with_g = stagecraft::semi_explicit<2, 1>(f_in_place, g_of_y);
