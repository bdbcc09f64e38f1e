// SPDX-License-Identifier: BSL-1.0
// says: erase both, split(erased(f_explicit), erased(f_implicit))
// lines: 8
#include <stagecraft/problem/erased.hpp>
#include <stagecraft/problem/split.hpp>

using Eigen::VectorXd;

auto make() {
    const auto f = [](double, const VectorXd& y, VectorXd& f) { f = -y; };
    return stagecraft::erased(stagecraft::split(f, f));
}
