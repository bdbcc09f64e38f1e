// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>

#include <stagecraft/method/order_conditions.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>
#include <stagecraft/tableau.hpp>

namespace stagecraft {

namespace detail {

/// Whether the first stage of m is f(t, y), and whether its last one is that of the next step besides.
struct shared_stages {
    bool first, last;
};
template <class Scalar, int Stages>
shared_stages shared_stages_of(const tableau<Scalar, Stages>& m) {
    const int s = m.stages();
    bool first = true;
    for (int j = 0; j < s; ++j) first = first && m.A(0, j) == Scalar(0);
    bool last = first && s > 1 && m.c[s - 1] == Scalar(1);
    for (int j = 0; j < s; ++j) last = last && m.A(s - 1, j) == m.b[j];
    return {first, last};
}

/// step_doubling() of a method of order p, with these stages shared.
template <class Scalar, int Stages>
tableau<Scalar> doubled(const tableau<Scalar, Stages>& m, int p, shared_stages shared) {
    const int s = m.stages(), first = shared.first ? 1 : 0, second = shared.last ? 1 : 0,
              size = 3 * s - first - second;
    // Stages of the whole step are 0 ... s-1; those of the first half follow, save a shared one; then those
    // of the second, save one handed on.
    const auto whole = [](int i) { return i; };
    const auto left = [&](int i) { return i < first ? i : s + i - first; };
    const auto right = [&](int i) { return i < second ? left(s - 1) : 2 * s + i - first - second; };

    tableau<Scalar> r;
    r.A = decltype(r.A)::Constant(size, size, Scalar(0));
    r.b = r.c = decltype(r.b)::Constant(size, Scalar(0));
    Scalar power = Scalar(1);
    for (int k = 0; k < p; ++k) power *= Scalar(2);
    const Scalar half = Scalar(1) / Scalar(2), share = Scalar(1) / (power - Scalar(1));
    for (int i = 0; i < s; ++i) {
        r.c[whole(i)] = m.c[i];
        if (i >= first) r.c[left(i)] = m.c[i] * half;
        if (i >= second) r.c[right(i)] = half + m.c[i] * half;
        for (int j = 0; j < s; ++j) {
            r.A(whole(i), whole(j)) = m.A(i, j);
            if (i >= first) r.A(left(i), left(j)) = m.A(i, j) * half;
            if (i < second) continue;
            r.A(right(i), left(j)) += m.b[j] * half;
            r.A(right(i), right(j)) += m.A(i, j) * half;
        }
        r.b[left(i)] += m.b[i] * half;
        r.b[right(i)] += m.b[i] * half;
    }
    r.b_embedded = r.b * (Scalar(1) - share);
    for (int i = 0; i < s; ++i) r.b_embedded[whole(i)] += m.b[i] * share;
    r.facts = m.facts;  // two steps of a method have these properties where one has
    r.facts.order = p;
    r.facts.stage_order = 0;
    r.facts.r_infinity = m.facts.r_infinity * m.facts.r_infinity;
    return r;
}

}  // namespace detail

/// The method that takes two half steps of m and estimates their error by a whole one (Hairer-Norsett-Wanner
/// I.II.4; lecture 2.4.1): for a method without embedded weights.
///
/// The result is a tableau of 3 s stages, those of the whole step first, and 3 s - 1 where the first stage of
/// m is f(t, y), which the whole and the first half step share; 3 s - 2 where the last stage is that of the
/// next step besides (last row of A equal to b, c_s = 1), so that it serves both half steps, and singular
/// mass matrices are those that m serves. It is explicit, diagonally implicit or stiffly accurate if m is;
/// the stages of another method are solved as one system. Its embedded weights are such that b - b_embedded
/// is (b - b_whole) / (2^p - 1), the leading term of the error, p being m.facts.order or, where that is not
/// set, the order found. Throws std::invalid_argument if m has no stages or order 0.
template <class Scalar, int Stages>
tableau<Scalar> step_doubling(const tableau<Scalar, Stages>& m) {
    if (m.stages() < 1) throw std::invalid_argument("step_doubling: method has no stages");
    const int p = classical_order(m);
    if (p < 1) throw std::invalid_argument("step_doubling: method has order 0");
    return detail::doubled(m, p, detail::shared_stages_of(m));
}

namespace detail {
struct call_of_step_doubling {
    template <class Method>
    static constexpr bool say() {
        static_assert(
            never<Method>,
            "step_doubling(method): the method must be a tableau, gauss<3>() with its parentheses, say");
        return true;
    }
};
}  // namespace detail

/// Of what is no tableau.
tableau<double> step_doubling(detail::refused_call<detail::call_of_step_doubling>, ...);

}  // namespace stagecraft
