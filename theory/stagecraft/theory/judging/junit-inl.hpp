// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/junit.hpp"

#include <algorithm>
#include <string_view>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE std::string one_line(const file_certificate& c) {
    std::string line = c.verdict_in_words();
    for (const finding& f : c.findings) {
        if (f.value && f.name != "stage_order") line += ", " + f.name + " " + std::to_string(*f.value);
        if (f.judgement && f.judgement->standing() == c.overall() &&
            (f.judgement->is_refuted() || f.judgement->is_inconclusive()))
            line +=
                ", " + f.name + (f.claimed ? " claimed " + *f.claimed : "") + ": " + f.judgement->reason();
    }
    if (!c.suspects.empty())
        line += "; " + c.suspects.front().entry + " = " + c.suspects.front().written + " should read " +
                c.suspects.front().suggest;
    return line;
}

STAGECRAFT_INLINE int exit_code(const std::vector<file_outcome>& all) {
    for (const int code : {1, 2, 3})
        if (std::any_of(all.begin(), all.end(), [&](const auto& f) { return f.exit_code == code; }))
            return code;
    return 0;
}

namespace detail {

STAGECRAFT_INLINE std::string xml_escaped(std::string_view text) {
    std::string out;
    for (const char ch : text) {
        if (ch == '&')
            out += "&amp;";
        else if (ch == '<')
            out += "&lt;";
        else if (ch == '>')
            out += "&gt;";
        else if (ch == '"')
            out += "&quot;";
        else
            out += ch >= ' ' && ch < 127 ? ch : ' ';
    }
    return out;
}

}  // namespace detail

STAGECRAFT_INLINE std::string junit_text(const std::vector<file_outcome>& all) {
    const auto count = [&](int code) {
        return std::to_string(
            std::count_if(all.begin(), all.end(), [&](const auto& f) { return f.exit_code == code; }));
    };
    std::string out =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"stagecraft certify\" tests=\"" +
        std::to_string(all.size()) + "\" failures=\"" + count(1) + "\" errors=\"" + count(2) +
        "\" skipped=\"" + count(3) + "\">\n";
    for (const file_outcome& f : all) {
        out += "  <testcase classname=\"certify\" name=\"" + detail::xml_escaped(f.path) + "\"";
        const char* tag = f.exit_code == 1   ? "failure"
                          : f.exit_code == 2 ? "error"
                          : f.exit_code == 3 ? "skipped"
                                             : nullptr;
        out += !tag ? "/>\n"
                    : std::string(">\n    <") + tag + " message=\"" + detail::xml_escaped(f.summary) +
                          "\"/>\n  </testcase>\n";
    }
    return out + "</testsuite>\n";
}

}  // namespace stagecraft::theory
