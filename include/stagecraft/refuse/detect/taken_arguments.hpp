// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <stagecraft/refuse/detect/named_member.hpp>

namespace stagecraft::detail {

struct call_operator_member {
    void operator()();
    template <class T>
    static constexpr bool visible_in = requires {
        &T::operator();
    };
};

/// What an argument of type A is converted to by a rival call.
template <class A>
struct converted_from {
    converted_from(A);
};
struct rival_called {};

/// F with one more operator(), which takes argument K by a conversion and the others as they are, and the object as it
/// is, not const. Overload resolution prefers it to an operator() const of F's that converts argument K as well; with one
/// of F's that takes this argument as it is, the call is ambiguous. So it is found out which of them F has without
/// compiling what F does (unless its operator() is not const: that one is better then, and compiled).
template <class F, std::size_t K, class Positions, class... Args>
struct rival;
template <class F, std::size_t K, std::size_t... I, class... Args>
struct rival<F, K, std::index_sequence<I...>, Args...> : F {
    using F::operator();
    rival_called operator()(std::conditional_t<I == K, converted_from<Args>, Args>...);
};

template <class F, std::size_t K, class... Args>
concept converts_argument =
    requires(rival<std::remove_const_t<F>, K, std::index_sequence_for<Args...>, Args...>& f) {
    { f(std::declval<Args>()...) } -> std::same_as<rival_called>;
};

template <class T>
concept matrix_of_eigen = requires {
    typename T::Scalar;
    {int(T::RowsAtCompileTime) + int(T::ColsAtCompileTime)};
};

/// M declares, as all of Eigen's matrices do, that it can be made of a column Vector, and cannot: it has other numbers, or
/// another size at compile time.
template <class M, class Vector>
constexpr bool unlike() {
    if constexpr (matrix_of_eigen<M>) {
        constexpr int rows = M::RowsAtCompileTime, columns = M::ColsAtCompileTime,
                      n = Vector::RowsAtCompileTime;
        const auto fits = [](int given, int wanted) { return given == wanted || given < 0 || wanted < 0; };
        using number = typename M::Scalar;
        return (std::is_arithmetic_v<number> && !std::is_same_v<number, typename Vector::Scalar>) ||
               !((fits(rows, n) && fits(columns, 1)) || (rows == 1 && fits(columns, n)));
    } else {
        return false;
    }
}
template <class Vector>
struct unlike_vector {
    template <class M>
    requires(unlike<M, Vector>()) operator M() const;
};

/// F takes its argument K by a conversion from a vector to a matrix that it does not fit. Only asked of an F that does not
/// take any type there, and would be compiled for this one.
template <class F, std::size_t K, class... Args>
constexpr bool takes_unlike() {
    return []<std::size_t... I>(std::index_sequence<I...>) {
        return requires(F & f) {
            f(std::declval<std::conditional_t<I == K, unlike_vector<std::remove_cvref_t<Args>>, Args>>()...);
        };
    }
    (std::index_sequence_for<Args...>());
}

template <class F, std::size_t K, class Argument, class... Args>
constexpr bool mistakes_argument() {
    constexpr bool known = !std::is_class_v<F> || requires { &F::operator(); };  // which types it takes
    if constexpr (!matrix_of_eigen<std::remove_cvref_t<Argument>>) {
        return false;
    } else if constexpr (known) {
        return takes_unlike<F, K, Args...>();
    } else if constexpr (has_member_named<F, call_operator_member> && !std::is_final_v<F>) {
        if constexpr (converts_argument<F, K, Args...>)
            return takes_unlike<F, K, Args...>();
        else
            return false;
    } else {
        return false;
    }
}

/// F can be called with these arguments by its declaration, but not compiled: a vector among them arrives in a parameter
/// like `const Eigen::Vector3d& y` of another size.
template <class F, class... Args>
constexpr bool mistakes_vectors() {
    return []<std::size_t... K>(std::index_sequence<K...>) {
        return (mistakes_argument<F, K, Args, Args...>() || ...);
    }
    (std::index_sequence_for<Args...>());
}

}  // namespace stagecraft::detail
