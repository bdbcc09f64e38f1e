// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <stdexcept>

#include <stagecraft/linear/mass.hpp>
#include <stagecraft/problem/capabilities.hpp>
#include <stagecraft/refuse/problem/checked_capabilities.hpp>

namespace stagecraft::detail {

/// What a problem brings that its run cannot use, and what it lacks; a message for each.
template <class Problem, class Scalar, bool Analytic>
struct checked_distribution {
    static constexpr bool distributed = has_add_up<Problem, Scalar>;
    static_assert(!distributed || Analytic,
                  "problem.add_up: finite differences and automatic differentiation do not see components on "
                  "other processes: write jacobian(t, y, J), J of the type of matrix()");
    static_assert(
        !distributed || has_linear_solver<Problem>,
        "problem.add_up: the built-in linear solvers do not see components on other processes: give "
        "the problem a linear_solver");
    static_assert(!distributed || !has_second_order_components<Problem>,
                  "problem.add_up: second_order_components cannot be used in a distributed problem");
    static_assert(!has_matrix<Problem> || has_type_named_matrix<Problem> ||
                      (Analytic && has_linear_solver<Problem>),
                  "problem.matrix needs jacobian(t, y, J), J of its type, and a linear_solver that takes it");
};

/// std::invalid_argument where second_order_components are too many, or M is not one there or leaves the band of J.
template <class Problem, class Mass, class Matrix>
void demand_mass_fits([[maybe_unused]] const Mass& mass, [[maybe_unused]] const Matrix& J,
                      [[maybe_unused]] int n) {
    if constexpr (has_bandwidth<Problem> && !Mass::identity && has_entries<Mass>)
        for (const auto& e : mass.entries())
            if (!J.in_band(e.row, e.column))
                throw std::invalid_argument("integrate: problem.mass() must lie within problem.bandwidth()");
    if constexpr (has_second_order_components<Problem>) {
        const int m = position_components<Problem>(n);
        if (Problem::second_order_components == Eigen::Dynamic && 2 * m != n)
            throw std::invalid_argument(
                "integrate: y0 = (q, v) must have an even number of components, as many q as v");
        if (m < 0 || 2 * m > n)
            throw std::invalid_argument("integrate: problem.second_order_components must be at most n / 2");
        if constexpr (!Mass::identity) {
            int ones = 0;
            for (const auto& e : mass.entries())
                if (std::min(e.row, e.column) < m) ones += e.row == e.column && e.value == 1 ? 1 : 2 * n;
            if (ones != m)
                throw std::invalid_argument(
                    "integrate: problem.mass() must be one in the rows and columns of "
                    "second_order_components");
        }
    }
}

/// std::invalid_argument where the index flags are not those of n components.
template <class Flags>
void demand_index_flags(const Flags& flags, int n, bool identity) {
    if (static_cast<int>(flags.size()) != n)
        throw std::invalid_argument("integrate: problem.index() must have the size of y0");
    for (int i = 0; i < n; ++i) {
        if (flags[i] < 0 || flags[i] > 3)
            throw std::invalid_argument("integrate: problem.index() must hold 1, 2 or 3");
        if (flags[i] > 1 && identity)
            throw std::invalid_argument(
                "integrate: problem.index() holds 2 or 3, but there is no problem.mass(): "
                "without one all components are of index 1");
    }
}

}  // namespace stagecraft::detail
