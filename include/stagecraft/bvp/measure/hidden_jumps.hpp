// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include <stagecraft/bvp/measure/missed_phase.hpp>

namespace stagecraft::detail {

/// Adds the effect of jumps of f near mesh points, which no evaluation of f sees, to the local errors `delta`. Between the last
/// evaluation in an interval and the first one in the next f may jump unseen, and meshes refined around a jump end with it
/// there. The slope of w then jumps at the mesh point, and the local errors are at most that jump times the lengths on
/// either side. The slopes of a smooth solution differ there as well, by defects, of which P_m says how large they are at
/// the ends, by f_y times the error of the mesh value, and by rounding: only ten times that is taken for a jump. At `known`
/// points, which belong to every mesh, f may jump. Intervals on either side of a jump are marked.
template <class Rule, class Equations, class Iterate, class Wide>
void add_hidden_jumps(const Rule& rule, const Equations& equations, const Iterate& x,
                      const std::vector<std::decay_t<decltype(rule.first)>>& known, const Wide& slopes,
                      const Wide& left_over, Wide& delta, std::vector<char>& marks) {
    using std::abs;
    using scalar = std::decay_t<decltype(rule.first)>;
    const int n = equations.n(), s = equations.s(), m = rule.nodes(), width = n + equations.np();
    const scalar rounding = 8 * m * std::numeric_limits<scalar>::epsilon();
    for (int i = 1; i < x.intervals(); ++i) {
        if (std::binary_search(known.begin(), known.end(), x.t[i])) continue;
        const scalar h = x.h(i - 1), next = x.h(i), behind = (1 - rule.last) * h, before = rule.first * next;
        const auto J = equations.jacobians(i - 1).middleCols((s - 1) * width, n);
        for (int c = equations.positions(); c < n; ++c) {
            const scalar left = rule.at_end.dot(slopes.row(c).segment((i - 1) * m, m)) / h,
                         right = rule.at_start.dot(slopes.row(c).segment(i * m, m)) / next;
            scalar usual = rounding * (abs(left) + abs(right));
            for (int d = 0; d < n; ++d)
                usual += abs(J(c, d)) * (abs(delta(d, i - 1)) + rounding * abs(x.y(d, i)));
            for (int k = 0; k < 2; ++k) {
                const scalar size =
                    std::max(abs(left_over(c, 2 * i - 2 + k)) / h, abs(left_over(c, 2 * i + k)) / next);
                usual = std::max(usual, scalar(size / rule.check[k].level));
            }
            if (!(abs(right - left) > 10 * usual)) continue;
            delta(c, i - 1) += (right - left) * behind;
            delta(c, i) += (right - left) * before;
            marks[i - 1] = marks[i] = 1;
        }
    }
}

/// Writes to `jumps` an upper bound of the part of a jump of f inside an interval that both quadratures miss: in proportion to
/// `inner`, the error seen between the nodes. f jumps where that is not small beside the last coefficients of the slopes, as
/// it is for smooth solutions; where h f_y is large it comes from fast modes. Errors in q' = v are those of v. False if
/// there is no jump.
template <class Rule, class Equations, class Iterate, class Wide>
bool find_jumps(const Rule& rule, const Equations& equations, const Iterate& x, const Wide& slopes,
                const Wide& inner, const std::decay_t<decltype(rule.first)>& negligible, Wide& jumps,
                std::vector<char>& marks) {
    const int n = equations.n(), m = rule.nodes(), s = equations.s();
    bool any = false;
    jumps.setZero(n, x.intervals());
    for (int i = 0; i < x.intervals(); ++i) {
        bool here = false;
        for (int c = equations.positions(); c < n; ++c) {
            if (!(rule.unseen * inner(c, i) > negligible) ||
                !(inner(c, i) > rule.jump_share * rule.last_coefficients(&slopes(c, i * m), n)))
                continue;
            if (!here && 4 * largest_rate(middle_jacobian(equations, x, i)) > 5 * s) break;
            jumps(c, i) = rule.unseen * inner(c, i);
            here = true;
        }
        if (here) marks[i] = 1, any = true;
    }
    return any;
}

}  // namespace stagecraft::detail
