// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <stagecraft/tableaux/small_solve.hpp>
#include <stagecraft/theory/judging/properties.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <stagecraft/theory/stability/spectrum.hpp>
#include <stagecraft/theory/stability/stability_function.hpp>
#include <string>
#include <vector>

namespace stagecraft::theory {

namespace detail {

/// A without the rows and columns i of which one vanishes exactly: each brings the eigenvalue 0.
inline Eigen::Matrix<tableaux::ball, -1, -1> without_zero_lines(
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

inline spectrum enclosed_eigenvalues(const Eigen::Matrix<tableaux::ball, -1, -1>& A) {
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

/// The spectrum of A and the poles of R of a tableau, up to largest_spectrum stages. Exact data: proved, with
/// multiplicities; a tableau whose stability function would be too long an expression is left out.
/// Enclosures: of every tableau among them; the poles are the zeros of det(I - zA), for enclosures cannot
/// tell whether the numerator shares one. Cost: the stability function once more, and the root enclosures.
template <class K>
spectra spectra_of(const subject<K>& s) {
    spectra out;
    const int n = s.stages();
    const auto& A = s.t.A;
    if (n > largest_spectrum) {
        out.note = beyond_largest_spectrum();
        return out;
    }
    try {
        if (s.strictly_lower) {
            out.eigenvalues = detail::with_zeros({}, n);
            out.poles = spectrum{};
            return out;
        }
        if (s.lower) out.eigenvalues = diagonal_of(A);
        if constexpr (exact_scalar<K>) {
            if (determinant_bits(s) > longest_exact_determinant)
                throw tableaux::undecided("fractions too long for an exact stability function");
            const auto r = stability_function_of(s.t);
            out.poles = roots_of(r.denominator);
            if (s.lower) return out;
            out.eigenvalues =
                r.denominator.degree() == n
                    ? reciprocals(*out.poles)
                    : detail::eigenvalues_of(tableaux::determinant_of_one_minus_z<K>(A), n, *out.poles);
        } else {
            if (!s.lower) out.eigenvalues = detail::enclosed_eigenvalues(A);
            out.poles = reciprocals(*out.eigenvalues);
            out.note = "poles: the zeros of det(I - zA), some of which the numerator may share";
        }
    } catch (const tableaux::undecided& e) {
        out.note = std::string(out.eigenvalues ? "no poles: " : "no eigenvalues and poles: ") + e.what();
    }
    return out;
}

}  // namespace stagecraft::theory
