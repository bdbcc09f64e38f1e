// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/multipoint.hpp>
#include <stagecraft/bvp/options.hpp>
#include <stagecraft/bvp/result.hpp>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/bvp/solve/lengthening.hpp>
#include <stagecraft/bvp/solve/limit_state.hpp>
#include <stagecraft/problem/to_infinity.hpp>

namespace stagecraft {

namespace detail {

/// The guess on [a, T]: the one given, or the solution on a shorter interval and how it decays beyond.
template <class Guess, class Vector>
struct lengthened_guess {
    using scalar = typename Vector::Scalar;
    const Guess& given;
    const solution<Vector>* shorter = nullptr;
    Vector left{};  ///< of y - limit, at the end of the shorter one
    scalar rate{0};
    std::function<Vector(const scalar&)> limit{};

    Vector operator()(const scalar& t) const {
        using std::exp;
        if (!shorter) return guess_value(given, t);
        if (t <= shorter->t1()) return (*shorter)(t);
        return limit(t) + exp(-rate * (t - shorter->t1())) * left;
    }
};

/// One part of a problem as a tuple, to_infinity() as none.
template <class Part>
auto finite_part(const Part& part) {
    if constexpr (reaches_infinity<Part>)
        return std::tuple<>();
    else
        return std::tuple<Part>(part);
}
template <class Part>
auto infinite_part(const Part& part) {
    if constexpr (reaches_infinity<Part>)
        return std::tuple<Part>(part);
    else
        return std::tuple<>();
}

/// r writes as many numbers as it has to, as far as its values at the guess tell.
template <class Vector, class Conditions, class Parameters>
void demand_all_written(Conditions& ends, const Vector& y, const Parameters& p) {
    using scalar = typename Vector::Scalar;
    Eigen::Matrix<scalar, Eigen::Dynamic, 1> out(ends.at_a + ends.away.rows());
    if constexpr (Parameters::RowsAtCompileTime == 0)
        ends(y, y, out);
    else
        ends(y, y, typename Parameters::PlainObject(p), out);
    if (y.allFinite() && !out.head(ends.at_a).allFinite())
        throw bad_problem("solve_bvp: the conditions must write " + ends.counted()() +
                          "; at guess(a) one of them is "
                          "missing or not finite");
}

/// f and conditions with the other parts, on a finite interval.
template <class Rhs, class Conditions, class... More>
auto finite_problem(const Rhs& f, Conditions r, const std::tuple<More...>& more) {
    if constexpr (sizeof...(More) == 0)
        return two_point_problem<Rhs, Conditions>{f, std::move(r)};
    else
        return multipoint_problem<Rhs, Conditions, More...>{f, std::move(r), more};
}

/// Solutions on longer and longer intervals, until what the next one changes is below the tolerance. `solve` solves on
/// [a, end] with the conditions of `state` there.
template <class Result, class Guess, class State, class Solve>
class search_to_infinity {
    using scalar = typename Result::scalar;
    using vector = std::decay_t<decltype(std::declval<Result>().y(scalar(0)))>;
    using parameters = decltype(Result::p);

  public:
    /// `pieces`: how many the interval is cut into by conditions inside; `integrals`: some are on integrals, which lack what is
    /// beyond the end.
    search_to_infinity(State& state, const Guess& guess, const scalar& a, const bvp_options<scalar>& o,
                       int pieces, bool integrals, const Solve& solve)
        : state_(state), guess_(guess), a_(a), o_(o), pieces_(pieces), integrals_(integrals), solve_(solve) {}

    /// From the first end on; where that leads to no solution which approaches the limit, from half the length, and again, as
    /// long as that is not below `least`. `coarse` is the tolerance up to the first end.
    Result run(const parameters& p, scalar end, const scalar& least, const scalar& coarse) {
        constexpr int starts = 3;
        for (int k = 1;; ++k) {
            Result r = lengthen(p, end, coarse);
            const bool elsewhere = r.status == bvp_status::newton_failed ||
                                   r.status == bvp_status::singular ||
                                   r.status == bvp_status::tolerance_not_met;
            const scalar shorter = std::max(least, scalar(a_ + (end - a_) / 2));
            if (r.ok() || !elsewhere || k == starts || !(shorter < end)) {
                r.report = work_;
                return r;
            }
            end = shorter;
        }
    }

  private:
    struct tail {
        scalar height{0};  ///< the largest |y - limit|
        vector outside;    ///< of what drives the directions that do not decay, over the last sixteenth
    };

    Result lengthen(parameters p, scalar end, const scalar& coarse) {
        using std::log;
        bvp_options<scalar> own = o_;
        if (!own.mesh.empty() && own.mesh.back() != end) own.mesh.clear();
        Result last;
        lengthened_guess<Guess, vector> from{guess_};
        tail before;  // of the last one
        slow_approach<scalar> approach;
        for (int k = 0; k < 16 && !approach.stays(); ++k) {
            state_.look(end, p);
            set_tolerance(own, k == 0 ? coarse : scalar(0));
            own.conditioning = o_.conditioning && k > 0;
            Result now = solve_(end, from, p, own);
            add_work(work_, now.report);
            if (!now.ok()) {
                now.message += up_to(end);
                return now;
            }
            scalar digits = std::max(scalar(log(scalar(100))), scalar(-log(o_.rtol) / 2 - first_digits));
            const vector left = now.y(end) - state_.limit(end, now.p);
            scalar rate = state_.slowest;
            std::optional<gap_between<Result>> gap;
            if (k > 0) gap.emplace(last, now, o_.atol > scalar(0) ? scalar(o_.atol / o_.rtol) : scalar(1));
            const tail seen = look(now, end, gap);
            if (gap) {
                const scalar length = end - gap->end, fallen = left.norm() / from.left.norm();
                scalar part = seen.outside.norm() / before.outside.norm();
                if (integrals_ && !(part > fallen)) part = fallen;
                const scalar falling = part > scalar(0) ? scalar(-log(part) / length) : state_.slowest;
                const scalar cut =
                    count_what_is_cut_off(now, *gap, part, seen.outside, std::max(falling, scalar(0)));
                if (now.error.global <= o_.rtol) return now;
                approach.look(before.height, seen.height, gap->end - a_, end - a_);
                digits = log(20 * cut / o_.rtol + 10);
                rate = std::clamp(falling, scalar(state_.slowest / 100), state_.slowest);
            }
            before = seen;
            last = std::move(now);
            p = last.p;
            from.shorter = &last.y, from.left = left, from.rate = state_.slowest;
            from.limit = [this, p](const scalar& t) { return state_.limit(t, p); };
            end += std::clamp(scalar(digits / rate), scalar((end - a_) / 4), scalar(end - a_));
            own.mesh = lengthened_mesh(last.mesh, end, o_.max_intervals, pieces_);
        }
        last.status = bvp_status::tolerance_not_met;
        last.message = approach.in_words(state_.slowest) + up_to(last.mesh.back());
        return last;
    }
    /// A fifth of the tolerance is left for what is cut off.
    void set_tolerance(bvp_options<scalar>& own, const scalar& least) const {
        own.rtol =
            std::max({scalar(o_.rtol * 4 / 5), scalar(4 * std::numeric_limits<scalar>::epsilon()), least});
        own.atol = o_.atol * own.rtol / o_.rtol;
    }
    /// Looks at the last half of [a, end]. Waves pass zero, at the end of the shorter interval as well, where what was cut off
    /// leaves no gap then: it is looked for behind that end too.
    tail look(const Result& now, const scalar& end, std::optional<gap_between<Result>>& gap) const {
        tail seen{scalar(0), vector::Zero(now.error.components.size())};
        for (int k = 0; k <= 64; ++k) {
            const scalar t = end - (end - a_) * scalar(k) / scalar(128);
            const vector y = now.y(t);
            seen.height = std::max(seen.height, scalar((y - state_.limit(t, now.p)).norm()));
            if (k <= 8) seen.outside = seen.outside.cwiseMax(state_.driving(t, y, now.p).cwiseAbs()).eval();
            if (gap && t >= gap->end && t <= (gap->end + end) / 2)
                gap->widen(state_.undecaying(t, y, now.p), y);
        }
        return seen;
    }
    /// Adds to the error what is cut off, and returns it as a part of 1 + |y|. In the directions that do not decay the solution
    /// is, at the end, the integral of what drives them from there on, which falls at the rate `falling`. From the solution on
    /// the shorter interval this one differs by what was cut off there, and by the errors of both; `part` of the former is
    /// left. That is believed beyond those errors, or where it is less.
    scalar count_what_is_cut_off(Result& now, const gap_between<Result>& gap, const scalar& part,
                                 const vector& outside, const scalar& falling) const {
        const scalar kept = part < scalar(0.9) ? scalar(part / (1 - part)) : scalar(10);
        const vector y = now.y(now.mesh.back());
        const scalar rate = std::max(scalar(state_.growth + falling), scalar(state_.slowest / 100));
        scalar direct = integrals_ ? std::numeric_limits<scalar>::infinity() : scalar(0);
        for (Eigen::Index i = 0; i < y.size(); ++i) {
            using std::abs;
            direct = std::max(direct, scalar(outside[i] / rate / (gap.floor + abs(y[i]))));
        }
        const scalar cut = std::max(std::min(scalar(kept * gap.global), direct),
                                    scalar(kept * gap.beyond_errors())),
                     share = gap.global > scalar(0) ? scalar(cut / gap.global) : scalar(0);
        now.error.global += cut;
        now.error.components += share * gap.components;
        now.error.parameters += share * gap.parameters;
        return cut;
    }
    static std::string up_to(const scalar& end) {
        std::ostringstream text;
        text << " (the interval was cut off at " << end << ')';
        return text.str();
    }

    static constexpr double first_digits = 4.6;  // a hundredth
    State& state_;
    const Guess& guess_;
    scalar a_;
    const bvp_options<scalar>& o_;
    int pieces_;
    bool integrals_;
    const Solve& solve_;
    bvp_report work_;
};

}  // namespace detail

/// Solves a problem on [a, infinity) with y(t) - limit going to zero there; see to_infinity() in problem/to_infinity.hpp.
///
/// The interval is cut off at some T, where no part of y(T) - limit may be left in the directions that do not decay, which
/// are those of the eigenvalues of f_y(T, limit) with real parts not below zero (Lentini-Keller 1980; de Hoog-Weiss 1980;
/// Ascher-Mattheij-Russell). Each of these, k say, is one condition: r writes n + n_p - k numbers, less those
/// of interior() and integral(), and its `out` has its size at run time, its `right` is y(T). b is the first T, or infinite:
/// then it follows from the eigenvalues. T grows until the solutions on two intervals differ by less than the tolerance;
/// result.error counts, beside what it always does, what is cut off: by what drives y - limit at T in the directions that do
/// not decay, and by what is left of that difference. result.y ends at T, where y may still be off limit by more than the tolerance.
///
/// std::invalid_argument, naming to_infinity(limit), is thrown where limit does not solve the equation, where no eigenvalue has
/// a negative real part, a pair is on the imaginary axis, or rates fall like 1/t (powers of t solve the linearisation). An
/// eigenvalue zero is one of those that do not decay, be it that limits of other p lie there, or solutions that approach
/// limit like a power of t, which are not found. An r that writes another number of conditions is told how many they are.
/// Costs some three runs of solve_bvp, all but the first from near guesses.
template <class Scalar, int S, class Rhs, class Conditions, class... More, class Guess, class Parameters>
requires((detail::reaches_infinity<More> || ...) &&
         requires(const Parameters& p) {
             p.size();
         }) auto solve_bvp(const tableau<Scalar, S>& method,
                           multipoint_problem<Rhs, Conditions, More...> problem,
                           std::type_identity_t<Scalar> a, std::type_identity_t<Scalar> b, const Guess& guess,
                           const Parameters& p, const bvp_options<std::type_identity_t<Scalar>>& o = {}) {
    static_assert((detail::reaches_infinity<More> + ...) == 1, "solve_bvp: to_infinity() is given once");
    static_assert(!(std::is_same_v<More, unknown_length> || ...),
                  "solve_bvp: b is infinite with to_infinity(), free_length() makes no sense beside it");
    static_assert(!has_mass<Rhs>, "solve_bvp: to_infinity() is for y' = f(t, y), without mass()");
    static_assert(
        detail::usable_guess<Guess, Scalar>,
        "solve_bvp: guess must be a vector of Eigen's (Eigen::Vector2d(0, 1), say), a function of t "
        "that returns one (no expression: write `-> Eigen::Vector2d` or .eval()), or a solution");
    using vector = typename detail::vector_of_guess<Guess, Scalar>::type;
    using parameters = typename Parameters::PlainObject;
    constexpr int N = vector::RowsAtCompileTime, P = parameters::RowsAtCompileTime,
                  fewer = (detail::multipoint_part<More>::conditions + ...);
    auto others =
        std::apply([](auto&... part) { return std::tuple_cat(detail::finite_part(part)...); }, problem.more);
    auto infinite = std::get<0>(std::apply(
        [](auto&... part) { return std::tuple_cat(detail::infinite_part(part)...); }, problem.more));
    using limit = decltype(infinite.limit);
    static_assert(detail::limit_with<limit, Scalar, vector, parameters>,
                  "solve_bvp: to_infinity(limit): limit must be a vector of Eigen's or callable as "
                  "limit(t, out), with a guess for parameters as limit(t, p, out)");
    using conditions = detail::conditions_to_infinity<Conditions, limit, Scalar, N, P>;
    using finite = decltype(detail::finite_problem(problem.f, std::declval<conditions>(), others));
    using functions_type = two_point_system<two_point_problem<Rhs, conditions>, vector, parameters>;

    const int n = static_cast<int>(detail::guess_value(guess, a).size()), np = static_cast<int>(p.size());
    detail::demand_bvp(n > 0, "guess must have at least one component");
    detail::validate(o, a, b > a && b - b != Scalar(0) ? Scalar(a + 1) : b);
    report<Scalar> counts;
    conditions ends{problem.r, infinite.limit, b, n + np - fewer, {}};
    functions_type functions(problem.f, ends, n, np, counts);
    detail::limit_state<vector, parameters, two_point_functions<Scalar, N, P>> state(
        functions,
        [&](const Scalar& t, const parameters& q) {
            return detail::limit_at<vector>(infinite.limit, t, q, n);
        },
        a, o.rtol);
    const auto at_end = [&](const Scalar& to) {
        ends.end = to, ends.away = state.away;
        ends.at_a = n + np - fewer - static_cast<int>(state.away.rows());
        detail::demand_bvp(ends.at_a >= 0,
                           "to_infinity(limit): near limit more directions do not decay than "
                           "there are conditions to give");
    };
    Scalar end = b, coarse(0), least = a;  // conditions inside want to be inside
    const auto beyond = [&](const auto& part) {
        if constexpr (detail::multipoint_part<std::decay_t<decltype(part)>>::cuts)
            least = std::max(least, Scalar(a + (Scalar(part.t) - a) * 5 / 4));
    };
    std::apply([&](const auto&... part) { (beyond(part), ...); }, problem.more);
    for (const Scalar& t : o.fixed_points) least = std::max(least, Scalar(a + (t - a) * 5 / 4));
    if (!(b - b == Scalar(0))) {
        coarse = Scalar(1) / 10000;
        end = std::max(least, Scalar(a + state.first_length(p)));
    }
    state.look(end, p), at_end(end);
    detail::demand_all_written<vector>(ends, vector(detail::guess_value(guess, a)), p);
    const auto solve = [&](const Scalar& to, const auto& from, const parameters& q,
                           const bvp_options<Scalar>& own) {
        at_end(to);
        return solve_bvp(method, finite(detail::finite_problem(problem.f, ends, others)), a, to, from, q,
                         own);
    };
    using result = decltype(solve(end, detail::lengthened_guess<Guess, vector>{guess}, p, o));
    constexpr int pieces = 1 + (int(detail::multipoint_part<More>::cuts) + ...);
    constexpr bool integrals = (detail::multipoint_part<More>::integrates || ...);
    detail::search_to_infinity<result, Guess, decltype(state), decltype(solve)> search(
        state, guess, a, o, pieces, integrals, solve);
    return search.run(p, end, least, coarse);
}

}  // namespace stagecraft
