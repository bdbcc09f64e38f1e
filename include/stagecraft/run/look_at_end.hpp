// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/options.hpp>
#include <stagecraft/problem/domain_border.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/run/end_slope.hpp>
#include <stagecraft/run/step_plan.hpp>

namespace stagecraft {

/// Where a step would end: not looked at, where f is finite, beside such a state by less than a tolerance; or where no step
/// may end, since f is not finite or the problem's domain() excludes it.
enum class domain_end { unknown, inside, beside, not_finite, outside };

/// Clips y where the problem says so, and counts.
template <class System, class Vector, class Scalar>
long clip(System& system, Vector& y, const options<Scalar>& o) {
    return system.clip(y, [&o](Eigen::Index i) { return absolute_tolerance(o, i); });
}

/// Looks at f at the end y1 of a step from y, once f has not been finite in the run, or where a component passes zero within
/// the tolerance: one evaluation, which the next step would make. Then asks the problem's domain(), if it has one, for the
/// state with which the run would go on: clipped if the problem says so. `room` is overwritten.
template <class System, class Vector, class Scalar>
[[gnu::always_inline]] inline domain_end look_at_end(System& system, const planned_step<Scalar>& plan,
                                                     const Vector& y, const Vector& y1, const Vector& weights,
                                                     const options<Scalar>& o, bool fixed, Vector& room) {
    domain_end end = domain_end::unknown;
    if constexpr (System::sums_type::complete) {
        auto& border = system.border();
        if (border.watched() || (!fixed && border.may_be_passed(y, y1, weights))) {
            if (!border.admits(system, plan.t_next, y1, plan.h)) return domain_end::not_finite;
            end = border.moved() ? domain_end::beside : domain_end::inside;
        }
    }
    if constexpr (System::excludes_states) {
        room = y1;
        if constexpr (System::sums_type::complete)
            if (end == domain_end::beside) room = system.border().end();
        clip(system, room, o);
        if (!system.inside(plan.t_next, room)) return domain_end::outside;
    }
    return end;
}

/// The end y1 of an accepted step moves into the domain, and with it the end of the continuous solution: to the state inside
/// that has been found beside it, and where the problem clips, to zero. True if it has moved. `room` is overwritten.
template <class System, class Vector, class Scalar, class Output>
bool move_inside(System& system, domain_end end, const options<Scalar>& o, Vector& y1, end_slope<Vector>& f,
                 Output* now, Vector& room, report<Scalar>& counts) {
    bool moved = false;
    const auto move = [&](const Vector& to) {
        if (now != nullptr) now->move_end(to - y1);
        y1 = to;
        f.forget();
        moved = true;
    };
    if constexpr (System::sums_type::complete)
        if (end == domain_end::beside) {
            move(system.border().end());
            f.take_right(system.border().value());
        }
    if constexpr (System::clips) {
        room = y1;
        const long clipped = clip(system, room, o);
        counts.clipped += clipped;
        if (clipped > 0) move(room);
    }
    return moved;
}

/// The end y of the step `last`, which has been accepted without a look, and where f is not finite, moves inside. Where that
/// would take more than a tolerance it goes back to where that step began, t with it: false.
template <class System, class Vector, class Scalar, class Output>
[[gnu::noinline, gnu::cold]] bool mend_start(System& system, Scalar& t, Vector& y, const Scalar& h,
                                             const Vector& weights, Output& last, end_slope<Vector>& f) {
    auto& border = system.border();
    border.lies_near(last.y0(), weights);
    const bool good = border.admits(system, t, y, h);
    if (good && border.moved()) {
        last.move_end(border.end() - y);
        y = border.end();
    }
    if (good)
        f.take_right(border.value());
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
