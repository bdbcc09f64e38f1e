// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/statements/expression_text.hpp"

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE std::string formula::at_least(binding needed, const char* left, const char* right) const {
    return strength >= needed ? text : left + text + right;
}

STAGECRAFT_INLINE std::string formula::latex_behind(binding needed) const {
    return text.starts_with('-') ? "\\bigl(" + text + "\\bigr)" : latex_at_least(needed);
}

STAGECRAFT_INLINE std::string latex_product(const std::string& left, const std::string& right) {
    const bool number = right.starts_with("\\frac") || (!right.empty() && right[0] >= '0' && right[0] <= '9');
    return left + (number ? " \\cdot " : " ") + right;
}

STAGECRAFT_INLINE formula in_source::of(const constant& e) {
    return {e.value.str(), e.value.denominator() == 1 ? atomic : multiplicative};
}

STAGECRAFT_INLINE formula in_latex::of(const constant& e, const place&) {
    const binding strength = sign(e.value) < 0 || e.value.denominator() != 1 ? multiplicative : atomic;
    if (e.value.denominator() == 1) return {e.value.str(), strength};
    return {(sign(e.value) < 0 ? "-\\frac{" : "\\frac{") + exact_number(abs(e.value).numerator(), 1).str() +
                "}{" + exact_number(e.value.denominator(), 1).str() + "}",
            strength};
}

STAGECRAFT_INLINE void in_latex::append(factor_list& factors, formula f) {
    if (!factors.empty() && factors.back().first.text == f.text)
        ++factors.back().second;
    else
        factors.emplace_back(std::move(f), 1);
}

STAGECRAFT_INLINE void in_latex::collect(hat_node_vector, const place& at, factor_list& f) {
    append(f, {"\\hat c_{" + at.index + "}"});
}

STAGECRAFT_INLINE void in_latex::collect(hat_weight_row, const place& at, factor_list& f) {
    append(f, {"\\hat b_{" + at.index + "}"});
}

}  // namespace detail

namespace detail {

STAGECRAFT_INLINE std::string all_of(unsigned free) {
    return free == 0 ? "" : free == 1 ? "u" : free == 2 ? "v" : "u, v";
}

}  // namespace detail

}  // namespace stagecraft::theory
