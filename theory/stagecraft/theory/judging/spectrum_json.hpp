// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>
#include <stagecraft/theory/stability/spectrum.hpp>

namespace stagecraft::theory {

/// An array of {re, im, multiplicity}, one for each value (both of a pair): decimal strings, correctly
/// rounded to 12 digits, with "exact" where known; with the bound "radius" for either part where the data
/// leave the rounding open.
nlohmann::ordered_json to_json(const spectrum& all);

/// Adds "eigenvalues", "poles" and "spectrum_note" to a certificate, each where there is one.
void add_to_json(const spectra& s, nlohmann::ordered_json& certificate);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/spectrum_json-inl.hpp"
#endif
