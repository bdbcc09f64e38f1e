// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>

namespace stagecraft {

/// Gauss methods of which solve_bvp takes the one that suits the tolerance: solve_bvp(gauss_variable(), ...).
struct gauss_choice {
    friend void take_tableau(const gauss_choice&);  // stands where a tableau does (bvp/solve.hpp)
};
inline gauss_choice gauss_variable() { return {}; }

/// solve_bvp with 5 stages for rtol above 1e-6 and 7 below.
template <class Rhs, class Conditions, class Guess, class Parameters>
requires requires(const Parameters& p) { p.size(); }
auto solve_bvp(gauss_choice, two_point_problem<Rhs, Conditions> problem, double a, double b,
               const Guess& guess, const Parameters& p, const bvp_options<double>& o = {}) {
    if (o.rtol > 1e-6) return solve_bvp(gauss<5>(), std::move(problem), a, b, guess, p, o);
    return solve_bvp(gauss<7>(), std::move(problem), a, b, guess, p, o);
}

/// The same without parameters.
template <class Rhs, class Conditions, class Guess>
auto solve_bvp(gauss_choice method, two_point_problem<Rhs, Conditions> problem, double a, double b,
               const Guess& guess, const bvp_options<double>& o = {}) {
    return solve_bvp(method, std::move(problem), a, b, guess, Eigen::Matrix<double, 0, 1>(), o);
}

}  // namespace stagecraft
