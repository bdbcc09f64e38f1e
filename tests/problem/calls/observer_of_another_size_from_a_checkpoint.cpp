// SPDX-License-Identifier: BSL-1.0
// says: integrate(method, problem, checkpoint, t1, options, observer): the observer must be
// lines: 11
#include <stagecraft/checkpoint.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d, Eigen::Vector3d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run(const stagecraft::checkpoint<Vector2d>& from, double& last) {
#ifdef RIGHT
    const auto keep = [&](double, const Vector2d& y) { last = y[1]; };
#else
    const auto keep = [&](double, const Vector3d& y) { last = y[1]; };
#endif
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, from, 1, {}, keep);
}
