// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/stage_forms.hpp"

#include <cstddef>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/json_document.hpp"
#include "stagecraft/tableaux/reading.hpp"
#include "stagecraft/tableaux/stage_form.hpp"

namespace stagecraft::tableaux {

namespace json_reader {

/// The rows of a list of lists, row i of at most i + 1 entries, filled up with zeros.
STAGECRAFT_INLINE std::vector<std::vector<entry>> triangle(const document& d, const std::string& key) {
    const json& all = d.root[key];
    if (!all.is_array() || all.empty() || all.size() > most_stages)
        reject(d, "/" + key, key, "must be a list of 1 to " + std::to_string(most_stages) + " rows");
    std::vector<std::vector<entry>> rows;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string row = key + "[" + std::to_string(i + 1) + "]";
        rows.push_back(numbers(d, all[i], "/" + key + "/" + std::to_string(i), row, 0));
        if (rows.back().size() > all.size() || rows.back().empty())
            reject(d, "/" + key + "/" + std::to_string(i), row,
                   "must have 1 to " + std::to_string(all.size()) + " entries");
        for (std::size_t k = i + 1; k < rows.back().size(); ++k)
            if (!rows.back()[k].exact || *rows.back()[k].exact != 0)
                reject(d, "/" + key + "/" + std::to_string(i) + "/" + std::to_string(k),
                       row + "[" + std::to_string(k + 1) + "]", "must be 0: the method is explicit");
        rows.back().resize(all.size(), read_entry("0"));
    }
    return rows;
}

/// The list of that name, whose length is the number of stages; as many as `expected` where that is not 0.
STAGECRAFT_INLINE std::vector<entry> one_for_each_stage(const document& d, const std::string& key,
                                                        std::size_t expected) {
    auto list = numbers(d, d.root[key], "/" + key, key, 0);
    if (list.empty() || list.size() > most_stages)
        reject(d, "/" + key, key, "must have 1 to " + std::to_string(most_stages) + " entries");
    if (expected != 0 && list.size() != expected)
        reject(d, "/" + key, key,
               "has " + std::to_string(list.size()) + " entries, others have " + std::to_string(expected));
    return list;
}

/// alpha and beta. A row of alpha that does not sum to 1 is no method.
STAGECRAFT_INLINE std::vector<std::vector<entry>> shu_osher_rows(const document& d) {
    auto alpha = triangle(d, "alpha");
    for (auto& row : triangle(d, "beta")) alpha.push_back(std::move(row));
    if (alpha.size() != 2 * alpha.front().size())
        reject(d, "/beta", "beta",
               "must have " + std::to_string(alpha.front().size()) + " rows, as many as alpha");
    return alpha;
}

STAGECRAFT_INLINE bool is_stage_form(const std::string& form) {
    return form == "shu-osher" || form == "2N" || form == "2S" || form == "3S*";
}

STAGECRAFT_INLINE tableau_file from_stage_form(const document& d, const reading& how) {
    using kind = stage_form::kind;
    const std::string form = text_field(d, "form");
    const kind which = form == "shu-osher" ? kind::shu_osher
                       : form == "2N"      ? kind::williamson
                       : form == "2S"      ? kind::ketcheson
                                           : kind::ketcheson_three;
    std::set<std::string> known{"name", "source", "note", "form", "claims", "tolerance", "b_embedded", "c"};
    for (const std::string& name : stage_form::names(which)) known.insert(name);
    require_keys(d, known, {});
    for (const std::string& name : stage_form::names(which)) require_keys(d, known, {name.c_str()});
    tableau_file given;  // so that what decimals mean is decided from all of them
    if (which == kind::shu_osher) {
        given.A = shu_osher_rows(d);
    } else {
        for (const std::string& name : stage_form::names(which))
            given.A.push_back(one_for_each_stage(d, name, given.A.empty() ? 0 : given.A.front().size()));
    }
    if (d.root.contains("b_embedded"))
        given.b_embedded = one_for_each_stage(d, "b_embedded", given.A.front().size());
    else if (read_claims(d).embedded_order)
        reject(d, "/claims/embedded_order", "claims.embedded_order", "there is no b_embedded");
    if (d.root.contains("c")) given.c = one_for_each_stage(d, "c", given.A.front().size());
    apply(with_tolerance_of(d, how), given);
    try {
        tableau_file file = expanded({which, std::move(given.A)});
        file.b_embedded = std::move(given.b_embedded);
        file.c = std::move(given.c);
        file.short_decimals = given.short_decimals;
        return file;
    } catch (const std::invalid_argument& e) {
        reject(d, "", "", e.what());
    }
}

}  // namespace json_reader

}  // namespace stagecraft::tableaux
