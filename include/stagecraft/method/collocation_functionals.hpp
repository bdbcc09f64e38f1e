// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include <stagecraft/linear/split_lu.hpp>
#include <stagecraft/method/legendre_values.hpp>
#include <stagecraft/tableau.hpp>

// Linear functionals of the stage polynomial u, given by z_i = u(c_i h) - y: weights, one per stage, distinct
// nodes.

namespace stagecraft {

/// z -> h u'(0) of the polynomial through y and the stages, no node being 0.
template <class Scalar, int Stages>
Eigen::Matrix<Scalar, Stages, 1> slope_at_left_end(const tableau<Scalar, Stages>& m) {
    const int s = m.stages();
    Eigen::Matrix<Scalar, Stages, 1> w(s);
    for (int j = 0; j < s; ++j) {
        Scalar product = m.c[j];
        for (int k = 0; k < s; ++k)
            if (k != j) product *= m.c[j] - m.c[k];
        w[j] = Scalar(1) / product;
        for (int k = 0; k < s; ++k)
            if (k != j) w[j] *= -m.c[k];
    }
    return w;
}

/// z -> h u'(1) of the polynomial through the stages, and through y where 0 is no node.
template <class Scalar, int Stages>
Eigen::Matrix<Scalar, Stages, 1> slope_at_right_end(const tableau<Scalar, Stages>& m) {
    const int s = m.stages();
    Eigen::Matrix<Scalar, Stages, 1> w(s);
    for (int j = 0; j < s; ++j) {
        Scalar value = Scalar(1), slope = Scalar(0);  // of the Lagrange function at 1, factor by factor
        const auto factor = [&](const Scalar& node) {
            const Scalar width = m.c[j] - node;
            slope = (slope * (Scalar(1) - node) + value) / width;
            value *= (Scalar(1) - node) / width;
        };
        if (!(m.c[0] == Scalar(0))) factor(Scalar(0));
        for (int k = 0; k < s; ++k)
            if (k != j) factor(m.c[k]);
        w[j] = slope;
    }
    return w;
}

/// z -> change of the polynomial at the end of the step if the node 0 is left out, for which the polynomial
/// through the others is extrapolated to 0.
template <class Scalar, int Stages>
Eigen::Matrix<Scalar, Stages, 1> change_without_left_node(const tableau<Scalar, Stages>& m) {
    const int s = m.stages(), first = m.c[0] == Scalar(0) ? 1 : 0;
    Eigen::Matrix<Scalar, Stages, 1> w(s);
    Scalar ratio = Scalar(1);  // of prod (x - c_k) at 1 and at 0
    for (int k = first; k < s; ++k) ratio *= (Scalar(1) - m.c[k]) / -m.c[k];
    if (first == 1) w[0] = ratio;
    for (int j = first; j < s; ++j) {
        w[j] = -ratio;
        for (int k = first; k < s; ++k)
            if (k != j) w[j] *= -m.c[k] / (m.c[j] - m.c[k]);
    }
    return w;
}

/// z -> value at 0 of the polynomial through the stages alone.
template <class Scalar, int Stages>
Eigen::Matrix<Scalar, Stages, 1> value_at_left_end(const tableau<Scalar, Stages>& m) {
    const int s = m.stages();
    Eigen::Matrix<Scalar, Stages, 1> w(s);
    for (int j = 0; j < s; ++j) {
        w[j] = Scalar(1);
        for (int k = 0; k < s; ++k)
            if (k != j) w[j] *= -m.c[k] / (m.c[j] - m.c[k]);
    }
    return w;
}

/// z -> a_{s-1}, the last shifted Legendre coefficient of the polynomial through the stages alone: their
/// divided difference over the leading coefficient of P_{s-1}, binomial(2s - 2, s - 1).
template <class Scalar, int Stages>
Eigen::Matrix<Scalar, Stages, 1> leading_legendre_coefficient(const tableau<Scalar, Stages>& m) {
    const int s = m.stages();
    Eigen::Matrix<Scalar, Stages, 1> w(s);
    for (int j = 0; j < s; ++j) {
        w[j] = Scalar(1);
        for (int k = 0; k < s; ++k)
            if (k != j) w[j] /= m.c[j] - m.c[k];
        for (int k = 1; k < s; ++k) w[j] *= Scalar(k) / Scalar(s - 1 + k);
    }
    return w;
}

/// Element k n + j - 1: z_j -> a_k, the shifted Legendre coefficients of the polynomial of degree n through y and the
/// n values z_j at c_j != 0: the inverse of P_k at the nodes {0, c}, where z_0 = 0.
template <class Scalar, class Nodes>
std::vector<Scalar> legendre_coefficients(const Nodes& c, int n) {
    const int m = n + 1;
    split_lu<Scalar, -1> lu(m);
    for (int j = 0; j < m; ++j)  // transposed, so that a solve gives a row of the inverse
        legendre_values(j == 0 ? Scalar(0) : Scalar(c[j - 1]), n, lu.entries() + j * m);
    lu.factor();
    std::vector<Scalar> all(static_cast<std::size_t>(m) * static_cast<std::size_t>(n)), row(m);
    for (int k = 0; k < m; ++k) {
        std::fill(row.begin(), row.end(), Scalar(0));
        row[k] = Scalar(1);
        lu.solve(row.data());
        std::copy(row.begin() + 1, row.end(), all.begin() + k * n);
    }
    return all;
}

/// Columns: z -> a_n, z -> a_{n-2} (zero for n = 1).
template <class Scalar, class Nodes>
Eigen::Matrix<Scalar, Eigen::Dynamic, 2> highest_legendre_coefficients(const Nodes& c, int n) {
    const std::vector<Scalar> all = legendre_coefficients<Scalar>(c, n);
    Eigen::Matrix<Scalar, Eigen::Dynamic, 2> top(n, 2);
    for (int j = 0; j < n; ++j) {
        top(j, 0) = all[n * n + j];
        top(j, 1) = n > 1 ? all[(n - 2) * n + j] : Scalar(0);
    }
    return top;
}

}  // namespace stagecraft
