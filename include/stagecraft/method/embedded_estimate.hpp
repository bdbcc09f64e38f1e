// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <vector>

#include <stagecraft/linear/split_lu.hpp>
#include <stagecraft/method/order_conditions.hpp>
#include <stagecraft/method/structure.hpp>

namespace stagecraft {

namespace detail {

/// True if the w_i of stages with the same node (those before `first` left out) sum to zero but for rounding:
/// then sum_i w_i g(c_i) is zero for every g.
template <class Scalar, int Stages, class Weights>
bool vanishes_at_every_node(const tableau<Scalar, Stages>& m, const Weights& w, int first) {
    using std::abs;
    Scalar size(0);
    for (int i = first; i < m.stages(); ++i) size += abs(w[i]);
    for (int i = first; i < m.stages(); ++i) {
        Scalar sum(0);
        for (int j = first; j < m.stages(); ++j)
            if (holds(m.c[j], m.c[i])) sum += w[j];
        if (abs(sum) > condition_tolerance<Scalar>() * size) return false;
    }
    return true;
}

}  // namespace detail

/// True if the weights d = b - b_embedded see no error of a quadrature y' = f(t), whatever f and the step are
/// (Fehlberg's pairs of order 5(6) and 7(8); Hairer-Norsett-Wanner I.II.5): h sum_j d_j f(t + c_j h) is zero.
template <class Scalar, int Stages, class Weights>
bool blind_to_quadrature(const tableau<Scalar, Stages>& m, const Weights& d) {
    return detail::vanishes_at_every_node(m, d, 0);
}

/// Whether the estimate h sum_j d_j k_j is to be multiplied by (M - h a J)^-1 M.
///
/// In a stiff component the stages lie on the smooth solution. If y1 is the last stage, so does y1: its error
/// is O(1/z) with z = h lambda, and an estimate that is O(1) needs the filter to become as small. There are
/// two exceptions. If y1 is no stage, its error is O(1) like the estimate, and the filter would hide it. If
/// the estimate is a difference of stages at the same node, as for two stiffly accurate methods, it is O(1/z)
/// already. With w = A_r^-T d_r, A_r being A without a left stage, the estimate is sum_i w_i z_i + (d_1 - w^T
/// a_1) h k_1; the second exception holds if the w_i of every node sum to zero and d_1 - w^T a_1 is zero.
template <class Scalar, int Stages, class Weights>
bool needs_filter(const tableau<Scalar, Stages>& m, const tableau_structure& is, const Weights& d) {
    using std::abs;
    if (!is.stiffly_accurate || !is.regular()) return false;
    const int s = m.stages(), first = is.left_stage ? 1 : 0, n = s - first;
    split_lu<Scalar, -1> lu(n);
    std::vector<Scalar> w(static_cast<std::size_t>(s), Scalar(0));
    for (int i = 0; i < n; ++i) {
        w[i + first] = d[i + first];
        for (int j = 0; j < n; ++j) lu.entries()[i + j * n] = m.A(first + j, first + i);
    }
    if (!lu.factor()) return true;
    lu.solve(w.data() + first);
    if (!detail::vanishes_at_every_node(m, w, first)) return true;
    if (!is.left_stage) return false;
    Scalar left = d[0], size = abs(d[0]);
    for (int i = first; i < s; ++i) {
        left -= w[i] * m.A(i, 0);
        size += abs(w[i] * m.A(i, 0));
    }
    return abs(left) > detail::condition_tolerance<Scalar>() * size;
}

}  // namespace stagecraft
