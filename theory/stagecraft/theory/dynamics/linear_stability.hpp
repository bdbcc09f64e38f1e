// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>

#include "stagecraft/theory/dynamics/inner_product.hpp"

namespace stagecraft::theory {

namespace detail {

/// B - gamma 1.
dense<rational> shifted(dense<rational> B, const rational& gamma);

}  // namespace detail

/// G with G B + B^T G = -Q, Q symmetric: exact, one linear system of n(n + 1)/2 unknowns. Throws
/// std::invalid_argument where two eigenvalues of B add up to 0 (it names them): no or many G then.
dense<rational> solve_lyapunov(const dense<rational>& B, const dense<rational>& Q);

/// The spectral abscissa alpha(B) = max Re lambda (lecture, Definition 3.2): low <= alpha(B) < high (low =
/// alpha(B) = high where a dyadic number met exactly), high - low <= width, by exact half-plane counts.
supremum spectral_abscissa(const dense<rational>& B, const rational& width = rational(1, 1 << 20));

/// An inner product x^T G y with <B x, x> <= gamma |x|^2, G > 0 (lecture, Lemma 3.3 and Satz 3.5). For gamma >
/// alpha(B), part 1, it is the solution of G (B - gamma) + (B - gamma)^T G = -1. For gamma = alpha(B) there is one if
/// and only if the eigenvalues with that real part have Jordan blocks of order 1 (part 2): on their invariant subspace,
/// split off exactly, it is the mean over all times of the Euclidean product along the flow, on the complement it is as
/// in part 1. Both inequalities are checked by exact L D L^T. Throws std::invalid_argument for gamma < alpha(B), and for
/// gamma = alpha(B) with a larger Jordan block.
dense<rational> inner_product(const dense<rational>& B, const rational& gamma);

enum class lyapunov_stability { asymptotically_stable, stable, unstable };

/// Stability of the zero solution of x' = B x, exact (lecture, Korollar 3.6): by the half-planes of the
/// eigenvalues and, where some lie on the axis, by ranks. `witness`, for an unstable B without eigenvalues in
/// the right half-plane: a vector v with s(B)^2 v = 0 != s(B) v, s the polynomial of the simple eigenvalues
/// on the axis; the solution from v grows like a power of t.
struct linear_stability_verdict {
    lyapunov_stability kind;
    std::string reason;
    std::optional<column<rational>> witness{};
};

linear_stability_verdict linear_stability(const dense<rational>& B);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/linear_stability-inl.hpp"
#endif
