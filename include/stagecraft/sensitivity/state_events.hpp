// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <utility>

#include <stagecraft/observe/event_watch.hpp>

namespace stagecraft {

namespace detail {
/// The state stays as it is, and so does the problem.
struct no_jump {
    template <class T, class Y, class P, class After>
    void operator()(const T&, const Y& y, const P&, After& after) const {
        after = y;
    }
};
struct no_change {
    template <class Problem>
    void operator()(Problem&) const {}
};
}  // namespace detail

/// An event of sensitivities_with_events(); sensitivity_event() makes it.
template <class G, class Jump = detail::no_jump, class Change = detail::no_change>
struct state_event {
    G g;
    Jump jump;
    Change change;
    event_options options;
};

/// The event g(t, y, p) = 0. jump(t, y, p, after) writes the state after it, change(problem) makes the problem the one that is
/// solved from there on (sets a mode of it, in place of an `if` in f, say). g and jump are generic in their scalars.
template <class G, class Jump = detail::no_jump, class Change = detail::no_change>
state_event<G, Jump, Change> sensitivity_event(G g, event_options options = {}, Jump jump = {},
                                               Change change = {}) {
    return {std::move(g), std::move(jump), std::move(change), options};
}

/// An event, or a change at a given time, with the derivatives of its time and of the state there, before the change, as
/// functions of p.
template <class Vector, class Matrix>
struct event_derivative {
    int event;  ///< its place in the list
    typename Vector::Scalar t;
    Eigen::Matrix<typename Vector::Scalar, 1, Matrix::ColsAtCompileTime> dt;  ///< zero at a given time
    Vector y;
    Matrix dy;
    /// About the relative error of the derivatives of g and of the change where these are differences; zero where exact.
    typename Vector::Scalar error{0};
};

namespace detail {

template <class T>
inline constexpr bool is_state_event = false;
template <class G, class Jump, class Change>
inline constexpr bool is_state_event<state_event<G, Jump, Change>> = true;

}  // namespace detail

}  // namespace stagecraft
