// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <complex>
#include <initializer_list>
#include <iosfwd>
#include <type_traits>

#include <stagecraft/checkpoint.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>
#include <stagecraft/refuse/given_arguments.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/result.hpp>

// Calls of integrate() that cannot be meant as they stand: each says in one sentence what to write. Nothing else needs
// this, and nobody who reads the engine has to.

namespace stagecraft {

/// Results and reports are not printed by <<.
template <class Traits, class Vector>
std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out, const result<Vector>&) {
    static_assert(detail::never<Vector>,
                  "write print(std::cout, r) of stagecraft/report_text.hpp, or print r.status, r.t and r.y");
    return out;
}
template <class Traits, class Scalar>
std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out, const report<Scalar>&) {
    static_assert(detail::never<Scalar>, "write print(std::cout, r.report) of stagecraft/report_text.hpp");
    return out;
}

namespace detail {

struct call_by_a_name {
    template <class T>
    static constexpr bool say() {
        static_assert(!sizeof(T),
                      "integrate(method, problem, y0, t0, t1, options, observer): the name of overloaded "
                      "functions or of a template cannot be passed as the problem: write "
                      "[](const auto& t, const auto& y, auto& f) { name(t, y, f); }");
        return true;
    }
};
struct call_of_integrate {
    template <class T>
    static constexpr bool say() {
        static_assert(
            sizeof(T) == 0,
            "integrate(method, problem, y0, t0, t1, options, observer), with a checkpoint in place of y0, "
            "t0: t0 and t1 are numbers; options have no such name, or "
            "one with a value of another type: {.rtol, .atol, .atol_components, .fixed_step, .initial_step, "
            ".min_step, .max_step, .control, .continuous, .jumps, .max_steps, .newton_iterations, "
            ".newton_factor, .break_points, .consistent_start}");
        return true;
    }
};

}  // namespace detail

/// y0 is no vector of Eigen's (arguments in another order, say).
template <class Method, class Problem, class State, class T0, class T1, class Observer = no_observer>
requires(!detail::eigen_object<State> && !detail::has_own_overload<State>) result<Eigen::VectorXd> integrate(
    const Method&, Problem&&, const State&, const T0&, const T1&, const options<double>& = {},
    Observer&& = {}) {
    constexpr bool state = detail::eigen_object<State>;
    static_assert(
        state,
        "integrate(method, problem, y0, t0, t1, options, observer): the third argument must be a column "
        "vector of Eigen's; with stagecraft/states.hpp it may be a std::array, a std::vector, a double or "
        "complex");
    return {};
}

/// y0 is a list in braces, which has no type.
template <class Method, class Problem, class Observer = no_observer>
result<Eigen::VectorXd> integrate(const Method&, Problem&&, std::initializer_list<double>, double, double,
                                  const options<double>& = {}, Observer&& = {}) {
    static_assert(detail::never<Method>,
                  "integrate: y0 must be a vector with its type, Eigen::Vector2d(1, 1), say, not {1, 1}");
    return {};
}

/// The same with braces around them, or of complex numbers.
template <class Method, class Problem, class Observer = no_observer>
result<Eigen::VectorXd> integrate(const Method&, Problem&&,
                                  std::initializer_list<std::initializer_list<double>>, double, double,
                                  const options<double>& = {}, Observer&& = {}) {
    static_assert(detail::never<Method>,
                  "integrate: y0 must be a vector with its type, Eigen::Vector2d(1, 1), say, not {{1, 1}}");
    return {};
}
template <class Method, class Problem, class Observer = no_observer>
result<Eigen::VectorXd> integrate(const Method&, Problem&&, std::initializer_list<std::complex<double>>,
                                  double, double, const options<double>& = {}, Observer&& = {}) {
    static_assert(detail::never<Method>,
                  "integrate: y0 must be a vector with its type, a named Eigen::Vector2cd, say, with "
                  "stagecraft/states.hpp");
    return {};
}

/// t1, or t0 as well, is missing.
template <class Method, class Problem, class State, class Observer = no_observer>
requires(!detail::is_checkpoint<State>) result<Eigen::VectorXd> integrate(const Method&, Problem&&,
                                                                          const State&, double = 0,
                                                                          const options<double>& = {},
                                                                          Observer&& = {}) {
    static_assert(detail::never<Method>,
                  "integrate(method, problem, y0, t0, t1, options, observer): t0 and t1 must both be given");
    return {};
}

/// Options under the names that other programs give them, or with values of other types.
template <class Method, class Problem, class Observer = no_observer>
result<Eigen::VectorXd> integrate(const Method&, Problem&&, detail::anything, detail::anything,
                                  detail::anything, const detail::misnamed_options&, Observer&& = {}) {
    static_assert(
        detail::never<Method>,
        "integrate: options have no tol, reltol, rel_tol, abstol or abs_tol; their tolerances are "
        "rtol (relative) and atol (absolute): {.rtol = 1e-6, .atol = 1e-9}. Their other names are, in "
        "this order, atol_components (an Eigen::VectorXd or {1e-6, 1e-9}), fixed_step, initial_step, "
        "min_step, "
        "max_step, control (of step_control), continuous, jumps, max_steps, newton_iterations, "
        "newton_factor");
    return {};
}

/// A tolerance, or a step size, in place of the options.
template <class Method, class Problem, class Number, class... More>
requires std::is_arithmetic_v<Number> result<Eigen::VectorXd> integrate(const Method&, Problem&&,
                                                                        detail::anything, detail::anything,
                                                                        detail::anything, const Number&,
                                                                        const More&...) {
    static_assert(detail::never<Method>,
                  "integrate: a number in place of the options; name what it is: {.rtol = 1e-6, .atol = "
                  "1e-9}, {.fixed_step = 0.01}; a Jacobian goes with the problem: with_jacobian(f, J) of "
                  "stagecraft/problem/with.hpp");
    return {};
}

/// The observer in place of the options.
template <class Method, class Problem, class Observer>
requires detail::misplaced_observer<std::remove_cvref_t<Observer>> result<Eigen::VectorXd> integrate(
    const Method&, Problem&&, detail::anything, detail::anything, detail::anything, Observer&&,
    const options<double>& = {}) {
    static_assert(detail::never<Method>,
                  "integrate(method, problem, y0, t0, t1, options, observer): options come before the "
                  "observer: write {} in their place for the defaults");
    return {};
}

/// Several observers, one after the other.
template <class Method, class Problem, class First, class Second, class... More>
result<Eigen::VectorXd> integrate(const Method&, Problem&&, detail::anything, detail::anything,
                                  detail::anything, const options<double>&, const First&, const Second&,
                                  const More&...) {
    static_assert(detail::never<Method>,
                  "integrate: several observers are given as one, observers(a, b), of "
                  "stagecraft/observe/observers.hpp");
    return {};
}

/// Options of names that there are not, or times that are none.
result<Eigen::VectorXd> integrate(detail::refused_call<detail::call_of_integrate>, detail::anything,
                                  detail::anything, detail::anything, const detail::misnamed_options&);
result<Eigen::VectorXd> integrate(detail::refused_call<detail::call_of_integrate>, detail::anything,
                                  detail::anything, detail::anything, detail::anything,
                                  const detail::misnamed_options&, detail::anything = 0);
result<Eigen::VectorXd> integrate(detail::refused_call<detail::call_of_integrate>, detail::anything,
                                  detail::anything, detail::anything);
result<Eigen::VectorXd> integrate(detail::refused_call<detail::call_of_integrate>, detail::anything,
                                  detail::anything, ...);
/// A checkpoint of no state, which says itself what to write.
result<Eigen::VectorXd> integrate(detail::anything, detail::anything, const checkpoint<detail::unstated>&,
                                  detail::anything = 0, const detail::misnamed_options& = {},
                                  detail::anything = 0);
/// A problem of no type.
result<Eigen::VectorXd> integrate(detail::refused_call<detail::call_by_a_name>, ...);

}  // namespace stagecraft
