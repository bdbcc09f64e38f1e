// SPDX-License-Identifier: BSL-1.0
// says: sparse_blocks<double>>(problem)
// lines: 8
#include <stagecraft/linear/sparse_blocks.hpp>
#include <stagecraft/problem/with.hpp>

const auto f = [](double, const Eigen::VectorXd& y, Eigen::VectorXd& out) { out = -y; };

auto run() { return stagecraft::with_linear_solver<stagecraft::sparse_blocks>(f); }
