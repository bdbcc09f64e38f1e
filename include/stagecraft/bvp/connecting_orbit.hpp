// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/multipoint.hpp>
#include <stagecraft/bvp/paths/no_conditions.hpp>
#include <stagecraft/bvp/semi_infinite.hpp>
#include <stagecraft/bvp/solve/connection_end.hpp>

namespace stagecraft {

/// An orbit that connects two equilibria, as connecting_orbit() found it.
template <class Vector, class Parameters>
struct connection_result {
    using scalar = typename Vector::Scalar;
    bvp_status status = bvp_status::newton_failed;
    std::string message;  ///< what went wrong, in words; empty for success
    Parameters p;
    Vector from, to;          ///< the equilibria at p
    solution<Vector> y;       ///< between the times at which it was cut off
    bvp_error<Vector> error;  ///< with what is cut off
    std::vector<scalar> mesh;
    bvp_report report;

    bool ok() const { return status == bvp_status::success; }
};

namespace detail {

/// f with unknowns q = (p, from, to); to is left out where it is from.
template <class Rhs, int P>
struct connection_rhs {
    Rhs f;
    int parameters;
    template <class T, class Y, class Q, class Own = Eigen::Matrix<typename Y::Scalar, P, 1>>
    requires(callable_unconverted<Rhs, const T&, const Y&, const Own&, Y&>) void operator()(const T& t,
                                                                                            const Y& y,
                                                                                            const Q& q,
                                                                                            Y& out) {
        const Own p = q.head(parameters);
        f(t, y, p, out);
    }
};

/// That no part of y - from is left at the beginning in the directions that come to it, none of y - to at the end in those
/// that leave it, and that both are equilibria.
template <class Rhs, class Scalar, int P>
struct connection_conditions {
    Rhs f;
    int parameters;
    bool same;
    Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> away_from, away_to;

    template <class Y, class Q, class R, class Own = Eigen::Matrix<typename Y::Scalar, P, 1>>
    requires(callable_unconverted<Rhs, const Scalar&, const Y&, const Own&, Y&>) void operator()(
        const Y& left, const Y& right, const Q& q, R& out) {
        const Eigen::Index n = left.size();
        const Own p = q.head(parameters);
        const Y from = q.segment(parameters, n);
        const Y to = same ? from : Y(q.segment(parameters + n, n));
        Eigen::Index k = 0;
        const auto vanish = [&](const auto& rows, const Y& y, const Y& rest) {
            using number = typename Y::Scalar;
            for (Eigen::Index i = 0; i < rows.rows(); ++i) {
                number sum(Scalar(0));
                for (Eigen::Index c = 0; c < n; ++c) sum += (y[c] - rest[c]) * rows(i, c);
                out[k++] = sum;
            }
        };
        vanish(away_from, left, from), vanish(away_to, right, to);
        Y value(n);
        f(Scalar(0), from, p, value);
        for (Eigen::Index c = 0; c < n; ++c) out[k++] = value[c];
        if (same) return;
        f(Scalar(0), to, p, value);
        for (Eigen::Index c = 0; c < n; ++c) out[k++] = value[c];
    }
};

/// As many parameters as the directions at both ends ask for.
inline void demand_count(int n, int coming, int leaving, int parameters) {
    const int needed = coming + leaving + 1 - n, more = needed - parameters;
    if (more == 0) return;
    const std::string ends = std::to_string(coming) + " direction(s) come to `from`, " +
                             std::to_string(leaving) + " leave `to`: an orbit between them has " +
                             std::to_string(coming + leaving + 1) + " conditions, with its phase, for " +
                             std::to_string(n) + " components and " + std::to_string(parameters) +
                             " parameter(s); ";
    demand_bvp(false,
               (ends + (more > 0 ? std::to_string(more) + " parameter(s) more must be unknown"
                                 : "there is a family of them: " + std::to_string(-more) +
                                       " condition(s) are missing, or parameters too many"))
                   .c_str(),
               "connecting_orbit");
}

/// Where a guess on the whole line is cut off first, and where its phase is fixed.
template <class Vector>
struct first_cut {
    using scalar = typename Vector::Scalar;
    scalar a, b, phase{0};
    Vector at, normal;

    /// It is cut where it has come to a fiftieth of its distance.
    template <class Guess>
    first_cut(const Guess& guess, const Vector& from, const Vector& to) {
        const auto end_of = [&](const Vector& rest, int direction, const char* name) {
            scalar most(0);
            for (scalar t = scalar(1) / 8; t < scalar(1e6); t *= scalar(1.2)) {
                const scalar off = (guess_value(guess, scalar(direction * t)) - rest).norm();
                most = std::max(most, off);
                if (most > scalar(0) && off <= most / 50 && t > scalar(1) / 2) return scalar(direction * t);
            }
            demand_bvp(false,
                       (std::string("guess(t) must come near `") + name + "` for large " +
                        (direction > 0 ? "t" : "-t"))
                           .c_str(),
                       "connecting_orbit");
            return scalar(0);
        };
        a = end_of(from, -1, "from"), b = end_of(to, 1, "to");
        // Where neither equilibrium has the phase that is asked for, and the guess moves.
        scalar best(0);
        for (int k = 1; k < 200; ++k) {
            const scalar t = a + (b - a) * scalar(k) / 200, h = (b - a) / 1000;
            const Vector y = guess_value(guess, t);
            const Vector slope =
                (guess_value(guess, scalar(t + h)) - guess_value(guess, scalar(t - h))) / (2 * h);
            using std::abs;
            const scalar off = std::min(abs(slope.dot(y - from)), abs(slope.dot(y - to)));
            if (off > best) best = off, phase = t, at = y, normal = slope.normalized();
        }
        demand_bvp(best > scalar(0), "guess must move from `from` to `to`", "connecting_orbit");
    }
};

/// Connecting orbits on longer and longer intervals, until what is cut off is below the tolerance.
template <class Vector, class Parameters, class End, class Solve>
class search_for_connection {
    using scalar = typename Vector::Scalar;
    using unknowns = Eigen::Matrix<scalar, Eigen::Dynamic, 1>;
    using result = bvp_result<Vector, unknowns>;

  public:
    search_for_connection(End& from, End& to, int parameters, const bvp_options<scalar>& o,
                          const Solve& solve)
        : ends_{&from, &to}, np_(parameters), o_(o), solve_(solve) {}

    /// From [a, b] on; `same`: both ends are one equilibrium.
    template <class Guess>
    result run(const Guess& guess, scalar a, scalar b, unknowns q, bool same) {
        result last;
        std::array<scalar, 2> before{};
        for (int k = 0; k < 10; ++k) {
            const auto p = Parameters(q.head(np_));
            const Eigen::Index n = ends_[0]->y.size();
            for (End* end : ends_) end->look(p);
            const auto from = [&](const scalar& t) -> Vector {
                if (k == 0) return guess_value(guess, t);
                if (t < last.y.t0()) return beyond(0, last.y(last.y.t0()), last.y.t0() - t);
                if (t > last.y.t1()) return beyond(1, last.y(last.y.t1()), t - last.y.t1());
                return last.y(t);
            };
            bvp_options<scalar> own = o_;
            own.conditioning = false;
            own.rtol = std::max(scalar(o_.rtol * 4 / 5), 4 * std::numeric_limits<scalar>::epsilon());
            own.atol = o_.atol * own.rtol / o_.rtol;
            result now = solve_(a, b, from, q, own);
            add_work(work_, now.report);
            now.report = work_;
            if (!now.ok()) return now;
            q = now.p;
            ends_[0]->y = q.segment(np_, n), ends_[1]->y = q.segment(np_ + (same ? 0 : n), n);
            const std::array<scalar, 2> cut{left_out(now, 0), left_out(now, 1)};
            if (k > 0) {
                count(now, last, cut, before);
                if (now.error.global <= o_.rtol) return now;
            }
            before = cut;
            // What drives it is quadratic near an equilibrium. Something is added always, to compare with.
            using std::log;
            const std::array<scalar, 2> more{
                log(1 + 20 * cut[0] / o_.rtol) / (2 * ends_[0]->slowest) + (b - a) / 20,
                log(1 + 20 * cut[1] / o_.rtol) / (2 * ends_[1]->slowest) + (b - a) / 20};
            last = std::move(now);
            a -= std::min(more[0], scalar(b - a)), b += std::min(more[1], scalar(b - a));
        }
        last.status = bvp_status::tolerance_not_met;
        last.message = "what is cut off does not fall below the tolerance as the interval grows";
        return last;
    }

  private:
    Vector beyond(int end, const Vector& y, const scalar& time) const {
        using std::exp;
        const End& at = *ends_[static_cast<std::size_t>(end)];
        return at.y + exp(-at.slowest * time) * (y - at.y);
    }
    /// As a part of 1 + |y|.
    scalar left_out(const result& now, int end) const {
        const scalar t0 = now.y.t0(), t1 = now.y.t1(), part = (t1 - t0) / 256;
        const End& at = *ends_[static_cast<std::size_t>(end)];
        const scalar floor = o_.atol > scalar(0) ? scalar(o_.atol / o_.rtol) : scalar(1);
        scalar most(0);
        for (int k = 0; k <= 4; ++k) {
            const Vector y = now.y(end == 0 ? scalar(t0 + k * part) : scalar(t1 - k * part));
            const Vector drive = at.driving(y, Parameters(now.p.head(np_)));
            using std::abs;
            for (Eigen::Index i = 0; i < y.size(); ++i)
                most = std::max(most,
                                scalar(abs(drive[i]) / (at.growth + 2 * at.slowest) / (floor + abs(y[i]))));
        }
        return most;
    }
    /// As in search_to_infinity: what is left of the difference to the shorter orbit, beyond the errors of both.
    void count(result& now, const result& shorter, const std::array<scalar, 2>& cut,
               const std::array<scalar, 2>& before) const {
        const scalar floor = o_.atol > scalar(0) ? scalar(o_.atol / o_.rtol) : scalar(1);
        const gap_between<result> gap(shorter, now, floor);
        const scalar direct = cut[0] + cut[1], was = before[0] + before[1];
        const scalar part = was > scalar(0) ? std::min(scalar(direct / was), scalar(0.9)) : scalar(0.9);
        const scalar kept = part / (1 - part), all = std::max(direct, scalar(kept * gap.beyond_errors()));
        now.error.global += all;
        for (Eigen::Index i = 0; i < now.error.components.size(); ++i)
            now.error.components[i] += std::max(direct, scalar(kept * gap.components[i]));
        now.error.parameters += kept * gap.parameters;
    }

    std::array<End*, 2> ends_;
    int np_;
    const bvp_options<scalar>& o_;
    const Solve& solve_;
    bvp_report work_;
};

}  // namespace detail

/// The orbit of the autonomous y' = f(y, p), called as f(t, y, p, out), that comes from the equilibrium near `from` (t to minus
/// infinity) and goes to that near `to`: a homoclinic orbit where they are the same, else a heteroclinic one, a travelling wave
/// for instance; and the values of the parameters, near the guess p, at which it exists.
///
///     connecting_orbit(gauss<5>(), f, Vector2d(1, 0), Vector2d(0, 0), guess, p, {.rtol = 1e-10})
///
/// guess is a function of t on the whole line that comes near both ends. The orbit is cut off at two times, where no part of
/// y - from is left in the directions that come to `from`, and none of y - to in those that leave `to` (projection conditions,
/// Beyn 1990; the equilibria are unknowns, Doedel-Friedman 1989). Their phase is fixed inside, by a plane across the guess.
/// The times grow until what is cut off is below the tolerance; error counts it, by what drives the directions left
/// out at the ends, and by the difference to the shorter orbit.
///
/// With s directions that come to `from` and u that leave `to` the n_p parameters must be s + u + 1 - n, one for a homoclinic
/// orbit. std::invalid_argument says where they are not, how many are missing, and where an equilibrium is not hyperbolic,
/// is not found, or the guess does not come near it. Everything else is said by the status, as by solve_bvp. Options are those of
/// solve_bvp without a mesh and times, which are not known before.
template <class Scalar, int S, class Rhs, class Vector, class Guess, class Given>
requires requires {
    typename Vector::PlainObject;
    typename Given::PlainObject;
}
auto connecting_orbit(const tableau<Scalar, S>& method, Rhs f, const Vector& from, const Vector& to,
                      const Guess& guess, const Given& p,
                      const bvp_options<std::type_identity_t<Scalar>>& o = {}) {
    using vector = typename Vector::PlainObject;
    using parameters = typename Given::PlainObject;
    using unknowns = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    constexpr int P = parameters::RowsAtCompileTime;
    constexpr bool callable = detail::writes_last<Rhs, vector, Scalar, vector, parameters>;
    static_assert(
        callable,
        "connecting_orbit(method, f, from, to, guess, p): f is called as f(t, y, p, out), y and out of "
        "the type of from and to, p of that of p");
    static_assert(
        detail::usable_guess<Guess, Scalar>,
        "connecting_orbit: guess must be a function of t on the whole line that returns a vector of "
        "Eigen's (no expression: write `-> Eigen::Vector2d` or .eval())");
    connection_result<vector, parameters> r;
    if constexpr (callable) {
        const int n = static_cast<int>(from.size()), np = static_cast<int>(p.size());
        detail::validate(o, Scalar(0), Scalar(1), "connecting_orbit");
        detail::demand_bvp(o.mesh.empty() && o.fixed_points.empty() && o.break_points.empty(),
                           "mesh, fixed_points and break_points make no sense here", "connecting_orbit");
        using alone = two_point_problem<Rhs, detail::no_conditions>;
        alone of{f, {}};
        report<Scalar> counts;
        two_point_system<alone, vector, parameters> functions(of.f, of.r, n, np, counts);
        using end = detail::connection_end<vector, parameters,
                                           two_point_functions<Scalar, vector::RowsAtCompileTime, P>>;
        end first(functions, "`from`", false), last(functions, "`to`", true);
        first.find(from, p), last.find(to, p);
        first.look(p), last.look(p);
        detail::demand_count(n, first.leaving(), last.leaving(), np);
        const bool same = (first.y - last.y).norm() <= Scalar(1e-6) * (1 + first.y.norm());
        const detail::first_cut<vector> cut(guess, first.y, last.y);
        const auto phase = [&cut](const auto& y) {
            auto sum = (y[0] - cut.at[0]) * cut.normal[0];
            for (Eigen::Index c = 1; c < cut.at.size(); ++c) sum += (y[c] - cut.at[c]) * cut.normal[c];
            return sum;
        };
        unknowns q(np + (same ? n : 2 * n));
        q.head(np) = p, q.segment(np, n) = first.y;
        if (!same) q.tail(n) = last.y;
        const auto solve = [&](const Scalar& a, const Scalar& b, const auto& near, const unknowns& begin,
                               const bvp_options<Scalar>& own) {
            return solve_bvp(
                method,
                two_point(detail::connection_rhs<Rhs, P>{f, np},
                          detail::connection_conditions<Rhs, Scalar, P>{f, np, same, first.away, last.away},
                          interior(static_cast<double>(cut.phase), phase)),
                a, b, near, begin, own);
        };
        detail::search_for_connection<vector, parameters, end, decltype(solve)> search(first, last, np, o,
                                                                                       solve);
        auto found = search.run(guess, cut.a, cut.b, q, same);
        r.status = found.status, r.message = std::move(found.message);
        r.p = found.p.head(np), r.from = first.y, r.to = last.y;
        r.y = std::move(found.y), r.mesh = std::move(found.mesh), r.report = found.report;
        r.error = std::move(found.error);
        r.error.parameters = r.error.parameters.head(np).eval();
    }
    return r;
}

}  // namespace stagecraft
