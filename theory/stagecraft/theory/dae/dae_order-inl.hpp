// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dae/dae_order.hpp"

#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE verdict decided(bool holds, std::string text) {
    return holds ? verdict::proved(std::move(text)) : verdict::refuted(std::move(text));
}

STAGECRAFT_INLINE hypothesis left_end() {
    return {"the first stage is the left end",
            verdict::proved("a_1j = 0, c_1 = 0, det A_r != 0 of the rest")};
}

STAGECRAFT_INLINE bool all_proved(const std::vector<hypothesis>& list) {
    return std::all_of(list.begin(), list.end(), [](const auto& h) { return h.verdict.is_proved(); });
}

STAGECRAFT_INLINE order_prediction best_of(const std::vector<order_prediction>& all) {
    const order_prediction* best = nullptr;
    for (const auto& p : all) {
        if (!p.applies()) continue;
        if (!best || std::pair(*p.y, p.z.value_or(0)) > std::pair(*best->y, best->z.value_or(0))) best = &p;
    }
    if (best) return *best;
    order_prediction none;
    none.theorem = "none";
    for (const auto& p : all) {
        for (const auto& h : p.hypotheses) {
            const auto known = [&](const auto& other) { return other.name == h.name; };
            if (!h.verdict.is_refuted()) continue;
            if (std::none_of(none.hypotheses.begin(), none.hypotheses.end(), known))
                none.hypotheses.push_back(h);
        }
    }
    none.note = "no theorem applies";
    return none;
}

}  // namespace detail

namespace detail {

STAGECRAFT_INLINE order_prediction theorem::applied() const {
    order_prediction p;
    p.theorem = citation;
    p.hypotheses = hypotheses;
    if (all_proved(hypotheses)) conclusion(p);
    return p;
}

STAGECRAFT_INLINE order_prediction theorem::applied_or_none() const {
    order_prediction p = applied();
    if (!p.applies()) p.note = "no theorem applies";
    return p;
}

}  // namespace detail

}  // namespace stagecraft::theory
