// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/jacobian/dual_functions.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/owned_value.hpp>
#include <stagecraft/sensitivity/parameters.hpp>

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

/// An event, with the derivatives of its time and of the state there, before the jump, as functions of p.
template <class Vector, class Matrix>
struct event_derivative {
    int event;  ///< its place in the list
    typename Vector::Scalar t;
    Eigen::Matrix<typename Vector::Scalar, 1, Matrix::ColsAtCompileTime> dt;
    Vector y;
    Matrix dy;
};

namespace detail {

template <class T>
inline constexpr bool is_state_event = false;
template <class G, class Jump, class Change>
inline constexpr bool is_state_event<state_event<G, Jump, Change>> = true;
template <class T>
inline constexpr bool are_events = is_state_event<T>;
template <class... T>
inline constexpr bool are_events<std::tuple<T...>> = sizeof...(T) > 0 && (is_state_event<T> && ...);

/// What finds the events of a tuple, at these parameters; nothing where there are none.
template <class Problem, class Parameters, class Vector, class... Events>
auto watch_for(const Problem&, const Parameters& p, const std::tuple<Events...>& list, const Vector&) {
    if constexpr (sizeof...(Events) == 0) {
        return 0;
    } else {
        using watch = event_watch<Vector>;
        using scalar = typename Vector::Scalar;
        std::vector<event_function<typename watch::function>> all;
        const auto add = [&](const auto& one) {
            static_assert(
                owned_number<decltype(one.g(std::declval<const scalar&>(), std::declval<const Vector&>(),
                                            p))>,
                "sensitivity_event: g returns a product of Eigen's, whose operands may be gone before it is "
                "evaluated: write n.dot(y), or (n.transpose() * y).value()");
            all.push_back({[&p, &one](const scalar& t, const Vector& y) { return scalar(one.g(t, y, p)); },
                           {one.options.direction, false}});
        };
        std::apply([&](const auto&... one) { (add(one), ...); }, list);
        return watch(std::move(all));
    }
}

/// Goes across an event at (t, y), of which S is dy/dp before and after; changes t by what g there asks for. `near` is how
/// long g takes to zero from what it is after the event, `mean` its mean slope in the step before.
template <class Event, class Problem, class Parameters, class Vector, class Matrix>
auto cross(const Event& event, int number, Problem& problem, const Parameters& p, typename Vector::Scalar& t,
           Vector& y, Matrix& S, const typename Vector::Scalar& mean, typename Vector::Scalar& near) {
    using std::abs;
    using scalar = typename Vector::Scalar;
    using dual = dual_number<scalar, 1>;
    using duals = Eigen::Matrix<dual, Vector::RowsAtCompileTime, 1>;
    const Eigen::Index m = p.size();
    Vector f = y;
    // g and its derivative along (1, f, 0) or (0, S_k, e_k); jump likewise.
    duals at = promoted<dual>(y), after = at;
    auto q = promoted<dual>(p);
    dual time(t);
    const auto along = [&](const scalar& dt, const Vector& dy, Eigen::Index k, const auto& call) {
        time = dual(t);
        time.derivatives()[0] = dt;
        for (Eigen::Index i = 0; i < y.size(); ++i) {
            at[i].value() = y[i];
            at[i].derivatives()[0] = dy[i];
        }
        if (k >= 0) q[k].derivatives()[0] = scalar(1);
        call();
        if (k >= 0) q[k].derivatives()[0] = scalar(0);
    };
    dual value;
    const auto take_g = [&] { value = event.g(std::as_const(time), std::as_const(at), std::as_const(q)); };
    const auto slopes = [&](Eigen::Index k) {  // of f along (S_k, e_k)
        Vector slope = y;
        along(scalar(0), S.col(k), k,
              [&] { problem(std::as_const(time), std::as_const(at), std::as_const(q), after); });
        for (Eigen::Index i = 0; i < y.size(); ++i) slope[i] = after[i].derivatives()[0];
        return slope;
    };
    // The time was found on the continuous solution, which is less accurate than y: one step of Newton's.
    problem(t, y, p, f);
    along(scalar(1), f, -1, take_g);
    const scalar change = -value.value() / value.derivatives()[0];
    scalar reach = abs(change) * f.template lpNorm<Eigen::Infinity>();
    if (reach - reach == scalar(0) && change != scalar(0)) {
        const Matrix before = S;
        for (Eigen::Index k = 0; k < m; ++k) {
            const Vector slope = slopes(k);
            for (Eigen::Index i = 0; i < y.size(); ++i) S(i, k) = before(i, k) + change * slope[i];
        }
        y += change * f;
        t += change;
        problem(t, y, p, f);
        along(scalar(1), f, -1, take_g);
    }
    const scalar rate = value.derivatives()[0];
    if (!(abs(rate) * 1000000 > abs(mean)) || rate == scalar(0)) {
        std::ostringstream text;
        text << "sensitivities_with_events: at t = " << t << " event " << number
             << " is grazing: its time has no derivative";
        throw std::domain_error(text.str());
    }
    event_derivative<Vector, Matrix> r{number, t, {}, y, S};
    r.dt.resize(m);
    for (Eigen::Index k = 0; k < m; ++k) {
        along(scalar(0), S.col(k), k, take_g);
        r.dt[k] = -value.derivatives()[0] / rate;
        r.dy.col(k) = S.col(k) + r.dt[k] * f;
    }
    for (Eigen::Index k = 0; k < m; ++k) {
        along(r.dt[k], r.dy.col(k), k,
              [&] { event.jump(std::as_const(time), std::as_const(at), std::as_const(q), after); });
        for (Eigen::Index i = 0; i < y.size(); ++i) S(i, k) = after[i].derivatives()[0];
    }
    Vector next = y;
    event.jump(t, std::as_const(r.y), p, next);
    y = next;
    event.change(problem);
    problem(t, y, p, f);
    for (Eigen::Index k = 0; k < m; ++k) S.col(k) -= r.dt[k] * f;
    along(scalar(1), f, -1, take_g);
    near = abs(value.value() / value.derivatives()[0]);
    return r;
}

}  // namespace detail

}  // namespace stagecraft
