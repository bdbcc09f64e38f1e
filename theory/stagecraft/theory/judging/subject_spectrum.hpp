// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stagecraft/tableaux/small_solve.hpp>
#include <stagecraft/theory/judging/exact_cost.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <stagecraft/theory/stability/spectrum.hpp>
#include <stagecraft/theory/stability/stability_function.hpp>
#include <string>

namespace stagecraft::theory {

namespace detail {

spectrum enclosed_eigenvalues(const Eigen::Matrix<tableaux::ball, -1, -1>& A);

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

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/subject_spectrum-inl.hpp"
#endif
