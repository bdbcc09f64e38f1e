// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/integrate.hpp>
#include <stagecraft/method/additive_method.hpp>
#include <stagecraft/problem/split.hpp>
#include <stagecraft/step/additive_step.hpp>
#include <stagecraft/step/method_set.hpp>

namespace stagecraft::detail {

/// Additive (implicit-explicit) methods run: M y' = f_explicit(t, y) + f_implicit(t, y), of which f_implicit alone is solved for.
///
///     integrate(additive(explicit_part, implicit_part), split(f_explicit, f_implicit), y0, t0, t1, options)
///
/// takes what integrate() takes. Steps are controlled by b_embedded of both parts, or equal (options.fixed_step); the order is
/// that of the coupled conditions, additive_method::order. Between the ends y(t) is Hermite's cubic, of order min(order, 3);
/// with a singular M, whose slopes are not known, the quadratic through both ends and a stage, of order min(order, 2). An
/// observer that asks for it costs an evaluation of f_implicit where the last stage is no slope of it, else none but at t1.
/// M may be any regular matrix, and singular with index 1 where the implicit tableau is stiffly accurate and the equations
/// without a derivative stand in f_implicit alone: the order is that for ordinary differential equations then, at the cost
/// of one more linear system a step where b is not the last row of both tableaux.
template <class Scalar, int Stages>
struct step_for<additive_method<Scalar, Stages>> {
    static constexpr bool named = true, takes_parts = true;
    static constexpr int columns = Stages < 0 || Stages > 3 ? Stages : 3;
    template <class Space>
    using type = additive_step<Stages, Space>;
};

}  // namespace stagecraft::detail
