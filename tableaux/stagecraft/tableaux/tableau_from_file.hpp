// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <limits>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>

namespace stagecraft::tableaux {

/// The Real nearest to a rational number (for a multiprecision float good to a few units of the last place).
template <class Real = double>
Real nearest(const rational& q) {
    return widening(significand_bits<Real> + 64, [&](int bits) {
        const auto value = nearest<Real>(ball(q, bits));
        if (!value) throw undecided("nearest: a rational number half-way between two floating-point ones");
        return *value;
    });
}

/// The Real nearest to an entry; to a decimal as it is written.
template <class Real = double>
Real rounded(const entry& e) {
    return nearest<Real>(e.exact && e.exact->is_rational() ? e.exact->rational_part() : e.enclosure.middle());
}

/// The method of a tableau file in the numbers a stepper computes with, each entry rounded once: exact
/// entries to the nearest double or long double, decimals from the number as it is written. The facts are
/// what the file claims (`stagecraft certify` proves or refutes it). What it does not claim is 0 or false, R(inf) is NaN.
template <class Real = double>
tableau<Real> rounded(const tableau_file& file) {
    auto t = to_tableau<Real>(file, [](const entry& e) { return rounded<Real>(e); });
    auto& f = t.facts;
    f.order = file.claims.order.value_or(0);
    f.stage_order = file.claims.stage_order.value_or(0);
    const bool l_stable = file.claims.l_stable.value_or(false);
    f.a_stable = l_stable || file.claims.a_stable.value_or(false);
    f.algebraically_stable = file.claims.algebraically_stable.value_or(false);
    f.symplectic = file.claims.symplectic.value_or(false);
    f.symmetric = file.claims.symmetric.value_or(false);
    f.r_infinity = l_stable ? 0.0 : std::numeric_limits<double>::quiet_NaN();
    return t;
}

/// The same for an exact tableau over Q, with the facts that it carries.
template <class Real = double>
tableau<Real> rounded(const tableau<rational>& exact) {
    const int s = exact.stages();
    tableau<Real> t;
    t.A.resize(s, s);
    t.b.resize(s);
    t.c.resize(s);
    t.b_embedded.resize(exact.b_embedded.size());
    for (int i = 0; i < s; ++i) {
        for (int j = 0; j < s; ++j) t.A(i, j) = nearest<Real>(exact.A(i, j));
        t.b(i) = nearest<Real>(exact.b(i));
        t.c(i) = nearest<Real>(exact.c(i));
        if (t.b_embedded.size() != 0) t.b_embedded(i) = nearest<Real>(exact.b_embedded(i));
    }
    t.facts = exact.facts;
    return t;
}

}  // namespace stagecraft::tableaux
