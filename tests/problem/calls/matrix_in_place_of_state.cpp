// SPDX-License-Identifier: BSL-1.0
// says: y0 must be a column vector
// says: a matrix is one as Y.reshaped()
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Matrix2d;

const auto problem = [](double, const Matrix2d& y, Matrix2d& f) { f = -y * y; };

auto run() {
    const Matrix2d y0 = Matrix2d::Identity();
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, y0, 0, 1);
}
