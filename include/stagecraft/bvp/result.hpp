// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <exception>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include <stagecraft/bvp/status.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>

namespace stagecraft {

/// Prints it as a word.
template <class Traits>
std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out, bvp_status s) {
    return out << name(s);
}

/// Results with such a status, and the points of paths, are not printed by <<.
template <class Traits, class Result>
requires std::is_same_v<decltype(Result::status), bvp_status> std::basic_ostream<char, Traits>
&operator<<(std::basic_ostream<char, Traits>& out, const Result&) {
    static_assert(detail::never<Result>, "print r.status, r.message and the values of r.y(t)");
    return out;
}

/// The cost of a solution. f and jacobians are counted per evaluation at a point, f_jacobian as in report.hpp;
/// a factorisation or a solve is one of the whole system.
struct bvp_report {
    int meshes = 0;
    int intervals = 0;  ///< of the last mesh
    int newton_steps = 0;
    long f = 0, f_jacobian = 0, jacobians = 0;
    int factorisations = 0;
    int solves = 0;        ///< in Newton's iteration
    int error_solves = 0;  ///< for the error estimate: one per mesh
    int conditioning_solves = 0;
};

/// The estimated error y - y_exact: from the linearised problem, driven by the defect of the collocation polynomial.
template <class Vector>
struct bvp_error {
    using scalar = typename Vector::Scalar;
    /// The largest of |error_i(t)| / (atol/rtol + |y_i(t)|), and the same for p; infinity where it is not known,
    /// Newton's iteration having ended without a solution.
    scalar global{0};
    Vector
        components;  ///< the largest absolute error of each component over [a, b]; infinity where it is not known
    Eigen::Matrix<scalar, Eigen::Dynamic, 1> parameters;  ///< absolute errors of p
    scalar defect{0};  ///< the largest |y' - f(t, y)| / (atol/rtol + |f|) of the returned y(t)

    /// Of n components and m parameters nothing is known.
    void forget(Eigen::Index n, Eigen::Index m) {
        global = std::numeric_limits<scalar>::infinity();
        components.setConstant(n, global);
        parameters.setConstant(m, global);
    }
};

/// How well posed the linearised problem is, in the spectral norm, as found at mesh points and nodes.
/// X(t) is the fundamental matrix, M = B_a X(a) + B_b X(b), Phi = X M^-1, G Green's function. All are those of the problem
/// on the last mesh: where y needs no finer one, modes that it does not show may be worse conditioned than this says (those
/// that grow to both sides of a turning point, for one).
template <class Scalar>
struct bvp_conditioning {
    Scalar kappa1{0};  ///< max |Phi(t)|: how far boundary data reach (lecture (4.6); Ascher-Mattheij-Russell)
    Scalar kappa2{0};  ///< sup |G(t, s)|, found by alternating searches: a lower bound, mostly the value
    Scalar kappa{0};   ///< max over t of |Phi(t)| + int |G(t, s)| ds at the t of kappa2 (Cash-Mazzia 2005)
    Scalar gamma1{0};  ///< the mean of |Phi(t)| over [a, b]
    Scalar sigma{0};   ///< kappa1 / gamma1: large where the problem has layers (Cash-Mazzia 2005)
};

/// The result of solve_bvp. y(t) is continuous and, like p, within the tolerance where status is success.
template <class Vector, class Parameters>
struct bvp_result {
    using scalar = typename Vector::Scalar;
    bvp_status status = bvp_status::newton_failed;
    std::string message;  ///< what went wrong, in words; empty for success
    int kernel = 0;       ///< not_isolated: the dimension of the solution set
    solution<Vector> y;
    Parameters p;
    std::vector<scalar> mesh;
    bvp_error<Vector> error;
    bvp_conditioning<scalar> conditioning;
    bvp_report report;
    std::exception_ptr exception;  ///< what a callable threw (function_threw), else null

    bool ok() const { return status == bvp_status::success; }
};

namespace detail {

/// The message about an f that was not finite at t. Is t an end of the interval, where not every method evaluates f?
template <class Scalar>
std::string not_finite_at(const Scalar& t, bool end) {
    std::ostringstream text;
    text.precision(std::numeric_limits<Scalar>::max_digits10);
    text << "f or its Jacobian gave NaN or infinity, or left a component unwritten, at t = " << t;
    if (end) text << ", an end of the interval, where Gauss methods do not evaluate f";
    return text.str();
}

}  // namespace detail

}  // namespace stagecraft
