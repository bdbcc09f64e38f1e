// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "solve.hpp"

namespace thesis {

/// The index-2 motion over [0, 1] in 1000 equal steps of Radau IIA-5, and another run on the same grid.
const trajectory& index_2_motion();
trajectory thousand_steps(const setup& s);

/// Largest distances between a regularised motion and the index-2 motion from t = 0.1 on, past every layer, and
/// the largest violation |G q'|.
struct limit_distance {
    double y = 0, lambda = 0, creep = 0;
};
limit_distance past_the_layer(const setup& soft);

/// zeta_0 of (3.54), (3.55) at xi = t/sqrt(eps), from zeta_0(0) = (1, 1) at the leaning angle beta.
Eigen::Vector2d layer_term(double beta, double xi, double c, double d);

/// Largest distances to the index-2 motion during 4 sqrt(eps) of principal damping, from that motion at t = 1/4
/// with lambda + (offset, offset); `corrected` is that of lambda - offset zeta_0. Not from t = 0: there
/// lambda_0' = 0 and the orders are higher by 1/2.
struct layer_distance {
    double y = 0, lambda = 0, corrected = 0;
};
layer_distance within_the_layer(double eps, double offset, double c, double d);

/// The largest |h(y_0, lambda_0)| = |d/dt g(y_0)| along the index-2 motion: zero, up to the error of the run.
double hidden_residual();

/// |y - y_0 - eps Y| and |lambda - lambda_0 - eps Lambda| over the largest |eps Y|, |eps Lambda|, in the maximum
/// from t = 0.1 on; c = d = 2.
struct remainder {
    double y, lambda;
};
remainder after_eps_Y(double eps, double kappa);

/// Definition 1.2 measured on the disc: how the largest changes of y and of lambda by t = 0.1 grow with w, as powers
/// of w, where `rows` components of its index-2 system from `first` on have the defect 1e-6 sin(w t).
struct defect_growth {
    double y, lambda;
};
defect_growth growth_with_frequency(int first, int rows);

}  // namespace thesis
