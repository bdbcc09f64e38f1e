// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/judge_claims.hpp"

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE int matching_digits(tableaux::bound residual) {
    return residual > 0 ? static_cast<int>(std::floor(-std::log10(residual))) : 0;
}

STAGECRAFT_INLINE void set_open_stage_order(finding& f, tableaux::bound residual, tableaux::bound most,
                                            tableaux::bound relative_bound) {
    f.relative_bound = brief(relative_bound);
    f.judgement = says_nothing(relative_bound, 1)
                      ? verdict::inconclusive(brief(residual), brief(most), "too few digits")
                      : verdict::consistent(brief(residual), brief(most), data_reason);
}

}  // namespace detail

}  // namespace stagecraft::theory
