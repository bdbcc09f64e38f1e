// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <utility>

#include <stagecraft/integrate.hpp>
#include <stagecraft/method/nystrom_method.hpp>
#include <stagecraft/problem/second_order.hpp>
#include <stagecraft/step/nystrom_step.hpp>

namespace stagecraft {

/// The problem q'' = f(t, q) or q'' = f(t, q, v) for a Nystrom method or any other; the state is y = (q, v), q above v:
///
///     integrate(dormand_prince_rkn_6_4(), second_order(f), y0, t0, t1, {.rtol = 1e-9, .atol = 1e-12})
///
/// Methods are in coefficients/nystrom.hpp, read from a file (tableaux/read_method.hpp), or a nystrom_method of your own
/// (method/nystrom_method.hpp); they take s evaluations of f a step and no stages for q' = v. f(t, q, v) does not
/// compile with a method that is not for it, where it would have order 1 and say nothing. Steps are adaptive where the
/// method has embedded weights, else options.fixed_step. y(t) within a step is Hermite's quintic in q, and its derivative in v.
///
/// f takes vectors of half the size of y and returns one (a number where it has one component), or writes it: f(t, q, out),
/// f(t, q, v, out). Generic f is differentiated automatically where stages are implicit, and matrices have half the size
/// there. bad_problem (std::invalid_argument) leaves integrate() where what f returns has another size. A callable
/// f(t, q, v) that returns nothing is taken for f(t, q, out).
template <class F>
second_order_problem<F> second_order(F f) {
    return second_order_problem<F>(std::move(f));
}

}  // namespace stagecraft
