// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/program_leftovers.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/program_names.hpp"

namespace stagecraft::tableaux::program_text {

STAGECRAFT_INLINE leftovers::leftovers(const variables& v, const std::set<std::size_t>& taken, groups& out)
    : v_(v), taken_(taken), out_(out) {
    for (const auto& x : v.all)
        if (x.is == variable::kind::array && x.last() == "b") with_b_.emplace(x.scope, x.owner());
    for (const auto& x : v.all)
        if (x.used && x.is == variable::kind::array && x.array.numbers() > 0) used_.insert(numbers_of(x));
}

STAGECRAFT_INLINE std::vector<std::pair<std::size_t, std::string>> leftovers::numbers_of(const variable& x) {
    std::vector<std::pair<std::size_t, std::string>> all;
    for (const auto& c : x.array.all()) all.emplace_back(c.line, c.text);
    return all;
}

STAGECRAFT_INLINE void leftovers::tell() {
    std::string first_single;
    std::size_t singles = 0, line = 0;
    for (std::size_t k = 0; k < v_.all.size(); ++k) {
        const auto& x = at(k);
        if ((x.used && !is_claim_left(k)) || x.gathered_as != variable::gathered::no) continue;
        if (is_array(k) && used_.contains(numbers_of(x))) continue;  // another name for what is in use
        if ((is_array(k) && looks_like_coefficients(x)) || is_claim_left(k)) {
            std::string what =
                x.name + (x.elements.empty() ? "" : "[..]") + " (line " + std::to_string(x.line) + ")";
            if (!x.trouble.empty()) what += ": " + x.trouble;
            out_.unused.emplace(x.line, std::move(what));
        } else if ((x.is == variable::kind::number || x.is == variable::kind::other) &&
                   is_single_coefficient(x.last()) && singles++ == 0) {
            first_single = x.name;
            line = x.line;
        }
    }
    if (singles > 0)
        out_.unused.emplace(
            line, first_single + " (line " + std::to_string(line) + ")" +
                      (singles > 1 ? " and " + std::to_string(singles - 1) + " more single numbers" : ""));
    for (const auto n : v_.unnamed)
        out_.unused.emplace(n, "numbers without a name (line " + std::to_string(n) + ")");
}

/// Whether x says something of an order or a property and is in no tableau.
STAGECRAFT_INLINE bool leftovers::is_claim_left(std::size_t k) const {
    const auto& x = at(k);
    if (taken_.contains(k) || x.by_elements) return false;
    const auto name = claim_in(x.name);
    if (name && x.name.find("->") != x.name.npos) return x.is == variable::kind::number && has_elements(x);
    if (name && name->key != "name") return true;
    const std::string text = lower(x.last());
    if (x.is == variable::kind::text) return false;
    for (const std::string_view word : {"order", "stable", "symplectic", "symmetric", "accurate"}) {
        const auto i = text.find(word);
        if (i == text.npos) continue;
        const bool begins = i == 0 || std::isalpha(static_cast<unsigned char>(text[i - 1])) == 0 ||
                            std::isupper(static_cast<unsigned char>(x.last()[i])) != 0;
        if (begins) return true;
    }
    return false;
}

/// Whether elements are assigned in the same scope under the same owner, as B->b[0] beside B->q.
STAGECRAFT_INLINE bool leftovers::has_elements(const variable& x) const {
    return with_b_.contains({x.scope, x.owner()});
}

/// Elements only of what is called as coefficients are; no pair of whole numbers, such as (0, 1).
STAGECRAFT_INLINE bool leftovers::looks_like_coefficients(const variable& x) {
    if (is_coefficient(x.last()) || dense_as(x.last())) return true;
    if (x.by_elements || x.array.numbers() == 0) return !x.by_elements && !x.trouble.empty();
    const auto all = x.array.all();
    const bool whole = std::all_of(all.begin(), all.end(), [](const cell& c) {
        return c.text.find_first_not_of("0123456789.-+()") == c.text.npos;
    });
    return all.size() > 2 || (all.size() == 2 && !whole);
}

}  // namespace stagecraft::tableaux::program_text
