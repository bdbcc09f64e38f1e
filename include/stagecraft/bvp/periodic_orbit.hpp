// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <stagecraft/bvp/instances.hpp>
#include <stagecraft/bvp/paths/multipliers.hpp>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/observe/solution.hpp>

namespace stagecraft {

/// A stretch of a trajectory that nearly returns to where it began.
template <class Vector>
struct orbit_guess {
    using scalar = typename Vector::Scalar;
    solution<Vector> y;
    scalar begin{0}, period{0};
};

/// The options of periodic_orbit; see bvp_options.
template <class Scalar>
struct orbit_options {
    Scalar rtol = Scalar(1) / 1000000;
    Scalar atol{0};
    int intervals = 20;
    int max_intervals = 10000;
    int phase_component = -1;  ///< i >= 0: the phase is fixed by y_i(0) = phase_value (lecture 4.4.1), which
    Scalar phase_value{0};     ///< needs f_i(y(0)) != 0; else by f(g) (y(0) - g) = 0, g the guess at 0
    bool integral_phase =
        false;  ///< the phase is that in which the orbit is nearest to the guess: the integral of
                ///< g' (y - g) is zero (Doedel-Keller-Kernevez 1991), as a mean over 1000 points
};

template <class Vector>
struct orbit_result {
    using scalar = typename Vector::Scalar;
    bvp_status status = bvp_status::newton_failed;
    std::string message;
    scalar period{0};
    solution<Vector> y;                                   ///< over [0, 1], time in units of the period
    std::vector<floquet_multiplier<scalar>> multipliers;  ///< by decreasing modulus
    bvp_error<Vector> error;                              ///< error.parameters[0] is that of the period
    std::vector<scalar> mesh;
    bvp_report report;

    bool ok() const { return status == bvp_status::success; }
};

namespace detail {

/// y' = T f(y) on [0, 1].
template <class Rhs>
struct scaled_rhs {
    Rhs f;
    template <class T, class Y, class P>
    requires(std::is_invocable_v<Rhs&, const T&, const Y&, Y&>) void operator()(const T& t, const Y& y,
                                                                                const P& p, Y& out) {
        f(t, y, out);
        for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = out[i] * p[0];
    }
};

template <class Vector>
struct orbit_conditions {
    Vector at, normal;
    typename Vector::Scalar shift;
    template <class Y, class P, class R>
    void operator()(const Y& left, const Y& right, const P&, R& r) const {
        const Eigen::Index n = at.size();
        for (Eigen::Index i = 0; i < n; ++i) r[i] = left[i] - right[i];
        r[n] = left[0] * typename Vector::Scalar(0) - shift;
        for (Eigen::Index i = 0; i < n; ++i) r[n] = r[n] + normal[i] * (left[i] - at[i]);
    }
};

/// The condition on the phase: a component with its value, or a normal on f at the guess; zero at an equilibrium.
template <class Rhs, class Vector, class Scalar>
orbit_conditions<Vector> phase_of(Rhs& f, const orbit_guess<Vector>& guess, const orbit_options<Scalar>& o) {
    const Vector at = guess.y(guess.begin);
    const Eigen::Index n = at.size();
    if (o.phase_component >= n)
        throw std::invalid_argument("periodic_orbit: phase_component must be below the size of y");
    if (o.phase_component >= 0 && o.integral_phase)
        throw std::invalid_argument("periodic_orbit: phase_component and integral_phase exclude each other");
    Vector normal(n);
    f(guess.begin, at, normal);
    Vector later = normal;
    f(guess.begin + guess.period * Scalar(0.381966), at, later);
    if ((normal.array() < later.array() || normal.array() > later.array()).any())
        throw std::invalid_argument(
            "periodic_orbit: f must not depend on t; solutions of an equation that does, of a period "
            "that is known, are found by solve_bvp with r = left - right");
    if (!(normal.norm() > Scalar(0))) return {at, Vector::Zero(n), Scalar(0)};
    if (o.phase_component < 0) return {at, normal / normal.norm(), Scalar(0)};
    return {at, Vector::Unit(n, o.phase_component), o.phase_value - at[o.phase_component]};
}

template <class Vector>
void validate_period(const orbit_guess<Vector>& guess, const std::string& who) {
    if (guess.y.steps() == 0)
        throw std::invalid_argument(who + ": guess.y must be a solution; last_return() finds a guess");
    if (!(guess.period > 0) || !(guess.period - guess.period == 0))
        throw std::invalid_argument(who + ": guess.period must be positive and finite");
}

/// The guess as a function on [0, 1].
template <class Vector>
auto in_units_of_the_period(const orbit_guess<Vector>& guess) {
    return [&guess](const typename Vector::Scalar& s) {
        const typename Vector::Scalar t = guess.begin + s * guess.period;
        return guess.y(t < guess.y.t1() ? t : guess.y.t1());
    };
}

/// The first mesh on [0, 1]: as dense as the steps of the run that the guess comes from, which has found out where the orbit
/// is fast. One interval for eight of its steps, which are of lower order and of a tighter tolerance, at least `least`.
template <class Vector>
auto mesh_of_steps(const orbit_guess<Vector>& guess, int least, int most) {
    using scalar = typename Vector::Scalar;
    std::vector<scalar> t{scalar(0)};
    for (const scalar& time : guess.y.ends_of_steps()) {
        const scalar s = (time - guess.begin) / guess.period;
        if (s > t.back() && s < scalar(1)) t.push_back(s);
    }
    // The parts of steps that begin and end cut off are no steps.
    if (t.size() > 2 && 2 * (t[1] - t[0]) < t[2] - t[1]) t.erase(t.begin() + 1);
    if (t.size() > 2 && 2 * (scalar(1) - t.back()) < t.back() - t[t.size() - 2]) t.pop_back();
    t.push_back(scalar(1));
    const std::vector<scalar> parts(t.size() - 1, scalar(1));
    return equidistributed(t, mesh_density(t, parts, scalar(5)),
                           std::min(std::max(least, static_cast<int>(parts.size()) / 8), most), {});
}

/// By how much an orbit y over [0, 1] has to be shifted, y(s + shift), for the mean of g'(s) (y(s + shift) - g(s)) to
/// vanish, by Newton's iteration from 0.
template <class Vector, class Guess>
auto shift_to(const Guess& guess, const solution<Vector>& y) {
    using scalar = typename Vector::Scalar;
    using std::abs;
    using std::floor;
    constexpr int points = 1000;
    scalar shift(0);
    for (int k = 0; k < 20; ++k) {
        scalar sum(0), slope(0);
        for (int i = 0; i < points; ++i) {
            const scalar s = scalar(2 * i + 1) / scalar(2 * points), d = scalar(1) / scalar(2 * points);
            const Vector rate = (guess(s + d) - guess(s - d)) / (2 * d);
            const scalar at = s + shift - floor(s + shift);
            sum += rate.dot(Vector(y(at) - guess(s)));
            slope += rate.dot(y.derivative(at));
        }
        if (!(slope > scalar(0))) break;
        const scalar step = std::clamp(scalar(-sum / slope), scalar(-0.1), scalar(0.1));
        shift += step;
        if (abs(step) < 100 * std::numeric_limits<scalar>::epsilon()) break;
    }
    return scalar(shift - floor(shift));
}

/// Is the orbit y over [0, 1] a point, or run through several times? Differences count as none up to 1000 errors, `error` being
/// that of y relative to 1 + |y|, but where that is much, not up to more than a fiftieth.
template <class Vector>
bvp_status judge_orbit(const solution<Vector>& y, const typename Vector::Scalar& error) {
    using scalar = typename Vector::Scalar;
    using std::sqrt;
    const scalar none = std::clamp(scalar(1000 * error), scalar(sqrt(std::numeric_limits<scalar>::epsilon())),
                                   scalar(scalar(1) / 50));
    const Vector start = y(scalar(0));
    scalar size(0);
    for (int k = 1; k < 64; ++k) size = std::max(size, scalar((y(scalar(k) / 64) - start).norm()));
    const scalar whole = 1 + start.norm();
    if (size <= std::max(none, scalar(10 * error)) * whole) return bvp_status::equilibrium;
    for (int times = 2; times < 8; ++times) {
        scalar gap(0);
        for (int k = 0; k < 8; ++k) {
            const scalar s = scalar(k) / scalar(8 * times);
            gap = std::max(gap, scalar((y(s) - y(s + scalar(1) / scalar(times))).norm()));
        }
        if (gap <= std::max(scalar(none * size), scalar(10 * error * whole)))
            return bvp_status::multiple_period;
    }
    return bvp_status::success;
}

/// Does the guess over [0, 1] come back to where it begins, to six digits of its size? It is an orbit then, not a point.
template <class Vector, class Guess>
bool closes(const Guess& guess) {
    using scalar = typename Vector::Scalar;
    const Vector start = guess(scalar(0));
    scalar size(0);
    for (int k = 1; k < 64; ++k) size = std::max(size, scalar((guess(scalar(k) / 64) - start).norm()));
    return size > scalar(0) && (guess(scalar(1)) - start).norm() <= size / 1000000;
}

/// The verdict of judge_orbit in words.
constexpr const char* words_of(bvp_status judged) {
    return judged == bvp_status::equilibrium ? "the orbit is a point"
                                             : "the period is a multiple of the smallest one";
}

/// An orbit over [0, 1] whose parameter is its period, and where it is found and they are asked for its multipliers.
template <int S, class Vector>
bvp_result<Vector, Eigen::Matrix<typename Vector::Scalar, 1, 1>> solve_orbit(
    const tableau<typename Vector::Scalar, S>& method,
    two_point_functions<typename Vector::Scalar, Vector::RowsAtCompileTime, 1>& problem,
    const guess_view<Vector>& guess, const Eigen::Matrix<typename Vector::Scalar, 1, 1>& period,
    const bvp_options<typename Vector::Scalar>& o,
    std::vector<floquet_multiplier<typename Vector::Scalar>>* multipliers) {
    using scalar = typename Vector::Scalar;
    bvp_solver<S, Vector, Eigen::Matrix<scalar, 1, 1>> solver(method, problem, period, o);
    auto solved = solver.run(guess, scalar(0), scalar(1));
    if (multipliers && solved.ok()) *multipliers = multipliers_with_errors(solver, problem.size(), 4);
    return solved;
}

struct call_of_periodic_orbit {
    template <class Method>
    static constexpr bool say() {
        static_assert(is_one_tableau<Method> || never<Method>,
                      "periodic_orbit: the first argument must be a collocation tableau, gauss<3>() with its "
                      "parentheses, say; gauss_variable() is of solve_bvp alone");
        static_assert(
            !is_one_tableau<Method> || never<Method>,
            "periodic_orbit(method, f, guess, options): f is called as f(t, y, out), guess must be an "
            "orbit_guess, as "
            "last_return(method, f, y0, t0, t1) of stagecraft/last_return.hpp finds it; options have "
            "no other names than {.rtol, .atol, .intervals, .max_intervals, .phase_component, "
            ".phase_value, .integral_phase}");
        return true;
    }
};

}  // namespace detail

/// A periodic orbit of the autonomous y' = f(y), its period (unknown, in the border of the linear systems) and
/// its Floquet multipliers. f is called as f(t, y, out); guess from last_return(), or any orbit_guess. One of the
/// multipliers is 1; for how they and their errors are found see bvp/paths/multipliers.hpp. Where the iteration leaves a guess
/// that closes for an equilibrium, or for a period that is not positive, the status is newton_failed.
template <class Scalar, int S, class Rhs, class Vector>
requires detail::writes_last<Rhs, Vector, Scalar, Vector> orbit_result<Vector> periodic_orbit(
    const tableau<Scalar, S>& method, Rhs f, const orbit_guess<Vector>& guess,
    const orbit_options<std::type_identity_t<Scalar>>& o = {}) {
    detail::validate_period(guess, "periodic_orbit");
    const auto phase = detail::phase_of(f, guess, o);
    const int n = static_cast<int>(phase.at.size());
    orbit_result<Vector> r;
    if (phase.normal.isZero(Scalar(0))) {
        r.status = bvp_status::equilibrium;
        r.message = "the guess begins at an equilibrium";
        r.error.forget(n, 1);
        return r;
    }
    using problem = two_point_problem<detail::scaled_rhs<Rhs>, detail::orbit_conditions<Vector>>;
    using parameters = Eigen::Matrix<Scalar, 1, 1>;
    problem scaled{{f}, phase};
    bvp_options<Scalar> b;
    b.rtol = o.rtol, b.atol = o.atol, b.intervals = o.intervals, b.max_intervals = o.max_intervals;
    b.conditioning = false;
    detail::validate(b, Scalar(0), Scalar(1), "periodic_orbit");
    b.mesh = detail::mesh_of_steps(guess, o.intervals, o.max_intervals);
    const auto given = detail::in_units_of_the_period(guess);
    Scalar shift_of_orbit(0), period = guess.period;
    solution<Vector> first;
    const auto value = [&](const Scalar& s) {
        using std::floor;
        if (first.steps() == 0) return given(s);
        const Scalar at_time = s + shift_of_orbit;
        return first(Scalar(at_time - floor(at_time)));
    };
    bvp_result<Vector, parameters> solved;
    for (;;) {
        const bool last = !o.integral_phase || first.steps() > 0;
        report<Scalar> counts;
        two_point_system<problem, Vector, parameters> functions(scaled.f, scaled.r, n, 1, counts);
        solved = detail::solve_orbit<S, Vector>(method, functions, value, parameters(period), b,
                                                last ? &r.multipliers : nullptr);
        if (last || solved.status != bvp_status::success) break;
        shift_of_orbit = detail::shift_to(given, solved.y);
        first = std::move(solved.y);
        period = solved.p[0];
        scaled.r.at = first(shift_of_orbit), scaled.r.shift = Scalar(0);
        f(guess.begin, scaled.r.at, scaled.r.normal);
        scaled.r.normal /= scaled.r.normal.norm();
    }
    r.status = solved.status, r.message = solved.message;
    r.period = solved.p[0];
    r.y = std::move(solved.y);
    r.error = solved.error, r.mesh = solved.mesh, r.report = solved.report;
    using std::abs;
    using std::sqrt;
    if (r.status == bvp_status::not_isolated &&
        abs(r.period) <= sqrt(std::numeric_limits<Scalar>::epsilon()) * guess.period) {
        r.status = bvp_status::equilibrium;  // every point stays where it is for no time
        r.message = "the period has gone to zero, and the orbit found is a point";
    }
    if (r.ok() && !(r.period > Scalar(0))) {
        r.status = bvp_status::newton_failed;
        r.message = "the period found is not positive; a nearer guess may lead to the orbit";
    }
    if (r.ok()) {
        r.status = detail::judge_orbit(r.y, r.error.global);
        if (!r.ok()) r.message = detail::words_of(r.status);
    }
    if (r.status == bvp_status::equilibrium && detail::closes<Vector>(given)) {
        r.status = bvp_status::newton_failed;
        r.message =
            "Newton's iteration left the guess, which closes, for an equilibrium: f may jump or have a kink "
            "on the orbit";
    }
    return r;
}

/// Another first argument, no guess of the period, or options of names that there are not.
orbit_result<Eigen::VectorXd> periodic_orbit(detail::refused_call<detail::call_of_periodic_orbit>,
                                             detail::anything, detail::anything,
                                             const detail::misnamed_options&);
orbit_result<Eigen::VectorXd> periodic_orbit(detail::refused_call<detail::call_of_periodic_orbit>,
                                             detail::anything = 0, detail::anything = 0, ...);

}  // namespace stagecraft

#ifdef STAGECRAFT_BVP_TAKEN
namespace stagecraft::detail {
STAGECRAFT_BVP_ORBIT(extern template, 5, 2)
STAGECRAFT_BVP_ORBIT(extern template, 5, 3)
}  // namespace stagecraft::detail
#endif
