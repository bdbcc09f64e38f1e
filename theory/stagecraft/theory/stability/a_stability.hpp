// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "stagecraft/tableaux/sturm.hpp"
#include "stagecraft/theory/stability/stability_function.hpp"
#include "stagecraft/theory/statements/verdict.hpp"

namespace stagecraft::theory {

/// E(y) = |Q(iy)|^2 - |P(iy)|^2, an even polynomial: |R(iy)| <= 1 exactly where E(y) >= 0
/// (Hairer-Wanner II, formula IV.3.8).
template <class K>
polynomial<K> e_polynomial(const stability_function<K>& r) {
    const auto p = tableaux::on_imaginary_axis(r.numerator);
    const auto q = tableaux::on_imaginary_axis(r.denominator);
    return q.real * q.real + q.imaginary * q.imaginary - p.real * p.real - p.imaginary * p.imaginary;
}

/// The polynomial p(x) with p(y^2) = even(y). Throws std::invalid_argument where an odd power occurs.
template <class K>
polynomial<K> in_square(const polynomial<K>& even) {
    std::vector<K> v;
    for (int k = 0; k <= even.degree(); ++k) {
        if (k % 2 == 0) v.push_back(even[k]);
        if (k % 2 != 0 && !(even[k] == K(0)))
            throw std::invalid_argument("in_square: not an even polynomial");
    }
    return polynomial<K>(std::move(v));
}

/// |R(iy)| <= 1 for all real y. Refuted with a y^2; decided by Sturm's theorem on the factors of odd
/// multiplicity of E.
template <class K>
verdict i_stable(const stability_function<K>& r) {
    const auto e = e_polynomial(r);
    const auto bad = tableaux::negative_point_from_zero(in_square(e));
    if (!bad) return verdict::proved("E(y) = " + to_string(e, "y") + (e.is_zero() ? "" : " >= 0"));
    return verdict::refuted("|R(iy)| > 1 at y^2 = " + bad->str());
}

/// |R(z)| <= 1 for Re z <= 0: I-stable and every pole in the open right half-plane (maximum principle;
/// Hairer-Wanner II.IV.3; lecture, Definition 2.21). Both are decided exactly. A statement about R in lowest terms, as
/// the definition is: stages of a reducible method, whose P and Q share a factor, can have poles that R has not.
template <class K>
verdict a_stable(const stability_function<K>& r) {
    const auto axis = i_stable(r);
    if (axis.is_refuted()) return axis;
    if (const auto poles = r.poles(); poles.left > 0) {
        return verdict::refuted(std::to_string(poles.left) + " pole(s) in the left half-plane, roots of " +
                                to_string(r.denominator, "z"));
    }
    return verdict::proved(axis.reason() + ", poles in the right half-plane");
}

/// A-stable with |R(infinity)| < 1 (lecture, Definition 2.21).
template <class K>
verdict strongly_a_stable(const stability_function<K>& r) {
    const auto a = a_stable(r);
    if (a.is_refuted()) return a;
    const K limit = *r.at_infinity();  // A-stable: it exists
    if (tableaux::sign_of(limit * limit - K(1)) < 0) {
        return verdict::proved(a.reason() + ", R(inf) = " + limit.str());
    }
    return verdict::refuted("R(inf) = " + limit.str());
}

/// A-stable with R(infinity) = 0 (Hairer-Wanner II.IV.3; lecture, Definition 2.21).
template <class K>
verdict l_stable(const stability_function<K>& r) {
    const auto a = a_stable(r);
    if (a.is_refuted()) return a;
    const K limit = *r.at_infinity();
    if (limit == K(0)) return verdict::proved(a.reason() + ", R(inf) = 0");
    return verdict::refuted("R(inf) = " + limit.str());
}

/// Q(-x)^2 - P(-x)^2: non-negative exactly where |R(-x)| <= 1.
template <class K>
polynomial<K> real_axis_polynomial(const stability_function<K>& r) {
    const auto p = tableaux::reflected(r.numerator);
    const auto q = tableaux::reflected(r.denominator);
    return q * q - p * p;
}

/// |R(x)| <= 1 for all real x <= 0.
template <class K>
verdict a0_stable(const stability_function<K>& r) {
    const auto bad = tableaux::negative_point_from_zero(real_axis_polynomial(r));
    if (!bad) return verdict::proved("Q(x)^2 >= P(x)^2 for x <= 0");
    return verdict::refuted("|R(x)| > 1 at x = " + (K(0) - *bad).str());
}

/// An interval [0, end] of stability on half an axis: end is infinite, or enclosed in [low, high] (an exact
/// value where they agree).
template <class K>
struct stability_interval {
    bool infinite = false;
    K low{};
    K high{};
};

namespace detail {

template <class K>
stability_interval<K> interval_of(const polynomial<K>& p, const K& width) {
    const auto loss = tableaux::first_sign_loss(p, width);
    if (!loss) return {true, K(0), K(0)};
    return {false, loss->low, loss->high};
}

template <class K>
K two_to_minus(int bits) {
    K width(1);
    for (int k = 0; k < bits; ++k) width = width / K(2);
    return width;
}

}  // namespace detail

/// The largest x with |R| <= 1 on [-x, 0], enclosed to 2^-bits.
template <class K>
stability_interval<K> real_stability_interval(const stability_function<K>& r, int bits = 60) {
    return detail::interval_of(real_axis_polynomial(r), detail::two_to_minus<K>(bits));
}

/// The largest y^2 with |R| <= 1 on [-iy, iy], enclosed to 2^-bits. (The square: it is often rational, as the
/// 8 of the classical method; see imaginary_stability_interval for y itself.)
template <class K>
stability_interval<K> imaginary_stability_square(const stability_function<K>& r, int bits = 60) {
    return detail::interval_of(in_square(e_polynomial(r)), detail::two_to_minus<K>(bits));
}

/// The largest y with |R| <= 1 on [-iy, iy], enclosed to 2^-bits.
template <class K>
stability_interval<K> imaginary_stability_interval(const stability_function<K>& r, int bits = 60) {
    return detail::interval_of(e_polynomial(r), detail::two_to_minus<K>(bits));
}

}  // namespace stagecraft::theory
