// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/paths/path.hpp>
#include <stagecraft/bvp/solve.hpp>

namespace stagecraft {

/// A point of a path: parameter, solution, and where on the path it lies.
template <class Vector>
struct continuation_point {
    using scalar = typename Vector::Scalar;
    using parameters = Eigen::Matrix<scalar, 1, 1>;
    parameters p;
    solution<Vector> y;  ///< without steps (y.steps() == 0) where a last point failed and left none
    point_kind kind = point_kind::regular;
    bvp_status status = bvp_status::newton_failed;
    std::string
        message;  ///< of the last point: why the path ends there, in words; empty where p has passed `to`
    scalar arclength{0};  ///< in the space of (y(a), y(b), p)
    std::vector<scalar> mesh;
    /// Branch points: a solution on the path that crosses, close by. continuation() follows that path from the guess
    /// crossing_y with .from = crossing_p[0]; where it has a fold at the crossing (a pitchfork), to the side of crossing_p.
    /// Empty (crossing_y.steps() == 0) where none was found.
    parameters crossing_p = parameters::Zero();
    solution<Vector> crossing_y;

    bool ok() const { return status == bvp_status::success; }
};

namespace detail {

struct call_of_continuation {
    template <class Method>
    static constexpr bool say() {
        static_assert(is_one_tableau<Method> || never<Method>,
                      "continuation: the first argument must be a collocation tableau, gauss<3>() with its "
                      "parentheses, say; gauss_variable() is of solve_bvp alone");
        static_assert(
            !is_one_tableau<Method> || never<Method>,
            "continuation(method, two_point(f, r), a, b, guess, options): options have no other "
            "names than {.from, .to, .rtol, .step, .largest_step, .max_points, .intervals}; the path "
            "begins at p = from");
        return true;
    }
};

}  // namespace detail

/// The path of solutions of y' = f(t, y, p), r(y(a), y(b), p) = 0 with one parameter p from p[0] = o.from on, by
/// arclength in the space of (y(a), y(b), p), in which a solution is determined; the mesh is adapted at every
/// point.
///
/// Points where dp/ds changes its sign are located (point_kind::fold), and points where another path crosses
/// (point_kind::branch_point): where the determinant of the linearised problem with the arclength changes its sign, which at
/// folds it does not. A crossing that leaves the sign as it is, of an even number of paths, is not seen, nor are two
/// crossings between neighbouring points (largest_step). Every point costs a run of solve_bvp from a near guess,
/// a fold about ten, a branch point about twenty.
///
/// A branch point solves the problem to the tolerance. Where an imperfection (a small load on a rod, say) leaves two paths that
/// come close and turn away from each other, there is none, and a step from one to the other is refused, as is one whose
/// chord or tangent turns by more than 30 or 60 degrees: smaller steps follow the path round its bend, down to
/// step / 10000, at a cost of some ten to a hundred solutions for each halving.
///
/// A path ends where p has passed `to`; the last point's message says where it ends otherwise: p has come back to `from`, there
/// are max_points, the smallest step still is refused (that point, whose status is tolerance_not_met, may lie on another path),
/// or solve_bvp fails (that point's status says how). A special point that could not be located to
/// the tolerance has the status tolerance_not_met: it lies near the place, if there is one.
template <class Scalar, int S, class Rhs, class Conditions, class Guess>
auto continuation(const tableau<Scalar, S>& method, two_point_problem<Rhs, Conditions> problem,
                  std::type_identity_t<Scalar> a, std::type_identity_t<Scalar> b, const Guess& guess,
                  const continuation_options<std::type_identity_t<Scalar>>& o = {}) {
    constexpr bool real = detail::real_guess<Guess, Scalar>,
                   guessed = real && detail::usable_guess<Guess, Scalar>;
    static_assert(real, "continuation: y is real: a complex y of n components is a real one of 2 n");
    static_assert(
        guessed || !real,
        "continuation: guess must be a vector of Eigen's (Eigen::Vector2d(0, 1), say), a function of t "
        "that returns one (no expression: write `-> Eigen::Vector2d` or .eval()), or a solution");
    using vector = typename detail::vector_of_guess<Guess, Scalar>::type;
    using point = continuation_point<vector>;
    using parameters = typename point::parameters;
    using check = detail::checked_two_point<Rhs, Conditions, vector, parameters>;
    constexpr bool rhs = !guessed || check::rhs, conditions = !guessed || !rhs || check::conditions,
                   writes_through = !guessed || check::writes_through;
    static_assert(
        rhs,
        "continuation: the first argument of two_point must be callable as f(t, y, p, out), with p[0] "
        "the parameter of the path, and write n numbers; y and out are of the type of guess");
    static_assert(
        conditions,
        "continuation: the second argument of two_point must be callable as r(left, right, p, out) and "
        "write n numbers, out a vector of n + 1");
    static_assert(writes_through,
                  "continuation: f or r of two_point(f, r) takes out by value, what it writes is lost: write "
                  "`auto& out`");
    std::vector<point> path;
    if constexpr (guessed && rhs && conditions && writes_through) {
        detail::validate(o, a, b, "continuation");
        detail::demand_bvp(detail::guess_value(guess, a).size() > 0, "guess must have at least one component",
                           "continuation");
        detail::path_problem_of<Rhs, Conditions, vector, parameters> of(std::move(problem));
        for (auto& s :
             detail::follow_path<S, vector, parameters>(method, of, a, b, guess, parameters(o.from), o))
            path.push_back({s.p, std::move(s.y), s.kind, s.status, s.message, s.arclength, std::move(s.mesh),
                            s.other_p, std::move(s.other_y)});
    }
    return path;
}

/// Another first argument, or options of names that there are not.
std::vector<continuation_point<Eigen::VectorXd>> continuation(
    detail::refused_call<detail::call_of_continuation>, detail::anything, detail::anything, detail::anything,
    detail::anything, const detail::misnamed_options&);
std::vector<continuation_point<Eigen::VectorXd>> continuation(
    detail::refused_call<detail::call_of_continuation>, detail::anything = 0, detail::anything = 0,
    detail::anything = 0, detail::anything = 0, ...);

}  // namespace stagecraft
