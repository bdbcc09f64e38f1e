// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stagecraft/tableaux/decimals.hpp>
#include <stagecraft/tableaux/nodal.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <string>
#include <vector>

namespace stagecraft::tool {

/// What `collocate --embedded` adds to a method on given nodes.
struct embedded_method {
    std::vector<std::string> b;  ///< embedded weights; with the extra stage, if any, first
    bool extra_stage = false;    ///< f(t_0, y_0) before the others
    int order = 0;
    bool l_stable = false;
    std::string why;  ///< one sentence
};

/// The embedded weights of the kind "highest" or "l-stable", as text of the same kind as the tableau's: surds where the nodes
/// lie in a quadratic field, otherwise 30 digits. `said` becomes one sentence where there are none. Throws
/// std::invalid_argument for another kind.
std::optional<embedded_method> embedded_of(const tableaux::nodal_polynomial& w, const std::string& kind,
                                           std::string& said);

/// The tableau with the extra stage, if the formula has one, before the others.
tableaux::decimal_tableau with_stage(tableaux::decimal_tableau t, const embedded_method& e);

/// The embedded method as a tableau file of its own, with its claims.
nlohmann::ordered_json file_of(const tableaux::decimal_tableau& t, const embedded_method& e,
                               const std::string& name);

}  // namespace stagecraft::tool
