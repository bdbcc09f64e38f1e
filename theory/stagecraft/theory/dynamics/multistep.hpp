// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/polynomial.hpp"
#include "stagecraft/tableaux/rational.hpp"
#include "stagecraft/tableaux/routh_hurwitz.hpp"
#include "stagecraft/theory/statements/verdict.hpp"

namespace stagecraft::theory {

using tableaux::polynomial;
using tableaux::rational;

/// The linear multistep method sum_j alpha_j x_(n+j) = h sum_j beta_j f_(n+j) by its generating polynomials
/// rho = sum alpha_j zeta^j and sigma = sum beta_j zeta^j (Hairer-Norsett-Wanner I, section III.2).
struct multistep {
    polynomial<rational> rho, sigma;
    int steps() const { return rho.degree(); }
};

/// rho(1) = 0 and rho'(1) = sigma(1): exact.
verdict consistent_method(const multistep& m);

/// Roots inside, on and outside the unit circle, with multiplicity, exactly: zeta = (1 + w)/(1 - w) takes the
/// left half-plane to the disc, and infinity to -1.
tableaux::half_plane_count count_by_unit_circle(const polynomial<rational>& p);

/// Dahlquist's root condition: no root of rho outside the unit circle, those on it simple. Exact. Throws
/// std::invalid_argument where rho is zero or sigma has the higher degree.
verdict root_condition(const multistep& m);

/// Whether every stationary sequence is an equilibrium of x' = f(x), whatever f: for a constant sequence the
/// method says rho(1) x = h sigma(1) f(x), so it needs rho(1) = 0 != sigma(1), which consistency and the root
/// condition give (lecture, Satz 1.25).
verdict no_multistep_ghosts(const multistep& m);

/// The BDF method of k steps: sum_(j=1..k) (1/j) zeta^(k-j) (zeta - 1)^j = h zeta^k.
multistep bdf(int k);

/// The explicit Adams method (Adams-Bashforth) of k steps.
multistep adams_bashforth(int k);

/// The implicit Adams method (Adams-Moulton) of k steps.
multistep adams_moulton(int k);

/// The largest p with sum alpha_j j^q = q sum beta_j j^(q-1) for q = 0 ... p: the order, at least 1 for consistent
/// methods, -1 where rho(1) != 0. Exact. Throws std::invalid_argument where rho and sigma are zero.
int order(const multistep& m);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/multistep-inl.hpp"
#endif
