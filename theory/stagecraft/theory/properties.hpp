// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/a_stability.hpp>
#include <stagecraft/theory/algebraic_stability.hpp>
#include <stagecraft/theory/rounded_properties.hpp>
#include <stagecraft/theory/subject.hpp>
#include <stagecraft/theory/symmetry.hpp>
#include <stagecraft/theory/verdict.hpp>
#include <string_view>

namespace stagecraft::theory {

/// The verdict on one of the properties that a file can claim (tableaux::yes_no_claims), by its name there:
/// decided over exact fields, with enclosures refuted or consistent.
/// Throws std::invalid_argument for another name.
template <class K>
verdict property_of(const subject<K>& s, std::string_view property) {
    const auto& t = s.t;
    if constexpr (exact_scalar<K>) {
        if (property == "stiffly_accurate") return stiffly_accurate(t);
        if (property == "symplectic") return symplectic(t);
        if (property == "symmetric") return symmetric(t);
        if (property == "algebraically_stable") return algebraically_stable(t);
        if (property == "A_stable" || property == "L_stable") {
            if (s.strictly_lower && certainly_nonzero(t.b.sum()))
                return verdict::refuted("explicit: R is a polynomial and not constant");
            const auto r = stability_function_of(t);
            return property == "A_stable" ? a_stable(r) : l_stable(r);
        }
    } else {
        if (property == "stiffly_accurate") return rounded_stiffly_accurate(s);
        if (property == "symplectic") return rounded_symplectic(s);
        if (property == "symmetric") return rounded_symmetric(s);
        if (property == "algebraically_stable") return rounded_algebraically_stable(s);
        if (property == "A_stable") return rounded_a_stable(s);
        if (property == "L_stable") return rounded_l_stable(s);
    }
    throw std::invalid_argument("property: unknown name '" + std::string(property) + "'");
}

}  // namespace stagecraft::theory
