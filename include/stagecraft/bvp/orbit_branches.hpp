// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/equilibrium_continuation.hpp>
#include <stagecraft/bvp/orbit_continuation.hpp>
#include <stagecraft/bvp/paths/doubled_orbit.hpp>

namespace stagecraft {

namespace detail {

/// That the first orbit lies `amplitude` away from y in the direction v, at its beginning and its end; q = (T, p).
template <class Vector, class Direction, class Unknowns>
path_demand<typename Vector::Scalar> away_from(const Vector& y, const Direction& v, const Unknowns& q,
                                               const typename Vector::Scalar& amplitude) {
    using scalar = typename Vector::Scalar;
    path_demand<scalar> first;
    first.from.resize(2 * y.size() + 2), first.along.resize(2 * y.size() + 2);
    first.from << y, y, q;
    first.along << v, v, scalar(0), scalar(0);
    first.step = amplitude * first.along.norm();
    first.along.normalize();
    return first;
}

/// Where the first orbits lie on the other side of the point than `to` is, the path says so.
template <class Vector, class Scalar>
std::vector<orbit_point<Vector>> with_side(std::vector<orbit_point<Vector>> path,
                                           const continuation_options<Scalar>& o, const char* point) {
    auto& last = path.back();
    const bool above = last.p[0] > o.from;
    if (path.size() > 2 || last.y.steps() == 0 || above == (o.to > o.from)) return path;
    last.message = std::string("the orbits that begin at this ") + point + " lie at " +
                   (above ? "larger" : "smaller") + " p, and `to` is on the other side of it: give one " +
                   (above ? "above" : "below") + " `from`, which is p of the point";
    return path;
}

inline void demand_start(bool good, const char* what) {
    if (!good) throw std::invalid_argument(std::string("orbit_continuation: ") + what);
}

}  // namespace detail

/// The path of periodic orbits that begins at a Hopf point which equilibrium_continuation() found: the first orbit is o.step away
/// from the equilibrium, in the direction of hopf.cosine, and the path goes on to larger ones; p and the period follow.
/// o.from is that of the point; orbits are there for p on one side of it, and o.to should be there too: where it is not, the
/// message of the last point says so. f and everything else are as for orbit_continuation() from a guess. Throws
/// std::invalid_argument where the point is no Hopf point, or not ok().
template <class Scalar, int S, class Rhs, class Vector>
requires detail::right_hand_side_of_path<Rhs, Scalar, Vector> std::vector<orbit_point<Vector>>
orbit_continuation(const tableau<Scalar, S>& method, Rhs f, const equilibrium_point<Vector>& hopf,
                   const continuation_options<std::type_identity_t<Scalar>>& o = {}) {
    detail::demand_start(hopf.kind == point_kind::hopf && hopf.ok(),
                         "an equilibrium from which orbits are followed must be a Hopf point that is ok()");
    auto own = o;
    own.from = hopf.p[0];
    detail::validate(own, Scalar(0), Scalar(1), "orbit_continuation");
    using std::atan;
    const Scalar turn = 8 * atan(Scalar(1));
    const auto small = [&](const Scalar& s) {
        using std::cos;
        using std::sin;
        return Vector(hopf.y + o.step * (cos(turn * s) * hopf.cosine + sin(turn * s) * hopf.sine));
    };
    const Eigen::Matrix<Scalar, 2, 1> start(hopf.period, hopf.p[0]);
    return detail::with_side(
        detail::follow_orbits<Scalar, S, Rhs, Vector>(method, std::move(f), small, start, own,
                                                      detail::away_from(hopf.y, hopf.cosine, start, o.step)),
        own, "Hopf point");
}

/// The path of orbits of twice the period that begins at a period doubling which orbit_continuation() found: the first one is
/// o.step away from the orbit there, in the direction of the multiplier -1, and the path goes on from it. Everything else
/// is as for that from a Hopf point. From a branch point it is the path that crosses, from the orbit found on it on, at
/// p = crossing_p, which is o.from.
template <class Scalar, int S, class Rhs, class Vector>
requires detail::right_hand_side_of_path<Rhs, Scalar, Vector> std::vector<orbit_point<Vector>>
orbit_continuation(const tableau<Scalar, S>& method, Rhs f, const orbit_point<Vector>& doubling,
                   const continuation_options<std::type_identity_t<Scalar>>& o = {}) {
    const bool crossed = doubling.kind == point_kind::branch_point && doubling.crossing_y.steps() > 0;
    detail::demand_start((doubling.kind == point_kind::period_doubling || crossed) && doubling.ok(),
                         "an orbit from which others are followed must be a period doubling, or a branch "
                         "point with crossing_y, that is ok()");
    using unknowns = Eigen::Matrix<Scalar, 2, 1>;
    if (crossed) {
        auto other = o;
        other.from = doubling.crossing_p;
        detail::validate(other, Scalar(0), Scalar(1), "orbit_continuation");
        return detail::follow_orbits<Scalar, S, Rhs, Vector>(
            method, std::move(f), doubling.crossing_y,
            unknowns(doubling.crossing_period, doubling.crossing_p), other, {});
    }
    using rhs = detail::scaled_rhs_on_path<Rhs>;
    using conditions = detail::orbit_path_conditions<Rhs, Vector>;
    auto own = o;
    own.from = doubling.p[0];
    detail::validate(own, Scalar(0), Scalar(1), "orbit_continuation");
    const Vector at = doubling.y(Scalar(0));
    const Eigen::Index n = at.size();
    const unknowns once(doubling.period, doubling.p[0]), twice(2 * doubling.period, doubling.p[0]);
    const detail::path_problem_of<rhs, conditions, Vector, unknowns> linear(
        two_point_problem<rhs, conditions>{{f}, {f, at, at, at}});
    const auto functions = linear.with({}, static_cast<int>(n), 2);
    const auto jacobian = [&](const Scalar& t) {
        functions->f(t, doubling.y(t), once);
        return functions->jacobian(t).topLeftCorner(n, n).eval();
    };
    const detail::doubled_orbit<Vector> guess{
        doubling.y, doubling.mesh, detail::doubling_direction(method, doubling.mesh, n, jacobian), o.step};
    return detail::with_side(detail::follow_orbits<Scalar, S, Rhs, Vector>(
                                 method, std::move(f), guess, twice, own,
                                 detail::away_from(at, Vector(guess.direction.col(0)), twice, o.step)),
                             own, "period doubling");
}

}  // namespace stagecraft
