// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <sstream>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/orbit_continuation.hpp>

namespace stagecraft {

namespace detail {

/// y' = T (f(y) + alpha g(y)) on [0, 1] with the unknowns (alpha, T).
template <class Rhs, class Gradient>
struct unfolded_rhs {
    Rhs f;
    Gradient g;
    template <class T, class Y, class Q>
    requires(
        std::is_invocable_v<Rhs&, const T&, const Y&, Y&>&& std::is_invocable_v<Gradient&, const Y&, Y&>) void
    operator()(const T& t, const Y& y, const Q& q, Y& out) {
        Y gradient(y.size());
        g(y, gradient);
        f(t, y, out);
        for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = (out[i] + q[0] * gradient[i]) * q[1];
    }
};

/// f with a parameter that it does not take, for the condition on the phase.
template <class Rhs>
struct rhs_beside_parameter {
    Rhs f;
    template <class T, class Y, class P, class Out>
    void operator()(const T& t, const Y& y, const P&, Out& out) {
        f(t, y, out);
    }
};

/// That g f = 0 along the guess.
template <class Rhs, class Gradient, class Orbit>
void demand_conserved(Rhs& f, Gradient& g, const Orbit& guess) {
    using vector = std::decay_t<decltype(guess(0.))>;
    using scalar = typename vector::Scalar;
    for (int k = 0; k < 16; ++k) {
        const vector y = guess(scalar(k) / 16);
        vector slope = y, gradient = y;
        f(scalar(0), y, slope), g(y, gradient);
        const scalar change = gradient.dot(slope), size = gradient.norm() * slope.norm();
        std::ostringstream text;
        text << "gradient is not that of a conserved quantity: gradient . f is " << change << " beside "
             << size << " where y is (" << y.transpose() << ')';
        using std::abs;
        demand_bvp(abs(change) <= scalar(1e-8) * size, text.str().c_str(), "orbit_family");
    }
}

}  // namespace detail

/// The family of periodic orbits of an autonomous y' = f(y) with a conserved quantity H (a Hamiltonian system, for one), from the
/// orbit near `guess`, over [0, 1], of the period `period` on: p[0] of its points is their period, and o.to where the path ends.
///
/// Such orbits are not isolated at a fixed parameter, so that periodic_orbit() and orbit_continuation() do not find them.
/// Here they are those of y' = f(y) + alpha grad H(y), where alpha is unknown: on an orbit the integral of
/// alpha |grad H|^2 is zero, so that alpha is, and the family is a path in (alpha, T) without a kernel
/// (Munoz-Almaraz 2003). f is called as f(t, y, out), gradient as gradient(y, out); guess(s) returns a vector: of the guess g
/// that last_return() finds, g.y(g.begin + s * g.period). A fold is an extremum of the period. Everything else is as for
/// orbit_continuation(); the multiplier 1 is double, and known to half of the digits. std::invalid_argument is thrown where
/// gradient . f is not zero.
template <class Scalar, int S, class Rhs, class Gradient, class Guess>
auto orbit_family(const tableau<Scalar, S>& method, Rhs f, Gradient gradient, const Guess& guess,
                  std::type_identity_t<Scalar> period,
                  const continuation_options<std::type_identity_t<Scalar>>& o = {}) {
    using vector = std::decay_t<decltype(guess(Scalar(0)))>;
    using unknowns = Eigen::Matrix<Scalar, 2, 1>;
    using rhs = detail::unfolded_rhs<Rhs, Gradient>;
    using conditions = detail::orbit_path_conditions<detail::rhs_beside_parameter<Rhs>, vector>;
    detail::demand_bvp(period > Scalar(0) && period - period == Scalar(0),
                       "period must be positive and finite", "orbit_family");
    auto own = o;
    own.from = period;
    detail::validate(own, Scalar(0), Scalar(1), "orbit_family");
    detail::demand_conserved(f, gradient, guess);
    const vector at = guess(Scalar(0));
    const unknowns start(Scalar(0), period);
    two_point_problem<rhs, conditions> problem{{f, gradient}, {{f}, at, at, at}};
    problem.r.follow(guess, start);
    detail::path_problem_of<rhs, conditions, vector, unknowns> of(std::move(problem));
    std::vector<orbit_point<vector>> path;
    for (auto& s :
         detail::follow_path<S, vector, unknowns>(method, of, Scalar(0), Scalar(1), guess, start, own)) {
        path.push_back({Eigen::Matrix<Scalar, 1, 1>(s.p[1]), s.p[1], std::move(s.y), std::move(s.multipliers),
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
