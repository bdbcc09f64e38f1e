// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>
#include "stagecraft/tableaux/program_names.hpp"
#include "stagecraft/tableaux/program_scan.hpp"
#include "stagecraft/tableaux/program_variables.hpp"

namespace stagecraft::tableaux::program_text {

/// Variables that make one tableau.
struct group {
    std::string name;
    std::size_t scope = 0;
    std::size_t line = 0;
    std::map<std::string, std::size_t>
        arrays;  ///< "A", "b", "c", "b_embedded", "diagonal", "b_theta": which variable
    nlohmann::json claims = nlohmann::json::object();
    std::string before, behind;         ///< what stands beside A in its name
    std::size_t last_row_of = nowhere;  ///< the variable whose last row is b, where there is no b
    std::size_t embedded_from = 0;      ///< how many numbers stand before the first embedded weight
    dense_word::written dense_as = dense_word::written::ascending;  ///< how b_theta is written
};

/// Groups, and what looks like a coefficient or a claim and is in none of them, with its line.
struct groups {
    std::vector<group> all;
    std::multimap<std::size_t, std::string> unused;
};

/// Marks what it uses of v.
groups groups_of(const program& p, variables& v);

}  // namespace stagecraft::tableaux::program_text

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/program_groups-inl.hpp"
#endif
