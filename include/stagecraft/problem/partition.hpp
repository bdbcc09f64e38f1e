// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include <stagecraft/jacobian/dual_number.hpp>
#include <stagecraft/jacobian/unconverted.hpp>
#include <stagecraft/owned_value.hpp>
#include <stagecraft/problem/capabilities.hpp>

namespace stagecraft {

/// A problem whose state is y = (q, p), q and p one above the other and of the same size, of which methods for
/// partitioned systems know more than its call: `separable<Part>` says whether f depends on t and p and g on t and q
/// alone (Part is the type of q and p); then q_rate(t, p, out) and p_rate(t, q, out) write them.
template <class Problem, class Part>
concept partitioned_right_hand_side = requires {
    {std::bool_constant<std::remove_cv_t<Problem>::template separable<Part>>{}};
};

namespace detail {

template <int N>
inline constexpr int half_of = N == Eigen::Dynamic ? Eigen::Dynamic : N / 2;

/// The type of q and p in a state of type Vector.
template <class Vector>
using part_of = Eigen::Matrix<typename Vector::Scalar, half_of<int(Vector::RowsAtCompileTime)>, 1>;

/// Half the size of a state (q, p); std::invalid_argument where it is odd.
template <class Vector>
int half_size(const Vector& y, const char* who) {
    constexpr int n = Vector::RowsAtCompileTime;
    static_assert(n == Eigen::Dynamic || n % 2 == 0 || is_dual<typename Vector::Scalar>,
                  "the state holds two parts of the same size, (q, p) or (q, v): y0 must have an even number "
                  "of components");
    if (y.size() % 2 != 0)
        throw bad_problem(std::string(who) + ": the state holds two parts of the same size, and y has " +
                          std::to_string(y.size()) + " components, an odd number");
    return static_cast<int>(y.size() / 2);
}

/// How a part of a right-hand side is written: of one argument besides t or of two, returned or written into the last.
enum class part_call { none, one, one_written, two, two_written };

template <class F, class T, class Part>
constexpr part_call call_of_part() {
    if constexpr (std::is_invocable_v<const F&, const T&, const Part&>) {
        return part_call::one;
    } else if constexpr (std::is_invocable_v<const F&, const T&, const Part&, Part&>) {
        using returned = std::invoke_result_t<const F&, const T&, const Part&, Part&>;
        return std::is_void_v<returned> ? part_call::one_written : part_call::two;
    } else if constexpr (std::is_invocable_v<const F&, const T&, const Part&, const Part&, Part&>) {
        return part_call::two_written;
    } else {
        return part_call::none;
    }
}

template <class F, class T, class Part>
inline constexpr bool takes_one = call_of_part<F, T, Part>() == part_call::one
                                  || call_of_part<F, T, Part>() == part_call::one_written;

/// out := what the call returns, a vector of the size of out or, for one component, a number.
template <class Value, class Part>
void keep_part(const Value& value, Part& out, const char* what) {
    if constexpr (std::is_convertible_v<Value, typename Part::Scalar>) {
        if (out.size() != 1)
            throw bad_problem(std::string(what) + " returns a number, and the state has " +
                              std::to_string(out.size()) + " components of its kind");
        out[0] = typename Part::Scalar(value);
    } else {
        constexpr bool object = owns_numbers<Value>;
        static_assert(object || is_dual<typename Part::Scalar>,  // said once
                      "a part of the right-hand side returns an expression of Eigen's, whose operands may be "
                      "gone before it is evaluated: write `-> Eigen::Vector2d` or `return (-q).eval();`");
        if (value.size() != out.size())
            throw bad_problem(std::string(what) + " returns " + std::to_string(value.size()) +
                              " numbers, and the state has " + std::to_string(out.size()) +
                              " components of its kind");
        if constexpr (object) out = value;
    }
}

/// out := f(t, own) or, where it takes both, f(t, q, p).
template <class F, class T, class Part>
void call_part(const F& f, const T& t, const Part& own, const Part& q, const Part& p, Part& out,
               const char* what) {
    constexpr part_call how = call_of_part<F, T, Part>();
    if constexpr (how == part_call::one)
        keep_part(f(t, own), out, what);
    else if constexpr (how == part_call::one_written)
        f(t, own, out);
    else if constexpr (how == part_call::two)
        keep_part(f(t, q, p), out, what);
    else
        f(t, q, p, out);
    if (out.size() != q.size()) throw size_change();
}

template <class F, class T, class Part>
inline constexpr bool has_part = call_of_part<F, T, Part>() != part_call::none;

/// The same of dual numbers, which arrive as what they are (jacobian/unconverted.hpp).
template <class F, class T, class Part>
constexpr bool takes_duals() {
    using in = const Part&;
    constexpr part_call how = call_of_part<F, T, Part>();
    if constexpr (how == part_call::one)
        return !converts_duals<const F, const T&, in>();
    else if constexpr (how == part_call::one_written)
        return !converts_duals<const F, const T&, in, Part&>();
    else if constexpr (how == part_call::two)
        return !converts_duals<const F, const T&, in, in>();
    else if constexpr (how == part_call::two_written)
        return !converts_duals<const F, const T&, in, in, Part&>();
    else
        return false;
}

/// F and G take plain numbers, or dual ones where they are asked for these.
template <class F, class G, class T, class Part>
constexpr bool takes_these() {
    if constexpr (is_dual<typename Part::Scalar>)
        return takes_duals<F, T, Part>() && takes_duals<G, T, Part>();
    else
        return true;
}

}  // namespace detail

/// q' = f, p' = g. Made by partition().
template <class F, class G>
class partition_problem {
  public:
    partition_problem(F f, G g) : f_(std::move(f)), g_(std::move(g)) {}

    template <class Part>
    static constexpr bool separable =
        detail::takes_one<F, typename Part::Scalar, Part>&& detail::takes_one<G, typename Part::Scalar, Part>;

    /// The right-hand side of y = (q, p), for methods that know nothing of its parts.
    template <class T, class Y, class Out>
    requires(detail::takes_these<F, G, T, detail::part_of<Y>>()) void operator()(const T& t, const Y& y,
                                                                                 Out& out) const {
        using part = detail::part_of<Y>;
        constexpr bool f_good = detail::has_part<F, T, part>, g_good = detail::has_part<G, T, part>;
        static_assert(
            f_good,
            "partition(f, g): f must be callable as f(t, p) or f(t, q, p), q and p of half the size "
            "of y0, and return a vector of that size, or write it into one more argument");
        static_assert(
            g_good,
            "partition(f, g): g must be callable as g(t, q) or g(t, q, p), q and p of half the size "
            "of y0, and return a vector of that size, or write it into one more argument");
        if constexpr (f_good && g_good) {
            const int n = detail::half_size(y, "partition");
            const part q = y.head(n), p = y.tail(n);
            part rate(n);
            detail::call_part(f_, t, p, q, p, rate, "partition: f");
            out.head(n) = rate;
            detail::call_part(g_, t, q, q, p, rate, "partition: g");
            out.tail(n) = rate;
        }
    }

    /// out := f(t, p) and out := g(t, q), where it is separable.
    template <class T, class Part>
    void q_rate(const T& t, const Part& p, Part& out) const {
        detail::call_part(f_, t, p, p, p, out, "partition: f");
    }
    template <class T, class Part>
    void p_rate(const T& t, const Part& q, Part& out) const {
        detail::call_part(g_, t, q, q, q, out, "partition: g");
    }

  private:
    F f_;
    G g_;
};

/// The problem q' = f, p' = g with f(t, p) or f(t, q, p), and g(t, q) or g(t, q, p), for integrate() with
/// partitioned(first, second) or any other method. The state is y = (q, p), q above p, of the same size:
/// Eigen::Vector4d(q0, q1, p0, p1). f and g take q and p as vectors of half the size (Eigen::Vector2d, or
/// `const auto&`) and return one (a number where it has one component), or write it: f(t, p, out), f(t, q, p, out).
/// Where f is f(t, p) and g is g(t, q) the system is separable, and many pairs are explicit. Generic f and g are
/// differentiated automatically where stages are implicit. bad_problem (std::invalid_argument) leaves integrate()
/// where what they return has another size. A callable f(t, q, p) that returns nothing is taken for f(t, p, out).
template <class F, class G>
partition_problem<F, G> partition(F f, G g) {
    return {std::move(f), std::move(g)};
}

/// (q, p) one above the other, the state of a partitioned problem. std::invalid_argument where their sizes differ.
template <class Q, class P>
auto stacked(const Eigen::MatrixBase<Q>& q, const Eigen::MatrixBase<P>& p) {
    constexpr int n = Q::SizeAtCompileTime, m = P::SizeAtCompileTime;
    constexpr int common = n == Eigen::Dynamic ? m : n;
    static_assert(n == m || n == Eigen::Dynamic || m == Eigen::Dynamic,
                  "stacked(q, p): q and p must have the same size");
    if (q.size() != p.size())
        throw std::invalid_argument("stacked: q has " + std::to_string(q.size()) + " components and p " +
                                    std::to_string(p.size()) + "; both must have the same number");
    Eigen::Matrix<typename Q::Scalar, common == Eigen::Dynamic ? Eigen::Dynamic : 2 * common, 1> y(2 *
                                                                                                   q.size());
    y << q, p;
    return y;
}

}  // namespace stagecraft
