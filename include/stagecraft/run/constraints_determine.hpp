// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>

#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/split_lu.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/run/inconsistent_start.hpp>
#include <stagecraft/status.hpp>

namespace stagecraft {

/// Why a run with constraints could not go on, asked when it has ended: false if the equations without a derivative,
/// the rows of J where a diagonal M has none, do not determine the components whose derivatives M lacks. Then
/// g_z is singular, or so nearly that a pivot is below what rounding, a hundred times in units of rtol, leaves
/// of the entries beside it: the constraints depend on each other, or are of higher index than index() says.
/// True where that is not known: an M that is not diagonal, components of index 2 and 3, banded and sparse matrices,
/// states on several processes.
template <class System, class Scalar>
bool constraints_determine(const System& system, const Scalar& rtol) {
    if constexpr (System::structured || System::mass_type::identity || !System::sums_type::complete ||
                  !has_entries<typename System::mass_type>) {
        return true;
    } else {
        using std::abs;
        const int n = system.size();
        if (system.largest_index() > 1) return true;
        split_lu<Scalar, -1> lu(n);
        Scalar* a = lu.entries();
        for (int i = 0; i < n * n; ++i) a[i] = system.jacobian().data()[i];
        for (const auto& e : system.mass().entries()) {
            if (e.value == Scalar(0)) continue;
            if (e.row != e.column) return true;
            for (int j = 0; j < n; ++j) a[e.row + j * n] = Scalar(e.row == j ? 1 : 0);
        }
        for (int i = 0; i < n; ++i) {  // rows of size one
            Scalar largest(0);
            for (int j = 0; j < n; ++j)
                if (abs(a[i + j * n]) > largest) largest = abs(a[i + j * n]);
            if (!(largest - largest == Scalar(0))) return true;
            for (int j = 0; j < n && largest > Scalar(0); ++j) a[i + j * n] /= largest;
        }
        if (!lu.factor()) return false;
        const Scalar least = 100 * std::numeric_limits<Scalar>::epsilon() / rtol;
        for (int k = 0; k < n; ++k)
            if (!(lu.pivot(k) > least)) return false;
        return true;
    }
}

/// A mechanical system that says of a state which of its constraints depend on others there: a string, empty where none does.
template <class Problem, class Scalar, class Vector>
concept names_dependent_constraints = requires(const Problem& problem, const Scalar& t, const Vector& y) {
    problem.dependent_constraints(t, y).empty();
};

/// The status of a run that ends with `found` at (t, y): a start that is not consistent, or constraints that do not determine their components are the
/// cause of iterations that fail.
template <class System, class Vector, class Norm, class Scalar>
status cause_of(status found, System& system, const Scalar& t, const Vector& y, const Norm& norm,
                const Scalar& rtol, report<Scalar>& counts) {
    if constexpr (names_dependent_constraints<typename System::problem_type, Scalar, Vector>)
        if ((found == status::newton_failed || found == status::step_underflow ||
             found == status::singular_matrix) &&
            !system.problem().dependent_constraints(t, y).empty())
            return status::constraints_dependent;
    if (counts.steps == 0) found = blame_start(found, system, t, y, norm.of_state(), counts);
    const bool unsolved = found == status::newton_failed || found == status::step_underflow;
    return unsolved && !constraints_determine(system, rtol) ? status::singular_matrix : found;
}

}  // namespace stagecraft
