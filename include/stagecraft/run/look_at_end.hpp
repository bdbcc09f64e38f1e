// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <limits>

#include <stagecraft/judge/evidence.hpp>
#include <stagecraft/problem/domain_border.hpp>
#include <stagecraft/run/end_slope.hpp>
#include <stagecraft/run/step_plan.hpp>

namespace stagecraft {

/// Where a step would end: not looked at, where f is finite, beside such a state by less than a tolerance, or where no step
/// may end.
enum class domain_end { unknown, inside, beside, outside };

/// Looks at f at the end y1 of a step from y, once f has not been finite in the run, or where a component passes zero within
/// the tolerance. One evaluation, which the next step would make.
template <class System, class Vector, class Scalar>
[[gnu::always_inline]] inline domain_end look_at_end(System& system, const planned_step<Scalar>& plan,
                                                     const Vector& y, const Vector& y1, const Vector& weights,
                                                     bool fixed) {
    if constexpr (!System::sums_type::complete) {
        return domain_end::unknown;
    } else {
        auto& border = system.border();
        if (!border.watched() && (fixed || !border.may_be_passed(y, y1, weights))) return domain_end::unknown;
        if (!border.admits(system, plan.t_next, y1, plan.h)) return domain_end::outside;
        return border.moved() ? domain_end::beside : domain_end::inside;
    }
}

/// What is said of a step that ends outside: half of it, as after stage equations that could not be solved.
template <class Scalar>
verdict<Scalar> outside_domain(const planned_step<Scalar>& plan) {
    return {false, std::numeric_limits<Scalar>::quiet_NaN(), plan.h / 2};
}

/// y1 moves to the state inside that has been found beside it, and with it the end of the continuous solution.
template <class System, class Vector, class Output>
void move_inside(System& system, Vector& y1, end_slope<Vector>& f, Output* now) {
    if constexpr (System::sums_type::complete) {
        const auto& border = system.border();
        if (now != nullptr) now->move_end(border.end() - y1);
        y1 = border.end();
        f.take_right(border.value());
    }
}

/// The end y of the step `last`, which has been accepted without a look, and where f is not finite, moves inside. Where that
/// would take more than a tolerance it goes back to where that step began, t with it: false.
template <class System, class Vector, class Scalar, class Output>
[[gnu::noinline, gnu::cold]] bool mend_start(System& system, Scalar& t, Vector& y, const Scalar& h,
                                             const Vector& weights, Output& last, end_slope<Vector>& f) {
    auto& border = system.border();
    border.lies_near(last.y0(), weights);
    const bool good = border.admits(system, t, y, h);
    if (good)
        move_inside(system, y, f, &last);
    else
        t = last.t0(), y = last.y0();
    f.stepped();
    border.lies_near(y, weights);
    return good;
}
/// True if f is finite at (t, y), where the step `last` has ended and another begins, or beside it.
template <class Step, class System, class Vector, class Scalar, class Norm, class Output>
[[gnu::always_inline]] inline bool starts_inside(Step& method, System& system, Scalar& t, Vector& y,
                                                 const Scalar& h, Norm& norm, Output* last,
                                                 end_slope<Vector>& f) {
    if constexpr (System::sums_type::complete)
        if (!all_finite(f.left(system, t, y), system.size()) && last != nullptr) [[unlikely]] {
            const bool mended = mend_start(system, t, y, h, norm.of_state(), *last, f);
            norm.at(y);
            method.replaced();
            return mended;
        }
    return true;
}

}  // namespace stagecraft
