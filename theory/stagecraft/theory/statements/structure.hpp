// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/statements/statement.hpp>

namespace stagecraft::theory::statements {

/// M = BA + A^T B - b b^T = 0 as a bilinear form in arbitrary u and v: the method preserves quadratic
/// invariants, hence is symplectic (and conversely where it is irreducible).
inline constexpr auto symplecticity = [] {
    using namespace symbols;
    return make_statement(
        "symplecticity", -1,
        "Lasagni 1988; Sanz-Serna 1988; Suris 1988; Hairer-Norsett-Wanner I.II.16, Theorem 16.6",
        dot(b, u * (A * v)) + dot(b, v * (A * u)) == dot(b, u) * dot(b, v));
}();

/// a_{s+1-i,s+1-j} + a_ij = b_j: the method is its own adjoint. Stages are paired in the order in which the
/// tableau lists them, P reversing it, as for increasing nodes; a tableau in another order must be sorted
/// first. The weights are then symmetric too (apply P to both sides), and c by the row sums.
inline constexpr auto symmetry_of_stages = [] {
    using namespace symbols;
    return make_statement("symmetry", -1,
                          "Hairer-Norsett-Wanner I.II.8, Theorem 8.3; Hairer-Lubich-Wanner, Theorem V.2.3",
                          P * (A * (P * v)) + A * v == dot(b, v) * one);
}();

/// a_sj = b_j: the last stage is the result. (With the row sums and B(1), c_s = 1.)
inline constexpr auto stiff_accuracy = [] {
    using namespace symbols;
    return make_statement("stiff accuracy", -1,
                          "Prothero and Robinson 1974; Hairer-Wanner II.IV.3, Proposition 3.8",
                          dot(last, A * v) == dot(b, v));
}();

}  // namespace stagecraft::theory::statements
