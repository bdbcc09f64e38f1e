// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/tableau_json.hpp"

#include <string>
#include <vector>

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE void add_claims(const claims& stated, nlohmann::ordered_json& j) {
    for (const auto& [key, value] : counted_claims)
        if (stated.*value) j["claims"][std::string(key)] = *(stated.*value);
    for (const auto& [key, value] : yes_no_claims)
        if (stated.*value) j["claims"][std::string(key)] = *(stated.*value);
    for (const auto& [key, value] : number_claims)
        if (stated.*value) j["claims"][std::string(key)] = *(stated.*value);
}

STAGECRAFT_INLINE nlohmann::ordered_json to_json(const tableau_file& file) {
    const auto texts = [](const std::vector<entry>& entries) {
        auto list = nlohmann::ordered_json::array();
        for (const entry& e : entries) list.push_back(e.text);
        return list;
    };
    nlohmann::ordered_json j{{"name", file.name}, {"source", file.source}};
    if (!file.c.empty()) j["c"] = texts(file.c);
    for (const auto& row : file.A) j["A"].push_back(texts(row));
    j["b"] = texts(file.b);
    if (!file.b_embedded.empty()) j["b_embedded"] = texts(file.b_embedded);
    for (const auto& row : file.b_theta) j["b_theta"].push_back(texts(row));
    add_claims(file.claims, j);
    return j;
}

STAGECRAFT_INLINE void add_rosenbrock(const partitioned_file& file, nlohmann::ordered_json& j) {
    const auto values = to_json(file.partners[0]);
    auto matrix = to_json(file.partners[1])["A"];
    const auto s = static_cast<std::size_t>(file.stages());
    if (file.one_gamma || file.transformed) {
        j["gamma"] = file.one_gamma ? matrix[0][0] : nlohmann::ordered_json::array();
        for (std::size_t i = 0; i < s; ++i) {
            if (!file.one_gamma) j["gamma"].push_back(matrix[i][i]);
            matrix[i][i] = "0";
        }
    }
    j[file.transformed ? "a" : "A"] = values["A"];
    j[file.transformed ? "C" : "Gamma"] = std::move(matrix);
    j[file.transformed ? "m" : "b"] = values["b"];
    if (values.contains("b_embedded"))
        j[file.difference ? "e" : file.transformed ? "m_embedded" : "b_embedded"] = values["b_embedded"];
    if (values.contains("c")) j["c"] = values["c"];
    if (const auto sums = to_json(file.partners[1]); sums.contains("c")) j["d"] = sums["c"];
}

STAGECRAFT_INLINE nlohmann::ordered_json to_json(const partitioned_file& file) {
    nlohmann::ordered_json j{{"name", file.name}, {"source", file.source}, {"form", name(file.coupling)}};
    if (file.coupling == coupling::rosenbrock) {
        add_rosenbrock(file, j);
    } else if (file.coupling == coupling::nystrom) {
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
