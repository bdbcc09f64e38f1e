// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <type_traits>
#include <utility>

#include <stagecraft/problem/partition.hpp>

namespace stagecraft {

/// A problem q'' = f whose state is y = (q, v): `uses_velocity<Part>` says whether f depends on v.
template <class Problem, class Part>
concept second_order_right_hand_side = requires {
    {std::bool_constant<std::remove_cv_t<Problem>::template uses_velocity<Part>>{}};
};

/// q'' = f(t, q) or f(t, q, v). Made by second_order() (nystrom.hpp).
template <class F>
class second_order_problem {
  public:
    /// Implicit methods factor matrices of half the size.
    static constexpr int second_order_components = Eigen::Dynamic;

    explicit second_order_problem(F f) : f_(std::move(f)) {}

    template <class Part>
    static constexpr bool uses_velocity = !detail::takes_one<F, typename Part::Scalar, Part>;

    /// The right-hand side (v, f) of y = (q, v).
    template <class T, class Y, class Out>
    requires(detail::takes_these<F, F, T, detail::part_of<Y>>()) void operator()(const T& t, const Y& y,
                                                                                 Out& out) const {
        using part = detail::part_of<Y>;
        constexpr bool good = detail::has_part<F, T, part>;
        static_assert(
            good,
            "second_order(f): f must be callable as f(t, q) or f(t, q, v), q and v of half the size "
            "of y0, and return a vector of that size, or write it into one more argument");
        if constexpr (good) {
            const int n = detail::half_size(y, "second_order");
            const part q = y.head(n), v = y.tail(n);
            part a(n);
            acceleration(t, q, v, a);
            out.head(n) = v;
            out.tail(n) = a;
        }
    }

    /// out := f(t, q) or f(t, q, v).
    template <class T, class Part>
    void acceleration(const T& t, const Part& q, const Part& v, Part& out) const {
        detail::call_part(f_, t, q, q, v, out, "second_order: f");
    }

  private:
    F f_;
};

}  // namespace stagecraft
