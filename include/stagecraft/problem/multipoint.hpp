// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/problem/two_point.hpp>

namespace stagecraft {

/// A condition on y(t), t inside (a, b); made by interior().
template <class Condition>
struct interior_condition {
    double t;
    Condition g;
};
/// What becomes of y at t; made by jump_at().
template <class Relation>
struct jump_relation {
    double t;
    Relation r;
};
/// A condition on an integral over [a, b]; made by integral().
template <class Functional>
struct integral_condition {
    double value;
    Functional g;
};
/// The end b is unknown; made by free_length().
struct unknown_length {};

/// The condition g(y(t)) = 0, or g(y(t), p) = 0, with y before a jump at t, if there is one. g returns a number.
template <class Condition>
interior_condition<Condition> interior(double t, Condition g) {
    return {t, std::move(g)};
}
/// Instead of y being continuous at t: relation(before, after, out), or (before, after, p, out), writes n numbers that are to
/// be zero, as conditions at the ends do.
template <class Relation>
jump_relation<Relation> jump_at(double t, Relation relation) {
    return {t, std::move(relation)};
}
/// The condition that the integral of g(t, y), or g(t, y, p), over [a, b] is `value`. g returns a number.
template <class Functional>
integral_condition<Functional> integral(Functional g, double value = 0) {
    return {value, std::move(g)};
}
/// b is unknown, and what is given for it a guess; result.y.t1() is what was found.
inline unknown_length free_length() { return {}; }

/// A boundary value problem with more conditions than those at the ends, or an unknown end; made by two_point().
template <class Rhs, class Conditions, class... More>
struct multipoint_problem {
    Rhs f;
    Conditions r;
    std::tuple<More...> more;
};

namespace detail {

/// What two_point() takes after f and r: how many conditions r writes less for it.
template <class Part>
struct multipoint_part {
    static constexpr bool is = false;
};
template <class G>
struct multipoint_part<interior_condition<G>> {
    static constexpr bool is = true, cuts = true, jumps = false, integrates = false;
    static constexpr int conditions = 1;
};
template <class G>
struct multipoint_part<jump_relation<G>> {
    static constexpr bool is = true, cuts = true, jumps = true, integrates = false;
    static constexpr int conditions = 0;
};
template <class G>
struct multipoint_part<integral_condition<G>> {
    static constexpr bool is = true, cuts = false, jumps = false, integrates = true;
    static constexpr int conditions = 1;
};
template <>
struct multipoint_part<unknown_length> {
    static constexpr bool is = true, cuts = false, jumps = false, integrates = false;
    static constexpr int conditions = -1;
};

/// A part that says that b is infinite; made by to_infinity().
template <class Part>
inline constexpr bool reaches_infinity = false;

}  // namespace detail

/// The problem of f and conditions r at the ends, as two_point(f, r), with any number of interior(), jump_at() and integral(),
/// and free_length() once:
///
///     solve_bvp(gauss<5>(), two_point(f, r, interior(0.3, g), jump_at(0.5, relation)), a, b, guess)
///
/// Every interior() and every integral() is one condition, so that r writes one number less for each; with free_length() it
/// writes one more. The pieces between the points are solved as one system on one mesh, each in its own time: m points cost
/// (m + 1)^3 times as much for an interval.
template <class Rhs, class Conditions, class... More>
requires(sizeof...(More) > 0 && (detail::multipoint_part<More>::is && ...))
    multipoint_problem<Rhs, Conditions, More...> two_point(Rhs f, Conditions r, More... more) {
    return {std::move(f), std::move(r), {std::move(more)...}};
}

namespace detail {

/// [a, b] cut into pieces, in each of which are the n components of y and one integral so far for every integral().
template <class Scalar>
struct cut_interval {
    std::vector<Scalar> ends;  ///< a, the points in order, b or its guess
    int n = 0, integrals = 0;

    int pieces() const { return static_cast<int>(ends.size()) - 1; }
    int width() const { return n + integrals; }
    Scalar length(int k) const { return ends[k + 1] - ends[k]; }
    /// t at the part s of piece k, on its side of the points, where f may jump.
    template <class T>
    T time(int k, const T& s, const T& length) const {
        using std::abs;
        const auto rounding = [&](const Scalar& at) {
            return std::max(this->length(k), Scalar(abs(at))) * 2 * std::numeric_limits<Scalar>::epsilon();
        };
        const T t = ends[k] + s * length;
        if (k > 0 && !(t > ends[k])) return T(Scalar(ends[k] + rounding(ends[k])));
        if (k + 1 < pieces() && !(t < ends[k + 1])) return T(Scalar(ends[k + 1] - rounding(ends[k + 1])));
        return t;
    }
    /// The piece that ends at t.
    int before(const Scalar& t) const {
        return static_cast<int>(std::lower_bound(ends.begin(), ends.end(), t) - ends.begin()) - 1;
    }
};

/// g(arguments..., p), or g(arguments...) where it takes no parameters.
template <class G, class P, class... Arguments>
auto value_with(G& g, const P& p, const Arguments&... arguments) {
    if constexpr (P::RowsAtCompileTime != 0 && std::is_invocable_v<G&, const Arguments&..., const P&>)
        return g(arguments..., p);
    else
        return g(arguments...);
}

/// A multipoint_problem as a two-point problem on [0, 1]: its pieces one below the other. N and P are those of the problem;
/// the parameters are p and, where the length is free, that of the last piece.
template <class Rhs, class More, class Scalar, int N, int P, bool Free>
struct stacked_rhs {
    static constexpr int unknowns = P == Eigen::Dynamic ? P : P + Free;
    Rhs f;
    More more;
    cut_interval<Scalar> cut;
    Scalar fault{0};  ///< where f was not finite

    template <class T, class Z, class Out, class U = typename Z::Scalar, class Y = Eigen::Matrix<U, N, 1>>
    requires(unknowns == 0 && callable_unconverted<Rhs, const T&, const Y&, Y&>) void operator()(const T& s,
                                                                                                 const Z& z,
                                                                                                 Out& out) {
        evaluate<Y>(
            s, z, Eigen::Matrix<U, 0, 1>(), [](int) {}, out);
    }
    template <class T, class Z, class Q, class Out, class U = typename Z::Scalar,
              class Y = Eigen::Matrix<U, N, 1>, class Own = Eigen::Matrix<U, P, 1>,
              class Time = std::conditional_t<Free, U, T>>
    requires(unknowns != 0 &&
             (P == 0 ? callable_unconverted<Rhs, const Time&, const Y&, Y&>
                     : callable_unconverted<Rhs, const Time&, const Y&, const Own&, Y&>)) void
    operator()(const T& s, const Z& z, const Q& q, Out& out) {
        const Own p = q.head(q.size() - Free);
        if constexpr (Free)
            evaluate<Y>(
                Time(s), z, p, [&](int) { return q[q.size() - 1]; }, out);
        else
            evaluate<Y>(
                s, z, p, [](int) {}, out);
    }

  private:
    template <class Y, class T, class Z, class Own, class Last, class Out>
    void evaluate(const T& s, const Z& z, const Own& p, const Last& last, Out& out) {
        using U = typename Z::Scalar;
        Y value(cut.n);
        for (int k = 0; k < cut.pieces(); ++k) {
            int at = k * cut.width();
            const Y y = z.segment(at, cut.n);
            T length(cut.length(k));
            if constexpr (Free)
                if (k + 1 == cut.pieces()) length = last(k);
            const T t = cut.time(k, s, length);
            for (int c = 0; c < cut.n; ++c) value[c] = U(std::numeric_limits<double>::quiet_NaN());
            if constexpr (P == 0)
                f(t, y, value);
            else
                f(t, y, p, value);
            if (value.size() != cut.n) throw size_change{};
            for (int c = 0; c < cut.n; ++c, ++at) {
                out[at] = value[c] * length;
                if (!(out[at] - out[at] == U(0))) fault = number(t);
            }
            std::apply([&](auto&... part) { (add_integrand(part, t, y, p, length, out, at), ...); }, more);
        }
    }
    static Scalar number(const Scalar& t) { return t; }
    template <class T>
    static Scalar number(const T& t) {
        return Scalar(t.value());
    }
    template <class Part, class T, class Y, class Own, class Out>
    void add_integrand(Part& part, const T& t, const Y& y, const Own& p, const T& length, Out& out, int& at) {
        if constexpr (multipoint_part<Part>::integrates) out[at++] = value_with(part.g, p, t, y) * length;
    }
};

/// Its conditions: those at the ends, inside and of integrals, and that the pieces fit together.
template <class Conditions, class More, class Scalar, int N, int P, int M, bool Free>
struct stacked_conditions {
    static constexpr int unknowns = P == Eigen::Dynamic ? P : P + Free;
    Conditions r;
    More more;
    cut_interval<Scalar> cut;
    int at_ends;  ///< how many numbers r writes, M where it is known

    template <class Z, class R, class U = typename Z::Scalar, class Y = Eigen::Matrix<U, N, 1>,
              class Out = Eigen::Matrix<U, M, 1>>
    requires(unknowns == 0 && writes_conditions<Conditions, Out, Y, Y>) void operator()(const Z& left,
                                                                                        const Z& right,
                                                                                        R& out) {
        write_all<Y, Out>(left, right, out, Eigen::Matrix<U, 0, 1>());
    }
    template <class Z, class Q, class R, class U = typename Z::Scalar, class Y = Eigen::Matrix<U, N, 1>,
              class Own = Eigen::Matrix<U, P, 1>, class Out = Eigen::Matrix<U, M, 1>>
    requires(unknowns != 0 && (P == 0 ? writes_conditions<Conditions, Out, Y, Y>
                                      : writes_conditions<Conditions, Out, Y, Y, Own>)) void
    operator()(const Z& left, const Z& right, const Q& q, R& out) {
        write_all<Y, Out>(left, right, out, Own(q.head(q.size() - Free)));
    }

  private:
    template <class Y, class Ends, class Z, class R, class Own>
    void write_all(const Z& left, const Z& right, R& out, const Own& p) {
        const int n = cut.n, width = cut.width(), last = (cut.pieces() - 1) * width;
        int next = 0, integral = n;
        write<Ends>(r, at_ends, out, next, p, Y(left.head(n)), Y(right.segment(last, n)));
        const auto of_part = [&](auto& part) {
            using kind = multipoint_part<std::decay_t<decltype(part)>>;
            if constexpr (kind::integrates) {
                out[next++] = left[integral];
                out[next++] = right[last + integral++] - Scalar(part.value);
            } else if constexpr (kind::conditions == 1) {
                out[next++] = value_with(part.g, p, Y(right.segment(cut.before(Scalar(part.t)) * width, n)));
            }
        };
        std::apply([&](auto&... part) { (of_part(part), ...); }, more);
        for (int k = 1; k < cut.pieces(); ++k) {
            const int before = (k - 1) * width, after = k * width, first = next;
            const auto jump = [&](auto& part) {
                if constexpr (multipoint_part<std::decay_t<decltype(part)>>::jumps)
                    if (Scalar(part.t) == cut.ends[k])
                        write<Y>(part.r, n, out, next, p, Y(right.segment(before, n)),
                                 Y(left.segment(after, n)));
            };
            std::apply([&](auto&... part) { (jump(part), ...); }, more);
            for (int c = next > first ? n : 0; c < width; ++c)
                out[next++] = left[after + c] - right[before + c];
        }
    }
    template <class Values, class F, class R, class Own, class... Arguments>
    static void write(F& f, int m, R& out, int& next, const Own& p, const Arguments&... arguments) {
        const auto count = [m] { return std::to_string(m) + " numbers"; };
        if constexpr (Own::RowsAtCompileTime != 0 && writes_conditions<F, Values, Arguments..., Own>)
            write_conditions<Values>(f, m, count, out, next, arguments..., p);
        else
            write_conditions<Values>(f, m, count, out, next, arguments...);
        next += m;
    }
};

}  // namespace detail

}  // namespace stagecraft
