// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/theory/judging/order_finding.hpp>
#include <stagecraft/theory/statements/certainty.hpp>
#include <stagecraft/theory/statements/verdict.hpp>
#include <string>
#include <vector>

namespace stagecraft::theory {

namespace detail {

inline bool certainly_before(const tableaux::quadratic& x, const tableaux::quadratic& y) { return x < y; }
bool certainly_before(const tableaux::ball& x, const tableaux::ball& y);
inline double middle_of(const tableaux::quadratic& x) { return x.to<double>(); }
inline double middle_of(const tableaux::ball& x) { return x.middle().to<double>(); }
/// The number as a sentence has it.
inline std::string plain(const tableaux::quadratic& x) { return in_words(x); }
inline std::string plain(const tableaux::ball& x) { return brief(x.middle().to<tableaux::bound>()); }

/// 0, the nodes between and 1, increasing; of nodes that are not certainly different one.
template <class K>
std::vector<K> ends_of_gaps(const tableau<K>& t) {
    std::vector<K> ends{K(0)};
    for (int i = 0; i < t.stages(); ++i)
        if (certainly_before(K(0), t.c(i)) && certainly_before(t.c(i), K(1))) ends.push_back(t.c(i));
    std::stable_sort(ends.begin(), ends.end(),
                     [](const K& x, const K& y) { return middle_of(x) < middle_of(y); });
    ends.push_back(K(1));
    const auto same = [](const K& x, const K& y) { return !certainly_before(x, y); };
    ends.erase(std::unique(ends.begin(), ends.end(), same), ends.end());
    return ends;
}

}  // namespace detail

/// Whether the embedded estimate h sum_i (b_i - b^_i) k_i shows every jump of f. A jump by J at t + theta h changes
/// it by h J d, d being the sum of b_i - b^_i over the stages with c_i > theta, while y_1 errs by h J times the sum of
/// those b_i less 1 - theta. Refuted with the gaps between neighbouring nodes in which d = 0, proved with the gap
/// in which |d| is least. t has b_embedded. O(s^2).
template <class K>
verdict jumps_seen(const tableau<K>& t) {
    const auto ends = detail::ends_of_gaps(t);
    std::string blind, faintest;
    tableaux::bound least = 0, open_residual = 0, open_bound = 0, scale = 0;
    bool open = false;
    for (int i = 0; i < t.stages(); ++i) scale = std::max(scale, size_of(K(t.b(i))));
    for (std::size_t g = 0; g + 1 < ends.size(); ++g) {
        K change(0);
        for (int i = 0; i < t.stages(); ++i)
            if (detail::certainly_before(ends[g], t.c(i))) change = change + (t.b(i) - t.b_embedded(i));
        const std::string gap = "(" + detail::plain(ends[g]) + ", " + detail::plain(ends[g + 1]) + ")";
        const auto size = size_of(change);
        if (certainly_nonzero(change)) {
            if (faintest.empty() || size < least) {
                least = size;
                faintest = "jumps of f in " + gap + " show least in the embedded estimate, " +
                           detail::plain(certainly_negative(change) ? -change : change) + " times their size";
            }
            continue;
        }
        blind += (blind.empty() ? "" : " and ") + gap;
        if constexpr (!exact_scalar<K>) {
            open = open || !change.exactly_zero();
            open_residual = std::max(open_residual, change.magnitude());
            open_bound = std::max(open_bound, change.radius());
        }
    }
    if (blind.empty()) return verdict::proved(faintest);
    const std::string why = "the embedded estimate sees no jump of f in " + blind;
    if (open) return open_case(open_residual, open_bound, scale, why + ", up to rounding");
    return verdict::refuted(why);
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/jumps_seen-inl.hpp"
#endif
