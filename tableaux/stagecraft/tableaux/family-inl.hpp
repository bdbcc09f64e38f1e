// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/family.hpp"

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE std::string family_names() {
    std::string all;
    for (const family f : all_families) (all += all.empty() ? "" : ", ") += name(f);
    return all;
}

STAGECRAFT_INLINE family family_from_name(std::string_view text) {
    for (const family f : all_families)
        if (name(f) == text) return f;
    throw std::invalid_argument("family: unknown name '" + std::string(text) +
                                "', allowed: " + family_names());
}

STAGECRAFT_INLINE void require_stages(family f, int s) {
    if (s < least_stages(f))
        throw std::invalid_argument("stages: " + std::string(name(f)) + " needs at least " +
                                    std::to_string(least_stages(f)) + ", got " + std::to_string(s));
}

}  // namespace stagecraft::tableaux
