// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/path.hpp>
#include <stagecraft/bvp/periodic_orbit.hpp>

namespace stagecraft {

/// A periodic orbit on a path of such.
template <class Vector>
struct orbit_point {
    using scalar = typename Vector::Scalar;
    Eigen::Matrix<scalar, 1, 1> p;
    scalar period{0};
    solution<Vector> y;                                   ///< over [0, 1], time in units of the period
    std::vector<floquet_multiplier<scalar>> multipliers;  ///< by decreasing modulus; see periodic_orbit
    point_kind kind = point_kind::regular;
    bvp_status status = bvp_status::newton_failed;
    std::string
        message;  ///< of the last point: why the path ends there, in words; empty where p has passed `to`
    scalar arclength{0};  ///< in the space of (y(0), y(1), T, p)
    std::vector<scalar> mesh;

    bool ok() const { return status == bvp_status::success; }
};

namespace detail {

/// y' = T f(y, p) on [0, 1] with the unknowns (T, p).
template <class Rhs>
struct scaled_rhs_on_path {
    Rhs f;
    template <class T, class Y, class Q, class P = Eigen::Matrix<typename Y::Scalar, 1, 1>>
    requires(std::is_invocable_v<Rhs&, const T&, const Y&, const P&, Y&>) void operator()(const T& t,
                                                                                          const Y& y,
                                                                                          const Q& q,
                                                                                          Y& out) {
        f(t, y, P(q[1]), out);
        for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = out[i] * q[0];
    }
};

/// y(0) = y(1), and y(0) on the plane through the last point of the path that is normal to its f.
template <class Rhs, class Vector>
struct orbit_path_conditions {
    Rhs f;
    Vector at, normal;

    template <class Y, class Q, class R>
    void operator()(const Y& left, const Y& right, const Q&, R& r) const {
        const Eigen::Index n = at.size();
        for (Eigen::Index i = 0; i < n; ++i) r[i] = left[i] - right[i];
        r[n] = left[0] * typename Vector::Scalar(0);
        for (Eigen::Index i = 0; i < n; ++i) r[n] = r[n] + normal[i] * (left[i] - at[i]);
    }
    template <class Parameters>
    void follow(const Vector& left, const Parameters& q) {
        using scalar = typename Vector::Scalar;
        const Vector last = normal;
        at = left;
        f(scalar(0), left, Eigen::Matrix<scalar, 1, 1>(q[1]), normal);
        normal.normalize();
        // Beyond a Hopf point f has turned round: the sign of a condition is that of the determinant.
        if (normal.dot(last) < scalar(0)) normal = -normal;
    }
};

}  // namespace detail

/// The path of periodic orbits of the autonomous y' = f(y, p), called as f(t, y, p, out) with one parameter p, from the orbit
/// near `guess` at p[0] = o.from on; period and parameter are unknowns, the phase is fixed by the orbit before.
///
/// Located are, beside folds and branch points as by continuation(), period doublings, where a multiplier passes -1,
/// and torus points, where a complex pair passes the unit circle. Every point costs what periodic_orbit()
/// costs from a near guess, with the multipliers found on the orbit's mesh halved once. The path ends as that of
/// continuation(), or at a point or an orbit run through several times. Beyond a Hopf point, where the orbits shrink to a
/// point, it comes back over the same orbits; p turns there, and what is found between has the status
/// tolerance_not_met or equilibrium, the latter of which ends the path.
template <class Scalar, int S, class Rhs, class Vector>
std::vector<orbit_point<Vector>> orbit_continuation(
    const tableau<Scalar, S>& method, Rhs f, const orbit_guess<Vector>& guess,
    const continuation_options<std::type_identity_t<Scalar>>& o = {}) {
    using rhs = detail::scaled_rhs_on_path<Rhs>;
    using conditions = detail::orbit_path_conditions<Rhs, Vector>;
    using unknowns = Eigen::Matrix<Scalar, 2, 1>;
    detail::validate(o, Scalar(0), Scalar(1), "orbit_continuation");
    detail::validate_period(guess, "orbit_continuation");
    const Vector at = guess.y(guess.begin);
    const unknowns start(guess.period, o.from);
    two_point_problem<rhs, conditions> problem{{f}, {f, at, at}};
    problem.r.follow(at, start);
    detail::path_follower<Scalar, S, rhs, conditions, Vector, unknowns> follower(method, problem, Scalar(0),
                                                                                 Scalar(1), o);
    std::vector<orbit_point<Vector>> path;
    for (auto& s : follower.run(detail::in_units_of_the_period(guess), start)) {
        path.push_back({Eigen::Matrix<Scalar, 1, 1>(s.p[1]), s.p[0], std::move(s.y), std::move(s.multipliers),
                        s.kind, s.status, s.message, s.arclength, std::move(s.mesh)});
        auto& point = path.back();
        if (s.kind == point_kind::regular && s.status != bvp_status::success) break;
        const bvp_status judged = detail::judge_orbit(point.y, o.rtol);
        if (judged == bvp_status::success) continue;
        point.status = judged, point.kind = point_kind::regular;
        point.message = detail::words_of(judged);
        break;
    }
    return path;
}

}  // namespace stagecraft
