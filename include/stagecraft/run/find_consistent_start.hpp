// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

#include <stagecraft/linear/mass_kernel.hpp>
#include <stagecraft/linear/norms.hpp>
#include <stagecraft/options.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/run/end_slope.hpp>
#include <stagecraft/run/inconsistent_start.hpp>
#include <stagecraft/run/linearisation.hpp>

namespace stagecraft {

/// The start holds, was moved to where it does, or no such point was found.
enum class start_found { holds, moved, none };

/// Newton's iteration, damped, for the algebraic components of a start (t, y) of index 1 that does not satisfy the equations
/// without a derivative; y is moved by what M takes to zero only. Each iteration takes a new Jacobian and solves with
/// M/(h a) - J, h being so small that the other components stay. An increment is taken by a part for which the next one,
/// with the same matrix, is smaller (Hairer-Wanner II.VI.1 for the equations, Deuflhard 2004, section 3.3 for the test).
///
/// They hold where they are off by at most `most` tolerances. Without such a bound the iteration goes on as long as its
/// increments become smaller, behind a thousandth of a tolerance, where it is content otherwise. Where no such point is found y
/// is as it was. Where the entries of M or J are not here nothing is tried. Takes storage; at most 50 factorisations.
template <class Method, class System, class Vector, class Norm>
start_found find_consistent_start(Method& method, System& system, linearisation<System, Vector>& linear,
                                  const typename Vector::Scalar& t, Vector& y,
                                  const typename Vector::Scalar& h, const Norm& norm,
                                  const options<typename Vector::Scalar>& o,
                                  report<typename Vector::Scalar>& counts,
                                  const typename Vector::Scalar& most) {
    start_found found = start_found::none;
    if constexpr (shows_constraints<System>) {
        using scalar = typename Vector::Scalar;
        if (system.largest_index() > 1 || !method.implicit()) return found;
        const int n = system.size();
        const auto constraints = constraints_of(system.mass(), n);
        mass_kernel<scalar> algebraic(system.mass(), n), without_derivative(system.mass().transposed(), n);
        const scalar tiny = h / scalar(1 << 30);
        Vector x = y, trial = y, f(n), step(n), next(n);
        typename Method::output* const none = nullptr;
        const auto correction = [&](const Vector& at, Vector& d) {
            system.evaluate_inside(t, at, f);
            d = f;
            without_derivative.project(d);
            ++counts.error_solves;
            method.solve_for_defect(system, tiny, d);
            algebraic.project(d);
            return norm(d);
        };
        system.evaluate_inside(t, x, f);
        const auto holds = [&] {
            return !(worst_constraint(system, constraints, f, norm.of_state()).tolerances > most);
        };
        if (constraints.empty() || (most > scalar(0) && holds())) return start_found::holds;
        for (int k = 0; k < 50; ++k) {
            linear.evaluate(system, t, x, f, h, none, false, o, trial);
            ++counts.factorisations;
            if (!method.stages().factor(system, tiny)) break;
            const scalar size = correction(x, step);
            if (!(size - size == scalar(0))) break;
            const scalar least = scalar(1) / 1000,
                         shortest = least * least;  // a kink may ask for parts of its slopes' ratio
            scalar part(1), left;
            for (;; part /= 2) {
                trial = x + part * step;
                left = correction(trial, next);
                if (left <= least || left <= (scalar(1) - part / 4) * size || part < shortest) break;
            }
            if (part < shortest) break;
            x = trial;
            if (left > least) continue;
            y = x;
            found = start_found::moved;
            if (most > scalar(0) || 2 * left >= size) break;
        }
        linear.moved();
    }
    return found;
}

/// The same for a method that forgets y0, in a run whose norm is of the state and which knows f at its start.
template <class Method, class System, class Vector, class Norm>
bool move_start(Method& method, System& system, linearisation<System, Vector>& linear,
                const typename Vector::Scalar& t, Vector& y, const typename Vector::Scalar& h, Norm& norm,
                end_slope<Vector>& f, const options<typename Vector::Scalar>& o,
                report<typename Vector::Scalar>& counts) {
    const typename Vector::Scalar most = typename Vector::Scalar(1) / 10;
    if (!method.stiffly_accurate() ||
        find_consistent_start(method, system, linear, t, y, h, norm, o, counts, most) != start_found::moved)
        return false;
    norm.at(y);
    f.forget();
    return true;
}

}  // namespace stagecraft
