// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/resolution.hpp"

#include <algorithm>
#include <functional>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/reading.hpp"
#include "stagecraft/theory/judging/coupling_suspects.hpp"
#include "stagecraft/theory/judging/find_suspects.hpp"
#include "stagecraft/theory/judging/form_suspects.hpp"
#include "stagecraft/theory/judging/judge_claims.hpp"
#include "stagecraft/theory/statements/certainty.hpp"

namespace stagecraft::theory {

namespace detail {

/// `shows` tells whether a change of the entry of this number by so much refutes a claim.
STAGECRAFT_INLINE resolution
find_resolution(const std::vector<std::string>& entries, const tableaux::rational& least,
                const std::function<bool(std::size_t, const tableaux::ball&)>& shows) {
    resolution found;
    const auto shows_both_ways = [&](std::size_t k, const tableaux::rational& x) {
        const auto change = to_ball({x, x});
        return shows(k, change) && shows(k, -change);
    };
    auto size = least;
    for (std::size_t k = 0; k < entries.size(); ++k) {
        if (!shows_both_ways(k, size)) {
            if (!shows_both_ways(k, tableaux::rational(1, 2))) {
                found.unseen.push_back(entries[k]);
                continue;
            }
            while (size < 1 && !shows_both_ways(k, size)) size += size;
            found.entry = entries[k];
        } else if (found.entry.empty()) {
            found.entry = entries[k];
        }
    }
    found.size = brief(size.to<tableaux::bound>());
    return found;
}

STAGECRAFT_INLINE resolution resolution_of_form(const tableaux::tableau_file& file) {
    const auto& form = *file.form;
    form_values<tableaux::ball> values;
    std::vector<place> places;
    std::vector<std::string> names;
    for (const auto& row : form.rows) {
        values.emplace_back();
        for (const auto& e : row) values.back().push_back(enclosed_entry(e));
    }
    for (const place& p : form_places(form)) {
        const auto i = static_cast<std::size_t>(p.row), k = static_cast<std::size_t>(p.column);
        if (!certainly_nonzero(values[i][k])) continue;
        places.push_back(p);
        names.push_back(form.name(i, k));
    }
    return find_resolution(
        names, largest_uncertainty(file), [&](std::size_t n, const tableaux::ball& change) {
            auto changed = values;
            auto& value =
                changed[static_cast<std::size_t>(places[n].row)][static_cast<std::size_t>(places[n].column)];
            value = value + change;
            return refutes_a_condition(subject_of_form(form.which, changed), file.claims, false);
        });
}

}  // namespace detail

STAGECRAFT_INLINE resolution resolution_of(const tableaux::tableau_file& file) {
    if (file.form) return detail::resolution_of_form(file);
    const auto s = detail::enclosed_subject(file);
    std::vector<place> places;
    std::vector<std::string> names;
    for (const place& p : places_of(file)) {
        if (!certainly_nonzero(value_at(s, p))) continue;
        places.push_back(p);
        names.push_back(p.name());
    }
    return detail::find_resolution(
        names, largest_uncertainty(file), [&](std::size_t n, const tableaux::ball& change) {
            auto changed = s;
            put(changed, places[n], tableaux::ball(value_at(s, places[n]) + change));
            return refutes_a_condition(changed, file.claims, mostly_row_sums(changed));
        });
}

STAGECRAFT_INLINE resolution resolution_of(const tableaux::partitioned_file& file) {
    coupled_subject<tableaux::ball> s{&file, {}};
    tableaux::rational least(0);
    for (const auto& p : file.partners) {
        s.partners.push_back(detail::enclosed_subject(p));
        least = std::max(least, largest_uncertainty(p));
    }
    std::vector<detail::coupled_place> places;
    std::vector<std::string> names;
    for (const auto& p : detail::coupled_places(file)) {
        if (!certainly_nonzero(value_at(s.partners[p.partner], p.place))) continue;
        places.push_back(p);
        names.push_back(detail::name(p, file));
    }
    const detail::coupled_trees_claimed trees(file);
    return detail::find_resolution(names, least, [&](std::size_t n, const tableaux::ball& change) {
        auto changed = s;
        const auto& p = places[n];
        detail::put(changed, p, tableaux::ball(value_at(s.partners[p.partner], p.place) + change));
        return detail::refutes_a_coupled_claim(changed, trees);
    });
}

STAGECRAFT_INLINE std::string in_words(const resolution& r) {
    std::string text =
        "resolution: a change of one entry by " + r.size + " or more shows, that of " + r.entry + " last";
    if (r.entry.empty()) text = "resolution: none";
    if (r.unseen.empty()) return text;
    const std::size_t shown = std::min<std::size_t>(r.unseen.size(), 4);
    text += "; no claim sees ";
    for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : ", ") + r.unseen[i];
    return text +
           (shown < r.unseen.size() ? " and " + std::to_string(r.unseen.size() - shown) + " more" : "");
}

}  // namespace stagecraft::theory
