// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/exact_cost.hpp"

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/range.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE int determinant_bits(const subject<tableaux::quadratic>& s) {
    int bits = 0;
    for (int i = 0; i < s.stages(); ++i) {
        int longest = 0;
        for (int j = 0; j < s.stages(); ++j) longest = std::max(longest, tableaux::bit_size(s.t.A(i, j)));
        bits += longest;
    }
    return bits;
}

STAGECRAFT_INLINE subject<tableaux::ball> enclosed(const subject<tableaux::quadratic>& s) {
    subject<tableaux::ball> e{{}, s.nodes_given, s.strictly_lower, s.lower};
    const auto map = [](const auto& from, auto& to) {
        to.resize(from.rows(), from.cols());
        for (int i = 0; i < from.rows(); ++i)
            for (int j = 0; j < from.cols(); ++j) to(i, j) = to_ball(tableaux::to_range(from(i, j)));
    };
    map(s.t.A, e.t.A);
    map(s.t.b, e.t.b);
    map(s.t.c, e.t.c);
    map(s.t.b_embedded, e.t.b_embedded);
    return e;
}

}  // namespace stagecraft::theory
