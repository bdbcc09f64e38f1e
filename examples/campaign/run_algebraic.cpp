// SPDX-License-Identifier: BSL-1.0
#include <stdexcept>

#include "run.hpp"

campaign::outcome campaign::run_algebraic(int stages, const problem& p, double tol) {
    return run_with<algebraic_view>(stages, p, tol);
}

Eigen::VectorXd campaign::end_state(const problem& p, double tol) {
    algebraic_view view;
    view.p = &p;
    const auto r =
        stagecraft::integrate(stagecraft::radau_iia<7>(), view, p.y0, p.t0, p.t1, {.rtol = tol, .atol = tol});
    if (!r.ok()) throw std::runtime_error("campaign: a reference run failed");
    return r.y;
}
