// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/tableaux/nodal.hpp>
#include <vector>

namespace stagecraft::tableaux {

/// P_0(x), ..., P_n(x) and, where asked for, their first derivatives. O(n) operations.
struct legendre_table {
    std::vector<ball> value;
    std::vector<ball> slope;
};

/// The shifted Legendre polynomials at every point of a ball in [0, 1]. The recurrence runs on midpoints: where
/// each of its steps rounds by at most e, P_k is off by at most e (k+1)(k+2)/4 (Johansson and Mezzarobba
/// 2018, section 3). The width of x enters by the mean value theorem with |P_k'| <= k (k+1) and
/// |P_k''| <= (k-1) k (k+1) (k+2) / 2 on [0, 1]. Throws undecided where the midpoint lies outside.
legendre_table legendre_values(const ball& x, int n, bool slopes = false);

/// The rationals as balls of `bits` bits.
std::vector<ball> enclosed(const std::vector<rational>& v, int bits);

/// The sum over k of u_k P_k, at a table of values or of slopes.
ball legendre_sum(const std::vector<ball>& u, const std::vector<ball>& p);

namespace zeros {

/// Double approximations of the zeros in (0, 1) of a family's w: sign changes between neighbours of a grid
/// in theta, x = sin(theta / 2)^2, where the zeros of orthogonal polynomials are almost equidistant.
std::vector<double> approximate(const std::vector<double>& w, std::size_t expected);

/// Where Newton's method starts for a zero, how many bits tell it from its neighbours, and how far away (2^-apart) the next number is among the
/// zeros, 0 and 1.
struct start {
    ball x;
    int bits = 128;
    int apart = 29;
};

/// Starts at the zeros of a user's w in (0, 1): w is rounded by 2^-bits, a zero by that over the
/// slope, which is to be 2^-128 of the distance to the next zero.
std::vector<start> starts(const polynomial<rational>& w, int bits);

/// A ball of radius r = 2 |w| / |w'| around a Newton limit, proved to hold a zero of w by certain and
/// opposite signs of w at its two ends. Throws undecided where the signs cannot be told.
ball certified(const std::vector<ball>& w, const start& from, int bits);

}  // namespace zeros

/// Enclosures of the nodes c_1 < ... < c_s, the zeros of w, computed with `bits` bits (more where a user's w needs them
/// to tell its zeros from one another); their radii are about s^2 2^-bits for a family. Nodes 0, 1/2 and 1 are exact. The proof: s disjoint balls, each holding a sign
/// change of a polynomial of degree s. Throws undecided where the precision does not suffice for that.
/// Cost O(s^2).
std::vector<ball> enclose_nodes(const nodal_polynomial& w, int bits);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/roots-inl.hpp"
#endif
