// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/report.hpp>
#include <stagecraft/stages/newton.hpp>

namespace stagecraft {

/// Solves the stage equations of a step h that Newton's iteration could not solve from its first guess, by
/// homotopy in the step size: the equations of a part of the step are solved first, and their polynomial
/// is the first guess for a longer part (with the Jacobian taken two fifths into it), until the part is the
/// whole step. Only the guess comes from the parts; the equations solved at the end are those of h. For equal
/// steps, which cannot be repeated with a smaller one.
///
/// Returns true with the stages in `now` and what the last iteration told in `newton`; else leaves `newton`
/// as it was. At most 40 systems are tried, down to h/64. Takes storage for one more polynomial and a few
/// states where the size is dynamic; nothing where the first iteration converges.
template <class Scalar, class Step, class System, class Norm>
[[gnu::cold]] bool solve_by_homotopy(Step& method, System& system, const Scalar& t,
                                     const typename Step::vector& y, const Scalar& h, const Norm& norm,
                                     newton_limits<Scalar> limits, typename Step::output& now,
                                     report<Scalar>& counts, newton_outcome<Scalar>& newton) {
    if (system.constant_jacobian()) return false;
    limits.iterations *= 8;  // far from the solution the first iterations contract slowly,
    limits.patience = 2;     // and with index 3 the second increment may be as large as the first
    typename Step::output reached(static_cast<int>(y.size()), method.columns());
    typename Step::vector point = y, f = y, negligible = y;
    for (int i = 0; i < y.size(); ++i) negligible[i] = Scalar(1) / (norm.weights()[i] * Scalar(1000));
    Scalar known(0), target = Scalar(1) / 2;  // parts of h: solved, and to be solved next
    for (int trial = 0; trial < 40; ++trial) {
        const Scalar part = target * h, ahead = known > Scalar(0) ? Scalar(part * 2 / 5) : Scalar(0);
        if (known > Scalar(0))
            reached.evaluate(t + ahead, point);
        else
            point = y;
        if constexpr (System::finite_difference) system.evaluate(t + ahead, point, f);
        system.evaluate_jacobian(t + ahead, point, f, negligible);
        ++counts.factorisations;
        newton_outcome<Scalar> outcome;
        if (method.stages().factor(system, part)) {
            method.guess(known > Scalar(0) ? &reached : nullptr, y, part, now, Scalar(0));
            outcome =
                method.stages().solve(system, t, y, part, norm, limits, now.increments(), counts.solves);
        }
        if (outcome.end == newton_end::converged && target == Scalar(1)) {
            newton = outcome;
            return true;
        }
        if (outcome.end == newton_end::converged) {
            method.advance(y, now, point);
            method.finish(t, y, part, point, now);
            reached = now;
            known = target;
            target = known < Scalar(1) / 2 ? Scalar(known * 2) : Scalar(1);
        } else {
            target = (known + target) / 2;
            if (target - known < Scalar(1) / 64) return false;
        }
    }
    return false;
}

}  // namespace stagecraft
