// SPDX-License-Identifier: BSL-1.0
// Runs that are told what is known of their problem.
#include <stagecraft/observe/at.hpp>
#include <stagecraft/observe/observers.hpp>

#include "run.hpp"

namespace campaign {

namespace {

struct said_view : ordinary_view {
    std::vector<double> break_points() const { return p->known; }
    bool domain(double t, const VectorXd& y) const { return !p->domain || p->domain(t, y); }
};

template <class Method>
outcome run_told(const Method& method, const problem& p, double tol) {
    outcome o;
    const auto watch = [&](double t, const VectorXd& y, double h) {
        o.worst = std::max(o.worst, error_of(p, t, y, h, tol));
    };
    const auto dose = [&](double t, VectorXd& y) { p.dose(t, y); };
    said_view view;
    view.p = &p;
    const auto r =
        stagecraft::integrate(method, view, p.y0, p.t0, p.t1, {.rtol = tol, .atol = tol, .max_steps = 100000},
                              stagecraft::observers(stagecraft::at(p.doses, dose), watch));
    o.success = r.ok();
    o.status = stagecraft::name(r.status);
    o.t = r.t;
    o.steps = r.report.steps;
    return o;
}

}  // namespace

outcome run_said(int stages, const problem& p, double tol) {
    return stages == 3 ? run_told(stagecraft::radau_iia<3>(), p, tol)
                       : run_told(stagecraft::radau_iia_variable(), p, tol);
}

}  // namespace campaign
