// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>
#include <stagecraft/theory/judging/principal_error.hpp>
#include <stagecraft/theory/statements/verdict.hpp>

namespace stagecraft::theory {

/// {"verdict": "proved" | "refuted" | "consistent" | "inconclusive", "reason": ...}, with residual and bound in
/// the open cases.
inline nlohmann::ordered_json to_json(const verdict& v) {
    nlohmann::ordered_json j{{"verdict", name(v.standing())}};
    if (v.is_consistent() || v.is_inconclusive()) {
        j["residual"] = v.residual();
        j["bound"] = v.bound();
    }
    j["reason"] = v.reason();
    return j;
}

/// {"order": 5, "norm": ..., "largest": ...}.
inline nlohmann::ordered_json to_json(const principal_error& e) {
    return {{"order", e.order}, {"norm", e.norm}, {"largest", e.largest}};
}

}  // namespace stagecraft::theory
