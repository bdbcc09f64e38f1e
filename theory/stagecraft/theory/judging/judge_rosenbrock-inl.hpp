// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/judge_rosenbrock.hpp"

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory::detail {

STAGECRAFT_INLINE std::vector<rosenbrock_question> questions_of(const tableaux::partitioned_file& file) {
    using enum rosenbrock_conditions;
    const auto& claims = file.claims;
    const int most = tableaux::largest_order_of(file);
    std::vector<rosenbrock_question> all{{"order", jacobian, claims.order, most}};
    if (!file.partners[0].b_embedded.empty())
        all.push_back({"embedded_order", jacobian, claims.embedded_order, most, true});
    all.push_back({"w_order", any_matrix, claims.w_order, tableaux::largest_w_order});
    all.push_back({"index_1_order", index_1, claims.index_1_order, tableaux::largest_index_1_order});
    return all;
}

}  // namespace stagecraft::theory::detail
