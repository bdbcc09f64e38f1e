// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/method/stabilised_method.hpp>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/rational.hpp>

namespace stagecraft::theory {

/// What is proved of the stability function R of a stabilised method with s stages on the negative real axis.
struct stabilised_interval {
    int stages;
    tableaux::rational beta;      ///< the interval is [-beta, 0]
    tableaux::rational damped;    ///< |R| is at most this where w_0 + w_1 z <= 1
    tableaux::rational smallest;  ///< and R at least this on all of it
    bool stable;                  ///< proved: |R(z)| <= 1 for -beta <= z <= 0
    tableaux::rational
        largest_stage;  ///< the same bound of all stages: what an error of one of them becomes at most
};

/// Decides |R| <= 1 on [-beta, 0] in rational arithmetic. For -1 <= x <= 1, x = w_0 + w_1 z, the family's polynomials satisfy
/// |p_s(x)| <= p_s(1) (Szego 7.33; for Chebyshev's it is |cos| <= 1), so that R = a_s + b_s p_s(x), b_s > 0, lies between
/// a_s - b_s p_s(1) and a_s + b_s p_s(1). For 1 <= x <= w_0 p_s increases, as all its zeros lie in (-1, 1), and R with it up
/// to R(0) = 1. The same holds for every stage. Costs O(s) operations with numbers of O(s) digits.
inline stabilised_interval decide_stabilised_interval(const stabilised_method<tableaux::rational>& m, int s) {
    using tableaux::rational;
    stabilised_recurrence<rational> rows(m);
    rows.make(s);
    const auto size = [](const rational& x) { return x < rational(0) ? -x : x; };
    const auto larger = [](const rational& x, const rational& y) { return x < y ? y : x; };
    stabilised_interval found{s,     rows.beta(), larger(size(rows.least()), size(rows.most())), rows.least(),
                              false, rational(0)};
    found.stable = rows.weight(s) > rational(0) && rows.least() >= rational(-1) &&
                   rows.most() <= rational(1) && rows.beta() > rational(0);
    for (int j = 1; j <= s; ++j) found.largest_stage = larger(found.largest_stage, rows.bound(j));
    return found;
}

/// The method with s stages as a tableau, A strictly lower triangular: what its recurrence adds up to, in any scalar. O(s^3).
template <class K>
tableau<K> stabilised_tableau(const stabilised_method<K>& m, int s) {
    stabilised_recurrence<K> rows(m);
    rows.make(s);
    typename tableau<K>::matrix all = tableau<K>::matrix::Constant(s + 1, s, K(0));  // row j: of Y_j
    for (int j = 1; j <= s; ++j) {
        const auto& r = rows.at(j);
        for (int k = 0; k < j && j > 1; ++k) all(j, k) = r.mu * all(j - 1, k) + r.nu * all(j - 2, k);
        all(j, j - 1) += r.rate;
        all(j, 0) += r.start;
    }
    tableau<K> t;
    t.A = all.topRows(s);
    t.b = all.row(s).transpose();
    t.c.resize(s);
    for (int j = 0; j < s; ++j) t.c[j] = j > 0 ? rows.at(j).c : K(0);
    return t;
}

}  // namespace stagecraft::theory
