// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <cstddef>
#include <sstream>
#include <utility>
#include <vector>

#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/mass_kernel.hpp>
#include <stagecraft/problem/system.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/status.hpp>

namespace stagecraft {

/// The combinations of equations that M leaves without a derivative.
template <class Mass>
auto constraints_of(const Mass& mass, int n) {
    return mass_kernel(mass.transposed(), n).basis();
}

/// How much each combination of equations changes at most if every component moves by a tolerance, 1 / weights_j:
/// sum_j |(w^T J)_j| / weights_j.
template <class System, class Combinations, class Vector>
Vector reach_of_tolerance(const System& system, const Combinations& constraints, const Vector& weights) {
    using std::abs;
    using scalar = typename Vector::Scalar;
    const int n = system.size(), m = static_cast<int>(constraints.size());
    std::vector<std::vector<std::pair<int, scalar>>> of_row(static_cast<std::size_t>(n));
    for (int k = 0; k < m; ++k)
        for (std::size_t i = 0; i < constraints[k].at.size(); ++i)
            of_row[constraints[k].at[i]].push_back({k, constraints[k].value[i]});
    std::vector<scalar> column(static_cast<std::size_t>(m), scalar(0)), reach = column;
    std::vector<int> touched;
    const auto& J = system.jacobian();
    for (int j = 0; j < n; ++j) {
        const auto add = [&](Eigen::Index i, const scalar& value) {
            for (const auto& [k, factor] : of_row[static_cast<std::size_t>(i)]) {
                column[k] += factor * value;
                touched.push_back(k);
            }
        };
        if constexpr (requires {
                          typename std::decay_t<decltype(J)>::InnerIterator;
                          J.isCompressed();
                      }) {
            for (typename std::decay_t<decltype(J)>::InnerIterator it(J, j); it; ++it)
                add(it.row(), it.value());
        } else if constexpr (requires { J.in_band(0, 0); }) {
            for (int i = 0; i < n; ++i)
                if (J.in_band(i, j)) add(i, J(i, j));
        } else {
            for (int i = 0; i < n; ++i) add(i, J(i, j));
        }
        for (const int k : touched) {
            reach[k] += abs(column[k]) / weights[j];
            column[k] = scalar(0);
        }
        touched.clear();
    }
    Vector result(weights.size());
    result.setZero();
    for (int k = 0; k < m; ++k) result[k] = reach[k];
    return result;
}

/// The equation without a derivative that is farthest from being satisfied.
template <class Scalar>
struct unmet_constraint {
    int number = -1;  ///< among constraints_of(M); -1: there is none
    Scalar rest{0},
        tolerances{0};  ///< what it leaves; what it leaves if every component moves by a tolerance is one
};

/// The one of f0 = f(t, y) that is farthest off, weights being the inverse tolerances, to first order.
template <class System, class Combinations, class Vector>
unmet_constraint<typename Vector::Scalar> worst_constraint(const System& system, const Combinations& all,
                                                           const Vector& f0, const Vector& weights) {
    using std::abs;
    using scalar = typename Vector::Scalar;
    unmet_constraint<scalar> worst;
    if (all.empty()) return worst;
    const Vector reach = reach_of_tolerance(system, all, weights);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const scalar rest = all[k].of(f0), most = reach[static_cast<int>(k)];
        if (most > scalar(0) && abs(rest) > worst.tolerances * most)
            worst = {static_cast<int>(k), rest, scalar(abs(rest) / most)};
    }
    return worst;
}

/// True where constraints can be looked at: M is not the identity, its entries and those of J are here.
template <class System>
inline constexpr bool shows_constraints =
    !System::mass_type::identity && has_entries<typename System::mass_type> && System::sums_type::complete &&
    !System::opaque;

/// What a method with |R(infinity)| = 1 asks of a start with a singular M, whose errors in algebraic components it would
/// hand on for ever: that no equation without a derivative is off by more than `most` tolerances in every component can
/// account for, to first order; slope() = f(t0, y0), weights are the inverse tolerances. bad_problem names the equation.
/// Nothing is asked where the entries of M or J are not here.
template <class System, class Slope, class Vector>
void demand_consistent_start(const System& system, Slope&& slope, const Vector& weights,
                             const typename Vector::Scalar& most) {
    if constexpr (shows_constraints<System>) {
        using scalar = typename Vector::Scalar;
        const auto constraints = constraints_of(system.mass(), system.size());
        if (constraints.empty()) return;
        const auto worst = worst_constraint(system, constraints, slope(), weights);
        if (!(worst.tolerances > most)) return;
        const auto& unmet = constraints[static_cast<std::size_t>(worst.number)];
        std::ostringstream text;
        const char* between = unmet.at.size() > 1 ? "the combination of equations " : "equation ";
        text << "integrate: y0 is not consistent: ";
        for (std::size_t i = 0; i < unmet.at.size(); ++i)
            if (!(unmet.value[i] == scalar(0))) {
                text << between << unmet.at[i];
                between = ", ";
            }
        text << " (counted from 0), which has no derivative, leaves " << worst.rest
             << ". A method with |R(infinity)| = 1 never forgets that: take radau_iia, or "
                "consistent_initial_values of dae/consistent.hpp";
        throw bad_problem(text.str());
    }
}

/// The status of a run that has not made its first step and would end with `found`: where the start is off by more than ten
/// tolerances, that is the reason, and counts takes the equation and how far.
template <class System, class Vector>
status blame_start(status found, System& system, const typename Vector::Scalar& t, const Vector& y,
                   const Vector& weights, report<typename Vector::Scalar>& counts) {
    if constexpr (shows_constraints<System>) {
        using std::abs;
        if (found != status::newton_failed && found != status::step_underflow) return found;
        const auto constraints = constraints_of(system.mass(), system.size());
        Vector f(y.size());
        system.evaluate_inside(t, y, f);
        const auto worst = worst_constraint(system, constraints, f, weights);
        if (!(worst.tolerances > typename Vector::Scalar(10))) return found;
        const auto& unmet = constraints[static_cast<std::size_t>(worst.number)];
        std::size_t most = 0;
        for (std::size_t i = 0; i < unmet.at.size(); ++i)
            if (abs(unmet.value[i]) > abs(unmet.value[most])) most = i;
        counts.unmet_equation = unmet.at[most];
        counts.unmet_rest = worst.rest;
        counts.unmet_tolerances = worst.tolerances;
        return status::inconsistent_start;
    } else {
        return found;
    }
}

}  // namespace stagecraft
