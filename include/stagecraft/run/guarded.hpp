// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <tuple>
#include <type_traits>
#include <utility>

#include <stagecraft/judge/evidence.hpp>
#include <stagecraft/judge/guards/first_step.hpp>
#include <stagecraft/judge/guards/growth.hpp>
#include <stagecraft/judge/guards/index.hpp>
#include <stagecraft/judge/guards/jumps.hpp>
#include <stagecraft/judge/guards/phase.hpp>
#include <stagecraft/judge/guards/rounding.hpp>
#include <stagecraft/step/method_set.hpp>

namespace stagecraft {

/// Names of the library's guards, for without<...>(method). Each stands for a class of problems that error estimates do not
/// judge rightly; its own header says which, and what it costs.
namespace guards {
/// The name of a guard that needs nothing of the problem but its scalar.
template <template <class Scalar> class Guard>
struct of_scalar {
    template <class System>
    using in = Guard<typename System::scalar>;
};
using jumps = of_scalar<jump_guard>;
using output = of_scalar<output_guard>;
using phase = of_scalar<phase_guard>;
using first_step = of_scalar<first_step_guard>;
/// Of components of index 2 and 3: named by index(), or else those that only behave so. M = I has none.
struct index {
    template <class System>
    using in = std::conditional_t<System::may_be_raised, index_guard<typename System::scalar>,
                                  std::conditional_t<System::mass_type::identity, guard_defaults,
                                                     rounding_guard<typename System::scalar>>>;
};
struct growth {
    template <class System>
    using in = growth_guard<System>;
};
}  // namespace guards

/// All of them, in the order in which they look at a step: a guard is added or taken out here.
using standard_guards = std::tuple<guards::index, guards::jumps, guards::output, guards::phase,
                                   guards::first_step, guards::growth>;

namespace detail {

template <class Method>
struct guards_of {
    using type = standard_guards;
    static type of(const Method&) { return {}; }
    static const Method& method(const Method& m) { return m; }
};
template <class Method, class Guards>
struct guards_of<guarded_method<Method, Guards>> {
    using type = Guards;
    static const type& of(const guarded_method<Method, Guards>& m) { return m.guards; }
    static const Method& method(const guarded_method<Method, Guards>& m) { return m.method; }
};

template <class Left, class Guard>
auto all_but(const Guard& guard) {
    if constexpr (std::is_same_v<Left, Guard>)
        return std::tuple<>();
    else
        return std::tuple<Guard>(guard);
}

/// The guard in a run: what a name stands for, or a copy of the user's.
template <class System, class Guard>
auto guard_in(const Guard& guard) {
    if constexpr (std::is_base_of_v<guard_defaults, Guard>)
        return guard;
    else
        return typename Guard::template in<System>();
}
template <class System, class Guards>
auto guards_in(const Guards& guards) {
    return std::apply([](const auto&... g) { return std::tuple(guard_in<System>(g)...); }, guards);
}

}  // namespace detail

/// integrate(guarded(radau_iia<3>(), my_guard()), problem, ...): the library's guards, and behind them one of your own, a
/// class that derives from guard_defaults (judge/evidence.hpp says what it can do). Every run begins with a copy of it.
template <class Method, class Guard>
auto guarded(const Method& method, const Guard& guard) {
    static_assert(std::is_base_of_v<guard_defaults, Guard>,
                  "guarded(method, guard): write `struct my_guard : stagecraft::guard_defaults`");
    using known = detail::guards_of<Method>;
    auto guards = std::tuple_cat(known::of(method), std::tuple<Guard>(guard));
    return guarded_method<std::decay_t<decltype(known::method(method))>, decltype(guards)>{
        known::method(method), std::move(guards)};
}

/// integrate(without<guards::growth>(radau_iia<3>()), problem, ...): a run without one guard, whose work, storage and machine
/// code are left out.
template <class Left, class Method>
auto without(const Method& method) {
    using known = detail::guards_of<Method>;
    auto guards = std::apply([](const auto&... g) { return std::tuple_cat(detail::all_but<Left>(g)...); },
                             known::of(method));
    static_assert(
        std::tuple_size_v<decltype(guards)> < std::tuple_size_v<typename known::type>,
        "without<guard>(method): the method has no such guard; write guards::growth, guards::jumps, "
        "guards::phase, guards::first_step, guards::index or guards::output");
    return guarded_method<std::decay_t<decltype(known::method(method))>, decltype(guards)>{
        known::method(method), std::move(guards)};
}

}  // namespace stagecraft
