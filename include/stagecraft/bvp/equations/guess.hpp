// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/options.hpp>
#include <stagecraft/owned_value.hpp>
#include <stagecraft/problem/system.hpp>

namespace stagecraft::detail {

/// The first mesh: options.mesh, or options.intervals equal intervals, `usual` where these are 0, with
/// options.fixed_points among its points.
template <class Scalar>
std::vector<Scalar> first_mesh(const bvp_options<Scalar>& o, const Scalar& a, const Scalar& b, int usual) {
    const int between = static_cast<int>(o.fixed_points.size()),
              intervals =
                  std::min(o.intervals > 0 ? o.intervals : usual, std::max(1, o.max_intervals - between));
    std::vector<Scalar> t = o.mesh;
    if (t.empty()) {
        t.reserve(static_cast<std::size_t>(intervals) + 1 + o.fixed_points.size());
        for (int i = 0; i < intervals; ++i) t.push_back(a + (b - a) * Scalar(i) / Scalar(intervals));
        t.push_back(b);
    }
    for (const Scalar& point : o.fixed_points) {
        const auto at = std::lower_bound(t.begin(), t.end(), point);
        if (*at != point) t.insert(at, point);
    }
    demand_bvp(std::adjacent_find(t.begin(), t.end(), std::greater_equal<Scalar>()) == t.end(),
               "b - a must be so large that the mesh points differ");
    demand_bvp(
        static_cast<int>(t.size()) - 1 <= o.max_intervals,
        "the intervals of mesh with fixed_points and break_points must not be more than max_intervals");
    return t;
}

/// A guess as value and slope at t: a constant vector, a function of t, or one with derivative(t).
template <class Guess>
concept constant_guess = requires {
    typename Guess::PlainObject;
};

template <class Scalar, class Guess>
auto guess_value(const Guess& guess, const Scalar& t) {
    if constexpr (constant_guess<Guess>)
        return typename Guess::PlainObject(guess);
    else
        return typename std::decay_t<decltype(guess(t))>::PlainObject(guess(t));
}
/// A guess may be this, for solvers in Scalar.
template <class Guess, class Scalar>
concept usable_guess = constant_guess<Guess> || requires(const Guess& guess, const Scalar& t) {
    typename std::decay_t<decltype(guess(t))>::PlainObject;
    { guess(t) } -> owns_numbers;
};

/// The type of y: that of guess, whatever where that cannot be one.
template <class Guess, class Scalar>
struct vector_of_guess {
    using type = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
};
template <class Guess, class Scalar>
requires usable_guess<Guess, Scalar>
struct vector_of_guess<Guess, Scalar> {
    using type = decltype(guess_value(std::declval<const Guess&>(), std::declval<const Scalar&>()));
};

/// guess is, as far as it is one, of real numbers.
template <class Guess, class Scalar>
inline constexpr bool real_guess = [] {
    if constexpr (usable_guess<Guess, Scalar>)
        return std::is_same_v<typename vector_of_guess<Guess, Scalar>::type::Scalar, Scalar> ||
               !requires(typename vector_of_guess<Guess, Scalar>::type::Scalar z) {
            z.imag();
        };
    else
        return true;
}();

/// The same, which must have n components at every t.
template <class Scalar, class Guess>
auto guess_value(const Guess& guess, const Scalar& t, Eigen::Index n) {
    auto value = guess_value(guess, t);
    if (value.size() != n)
        throw bad_problem("solve_bvp: guess must have the same number of components at every t");
    return value;
}
template <class Scalar, class Guess>
auto guess_slope(const Guess& guess, const Scalar& t, const Scalar& h, Eigen::Index n) {
    using vector = decltype(guess_value(guess, t));
    if constexpr (constant_guess<Guess>) {
        return vector(vector::Zero(n));
    } else if constexpr (requires { guess.derivative(t); }) {
        static_assert(
            owns_numbers<decltype(guess.derivative(t))>,
            "guess.derivative(t) returns an expression of Eigen's, whose operands may be gone: write "
            "its type, Eigen::Vector2d, say, or .eval()");
        return vector(guess.derivative(t));
    } else {
        const Scalar step = h / 64;
        return vector((guess_value(guess, Scalar(t + step), n) - guess_value(guess, Scalar(t - step), n)) /
                      (2 * step));
    }
}

/// A guess of whatever type, for as long as that lives.
template <class Vector>
class guess_view {
  public:
    using scalar = typename Vector::Scalar;

    template <class Guess>
    guess_view(const Guess& guess)
        : guess_(&guess),
          value_([](const void* g, const scalar& t) {
              return Vector(guess_value(*static_cast<const Guess*>(g), t));
          }),
          slope_([](const void* g, const scalar& t, const scalar& h, Eigen::Index n) {
              return Vector(guess_slope(*static_cast<const Guess*>(g), t, h, n));
          }) {}

    Vector operator()(const scalar& t) const { return value_(guess_, t); }
    /// The same, which must have n components at every t.
    Vector value(const scalar& t, Eigen::Index n) const {
        Vector y = value_(guess_, t);
        if (y.size() != n)
            throw bad_problem("solve_bvp: guess must have the same number of components at every t");
        return y;
    }
    /// That over an interval of length h around t.
    Vector slope(const scalar& t, const scalar& h, Eigen::Index n) const { return slope_(guess_, t, h, n); }

  private:
    const void* guess_;
    Vector (*value_)(const void*, const scalar&);
    Vector (*slope_)(const void*, const scalar&, const scalar&, Eigen::Index);
};

/// y of n components at the mesh points of x and its scaled slopes at the nodes c of every interval, from a guess.
template <class Vector, class Nodes, class Iterate>
void take_guess(const guess_view<Vector>& guess, int n, const Nodes& c, Iterate& x) {
    const int s = static_cast<int>(c.size());
    x.y.resize(n, x.intervals() + 1);
    x.Z.resize(n, s * x.intervals());
    for (int i = 0; i <= x.intervals(); ++i) x.y.col(i) = guess.value(x.t[i], x.y.rows());
    for (int i = 0; i < x.intervals(); ++i)
        for (int j = 0; j < s; ++j) {
            auto h = x.h(i);
            x.Z.col(i * s + j) = h * guess.slope(decltype(h)(x.t[i] + c[j] * h), h, x.y.rows());
        }
    if (!x.y.allFinite() || !x.p.allFinite()) throw bad_problem("solve_bvp: guess must be finite");
}

/// The mesh values of x as a guess, straight lines between them.
template <class Vector, class Iterate>
auto straight_between(const Iterate& x) {
    return [t = x.t, y = x.y](const typename Vector::Scalar& time) {
        const auto last = static_cast<Eigen::Index>(t.size()) - 1;
        const auto i = std::clamp(std::upper_bound(t.begin(), t.end(), time) - t.begin() - 1,
                                  std::ptrdiff_t(0), last - 1);
        const typename Vector::Scalar theta = (time - t[i]) / (t[i + 1] - t[i]);
        return Vector(y.col(i) + theta * (y.col(i + 1) - y.col(i)));
    };
}

}  // namespace stagecraft::detail
