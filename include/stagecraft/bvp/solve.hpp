// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <type_traits>
#include <utility>

// Before what includes it, so that what is said from there is said in fewer lines.
#include <stagecraft/jacobian/dual_number.hpp>

#include <stagecraft/bvp/multipoint.hpp>
#include <stagecraft/bvp/solve/solve_functions.hpp>
#include <stagecraft/jacobian/automatic.hpp>
#include <stagecraft/problem/system.hpp>
#include <stagecraft/problem/two_point.hpp>
#include <stagecraft/refuse/detect/named_member.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>

namespace stagecraft {

namespace detail {

/// f is generic, by its declaration, and will be differentiated automatically.
template <class Rhs, class Vector,
          class Numbers = dual_vector<typename Vector::Scalar, Vector::RowsAtCompileTime>>
inline constexpr bool differentiated_rhs =
    !has_member_named<Rhs, jacobian_member> &&
    !converts_duals<Rhs, const typename Vector::Scalar&, const Numbers&, Numbers&>();

template <class Rhs>
inline constexpr bool is_two_point = false;
template <class Rhs, class Conditions>
inline constexpr bool is_two_point<two_point_problem<Rhs, Conditions>> = true;

template <class Scalar, int S>
void take_tableau(const tableau<Scalar, S>&);
template <class Method>
concept is_tableau = requires(const Method& m) {
    take_tableau(m);
};

/// One whose stages are given, unlike gauss_variable().
template <class Method>
concept is_one_tableau = is_tableau<Method> && requires(const Method& m) {
    m.A;
};

struct call_of_solve_bvp {
    template <class Method>
    static constexpr bool say() {
        static_assert(is_tableau<Method> || never<Method>,
                      "solve_bvp: the first argument must be a collocation tableau, gauss<3>() with its "
                      "parentheses, say");
        static_assert(
            !is_tableau<Method> || never<Method>,
            "solve_bvp(method, two_point(f, r), a, b, guess, p, options): guess is a vector with its type, "
            "Eigen::Vector2d(0, 1), say, not {0, 1}; p is a vector of Eigen's, left out if there is none, "
            "and options have no other names than {.rtol, .atol, "
            ".intervals, .mesh, .fixed_points, .max_intervals, .adapt, .newton_iterations, "
            ".break_points, .conditioning}");
        return true;
    }
};

}  // namespace detail

/// Solves M y' = f(t, y, p) on [a, b] with r(y(a), y(b), p) = 0.
///
/// method   A collocation tableau with distinct nodes: gauss<s>() (recommended), lobatto_iiia<s>(),
///          radau_iia<s>(), or one's own.
/// problem  two_point(f, r), problem/two_point.hpp. Where f has a domain (y > 0, say) it should write NaN outside:
///          Newton's iteration then keeps inside, where else it may be caught on the other side.
/// guess    For y: a vector, a function of t, or a solution, which is asked for derivative(t) as well.
///          Where Newton's iteration fails from it on four meshes, it begins at y = 0 (unless that solves the problem) and
///          on the trajectory from guess(a), before finer meshes; whatever it finds is a solution.
/// p        A guess for the unknown parameters; n + n_p conditions then.
/// Conditions inside [a, b], jumps of y, integrals and an unknown b are said in bvp/multipoint.hpp.
///
/// The mesh follows the contributions of its intervals to the global error, which is estimated by one more
/// solve with the factors of Newton's iteration (bvp/measure/error_estimate.hpp). Success means: the estimated error
/// of y(t) for all t, and of p, is within the tolerance, and the linearised problem is regular beyond the errors of
/// rounding, of differences and, where its fundamental solutions are resolved, of the mesh (bvp/judge/regularity_judge.hpp).
/// Where the first m components of f are the next m of y, q' = v, the largest such m is found by one evaluation of f near
/// the guess, or stated by f's second_order_components: q is then a polynomial of degree s + 1, and m s unknowns less
/// are eliminated.
/// Bad arguments throw std::invalid_argument, which names the argument; everything else is said by
/// result.status. Cost of a Newton step: N s evaluations of f and its Jacobian, O(N s^3 n^3) operations.
template <class Scalar, int S, class Rhs, class Conditions, class Guess, class Parameters>
requires requires(const Parameters& p) { p.size(); }
auto solve_bvp(const tableau<Scalar, S>& method, two_point_problem<Rhs, Conditions> problem,
               std::type_identity_t<Scalar> a, std::type_identity_t<Scalar> b, const Guess& guess,
               const Parameters& p, const bvp_options<std::type_identity_t<Scalar>>& o = {}) {
    constexpr bool real = detail::real_guess<Guess, Scalar>,
                   guessed = real && detail::usable_guess<Guess, Scalar>;
    static_assert(
        real,
        "solve_bvp: y is real: a complex y of n components is a real one of 2 n, its real parts and "
        "then its imaginary parts, as f and r then write them");
    static_assert(
        guessed || !real,
        "solve_bvp: guess must be a vector of Eigen's (Eigen::Vector2d(0, 1), say), a function of t "
        "that returns one (no expression: write `-> Eigen::Vector2d` or .eval()), or a solution");
    using vector = typename detail::vector_of_guess<Guess, Scalar>::type;
    using parameters = typename Parameters::PlainObject;
    if constexpr (guessed && parameters::RowsAtCompileTime == 0)
        if constexpr (detail::differentiated_rhs<Rhs, vector>) {
            // Called here before anybody else does, so that what does not compile in f is said from here.
            using number = dual<Scalar, vector::RowsAtCompileTime>;
            using numbers = dual_vector<Scalar, vector::RowsAtCompileTime>;
            [[maybe_unused]] constexpr bool dual_time = requires(numbers & out) {
                problem.f(std::declval<number>(), std::declval<numbers>(), out);
            };
            [[maybe_unused]] constexpr bool plain = requires(vector & out) {
                problem.f(std::declval<Scalar>(), std::declval<vector>(), out);
            };
        }
    using check = detail::checked_two_point<Rhs, Conditions, vector, parameters>;
    constexpr bool rhs = !guessed || check::rhs, conditions = !guessed || !rhs || check::conditions,
                   writes_through = !guessed || check::writes_through;
    static_assert(rhs,
                  "solve_bvp: the first argument of two_point must be callable as f(t, y, out), with a guess "
                  "for parameters as f(t, y, p, out), and write n numbers; y and out are of the type of "
                  "guess; the conditions come second");
    static_assert(conditions,
                  "solve_bvp: the second argument of two_point must be callable as r(left, right, out), with "
                  "a guess for parameters as r(left, right, p, out), and write n + n_p numbers; left and "
                  "right are of the type of guess, out too without parameters");
    static_assert(writes_through,
                  "solve_bvp: f or r of two_point(f, r) takes out by value, what it writes is lost: write "
                  "`Vector& out` or `auto& out`");
    if constexpr (guessed && rhs && conditions && writes_through) {
        detail::validate(o, a, b);
        bvp_options<Scalar> own = o;
        detail::take_break_points(own, o.break_points, a, b);
        if constexpr (has_break_points<Rhs>)
            detail::take_break_points(own, break_times<Scalar>(problem.f.break_points()), a, b);
        const int n = static_cast<int>(detail::guess_value(guess, a).size());
        detail::demand_bvp(n > 0, "guess must have at least one component");
        if constexpr (has_index<Rhs>)
            for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(problem.f.index().size()); ++i)
                detail::demand_bvp(problem.f.index()[i] <= 1, "problem.index() must not exceed 1");
        int positions = -1;
        if constexpr (has_second_order_components<Rhs>) positions = position_components<Rhs>(n);
        report<Scalar> counts;
        two_point_system<two_point_problem<Rhs, Conditions>, vector, parameters> functions(
            problem.f, problem.r, n, static_cast<int>(p.size()), counts);
        return detail::solve_functions<S, vector, parameters>(method, functions, guess, a, b, parameters(p),
                                                              own, positions);
    } else {
        return bvp_result<vector, parameters>{};
    }
}

/// The same without parameters.
template <class Scalar, int S, class Rhs, class Conditions, class Guess>
auto solve_bvp(const tableau<Scalar, S>& method, two_point_problem<Rhs, Conditions> problem,
               std::type_identity_t<Scalar> a, std::type_identity_t<Scalar> b, const Guess& guess,
               const bvp_options<std::type_identity_t<Scalar>>& o = {}) {
    return solve_bvp(method, std::move(problem), a, b, guess, Eigen::Matrix<Scalar, 0, 1>(), o);
}

/// f and r without two_point().
template <class Scalar, int S, class Rhs, class Conditions, class Guess>
requires(!detail::is_two_point<Rhs>) bvp_result<Eigen::VectorXd, Eigen::VectorXd> solve_bvp(
    const tableau<Scalar, S>&, const Rhs&, const Conditions&, std::type_identity_t<Scalar>,
    std::type_identity_t<Scalar>, const Guess&, const bvp_options<std::type_identity_t<Scalar>>& = {}) {
    constexpr bool together = detail::is_two_point<Rhs>;
    static_assert(
        together,
        "solve_bvp(method, two_point(f, r), a, b, guess): write two_point(f, r) for the right-hand side "
        "f(t, y, out) and the conditions r(left, right, out)");
    return {};
}

/// The guess is a list in braces, which has no type.
template <class Method, class Rhs, class Conditions>
bvp_result<Eigen::VectorXd, Eigen::VectorXd> solve_bvp(const Method&,
                                                       const two_point_problem<Rhs, Conditions>&, double,
                                                       double, std::initializer_list<double>,
                                                       const bvp_options<double>& = {}) {
    static_assert(detail::never<Method>,
                  "solve_bvp: guess is a vector with its type, Eigen::Vector2d(0, 1), say, not {0, 1}");
    return {};
}
template <class Method, class Rhs, class Conditions, class Parameters>
requires requires(const Parameters& p) { p.size(); }
bvp_result<Eigen::VectorXd, Eigen::VectorXd> solve_bvp(const Method& method,
                                                       const two_point_problem<Rhs, Conditions>& problem,
                                                       double a, double b,
                                                       std::initializer_list<double> guess, const Parameters&,
                                                       const bvp_options<double>& = {}) {
    return solve_bvp(method, problem, a, b, guess);
}

/// Another first argument, or options of names that there are not.
bvp_result<Eigen::VectorXd, Eigen::VectorXd> solve_bvp(detail::refused_call<detail::call_of_solve_bvp>,
                                                       detail::anything, detail::anything, detail::anything,
                                                       detail::anything, const detail::misnamed_options&);
bvp_result<Eigen::VectorXd, Eigen::VectorXd> solve_bvp(detail::refused_call<detail::call_of_solve_bvp>,
                                                       detail::anything, detail::anything, detail::anything,
                                                       detail::anything, detail::anything,
                                                       const detail::misnamed_options&);
bvp_result<Eigen::VectorXd, Eigen::VectorXd> solve_bvp(detail::refused_call<detail::call_of_solve_bvp>,
                                                       detail::anything = 0, detail::anything = 0);
bvp_result<Eigen::VectorXd, Eigen::VectorXd> solve_bvp(detail::refused_call<detail::call_of_solve_bvp>,
                                                       detail::anything, detail::anything, detail::anything,
                                                       detail::anything, ...);
bvp_result<Eigen::VectorXd, Eigen::VectorXd> solve_bvp(detail::refused_call<detail::call_of_solve_bvp>,
                                                       detail::anything, detail::anything, detail::anything,
                                                       ...);

}  // namespace stagecraft
