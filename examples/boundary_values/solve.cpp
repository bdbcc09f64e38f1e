// SPDX-License-Identifier: BSL-1.0
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/families.hpp>

#include "experiments.hpp"

namespace boundary_values {

using linear_result = bvp_result<VectorXd, Eigen::Matrix<double, 0, 1>>;

linear_result solve(const tableau<double>& method, const linear_rhs& f, const linear_conditions& r, double T,
                    const bvp_options<double>& o) {
    return solve_bvp(method, two_point(f, r), 0.0, T, VectorXd(VectorXd::Zero(r.d.size())), o);
}

linear_result solve(const linear_rhs& f, const linear_conditions& r, double T, const bvp_options<double>& o) {
    static const tableau<double> method = gauss(5);
    return solve(method, f, r, T, o);
}

}  // namespace boundary_values
