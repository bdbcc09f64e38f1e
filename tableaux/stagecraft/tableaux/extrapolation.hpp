// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <limits>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stdexcept>
#include <vector>

namespace stagecraft::tableaux {

/// What is extrapolated: explicit Euler, whose error has an expansion in powers of h, or the explicit midpoint rule
/// y_{m+1} = y_{m-1} + 2 h f(y_m) after one step of Euler (Gragg), whose error after an even number of steps has one in h^2.
enum class base_method { explicit_euler, explicit_midpoint };

namespace detail {

using stage_row = tableau<rational>::vector;

/// One step of length 1 in n steps of the base method: what y_n adds to y_0, as weights of the stages. The first stage is
/// f(y_0); the n - 1 others are written into A from row `next` on.
inline stage_row steps_of(base_method base, int n, tableau<rational>& t, Eigen::Index& next) {
    const bool euler = base == base_method::explicit_euler;
    const rational h(1, n);
    stage_row before = stage_row::Constant(t.b.size(), rational(0)), now = before;
    now[0] = h;
    for (int m = 1; m < n; ++m, ++next) {
        t.A.row(next) = now.transpose();
        stage_row after = euler ? now : before;
        after[next] += euler ? h : 2 * h;
        before = now;
        now = after;
    }
    return now;
}

/// The value at h = 0 of the polynomial in h^power through the results from number `first` on.
inline stage_row at_zero(const std::vector<stage_row>& results, const std::vector<int>& sequence, int power,
                         std::size_t first) {
    const auto to_power = [&](int n) { return power == 1 ? rational(n) : rational(n) * rational(n); };
    stage_row sum = stage_row::Constant(results[0].size(), rational(0));
    for (std::size_t j = first; j < results.size(); ++j) {
        rational weight(1);
        for (std::size_t i = first; i < results.size(); ++i)
            if (i != j) weight *= to_power(sequence[j]) / (to_power(sequence[j]) - to_power(sequence[i]));
        for (Eigen::Index k = 0; k < sum.size(); ++k) sum[k] += weight * results[j][k];
    }
    return sum;
}

}  // namespace detail

/// The extrapolated method with these numbers of steps n_1 < ... < n_k as one explicit Runge-Kutta method, exactly: T_kk as b, with
/// T_{k,k-1} as b_embedded if k > 1. They share f(y_0): 1 + sum (n_j - 1) stages. The orders are k and k - 1 for explicit Euler,
/// 2k and 2k - 2 for the midpoint rule, which is not smoothed at the end (Hairer-Norsett-Wanner I, section II.9); the facts say
/// so, and `certify` proves it. Throws std::invalid_argument for a sequence that is empty, does not increase, begins below
/// 1 or, for the midpoint rule, has an odd number.
inline tableau<rational> extrapolation(base_method base, const std::vector<int>& sequence) {
    const int power = base == base_method::explicit_euler ? 1 : 2, k = static_cast<int>(sequence.size());
    if (sequence.empty()) throw std::invalid_argument("sequence: must have a number of steps");
    int stages = 1, last = 0;
    for (const int n : sequence) {
        if (n <= last) throw std::invalid_argument("sequence: must increase from at least 1");
        if (n % power != 0)
            throw std::invalid_argument(
                "sequence: the midpoint rule has an expansion in h^2 for even numbers");
        stages += n - 1;
        last = n;
    }
    tableau<rational> t;
    t.A = tableau<rational>::matrix::Constant(stages, stages, rational(0));
    t.b = t.c = detail::stage_row::Constant(stages, rational(0));
    std::vector<detail::stage_row> results;
    Eigen::Index next = 1;
    for (const int n : sequence) results.push_back(detail::steps_of(base, n, t, next));
    for (Eigen::Index i = 0; i < stages; ++i)
        for (Eigen::Index j = 0; j < i; ++j) t.c[i] += t.A(i, j);
    t.b = detail::at_zero(results, sequence, power, 0);
    if (k > 1) t.b_embedded = detail::at_zero(results, sequence, power, 1);
    t.facts.order = power * k;
    t.facts.stage_order = 1;
    t.facts.r_infinity = std::numeric_limits<double>::quiet_NaN();
    return t;
}

}  // namespace stagecraft::tableaux
