// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/continuation_options.hpp>
#include <stagecraft/bvp/paths/equilibrium_path.hpp>
#include <stagecraft/bvp/paths/no_conditions.hpp>
#include <stagecraft/bvp/result.hpp>
#include <stagecraft/jacobian/automatic.hpp>
#include <stagecraft/problem/two_point.hpp>

namespace stagecraft {

/// An equilibrium on a path of such.
template <class Vector>
struct equilibrium_point {
    using scalar = typename Vector::Scalar;
    using parameters = Eigen::Matrix<scalar, 1, 1>;
    parameters p;
    Vector y;
    std::vector<std::complex<scalar>> eigenvalues;  ///< of f_y, by decreasing real part
    std::vector<scalar> eigenvalue_errors;          ///< to first order
    point_kind kind = point_kind::regular;
    bvp_status status = bvp_status::newton_failed;
    std::string
        message;  ///< of the last point: why the path ends there, in words; empty where p has passed `to`
    scalar arclength{0};  ///< in the space of (y, p)
    /// Branch points: an equilibrium on the path that crosses, close by, from which equilibrium_continuation() follows it.
    /// Empty (crossing_y.size() == 0) where none was found.
    parameters crossing_p = parameters::Zero();
    Eigen::Matrix<scalar, Eigen::Dynamic, 1> crossing_y;
    /// Hopf points: the period 2 pi/omega of the small orbits there, y + a (cosine cos(2 pi s) + sine sin(2 pi s)) with s in
    /// units of it and the amplitude a; |cosine| = 1 >= |sine|.
    scalar period{0};
    Vector cosine, sine;

    bool ok() const { return status == bvp_status::success; }
};

namespace detail {

template <class Vector, class Scalar>
equilibrium_point<Vector> point_of(rest_state<Scalar>&& s) {
    const Eigen::Index n = s.x.size() - 1;
    equilibrium_point<Vector> point;
    point.p[0] = s.x[n], point.y = s.x.head(n);
    point.eigenvalues = std::move(s.spectrum.values), point.eigenvalue_errors = std::move(s.spectrum.errors);
    point.kind = s.kind, point.status = s.status, point.message = std::move(s.message);
    point.arclength = s.arclength;
    if (s.crossing.size() > 0) point.crossing_p[0] = s.crossing[n], point.crossing_y = s.crossing.head(n);
    if (s.turning > Scalar(0)) {
        using std::atan;
        point.period = 8 * atan(Scalar(1)) / s.turning;
        point.cosine = s.cosine, point.sine = s.sine;
    }
    return point;
}

}  // namespace detail

/// The path of equilibria of the autonomous y' = f(y, p) from the one near the guess y0 at p[0] = o.from on, by
/// pseudo-arclength. f is called as f(t, y, p, out) with one parameter p; the arclength is that of (y, p)
/// (Allgower-Georg); o.intervals is not looked at.
///
/// Every point is solved to rounding errors. Located are folds, branch points, where another path crosses
/// (by the determinant; a crossing that leaves its sign as it is is not seen), and Hopf points, where a pair of complex
/// eigenvalues passes the imaginary axis (by the product of all sums of two, Kuznetsov 2004, section 10.2; real ones that pass each
/// other's negative are no Hopf point). A change of sign counts only where every such sum is known better than
/// to its distance from zero at both ends; f_y is known to rounding errors where f is differentiated automatically, and to 1e-7
/// by differences. The p of a Hopf point is as good as the real part of the pair over its slope, and where that is worse than
/// o.rtol the status is tolerance_not_met. From a Hopf point orbit_continuation() (bvp/orbit_branches.hpp) follows the orbits.
///
/// A path ends where p has passed `to`; the last point's message says where it ends otherwise. Costs some five evaluations of f
/// and its Jacobian and the eigenvalues for a point, ten times that for a special one.
template <class Rhs, class Guess>
requires requires { typename Guess::PlainObject; }
auto equilibrium_continuation(Rhs f, const Guess& y0,
                              const continuation_options<typename Guess::Scalar>& o = {}) {
    using vector = typename Guess::PlainObject;
    using scalar = typename vector::Scalar;
    using parameters = Eigen::Matrix<scalar, 1, 1>;
    using problem = two_point_problem<Rhs, detail::no_conditions>;
    constexpr bool callable = detail::writes_last<Rhs, vector, scalar, vector, parameters>;
    static_assert(
        callable,
        "equilibrium_continuation(f, y0, options): f is called as f(t, y, p, out), y and out of the "
        "type of y0, p being a vector of one number");
    std::vector<equilibrium_point<vector>> path;
    if constexpr (callable) {
        detail::validate(o, scalar(0), scalar(1), "equilibrium_continuation");
        const vector start = y0;
        detail::demand_bvp(start.size() > 0 && start.allFinite(),
                           "y0 must be finite, with one component at least", "equilibrium_continuation");
        problem of{std::move(f), {}};
        report<scalar> counts;
        const int n = static_cast<int>(start.size());
        two_point_system<problem, vector, parameters> functions(of.f, of.r, n, 1, counts);
        detail::rest_equations<scalar> equations{
            [&](const auto& x, auto& value, auto& J) {
                value = functions.f(scalar(0), x.head(n), parameters(x[n])).head(n);
                J = functions.jacobian(scalar(0)).topRows(n);
            },
            functions.differences ? scalar(1e-7) : scalar(100 * std::numeric_limits<scalar>::epsilon())};
        detail::rest_follower<scalar> follower(std::move(equations), o);
        for (auto& s : follower.run(start)) path.push_back(detail::point_of<vector>(std::move(s)));
    }
    return path;
}

}  // namespace stagecraft
