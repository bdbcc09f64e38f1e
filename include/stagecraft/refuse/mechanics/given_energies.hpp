// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <cstddef>
#include <type_traits>

#include <stagecraft/jacobian/dual_number.hpp>
#include <stagecraft/mechanics/model.hpp>
#include <stagecraft/owned_value.hpp>
#include <stagecraft/refuse/detect/named_member.hpp>
#include <stagecraft/refuse/detect/taken_arguments.hpp>
#include <stagecraft/refuse/mechanics/checked_model.hpp>

namespace stagecraft {

template <int Coordinates, int Constraints, class Parts>
class lagrangian_model;

/// No generalised forces: only those of the potential act.
struct no_forces {};
/// No constraint: every coordinate is free.
struct no_constraint {};

namespace detail {

template <class F, class Vector, bool Moves>
struct returned_by {
    using type = std::remove_cvref_t<std::invoke_result_t<const F&, const Vector&>>;
};
template <class F, class Vector>
struct returned_by<F, Vector, true> {
    using type = std::remove_cvref_t<std::invoke_result_t<const F&, const Vector&, double>>;
};

/// True if T is a callable, but no template: its address can be taken.
template <class T>
concept takes_one_scalar = requires {
    &T::operator();
};

/// True for generalised forces Q(q, v, t), which no constraint can be called as.
template <class Q, int Coordinates, class Vector = Eigen::Matrix<double, Coordinates, 1>>
concept forces_on = std::is_invocable_v<const Q&, const Vector&, const Vector&, const double&>;

/// True if the generic F, which can be called with a number as its last argument t, takes no dual number there: it is
/// declared as `double t`. The other arguments are vectors. Found out without compiling what F does.
template <class F, class... Vectors>
concept takes_plain_time =
    !takes_one_scalar<F> && has_member_named<F, call_operator_member> && !std::is_final_v<F> &&
    converts_argument<F, sizeof...(Vectors), const Vectors&..., const dual_number<double, 1>&>;

/// A constraint g(q, t) and forces Q(q, v, t) that do so.
template <class Constraint, int Coordinates, class Vector = Eigen::Matrix<double, Coordinates, 1>,
          class Dual = Eigen::Matrix<dual_number<double, 1>, Coordinates, 1>>
concept constraint_in_plain_time =
    std::is_invocable_v<const Constraint&, const Vector&, double> && takes_plain_time<Constraint, Dual>;
template <class Forces, int Coordinates, class Dual = Eigen::Matrix<dual_number<double, 1>, Coordinates, 1>>
concept forces_in_plain_time = forces_on<Forces, Coordinates> && takes_plain_time<Forces, Dual, Dual>;

/// What the caller of `lagrangian` gives.
template <class Kinetic, class Potential, class Constraint, class Forces>
struct lagrangian_parts {
    Kinetic T;
    Potential V;
    Constraint constraint;
    Forces Q;
};

/// Stands in for a kinetic or potential energy that is refused, so that the one sentence that says why is all.
struct refused_energy {
    template <class Vector>
    auto operator()(const Vector&, const Vector& v) const {
        return v.squaredNorm();
    }
    template <class Vector>
    auto operator()(const Vector& q) const {
        return q.squaredNorm();
    }
};

/// True for forces of which a vector can be made, and where there are none.
template <class Q, int Coordinates, class Vector = Eigen::Matrix<double, Coordinates, 1>>
concept returns_forces = std::is_same_v<Q, no_forces> ||
    requires(const Q& forces, const Vector& q, const double& t) {
    { forces(q, q, t) } -> std::convertible_to<Vector>;
};

/// The energies return numbers. A product of Eigen's that converts to one refers to M, which may be gone.
template <class Energy, class... Vectors>
concept returns_energy = requires(const Energy& energy, const Vectors&... x) {
    { energy(x...) } -> owned_number;
};

/// What the constraint of a model returns, where it can be looked at, has so many columns and rows.
template <bool Seen, class Model>
struct fit_of {
    static constexpr bool columns_fit = true, rows_fit = true;
};
template <class Model>
struct fit_of<true, Model> : Model {};

/// What is to be known of the arguments in a call of `lagrangian`, of a Constraint where there is one, M rows. The potential
/// energy is looked at where the kinetic one is good, so that the first complaint is the only one.
template <int Coordinates, int M, class Kinetic, class Potential, class Constraint, class Forces>
struct given_energies {
    using vector = Eigen::Matrix<double, Coordinates, 1>;
    using parts = lagrangian_parts<Kinetic, Potential, Constraint, Forces>;
    static constexpr std::size_t dual_numbers =
        sizeof(dual_number<dual_number<double, Coordinates>, Coordinates>);
    static constexpr bool free = std::is_same_v<Constraint, no_constraint>,
                          without_forces = std::is_same_v<Forces, no_forces>;
    /// Without M a constraint has been taken for forces, or forces do not take t.
    static constexpr bool numbered = M > 0 || without_forces || forces_on<Forces, Coordinates>;
    static constexpr bool generic = !takes_one_scalar<Kinetic> && !takes_one_scalar<Potential> &&
                                    !takes_one_scalar<Forces> && !takes_one_scalar<Constraint>,
                          kinetic = std::is_invocable_v<const Kinetic&, const vector&, const vector&>,
                          potential = !kinetic || std::is_invocable_v<const Potential&, const vector&>,
                          energy_numbers =
                              [] {
                                  if constexpr (!generic || !kinetic || !potential ||
                                                !std::is_invocable_v<const Potential&, const vector&>)
                                      return true;  // these come first
                                  else
                                      return returns_energy<Kinetic, vector, vector> &&
                                             returns_energy<Potential, vector>;
                              }(),
                          objects = owned_or_none<const Forces&, const vector&, const vector&, double> &&
                                    owned_or_none<const Constraint&, const vector&> &&
                                    owned_or_none<const Constraint&, const vector&, double>,
                          forces = !numbered || returns_forces<Forces, Coordinates>,
                          constraint_time = !constraint_in_plain_time<Constraint, Coordinates>,
                          forces_time = !forces_in_plain_time<Forces, Coordinates>,
                          on_the_stack = fits_on_the_stack(Coordinates * dual_numbers),
                          fewer = M < Coordinates, missing = free && M > 0,
                          constrained = free || std::is_invocable_v<const Constraint&, const vector&> ||
                                        std::is_invocable_v<const Constraint&, const vector&, double>,
                          alone = numbered && generic && kinetic && potential && energy_numbers && objects &&
                                  forces && constraint_time && forces_time && on_the_stack && fewer &&
                                  !missing && constrained;
    using fit = fit_of<alone && !free, lagrangian_model<Coordinates, M, parts>>;
    static constexpr bool columns = fit::columns_fit, rows = fit::rows_fit, usable = alone && columns && rows;
};

/// The same for what stands after the energies: a constraint, if there are M > 0, and forces.
template <int Coordinates, int M, class Kinetic, class Potential, class First = no_constraint,
          class Second = no_forces>
using given_to_lagrangian =
    given_energies<Coordinates, M, Kinetic, Potential, std::conditional_t<M == 0, no_constraint, First>,
                   std::conditional_t<M == 0 && !std::is_same_v<First, no_constraint>, First, Second>>;

}  // namespace detail

}  // namespace stagecraft
