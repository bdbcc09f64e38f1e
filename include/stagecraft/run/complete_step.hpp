// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/linear/norms.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/run/end_slope.hpp>
#include <stagecraft/run/look_at_end.hpp>
#include <stagecraft/run/step_plan.hpp>

namespace stagecraft {

/// Completes a step from (t, y) to y1 that has been accepted: `now` becomes its continuous solution, where `keeps` or the
/// method wants one, and y1 moves onto the constraints where the method ends beside them, or into the domain. `room` is
/// overwritten. True if there is such a solution.
template <class Step, class System, class Vector, class Scalar>
[[gnu::always_inline]] inline bool complete_step(Step& method, System& system,
                                                 const planned_step<Scalar>& plan, domain_end end,
                                                 const options<Scalar>& o, const Scalar& t, const Vector& y,
                                                 Vector& y1, end_slope<Vector>& f, bool keeps,
                                                 typename Step::output& now, Vector& room,
                                                 report<Scalar>& counts) {
    if constexpr (System::sums_type::complete)
        if (end == domain_end::inside) f.take_right(system.border().value());
    if (method.ends_with_value()) {
        const Vector& f1 = f.right(system, plan.t_next, y1);
        if (all_finite(f1, system.size(), system.sums()))
            method.end(f1);
        else
            method.end_without_value(plan.h, y, y1);
    }
    if constexpr (System::has_explicit_part) method.end_in_parts(system, plan.t_next, plan.h, y, y1);
    const bool has_output = keeps || method.implicit();
    if (has_output)
        method.finish(t, y, plan.h, y1, now);
    else
        now.cover(t, plan.h);
    if constexpr (!System::mass_type::identity)
        if (method.ends_off_constraints()) {
            const Vector& f1 = f.right(system, plan.t_next, y1);
            counts.error_solves += method.end_on_constraints(system, plan.h, f1, now, y1);
            f.retry();
        }
    if (end == domain_end::beside || System::clips)
        if (move_inside(system, end, o, y1, f, has_output ? &now : nullptr, room, counts)) method.replaced();
    return has_output;
}

}  // namespace stagecraft
