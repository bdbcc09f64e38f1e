// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <tuple>

#include <stagecraft/judge/evidence.hpp>
#include <stagecraft/options.hpp>
#include <stagecraft/step/one_step_method.hpp>

namespace stagecraft {

/// Makes method number k of a run known to its judge, and the run's demands to the method. std::invalid_argument where it
/// cannot serve them.
template <class Step, class System, class Scalar, class Judge>
void prepare_method(Step& method, int k, const System& system, const options<Scalar>& o,
                    const run_demands& demands, Judge& judge) {
    static_assert(one_step_method<Step, System>);
    method.prepare(system, demands);
    if (!demands.fixed) demand_free_steps(method, system.largest_index(), o.continuous);
    const Scalar smooth = method.estimate_ratio(o.rtol);
    judge.prepare(k, smooth);
    if constexpr (Judge::several_methods) {
        static_assert(variable_order_method<Step, System>);
        judge.prepare(
            k,
            {method.count(), method.estimate_power(), least_ratio_of_index(smooth, system.largest_index()),
             method.stages().work(system.total_size())},
            o.rtol);
    }
}

/// The same with all methods that a run chooses from.
template <class Steps, class System, class Scalar, class Judge>
void prepare_methods(Steps& steps, const System& system, const options<Scalar>& o, const run_demands& demands,
                     Judge& judge) {
    int k = 0;
    std::apply([&](auto&... m) { (prepare_method(m, k++, system, o, demands, judge), ...); }, steps);
}

}  // namespace stagecraft
