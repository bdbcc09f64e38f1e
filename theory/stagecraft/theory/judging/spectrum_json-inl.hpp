// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/spectrum_json.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE nlohmann::ordered_json to_json(const spectrum& all) {
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

STAGECRAFT_INLINE void add_to_json(const spectra& s, nlohmann::ordered_json& certificate) {
    if (s.eigenvalues) certificate["eigenvalues"] = to_json(*s.eigenvalues);
    if (s.poles) certificate["poles"] = to_json(*s.poles);
    if (!s.note.empty()) certificate["spectrum_note"] = s.note;
}

}  // namespace stagecraft::theory
