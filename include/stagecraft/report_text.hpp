// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <iomanip>
#include <ostream>
#include <utility>

#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/time_split.hpp>

namespace stagecraft {

/// Why a run ended, as a sentence.
constexpr const char* reason(status s) {
    switch (s) {
        case status::success:
            return "t1 was reached with every step accepted";
        case status::stopped:
            return "an observer asked to stop";
        case status::event:
            return "a terminal event took place";
        case status::steady_state:
            return "no component changes by more than steady_state() was told";
        case status::outside_domain:
            return "every step that t resolves would end outside of problem.domain()";
        case status::chattering:
            return "events with actions take place again and again: the solution slides along the zeros of "
                   "what switches it, or comes to rest there; take f as it is on that surface, or smooth the "
                   "switch";
        case status::too_many_steps:
            return "options.max_steps attempts were made before t1";
        case status::step_underflow:
            return "the error test wants a step below the resolution of t or below options.min_step";
        case status::newton_failed:
            return "the stage equations could not be solved with any admissible step";
        case status::inconsistent_start:
            return "y0 does not satisfy an equation without a derivative, and no y was found beside it that "
                   "does";
        case status::singular_matrix:
            return "the matrix gamma/h M - J, or what constraints leave of it for small h, was singular "
                   "for every admissible step";
        case status::constraints_dependent:
            return "constraints come to depend on each other beside the state where the run ends, which is "
                   "no position from which they determine the motion; result.exception names them";
        case status::linear_solver_failed:
            return "a linear solver that iterates did not reach the residual it was asked for, with any "
                   "admissible step";
        case status::non_finite:
            return "the right-hand side or the Jacobian gave NaN or infinity for every admissible step";
        case status::size_changed:
            return "the right-hand side or the Jacobian changed the size of its output";
        case status::wrong_derivative:
            return "a Jacobian, a pattern or a parameter_jacobian of the problem's disagrees with "
                   "differences of f";
        case status::function_threw:
            return "a function of the problem or an observer threw; result.exception holds what";
    }
    return "unknown";
}

namespace detail {

/// Restores what a printing function changes of a stream.
class stream_format {
  public:
    explicit stream_format(std::ostream& out) : out_(out), kept_(nullptr) { kept_.copyfmt(out); }
    ~stream_format() { out_.copyfmt(kept_); }
    stream_format(const stream_format&) = delete;
    stream_format& operator=(const stream_format&) = delete;

  private:
    std::ostream& out_;
    std::ios kept_;
};

}  // namespace detail

/// The optional members found, in a line: a misspelt one is missing there.
inline void print(std::ostream& out, const found_capabilities& found) {
    const char* separator = "";
    const auto name = [&](bool there, const char* what) {
        if (there) out << std::exchange(separator, ", ") << what;
    };
    name(true, "f");
    name(found.jacobian == jacobian_source::member, "jacobian");
    name(found.has(capability::mass), "mass");
    name(found.has(capability::index), "index");
    name(found.has(capability::constant_jacobian), "constant_jacobian");
    name(found.has(capability::second_order_components), "second_order_components");
    name(found.has(capability::bandwidth), "bandwidth");
    name(found.has(capability::sparsity), "sparsity");
    name(found.has(capability::matrix), "matrix");
    name(found.has(capability::linear_solver), "linear_solver");
    name(found.has(capability::add_up), "add_up");
    name(found.has(capability::measure), "measure");
    name(found.has(capability::break_points), "break_points");
    name(found.has(capability::domain), "domain");
    if (found.jacobian == jacobian_source::automatic_differentiation)
        out << "; Jacobian by automatic differentiation";
    if (found.jacobian == jacobian_source::differences) out << "; Jacobian by finite differences";
    out << '\n';
}

/// Prints what a run was told and what it cost, one line per kind of work.
template <class Scalar>
std::ostream& print(std::ostream& out, const report<Scalar>& r) {
    const detail::stream_format kept(out);
    const auto line = [&](const char* what) -> std::ostream& {
        return out << std::left << std::setw(16) << what << std::right << std::setw(10);
    };
    out << std::defaultfloat << std::setprecision(3);
    if (r.rtol > Scalar(0)) {  // a report that a run has filled
        out << std::left << std::setw(16) << "problem";
        print(out, r.found);
        out << std::setw(16) << "tolerances"
            << "rtol " << r.rtol;
        if (r.atol > Scalar(0)) out << ", atol " << r.atol;
        if (r.atol == Scalar(0)) out << ", atol by component";
        if (r.default_atol) {
            out << " (the default: components smaller than that are not controlled";
            if (r.rtol < r.atol) out << ", and it rules where |y| < " << r.atol / r.rtol;
            out << ')';
        }
        out << '\n';
    }
    if (r.unmet_equation >= 0)
        line("start") << "equation " << r.unmet_equation << " (counted from 0) leaves " << r.unmet_rest
                      << ", as much as " << r.unmet_tolerances << " tolerances of all components make\n";
    line("steps") << r.steps << "  from " << r.smallest_step << " to " << r.largest_step << ", "
                  << r.smallest_stages;
    if (r.largest_stages != r.smallest_stages) out << " to " << r.largest_stages;
    out << " stages\n";
    line("rejected") << r.rejected() << "  " << r.rejected_error << " by the error test, "
                     << r.rejected_newton << " by Newton\n";
    line("f") << r.f;
    if (r.f_explicit > 0) out << ", " << r.f_explicit << " explicit and " << r.f_implicit << " implicit";
    out << "  and " << r.f_jacobian << " in Jacobians\n";
    if (r.clipped > 0) line("clipped") << r.clipped << "  components below zero by less than their atol\n";
    if (r.at_rounding > 0)
        line("at rounding")
            << r.at_rounding
            << "  steps, whose error is rounding divided by h: components behave as of index 2\n";
    line("Jacobians") << r.jacobians << '\n';
    line("factorisations") << r.factorisations << '\n';
    line("solves") << r.solves << "  and " << r.error_solves << " error estimates\n";
    if (r.linear_iterations > 0)
        line("iterations") << r.linear_iterations << "  of linear solvers, " << r.linear_failures
                           << " of whose systems were not solved\n";
    return out;
}

/// What to look at where a run with a mass matrix could not go on, in a sentence; empty otherwise.
template <class Scalar>
constexpr const char* advice(status s, const report<Scalar>& r) {
    if (!r.found.has(capability::mass) || s == status::success || s == status::stopped ||
        s == status::event || s == status::steady_state || s == status::outside_domain ||
        s == status::chattering || s == status::too_many_steps || s == status::size_changed ||
        s == status::linear_solver_failed || s == status::constraints_dependent ||
        s == status::function_threw)
        return "";
    if (s == status::singular_matrix && !r.found.has(capability::index))
        return "there is no problem.index(): where the constraints determine components of index 2 and 3, it "
               "has to name them; or look at the constraints: they may depend on each other, or y0 may not "
               "satisfy them (dae/consistent.hpp)";
    if (s == status::singular_matrix)
        return "look at the constraints: they may depend on each other, or y0 may not satisfy them "
               "(dae/consistent.hpp), "
               "or they determine components of index 2 and 3, which problem.index() has to name";
    if (!r.found.has(capability::index))
        return "where mass() is singular, look at y0, which has to satisfy the constraints "
               "(dae/consistent.hpp), and "
               "at the index: problem.index() has to name components of index 2 and 3";
    if (r.steps == 0)
        return "look at y0, which has to satisfy the constraints and, with index 3, their derivative "
               "(dae/consistent.hpp), and at problem.index()";
    return "";
}

/// Why linear systems were not solved by iteration and what to do, in a sentence; empty where few were not.
template <class Scalar>
constexpr const char* linear_advice(status s, const report<Scalar>& r) {
    const long attempts = r.steps + r.rejected();
    if (s != status::linear_solver_failed && 10 * r.linear_failures <= attempts) return "";
    switch (r.linear_trouble) {
        case unsolved_because::nothing:
            return "";
        case unsolved_because::slow:
            return "iterations of the linear solver did not converge: the preconditioner is too weak for "
                   "steps of useful length; give problem.precondition() more of J, or take a direct solver "
                   "(linear/klu.hpp, linear/sparse_lu.hpp)";
        case unsolved_because::zero_diagonal:
            return "iterations of the linear solver did not converge, and its incomplete factorisation met "
                   "zeros on the diagonal, as constraints have them: take a direct solver (linear/klu.hpp, "
                   "linear/sparse_lu.hpp), or matrix() with a preconditioner of your own";
        case unsolved_because::bad_preconditioner:
            return "the preconditioner gave NaN, infinity or zeros for a vector that is finite and not zero: "
                   "look at problem.precondition()";
    }
    return "";
}

/// What the counts of a run give reason to doubt, in a sentence; empty where they do not. Where f is smooth and its
/// Jacobian right, Newton's iteration fails in few attempts. With a wrong one many attempts are rejected: those whose
/// iteration fails, and those that a far-off iteration which has been believed leaves with a large error.
template <class Scalar>
constexpr const char* doubt(status s, const report<Scalar>& r) {
    const long attempts = r.steps + r.rejected(), few = 10;
    if (r.found.jacobian == jacobian_source::member && r.rejected_newton > few &&
        3 * r.rejected() > attempts && 7 * r.rejected_newton > attempts)
        return "more than a third of the attempts were rejected, and Newton's iteration failed in more than "
               "a seventh: look "
               "at problem.jacobian(), or compare with a run without it";
    if (s == status::too_many_steps && r.rejected() > few && 3 * r.rejected() > attempts &&
        1000000 * r.smallest_step < r.largest_step)
        return "more than a third of the attempts were rejected, and steps became tiny: f may switch "
               "in every step; make the switch an event (observe/event.hpp), or smooth it";
    return "";
}

/// Prints how a run ended and what it cost.
template <class Vector>
std::ostream& print(std::ostream& out, const result<Vector>& r) {
    out << name(r.status) << " at t = " << r.t << ": " << reason(r.status) << '\n';
    for (const char* what :
         {advice(r.status, r.report), linear_advice(r.status, r.report), doubt(r.status, r.report)})
        if (*what) out << what << '\n';
    return print(out, r.report);
}

/// The stream is missing.
template <class Scalar>
void print(const report<Scalar>&) {
    static_assert(detail::never<Scalar>, "print: write the stream as well, print(std::cout, r.report)");
}
template <class Vector>
void print(const result<Vector>&) {
    static_assert(detail::never<Vector>, "print: write the stream as well, print(std::cout, r)");
}

/// Prints where the time went, in seconds and parts of the whole.
inline std::ostream& print(std::ostream& out, const time_split& s) {
    const detail::stream_format kept(out);
    const auto line = [&](const char* what, double seconds) {
        out << std::left << std::setw(16) << what << std::right << std::scientific << std::setprecision(2)
            << std::setw(10) << seconds << " s" << std::fixed << std::setprecision(1) << std::setw(7)
            << (s.total > 0 ? 100 * seconds / s.total : 0.0) << " %\n";
    };
    line("f", s.f);
    line("Jacobian", s.jacobian);
    line("factorisation", s.factorisation);
    line("solves", s.solves);
    line("rest", s.rest());
    line("total", s.total);
    return out;
}

}  // namespace stagecraft
