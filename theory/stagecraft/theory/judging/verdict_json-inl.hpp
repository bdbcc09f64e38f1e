// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/verdict_json.hpp"

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE nlohmann::ordered_json to_json(const verdict& v) {
    nlohmann::ordered_json j{{"verdict", name(v.standing())}};
    if (!v.residual().empty()) {
        j["residual"] = v.residual();
        j["bound"] = v.bound();
    }
    j["reason"] = v.reason();
    return j;
}

STAGECRAFT_INLINE nlohmann::ordered_json to_json(const principal_error& e) {
    return {{"order", e.order}, {"norm", e.norm}, {"largest", e.largest}};
}

}  // namespace stagecraft::theory
