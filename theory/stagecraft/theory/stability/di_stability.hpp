// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/stability/a_stability.hpp"

namespace stagecraft::theory {

/// How far [0, x] goes with |R| >= 1: beyond it a growing solution is taken for a decaying one.
template <class K>
stability_interval<K> growth_interval(const stability_function<K>& r, int bits = 60) {
    const auto &p = r.numerator, &q = r.denominator;
    return detail::interval_of(p * p - q * q, detail::two_to_minus<K>(bits));
}

/// |R(z)| <= 1 for Re z <= 0 and |R(z)| > 1 for Re z > 0: what decays keeps decaying, and what grows keeps growing, so that
/// boundary value problems with modes of both kinds stay well posed on coarse meshes (Ascher-Mattheij-Russell, section
/// 7.2, di-stability). Exactly where A-stable with E = 0: then P(z) P(-z) = Q(z) Q(-z), in lowest terms the zeros of P are
/// the poles reflected, and the maximum principle holds for R on the left and for 1/R on the right. Symmetric methods
/// have E = 0. Refuted with the least x > 0 beyond which |R(x)| < 1, or a y with |R(iy)| < 1, near which |R| < 1 on
/// the right as well.
template <class K>
verdict di_stable(const stability_function<K>& r) {
    if (r.numerator.degree() <= 0 && r.denominator.degree() <= 0) return verdict::refuted("R is constant");
    const auto a = a_stable(r);
    if (a.is_refuted()) return a;
    const auto e = e_polynomial(r);
    if (e.is_zero()) return verdict::proved("A-stable and E = 0: |R| > 1 where Re z > 0");
    const auto growth = growth_interval(r, 20);
    if (!growth.infinite) return verdict::refuted("|R(x)| < 1 right of x = " + growth.high.str());
    const auto y = tableaux::negative_point_from_zero(in_square(polynomial<K>{} - e));
    return verdict::refuted("|R(iy)| < 1 at y^2 = " + y->str() + ", and so on the right of iy");
}

}  // namespace stagecraft::theory
