// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <stdexcept>

#include "stagecraft/method/simplifying_assumptions.hpp"
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

using stagecraft::simplifying_orders;

/// Butcher's simplifying assumptions, decided over an exact field.
template <class K>
simplifying_orders simplifying_orders_of(const tableau<K>& t) {
    require_shape(t);
    return stagecraft::simplifying_orders_of(t, std::equal_to<>{});
}

}  // namespace stagecraft::tableaux
