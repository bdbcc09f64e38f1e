// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <utility>

#include <stagecraft/integrate.hpp>
#include <stagecraft/method/stabilised_method.hpp>
#include <stagecraft/step/stabilised_step.hpp>

namespace stagecraft {

/// Stabilised explicit methods, for large problems whose stiffness is diffusion: eigenvalues near the negative real axis, f
/// smooth, moderate accuracy. They solve no linear system, and a step costs as many evaluations of f as its length asks
/// for, about sqrt(1.5 h rho) with rkc2, rho the spectral radius of df/dy:
///
///     integrate(rkc2(), f, y0, t0, t1, {.rtol = 1e-4, .atol = 1e-4})
///     integrate(rkc2(), with_spectral_radius(f, 4 * n * n), ...)          // a bound, or a function of (t, y)
///
/// rho is found by the power method unless the problem has a member spectral_radius(t, y) (step/spectral_radius.hpp). Five
/// vectors beside y, whatever the number of stages. `stages` > 0 takes that many in every step, for which h rho must stay
/// within beta; 0 chooses. Where eigenvalues are far from the real axis (advection) or the problem is very stiff with few
/// unknowns, take radau_iia. Of a checkpoint, steps and order go on as they were.
///
/// rkc2: order 2, damping 2/13, beta = 0.65 s^2 (Sommeijer, Shampine and Verwer 1998). rkc1: order 1, damping 1/20,
/// beta = 1.93 s^2 (van der Houwen and Sommeijer 1980). rkl1, rkl2: beta = s (s + 1) and (s^2 + s - 2)/2, monotone for
/// linear diffusion (Meyer, Balsara and Aslam 2014). rkg1, rkg2: Gegenbauer's, beta = s (s + 3)/2 and (s - 1)(s + 4)/3 (Skaras,
/// Saxton, Meyer and Aslam 2021). |R| <= 1 on [-beta, 0] is decided exactly by theory/stability/stabilised_interval.hpp.
template <class Scalar = double>
stabilised_method<Scalar> rkc2(int stages = 0) {
    return {stabilised_family::chebyshev, 2, Scalar(2) / Scalar(13), stages};
}
template <class Scalar = double>
stabilised_method<Scalar> rkc1(int stages = 0) {
    return {stabilised_family::chebyshev, 1, Scalar(1) / Scalar(20), stages};
}
template <class Scalar = double>
stabilised_method<Scalar> rkl1(int stages = 0) {
    return {stabilised_family::legendre, 1, Scalar(0), stages};
}
template <class Scalar = double>
stabilised_method<Scalar> rkl2(int stages = 0) {
    return {stabilised_family::legendre, 2, Scalar(0), stages};
}
template <class Scalar = double>
stabilised_method<Scalar> rkg1(int stages = 0) {
    return {stabilised_family::gegenbauer, 1, Scalar(0), stages};
}
template <class Scalar = double>
stabilised_method<Scalar> rkg2(int stages = 0) {
    return {stabilised_family::gegenbauer, 2, Scalar(0), stages};
}

namespace detail {
template <class Rhs, class Radius>
struct rhs_with_spectral_radius : Rhs {
    Radius radius;
    rhs_with_spectral_radius(Rhs r, Radius rho) : Rhs(std::move(r)), radius(std::move(rho)) {}
    using Rhs::operator();
    template <class T, class Y>
    auto spectral_radius(const T& t, const Y& y) const {
        if constexpr (std::invocable<const Radius&, const T&, const Y&>)
            return radius(t, y);
        else
            return T(radius);
    }
};
}  // namespace detail

/// A right-hand side with a bound of the spectral radius of df/dy: a number, or a function of (t, y). One that is negative or not
/// finite ends integrate() in bad_problem (std::invalid_argument).
template <class Rhs, class Radius>
auto with_spectral_radius(Rhs rhs, Radius radius) {
    return detail::rhs_with_spectral_radius<Rhs, Radius>(std::move(rhs), std::move(radius));
}

}  // namespace stagecraft
