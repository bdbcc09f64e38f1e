// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <stdexcept>

#include "stagecraft/tableau.hpp"
#include "stagecraft/tableaux/small_solve.hpp"

namespace stagecraft::tableaux {

/// Throws std::invalid_argument, naming the part, where A, b, c do not fit together.
template <class K>
void require_shape(const tableau<K>& t) {
    const auto s = t.b.size();
    if (s == 0) throw std::invalid_argument("tableau: b is empty");
    if (t.A.rows() != s || t.A.cols() != s) throw std::invalid_argument("tableau: A does not fit b");
    if (t.c.size() != s) throw std::invalid_argument("tableau: c does not fit b");
    if (t.b_embedded.size() != 0 && t.b_embedded.size() != s) {
        throw std::invalid_argument("tableau: b_embedded does not fit b");
    }
}

/// The largest B(p), C(q), D(r) that hold (Butcher's simplifying assumptions; lecture, Definitions 2.5, 2.7,
/// 2.8), each at most 2s + 1: for s = 1 and c = 1, say, D(r) holds for every r.
struct simplifying_orders {
    int B = 0;
    int C = 0;
    int D = 0;

    /// The order that Butcher's theorem of 1964 gives (lecture, Satz 2.9): min(B, C + D + 1, 2 C + 2), a
    /// lower bound of the order. Needs C >= 1; with row sums that differ from c it says nothing and is 0.
    int order() const { return C == 0 ? std::min(B, 1) : std::min({B, C + D + 1, 2 * C + 2}); }
    friend bool operator==(const simplifying_orders&, const simplifying_orders&) = default;
};

/// Exact over an exact field. O(s^3) operations: B at most 2s, C at most s for distinct nodes.
template <class K>
simplifying_orders simplifying_orders_of(const tableau<K>& t) {
    require_shape(t);
    const auto s = t.b.size();
    const int limit = 2 * static_cast<int>(s) + 1;
    simplifying_orders found{limit, limit, limit};
    bool in_b = true, in_c = true, in_d = true;
    column<K> power(s);  // c^(k-1)
    for (Eigen::Index i = 0; i < s; ++i) power[i] = K(1);
    for (int k = 1; k <= limit && (in_b || in_c || in_d); ++k) {
        K moment(0);
        for (Eigen::Index i = 0; i < s; ++i) moment = moment + t.b[i] * power[i];
        if (in_b && !(moment * K(k) == K(1))) {
            in_b = false;
            found.B = k - 1;
        }
        for (Eigen::Index i = 0; i < s; ++i) {
            K row(0), col(0);
            for (Eigen::Index j = 0; j < s; ++j) {
                row = row + t.A(i, j) * power[j];
                col = col + t.b[j] * power[j] * t.A(j, i);
            }
            const K next = power[i] * t.c[i];  // c_i^k
            if (in_c && !(row * K(k) == next)) {
                in_c = false;
                found.C = k - 1;
            }
            if (in_d && !(col * K(k) == t.b[i] * (K(1) - next))) {
                in_d = false;
                found.D = k - 1;
            }
        }
        for (Eigen::Index i = 0; i < s; ++i) power[i] = power[i] * t.c[i];
    }
    return found;
}

}  // namespace stagecraft::tableaux
