// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <tuple>

#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/step/method_set.hpp>

namespace stagecraft {

/// Radau IIA of variable order 2 s - 1, s = 3, 5, 7, 9 (orders 5, 9, 13, 17) or any increasing list of stage
/// numbers: integrate(radau_iia_variable(), ...) chooses among them step by step (judge/order.hpp). More
/// than seven stages are chosen only where rtol <= 1e-10: they gain nothing before.
template <int... Stages>
requires(sizeof...(Stages) > 1) auto radau_iia_variable() {
    return variable_order{std::make_tuple(radau_iia<Stages>()...)};
}
inline auto radau_iia_variable() { return radau_iia_variable<3, 5, 7, 9>(); }

/// One number of stages leaves no choice.
template <int Stages>
auto radau_iia_variable() {
    constexpr bool several = Stages < 0;
    static_assert(
        several,
        "radau_iia_variable<3, 5>() chooses among several numbers of stages; radau_iia<3>() has one");
    return radau_iia_variable<3, 5>();
}

/// The parentheses are missing.
template <class... Arguments>
auto integrate(decltype(radau_iia_variable()) (*)(), const Arguments&... arguments) {
    static_assert(sizeof...(arguments) > 99, "integrate: write radau_iia_variable() with its parentheses");
    return 0;
}

/// Given to fixed_point().
template <class Never = void>
auto fixed_point(decltype(radau_iia_variable()) (*)()) {
    static_assert(detail::never<Never>,
                  "fixed_point(method): the method must be one tableau, radau_iia<3>(), say, with its "
                  "parentheses; radau_iia_variable chooses among several");
    return radau_iia_variable();
}

}  // namespace stagecraft
