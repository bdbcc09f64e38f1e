// SPDX-License-Identifier: BSL-1.0
// says: dense_blocks<double, 3>>(problem)
// lines: 8
#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/problem/with.hpp>

const auto f = [](double, const Eigen::VectorXd& y, Eigen::VectorXd& out) { out = -y; };

auto run() { return stagecraft::with_linear_solver<stagecraft::dense_blocks>(f); }
