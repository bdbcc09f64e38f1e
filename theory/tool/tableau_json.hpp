// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/decimals.hpp>
#include <string>

namespace stagecraft::tool {

/// What `tableau --format json` prints of a family's member: a tableau file.
inline nlohmann::ordered_json to_json(const std::string& family, const tableaux::decimal_tableau& t,
                                      int digits) {
    return {{"family", family}, {"stages", t.c.size()}, {"digits", digits}, {"c", t.c}, {"A", t.A},
            {"b", t.b}};
}

}  // namespace stagecraft::tool
