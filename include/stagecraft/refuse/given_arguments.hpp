// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <tuple>
#include <type_traits>
#include <utility>

#include <stagecraft/checkpoint.hpp>
#include <stagecraft/observe/observer.hpp>
#include <stagecraft/options.hpp>
#include <stagecraft/refuse/problem/checked_call.hpp>
#include <stagecraft/run/integrator.hpp>

namespace stagecraft::detail {

template <class Method>
concept runnable_method = requires(const Method& m) {
    as_tuple(m);
};

template <class Method>
using scalar_of_method =
    typename std::tuple_element_t<0, std::decay_t<decltype(as_tuple(std::declval<Method>()))>>::scalar;

/// True if the observer can be called in a run by these, or there is none to be made.
template <bool Runnable, class Method, class Problem, class Vector, class Observer>
inline constexpr bool observes = true;
template <class Method, class Problem, class Vector, class Observer>
inline constexpr bool observes<true, Method, Problem, Vector, Observer> =
    can_observe<Observer, Vector, typename integrator<Method, Problem, Vector>::output_type>;

/// What integrate() looks at in its arguments, and its sentences about them say: what cannot be looked at yet, because
/// of what came before, counts as true.
template <class Method, class Problem, class Vector, class Observer>
struct given_arguments {
    using vector = Vector;
    using scalar = typename Vector::Scalar;
    using check = checked_call<Problem, Vector>;
    static constexpr bool method_first = runnable_method<Method>;
    static constexpr bool same_scalar = [] {
        if constexpr (method_first)
            return std::is_same_v<scalar_of_method<Method>, scalar>;
        else
            return true;
    }();
    /// An additive method and a problem in two parts, or neither.
    static constexpr bool in_parts_or_not = [] {
        if constexpr (method_first)
            return fit_in_parts<Method, Problem>;
        else
            return true;
    }();
    static constexpr bool method_for_parts = in_parts_or_not || !in_parts<Problem>,
                          problem_in_parts = in_parts_or_not || in_parts<Problem>;
    static constexpr bool ready = method_first && same_scalar && in_parts_or_not,
                          returns = ready && returning_right_hand_side<Problem, Vector>,
                          unseen = !ready || returns, good = !unseen && check::good;
    static constexpr bool same_size = [] {
        if constexpr (returns)
            return returns_its_size<Problem, Vector>();
        else
            return true;
    }();
    static constexpr bool object = [] {
        if constexpr (returns)
            return returns_object<Problem, Vector>;
        else
            return true;
    }();
    /// The explicit part can be called, and what it writes arrives.
    static constexpr bool explicit_usable = [] {
        if constexpr (ready && in_parts<Problem>) {
            using part = typename std::remove_const_t<Problem>::explicit_function;
            return (callable_right_hand_side<part, Vector> &&
                    writes_into<part, Vector, typename Vector::Scalar, Vector>) ||
                   returning_right_hand_side<part, Vector>;
        } else {
            return true;
        }
    }();
    static constexpr bool column = unseen || check::column, const_enough = unseen || check::const_enough,
                          callable = unseen || check::callable,
                          uncalled = unseen || !column || !const_enough || !callable,
                          writes_through = uncalled || check::writes_through,
                          band_known = uncalled || check::band_known,
                          pattern_known = uncalled || check::pattern_known,
                          pattern_usable = uncalled || check::pattern_usable,
                          mass_usable = uncalled || check::mass_usable,
                          jacobian_usable = uncalled || check::jacobian_usable,
                          index_usable = uncalled || check::index_usable,
                          band_usable = uncalled || check::band_usable,
                          solver_usable = uncalled || check::solver_usable,
                          constancy_usable = uncalled || check::constancy_usable,
                          lower_case = uncalled || check::lower_case;
    /// The problem is generic, by its declaration, and will be differentiated automatically, in these numbers. integrate()
    /// calls it with them before anybody else does, so that what does not compile in it is said from there.
    using number = dual<scalar, Vector::RowsAtCompileTime>;
    using numbers = dual_vector<scalar, Vector::RowsAtCompileTime>;
    static constexpr bool begun = ready && check::column;
    static constexpr bool differentiated = [] {
        if constexpr (!begun)
            return false;
        else if constexpr (check::without_jacobian)
            return !converts_duals<Problem, const scalar&, const numbers&, numbers&>();
        else
            return false;
    }();
    static constexpr bool observed = observes<good, Method, Problem, Vector, Observer>;

    static auto writing(const Problem& problem) { return writes_returned<std::decay_t<Problem>>{problem}; }
};

template <class Derived>
requires(!Eigen::NumTraits<typename Derived::Scalar>::IsComplex) void take_real(
    const Eigen::MatrixBase<Derived>&);
/// A real matrix of Eigen's.
template <class State>
concept eigen_object = requires(const State& y) {
    take_real(y);
};

/// True of what may stand in the place of y0 by another overload than that of Eigen's vectors.
template <class State>
inline constexpr bool has_own_overload = false;
template <class Vector>
inline constexpr bool has_own_overload<checkpoint<Vector>> = true;
template <class State>
inline constexpr bool is_checkpoint = false;
template <class Vector>
inline constexpr bool is_checkpoint<checkpoint<Vector>> = true;

template <class Scalar>
void take_options(const options<Scalar>&);
/// What may be meant for an observer where the options have been left out.
template <class Observer>
concept misplaced_observer = std::is_class_v<Observer> && !requires(const Observer& o) {
    take_options(o);
}
&&!std::is_convertible_v<const Observer&, options<double>>;

}  // namespace stagecraft::detail
