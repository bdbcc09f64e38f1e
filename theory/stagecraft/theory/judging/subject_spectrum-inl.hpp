// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/subject_spectrum.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

namespace detail {

/// A without the rows and columns i of which one vanishes exactly: each brings the eigenvalue 0.
STAGECRAFT_INLINE Eigen::Matrix<tableaux::ball, -1, -1> without_zero_lines(
    const Eigen::Matrix<tableaux::ball, -1, -1>& A) {
    std::vector<Eigen::Index> kept;
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
        bool row = false, column = false;
        for (Eigen::Index j = 0; j < A.rows(); ++j) {
            row = row || !A(i, j).exactly_zero();
            column = column || !A(j, i).exactly_zero();
        }
        if (row && column) kept.push_back(i);
    }
    const auto n = static_cast<Eigen::Index>(kept.size());
    Eigen::Matrix<tableaux::ball, -1, -1> rest(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
            rest(i, j) = A(kept[static_cast<std::size_t>(i)], kept[static_cast<std::size_t>(j)]);
    return n == A.rows() ? rest : without_zero_lines(rest);
}

STAGECRAFT_INLINE spectrum enclosed_eigenvalues(const Eigen::Matrix<tableaux::ball, -1, -1>& A) {
    const auto core = without_zero_lines(A);
    spectrum all;
    if (core.rows() > 0) {
        auto coefficients = determinant_of_one_minus_z(core);
        std::reverse(coefficients.begin(), coefficients.end());
        if (!certainly_nonzero(coefficients.front()))
            throw tableaux::undecided("the enclosures do not tell whether A is singular");
        require_moderate(coefficients);
        const auto found = tableaux::locate_roots(coefficients, checker_bits);
        for (const auto& x : found.real) all.push_back({{x, 0}, {}, 1});
        for (const auto& z : found.upper) all.push_back({z, {}, 1});
    }
    return with_zeros(std::move(all), static_cast<int>(A.rows() - core.rows()));
}

}  // namespace detail

}  // namespace stagecraft::theory
