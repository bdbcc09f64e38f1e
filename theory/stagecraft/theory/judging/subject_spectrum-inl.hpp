// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/subject_spectrum.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/judging/enclosed_function.hpp"

namespace stagecraft::theory {

namespace detail {

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
