// SPDX-License-Identifier: BSL-1.0
// says: semi_explicit<n, m>(f, g): give n, the number of components of y, and m
// lines: 8
#include <stagecraft/problem/semi_explicit.hpp>

const auto f = [](const auto&, const auto& y, const auto& z, auto& out) { out[0] = z[0] - y[0]; };
const auto g = [](const auto&, const auto& y, const auto& z, auto& out) { out[0] = z[0] + y[0]; };

auto problem = stagecraft::semi_explicit<1>(f, g);
