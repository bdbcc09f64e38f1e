// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "stagecraft/tableaux/exact_collocation.hpp"

namespace stagecraft::tableaux {

/// The method c | A over b as it stands; c = A 1 where it is left out. The order stated is Butcher's bound
/// from B, C, D. Throws std::invalid_argument where the sizes do not fit.
template <class K>
constructed<K> from_butcher(const dense<K>& A, const column<K>& b, const std::optional<column<K>>& c = {}) {
    constructed<K> out;
    auto& t = out.tableau;
    t.A = A;
    t.b = b;
    if (c) {
        t.c = *c;
    } else {
        t.c.resize(A.rows());
        for (Eigen::Index i = 0; i < A.rows(); ++i) {
            t.c[i] = K(0);
            for (Eigen::Index j = 0; j < A.cols(); ++j) t.c[i] = t.c[i] + A(i, j);
        }
    }
    const auto n = simplifying_orders_of(t);
    out.order = n.order();
    out.exact_order = out.order == n.B;
    out.reason = "B(" + std::to_string(n.B) + "), C(" + std::to_string(n.C) + "), D(" + std::to_string(n.D) +
                 ") by Butcher's theorem";
    return out;
}

namespace detail {

/// 1 b^T - A with nodes 1 - c, stage i of the new method being stage index(i) of the old one.
template <class K, class Index>
stagecraft::tableau<K> backwards(const stagecraft::tableau<K>& t, Index index) {
    require_shape(t);
    const auto s = t.b.size();
    stagecraft::tableau<K> out;
    out.A.resize(s, s);
    out.b.resize(s);
    out.c.resize(s);
    out.b_embedded.resize(t.b_embedded.size());
    for (Eigen::Index i = 0; i < s; ++i) {
        out.b[i] = t.b[index(i)];
        out.c[i] = K(1) - t.c[index(i)];
        if (t.b_embedded.size() != 0) out.b_embedded[i] = t.b_embedded[index(i)];
        for (Eigen::Index j = 0; j < s; ++j) out.A(i, j) = t.b[index(j)] - t.A(index(i), index(j));
    }
    return out;
}

}  // namespace detail

/// The adjoint method: a step back with -h, a*_ij = b_{s+1-j} - a_{s+1-i,s+1-j}, c*_i = 1 - c_{s+1-i}
/// (Hairer-Norsett-Wanner I, Theorem II.8.3). It has the same order.
template <class K>
stagecraft::tableau<K> adjoint(const stagecraft::tableau<K>& t) {
    return detail::backwards(t, [s = t.b.size()](Eigen::Index i) { return s - 1 - i; });
}

/// The reflected method 1 b^T - A, b, 1 - c (Scherer and Turke 1989): the adjoint with the stages numbered as
/// they were. Its stability function is 1/R(-z).
template <class K>
stagecraft::tableau<K> reflected(const stagecraft::tableau<K>& t) {
    return detail::backwards(t, [](Eigen::Index i) { return i; });
}

/// The transposed method diag(b)^-1 A^T diag(b) with row sums as nodes, 1 - c where D(1) holds (Scherer and
/// Turke 1989): it has the same stability function, and Radau IA and IIA are each other's up to numbering.
/// Throws std::invalid_argument where a weight vanishes.
template <class K>
constructed<K> transposed(const stagecraft::tableau<K>& t) {
    require_shape(t);
    const auto s = t.b.size();
    dense<K> A(s, s);
    for (Eigen::Index i = 0; i < s; ++i) {
        if (t.b[i] == K(0)) throw std::invalid_argument("b: weight " + std::to_string(i + 1) + " vanishes");
        for (Eigen::Index j = 0; j < s; ++j) A(i, j) = t.b[j] * t.A(j, i) / t.b[i];
    }
    return from_butcher<K>(A, t.b);
}

/// One step of `first` over the fraction theta of h, then one of `second` over the rest: A = [theta A1, 0;
/// theta 1 b1^T, (1-theta) A2]. Throws std::invalid_argument for theta = 0 or 1.
template <class K>
stagecraft::tableau<K> composition(const stagecraft::tableau<K>& first, const stagecraft::tableau<K>& second,
                                   const K& theta) {
    require_shape(first);
    require_shape(second);
    const K rest = K(1) - theta;
    if (theta == K(0) || rest == K(0)) throw std::invalid_argument("theta: must be neither 0 nor 1");
    const auto m = first.b.size();
    const auto s = m + second.b.size();
    stagecraft::tableau<K> out;
    out.A.resize(s, s);
    out.b.resize(s);
    out.c.resize(s);
    for (Eigen::Index i = 0; i < s; ++i) {
        out.b[i] = i < m ? theta * first.b[i] : rest * second.b[i - m];
        out.c[i] = i < m ? theta * first.c[i] : theta + rest * second.c[i - m];
        for (Eigen::Index j = 0; j < s; ++j) {
            out.A(i, j) = j < m ? (i < m ? theta * first.A(i, j) : theta * first.b[j])
                                : (i < m ? K(0) : rest * second.A(i - m, j - m));
        }
    }
    return out;
}

/// Half a step of the method, half a step of its adjoint: symmetric, so its order is even and, where the
/// method's own order is p, at least p (p + 1 where p is odd; Hairer-Lubich-Wanner, Theorem II.3.2 and
/// section II.4). `order` is the method's own.
template <class K>
constructed<K> symmetric_composition(const stagecraft::tableau<K>& t, int order) {
    constructed<K> out;
    out.tableau = composition<K>(t, adjoint(t), K(1) / K(2));
    out.order = order % 2 == 0 ? order : order + 1;
    out.reason = "composition of a method of order " + std::to_string(order) +
                 " with its adjoint: symmetric, hence of even order";
    return out;
}

}  // namespace stagecraft::tableaux
