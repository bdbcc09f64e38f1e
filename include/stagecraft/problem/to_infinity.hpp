// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include <stagecraft/problem/multipoint.hpp>

namespace stagecraft {

/// b is infinite, and y approaches `limit`; made by to_infinity().
template <class Limit>
struct infinite_end {
    Limit limit;
};

/// Instead of conditions at b: y(t) - limit goes to zero, exponentially. limit is a vector of Eigen's, or a function that writes
/// a state, limit(t, out) or limit(t, p, out) with the unknown parameters p, of which some may stand for what is not known of
/// the limit. It is to solve y' = f(t, y), from some t on, to a tenth of rtol. Stands behind f and r, beside interior(),
/// jump_at() and integral():
///
///     solve_bvp(gauss<5>(), two_point(f, r, to_infinity(Eigen::Vector2d(1, 0))), 0, INFINITY, guess)
///
/// solve_bvp in bvp/semi_infinite.hpp says how many conditions r writes then.
template <class Limit>
auto to_infinity(Limit limit) {
    if constexpr (requires { typename Limit::PlainObject; })
        return infinite_end<typename Limit::PlainObject>{std::move(limit)};
    else
        return infinite_end<Limit>{std::move(limit)};
}

namespace detail {

template <class Limit>
inline constexpr bool reaches_infinity<infinite_end<Limit>> = true;

template <class Limit>
struct multipoint_part<infinite_end<Limit>> {
    static constexpr bool is = true, cuts = false, jumps = false, integrates = false;
    static constexpr int conditions = 0;
};

template <class Limit>
concept constant_limit = requires {
    typename Limit::PlainObject;
};

/// limit can be asked at t with the parameters P for a state Y.
template <class Limit, class Scalar, class Y, class P>
concept limit_with = constant_limit<Limit> || writes_last<Limit, Y, Scalar> ||
    (writes_last<Limit, Y, Scalar, P>&& callable_unconverted<Limit, const Scalar&, const P&, Y&>);

/// The limit at t, n components.
template <class Y, class Limit, class Scalar, class P>
Y limit_at(Limit& limit, const Scalar& t, const P& p, int n) {
    using number = typename Y::Scalar;
    Y value(n);
    if constexpr (constant_limit<Limit>) {
        if (limit.size() != n)
            throw bad_problem("solve_bvp: to_infinity(limit): limit must have n components");
        value = limit.template cast<number>();
    } else {
        for (int c = 0; c < n; ++c) value[c] = number(std::numeric_limits<double>::quiet_NaN());
        if constexpr (writes_last<Limit, Y, Scalar>)
            limit(t, value);
        else
            limit(t, p, value);
        if (value.size() != n) throw size_change{};
    }
    return value;
}

/// Conditions r at a, `at_a` numbers, and at the end T that no part of y(T) - limit is left along what does not decay.
template <class Conditions, class Limit, class Scalar, int N, int P>
struct conditions_to_infinity {
    Conditions r;
    Limit limit;
    Scalar end;
    int at_a;
    Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>
        away;  ///< its rows vanish on the directions that decay, and on no others

    template <class Y, class Out, class U = typename Y::Scalar,
              class Own = Eigen::Matrix<U, Eigen::Dynamic, 1>>
    requires(P == 0 && writes_conditions<Conditions, Own, Y, Y>) void operator()(const Y& left,
                                                                                 const Y& right, Out& out) {
        write_conditions<Own>(r, at_a, counted(), out, 0, left, right);
        write_away(right, Eigen::Matrix<U, 0, 1>(), out);
    }
    template <class Y, class Q, class Out, class U = typename Y::Scalar,
              class Own = Eigen::Matrix<U, Eigen::Dynamic, 1>>
    requires(P != 0 && limit_with<Limit, Scalar, Y, Q> && writes_conditions<Conditions, Own, Y, Y, Q>) void
    operator()(const Y& left, const Y& right, const Q& p, Out& out) {
        write_conditions<Own>(r, at_a, counted(), out, 0, left, right, p);
        write_away(right, p, out);
    }
    /// In words, how many r has to write.
    auto counted() const {
        return [this] {
            return std::to_string(at_a) + " number(s) with to_infinity(limit), near which " +
                   std::to_string(away.rows()) + " direction(s) do not decay exponentially";
        };
    }

  private:
    template <class Y, class Q, class Out>
    void write_away(const Y& right, const Q& p, Out& out) {
        using number = typename Y::Scalar;
        const Y off = right - limit_at<Y>(limit, end, p, static_cast<int>(right.size()));
        for (Eigen::Index i = 0; i < away.rows(); ++i) {
            number sum = off[0] * number(away(i, 0));
            for (Eigen::Index c = 1; c < off.size(); ++c) sum += off[c] * number(away(i, c));
            out[at_a + i] = sum;
        }
    }
};

}  // namespace detail

}  // namespace stagecraft
