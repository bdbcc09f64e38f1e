// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/options.hpp>
#include <stagecraft/bvp/result.hpp>
#include <stagecraft/bvp/solve/solve_functions.hpp>
#include <stagecraft/dense_output.hpp>
#include <stagecraft/problem/multipoint.hpp>

namespace stagecraft {

namespace detail {

/// [a, b] cut at the points of interior() and jump_at().
template <class Scalar, class More>
cut_interval<Scalar> cut_at(const More& more, const Scalar& a, const Scalar& b, int n) {
    cut_interval<Scalar> cut;
    cut.n = n;
    std::vector<Scalar> jumps;
    const auto take = [&](const auto& part) {
        using kind = multipoint_part<std::decay_t<decltype(part)>>;
        cut.integrals += kind::integrates;
        if constexpr (kind::cuts) {
            const Scalar t(part.t);
            demand_bvp(a < t && t < b, "the points of interior() and jump_at() must lie inside (a, b)");
            cut.ends.push_back(t);
            if (kind::jumps) jumps.push_back(t);
        }
    };
    std::apply([&](const auto&... part) { (take(part), ...); }, more);
    std::sort(jumps.begin(), jumps.end());
    demand_bvp(std::adjacent_find(jumps.begin(), jumps.end()) == jumps.end(),
               "there must be no more than one jump_at() for a point");
    cut.ends.push_back(a), cut.ends.push_back(b);
    std::sort(cut.ends.begin(), cut.ends.end());
    cut.ends.erase(std::unique(cut.ends.begin(), cut.ends.end()), cut.ends.end());
    return cut;
}

/// Times of [a, b] as parts of the pieces they are in; what differs by rounding alone is one.
template <class Scalar>
std::vector<Scalar> parts_of(const cut_interval<Scalar>& cut, const std::vector<Scalar>& times) {
    std::vector<Scalar> parts;
    for (const Scalar& t : times) {
        const int k = std::clamp(cut.before(t), 0, cut.pieces() - 1);
        const Scalar s = (t - cut.ends[k]) / cut.length(k);
        if (s > Scalar(0) && s < Scalar(1)) parts.push_back(s);
    }
    std::sort(parts.begin(), parts.end());
    const Scalar same = 16 * std::numeric_limits<Scalar>::epsilon();
    parts.erase(std::unique(parts.begin(), parts.end(),
                            [&](const Scalar& x, const Scalar& y) { return y - x <= same; }),
                parts.end());
    return parts;
}

/// A guess for all pieces; integrals grow evenly.
template <class Guess, class Scalar>
struct stacked_guess {
    using vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    const Guess& guess;
    const cut_interval<Scalar>& cut;
    std::vector<Scalar> integrals;

    vector operator()(const Scalar& s) const {
        vector all(cut.pieces() * cut.width());
        for (int k = 0; k < cut.pieces(); ++k) {
            const Scalar t = std::min(Scalar(cut.ends[k] + s * cut.length(k)), cut.ends[k + 1]),
                         part = (t - cut.ends.front()) / (cut.ends.back() - cut.ends.front());
            all.segment(k * cut.width(), cut.n) = guess_value(guess, t, cut.n);
            for (int j = 0; j < cut.integrals; ++j)
                all[k * cut.width() + cut.n + j] = part * integrals[static_cast<std::size_t>(j)];
        }
        return all;
    }
    vector derivative(const Scalar& s) const {
        vector all(cut.pieces() * cut.width());
        for (int k = 0; k < cut.pieces(); ++k) {
            const Scalar length = cut.length(k), whole = cut.ends.back() - cut.ends.front();
            // Away from the ends, beyond which a guess need not be there.
            const Scalar t = cut.ends[k] + std::clamp(s, Scalar(1) / 100, Scalar(99) / 100) * length;
            all.segment(k * cut.width(), cut.n) = length * guess_slope(guess, t, length / 10, cut.n);
            for (int j = 0; j < cut.integrals; ++j)
                all[k * cut.width() + cut.n + j] = length / whole * integrals[static_cast<std::size_t>(j)];
        }
        return all;
    }
};

/// Writes the pieces of `all` over [0, 1] one behind the other, as polynomials of this degree.
template <class Vector, class Stacked, class Scalar>
void join_pieces(const solution<Stacked>& all, const std::vector<Scalar>& mesh, int degree,
                 const cut_interval<Scalar>& cut, solution<Vector>& out) {
    interpolation_nodes<Scalar, dynamic> at(degree);
    at.size = degree;
    for (int j = 0; j < degree; ++j) at.c[j] = Scalar(j + 1) / Scalar(degree);
    at.finish();
    const auto y = [&](int k, const Scalar& s) { return Vector(all(s).segment(k * cut.width(), cut.n)); };
    out.start(cut.ends.front(), y(0, Scalar(0)), cut.ends.back());
    for (int k = 0; k < cut.pieces(); ++k) {
        const auto time = [&](const Scalar& s) {
            return s == Scalar(1) ? cut.ends[k + 1] : Scalar(cut.ends[k] + s * cut.length(k));
        };
        for (std::size_t i = 0; i + 1 < mesh.size(); ++i) {
            const Scalar s = mesh[i], h = mesh[i + 1] - s;
            const Vector begin = y(k, s);
            Scalar* numbers = out.add(time(s), h * cut.length(k), time(mesh[i + 1]), at);
            std::copy_n(begin.data(), cut.n, numbers);
            for (int j = 0; j < degree; ++j) {
                numbers += cut.n;
                const Scalar next = j + 1 < degree ? Scalar(s + at.c[j] * h) : mesh[i + 1];
                const Vector change = y(k, next) - begin;
                std::copy_n(change.data(), cut.n, numbers);
            }
        }
        if (k + 1 < cut.pieces()) out.changed(cut.ends[k + 1], y(k + 1, Scalar(0)));
    }
}

/// The result for the whole from that for its pieces.
template <class Vector, class Parameters, class Stacked, class StackedParameters, class Scalar>
bvp_result<Vector, Parameters> joined(bvp_result<Stacked, StackedParameters>& of, cut_interval<Scalar> cut,
                                      int degree, bool free) {
    bvp_result<Vector, Parameters> r;
    r.status = of.status, r.message = std::move(of.message), r.kernel = of.kernel;
    r.conditioning = of.conditioning, r.report = of.report, r.exception = of.exception;
    const Eigen::Index np = of.p.size() - free;
    r.p = of.p.head(np);
    if (free) cut.ends.back() = cut.ends[cut.ends.size() - 2] + of.p[np];
    const bool forwards = cut.ends.back() > cut.ends[cut.ends.size() - 2];
    if (!forwards && r.ok()) {
        r.status = bvp_status::newton_failed;
        r.message = "the length found is not positive; a nearer guess for b may lead to another one";
    }
    r.error.global = of.error.global, r.error.defect = of.error.defect;
    r.error.parameters = of.error.parameters.head(np);
    r.error.components = of.error.components.head(cut.n);
    for (int k = 0; k < cut.pieces(); ++k) {
        r.error.components =
            r.error.components.cwiseMax(of.error.components.segment(k * cut.width(), cut.n)).eval();
        for (std::size_t i = k > 0; i < of.mesh.size(); ++i)
            r.mesh.push_back(i + 1 == of.mesh.size() ? cut.ends[k + 1]
                                                     : Scalar(cut.ends[k] + of.mesh[i] * cut.length(k)));
    }
    r.report.intervals = static_cast<int>(r.mesh.size()) - 1;
    if (of.y.steps() > 0 && forwards) join_pieces(of.y, of.mesh, degree, cut, r.y);
    return r;
}

}  // namespace detail

/// Solves a problem with conditions inside [a, b], jumps, conditions on integrals, or an unknown end b; see two_point() in
/// problem/multipoint.hpp. Everything else is as for solve_bvp of a two-point problem (Ascher-Mattheij-Russell, section 1.1,
/// reduce one to the other in this way). result.y is continuous from the right at a jump, y.before(t) from the left; indices
/// of conditions in messages count those of r first; counts of f are those of all pieces together.
template <class Scalar, int S, class Rhs, class Conditions, class... More, class Guess, class Parameters>
requires(!(detail::reaches_infinity<More> || ...) &&
         requires(const Parameters& p) {
             p.size();
         }) auto solve_bvp(const tableau<Scalar, S>& method,
                           multipoint_problem<Rhs, Conditions, More...> problem,
                           std::type_identity_t<Scalar> a, std::type_identity_t<Scalar> b, const Guess& guess,
                           const Parameters& p, const bvp_options<std::type_identity_t<Scalar>>& o = {}) {
    static_assert(
        detail::usable_guess<Guess, Scalar>,
        "solve_bvp: guess must be a vector of Eigen's (Eigen::Vector2d(0, 1), say), a function of t "
        "that returns one (no expression: write `-> Eigen::Vector2d` or .eval()), or a solution");
    using vector = typename detail::vector_of_guess<Guess, Scalar>::type;
    using parameters = typename Parameters::PlainObject;
    using more = std::tuple<More...>;
    constexpr int N = vector::RowsAtCompileTime, P = parameters::RowsAtCompileTime,
                  fewer = (detail::multipoint_part<More>::conditions + ...),
                  frees = (std::is_same_v<More, unknown_length> + ...),
                  M = N == Eigen::Dynamic || P == Eigen::Dynamic ? Eigen::Dynamic : N + P - fewer;
    constexpr bool free = frees > 0;
    static_assert(frees <= 1, "solve_bvp: free_length() is given once");
    static_assert(M == Eigen::Dynamic || M >= 0,
                  "solve_bvp: there are more interior() and integral() conditions than unknowns");
    using rhs = detail::stacked_rhs<Rhs, more, Scalar, N, P, free>;
    using conditions = detail::stacked_conditions<Conditions, more, Scalar, N, P, M, free>;
    using stacked = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    using unknowns = Eigen::Matrix<Scalar, rhs::unknowns, 1>;
    using check = detail::checked_two_point<rhs, conditions, stacked, unknowns>;
    static_assert(
        check::rhs,
        "solve_bvp: the first argument of two_point must be callable as f(t, y, out), with a guess "
        "for parameters as f(t, y, p, out), and write n numbers; with free_length() t is like y[0]");
    static_assert(check::conditions,
                  "solve_bvp: the second argument of two_point must be callable as r(left, right, out), with "
                  "a guess for parameters as r(left, right, p, out), where out has one number less for every "
                  "interior() and integral(), one more for free_length()");
    using result = bvp_result<vector, parameters>;
    if constexpr (check::rhs && check::conditions && frees <= 1) {
        detail::validate(o, a, b);
        const int n = static_cast<int>(detail::guess_value(guess, a).size());
        detail::demand_bvp(n > 0, "guess must have at least one component");
        const auto cut = detail::cut_at(problem.more, a, b, n);
        bvp_options<Scalar> own = o;
        detail::take_break_points(own, o.break_points, a, b);
        if constexpr (has_break_points<Rhs>)
            detail::take_break_points(own, break_times<Scalar>(problem.f.break_points()), a, b);
        own.fixed_points = detail::parts_of(cut, own.fixed_points);
        own.max_intervals = std::max(1, o.max_intervals / cut.pieces());  // every piece has them all
        own.intervals = std::min(own.intervals, own.max_intervals);
        if (!o.mesh.empty()) {
            own.mesh = detail::parts_of(cut, o.mesh);
            own.mesh.insert(own.mesh.begin(), Scalar(0)), own.mesh.push_back(Scalar(1));
        }
        std::vector<Scalar> values;
        const auto take = [&](const auto& part) {
            if constexpr (detail::multipoint_part<std::decay_t<decltype(part)>>::integrates)
                values.push_back(Scalar(part.value));
        };
        std::apply([&](const auto&... part) { (take(part), ...); }, problem.more);
        const int np = static_cast<int>(p.size()), at_ends = n + np - fewer;
        detail::demand_bvp(at_ends >= 0, "there are more interior() and integral() conditions than unknowns");
        unknowns q(np + free);
        q.head(np) = p;
        if (free) q[np] = cut.length(cut.pieces() - 1);
        two_point_problem<rhs, conditions> whole{{problem.f, problem.more, cut},
                                                 {problem.r, problem.more, cut, at_ends}};
        report<Scalar> counts;
        const int size = cut.pieces() * cut.width();
        two_point_system<two_point_problem<rhs, conditions>, stacked, unknowns> functions(
            whole.f, whole.r, size, static_cast<int>(q.size()), counts);
        const detail::stacked_guess<Guess, Scalar> begin{guess, cut, values};
        auto found = detail::solve_functions<S, stacked, unknowns>(method, functions, begin, Scalar(0),
                                                                   Scalar(1), q, own, 0);
        if (found.status == bvp_status::non_finite && found.message.find("conditions") == std::string::npos)
            found.message = detail::not_finite_at(whole.f.fault, false);
        return detail::joined<vector, parameters>(found, cut, method.stages() + 3, free);
    } else {
        return result{};
    }
}

/// The same without parameters.
template <class Scalar, int S, class Rhs, class Conditions, class... More, class Guess>
auto solve_bvp(const tableau<Scalar, S>& method, multipoint_problem<Rhs, Conditions, More...> problem,
               std::type_identity_t<Scalar> a, std::type_identity_t<Scalar> b, const Guess& guess,
               const bvp_options<std::type_identity_t<Scalar>>& o = {}) {
    return solve_bvp(method, std::move(problem), a, b, guess, Eigen::Matrix<Scalar, 0, 1>(), o);
}

}  // namespace stagecraft
