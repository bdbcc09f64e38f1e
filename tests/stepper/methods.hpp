// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <initializer_list>
#include <stagecraft/tableau.hpp>
#include <vector>

// A few published methods, typed in from their papers' fractions.
namespace methods {

using stagecraft::tableau;

// Rows of A below each other, then b, then the embedded weights if there are any; c = A 1.
template <class S = double>
tableau<S> rows(const std::vector<std::vector<S>>& entries, bool embedded = false) {
    const int s = static_cast<int>(entries.size()) - (embedded ? 2 : 1);
    tableau<S> m;
    m.A.setZero(s, s);
    m.b.setZero(s);
    m.c.setZero(s);
    for (int i = 0; i < s; ++i)
        for (std::size_t j = 0; j < entries[i].size(); ++j) {
            m.A(i, static_cast<int>(j)) = entries[i][j];
            m.c(i) += entries[i][j];
        }
    for (std::size_t j = 0; j < entries[s].size(); ++j) m.b(static_cast<int>(j)) = entries[s][j];
    if (embedded) {
        m.b_embedded.setZero(s);
        for (std::size_t j = 0; j < entries[s + 1].size(); ++j)
            m.b_embedded(static_cast<int>(j)) = entries[s + 1][j];
    }
    return m;
}

template <class S = double>
tableau<S> classical() {
    return rows<S>({{}, {S(1) / 2}, {0, S(1) / 2}, {0, 0, 1}, {S(1) / 6, S(1) / 3, S(1) / 3, S(1) / 6}});
}

template <class S = double>
tableau<S> dormand_prince() {
    auto m = rows<S>(
        {{},
         {S(1) / 5},
         {S(3) / 40, S(9) / 40},
         {S(44) / 45, -S(56) / 15, S(32) / 9},
         {S(19372) / 6561, -S(25360) / 2187, S(64448) / 6561, -S(212) / 729},
         {S(9017) / 3168, -S(355) / 33, S(46732) / 5247, S(49) / 176, -S(5103) / 18656},
         {S(35) / 384, 0, S(500) / 1113, S(125) / 192, -S(2187) / 6784, S(11) / 84},
         {S(35) / 384, 0, S(500) / 1113, S(125) / 192, -S(2187) / 6784, S(11) / 84},
         {S(5179) / 57600, 0, S(7571) / 16695, S(393) / 640, -S(92097) / 339200, S(187) / 2100, S(1) / 40}},
        true);
    const S c[] = {0, S(1) / 5, S(3) / 10, S(4) / 5, S(8) / 9, 1, 1};
    for (int i = 0; i < 7; ++i) m.c(i) = c[i];
    return m;
}

// L-stable SDIRK of order 4, Hairer-Wanner II table IV.6.5.
inline tableau<double> sdirk_4_3() {
    auto m = rows<double>({{1. / 4},
                           {1. / 2, 1. / 4},
                           {17. / 50, -1. / 25, 1. / 4},
                           {371. / 1360, -137. / 2720, 15. / 544, 1. / 4},
                           {25. / 24, -49. / 48, 125. / 16, -85. / 12, 1. / 4},
                           {25. / 24, -49. / 48, 125. / 16, -85. / 12, 1. / 4},
                           {59. / 48, -17. / 96, 225. / 32, -85. / 12}},
                          true);
    const double c[] = {1. / 4, 3. / 4, 11. / 20, 1. / 2, 1};
    for (int i = 0; i < 5; ++i) m.c(i) = c[i];
    return m;
}

// TR-BDF2 as an ESDIRK method of order 2 with embedded order 3 (Hosea, Shampine 1996).
inline tableau<double> tr_bdf2() {
    const double g = 2 - std::sqrt(2.), d = g / 2, w = std::sqrt(2.) / 4;
    auto m = rows<double>({{}, {d, d}, {w, w, d}, {w, w, d}, {(1 - w) / 3, (3 * w + 1) / 3, d / 3}}, true);
    m.c(2) = 1;
    return m;
}

// Alexander's SDIRK of order 2 with two different diagonal entries is no SDIRK any more: a DIRK of order 1.
inline tableau<double> dirk_of_two_diagonals() { return rows<double>({{0.5}, {0.75, 0.25}, {0.75, 0.25}}); }

template <class S = double>
tableau<S> lobatto_iiia_3() {
    return rows<S>({{},
                    {S(5) / 24, S(1) / 3, -S(1) / 24},
                    {S(1) / 6, S(2) / 3, S(1) / 6},
                    {S(1) / 6, S(2) / 3, S(1) / 6}});
}

template <class S = double>
tableau<S> lobatto_iiib_3() {
    return rows<S>({{S(1) / 6, -S(1) / 6},
                    {S(1) / 6, S(1) / 3},
                    {S(1) / 6, S(5) / 6, 0},
                    {S(1) / 6, S(2) / 3, S(1) / 6}});
}

}  // namespace methods
