// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/integrate.hpp>
#include <stagecraft/method/additive_method.hpp>
#include <stagecraft/method/coloured_order.hpp>
#include <stagecraft/method/step_doubling.hpp>
#include <stagecraft/problem/split.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>
#include <stagecraft/step/additive_step.hpp>
#include <stagecraft/step/method_set.hpp>

namespace stagecraft {

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
///
/// explicit_part is an explicit tableau, implicit_part a diagonally implicit one, each with its own A, b, c and b_embedded. Their
/// orders are found here, but for rounding (coloured_order): about 3000 s^2 operations.
/// std::invalid_argument where the two do not fit together, or a part is not what its name says.
template <class Scalar, int First, int Second>
auto additive(const tableau<Scalar, First>& explicit_part, const tableau<Scalar, Second>& implicit_part) {
    static_assert(First == Second || First == dynamic || Second == dynamic,
                  "additive(explicit_part, implicit_part): both must have the same number of stages");
    constexpr int stages = First == Second ? First : dynamic;
    additive_method<Scalar, stages> m{detail::with_stages<stages>(explicit_part),
                                      detail::with_stages<stages>(implicit_part)};
    const auto &e = m.explicit_part, &i = m.implicit_part;
    checked(e), checked(i);
    detail::demand_parts(e, i);
    m.order = coloured_order(e, i, e.b, i.b);
    if (e.b_embedded.size() > 0) m.embedded_order = coloured_order(e, i, e.b_embedded, i.b_embedded);
    return m;
}

/// The additive method that takes two half steps of m and estimates their error by a whole one: step_doubling() of both parts.
template <class Scalar, int Stages>
additive_method<Scalar> step_doubling(const additive_method<Scalar, Stages>& m) {
    if (m.order < 1) throw std::invalid_argument("step_doubling: method has order 0");
    const auto e = detail::shared_stages_of(m.explicit_part), i = detail::shared_stages_of(m.implicit_part);
    const detail::shared_stages shared{e.first && i.first, e.last && i.last};
    return additive(detail::doubled(m.explicit_part, m.order, shared),
                    detail::doubled(m.implicit_part, m.order, shared));
}

namespace detail {
struct call_of_additive {
    template <class T>
    static constexpr bool say() {
        static_assert(never<T>,
                      "additive(explicit_part, implicit_part): both must be a tableau with the same scalar "
                      "type, functions with their parentheses");
        return true;
    }
};
}  // namespace detail

/// Of what are no two tableaux.
additive_method<double> additive(detail::refused_call<detail::call_of_additive>, ...);

namespace detail {

/// What runs additive methods.
template <class Scalar, int Stages>
struct step_for<additive_method<Scalar, Stages>> {
    static constexpr bool named = true, takes_parts = true;
    static constexpr int columns = Stages < 0 || Stages > 3 ? Stages : 3;
    template <class Space>
    using type = additive_step<Stages, Space>;
};

}  // namespace detail

}  // namespace stagecraft
