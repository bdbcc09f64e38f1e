// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/stability_report.hpp"

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE std::string digits(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.15g", x);
    return buffer;
}

STAGECRAFT_INLINE std::string order_text(const char* name, const std::optional<int>& order) {
    return order ? std::string(", ") + name + " O(h^" + std::to_string(*order) + ")" : "";
}

STAGECRAFT_INLINE std::string reasons(const std::vector<hypothesis>& hypotheses) {
    std::string out;
    for (const auto& h : hypotheses) {
        if (h.verdict.is_proved()) continue;
        out += (out.empty() ? "not: " : "; not: ") + h.name + " (" + h.verdict.reason() + ")";
    }
    return out;
}

STAGECRAFT_INLINE claim prediction_claim(const std::string& problem, const order_prediction& p) {
    if (!p.applies()) {
        return {problem + ": a theorem on the order applies", verdict::refuted(reasons(p.hypotheses))};
    }
    auto orders = order_text("y", p.y) + order_text("z", p.z) + order_text("u", p.u);
    return {problem + ":" + orders.substr(1),
            verdict::proved(p.theorem + (p.note.empty() ? "" : "; " + p.note))};
}

STAGECRAFT_INLINE std::string error_text(const std::vector<epsilon_term>& terms) {
    std::string out;
    for (const auto& t : terms) {
        out += (out.empty() ? "O(" : " + O(") + std::string(t.epsilon == 0 ? "" : "eps ") + "h^" +
               std::to_string(t.h) + ")";
    }
    return out;
}

}  // namespace detail

STAGECRAFT_INLINE std::string text(const std::vector<report_section>& report) {
    std::string out;
    for (const auto& section : report) {
        out += section.title + "\n";
        for (const auto& c : section.claims) out += "  " + c.statement + "  " + c.verdict.text() + "\n";
    }
    return out;
}

}  // namespace stagecraft::theory
