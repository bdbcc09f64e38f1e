// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/bvp/instances.hpp>
#include <stagecraft/bvp/solve/search.hpp>

namespace stagecraft::detail {

/// solve_bvp of a problem whose types are erased. The first `positions` equations are q' = v; where that is negative it is
/// looked for, and where the problem cannot be solved so it is solved as it stands.
template <int S, class Vector, class Parameters>
bvp_result<Vector, Parameters> solve_functions(const tableau<typename Vector::Scalar, S>& method,
                                               typename bvp_solver<S, Vector, Parameters>::functions& problem,
                                               const guess_view<Vector>& guess,
                                               const typename Vector::Scalar& a,
                                               const typename Vector::Scalar& b, const Parameters& p,
                                               const bvp_options<typename Vector::Scalar>& o, int positions) {
    using solver = bvp_solver<S, Vector, Parameters>;
    const bool declared = positions >= 0;
    solver first(method, problem, p, o, declared ? positions : 0);
    first.try_other_guesses();
    if (!declared) first.look_for_second_order(guess, a, b);
    try {
        auto result = first.run(guess, a, b);
        const bool failed = result.status == bvp_status::non_finite ||
                            (result.status == bvp_status::newton_failed && !first.dear());
        if (declared || !failed || !first.of_second_order()) return result;
    } catch (const not_of_second_order&) {
        if (declared)
            throw bad_problem("solve_bvp: problem.second_order_components does not hold: f_i is not y_{m+i}");
    }
    solver again(method, problem, p, o);
    again.count_work_of(first);
    again.try_other_guesses();
    return again.run(guess, a, b);
}

}  // namespace stagecraft::detail

#ifdef STAGECRAFT_BVP_TAKEN
namespace stagecraft::detail {
STAGECRAFT_BVP_SIZE(extern template, 2)
STAGECRAFT_BVP_SIZE(extern template, 3)
STAGECRAFT_BVP_SIZE(extern template, 4)
STAGECRAFT_BVP_SIZE(extern template, 6)
STAGECRAFT_BVP_SIZE(extern template, Eigen::Dynamic)
}  // namespace stagecraft::detail
#endif
