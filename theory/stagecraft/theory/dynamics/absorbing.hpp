// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "stagecraft/theory/dynamics/dissipativity.hpp"
#include "stagecraft/theory/dynamics/tableau_numbers.hpp"
#include "stagecraft/theory/stability/algebraic_stability.hpp"

namespace stagecraft::theory {

/// A ball around the centre that is positively invariant and absorbing for a method.
struct absorbing_set {
    double radius = 0;
    double decrease = 0;  ///< |x_n|^2 falls by at least this much in a step that ends outside

    /// Every run from |x - centre| <= start is inside after this many steps, and stays.
    long steps_from(double start) const;
};

namespace detail {

template <int N>
void require_everywhere(const dissipativity_constants<N>& d) {
    d.require_constants();
    if (!d.verdict.is_proved() || d.radius)
        throw std::invalid_argument("d: the dissipativity inequality must be proved everywhere");
}

/// An upper bound of |f| on |x - centre| <= radius, to one per cent.
template <int N, class F>
double largest_value(F&& f, const state<rational, N>& centre, double radius) {
    const search_limits limits{.absolute = 1e-12, .relative = 1e-2, .boxes = 20'000};
    const auto m = maximise_on_ball<N>(
        centre, radius, limits, [&](const box<N>& x, const box<N>&) { return length<N>(enclosed<N>(f, x)); });
    if (!std::isfinite(m.high)) throw std::invalid_argument("f: cannot be bounded on the ball");
    return m.high;
}

}  // namespace detail

/// The implicit Euler method, any step sizes with infinite sum: |x - centre|^2 <= alpha/beta + epsilon is
/// absorbing (sharper than lecture, Lemma 1.20): as long as |x_n|^2 exceeds it, (1 + 2 h beta) |x_n|^2 <=
/// |x_(n-1)|^2 + 2 h alpha. `decrease` is that of one unit of time.
template <int N>
absorbing_set absorbing_ball_of_implicit_euler(const dissipativity_constants<N>& d, double epsilon = 1e-3) {
    detail::require_everywhere<N>(d);
    if (!(epsilon > 0)) throw std::invalid_argument("epsilon: must be positive");
    return {d.absorbing_radius(epsilon), (2 * interval(d.beta) * epsilon).low()};
}

/// An absorbing ball of an algebraically stable method with b > 0 at equal steps h (lecture, Satz 1.23, which
/// leaves its radius open). From |x_1|^2 <= |x_0|^2 + 2 h sum_i b_i (alpha - beta |X_i|^2): either
/// sum_i b_i |X_i|^2 > alpha/beta + epsilon, and |x|^2 falls by 2 h beta epsilon, or every |X_j| <= R_j =
/// sqrt((alpha/beta + epsilon)/b_j) and one of them is at most sqrt(alpha/beta + epsilon); then, with F_j =
/// max |f| on |x| <= R_j and x_1 = X_i + h sum_j (b_j - a_ij) f(X_j),
///     |x_1| <= min( sqrt(alpha/beta + epsilon) + h max_i sum_j |b_j - a_ij| F_j,
///                   min_i (R_i + h sum_j |b_j - a_ij| F_j) ),
/// the second free of h where a row of A is b. Throws std::invalid_argument for h <= 0, for an inequality
/// that is not proved everywhere, and for a method that is inconsistent, has some b_i <= 0, or is not
/// algebraically stable.
template <int N, class K, class F>
absorbing_set absorbing_ball(const tableau<K>& method, F&& f, const dissipativity_constants<N>& d,
                             const rational& h, double epsilon = 1e-3) {
    detail::require_everywhere<N>(d);
    if (!(h > 0)) throw std::invalid_argument("h: must be positive, is " + h.str());
    if (!(epsilon > 0)) throw std::invalid_argument("epsilon: must be positive");
    K sum(0);
    for (Eigen::Index i = 0; i < method.b.size(); ++i) {
        if (!(K(0) < method.b[i]))
            throw std::invalid_argument("method: needs b > 0, b[" + std::to_string(i + 1) +
                                        "] = " + method.b[i].str());
        sum = sum + method.b[i];
    }
    if (!(sum == K(1))) throw std::invalid_argument("method: not consistent, sum b = " + sum.str());
    if (const auto v = algebraically_stable(method); !v.is_proved())
        throw std::invalid_argument("method: not algebraically stable: " + v.reason());
    const auto s = method.b.size();
    const interval level = interval(d.alpha) / interval(d.beta) + interval(epsilon);
    std::vector<interval> R, F_;
    for (Eigen::Index j = 0; j < s; ++j) {
        R.push_back(sqrt(level / enclosed_number(method.b[j])));
        F_.emplace_back(detail::largest_value<N>(f, d.centre, R.back().high()));
    }
    double largest = 0, least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < s; ++i) {
        interval move = 0;
        for (Eigen::Index j = 0; j < s; ++j)
            move += abs(enclosed_number(K(method.b[j] - method.A(i, j)))) * F_[static_cast<std::size_t>(j)];
        move *= interval(h);
        largest = std::max(largest, (sqrt(level) + move).high());
        least = std::min(least, (R[static_cast<std::size_t>(i)] + move).high());
    }
    return {std::min(largest, least), (2 * interval(h) * interval(d.beta) * epsilon).low()};
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/absorbing-inl.hpp"
#endif
