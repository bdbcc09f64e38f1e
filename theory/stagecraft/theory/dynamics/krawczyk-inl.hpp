// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/krawczyk.hpp"

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE interval_vector centre_of(const interval_vector& x) {
    return x.unaryExpr([](const interval& a) { return interval(a.middle()); });
}

STAGECRAFT_INLINE bool overlap(const interval_vector& a, const interval_vector& b) {
    for (Eigen::Index i = 0; i < a.size(); ++i)
        if (disjoint(a[i], b[i])) return false;
    return true;
}

STAGECRAFT_INLINE Eigen::Index widest_side(const interval_vector& x) {
    Eigen::Index k = 0;
    for (Eigen::Index i = 1; i < x.size(); ++i)
        if (x[i].width() > x[k].width()) k = i;
    return k;
}

}  // namespace detail

}  // namespace stagecraft::theory
