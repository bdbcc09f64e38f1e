// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/difference.hpp"

#include <algorithm>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/judging/subject.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE std::string in_brief(const finding& f) {
    if (f.value) return std::to_string(*f.value);
    return f.truth ? std::string(name(f.truth->standing())) : "open";
}

STAGECRAFT_INLINE bool all_exact(const tableaux::tableau_file& t) {
    const auto places = places_of(t);
    return std::all_of(places.begin(), places.end(),
                       [&](const place& p) { return entry_at(t, p).exact.has_value(); });
}

STAGECRAFT_INLINE std::vector<std::string> differences(const certified_file& x, const certified_file& y) {
    std::vector<std::string> lines;
    const auto& [a, of_a] = x;
    const auto& [b, of_b] = y;
    if (a.stages() != b.stages()) {
        lines.push_back("stages: " + std::to_string(a.stages()) + " and " + std::to_string(b.stages()));
    } else {
        const auto differ = [](const tableaux::entry& u, const tableaux::entry& v) {
            if (u.exact && v.exact) return !(u.enclosure == v.enclosure);
            return u.enclosure.upper < v.enclosure.lower || v.enclosure.upper < u.enclosure.lower;
        };
        for (const place& p : places_of(a)) {
            const bool missing =
                (p.part == part::c && b.c.empty()) || (p.part == part::b_embedded && b.b_embedded.empty());
            if (missing) continue;
            const auto &u = entry_at(a, p), &v = entry_at(b, p);
            if (differ(u, v)) lines.push_back(p.name() + ": " + u.text + " and " + v.text);
        }
        if (a.c.empty() != b.c.empty()) lines.push_back("c: given in one only");
        if (a.b_embedded.empty() != b.b_embedded.empty()) lines.push_back("b_embedded: given in one only");
    }
    for (const finding& f : of_a.findings) {
        const finding* g = of_b.find(f.name);
        const std::string first = in_brief(f), second = g ? in_brief(*g) : "not there";
        if (first != second) lines.push_back(f.name + ": " + first + " and " + second);
    }
    return lines;
}

}  // namespace stagecraft::theory
