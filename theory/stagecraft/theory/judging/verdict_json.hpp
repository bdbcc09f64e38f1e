// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>
#include <stagecraft/theory/judging/principal_error.hpp>
#include <stagecraft/theory/statements/verdict.hpp>

namespace stagecraft::theory {

/// {"verdict": "proved" | "refuted" | "consistent" | "inconclusive", "reason": ...}, with residual and bound in
/// the open cases.
nlohmann::ordered_json to_json(const verdict& v);

/// {"order": 5, "norm": ..., "largest": ...}.
nlohmann::ordered_json to_json(const principal_error& e);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/verdict_json-inl.hpp"
#endif
