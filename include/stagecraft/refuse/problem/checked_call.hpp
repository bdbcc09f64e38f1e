// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <type_traits>
#include <utility>

#include <stagecraft/jacobian/unconverted.hpp>
#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/owned_value.hpp>
#include <stagecraft/problem/capabilities.hpp>
#include <stagecraft/refuse/problem/checked_capabilities.hpp>
#include <stagecraft/refuse/problem/written_argument.hpp>

namespace stagecraft {

namespace detail {

/// A header with the solvers for matrices of this kind is included.
template <class Matrix>
concept solvable = requires {
    typename default_blocks<Matrix>::type;
};

template <class Problem, class Vector>
concept callable_right_hand_side = writes_last<Problem, Vector, typename Vector::Scalar, Vector>;

/// Problem's jacobian(t, y, J) takes J by value: what it writes is lost, and J stays zero.
template <class Problem, class Vector, class Matrix>
concept jacobian_takes_copy = requires(Problem& p, const typename Vector::Scalar& t, const Vector& y) {
    p.jacobian(t, y, std::declval<Matrix>());
}
&&(
    !requires(Problem & p, const typename Vector::Scalar& t, const Vector& y,
              passed_by_reference<Matrix>& J) { p.jacobian(t, y, J); } ||
    requires {
        requires std::is_same_v<typename last_parameter<decltype(&Problem::jacobian)>::type, Matrix>;
    });

/// Problem may be called as problem(t, y) and returns a vector of the scalar of Vector (Eigen's matrices convert
/// to those of other scalars by what they declare).
template <class Problem, class T, class Y, class Vector>
concept returns_vector = requires(Problem& p, const T& t, const Y& y) {
    { p(t, y) } -> std::convertible_to<Vector>;
    requires std::same_as < typename std::remove_cvref_t<decltype(p(t, y))>::Scalar,
    typename Vector::Scalar > ;
    requires !mistakes_vectors<Problem, const T&, const Y&>();
};

template <class Problem, class Vector>
concept returning_right_hand_side = !callable_right_hand_side<Problem, Vector> &&
                                    returns_vector<Problem, typename Vector::Scalar, Vector, Vector>;

/// What it returns has the size of Vector, as far as that is known at compile time.
template <class Problem, class Vector>
constexpr bool returns_its_size() {
    using returned = std::remove_cvref_t<decltype(std::declval<Problem&>()(
        std::declval<const typename Vector::Scalar&>(), std::declval<const Vector&>()))>;
    constexpr int its = returned::SizeAtCompileTime, wanted = Vector::SizeAtCompileTime;
    return its == wanted || its == Eigen::Dynamic || wanted == Eigen::Dynamic;
}

/// What a returning Problem returns is a vector, not an expression of one.
template <class Problem, class Vector>
concept returns_object = requires(Problem& p, const typename Vector::Scalar& t, const Vector& y) {
    { p(t, y) } -> owns_numbers;
};

/// mass() has as many rows and columns as Vector, as far as that is known at compile time.
template <class Problem, class Vector>
constexpr bool mass_of_its_size() {
    using returned = std::remove_cvref_t<decltype(std::declval<Problem&>().mass())>;
    constexpr int n = Vector::SizeAtCompileTime;
    if constexpr (requires { returned::RowsAtCompileTime, returned::ColsAtCompileTime; }) {
        constexpr int rows = returned::RowsAtCompileTime, columns = returned::ColsAtCompileTime;
        const auto fits = [=](int given) {
            return given == n || given == Eigen::Dynamic || n == Eigen::Dynamic;
        };
        return fits(rows) && fits(columns) &&
               (rows == columns || rows == Eigen::Dynamic || columns == Eigen::Dynamic);
    } else {
        return true;
    }
}

/// A right-hand side that returns f(t, y), with all it brings, as one that writes it.
template <class Problem>
struct writes_returned : Problem {
    explicit writes_returned(const Problem& p) : Problem(p) {}
    template <class T, class Y, class F>
    requires returns_vector<const Problem, T, Y, F>
    void operator()(const T& t, const Y& y, F& f) const {
        f = of_size(static_cast<const Problem&>(*this)(t, y), y.size());
    }
};
template <class Problem>
requires(!std::is_class_v<Problem> || std::is_final_v<Problem>) struct writes_returned<Problem> {
    Problem p;
    template <class T, class Y, class F>
    requires returns_vector<const Problem, T, Y, F>
    void operator()(const T& t, const Y& y, F& f) const { f = of_size(p(t, y), y.size()); }
};

}  // namespace detail

/// Looks at the call problem(t, y, f) of a Problem, const where it is given as const; integrate() says what to
/// write where it cannot be made. At most one of the first four is false.
template <class Problem, class Vector>
struct checked_call {
    template <class Matrix>
    static constexpr bool usable_in =
        !detail::has_member_named<Problem, detail::jacobian_member> ||
        (has_jacobian<Problem, Vector, Matrix> && !detail::jacobian_takes_copy<Problem, Vector, Matrix>);
    static constexpr bool column = Vector::ColsAtCompileTime == 1;
    static constexpr bool const_enough =
        !column || detail::callable_right_hand_side<Problem, Vector> ||
        !detail::callable_right_hand_side<std::remove_const_t<Problem>, Vector>;
    static constexpr bool callable =
        !column || !const_enough || detail::callable_right_hand_side<Problem, Vector>;
    static constexpr bool writes_through =
        !column || !const_enough || !callable ||
        detail::writes_into<Problem, Vector, typename Vector::Scalar, Vector>;
    static constexpr bool band_known = has_linear_solver<Problem> || !has_bandwidth<Problem> ||
                                       detail::solvable<banded_matrix<typename Vector::Scalar>>;

    static constexpr bool pattern_known = [] {
        if constexpr (has_sparsity<Problem> && !has_linear_solver<Problem>)
            return detail::solvable<std::remove_cvref_t<decltype(std::declval<Problem&>().sparsity())>>;
        else
            return true;
    }();
    static constexpr bool pattern_usable =
        !detail::has_member_named<Problem, detail::sparsity_member> || has_sparsity<Problem>;
    static constexpr bool mass_usable = [] {
        if constexpr (has_mass<Problem>)
            return detail::owns_numbers<decltype(std::declval<Problem&>().mass())> &&
                   detail::mass_of_its_size<Problem, Vector>();
        else
            return !detail::has_member_named<Problem, detail::mass_member>;
    }();
    static constexpr bool index_usable =
        !detail::has_member_named<Problem, detail::index_member> || has_owned_index<Problem>;
    static constexpr bool band_usable =
        !detail::has_member_named<Problem, detail::bandwidth_member> || has_bandwidth<Problem>;
    static constexpr bool solver_usable =
        !detail::has_member_named<Problem, detail::linear_solver_member> || has_linear_solver<Problem>;
    static constexpr bool constancy_usable =
        !detail::has_member_named<Problem, detail::constant_jacobian_member> ||
        has_constant_jacobian<Problem>;
    static constexpr bool jacobian_usable = [] {
        if constexpr (has_matrix<Problem> || !band_known || !pattern_known)
            return true;  // checked_capabilities says what is wrong with others
        else if constexpr (has_bandwidth<Problem>)
            return usable_in<banded_matrix<typename Vector::Scalar>>;
        else if constexpr (has_sparsity<Problem>)
            return usable_in<std::remove_cvref_t<decltype(std::declval<Problem&>().sparsity())>>;
        else
            return usable_in<
                Eigen::Matrix<typename Vector::Scalar, Vector::RowsAtCompileTime, Vector::RowsAtCompileTime>>;
    }();
    /// An optional member with a capital, or under the name of other programs, would be passed over; a number called Mass is
    /// something else.
    static constexpr bool lower_case = !requires(
        Problem & p, const typename Vector::Scalar& t, const Vector& y,
        Eigen::Matrix<typename Vector::Scalar, Vector::RowsAtCompileTime, Vector::RowsAtCompileTime>& J) {
        p.Jacobian(t, y, J);
    }
    &&!requires(
        Problem & p, const typename Vector::Scalar& t, const Vector& y,
        Eigen::Matrix<typename Vector::Scalar, Vector::RowsAtCompileTime, Vector::RowsAtCompileTime>& J) {
        p.jac(t, y, J);
    }
    &&!requires(Problem & p) { p.mass_matrix().rows(); }
    &&!requires(Problem & p) { p.Mass().rows(); }
    &&!requires(Problem & p) { p.Index()[0]; }
    &&!requires(Problem & p) { p.Bandwidth().lower; }
    &&!requires(Problem & p) { p.Sparsity().rows(); };
    /// It will be differentiated automatically if it is generic.
    static constexpr bool without_jacobian = !has_matrix<Problem> && !has_bandwidth<Problem> &&
                                             !has_sparsity<Problem> &&
                                             !detail::has_member_named<Problem, detail::jacobian_member>;

    static constexpr bool good = column && const_enough && callable && writes_through && band_known &&
                                 pattern_usable && pattern_known && mass_usable && jacobian_usable &&
                                 index_usable && band_usable && solver_usable && constancy_usable &&
                                 lower_case;
};

}  // namespace stagecraft
