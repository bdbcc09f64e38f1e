// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/partitioned_file.hpp>
#include <stagecraft/theory/stability/stability_function.hpp>
#include <stagecraft/theory/trees/rosenbrock_trees.hpp>
#include <stdexcept>
#include <string>

/// A Rosenbrock or W method in alpha, Gamma and b whatever way the file writes it, and the tableau with its stability function.

namespace stagecraft::theory {

namespace detail {

/// The product of a row and a matrix.
template <class K>
typename rosenbrock_method<K>::column row_times(const typename rosenbrock_method<K>::column& row,
                                                const typename rosenbrock_method<K>::matrix& M) {
    return product_of<K>(M.transpose(), row);
}

/// Gamma from C = diag(1/gamma_i) - Gamma^{-1}, with gamma on the diagonal of what is given: row by row and without a division.
template <class K>
typename rosenbrock_method<K>::matrix untransformed(const typename rosenbrock_method<K>::matrix& C) {
    const auto s = C.rows();
    typename rosenbrock_method<K>::matrix Gamma(s, s);
    for (Eigen::Index i = 0; i < s; ++i)
        for (Eigen::Index j = 0; j < s; ++j) {
            K sum(i == j ? 1 : 0);
            for (Eigen::Index k = j; k < i; ++k) sum = sum + C(i, k) * Gamma(k, j);
            Gamma(i, j) = j > i ? K(0) : K(C(i, i) * sum);
        }
    return Gamma;
}

}  // namespace detail

/// The method that the file gives in two tableaux, in alpha, Gamma and b (Hairer-Wanner II.IV.7): a = alpha Gamma^{-1} and
/// m^T = b^T Gamma^{-1}. Takes O(s^3) operations.
template <class K>
rosenbrock_method<K> rosenbrock_of(const tableaux::partitioned_file& file, const tableau<K>& values,
                                   const tableau<K>& matrix) {
    using detail::row_times;
    rosenbrock_method<K> m{values.A, matrix.A, {}, {}, values.b, values.b_embedded};
    if (file.difference)
        for (Eigen::Index i = 0; i < m.b.size(); ++i) m.b_embedded[i] = m.b[i] - m.b_embedded[i];
    if (file.transformed) {
        m.Gamma = detail::untransformed<K>(matrix.A);
        for (Eigen::Index i = 0; i < m.b.size(); ++i)
            m.alpha.row(i) = row_times<K>(values.A.row(i).transpose(), m.Gamma).transpose();
        m.b = row_times<K>(m.b, m.Gamma);
        if (m.b_embedded.size() > 0) m.b_embedded = row_times<K>(m.b_embedded, m.Gamma);
    }
    m.beta = m.alpha + m.Gamma;
    return m;
}

/// Throws std::invalid_argument for another method, of whose stability function this is not.
inline void require_rosenbrock(const tableaux::partitioned_file& file) {
    if (file.coupling != tableaux::coupling::rosenbrock)
        throw std::invalid_argument(
            "form: '" + std::string(tableaux::name(file.coupling)) +
            "', of several tableaux only a Rosenbrock method has one stability function");
}

/// beta and b, which have the stability function of the method, and the embedded weights with that of theirs: on y' = lambda y the
/// stages are those of a diagonally implicit method.
template <class K>
tableau<K> linear_part(const rosenbrock_method<K>& m) {
    tableau<K> t;
    t.A = m.beta;
    t.b = m.b;
    t.b_embedded = m.b_embedded;
    t.c = product_of<K>(m.beta, ones<K>(m.stages()));
    return t;
}

}  // namespace stagecraft::theory
