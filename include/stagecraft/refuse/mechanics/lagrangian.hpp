// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <type_traits>

#include <stagecraft/refuse/detect/refused_call.hpp>
#include <stagecraft/refuse/mechanics/given_energies.hpp>

// Calls of lagrangian() that cannot be meant as they stand: each says in one sentence what to write.

namespace stagecraft {

template <int Coordinates, class Parts>
class lagrangian_energies;

namespace detail {

/// A model in place of one that has been refused. Of a `Kinetic` energy, so that no model is asked for before there is a call.
template <int Coordinates, bool Constrained, class Kinetic>
auto refused_lagrangian() {
    using parts = lagrangian_parts<refused_energy, refused_energy, refused_energy, no_forces>;
    if constexpr (Constrained)
        return lagrangian_model<(Coordinates > 1 ? Coordinates : 2), 1, parts>(parts{});
    else
        return lagrangian_energies<Coordinates, parts>(parts{});
}

}  // namespace detail

/// An energy, a constraint or forces cannot be used.
template <int Coordinates, int Constraints = 0, class Kinetic, class Potential, class First = no_constraint,
          class Second = no_forces>
requires(!detail::given_to_lagrangian<Coordinates, Constraints, Kinetic, Potential, First,
                                      Second>::usable) auto lagrangian(const Kinetic&, const Potential&,
                                                                       const First& = {},
                                                                       const Second& = {}) {
    using given = detail::given_to_lagrangian<Coordinates, Constraints, Kinetic, Potential, First, Second>;
    static_assert(given::numbered,
                  "lagrangian<n, m>: give m, the number of constraints, as well: lagrangian<2, 1>(T, V, g); "
                  "forces without constraints, lagrangian<n>(T, V, Q), must be callable as Q(q, v, t)");
    static_assert(!given::missing, "lagrangian<n, m>(T, V, g): the m constraints g are missing");
    static_assert(given::generic,
                  "lagrangian: T, V, Q and the constraint must accept vectors of any scalar, as they are "
                  "differentiated automatically: [](const auto& q, const auto& v) { ... }");
    static_assert(given::on_the_stack,
                  "lagrangian: n is too large for arrays of dual numbers on the stack (24 fit by default); "
                  "write M, F and G by hand on Eigen::VectorXd (stagecraft/mechanics/sized_model.hpp), or "
                  "M^-1 F as an ordinary differential equation: these have any size");
    static_assert(
        given::kinetic,
        "lagrangian: the kinetic energy must be callable as T(q, v), and comes before the potential "
        "energy V(q)");
    static_assert(given::potential, "lagrangian: the potential energy must be callable as V(q)");
    static_assert(given::energy_numbers,
                  "lagrangian: T and V must return a number, not a matrix or product of Eigen's: write "
                  "0.5 * v.dot(M * v), or (0.5 * v.transpose() * M * v).value()");
    static_assert(
        given::objects,
        "lagrangian: the constraint or Q returns an expression of Eigen's, whose operands may be gone "
        "before it is evaluated: write `return (-C * v).eval();`");
    static_assert(
        given::forces,
        "lagrangian: the generalised forces must be callable as Q(q, v, t), with t even where they "
        "do not depend on it, [](const auto& q, const auto& v, const auto& t) { ... }, and return a "
        "vector of n numbers");
    static_assert(given::forces_time,
                  "lagrangian: the generalised forces must take t of any scalar as well, as they are "
                  "differentiated automatically: [](const auto& q, const auto& v, const auto& t) { ... }");
    static_assert(given::constraint_time,
                  "lagrangian: the constraint must take t of any scalar as well, as it is differentiated "
                  "automatically: [](const auto& q, const auto& t) { ... }");
    static_assert(
        given::fewer,
        "lagrangian<n, m>: m must be less than n: with as many constraints as coordinates nothing "
        "moves, unless some depend on others: independent_constraints<m>(constraint, q) keeps m of them");
    static_assert(given::constrained,
                  "lagrangian<n, m>(T, V, g): the constraint must be callable as g(q) or g(q, t) and return "
                  "its values, a number where m is 1");
    static_assert(
        given::columns,
        "lagrangian: the constraint must return a number or a column of position constraints, the matrix "
        "G of n columns, or (G, b) of n + 1 columns");
    static_assert(given::rows,
                  "lagrangian<n, m>: the constraint must return m rows, or a number where m is 1");
    constexpr bool constrained = (Constraints > 0 && !given::missing) ||
                                 std::is_invocable_v<const First&, const typename given::vector&>;
    return detail::refused_lagrangian<Coordinates, constrained, Kinetic>();
}

/// Both numbers are missing.
template <class Kinetic, class... Parts>
auto lagrangian(const Kinetic&, const Parts&...) {
    static_assert(detail::never<Kinetic>,
                  "lagrangian<n, m>(T, V, constraint): give n, the number of coordinates, and m, that of "
                  "constraints; lagrangian<n>(T, V) has none");
    return detail::refused_lagrangian<2, true, Kinetic>();
}

}  // namespace stagecraft
