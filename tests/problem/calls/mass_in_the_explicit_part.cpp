// SPDX-License-Identifier: BSL-1.0
// says: mass(), index(), domain() and break_points() are members of f_implicit; in f_explicit they would be lost
// lines: 8
#include <stagecraft/additive.hpp>
#include <stagecraft/problem/with.hpp>

using Eigen::Vector2d;

auto make() {
    const auto f = [](double, const Vector2d& y, Vector2d& f) { f = -y; };
    return stagecraft::split(stagecraft::with_mass(f, Eigen::Matrix2d(Eigen::Matrix2d::Identity())), f);
}
