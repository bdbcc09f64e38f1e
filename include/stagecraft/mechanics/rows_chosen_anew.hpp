// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/mechanics/independent_constraints.hpp>
#include <stagecraft/mechanics/start.hpp>
#include <stagecraft/observe/event.hpp>

namespace stagecraft {

/// An event at which a run keeps other rows of redundant constraints, where those kept come to depend on each other: `kept` is
/// what independent_constraints<rank> has returned, `system` a formulation of its model, of a size known at compile time:
///
///     const auto kept = independent_constraints<5>(constraint, q);
///     const auto bar = stabilised_index_2(lagrangian<6, 5>(T, V, kept));
///     auto choice = events<decltype(bar)::state>(rows_chosen_anew(kept, bar));
///     integrate(radau_iia<3>(), bar, bar.initial_state(q, v), 0, 5, options, choice);
///
/// Others are chosen where the volume that the kept rows of G span, each made of length 1, falls below a quarter of that of
/// the rows independent_constraints would take. The run goes on as one that begins, from the position nearby that satisfies
/// the constraints (assemble) with their multipliers, which are of other constraints from there on. Where all rows together
/// lose rank (a dead point) there is none to choose, and the run ends in status::constraints_dependent. The choice is that of
/// `kept` and of all its copies: two runs at once need one each. Costs an evaluation of G of all constraints wherever
/// events are looked for. What assemble throws ends the run in status::function_threw.
template <class Kept, class System>
auto rows_chosen_anew(const Kept& kept, const System& system) {
    using state = typename System::state;
    constexpr int n = System::n;
    const auto position = [](const state& y) -> Eigen::Matrix<double, n, 1> { return y.template head<n>(); };
    return event(
        [kept, position](double t, const state& y) {
            return detail::kept_row_margin(kept.gradient_of_all(position(y), t), *kept.rows);
        },
        {.direction = crossing::falling},
        [kept, position, &system](double t, state& y) {
            detail::choose_rows(kept.gradient_of_all(position(y), t), *kept.rows);
            const auto at = assemble(system.model(), position(y), y.template segment<n>(n).eval(), t);
            y = system.initial_state(at.q, at.v, t);
        });
}

}  // namespace stagecraft
