// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/branch_point.hpp>
#include <stagecraft/bvp/continuation_options.hpp>
#include <stagecraft/bvp/multipliers.hpp>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/bvp/traces.hpp>

namespace stagecraft::detail {

/// The conditions of a problem with one unknown too many, and that (y(a), y(b), p) lies `step` further along a
/// direction. With replaced >= 0 that condition of the problem gives way to another of this kind (branch_point.hpp).
template <class Conditions, class Scalar>
struct path_conditions {
    using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    Conditions r;
    column from, along;
    Scalar step{0};
    int replaced = -1;
    column across{};
    Scalar amount{0};

    template <class Y, class P, class R>
    requires(std::is_invocable_v<Conditions&, const Y&, const Y&, const P&, R&>) void operator()(
        const Y& left, const Y& right, const P& p, R& out) {
        r(left, right, p, out);
        auto& last = out[left.size() + p.size() - 1];
        if (last == last) throw bad_problem("continuation: the conditions must write n numbers, not more");
        last = distance(along, left, right, p) - step;
        if (replaced >= 0) out[replaced] = distance(across, left, right, p) - amount;
    }

  private:
    template <class Y, class P>
    typename Y::Scalar distance(const column& d, const Y& left, const Y& right, const P& p) const {
        const Eigen::Index n = left.size();
        typename Y::Scalar sum = left[0] * Scalar(0);
        for (Eigen::Index i = 0; i < n; ++i)
            sum = sum + d[i] * (left[i] - from[i]) + d[n + i] * (right[i] - from[n + i]);
        for (Eigen::Index i = 0; i < p.size(); ++i) sum = sum + d[2 * n + i] * (p[i] - from[2 * n + i]);
        return sum;
    }
};

/// The line through two solutions.
template <class Vector>
struct extrapolated {
    using scalar = typename Vector::Scalar;
    const solution<Vector>&now, &before;
    scalar factor;
    Vector operator()(const scalar& t) const { return now(t) + factor * (now(t) - before(t)); }
    Vector derivative(const scalar& t) const {
        return now.derivative(t) + factor * (now.derivative(t) - before.derivative(t));
    }
};

/// A point of a path as the follower sees it. x = (y(a), y(b), p).
template <class Vector, class Parameters>
struct path_state {
    using scalar = typename Vector::Scalar;
    using column = Eigen::Matrix<scalar, Eigen::Dynamic, 1>;
    bvp_status status = bvp_status::newton_failed;
    std::string message;  ///< of the last point
    point_kind kind = point_kind::regular;
    Parameters p = Parameters::Zero();
    solution<Vector> y;
    std::vector<scalar> mesh;
    scalar arclength{0};
    column x, tangent;
    solution_traces<scalar> traces;
    std::vector<floquet_multiplier<scalar>> multipliers;  ///< of periodic orbits
    int newton_steps = 0;
    /// Of branch points: a point of the crossing path close by.
    Parameters other_p = Parameters::Zero();
    solution<Vector> other_y;

    /// The slope along the path of the parameter that is followed, the last one.
    scalar slope() const { return tangent[tangent.size() - 1]; }
    void turn() {
        tangent = -tangent;
        traces.turn();
    }
};

/// One path, point by point. Conditions write n + n_p - 1 numbers; those of periodic orbits have a member follow(left,
/// p), which moves their phase condition on, and their points get multipliers.
template <class Scalar, int S, class Rhs, class Conditions, class Vector, class Parameters>
class path_follower {
  public:
    using conditions = path_conditions<Conditions, Scalar>;
    using state = path_state<Vector, Parameters>;
    using column = typename state::column;
    static constexpr bool orbits = requires(Conditions r, Vector left, Parameters p) { r.follow(left, p); };

    path_follower(const tableau<Scalar, S>& method, const two_point_problem<Rhs, Conditions>& problem,
                  Scalar a, Scalar b, const continuation_options<Scalar>& o)
        : method_(method), problem_(problem), a_(a), b_(b), o_(o), rtol_(o.rtol) {}

    template <class Guess>
    std::vector<state> run(const Guess& guess, const Parameters& p) {
        state now;
        if (!first(guess, p, now)) return {now};
        std::vector<state> path{now};
        if ((now.slope() < Scalar(0)) == (o_.to > o_.from)) now.turn();
        path.back() = now;
        state before = now;
        Scalar step = o_.step, last_step(0);
        while (static_cast<int>(path.size()) < o_.max_points) {
            state next;
            while (!advance(now, before, last_step, step, next)) {
                step /= 2;
                if (step < o_.step / 10000) {
                    if (next.message.empty()) next.message = "the path bends within the smallest step";
                    path.push_back(next);
                    return path;
                }
            }
            const leg between{now, before, next, last_step, step};
            for (state& special : special_points(between)) path.push_back(std::move(special));
            path.push_back(next);
            before = std::move(now);
            now = std::move(next);
            last_step = step;
            if constexpr (orbits) problem_.r.follow(Vector(now.x.head(size())), now.p);
            if (now.newton_steps < 8) step = std::min(Scalar(step * Scalar(1.5)), o_.largest_step);
            const Scalar q = now.p[now.p.size() - 1];
            if (o_.from < o_.to ? q > o_.to : q < o_.to) return path;
            if (o_.from < o_.to ? q < o_.from : q > o_.from) {
                path.back().message = "the path has come back to `from`";
                return path;
            }
        }
        path.back().message = "the path has max_points before it reaches `to`";
        return path;
    }

  private:
    /// Two points of the path, and the one before them.
    struct leg {
        const state &now, &before, &next;
        Scalar last_step, step;
    };

    int size() const { return n_; }

    template <class Guess>
    bool first(const Guess& guess, const Parameters& p, state& out) {
        const Vector left = guess_value(guess, a_);
        n_ = static_cast<int>(left.size());
        const int np = static_cast<int>(p.size());
        column x = column::Zero(2 * n_ + np), along = column::Zero(2 * n_ + np);
        x.tail(np) = p;
        along[2 * n_ + np - 1] = Scalar(1);
        return solve(conditions{problem_.r, x, along}, guess, p, {}, out);
    }

    bool advance(const state& now, const state& before, const Scalar& last_step, const Scalar& step,
                 state& out) {
        const conditions further{problem_.r, now.x, now.tangent, step};
        const Scalar factor = last_step > Scalar(0) ? Scalar(step / last_step) : Scalar(0);
        const Parameters p = now.p + step * now.tangent.tail(now.p.size());
        const bool solved = solve(further, extrapolated<Vector>{now.y, before.y, factor}, p, now.mesh, out);
        out.arclength = now.arclength + step;
        return solved && now.tangent.dot(out.tangent) > Scalar(1) / 2;  // else the step was too bold
    }

    template <class Guess>
    bool solve(const conditions& r, const Guess& guess, const Parameters& p, const std::vector<Scalar>& mesh,
               state& out) {
        bvp_options<Scalar> b;
        b.rtol = rtol_, b.intervals = o_.intervals, b.mesh = mesh, b.conditioning = false;
        two_point_problem<Rhs, conditions> problem{problem_.f, r};
        bvp_solver<Scalar, S, two_point_problem<Rhs, conditions>, Vector, Parameters, 0> s(method_, problem,
                                                                                           n_, p, b);
        auto solved = s.run(guess, a_, b_);
        out.status = solved.status, out.message = solved.message;
        out.p = solved.p;
        if (!solved.ok()) return false;
        out.y = std::move(solved.y);
        out.mesh = std::move(solved.mesh);
        out.newton_steps = solved.report.newton_steps;
        out.traces = solution_traces<Scalar>(s.linearised(), s.solution_on_mesh());
        out.tangent = out.traces.last().normalized();
        const auto& x = s.solution_on_mesh();
        out.x.resize(2 * n_ + p.size());
        out.x << x.y.col(0), x.y.col(x.intervals()), x.p;
        if constexpr (orbits) out.multipliers = multipliers_with_errors(s, n_, 1);
        return true;
    }

    /// What lies between two points, in the order of the path.
    std::vector<state> special_points(const leg& l) {
        using std::abs;
        std::vector<state> found;
        const auto fold = [](const state& s) { return s.slope(); };
        if (fold(l.now) * fold(l.next) < Scalar(0))
            found.push_back(locate(l, fold, Scalar(1e-8), point_kind::fold));
        const auto crossing = [&](const state& s) {
            return (l.now.traces.orientation(s.traces) < Scalar(0) ? Scalar(-1) : Scalar(1)) /
                   s.traces.largest().size;
        };
        if (crossing(l.next) < Scalar(0)) {
            state near = locate(l, crossing, crossing(l.now) / 100, point_kind::branch_point);
            // Without a saddle, and where the test has not become small, the spaces of solutions have turned by too much.
            if (cross(l, near) || abs(crossing(near)) < crossing(l.now) / 20)
                found.push_back(std::move(near));
        }
        if constexpr (orbits) {
            const auto doubling = [](const state& s) { return doubling_test(s.multipliers); };
            if (doubling(l.now) * doubling(l.next) < Scalar(0))
                found.push_back(locate(l, doubling, o_.rtol, point_kind::period_doubling));
            const auto torus = [](const state& s) { return torus_test(s.multipliers); };
            if (torus(l.now) * torus(l.next) < Scalar(0)) {
                state near = locate(l, torus, o_.rtol, point_kind::torus);
                if (on_unit_circle(near.multipliers)) found.push_back(std::move(near));
            }
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const state& a, const state& b) { return a.arclength < b.arclength; });
        return found;
    }

    /// From a point near a crossing to the crossing (branch_point.hpp). Where that fails the point stays what it is, with the
    /// status tolerance_not_met.
    bool cross(const leg& l, state& near) {
        const auto kernel = near.traces.largest();
        const int n = n_, np = static_cast<int>(near.p.size());
        conditions r{problem_.r, near.x, near.tangent};
        kernel.conditions.head(n + np - 1).cwiseAbs().maxCoeff(&r.replaced);
        r.across = (kernel.x - near.tangent.dot(kernel.x) * near.tangent).normalized();
        const int replaced = r.replaced;
        conditions whole{problem_.r, near.x, near.tangent};
        report<Scalar> ignored;
        two_point_system<Rhs, conditions, Vector, Parameters> original(problem_.f, whole, n, np, ignored);
        state on_surface;
        const auto move = [&](const auto& at) {
            r.step = at[0], r.amount = at[1];
            return solve(r, near.y, near.p, near.mesh, on_surface);
        };
        using pair = typename saddle_search<Scalar>::pair;
        const auto gradient = [&](const pair& at, pair& out) {
            if (!move(at)) return false;
            const auto& x = on_surface.x;
            original.conditions(x.head(n), x.segment(n, n), on_surface.p);
            const column row = original.conditions_jacobian().row(replaced).transpose();
            out = pair(row.dot(on_surface.traces.last()), row.dot(on_surface.traces.all().col(replaced)));
            return true;
        };
        rtol_ = sharp();
        // The error of the kernel, which is not that of the solution, shows when every interval is halved.
        saddle_search<Scalar> saddle;
        bool good = saddle.run(gradient, l.step), settled = false;
        for (int pass = 0; good && !settled && pass < 6; ++pass) {
            const auto before = saddle;
            near.mesh = halved(near.mesh);
            good = saddle.run(gradient, l.step) && move(saddle.at);
            settled = (saddle.at - before.at).norm() <= o_.rtol * (Scalar(1) + near.x.norm());
        }
        if (good) {
            state found = on_surface;
            found.kind = point_kind::branch_point;
            found.arclength = near.arclength + saddle.at[0];
            const auto& traces = found.traces;
            const column direction =
                (saddle.other[0] * traces.last() + saddle.other[1] * traces.all().col(replaced)).normalized();
            good = move(pair(saddle.at + o_.step / 2 * saddle.other));
            const state guess = on_surface;
            if (good && solve(conditions{problem_.r, found.x, direction, o_.step / 2}, guess.y, guess.p,
                              found.mesh, on_surface))
                found.other_p = on_surface.p, found.other_y = on_surface.y;
            near = std::move(found);
        }
        near.status = settled ? bvp_status::success : bvp_status::tolerance_not_met;
        rtol_ = o_.rtol;
        return settled;
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
    two_point_problem<Rhs, Conditions> problem_;
    Scalar a_, b_;
    continuation_options<Scalar> o_;
    Scalar rtol_;
    int n_ = 0;
};

}  // namespace stagecraft::detail
