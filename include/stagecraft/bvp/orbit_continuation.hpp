// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/paths/path.hpp>
#include <stagecraft/bvp/periodic_orbit.hpp>

namespace stagecraft {

/// A periodic orbit on a path of such. At a fold only p is within the tolerance: y and the period depend on p
/// like a square root there, so that the rounding errors of p leave half of their digits.
template <class Vector>
struct orbit_point {
    using scalar = typename Vector::Scalar;
    Eigen::Matrix<scalar, 1, 1> p;
    scalar period{0};
    solution<Vector>
        y;  ///< over [0, 1], time in units of the period; without steps where a last point failed
    std::vector<floquet_multiplier<scalar>> multipliers;  ///< by decreasing modulus; see periodic_orbit
    point_kind kind = point_kind::regular;
    bvp_status status = bvp_status::newton_failed;
    std::string
        message;  ///< of the last point: why the path ends there, in words; empty where p has passed `to`
    scalar arclength{0};  ///< in the space of (y(0), y(1), T, p)
    std::vector<scalar> mesh;
    /// Branch points: an orbit on the path that crosses, close by, from which orbit_continuation() of bvp/orbit_branches.hpp
    /// follows it. Empty (crossing_y.steps() == 0) where none was found.
    scalar crossing_p{0}, crossing_period{0};
    solution<Vector> crossing_y{};

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

template <class Rhs, class Scalar, class Vector>
concept right_hand_side_of_path = requires(Rhs& f, const Scalar& t, const Vector& y,
                                           const Eigen::Matrix<Scalar, 1, 1>& p, Vector& out) {
    f(t, y, p, out);
};

/// y(0) = y(1), and y(0) on a plane through the last orbit's y(0) and its mean: orbits that shrink to the mean pass through
/// it all the same. Where f is nearly in such a plane it is turned until f crosses it.
template <class Rhs, class Vector>
struct orbit_path_conditions {
    Rhs f;
    Vector at, normal, flow;  ///< flow: the direction of f at `at`

    template <class Y, class Q, class R>
    void operator()(const Y& left, const Y& right, const Q&, R& r) const {
        const Eigen::Index n = at.size();
        for (Eigen::Index i = 0; i < n; ++i) r[i] = left[i] - right[i];
        r[n] = left[0] * typename Vector::Scalar(0);
        for (Eigen::Index i = 0; i < n; ++i) r[n] = r[n] + normal[i] * (left[i] - at[i]);
    }
    template <class Orbit, class Parameters>
    void follow(const Orbit& y, const Parameters& q) {
        using scalar = typename Vector::Scalar;
        at = y(scalar(0));
        normal = flow = direction(at, q);
        const Vector out = at - orbit_swing<Vector>(y).mean;
        if (out.norm() > scalar(0)) {
            const scalar along = flow.dot(out) / out.norm(), part = along * along, most = scalar(9) / 10;
            normal -= (part > most ? scalar(most / part) : scalar(1)) * along / out.norm() * out;
        }
        normal.normalize();
    }
    /// The tangent of a path in (y(0), y(1), T, p), less what is a shift in phase, so that it stays in the plane.
    template <class Column>
    Column in_plane(const Column& tangent) const {
        const Eigen::Index n = at.size();
        const auto shift = normal.dot(tangent.head(n)) / normal.dot(flow);
        Column turned = tangent;
        turned.head(n) -= shift * flow;
        turned.segment(n, n) -= shift * flow;
        return turned.normalized();
    }
    /// Does f still cross the plane at y(0)? Where it does not, orbits only touch the plane, and p may turn there.
    template <class Parameters>
    bool crosses(const Vector& left, const Parameters& q) {
        return normal.dot(direction(left, q)) > normal.dot(flow) / 2;
    }

  private:
    template <class Parameters>
    Vector direction(const Vector& y, const Parameters& q) {
        using scalar = typename Vector::Scalar;
        Vector value(y.size());
        f(scalar(0), y, Eigen::Matrix<scalar, 1, 1>(q[1]), value);
        return value.normalized();
    }
};

/// The path of orbits from the one near `guess`, over [0, 1], and (T, p) on; `first` as in path_problem.
template <class Scalar, int S, class Rhs, class Vector, class Orbit>
std::vector<orbit_point<Vector>> follow_orbits(const tableau<Scalar, S>& method, Rhs f, const Orbit& guess,
                                               const Eigen::Matrix<Scalar, 2, 1>& start,
                                               const continuation_options<Scalar>& o,
                                               const path_demand<Scalar>& first) {
    using rhs = scaled_rhs_on_path<Rhs>;
    using conditions = orbit_path_conditions<Rhs, Vector>;
    using unknowns = Eigen::Matrix<Scalar, 2, 1>;
    const Vector at = guess(Scalar(0));
    two_point_problem<rhs, conditions> problem{{f}, {f, at, at, at}};
    problem.r.follow(guess, start);
    path_problem_of<rhs, conditions, Vector, unknowns> of(std::move(problem));
    of.start = first;
    std::vector<orbit_point<Vector>> path;
    auto states = follow_path<S, Vector, unknowns>(method, of, Scalar(0), Scalar(1), guess, start, o);
    const bool shrinks = states.back().kind == point_kind::hopf;
    for (auto& s : states) {
        path.push_back({Eigen::Matrix<Scalar, 1, 1>(s.p[1]), s.p[0], std::move(s.y), std::move(s.multipliers),
                        s.kind, s.status, s.message, s.arclength, std::move(s.mesh)});
        auto& point = path.back();
        if (s.other_y.steps() > 0)
            point.crossing_p = s.other_p[1], point.crossing_period = s.other_p[0],
            point.crossing_y = std::move(s.other_y);
        if (s.kind == point_kind::regular && s.status != bvp_status::success) break;
        const bvp_status judged = judge_orbit(point.y, o.rtol);
        if (judged == bvp_status::success || (shrinks && judged == bvp_status::equilibrium)) continue;
        point.status = judged, point.kind = point_kind::regular;
        point.message = words_of(judged);
        break;
    }
    return path;
}

struct call_of_orbit_continuation {
    template <class Method>
    static constexpr bool say() {
        static_assert(is_one_tableau<Method> || never<Method>,
                      "orbit_continuation: the first argument must be a collocation tableau, gauss<3>() with "
                      "its parentheses, say; gauss_variable() is of solve_bvp alone");
        static_assert(
            !is_one_tableau<Method> || never<Method>,
            "orbit_continuation(method, f, guess, options): f is called as f(t, y, p, out), guess must be an "
            "orbit_guess at "
            "p = from, as last_return(method, f, y0, t0, t1) of stagecraft/last_return.hpp finds it; "
            "options have no other names than {.from, .to, .rtol, .step, .largest_step, "
            ".max_points, .intervals}");
        return true;
    }
};

}  // namespace detail

/// The path of periodic orbits of the autonomous y' = f(y, p), called as f(t, y, p, out) with one parameter p, from the orbit
/// near `guess` at p[0] = o.from on; period and parameter are unknowns, the phase is fixed by the orbit before.
///
/// Located are, beside folds and branch points as by continuation(), period doublings, where a multiplier passes -1,
/// and torus points, where a complex pair passes the unit circle. Every point costs what periodic_orbit()
/// costs from a near guess, with the multipliers found on the orbit's mesh halved once. The path ends as that of
/// continuation(), or at a point or an orbit run through several times.
///
/// Where the orbits shrink to an equilibrium the path ends in a Hopf point (Kuznetsov 2004, section 3.5): its y is the
/// equilibrium, its period 2 pi/omega, +- i omega being the eigenvalues of f_y there, two of its multipliers are 1, and p is as
/// accurate as f_y, which automatic differentiation gives to rounding errors and differences to about 1e-8. It may
/// lie beyond `to`.
///
/// Where the period grows without bound (the orbits pass a saddle ever more closely, and p stays, Kuznetsov 2004, section 6.2)
/// the path ends with a point of the kind `homoclinic`, whose p is that of the homoclinic orbit to the tolerance. A special
/// point counts only where the multipliers that decide it are known better than to their distance from the unit circle; where
/// none is found near 1, they are lost to rounding errors, and the path ends with the status tolerance_not_met.
template <class Scalar, int S, class Rhs, class Vector>
requires detail::right_hand_side_of_path<Rhs, Scalar, Vector> std::vector<orbit_point<Vector>>
orbit_continuation(const tableau<Scalar, S>& method, Rhs f, const orbit_guess<Vector>& guess,
                   const continuation_options<std::type_identity_t<Scalar>>& o = {}) {
    detail::validate(o, Scalar(0), Scalar(1), "orbit_continuation");
    detail::validate_period(guess, "orbit_continuation");
    return detail::follow_orbits<Scalar, S, Rhs, Vector>(
        method, std::move(f), detail::in_units_of_the_period(guess), {guess.period, o.from}, o, {});
}

/// Another first argument, no guess of the period, or options of names that there are not.
std::vector<orbit_point<Eigen::VectorXd>> orbit_continuation(
    detail::refused_call<detail::call_of_orbit_continuation>, detail::anything, detail::anything,
    const detail::misnamed_options&);
std::vector<orbit_point<Eigen::VectorXd>> orbit_continuation(
    detail::refused_call<detail::call_of_orbit_continuation>, detail::anything = 0, detail::anything = 0,
    ...);

}  // namespace stagecraft
