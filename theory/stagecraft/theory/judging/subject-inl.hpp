// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/subject.hpp"

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/tableau_file.hpp"
#include "stagecraft/theory/statements/certainty.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE std::string place::name() const {
    static constexpr const char* names[] = {"A", "b", "c", "b_embedded"};
    std::string n = names[static_cast<int>(part)];
    n += "[" + std::to_string(row + 1) + "]";
    if (part == theory::part::A) n += "[" + std::to_string(column + 1) + "]";
    return n;
}

STAGECRAFT_INLINE std::vector<place> places_of(const tableaux::tableau_file& file, int above) {
    std::vector<place> all;
    const int s = file.stages();
    for (int i = 0; i < s; ++i)
        for (int j = 0; j < s && j - i <= above; ++j) all.push_back({part::A, i, j});
    for (int i = 0; i < s; ++i) all.push_back({part::b, i, 0});
    if (!file.c.empty())
        for (int i = 0; i < s; ++i) all.push_back({part::c, i, 0});
    if (!file.b_embedded.empty())
        for (int i = 0; i < s; ++i) all.push_back({part::b_embedded, i, 0});
    return all;
}

STAGECRAFT_INLINE std::vector<place> places_of_kind(const tableaux::tableau_file& file) {
    int above = -1;
    for (const place& p : places_of(file))
        if (p.part == part::A && p.column - p.row > above && entry_at(file, p).enclosure.middle() != 0)
            above = p.column - p.row;
    return places_of(file, above > 0 ? file.stages() : above);
}

}  // namespace stagecraft::theory
