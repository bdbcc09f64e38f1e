// SPDX-License-Identifier: BSL-1.0
// Boost.odeint's rosenbrock4 with step control.
#pragma once

#include <functional>
#include <vector>

namespace peers {

using values_at = std::function<void(double t, const double* y, double* out)>;

/// Integrates y from t0 to t1 in place; false when odeint throws. `jacobian` writes row by row.
bool rosenbrock4(std::vector<double>& y, double t0, double t1, double rtol, double atol, const values_at& f,
                 const values_at& jacobian, long& steps);

}  // namespace peers
