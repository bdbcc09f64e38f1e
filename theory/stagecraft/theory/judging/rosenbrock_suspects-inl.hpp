// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/rosenbrock_suspects.hpp"

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory::detail {

STAGECRAFT_INLINE std::vector<coupled_place> rosenbrock_places(const tableaux::partitioned_file& file) {
    std::vector<coupled_place> all;
    for (std::size_t k = 0; k < 2; ++k)
        for (const place& p : places_of(file.partners[k], k == 0 ? -1 : 0)) {
            const bool diagonal = k == 1 && p.part == part::A && p.row == p.column;
            const bool again = diagonal && file.one_gamma && p.row > 0;
            const bool weights = k == 1 && p.part == part::b;
            if (!again && !weights) all.push_back({k, p});
        }
    return all;
}

STAGECRAFT_INLINE std::string rosenbrock_name(const coupled_place& p,
                                              const tableaux::partitioned_file& file) {
    const std::string text = p.place.name(), index = text.substr(text.find('['));
    const bool diagonal = p.place.row == p.place.column;
    switch (p.place.part) {
        case part::A:
            if (p.partner == 0) return (file.transformed ? "a" : "A") + index;
            if (diagonal && file.one_gamma) return "gamma";
            if (diagonal && file.transformed) return "gamma[" + std::to_string(p.place.row + 1) + "]";
            return (file.transformed ? "C" : "Gamma") + index;
        case part::b:
            return (file.transformed ? "m" : "b") + index;
        case part::c:
            return (p.partner == 0 ? "c" : "d") + index;
        default:
            return (file.difference ? "e" : file.transformed ? "m_embedded" : "b_embedded") + index;
    }
}

}  // namespace stagecraft::theory::detail
