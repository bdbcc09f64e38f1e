// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/jacobian/reverse_functions.hpp>
#include <stagecraft/jacobian/unconverted.hpp>
#include <stagecraft/owned_value.hpp>

namespace stagecraft {

/// What adjoint_gradient() differentiates: a functional of the solution, one of three kinds. All functions are called with
/// reverse_numbers, must be generic (`const auto& y`) and return a number.

/// g(y(t1)), or g(y(t1), p) where g takes two arguments. A bare g means this.
template <class G>
struct end_value {
    G g;
};
/// sum_j g(j, y(t_j)), or g(j, y(t_j), p): misfits to data, say. A step ends at every t_j.
template <class G, class Scalar = double>
struct data_sum {
    std::vector<Scalar> times;  ///< in the order of the run, between t0 and t1
    G g;
};
/// The integral of g(t, y(t), p) from t0 to t1, by the quadrature that is the method, b and c.
template <class G>
struct time_integral {
    G g;
};

template <class G>
end_value<G> at_end(G g) {
    return {std::move(g)};
}
template <class Scalar, class G>
data_sum<G, Scalar> sum_over(std::vector<Scalar> times, G g) {
    return {std::move(times), std::move(g)};
}
template <class G>
time_integral<G> integral_of(G g) {
    return {std::move(g)};
}

namespace detail {

template <class T>
inline constexpr bool is_data_sum = false;
template <class G, class Scalar>
inline constexpr bool is_data_sum<data_sum<G, Scalar>> = true;
template <class T>
inline constexpr bool is_integral = false;
template <class G>
inline constexpr bool is_integral<time_integral<G>> = true;
template <class T>
inline constexpr bool is_end_value = false;
template <class G>
inline constexpr bool is_end_value<end_value<G>> = true;

template <class T>
inline constexpr bool is_tuple = false;
template <class... T>
inline constexpr bool is_tuple<std::tuple<T...>> = true;

/// A functional as one of the three kinds.
template <class G>
auto as_functional(const G& g) {
    if constexpr (is_data_sum<G> || is_integral<G> || is_end_value<G>)
        return g;
    else
        return at_end(g);
}

/// The value of g(y, p) and its derivatives, which are added to `by_y` and `by_p` times `factor`.
template <class Vector, class Parameters>
class recorded_function {
    using scalar = typename Vector::Scalar;
    using number = reverse_number<scalar>;

  public:
    template <class G>
    scalar operator()(const G& g, const Vector& y, const Parameters& p, const scalar& factor, Vector& by_y,
                      Parameters& by_p) {
        const int n = static_cast<int>(y.size()), m = static_cast<int>(p.size());
        operations_.start(n + m);
        Eigen::Matrix<number, Vector::RowsAtCompileTime, 1> at(n);
        Eigen::Matrix<number, Parameters::RowsAtCompileTime, 1> q(m);
        for (int j = 0; j < n; ++j) at[j] = number(y[j], &operations_, j);
        for (int k = 0; k < m; ++k) q[k] = number(p[k], &operations_, n + k);
        const number value = g(std::as_const(at), std::as_const(q));
        operations_.clear_adjoints();
        operations_.seed(value.number(), factor);
        operations_.sweep();
        for (int j = 0; j < n; ++j) by_y[j] += operations_.adjoint(j);
        for (int k = 0; k < m; ++k) by_p[k] += operations_.adjoint(n + k);
        return value.value();
    }

  private:
    tape<scalar> operations_;
};

/// g of arguments and, where it takes them, of the parameters as well.
template <class G, class Q, class... Args>
auto with_parameters(const G& g, const Q& q, const Args&... args) {
    if constexpr (std::is_invocable_v<const G&, const Args&..., const Q&>)
        return g(args..., q);
    else
        return g(args...);
}

/// G takes these as they are and returns a number: no product of Eigen's, which converts to one but refers to its operands.
template <class G, class... Args>
concept gives_number = callable_unconverted<G, Args...> && owned_number<std::invoke_result_t<G, Args...>>;

/// A functional can be differentiated.
template <class Functional, class Vector, class Parameters>
constexpr bool differentiable_functional() {
    using scalar = typename Vector::Scalar;
    using number = reverse_number<scalar>;
    using state = Eigen::Matrix<number, Vector::RowsAtCompileTime, 1>;
    using values = Eigen::Matrix<number, Parameters::RowsAtCompileTime, 1>;
    using G = decltype(std::declval<const Functional&>().g);
    if constexpr (is_integral<Functional>)
        return gives_number<const G, const scalar&, const state&, const values&> ||
               gives_number<const G, const scalar&, const state&>;
    else if constexpr (is_data_sum<Functional>)
        return gives_number<const G, const std::size_t&, const state&> ||
               gives_number<const G, const std::size_t&, const state&, const values&>;
    else if constexpr (gives_number<const G, const state&>)
        return std::is_convertible_v<std::invoke_result_t<const G&, const state&>, number>;
    else
        return gives_number<const G, const state&, const values&>;
}

/// A functional, or every one of a tuple, can be differentiated.
template <class Functional, class Vector, class Parameters>
constexpr bool differentiable_functionals() {
    if constexpr (is_tuple<Functional>)
        return []<class... G>(const std::tuple<G...>*) {
            return (differentiable_functional<decltype(as_functional(std::declval<const G&>())), Vector,
                                              Parameters>() &&
                    ...);
        }(static_cast<const Functional*>(nullptr));
    else
        return differentiable_functional<decltype(as_functional(std::declval<const Functional&>())), Vector,
                                         Parameters>();
}

}  // namespace detail

}  // namespace stagecraft
