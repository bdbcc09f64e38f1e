// SPDX-License-Identifier: BSL-1.0
// One run of the library on a random problem.
#pragma once

#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/radau_iia_variable.hpp>
#include <type_traits>

#include "problem.hpp"

namespace campaign {

/// The problem as the library sees it, without a mass matrix and with one.
struct ordinary_view {
    const problem* p;
    void operator()(double t, const VectorXd& y, VectorXd& f) const { p->f(t, y, f); }
    void jacobian(double t, const VectorXd& y, MatrixXd& J) const { p->jacobian(t, y, J); }
};
struct algebraic_view : ordinary_view {
    Eigen::DiagonalMatrix<double, Eigen::Dynamic> mass() const {
        VectorXd ones = VectorXd::Zero(p->y0.size());
        ones.head(p->differential).setOnes();
        return Eigen::DiagonalMatrix<double, Eigen::Dynamic>(ones);
    }
    const std::vector<int>& index() const { return p->index; }
};

template <class View, class Method>
outcome run_by(const Method& method, const problem& p, double tol) {
    outcome o;
    double last = 0;
    const auto watch = [&](double t, const VectorXd& y, double h) {
        last = h;
        if (p.exact_everywhere) o.worst = std::max(o.worst, error_of(p, t, y, h, tol));
    };
    View view;
    view.p = &p;
    const auto r = stagecraft::integrate(method, view, p.y0, p.t0, p.t1,
                                         {.rtol = tol, .atol = tol, .max_steps = 100000}, watch);
    o.success = r.ok();
    o.status = stagecraft::name(r.status);
    o.t = r.t;
    o.steps = r.report.steps;
    if (r.ok() && !p.exact_everywhere) o.worst = error_of(p, r.t, r.y, last, tol);
    return o;
}

template <class View>
outcome run_with(int stages, const problem& p, double tol) {
    switch (stages) {
        case 3:
            return run_by<View>(stagecraft::radau_iia<3>(), p, tol);
        case 5:
            return run_by<View>(stagecraft::radau_iia<5>(), p, tol);
        case 7:
            return run_by<View>(stagecraft::radau_iia<7>(), p, tol);
        default:
            return run_by<View>(stagecraft::radau_iia_variable(), p, tol);
    }
}

}  // namespace campaign
