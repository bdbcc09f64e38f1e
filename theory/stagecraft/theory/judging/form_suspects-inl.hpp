// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/form_suspects.hpp"

#include <optional>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory::detail {

STAGECRAFT_INLINE std::vector<place> form_places(const tableaux::stage_form& form) {
    using kind = tableaux::stage_form::kind;
    const int rows = static_cast<int>(form.rows.size());
    const int first = form.which == kind::shu_osher    ? rows / 2
                      : form.which == kind::williamson ? 0
                                                       : rows - 1;  // beta
    std::vector<place> all;
    for (int i = first; i < rows; ++i) {
        const auto& row = form.rows[static_cast<std::size_t>(i)];
        const int end = form.which == kind::shu_osher ? i - first + 1 : static_cast<int>(row.size());
        for (int k = 0; k < end; ++k) {
            const auto& e = row[static_cast<std::size_t>(k)];
            if (row.size() <= 20 || !e.exact || *e.exact != 0) all.push_back({part::A, i, k});
        }
    }
    return all;
}

}  // namespace stagecraft::theory::detail
