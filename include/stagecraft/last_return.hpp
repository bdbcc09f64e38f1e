// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <stdexcept>

#include <stagecraft/bvp/periodic_orbit.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>

namespace stagecraft {

namespace detail {
struct call_of_last_return {
    template <class T>
    static constexpr bool say() {
        static_assert(
            never<T>,
            "last_return(method, f, y0, t0, t1, options): method is radau_iia<3>() with its parentheses, "
            "say, f "
            "is called as f(t, y, out), y0 is a vector of Eigen's; options are those of integrate()");
        return true;
    }
};
}  // namespace detail

/// Integrates from t0 to t1, once to find the last state and once with an event where the trajectory passes the
/// plane through it that is normal to f; the last pass near that state and t1 bound one return. `o` are the options of the
/// integrations. Throws std::invalid_argument where the trajectory does not come back.
template <class Method, class Rhs, class Vector>
requires detail::runnable_method<Method> orbit_guess<Vector> last_return(
    const Method& method, const Rhs& f, const Vector& y0, typename Vector::Scalar t0,
    typename Vector::Scalar t1,
    const options<typename Vector::Scalar>& o = {.rtol = typename Vector::Scalar(1e-8),
                                                 .atol = typename Vector::Scalar(1e-8)}) {
    using scalar = typename Vector::Scalar;
    const auto first = integrate(method, f, y0, t0, t1, o);
    if (!first.ok()) throw std::invalid_argument("last_return: the integration does not reach t1");
    const Vector end = first.y;
    Vector normal(end.size());
    f(t1, end, normal);
    orbit_guess<Vector> guess;
    integrate(method, f, y0, t0, t1, o, guess.y);
    const auto plane = [&](const scalar&, const Vector& y) { return scalar(normal.dot(y - end)); };
    auto passes = events<Vector>(event(plane, {.direction = crossing::rising}));
    scalar size(0);
    integrate(method, f, y0, t0, t1, o, passes);
    for (const auto& pass : passes.found()) size = std::max(size, scalar((pass.y - end).norm()));
    for (int k = 0; k < 200; ++k)  // the last one is `end`
        size = std::max(size, scalar((guess.y(t0 + (t1 - t0) * scalar(k) / 200) - end).norm()));
    const auto& found = passes.found();
    for (auto pass = found.rbegin(); pass != found.rend(); ++pass)
        if (t1 - pass->t > (t1 - t0) / 1000000 && (pass->y - end).norm() < size / 10) {
            guess.begin = pass->t;
            guess.period = t1 - pass->t;
            return guess;
        }
    throw std::invalid_argument("last_return: the trajectory does not come back to its last state before t1");
}

/// Other arguments.
orbit_guess<Eigen::VectorXd> last_return(detail::refused_call<detail::call_of_last_return>, detail::anything,
                                         detail::anything = 0, detail::anything = 0, detail::anything = 0,
                                         ...);

}  // namespace stagecraft
