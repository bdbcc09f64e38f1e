// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/theory/judging/enclosed_stability.hpp>
#include <stagecraft/theory/judging/exact_cost.hpp>
#include <stagecraft/theory/judging/rounded_properties.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <stagecraft/theory/models/stage_algebra.hpp>
#include <stagecraft/theory/stability/a_stability.hpp>
#include <stagecraft/theory/stability/algebraic_stability.hpp>
#include <stagecraft/theory/stability/symmetry.hpp>
#include <stagecraft/theory/statements/verdict.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stagecraft::theory {

/// The verdict on one of the properties that a file can claim (tableaux::yes_no_claims), by its name there:
/// decided over exact fields (A- and L-stability unless the fractions are enormous), with enclosures refuted
/// or consistent. Throws std::invalid_argument for another name.
template <class K>
verdict property_of(const subject<K>& s, std::string_view property) {
    const auto& t = s.t;
    if constexpr (exact_scalar<K>) {
        if (property == "stiffly_accurate") return stiffly_accurate(t);
        if (property == "symplectic" || property == "symmetric") {
            const bool idle = std::all_of(t.b.begin(), t.b.end(), [](const K& b) { return b == K(0); });
            if (idle) return verdict::proved("b = 0: y_1 = y_0 for every problem");
            return property == "symplectic" ? symplectic(t) : symmetric(t);
        }
        if (property == "algebraically_stable") return algebraically_stable(t);
        if (property == "A_stable" || property == "L_stable") {
            if (s.strictly_lower && certainly_nonzero(t.b.sum()))
                return verdict::refuted("explicit: R is a polynomial and not constant");
            if (is_costly(s)) {  // a z with |R(z)| > 1, where there is one, is found at once
                const auto e = enclosed(s);
                auto quick = property == "A_stable" ? rounded_a_stable(e) : rounded_l_stable(e);
                if (quick.is_refuted()) return quick;
            }
            if (determinant_bits(s) > longest_exact_determinant)
                return property == "A_stable" ? rounded_a_stable(enclosed(s)) : rounded_l_stable(enclosed(s));
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
