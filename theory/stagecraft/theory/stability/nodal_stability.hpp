// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include "stagecraft/tableaux/polynomial.hpp"
#include "stagecraft/tableaux/rational.hpp"
#include "stagecraft/theory/models/legendre_model.hpp"
#include "stagecraft/theory/stability/stability_function.hpp"

namespace stagecraft::theory {

namespace detail {

using tableaux::integer;
using tableaux::rational;

// A polynomial as integers over one denominator: one lcm per operation instead of a gcd per coefficient.
struct scaled_polynomial {
    std::vector<integer> numerators;
    integer denominator = 1;
};

// det(I - z H) of the leading block of size n, H upper Hessenberg, by the leading minors d_k:
// d_k = (1 - z h_kk) d_{k-1} - sum_{i<k} z^{k-i+1} h_ik h_{k,k-1} ... h_{i+1,i} d_{i-1}   (k, i from 1).
// O(n^2) operations on integers for a tridiagonal H, O(n^3) for any.
scaled_polynomial determinant_of_one_minus_z(const band_matrix<rational>& h, int n, const rational& first);

tableaux::polynomial<rational> unscaled(const scaled_polynomial& p);

}  // namespace detail

/// R(z) in lowest terms from the model: det(I - z(H - e_0 e_0^T)) / det(I - z H) with the upper Hessenberg
/// H = A, for D(s) methods by R(z) = 1/R_c(-z) with the collocation method R_c on the same nodes. Where H is
/// tridiagonal its coupled block gives coprime determinants, otherwise common factors are cancelled.
/// O(s^2) integer operations for the families.
stability_function<tableaux::rational> stability_function_of(const legendre_model<tableaux::rational>& m);

/// C in R(z) - e^z = C z^{p+1} + O(z^{p+2}) for an R with R(z) - e^z = O(z^{p+1}); zero where R is of higher
/// order than p. O(p) operations.
tableaux::rational exponential_error(const stability_function<tableaux::rational>& r, int p);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/stability/nodal_stability-inl.hpp"
#endif
