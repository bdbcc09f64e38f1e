// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <type_traits>

#include <stagecraft/method/coloured_order.hpp>
#include <stagecraft/method/step_doubling.hpp>
#include <stagecraft/method/structure.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>
#include <stagecraft/tableau.hpp>

namespace stagecraft {

/// An additive (implicit-explicit) Runge-Kutta method: two tableaux of as many stages, for
/// M y' = f_explicit(t, y) + f_implicit(t, y). Made by additive().
template <class Scalar, int Stages = dynamic>
struct additive_method {
    using scalar = Scalar;
    tableau<Scalar, Stages> explicit_part, implicit_part;
    int order = 0;           ///< of both together, found by all trees of two colours, at most six
    int embedded_order = 0;  ///< the same of b_embedded; 0 where there is none

    int stages() const { return implicit_part.stages(); }
};

namespace detail {

/// The same tableau with a number of stages that is known at run time, or the one there is.
template <int Stages, class Scalar, int Own>
tableau<Scalar, Stages> with_stages(const tableau<Scalar, Own>& m) {
    if constexpr (Stages == Own)
        return m;
    else
        return {m.A, m.b, m.c, m.b_embedded, m.facts};
}

template <class Scalar, int Stages>
void demand_parts(const tableau<Scalar, Stages>& e, const tableau<Scalar, Stages>& i) {
    const auto demand = [](bool good, const char* what) {
        if (!good) throw std::invalid_argument(what);
    };
    demand(e.stages() == i.stages(),
           "additive(explicit_part, implicit_part): both must have the same number of stages");
    bool strictly = true, lower = true;
    for (int row = 0; row < e.stages(); ++row)
        for (int column = row; column < e.stages(); ++column) {
            strictly = strictly && e.A(row, column) == Scalar(0);
            lower = lower && (column == row || i.A(row, column) == Scalar(0));
        }
    demand(strictly,
           "additive(explicit_part, implicit_part): explicit_part.A must be strictly lower triangular; the "
           "explicit part comes first");
    demand(lower,
           "additive(explicit_part, implicit_part): implicit_part.A must be lower triangular (DIRK, SDIRK or "
           "ESDIRK)");
    demand((e.b_embedded.size() == 0) == (i.b_embedded.size() == 0),
           "additive(explicit_part, implicit_part): b_embedded must be given in both parts or in neither");
}

}  // namespace detail

/// The additive method of an explicit tableau, for f_explicit, and a diagonally implicit one, for f_implicit, each with its
/// own A, b, c and b_embedded. Its orders are found here, but for rounding (coloured_order): about 3000 s^2 operations.
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

}  // namespace stagecraft
