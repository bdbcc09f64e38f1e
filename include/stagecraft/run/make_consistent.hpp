// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>

#include <stagecraft/options.hpp>
#include <stagecraft/problem/higher_index.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/run/find_consistent_start.hpp>
#include <stagecraft/run/linearisation.hpp>

namespace stagecraft {

/// Moves y, where a run begins or goes on behind a change, to where the equations without a derivative hold
/// (options.consistent_start). Index 1: the components whose derivatives M takes to zero move, to rounding where Newton's
/// iteration goes so far, M y stays; index 2 and 3: as consistent_initial_values does (dae/consistent.hpp). A regular M leaves
/// nothing to move.
///
/// False where Newton's iteration finds no such point for index 1; y is as it was then. std::invalid_argument where the
/// entries of M or J are not here, and for index 2 and 3 where dae/consistent.hpp is not included; what
/// consistent_initial_values throws. h is a step that a run might take. Costs a few factorisations.
template <class Method, class System, class Vector, class Norm>
bool make_consistent(Method& method, System& system, linearisation<System, Vector>& linear,
                     const typename Vector::Scalar& t, Vector& y, const typename Vector::Scalar& h,
                     const Norm& norm, const options<typename Vector::Scalar>& o,
                     report<typename Vector::Scalar>& counts) {
    using scalar = typename Vector::Scalar;
    if (system.largest_index() > 1) {
        auto& problem = system.problem();
        if constexpr (requires { consistent_values(higher_index{}, problem, t, y); }) {
            y = consistent_values(higher_index{}, problem, t, y);
            return true;
        } else {
            throw std::invalid_argument(
                "integrate: consistent_start of a problem with components of index 2 or 3 needs #include "
                "<stagecraft/dae/consistent.hpp>");
        }
    }
    if constexpr (shows_constraints<System>) {
        const start_found found =
            find_consistent_start(method, system, linear, t, y, h, norm, o, counts, scalar(0));
        return found != start_found::none;
    } else {
        throw std::invalid_argument(
            "integrate: consistent_start needs the entries of problem.mass() and of the Jacobian: give "
            "consistent values as y0");
    }
}

}  // namespace stagecraft
