// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <exception>
#include <type_traits>

#include <stagecraft/observe/observer.hpp>
#include <stagecraft/step/integrator.hpp>

namespace stagecraft {

/// What a run returns: the last accepted state (status::event: the state at the event), always finite, and
/// why it ended. Only status::success means t = t1.
template <class Vector>
struct result {
    typename Vector::Scalar t;
    Vector y;
    stagecraft::status status;
    stagecraft::report<typename Vector::Scalar> report;
    std::exception_ptr exception;  ///< what a callable threw (status::function_threw), else null

    bool ok() const { return status == status::success; }
};

/// Integrates M y' = f(t, y), y(t0) = y0 to t1, in either direction of time.
///
/// method   One of three kinds. (1) A transformed_tableau (its A is regular: Radau IA/IIA, Gauss, Lobatto
///          IIIC), e.g. radau_iia<3>() from coefficients/radau_iia.hpp, with the number of stages known at
///          compile time or at run time. (2) A variable_order set, which chooses among such methods. (3) Any
///          tableau: the stages of explicit and of diagonally implicit methods are solved one by one, those of
///          the others together, in real and complex blocks where A has a basis of eigenvectors. Adaptive
///          steps of a tableau need its b_embedded (or tableau/step_doubling.hpp).
/// problem  Anything that can be called as problem(t, y, f) and writes f. Optional members are detected:
///          jacobian(t, y, J), mass(), index(), constant_jacobian(), second_order_components, bandwidth(),
///          sparsity() (problem/capabilities.hpp). Without jacobian(), a generic right-hand side is
///          differentiated automatically and any other by finite differences. problem/with.hpp adds such
///          members to a lambda; problem/semi_explicit.hpp and problem/fully_implicit.hpp make a problem of
///          y' = f(t, y, z), 0 = g and of F(t, y, y') = 0; dae/consistent.hpp finds and checks their initial
///          values.
/// y0       An Eigen column vector of fixed or dynamic size, of the method's scalar type.
/// options  Tolerances, step sizes and limits (control/options.hpp). options.fixed_step > 0 takes equal steps
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
requires right_hand_side < std::remove_reference_t<Problem>,
typename Derived::PlainObject >
    auto integrate(const Method& method, Problem&& problem, const Eigen::MatrixBase<Derived>& y0,
                   std::type_identity_t<typename Derived::Scalar> t0,
                   std::type_identity_t<typename Derived::Scalar> t1,
                   const options<typename Derived::Scalar>& o = {}, Observer&& observer = {}) {
    using vector = typename Derived::PlainObject;
    vector start = y0;  // later the states to be corrected
    using run_type = integrator<Method, std::remove_reference_t<Problem>, vector>;
    run_type run(
        method, problem, start, t0, t1, o,
        detail::asks_for_output<std::remove_reference_t<Observer>, vector, typename run_type::output_type>);
    detail::announce(observer, run.t(), start, t1);
    std::exception_ptr thrown;
    status ended = status::success;
    try {
        while (run.step()) {
            detail::correct(observer, run, start);
            if constexpr (!std::is_same_v<std::decay_t<Observer>, no_observer>)
                if (!detail::observe(observer, run.t(), run.y(), run.output().step(), run.output()))
                    run.stop();
        }
        ended = run.status();
    } catch (const bad_problem&) {
        throw;
    } catch (const size_change&) {
        ended = status::size_changed;
    } catch (...) {
        ended = status::function_threw;
        thrown = std::current_exception();
    }
    result<vector> r{run.t(), run.y(), ended, run.counts(), thrown};
    detail::conclude(observer, r);
    return r;
}

}  // namespace stagecraft
