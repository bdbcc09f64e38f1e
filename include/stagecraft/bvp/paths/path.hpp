// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/continuation_options.hpp>
#include <stagecraft/bvp/instances.hpp>
#include <stagecraft/bvp/paths/branch_point.hpp>
#include <stagecraft/bvp/paths/homoclinic_end.hpp>
#include <stagecraft/bvp/paths/hopf_point.hpp>
#include <stagecraft/bvp/paths/multipliers.hpp>
#include <stagecraft/bvp/paths/path_problem.hpp>
#include <stagecraft/bvp/paths/path_state.hpp>

namespace stagecraft::detail {

/// One path, point by point: of any problem whose solutions have these types (path_problem.hpp). Points of orbits get
/// multipliers, and their path may end in a Hopf point.
template <int S, class Vector, class Parameters>
class path_follower {
    using Scalar = typename Vector::Scalar;

  public:
    using problem_type = path_problem<Vector, Parameters>;
    using demand = path_demand<Scalar>;
    using state = path_state<Vector, Parameters>;
    using column = typename state::column;
    using guess_type = guess_view<Vector>;
    static constexpr bool orbits = problem_type::orbits;

    path_follower(const tableau<Scalar, S>& method, problem_type& problem, Scalar a, Scalar b,
                  const continuation_options<Scalar>& o)
        : method_(method), problem_(problem), a_(a), b_(b), o_(o), rtol_(o.rtol) {}

    std::vector<state> run(const guess_type& guess, const Parameters& p) {
        state now;
        if (!first(guess, p, now) || loses_multipliers(now)) return {now};
        std::vector<state> path{now};
        if (!started() && (now.slope() < Scalar(0)) == (o_.to > o_.from)) now.turn();
        path.back() = now;
        state before = now;
        Scalar step = o_.step, last_step(0);
        const Scalar least = o_.step / 10000;
        while (static_cast<int>(path.size()) < o_.max_points) {
            state next;
            std::vector<state> special;
            while (!advance(now, before, last_step, step, next) ||
                   !special_points({now, before, next, last_step, step}, step < 2 * least, special)) {
                step /= 2;
                if (step < least) {
                    if constexpr (orbits) {
                        state end;
                        if (shrinks_to_a_point({now, before, now, last_step, step}, end)) next = end;
                    }
                    if (next.status == bvp_status::success && next.kind != point_kind::hopf) {
                        next.status = bvp_status::tolerance_not_met;
                        next.message = "within the smallest step the path bends, or another one is as close";
                    }
                    path.push_back(next);
                    return path;
                }
            }
            for (state& s : special) path.push_back(std::move(s));
            if (path.back().kind == point_kind::hopf) return path;
            path.push_back(next);
            if (loses_multipliers(path.back()) || becomes_homoclinic(path.back())) return path;
            before = std::move(now);
            now = std::move(next);
            last_step = step;
            if constexpr (orbits) {
                problem_.follow(now.y, now.p);
                now.tangent = problem_.in_plane(now.tangent);
            }
            if (now.newton_steps < 8) step = std::min(Scalar(step * Scalar(1.5)), o_.largest_step);
            if (const char* end = end_of_path(o_, now.p[now.p.size() - 1])) {
                if (*end) path.back().message = end;
                return path;
            }
        }
        path.back().message = too_many_points;
        return path;
    }

  private:
    /// Two points of the path, and the one before them.
    struct leg {
        const state &now, &before, &next;
        Scalar last_step, step;
    };

    /// The first point is said by a direction in which the path goes on, not by the parameter.
    bool started() const { return problem_.start.along.size() > 0; }

    bool first(const guess_type& guess, const Parameters& p, state& out) {
        const Vector left = guess(a_);
        n_ = static_cast<int>(left.size());
        if (started()) return solve(problem_.start, guess, p, {}, out);
        const int np = static_cast<int>(p.size());
        column x = column::Zero(2 * n_ + np), along = column::Zero(2 * n_ + np);
        x.tail(np) = p;
        along[2 * n_ + np - 1] = Scalar(1);
        return solve(demand{x, along}, guess, p, {}, out);
    }

    bool advance(const state& now, const state& before, const Scalar& last_step, const Scalar& step,
                 state& out) {
        const demand further{now.x, now.tangent, step};
        const Scalar factor = last_step > Scalar(0) ? Scalar(step / last_step) : Scalar(0);
        const Parameters p = now.p + step * now.tangent.tail(now.p.size());
        const auto mesh = now.coarser(method_.stages(), rtol_, o_.intervals);
        const bool solved = solve(further, extrapolated<Vector>{now.y, before.y, factor}, p, mesh, out);
        out.arclength = now.arclength + step;
        if (!solved) return false;
        // Else the step was too long: on a circle the chord leaves both tangents by half of the angle between these.
        const column chord = (out.x - now.x).normalized();
        const Scalar turn(0.5), half_turn(0.866);
        return now.tangent.dot(out.tangent) > turn && now.tangent.dot(chord) > half_turn &&
               out.tangent.dot(chord) > half_turn;
    }

    bool solve(const demand& r, const guess_type& guess, const Parameters& p, const std::vector<Scalar>& mesh,
               state& out) {
        bvp_options<Scalar> b;
        b.rtol = rtol_, b.intervals = o_.intervals, b.mesh = mesh, b.conditioning = false;
        const auto functions = problem_.with(r, n_, static_cast<int>(p.size()));
        bvp_solver<S, Vector, Parameters> s(method_, *functions, p, b);
        auto solved = s.run(guess, a_, b_);
        out.status = solved.status, out.message = solved.message;
        out.p = solved.p;
        if (!solved.ok()) return false;
        out.y = std::move(solved.y);
        out.mesh = std::move(solved.mesh), out.error = solved.error.global;
        out.newton_steps = solved.report.newton_steps;
        out.traces = solution_traces<Scalar>(s.linearised(), s.solution_on_mesh());
        out.tangent = out.traces.last().normalized();
        const auto& x = s.solution_on_mesh();
        out.x.resize(2 * n_ + p.size());
        out.x << x.y.col(0), x.y.col(x.intervals()), x.p;
        if constexpr (orbits) out.multipliers = multipliers_with_errors(s, n_, 1);
        return true;
    }

    /// Marks a point where the multipliers are lost (judge/multiplier_judge.hpp).
    bool loses_multipliers(state& point) const {
        if constexpr (orbits) {
            if (!trivial_is_lost(point.multipliers)) return false;
            point.status = bvp_status::tolerance_not_met;
            point.message = words_of_lost(point.multipliers);
            return true;
        }
        return false;
    }
    /// Marks a point where the period grows without bound (judge/growing_period.hpp).
    bool becomes_homoclinic(state& point) {
        if constexpr (orbits) {
            const auto functions = problem_.with({}, n_, static_cast<int>(point.p.size()));
            periods_.add(passage_of<Vector>(*functions, point.y, point.p, point.mesh));
            if (!periods_.unbounded(o_.rtol)) return false;
            point.kind = point_kind::homoclinic;
            point.message = words_of_homoclinic(point.p[1]);
            return true;
        }
        return false;
    }

    /// Finds what lies between two points, in the order of the path. False where these are on different paths: a test
    /// changes its sign between them, but vanishes at no fold and no branch point. Where a crossing could not be located,
    /// nobody knows; then `last` says that smaller steps will not tell.
    bool special_points(const leg& l, bool last, std::vector<state>& found) {
        using std::abs;
        found.clear();
        if constexpr (orbits) {
            // Beyond a Hopf point orbits are half a turn ahead; or the next one is an equilibrium, of any period.
            const orbit_swing<Vector> now(l.now.y), next(l.next.y);
            if (now.with(next) < now.with(now) / 1000) {
                state end;
                if (!shrinks_to_a_point(l, end)) return false;
                found.push_back(std::move(end));
                return true;
            }
            if (!problem_.crosses(Vector(l.next.x.head(n_)), l.next.p)) return false;
            if (trivial_is_lost(l.next.multipliers)) return true;  // what changes its sign is noise
        }
        const auto fold = [](const state& s) { return s.slope(); };
        if (fold(l.now) * fold(l.next) < Scalar(0)) {
            found.push_back(locate(l, fold, Scalar(1e-8), point_kind::fold));
            if (jumps(l, fold, found.back())) return false;
        }
        const auto crossing = [&](const state& s) {
            return (l.now.traces.orientation(s.traces) < Scalar(0) ? Scalar(-1) : Scalar(1)) /
                   s.traces.largest().size;
        };
        if (crossing(l.next) < Scalar(0)) {
            state near = locate(l, crossing, crossing(l.now) / 100, point_kind::branch_point);
            if (jumps(l, crossing, near)) return false;
            const auto verdict = cross(l, near);
            if (verdict == crossing_verdict::apart || (verdict == crossing_verdict::unknown && !last))
                return false;
            found.push_back(std::move(near));
        }
        if constexpr (orbits) {
            const auto doubling = [](const state& s) { return doubling_test(s.multipliers); };
            if (doubling(l.now) * doubling(l.next) < Scalar(0) && decides_doubling(l.now.multipliers) &&
                decides_doubling(l.next.multipliers))
                found.push_back(locate(l, doubling, o_.rtol, point_kind::period_doubling));
            const auto torus = [](const state& s) { return torus_test(s.multipliers); };
            if (torus(l.now) * torus(l.next) < Scalar(0) && decides_torus(l.now.multipliers) &&
                decides_torus(l.next.multipliers)) {
                state near = locate(l, torus, o_.rtol, point_kind::torus);
                if (on_unit_circle(near.multipliers)) found.push_back(std::move(near));
            }
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const state& a, const state& b) { return a.arclength < b.arclength; });
        return true;
    }

    /// Writes the Hopf point where the orbits shrink to an equilibrium soon after `now`, if they do: with the amplitude a they
    /// have left the last two of them so that T and p are linear in a^2 as they are near such a point.
    bool shrinks_to_a_point(const leg& l, state& end) {
        using std::abs;
        const orbit_swing<Vector> now(l.now.y), before(l.before.y);
        const Scalar a2 = now.with(now), more = before.with(before);
        if (!(a2 < more)) return false;
        const Parameters expected = l.now.p - a2 / (more - a2) * (l.before.p - l.now.p);
        if (!(expected[0] > Scalar(0))) return false;
        const auto functions = problem_.with({}, n_, static_cast<int>(expected.size()));
        hopf_search<Vector, Parameters> hopf(*functions);
        if (!hopf.run(now.mean, expected[0], l.now.p[1], expected[1])) return false;
        const Parameters size(hopf.period, Scalar(1) + abs(hopf.p)), at(hopf.period, hopf.p);
        const auto far = [&](const Parameters& p) { return (p - expected).cwiseQuotient(size).norm(); };
        if (!(far(at) <= far(l.now.p) / 10 + 10 * o_.rtol)) return false;
        end = l.now;
        end.kind = point_kind::hopf;
        end.status = hopf.change <= o_.rtol * size[1] ? bvp_status::success : bvp_status::tolerance_not_met;
        end.message = "the orbits shrink to an equilibrium, a Hopf point";
        end.p = at, end.y = hopf.orbit(), end.multipliers = hopf.multipliers;
        end.x << hopf.y, hopf.y, at;
        end.arclength += (end.x - l.now.x).norm();
        return true;
    }

    /// Is `test` as large as ever where it changes its sign?
    template <class Test>
    static bool jumps(const leg& l, const Test& test, const state& where) {
        using std::abs;
        return where.status == bvp_status::success &&
               abs(test(where)) > std::max(abs(test(l.now)), abs(test(l.next))) / 50;
    }

    /// The solutions near a crossing where one condition gives way (branch_point.hpp).
    class surface {
      public:
        using pair = typename saddle_search<Scalar>::pair;
        state here;

        surface(path_follower& path, const state& near)
            : path_(path),
              near_(near),
              r_{near.x, near.tangent},
              original_(path.problem_.with(r_, path.n_, static_cast<int>(near.p.size()))) {
            const auto kernel = near.traces.largest();
            kernel.conditions.head(kernel.conditions.size() - 1).cwiseAbs().maxCoeff(&r_.replaced);
            r_.kernel = (kernel.x - near.tangent.dot(kernel.x) * near.tangent).normalized();
        }
        bool move(const pair& at) {
            r_.step = at[0], r_.amount = at[1];
            if (!path_.solve(r_, near_.y, near_.p, near_.mesh, here)) return false;
            const int n = path_.n_;
            const auto& x = here.x;
            value_ = original_->conditions(x.head(n), x.segment(n, n), here.p)[r_.replaced];
            row_ = original_->conditions_jacobian().row(r_.replaced).transpose();
            return true;
        }
        bool operator()(const pair& at, pair& gradient) {
            if (!move(at)) return false;
            gradient = pair(row_.dot(along()), row_.dot(across()));
            return true;
        }
        column along() const { return here.traces.last(); }
        column across() const { return here.traces.all().col(r_.replaced); }
        /// With a value other than 0 at the saddle the paths turn away from each other there.
        bool apart(const Scalar& uncertain) const {
            using std::abs;
            const auto size = (here.x.cwiseAbs().array() + Scalar(1)).matrix();
            return abs(value_) > path_.o_.rtol * row_.cwiseAbs().dot(size) + uncertain;
        }

      private:
        path_follower& path_;
        const state& near_;
        demand r_;
        std::unique_ptr<typename problem_type::functions> original_;
        column row_;
        Scalar value_{0};
    };

    /// crossing: two paths cross. apart: they only come close to each other.
    enum class crossing_verdict { crossing, apart, unknown };

    /// From a point near a crossing to the crossing. Where that fails the point stays what it is, with the status
    /// tolerance_not_met.
    crossing_verdict cross(const leg& l, state& near) {
        surface on(*this, near);
        rtol_ = sharp();
        // The error of the kernel, which is not that of the solution, shows when every interval is halved.
        saddle_search<Scalar> saddle;
        bool good = saddle.run(on, l.step) && on.move(saddle.at), settled = false;
        bool never = good && on.apart(saddle.change);
        for (int pass = 0; good && !never && !settled && pass < 6; ++pass) {
            const auto before = saddle;
            near.mesh = halved(near.mesh);
            good = saddle.run(on, l.step) && on.move(saddle.at);
            settled = (saddle.at - before.at).norm() <= o_.rtol * (Scalar(1) + near.x.norm());
        }
        never = never || (settled && on.apart(Scalar(0)));
        if (good && !never) {
            state found = on.here;
            found.kind = point_kind::branch_point;
            found.arclength = near.arclength + saddle.at[0];
            const column direction =
                (saddle.other[0] * on.along() + saddle.other[1] * on.across()).normalized();
            good = on.move(saddle.at + o_.step / 2 * saddle.other);
            state other;
            if (good &&
                solve(demand{found.x, direction, o_.step / 2}, on.here.y, on.here.p, found.mesh, other))
                found.other_p = other.p, found.other_y = std::move(other.y);
            near = std::move(found);
        }
        near.status = settled ? bvp_status::success : bvp_status::tolerance_not_met;
        rtol_ = o_.rtol;
        if (never) return crossing_verdict::apart;
        return settled ? crossing_verdict::crossing : crossing_verdict::unknown;
    }

    /// Between two points where `test` changes its sign: the step at which it vanishes, by false position
    /// (Illinois), to `small` or until the step no longer matters.
    template <class Test>
    state locate(const leg& l, const Test& test, const Scalar& small, point_kind kind) {
        using std::abs;
        rtol_ = sharp();
        Scalar low(0), high = l.step, at_low = test(l.now), at_high = test(l.next);
        state middle = l.next, trial;
        bool found = false;
        for (int k = 0; k < 30 && !found; ++k) {
            const Scalar s = (low * at_high - high * at_low) / (at_high - at_low);
            if (!advance(l.now, l.before, l.last_step, s, trial)) break;
            middle = trial;
            const Scalar value = test(middle);
            found = abs(value) < small || abs(high - low) < Scalar(1e-8) * l.step;
            if (value * at_high < Scalar(0)) {
                low = high, at_low = at_high;
            } else {
                at_low /= 2;
            }
            high = s, at_high = value;
        }
        rtol_ = o_.rtol;
        middle.kind = kind;
        if (!found) middle.status = bvp_status::tolerance_not_met;
        return middle;
    }

    /// Where p is what is asked for.
    Scalar sharp() const {
        return std::max(Scalar(o_.rtol / 100), Scalar(64 * std::numeric_limits<Scalar>::epsilon()));
    }

    const tableau<Scalar, S>& method_;
    problem_type& problem_;
    Scalar a_, b_;
    continuation_options<Scalar> o_;
    Scalar rtol_;
    growing_period<Scalar> periods_;
    int n_ = 0;
};

/// The path of `problem` on [a, b] from the solution near `guess` and p on.
template <int S, class Vector, class Parameters>
std::vector<path_state<Vector, Parameters>> follow_path(
    const tableau<typename Vector::Scalar, S>& method, path_problem<Vector, Parameters>& problem,
    const typename Vector::Scalar& a, const typename Vector::Scalar& b, const guess_view<Vector>& guess,
    const Parameters& p, const continuation_options<typename Vector::Scalar>& o) {
    return path_follower<S, Vector, Parameters>(method, problem, a, b, o).run(guess, p);
}

}  // namespace stagecraft::detail

#ifdef STAGECRAFT_BVP_TAKEN
namespace stagecraft::detail {
STAGECRAFT_BVP_PATHS(extern template, 2)
STAGECRAFT_BVP_PATHS(extern template, 3)
}  // namespace stagecraft::detail
#endif
