// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <iosfwd>

namespace stagecraft {

/// Why a run ended. Everything but `success` and `event` leaves the result at the last accepted state.
enum class status {
    success,         ///< t1 was reached with every step accepted
    stopped,         ///< an observer asked to stop
    event,           ///< a terminal event ended the run; the result is the state there
    steady_state,    ///< steady_state() has seen one
    outside_domain,  ///< every step that t resolves would end outside of problem.domain()
    chattering,  ///< events with actions take place again and again without end; result.exception names them
    too_many_steps,  ///< options.max_steps attempts were made before t1
    step_underflow,  ///< the error test wants a step below the resolution of t or below options.min_step
    newton_failed,   ///< the stage equations could not be solved with any admissible step
    inconsistent_start,  ///< y0 does not satisfy an equation without a derivative, and no y near it was found that does
    singular_matrix,  ///< gamma/h M - J, or what constraints leave of it for small h, was singular for every step
    constraints_dependent,  ///< constraints of a mechanical system come to depend on each other; result.exception names them
    linear_solver_failed,  ///< a linear solver that iterates did not converge, for every admissible step
    non_finite,    ///< the right-hand side or the Jacobian gave NaN or infinity for every admissible step
    size_changed,  ///< the right-hand side or the Jacobian resized its output
    wrong_derivative,  ///< a Jacobian, a pattern or a parameter_jacobian of the problem's disagrees with differences of f
    function_threw  ///< a callable of the problem threw; result.exception holds what it threw
};

/// The status as a word, e.g. "step_underflow".
constexpr const char* name(status s) {
    switch (s) {
        case status::success:
            return "success";
        case status::stopped:
            return "stopped";
        case status::event:
            return "event";
        case status::steady_state:
            return "steady_state";
        case status::outside_domain:
            return "outside_domain";
        case status::chattering:
            return "chattering";
        case status::too_many_steps:
            return "too_many_steps";
        case status::step_underflow:
            return "step_underflow";
        case status::newton_failed:
            return "newton_failed";
        case status::inconsistent_start:
            return "inconsistent_start";
        case status::singular_matrix:
            return "singular_matrix";
        case status::constraints_dependent:
            return "constraints_dependent";
        case status::linear_solver_failed:
            return "linear_solver_failed";
        case status::non_finite:
            return "non_finite";
        case status::size_changed:
            return "size_changed";
        case status::wrong_derivative:
            return "wrong_derivative";
        case status::function_threw:
            return "function_threw";
    }
    return "unknown";
}

/// Prints it as a word.
template <class Traits>
std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out, status s) {
    return out << name(s);
}

}  // namespace stagecraft
