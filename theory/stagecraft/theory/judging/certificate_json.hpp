// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>

#include "stagecraft/theory/judging/certificate.hpp"
#include "stagecraft/theory/judging/spectrum_json.hpp"
#include "stagecraft/theory/judging/verdict_json.hpp"

namespace stagecraft::theory {

/// The certificate as JSON. Rationals are strings "p/q", polynomials arrays of them, ascending; R_infinity is
/// "infinity" where R has a pole there, and a maximal C or D that every k satisfies is "infinity".
nlohmann::ordered_json to_json(const certificate& c);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/certificate_json-inl.hpp"
#endif
