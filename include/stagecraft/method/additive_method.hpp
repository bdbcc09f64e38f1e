// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <type_traits>

#include <stagecraft/method/structure.hpp>
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

}  // namespace stagecraft
