// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stagecraft::tableaux {

/// The families with rational nodal polynomial. Radau I is collocation on the left Radau nodes (c_1 = 0),
/// Radau II the method with D(s) on the right ones (c_s = 1): Butcher's two of 1964, neither A-stable.
/// The others as in Hairer-Wanner II, section IV.5.
enum class family { gauss, radau_i, radau_ia, radau_ii, radau_iia, lobatto_iiia, lobatto_iiib, lobatto_iiic };

/// Every family, in the order in which it is listed.
inline constexpr std::array<family, 8> all_families{
    family::gauss,     family::radau_i,      family::radau_ia,     family::radau_ii,
    family::radau_iia, family::lobatto_iiia, family::lobatto_iiib, family::lobatto_iiic};

/// The name used on the command line, in files and in the names of functions: "radau_iia".
constexpr std::string_view name(family f) {
    switch (f) {
        case family::gauss:
            return "gauss";
        case family::radau_i:
            return "radau_i";
        case family::radau_ia:
            return "radau_ia";
        case family::radau_ii:
            return "radau_ii";
        case family::radau_iia:
            return "radau_iia";
        case family::lobatto_iiia:
            return "lobatto_iiia";
        case family::lobatto_iiib:
            return "lobatto_iiib";
        case family::lobatto_iiic:
            return "lobatto_iiic";
    }
    throw std::invalid_argument("family: not an enumerator");
}

/// "gauss, radau_i, ...": for messages that say what is allowed.
std::string family_names();

/// The family of that name. Throws std::invalid_argument, listing the names, for any other text.
family family_from_name(std::string_view text);

/// How nodes determine A, once b is the interpolatory quadrature on them (Hairer-Wanner II.IV.5):
/// collocation by C(s); adjoint by D(s), which is collocation's adjoint for <u, v> = b^T(u v); lobatto_iiic
/// by C(s-1) and first column b_1 (1, ..., 1)^T, which needs the node 0.
enum class construction { collocation, adjoint, lobatto_iiic };

constexpr std::string_view name(construction rule) {
    return rule == construction::collocation ? "collocation"
           : rule == construction::adjoint   ? "adjoint"
                                             : "lobatto_iiic";
}

constexpr construction construction_of(family f) {
    switch (f) {
        case family::gauss:
        case family::radau_i:
        case family::radau_iia:
        case family::lobatto_iiia:
            return construction::collocation;
        case family::radau_ia:
        case family::radau_ii:
        case family::lobatto_iiib:
            return construction::adjoint;
        case family::lobatto_iiic:
            return construction::lobatto_iiic;
    }
    throw std::invalid_argument("family: not an enumerator");
}

/// Least number of stages: 2 for Lobatto, which has both ends as nodes, 1 for the others.
constexpr int least_stages(family f) {
    return f == family::lobatto_iiia || f == family::lobatto_iiib || f == family::lobatto_iiic ? 2 : 1;
}

/// Throws std::invalid_argument, naming the least number, where the family has no member with s stages.
void require_stages(family f, int s);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/family-inl.hpp"
#endif
