// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <utility>

#include <stagecraft/integrate.hpp>
#include <stagecraft/method/additive_method.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>
#include <stagecraft/step/relaxed_step.hpp>

namespace stagecraft {

/// An explicit, diagonally implicit or additive method whose steps keep an invariant eta(y) to rounding, or let a dissipated quantity fall
/// as f lets it: the direction of a step stays, its length is chosen so (Ketcheson 2019). The order stays as well.
///
///     integrate(relaxation(classical_rk4(), [](const auto& y) { return y.squaredNorm(); }), f, y0, t0, t1,
///               {.fixed_step = 0.1})
///
/// eta is called with y and returns a number; a generic one is differentiated along the slopes of the stages, which the rate
/// of a dissipated quantity asks for. One that takes vectors of numbers alone is an invariant. A step ends where the relaxed
/// time says, so that equal steps are nearly equal; t1 and break points are met exactly. A step costs one scalar equation, some
/// four calls of eta and one more of each stage, and f at its end where the method would take that slope from its last
/// stage. Between the ends y(t) is Hermite's cubic. bad_problem (std::invalid_argument) where eta(y0) is not finite;
/// std::invalid_argument for methods whose stages are solved together and problems with a mass matrix.
///
/// An additive method (additive.hpp) moves along the slopes of both parts together, so that eta need be an invariant of their
/// sum alone (Ranocha-Sayyari-Dalcin-Parsani-Ketcheson 2020):
///
///     integrate(relaxation(ark4(), energy), split(f_explicit, f_implicit), y0, t0, t1)
template <class Scalar, int Stages, class Quantity>
auto relaxation(const tableau<Scalar, Stages>& method, Quantity eta) {
    return relaxed_method<tableau<Scalar, Stages>, Quantity>{method, std::move(eta)};
}

/// The same of an additive method.
template <class Scalar, int Stages, class Quantity>
auto relaxation(const additive_method<Scalar, Stages>& method, Quantity eta) {
    return relaxed_method<additive_method<Scalar, Stages>, Quantity>{method, std::move(eta)};
}

namespace detail {
struct call_of_relaxation {
    template <class Method>
    static constexpr bool say() {
        static_assert(
            never<Method>,
            "relaxation(method, eta): the method must be a tableau, explicit or diagonally implicit, or an "
            "additive method, classical_rk4() with its parentheses, say");
        return true;
    }
};
}  // namespace detail

/// Of what is neither.
relaxed_method<tableau<double>, double (*)(const Eigen::VectorXd&)> relaxation(
    detail::refused_call<detail::call_of_relaxation>, ...);

}  // namespace stagecraft
