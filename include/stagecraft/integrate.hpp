// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <exception>
#include <type_traits>
#include <utility>

// Before what includes them, so that what is said from there is said in fewer lines.
#include <stagecraft/jacobian/dual_number.hpp>

#include <stagecraft/jacobian/dual_functions.hpp>

#include <stagecraft/observe/observer.hpp>
#include <stagecraft/problem/state_mass.hpp>
#include <stagecraft/refuse/given_arguments.hpp>
#include <stagecraft/refuse/problem/checked_call.hpp>
#include <stagecraft/result.hpp>
#include <stagecraft/run/continued.hpp>
#include <stagecraft/run/integrator.hpp>

namespace stagecraft {

namespace detail {

/// Makes the steps of a run that begins, or goes on, at `start`, which later takes the states to be corrected.
/// `begins`: it is no rest of a run.
template <class Run, class Vector, class Observer>
result<Vector> run_to_the_end(Run& run, Vector& start, const typename Vector::Scalar& t1, Observer& observer,
                              [[maybe_unused]] bool begins) {
    if (begins) {
        run.make_consistent();
        start = run.y();
    }
    run.between_steps([&] {
        announce(observer, run.t(), start, t1);
        return true;
    });
    std::exception_ptr thrown;
    stagecraft::status ended = status::success;
    try {
        if constexpr (!std::is_same_v<std::remove_cv_t<Observer>, no_observer>)
            if (begins && run.status() == status::success)
                run.between_steps([&] {
                    change(observer, run, start);
                    return !ends_at_start(observer);
                });
        while (run.step()) {
            if constexpr (!std::is_same_v<std::remove_cv_t<Observer>, no_observer>)
                run.between_steps([&] {
                    correct(observer, run, start);
                    const auto& output = run.output();
                    const auto* end = end_inside(observer, run.t(), run.y(), output.step(), output);
                    bool go_on = tell_until(end, observer, run.t(), run.y(), output.step(), output);
                    if (change(observer, run, start, end) && end) go_on = true;
                    // Generic, so that it is compiled only where an observer asks for it.
                    if (!end) save(observer, [&](auto... none) { return checkpoint_of(run, none...); });
                    return go_on;
                });
        }
        ended = run.status();
        if constexpr (requires { run.reason(); }) thrown = run.reason();
    } catch (const bad_problem&) {
        throw;
    } catch (const size_change&) {
        ended = status::size_changed;
    } catch (...) {
        ended = status::function_threw;
        thrown = std::current_exception();
    }
    result<Vector> r{run.t(), run.y(), ended, run.counts(), thrown};
    conclude(observer, r);
    return r;
}

template <class Observer, class Run, class Vector>
inline constexpr bool wants_output = asks_for_output<Observer, Vector, typename Run::output_type>;

/// The run from y0, where the arguments are good.
template <class Given, class Method, class Problem, class Derived, class Observer>
result<typename Given::vector> run_from(const Method& method, Problem& problem,
                                        const Eigen::MatrixBase<Derived>& y0,
                                        const typename Given::scalar& t0, const typename Given::scalar& t1,
                                        const options<typename Given::scalar>& o, Observer& observer) {
    if constexpr (Given::returns && Given::same_size && Given::object && Given::explicit_usable) {
        return integrate(method, Given::writing(problem), y0, t0, t1, o, observer);
    } else if constexpr (Given::good && Given::observed && Given::explicit_usable) {
        using vector = typename Given::vector;
        using run_type = integrator<Method, Problem, vector>;
        o.break_points.validate("integrate: break_points", t0, t1, true);
        vector start = y0;
        run_type run(method, problem, start, t0, t1, with_break_points_of(observer, o),
                     wants_output<Observer, run_type, vector>);
        if constexpr (looks_between<Observer, vector, typename run_type::output_type>)
            run.watch_between_ends();
        return run_to_the_end(run, start, t1, observer, true);
    } else {
        return {};
    }
}

}  // namespace detail

/// Integrates M y' = f(t, y), y(t0) = y0 to t1, in either direction of time.
///
/// method   One of six kinds. (1) A transformed_tableau (its A is regular: Radau IA/IIA, Gauss, Lobatto
///          IIIC), e.g. radau_iia<3>() from coefficients/radau_iia.hpp, with the number of stages known at
///          compile time or at run time. (2) A variable_order set, which chooses among such methods. (3) Any
///          tableau: the stages of explicit and of diagonally implicit methods are solved one by one, those of
///          the others together, in real and complex blocks where A has a basis of eigenvectors. Adaptive
///          steps of a tableau need its b_embedded (or method/step_doubling.hpp). (4) additive(explicit_part,
///          implicit_part) of additive.hpp, for a problem in two parts. (5) partitioned(first, second) of
///          partitioned.hpp, for q' = f, p' = g. (6) A Nystrom method of nystrom.hpp, for q'' = f.
/// problem  Anything that can be called as problem(t, y, f) and writes f, or as problem(t, y) and returns it (then a
///          copy of it is called). Optional members are detected:
///          jacobian(t, y, J), mass(), index(), constant_jacobian(), second_order_components, bandwidth(),
///          sparsity(), matrix(), add_up() (problem/capabilities.hpp). Without jacobian(), a generic right-hand side is
///          differentiated automatically and any other by finite differences. problem/with.hpp adds such
///          members to a lambda; problem/semi_explicit.hpp and problem/fully_implicit.hpp make a problem of
///          y' = f(t, y, z), 0 = g and of F(t, y, y') = 0; dae/consistent.hpp finds and checks their initial
///          values.
/// y0       An Eigen column vector of fixed or dynamic size, of the method's scalar type. (states.hpp: a std::array, a
///          std::vector, a number, complex.)
/// options  Tolerances, step sizes and limits (options.hpp). options.fixed_step > 0 takes equal steps
///          without an error estimate.
/// observer Called after every accepted step as observer(t, y, h, output), (t, y, h) or (t, y), where
///          output(time) and output.derivative(time) evaluate the continuous solution anywhere in that step
///          and cost nothing unless they are called. An observer that returns false stops the run
///          (status::stopped). It is used in place, never copied. More in observe/observer.hpp.
///
/// Never returns success with a state that is not finite. Bad arguments throw std::invalid_argument, which
/// names the argument. Whatever the problem or the observer throws ends the run with status::function_threw
/// and is kept in result.exception. t1 == t0 returns y0 with success and takes no step. No step allocates
/// memory where the state has a fixed size or the matrices are dense.
template <class Method, class Problem, class Derived, class Observer = no_observer>
requires(!Eigen::NumTraits<typename Derived::Scalar>::IsComplex &&
         !has_state_mass<
             std::remove_reference_t<Problem>,
             typename Derived::PlainObject>) auto integrate(const Method& method, Problem&& problem,
                                                            const Eigen::MatrixBase<Derived>& y0,
                                                            std::type_identity_t<typename Derived::Scalar> t0,
                                                            std::type_identity_t<typename Derived::Scalar> t1,
                                                            const options<typename Derived::Scalar>& o = {},
                                                            Observer&& observer = {})
    -> result<typename Derived::PlainObject> {
    using given = detail::given_arguments<Method, std::remove_reference_t<Problem>,
                                          typename Derived::PlainObject, std::remove_reference_t<Observer>>;
    using vector = typename given::vector;
    if constexpr (given::differentiated) {
        using number = typename given::number;
        using numbers = typename given::numbers;
        // As temporaries, which an `auto&` that is written into does not take: see detail::writes_last.
        constexpr bool dual_time = requires(numbers & f) {
            problem(std::declval<number>(), std::declval<numbers>(), f);
        };
        if constexpr (!dual_time) {
            [[maybe_unused]] constexpr bool plain_time = requires(numbers & f) {
                problem(std::declval<typename given::scalar>(), std::declval<numbers>(), f);
            };
        }
    }
    if constexpr (given::begun) {
        [[maybe_unused]] constexpr bool compiles = requires(vector & f) {
            problem(std::declval<typename given::scalar>(), std::declval<vector>(), f);
        };
    }
    [[maybe_unused]] constexpr bool watches = requires(const typename given::scalar& t, const vector& y) {
        observer(t, y);
    };
    static_assert(given::method_first,
                  "integrate(method, problem, y0, t0, t1, ...): the first argument must be a tableau, a "
                  "transformed_tableau or a variable_order set, radau_iia<3>() with its parentheses, say");
    static_assert(given::same_scalar,
                  "integrate: method and y0 must have the same scalar type: y0 is Eigen::Vector3d, say, "
                  "for a method in double");
    static_assert(given::problem_in_parts,
                  "integrate: an additive method takes a problem in two parts: write split(f_explicit, "
                  "f_implicit) in the place of the problem");
    static_assert(given::method_for_parts,
                  "integrate: the problem is split(f_explicit, f_implicit), which additive(explicit_part, "
                  "implicit_part) takes; for another method write their sum as one f");
    static_assert(given::explicit_usable,
                  "integrate: f_explicit of split(f_explicit, f_implicit) must be callable as f(t, y, f), f "
                  "by reference, or as f(t, y), with vectors of the type of y0");
    static_assert(given::column,
                  "integrate: y0 must be a column vector, Eigen::VectorXd or Eigen::Vector3d, say; a "
                  "matrix is one as Y.reshaped(), and in f an Eigen::Map of y.data() is the matrix again");
    static_assert(given::const_enough,
                  "integrate: the problem is const and its operator()(t, y, f) is not: write `void "
                  "operator()(...) const`");
    static_assert(given::callable,
                  "integrate: the problem must be callable as problem(t, y, f) and write f(t, y) into f, "
                  "as `void operator()(double t, const Vector& y, Vector& f) const` with Vector the type "
                  "of y0 (of fixed size if that is), or as problem(t, y) and return such a Vector");
    static_assert(given::writes_through,
                  "integrate: the problem takes f by value, or const, and what it writes is lost: write "
                  "`Vector& f` or `auto& f`");
    static_assert(given::band_known,
                  "integrate: the problem has bandwidth(): include stagecraft/linear/banded_blocks.hpp");
    static_assert(given::same_size, "integrate: the problem returns a vector of another size than y0");
    static_assert(
        given::object,
        "integrate: the problem returns an expression of Eigen's, whose operands may be gone before it "
        "is evaluated: write `-> Eigen::Vector2d`, the type of y0, or `return (A * y).eval();`");
    static_assert(given::pattern_usable,
                  "integrate: problem.sparsity must be a member function `auto sparsity() const` that "
                  "returns an Eigen::SparseMatrix with the pattern of df/dy");
    static_assert(given::pattern_known,
                  "integrate: the problem has sparsity(): include stagecraft/linear/sparse_blocks.hpp");
    static_assert(given::mass_usable,
                  "integrate: problem.mass must be a member function `auto mass() const` that returns the "
                  "n x n matrix M (an object, not an expression: write its type or .eval()); give a member "
                  "that means something else another name");
    static_assert(given::jacobian_usable,
                  "integrate: problem.jacobian must be a member function `void jacobian(double t, const "
                  "Vector& y, Matrix& J) const`, Vector the type of y0, Matrix n x n of the same sizes "
                  "(at compile time); a banded_matrix with bandwidth(), the type of sparsity() with that");
    static_assert(given::index_usable,
                  "integrate: problem.index must be a member function `auto index() const` that returns the "
                  "index of every component, as a std::array<int, n> or a std::vector<int> (or a vector of "
                  "Eigen's, not an expression: write its type or .eval())");
    static_assert(given::band_usable,
                  "integrate: problem.bandwidth must be a member function `stagecraft::bandwidth bandwidth() "
                  "const`, which returns {lower, upper}");
    static_assert(given::solver_usable,
                  "integrate: Problem::linear_solver must be a type with member types `real` and `complex`: "
                  "`using linear_solver = stagecraft::krylov_blocks;`, say");
    static_assert(given::constancy_usable,
                  "integrate: problem.constant_jacobian must be a member function `bool constant_jacobian() "
                  "const`");
    static_assert(given::lower_case,
                  "integrate: members of the problem are called jacobian, mass, index, bandwidth and "
                  "sparsity, without a capital, and not jac or mass_matrix");
    static_assert(
        given::observed,
        "integrate: the observer must be callable as observer(t, y), (t, y, h) or (t, y, h, "
        "output), y by value or const reference and of the type of y0, and const if it is given as const");
    return detail::run_from<given>(method, problem, y0, t0, t1, o, observer);
}

/// The same of M(t, y) y' = f(t, y), where the problem has a member mass(t, y) (problem/state_mass.hpp).
template <class Method, class Problem, class Derived, class Observer = no_observer>
requires(!Eigen::NumTraits<typename Derived::Scalar>::IsComplex &&
         has_state_mass<
             std::remove_reference_t<Problem>,
             typename Derived::PlainObject>) auto integrate(const Method& method, Problem&& problem,
                                                            const Eigen::MatrixBase<Derived>& y0,
                                                            std::type_identity_t<typename Derived::Scalar> t0,
                                                            std::type_identity_t<typename Derived::Scalar> t1,
                                                            const options<typename Derived::Scalar>& o = {},
                                                            Observer&& observer = {})
    -> result<typename Derived::PlainObject> {
    using vector = typename Derived::PlainObject;
    validate_interval(y0, t0, t1);
    const detail::explicit_form<std::remove_reference_t<Problem>, vector> solved(problem, t0, y0);
    return integrate(method, solved, y0, t0, t1, o, observer);
}

/// Goes on with a run from a checkpoint of it (checkpoint.hpp) with these options: with the same method, problem, t1 and
/// options it ends with the bits of the run that was not interrupted, report included. With other options or another t1 it
/// is a run that begins with the step size, the order and the Jacobian of the other one. Observers start at from.t.
/// std::invalid_argument where the method or the size of the problem is another one, and with options.fixed_step
/// another t1.
template <class Method, class Problem, class Vector, class Observer = no_observer>
result<Vector> integrate(const Method& method, Problem&& problem, const checkpoint<Vector>& from,
                         std::type_identity_t<typename Vector::Scalar> t1,
                         const options<typename Vector::Scalar>& o, Observer&& observer = {}) {
    using problem_type = std::remove_reference_t<Problem>;
    if constexpr (detail::returning_right_hand_side<problem_type, Vector>) {
        static_assert(detail::returns_object<problem_type, Vector>,
                      "integrate: the problem returns an expression of Eigen's, whose operands may be gone: "
                      "write `-> Eigen::Vector2d`, the type of the state, or `return (A * y).eval();`");
        return integrate(method, detail::writes_returned<std::decay_t<Problem>>{problem}, from, t1, o,
                         std::forward<Observer>(observer));
    } else {
        static_assert(checked_call<problem_type, Vector>::good,
                      "integrate(method, problem, checkpoint, t1, options, observer): the problem must be "
                      "the one of which "
                      "the checkpoint was taken");
        using run_type = integrator<Method, problem_type, Vector>;
        constexpr bool observed =
            detail::can_observe<std::remove_reference_t<Observer>, Vector, typename run_type::output_type>;
        static_assert(
            observed,
            "integrate(method, problem, checkpoint, t1, options, observer): the observer must be "
            "callable as observer(t, y), (t, y, h) or (t, y, h, output), y of the type of the state");
        Vector start = from.y;
        run_type run(method, problem, start, from.t, t1, with_break_points_of(observer, o),
                     detail::wants_output<std::remove_reference_t<Observer>, run_type, Vector>);
        restore(run, from);
        if constexpr (detail::looks_between<std::remove_reference_t<Observer>, Vector,
                                            typename run_type::output_type>)
            run.watch_between_ends();
        if constexpr (observed)
            return detail::run_to_the_end(run, start, t1, observer, false);
        else
            return {};
    }
}

/// The same with the options of the run that the checkpoint was taken of, where none are given or {} stands in their place:
///
///     integrate(method, problem, last, t1);
///     integrate(method, problem, last, t1, {}, observer);
///
/// The defaults are options<double>{}. std::invalid_argument where the checkpoint has no options.
template <class Method, class Problem, class Vector, class Observer = no_observer>
result<Vector> integrate(const Method& method, Problem&& problem, const checkpoint<Vector>& from,
                         std::type_identity_t<typename Vector::Scalar> t1, std::nullptr_t = {},
                         Observer&& observer = {}) {
    return integrate(method, std::forward<Problem>(problem), from, t1, detail::options_of(from), observer);
}

}  // namespace stagecraft

// What else is called integrate, and says what to write.
#include <stagecraft/refuse/integrate.hpp>
