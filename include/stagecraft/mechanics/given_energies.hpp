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

namespace stagecraft {

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

/// What is to be known of the energies in a call of `lagrangian`, and of what stands beside them. The potential energy is
/// looked at where the kinetic one is good, so that the first complaint is the only one.
template <int Coordinates, class Kinetic, class Potential, class Forces, class... Others>
struct given_energies {
    using vector = Eigen::Matrix<double, Coordinates, 1>;
    static constexpr std::size_t dual_numbers =
        sizeof(dual_number<dual_number<double, Coordinates>, Coordinates>);
    static constexpr bool generic = !takes_one_scalar<Kinetic> && !takes_one_scalar<Potential> &&
                                    !takes_one_scalar<Forces> && !(takes_one_scalar<Others> || ...),
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
                                    (owned_or_none<const Others&, const vector&> && ...) &&
                                    (owned_or_none<const Others&, const vector&, double> && ...),
                          forces = returns_forces<Forces, Coordinates>,
                          constraint_time = !(constraint_in_plain_time<Others, Coordinates> || ...),
                          forces_time = !forces_in_plain_time<Forces, Coordinates>,
                          on_the_stack = fits_on_the_stack(Coordinates * dual_numbers),
                          usable = generic && kinetic && potential && energy_numbers && objects && forces &&
                                   constraint_time && forces_time && on_the_stack;
};

}  // namespace detail

}  // namespace stagecraft
