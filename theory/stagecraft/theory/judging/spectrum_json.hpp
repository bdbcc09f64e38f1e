// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stagecraft/theory/stability/spectrum.hpp>
#include <string>
#include <utility>

namespace stagecraft::theory {

/// An array of {re, im, multiplicity}, one for each value (both of a pair): decimal strings, correctly
/// rounded to 12 digits, with "exact" where known; with the bound "radius" for either part where the data
/// leave the rounding open.
inline nlohmann::ordered_json to_json(const spectrum& all) {
    nlohmann::ordered_json array = nlohmann::ordered_json::array();
    for (const auto& v : all)
        for (const int sign : {1, -1}) {
            if (v.is_real() && sign < 0) continue;
            nlohmann::ordered_json entry{{"re", detail::digits_of(v.value.re)},
                                         {"im", (sign < 0 ? "-" : "") + detail::digits_of(v.value.im)},
                                         {"multiplicity", v.multiplicity}};
            if (v.exact) entry["exact"] = v.exact->str();
            if (!detail::is_certain(v.value.re) || !detail::is_certain(v.value.im))
                entry["radius"] = brief(std::max(v.value.re.radius(), v.value.im.radius()));
            array.push_back(std::move(entry));
        }
    return array;
}

/// Adds "eigenvalues", "poles" and "spectrum_note" to a certificate, each where there is one.
inline void add_to_json(const spectra& s, nlohmann::ordered_json& certificate) {
    if (s.eigenvalues) certificate["eigenvalues"] = to_json(*s.eigenvalues);
    if (s.poles) certificate["poles"] = to_json(*s.poles);
    if (!s.note.empty()) certificate["spectrum_note"] = s.note;
}

}  // namespace stagecraft::theory
