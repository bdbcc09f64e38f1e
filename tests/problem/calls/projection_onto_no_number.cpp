// SPDX-License-Identifier: BSL-1.0
// says: projection_onto<M>(g): give M, the number of equations
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/dae/projection.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto turn = [](double, const Vector2d& y, Vector2d& f) { f << -y[1], y[0]; };
const auto circle = [](double, const auto& y, auto& r) { r[0] = y.squaredNorm() - 1; };

auto run() {
#ifdef RIGHT
    auto keep = stagecraft::projection_onto<1>(circle);
#else
    auto keep = stagecraft::projection_onto(circle);
#endif
    return stagecraft::integrate(stagecraft::radau_iia<2>(), turn, Vector2d(1, 0), 0, 1, {}, keep);
}
