// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <limits>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/family.hpp>

namespace stagecraft::tool {

/// What Hairer-Wanner II, tables IV.5.13 and IV.12.1 say of a family's s-stage member.
inline stagecraft::facts family_facts(tableaux::family f, int s) {
    using tableaux::family;
    stagecraft::facts known;
    const double alternating = s % 2 == 0 ? 1 : -1;
    switch (f) {
        case family::gauss:
            known = {.order = 2 * s,
                     .stage_order = s,
                     .symplectic = true,
                     .symmetric = true,
                     .r_infinity = alternating};
            break;
        case family::radau_ia:
            known = {.order = 2 * s - 1, .stage_order = s - 1};
            break;
        case family::radau_iia:
            known = {.order = 2 * s - 1, .stage_order = s};
            break;
        case family::lobatto_iiia:
            known = {.order = 2 * s - 2, .stage_order = s, .symmetric = true, .r_infinity = -alternating};
            break;
        case family::lobatto_iiib:
            known = {.order = 2 * s - 2, .stage_order = s - 2, .symmetric = true, .r_infinity = -alternating};
            break;
        case family::lobatto_iiic:
            known = {.order = 2 * s - 2, .stage_order = s - 1};
            break;
        default:
            throw std::invalid_argument("family: " + std::string(name(f)) +
                                        " has no generated header, allowed: gauss, radau_ia, radau_iia, "
                                        "lobatto_iiia, lobatto_iiib, lobatto_iiic");
    }
    known.a_stable = true;
    known.l_stable = f == family::radau_ia || f == family::radau_iia || f == family::lobatto_iiic;
    known.algebraically_stable = known.l_stable || f == family::gauss;
    known.stiffly_accurate = f == family::radau_iia || f == family::lobatto_iiia || f == family::lobatto_iiic;
    return known;
}

}  // namespace stagecraft::tool
