// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/file_certificate.hpp"

#include <algorithm>
#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE std::string in_words(const numerical_order& n) {
    return "numerically order " + std::to_string(n.order) + " up to " + n.residual + ", what rounding to " +
           std::to_string(n.digits) + " digits explains";
}

STAGECRAFT_INLINE standing file_certificate::overall() const {
    const auto any = [&](standing s) {
        return std::any_of(findings.begin(), findings.end(),
                           [&](const finding& f) { return f.judgement && f.judgement->standing() == s; }) ||
               std::any_of(partners.begin(), partners.end(),
                           [&](const file_certificate& p) { return p.overall() == s; });
    };
    for (const standing s : {standing::refuted, standing::inconclusive, standing::consistent})
        if (any(s)) return s;
    return standing::proved;
}

STAGECRAFT_INLINE bool file_certificate::nothing_claimed() const {
    return std::none_of(findings.begin(), findings.end(), [](const finding& f) { return f.judgement; }) &&
           std::all_of(partners.begin(), partners.end(),
                       [](const file_certificate& p) { return p.nothing_claimed(); });
}

STAGECRAFT_INLINE std::string file_certificate::verdict() const {
    return nothing_claimed() ? "nothing claimed" : std::string(theory::name(overall()));
}

STAGECRAFT_INLINE std::string file_certificate::verdict_in_words() const {
    return verdict() + (taken_as ? " up to " + taken_as->residual + " (" + taken_as->what + ")" : "");
}

STAGECRAFT_INLINE int file_certificate::exit_code() const {
    const standing s = overall();
    return s == standing::refuted ? 1 : s == standing::inconclusive ? 3 : 0;
}

STAGECRAFT_INLINE const finding* file_certificate::find(std::string_view finding_name) const {
    for (const finding& f : findings)
        if (f.name == finding_name) return &f;
    return nullptr;
}

STAGECRAFT_INLINE nlohmann::ordered_json to_json(const file_certificate& c) {
    nlohmann::ordered_json j{{"name", c.name},
                             {"source", c.source},
                             {"data", c.data},
                             {"stages", c.stages},
                             {"verdict", c.verdict()}};
    for (const finding& f : c.findings) {
        nlohmann::ordered_json entry = nlohmann::ordered_json::object();
        if (f.value) entry["value"] = *f.value;
        if (f.truth)
            entry.update(to_json(*f.truth));
        else if (f.judgement)
            entry.update(to_json(*f.judgement));
        if (f.numerical)
            entry["numerical"] = {{"order", f.numerical->order},
                                  {"residual", f.numerical->residual},
                                  {"digits", f.numerical->digits}};
        if (!f.relative_bound.empty()) entry["relative_bound"] = f.relative_bound;
        if (f.claimed) {
            entry["claimed"] = nlohmann::ordered_json::parse(*f.claimed);
            entry["claim"] = name(f.judgement->standing());
        }
        j[f.name] = std::move(entry);
    }
    if (c.principal_error) j["principal_error"] = to_json(*c.principal_error);
    if (c.error_metrics) j["error_metrics"] = to_json(*c.error_metrics);
    if (c.partners.empty()) add_to_json(c.spectra, j);
    j["failures"] = nlohmann::ordered_json::array();
    for (const failure& f : c.failures)
        j["failures"].push_back({{"condition", f.condition}, {"tree", f.tree}, {"residual", f.residual}});
    j["suspects"] = nlohmann::ordered_json::array();
    for (const suspect& s : c.suspects)
        j["suspects"].push_back({{"entry", s.entry}, {"written", s.written}, {"suggest", s.suggest}});
    if (!c.suspects_note.empty()) j["suspects_note"] = c.suspects_note;
    if (!c.notes.empty()) j["notes"] = c.notes;
    if (c.taken_as)
        j["taken_as"] = {{"what", c.taken_as->what},
                         {"residual", c.taken_as->residual},
                         {"resolution", c.taken_as->resolution}};
    if (c.nearest)
        j["nearest"] = {{"family", c.nearest->family},
                        {"stages", c.nearest->stages},
                        {"error", c.nearest->error},
                        {"entry", c.nearest->entry}};
    for (file_certificate p : c.partners) {
        p.tableau = nullptr;  // it stands in that of the whole
        j["partners"].push_back(to_json(p));
    }
    if (!c.tableau.is_null()) j["tableau"] = c.tableau;
    return j;
}

STAGECRAFT_INLINE std::string json_text(const file_certificate& c) {
    return to_json(c).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

namespace detail {
STAGECRAFT_INLINE std::string indented(const std::string& lines) {
    std::string out;
    bool start = true;
    for (const char ch : lines) {
        if (start) out += "  ";
        out += ch;
        start = ch == '\n';
    }
    return out;
}
}  // namespace detail

STAGECRAFT_INLINE std::string to_text(const file_certificate& c) {
    std::string out = c.name.empty() ? "tableau\n" : c.name + "\n";
    if (!c.source.empty()) out += "  source: " + c.source + "\n";
    out +=
        "  data: " + c.data + ", " + std::to_string(c.stages) + " stage" + (c.stages == 1 ? "" : "s") + "\n";
    for (const std::string& note : c.notes) out += "  " + note + "\n";
    for (const finding& f : c.findings) {
        out += "  " + f.name + ":";
        if (f.value) out += " " + std::to_string(*f.value);
        if (f.truth) out += " " + f.truth->text();
        if (f.claimed) {
            out += (f.value || f.truth ? "; " : " ");
            out += "claimed " + *f.claimed + ": ";
            const bool same = f.truth && f.truth->standing() == f.judgement->standing();
            out += f.truth ? (same ? std::string(name(f.judgement->standing()))
                                   : "claim " + std::string(name(f.judgement->standing())))
                           : f.judgement->text();
        }
        out += "\n";
    }
    if (c.principal_error) out += "  " + text(*c.principal_error) + "\n";
    if (c.error_metrics) out += "  " + text(*c.error_metrics) + "\n";
    if (c.spectra.eigenvalues) out += "  eigenvalues of A: " + text(*c.spectra.eigenvalues) + "\n";
    if (c.spectra.poles) out += "  poles of R: " + text(*c.spectra.poles) + "\n";
    if (!c.spectra.note.empty()) out += "  " + c.spectra.note + "\n";
    // A true certificate need not show hundreds of conditions of the order that it does not claim.
    const bool refuted = c.overall() == standing::refuted;
    const std::size_t most = refuted ? c.failures.size() : 6;
    if (!c.failures.empty())
        out += refuted ? "  failing conditions, of the first order that has some:\n"
                       : "  conditions that fail, though nothing claimed needs them:\n";
    for (std::size_t i = 0; i < std::min(most, c.failures.size()); ++i) {
        const failure& f = c.failures[i];
        out += "    " + f.condition + (f.tree.empty() ? "" : "   tree " + f.tree) + "   residual " +
               f.in_words + "\n";
    }
    if (most < c.failures.size()) out += "    and " + std::to_string(c.failures.size() - most) + " more\n";
    if (!c.suspects.empty()) out += "  suspects, the single entries whose change restores every claim:\n";
    for (const suspect& s : c.suspects)
        out += "    " + s.entry + " = " + s.written + " should read " + s.suggest + "\n";
    if (!c.suspects_note.empty()) out += "  " + c.suspects_note + "\n";
    if (c.nearest)
        out += "  nearest: " + c.nearest->family + ", s = " + std::to_string(c.nearest->stages) +
               ", largest error " + c.nearest->error +
               (c.nearest->entry.empty() ? "" : " at " + c.nearest->entry) + "\n";
    for (const file_certificate& p : c.partners) out += detail::indented(to_text(p));
    return out + "  verdict: " + c.verdict_in_words() + "\n";
}

}  // namespace stagecraft::theory
