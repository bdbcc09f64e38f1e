// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableau.hpp>
#include <type_traits>

#include "stagecraft/tableaux/range.hpp"
#include "stagecraft/theory/dynamics/interval.hpp"

// Exact tableaux for computations in doubles and in intervals.

namespace stagecraft::theory {

/// The number K (rational or quadratic) near x in doubles: to a unit or two in the last place.
template <class K>
double near_double(const K& x) {
    if constexpr (requires { x.template to<double>(); }) {
        return x.template to<double>();
    } else {
        return tableaux::to_range(x).middle().template to<double>();
    }
}

/// The tableau in doubles (A, b and c; embedded weights are left out).
template <class K>
tableau<double> in_doubles(const tableau<K>& t) {
    tableau<double> d;
    d.A = t.A.unaryExpr([](const K& x) { return near_double(x); });
    d.b = t.b.unaryExpr([](const K& x) { return near_double(x); });
    d.c = t.c.unaryExpr([](const K& x) { return near_double(x); });
    return d;
}

/// An enclosure of an exact number, rational or quadratic.
template <class K>
interval enclosed_number(const K& x) {
    if constexpr (std::is_same_v<K, tableaux::rational>) {
        return interval(x);
    } else {
        const auto r = tableaux::to_range(x);
        return hull(interval(r.lower), interval(r.upper));
    }
}

/// Whether A is strictly lower triangular.
template <class K>
bool is_explicit(const tableau<K>& t) {
    for (Eigen::Index i = 0; i < t.b.size(); ++i)
        for (Eigen::Index j = i; j < t.b.size(); ++j)
            if (!(t.A(i, j) == K(0))) return false;
    return true;
}

namespace detail {
void require_step(const tableaux::rational& h);
}  // namespace detail

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/tableau_numbers-inl.hpp"
#endif
