// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/partitioned_file.hpp"

#include <nlohmann/json.hpp>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/tableau_json.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE number_kind partitioned_file::kind() const {
    tableau_file all;
    for (const auto& p : partners) p.for_each_entry([&](const entry& e) { all.b.push_back(e); });
    return all.kind();
}

STAGECRAFT_INLINE std::string partner_name(const partitioned_file& file, std::size_t k) {
    if (file.coupling == coupling::nystrom) return k == 0 ? "the formula for y" : "the formula for y'";
    const std::string& given = file.partners[k].name;
    return given.empty() ? "tableau " + std::to_string(k + 1) : given;
}

STAGECRAFT_INLINE nlohmann::ordered_json to_json(const partitioned_file& file) {
    nlohmann::ordered_json j{{"name", file.name}, {"source", file.source}, {"form", name(file.coupling)}};
    if (file.coupling == coupling::nystrom) {
        const auto position = to_json(file.partners[0]), velocity = to_json(file.partners[1]);
        j["c"] = position["c"];
        j["A_bar"] = position["A"];
        j["b_bar"] = position["b"];
        if (file.uses_velocity) j["A"] = velocity["A"];
        j["b"] = velocity["b"];
        if (position.contains("b_embedded")) {
            j["b_bar_embedded"] = position["b_embedded"];
            j["b_embedded"] = velocity["b_embedded"];
        }
    } else {
        for (const auto& p : file.partners) j["partners"].push_back(to_json(p));
    }
    add_claims(file.claims, j);
    return j;
}

}  // namespace stagecraft::tableaux
