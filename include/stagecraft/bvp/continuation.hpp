// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <stagecraft/bvp/solve.hpp>

namespace stagecraft {

enum class point_kind { regular, fold };

/// What continuation may be told.
template <class Scalar>
struct continuation_options {
    Scalar from{0};               ///< the parameter of the first point
    Scalar to = Scalar(1e30);     ///< the path ends where the parameter leaves [min(from, to), max(from, to)]
    Scalar rtol = Scalar(1e-10);  ///< of every point; see bvp_options
    Scalar step = Scalar(1) / 4;  ///< the first step in arclength; later ones follow from the work
    Scalar largest_step{1};
    int max_points = 60;
    int intervals = 10;
};

/// A point of a path: parameter, solution, and where on the path it lies.
template <class Vector>
struct continuation_point {
    using scalar = typename Vector::Scalar;
    Eigen::Matrix<scalar, 1, 1> p;
    solution<Vector> y;
    point_kind kind = point_kind::regular;
    bvp_status status = bvp_status::newton_failed;
    scalar arclength{0};  ///< in the space of (y(a), y(b), p)
    std::vector<scalar> mesh;
};

namespace detail {

/// The conditions of the problem, and that the point lies `step` further along the tangent.
template <class Conditions, class Vector>
struct arclength_conditions {
    using scalar = typename Vector::Scalar;
    Conditions r;
    Vector left0, right0, left_slope, right_slope;
    scalar p0, p_slope, step;
    template <class Y, class P, class R>
    requires(std::is_invocable_v<Conditions&, const Y&, const Y&, const P&, R&>) void operator()(
        const Y& left, const Y& right, const P& p, R& out) {
        r(left, right, p, out);
        const Eigen::Index n = left0.size();
        out[n] = p_slope * (p[0] - p0) - step;
        for (Eigen::Index i = 0; i < n; ++i)
            out[n] = out[n] + left_slope[i] * (left[i] - left0[i]) + right_slope[i] * (right[i] - right0[i]);
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

/// One path, point by point.
template <class Scalar, int S, class Rhs, class Conditions, class Vector>
class path_follower {
    using conditions = arclength_conditions<Conditions, Vector>;
    using extended_problem = two_point_problem<Rhs, conditions>;
    using parameters = Eigen::Matrix<Scalar, 1, 1>;
    using solver = bvp_solver<Scalar, S, extended_problem, Vector, parameters, 0>;
    using point = continuation_point<Vector>;

    struct state {
        point at;
        Vector left, right;  ///< y(a), y(b)
        Vector left_slope, right_slope;
        Scalar p_slope{0};
        int newton_steps = 0;
    };

  public:
    path_follower(const tableau<Scalar, S>& method, const two_point_problem<Rhs, Conditions>& problem,
                  Scalar a, Scalar b, const continuation_options<Scalar>& o)
        : method_(method), problem_(problem), a_(a), b_(b), o_(o), rtol_(o.rtol) {}

    template <class Guess>
    std::vector<point> run(const Guess& guess) {
        state now;
        if (!first(guess, now)) return {now.at};
        std::vector<point> path{now.at};
        if ((now.p_slope < Scalar(0)) == (o_.to > o_.from)) turn(now);
        state before = now;
        Scalar step = o_.step, last_step(0);
        while (static_cast<int>(path.size()) < o_.max_points) {
            state next;
            while (!advance(now, before, last_step, step, next)) {
                step /= 2;
                if (step < o_.step / 10000) {
                    path.push_back(next.at);  // says why
                    return path;
                }
            }
            if (now.p_slope * next.p_slope < Scalar(0))
                path.push_back(fold(now, before, last_step, step, next));
            path.push_back(next.at);
            before = std::move(now);
            now = std::move(next);
            last_step = step;
            if (now.newton_steps < 8) step = std::min(Scalar(step * Scalar(1.5)), o_.largest_step);
            const Scalar p = now.at.p[0];
            if (p < std::min(o_.from, o_.to) || p > std::max(o_.from, o_.to)) break;
        }
        return path;
    }

  private:
    static void turn(state& s) {
        s.left_slope = -s.left_slope, s.right_slope = -s.right_slope, s.p_slope = -s.p_slope;
    }

    template <class Guess>
    bool first(const Guess& guess, state& out) {
        const Vector y = guess_value(guess, a_), none = Vector::Zero(y.size());
        return solve(conditions{problem_.r, y, y, none, none, o_.from, Scalar(1), Scalar(0)}, guess, o_.from,
                     {}, out);
    }

    bool advance(const state& now, const state& before, const Scalar& last_step, const Scalar& step,
                 state& out) {
        const conditions further{problem_.r,      now.left,    now.right,   now.left_slope,
                                 now.right_slope, now.at.p[0], now.p_slope, step};
        const Scalar factor = last_step > Scalar(0) ? Scalar(step / last_step) : Scalar(0);
        const bool solved = solve(further, extrapolated<Vector>{now.at.y, before.at.y, factor},
                                  Scalar(now.at.p[0] + step * now.p_slope), now.at.mesh, out);
        out.at.arclength = now.at.arclength + step;
        if (!solved) return false;
        const Scalar along = now.left_slope.dot(out.left_slope) + now.right_slope.dot(out.right_slope) +
                             now.p_slope * out.p_slope;
        if (along < Scalar(0)) turn(out);
        return (along < Scalar(0) ? -along : along) > Scalar(1) / 2;  // else the step was too bold
    }

    template <class Guess>
    bool solve(const conditions& r, const Guess& guess, const Scalar& p, const std::vector<Scalar>& mesh,
               state& out) {
        bvp_options<Scalar> b;
        b.rtol = rtol_, b.intervals = o_.intervals, b.mesh = mesh, b.conditioning = false;
        extended_problem both{problem_.f, r};
        const int n = static_cast<int>(r.left0.size());
        solver s(method_, both, n, parameters(p), b);
        auto solved = s.run(guess, a_, b_);
        out.at.status = solved.status;
        out.at.p = solved.p;
        if (!solved.ok()) return false;
        out.at.y = std::move(solved.y);
        out.at.mesh = std::move(solved.mesh);
        out.newton_steps = solved.report.newton_steps;
        const auto slope = s.response(n);
        const auto& x = s.solution_on_mesh();
        out.left = x.y.col(0), out.right = x.y.col(x.intervals());
        out.left_slope = slope.y.col(0), out.right_slope = slope.y.col(x.intervals());
        out.p_slope = slope.p[0];
        using std::sqrt;
        const Scalar size =
            sqrt(out.left_slope.squaredNorm() + out.right_slope.squaredNorm() + out.p_slope * out.p_slope);
        out.left_slope /= size, out.right_slope /= size, out.p_slope /= size;
        return true;
    }

    /// Between two points where dp/ds changes its sign: the step at which it vanishes, by false position
    /// (Illinois), until the step no longer matters for p.
    point fold(const state& now, const state& before, const Scalar& last_step, const Scalar& step,
               const state& next) {
        using std::abs;
        const Scalar sharp = o_.rtol / 100, least = 64 * std::numeric_limits<Scalar>::epsilon();
        rtol_ = sharp > least ? sharp : least;  // p is what is asked for here
        Scalar low(0), high = step, at_low = now.p_slope, at_high = next.p_slope;
        state middle = next;
        for (int k = 0; k < 30; ++k) {
            const Scalar s = (low * at_high - high * at_low) / (at_high - at_low);
            if (!advance(now, before, last_step, s, middle)) break;
            if (abs(middle.p_slope) < Scalar(1e-8) || abs(high - low) < Scalar(1e-8) * step) break;
            if (middle.p_slope * at_high < Scalar(0)) {
                low = high, at_low = at_high;
            } else {
                at_low /= 2;
            }
            high = s, at_high = middle.p_slope;
        }
        rtol_ = o_.rtol;
        middle.at.kind = point_kind::fold;
        return middle.at;
    }

    const tableau<Scalar, S>& method_;
    two_point_problem<Rhs, Conditions> problem_;
    Scalar a_, b_;
    continuation_options<Scalar> o_;
    Scalar rtol_;
};

}  // namespace detail

/// The path of solutions of y' = f(t, y, p), r(y(a), y(b), p) = 0 with one parameter p from p[0] = o.from on, by
/// arclength in the space of (y(a), y(b), p), in which a solution is determined; the mesh is adapted at every
/// point. Points where dp/ds changes its sign are located (point_kind::fold). A point whose status is not
/// success is the last one.
template <class Scalar, int S, class Rhs, class Conditions, class Guess>
auto continuation(const tableau<Scalar, S>& method, two_point_problem<Rhs, Conditions> problem,
                  std::type_identity_t<Scalar> a, std::type_identity_t<Scalar> b, const Guess& guess,
                  const continuation_options<std::type_identity_t<Scalar>>& o = {}) {
    using vector = decltype(detail::guess_value(guess, a));
    const auto demand = [](bool good, const char* what) {
        if (!good) throw std::invalid_argument(what);
    };
    demand(o.from - o.from == Scalar(0), "continuation: from must be finite");
    demand(o.step > Scalar(0) && o.largest_step >= o.step,
           "continuation: step must be positive, largest_step no less");
    demand(o.max_points > 0, "continuation: max_points must be positive");
    bvp_options<Scalar> tolerances;
    tolerances.rtol = o.rtol, tolerances.intervals = o.intervals;
    detail::validate(tolerances, a, b);
    return detail::path_follower<Scalar, S, Rhs, Conditions, vector>(method, problem, a, b, o).run(guess);
}

}  // namespace stagecraft
