// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <complex>
#include <stagecraft/tableaux/complex_ball.hpp>
#include <stagecraft/tableaux/polynomial.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <vector>

namespace stagecraft::tableaux {

/// The roots of a real polynomial: the real ones increasing, and of every complex pair the one above the
/// real axis, imaginary parts increasing.
struct root_enclosures {
    std::vector<ball> real;
    std::vector<complex_ball> upper;
};

namespace zeros {

/// Approximations of all roots of a monic polynomial by the Ehrlich-Aberth iteration in long double, from a
/// circle whose radius is the geometric mean of the moduli. They may be poor. Points of the circle itself
/// are returned if the iteration overflows or makes two approximations coincide.
std::vector<std::complex<bound>> rough(const std::vector<ball>& a);

}  // namespace zeros

/// Enclosures of all roots of p, which must be simple and non-zero. The proof: by Smith's theorem (1970) the
/// discs |z - z_i| <= n |p(z_i)| / |prod_{j != i} (z_i - z_j)| of a monic p contain all roots, one each where
/// they are disjoint; a disc around a real z_i then holds a real root, because the conjugate of a root is a
/// root. `a` are the coefficients of p, ascending, the last one 1; where they are not exact, the enclosures
/// hold the roots of every p among them. O(n^2) operations a sweep. Throws undecided where `bits` is too
/// small, the coefficients too uncertain, or p has a multiple root. The order of the result is arbitrary.
root_enclosures locate_roots(const std::vector<ball>& a, int bits);

/// The same for exact coefficients, in order. Throws undecided where two pairs have the same imaginary part.
root_enclosures enclose_roots(const polynomial<rational>& p, int bits);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/complex_roots-inl.hpp"
#endif
