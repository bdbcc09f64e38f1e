// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include <stagecraft/owned_value.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>

namespace stagecraft {

namespace detail {

template <class Rhs, class Mass>
struct rhs_with_mass : Rhs {
    Mass m;
    rhs_with_mass(Rhs r, Mass mass) : Rhs(std::move(r)), m(std::move(mass)) {}
    using Rhs::operator();
    const Mass& mass() const { return m; }
};

template <class Rhs, class Jacobian>
struct rhs_with_jacobian : Rhs {
    Jacobian j;
    rhs_with_jacobian(Rhs r, Jacobian jacobian) : Rhs(std::move(r)), j(std::move(jacobian)) {}
    using Rhs::operator();
    template <class T, class Y, class J>
    requires std::invocable<const Jacobian&, const T&, const Y&, J&>
    void jacobian(const T& t, const Y& y, J& out) const { j(t, y, out); }
};

template <class Rhs, class Index>
struct rhs_with_index : Rhs {
    Index flags;
    rhs_with_index(Rhs r, Index index) : Rhs(std::move(r)), flags(std::move(index)) {}
    using Rhs::operator();
    const Index& index() const { return flags; }
};

template <class Solver, class Problem>
struct problem_with_solver : Problem {
    using linear_solver = Solver;
    explicit problem_with_solver(Problem p) : Problem(std::move(p)) {}
    using Problem::operator();
};

}  // namespace detail

/// A right-hand side, for instance a lambda, together with a constant mass matrix: M y' = f(t, y). Can be
/// combined with the others: with_index(with_mass(f, M), flags). An expression, v.asDiagonal(), is evaluated here.
template <class Rhs, class Mass>
auto with_mass(Rhs rhs, Mass mass) {
    using object = decltype(detail::object_of(std::move(mass)));
    return detail::rhs_with_mass<Rhs, object>(std::move(rhs), detail::object_of(std::move(mass)));
}

/// A right-hand side together with its Jacobian, a callable j(t, y, J).
template <class Rhs, class Jacobian>
auto with_jacobian(Rhs rhs, Jacobian jacobian) {
    return detail::rhs_with_jacobian<Rhs, Jacobian>(std::move(rhs), std::move(jacobian));
}

/// A right-hand side together with the index (1, 2 or 3) of every component, e.g. a std::array<int, n>.
template <class Rhs, class Index>
auto with_index(Rhs rhs, Index index) {
    using object = decltype(detail::object_of(std::move(index)));
    return detail::rhs_with_index<Rhs, object>(std::move(rhs), detail::object_of(std::move(index)));
}

/// A problem with all its members whose linear systems are solved by `Solver`, for instance
/// with_linear_solver<klu_blocks>(problem). problem/capabilities.hpp says what a Solver is.
template <class Solver, class Problem>
auto with_linear_solver(Problem problem) {
    return detail::problem_with_solver<Solver, Problem>(std::move(problem));
}

/// A template in place of a Solver.
template <template <class...> class Solver, class Problem>
Problem with_linear_solver(Problem problem) {
    static_assert(detail::never<Problem>,
                  "with_linear_solver: the solver needs the scalar of the state: write "
                  "with_linear_solver<sparse_blocks<double>>(problem)");
    return problem;
}
template <template <class, int> class Solver, class Problem>
Problem with_linear_solver(Problem problem) {
    static_assert(detail::never<Problem>,
                  "with_linear_solver: the solver needs the scalar and the size of the state: write "
                  "with_linear_solver<dense_blocks<double, 3>>(problem), or Eigen::Dynamic for the size");
    return problem;
}

}  // namespace stagecraft
