// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/exercises/kinds.hpp"

#include <stdexcept>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE exercise make_exercise(const std::string& kind, std::uint64_t seed) {
    std::string names;
    std::uint64_t number = 0;
    for (const auto& k : exercise_kinds()) {
        ++number;
        if (k.name == kind) {
            dice d(exercise_kinds().size() * seed + number);  // other choices for every kind
            exercise e = k.make(d);
            e.kind = kind;
            e.seed = seed;
            if (!e.certified())
                throw std::logic_error("exercise " + kind + ", seed " + std::to_string(seed) +
                                       ": the solution was not confirmed");
            return e;
        }
        names += (names.empty() ? "" : ", ") + k.name;
    }
    throw std::invalid_argument("kind: unknown name '" + kind + "', allowed: " + names);
}

}  // namespace stagecraft::theory
