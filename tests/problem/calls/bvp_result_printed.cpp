// SPDX-License-Identifier: BSL-1.0
// says: print r.status, r.message and the values of r.y(t)
// lines: 11
#include <iostream>
#include <stagecraft/bvp/solve.hpp>

void print(const stagecraft::bvp_result<Eigen::Vector2d, Eigen::VectorXd>& r) { std::cout << r; }
