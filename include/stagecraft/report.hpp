// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace stagecraft {

/// Where a run had its Jacobian from; none where no stage is implicit.
enum class jacobian_source { none, member, automatic_differentiation, differences };

/// The optional members of a problem besides its jacobian (problem/capabilities.hpp).
enum class capability {
    mass,
    index,
    constant_jacobian,
    second_order_components,
    bandwidth,
    sparsity,
    matrix,
    linear_solver,
    add_up,
    measure,
    break_points,
    domain
};

/// The optional members that a run found in its problem; one that is misspelt is missing here.
struct found_capabilities {
    jacobian_source jacobian = jacobian_source::none;

    constexpr bool has(capability c) const { return (members_ >> static_cast<int>(c)) % 2 != 0; }
    constexpr void add(capability c) { members_ |= 1u << static_cast<int>(c); }

  private:
    unsigned members_ = 0;
};

/// Why a linear solver that iterates has failed.
enum class unsolved_because : unsigned char {
    nothing,             ///< it has not
    slow,                ///< the iterations that are allowed were not enough
    zero_diagonal,       ///< the same, and its incomplete factorisation met zeros on the diagonal
    bad_preconditioner,  ///< the preconditioner gave NaN, infinity or zeros
};

/// What a run cost, and what it was told: plain counts, filled by every integrator.
/// `steps` counts accepted steps; an attempt that is repeated counts once in `rejected_error` (error test, or
/// growth that the step would pass over, judge/guards/growth_watch.hpp) or
/// `rejected_newton` (stage equations not solved, singular matrix or non-finite values).
/// `f` counts evaluations of the right-hand side outside of the Jacobian, `f_jacobian` those that finite
/// differences or automatic differentiation spent on it, or on its products with vectors (problem/matrix_free.hpp):
/// together these are all calls of f. Of a problem in two parts (problem/split.hpp) `f` counts both, `f_explicit` and
/// `f_implicit` each by itself. A factorisation is one set of real and complex
/// blocks; `solves` counts such sets as well (one per Newton iteration), `error_solves` those of the error
/// estimate. Diagonally implicit methods iterate stage by stage, so a set of theirs is one system of size n.
/// `linear_iterations` counts those of linear solvers that iterate, `linear_failures` the systems which these could not
/// solve, and `linear_trouble` says why, of the last one.
template <class Scalar>
struct report {
    long steps = 0;
    long rejected_error = 0;
    long rejected_newton = 0;
    long f = 0;
    long f_explicit = 0, f_implicit = 0;  ///< of split(f_explicit, f_implicit); else 0
    long f_jacobian = 0;
    long jacobians = 0;
    long factorisations = 0;
    long solves = 0;
    long error_solves = 0;
    long linear_iterations = 0;
    long linear_failures = 0;
    long clipped = 0;      ///< components set to zero by nonnegative(problem, {.clip = true})
    long at_rounding = 0;  ///< accepted steps with an error that is rounding (judge/guards/rounding.hpp)
    Scalar smallest_step = Scalar(0);  ///< in absolute value, over accepted steps
    Scalar largest_step = Scalar(0);
    int largest_stages = 0;  ///< largest and smallest number of stages used by an accepted step
    int smallest_stages = 0;
    /// Of status::inconsistent_start: the equation that is farthest off (counted from 0; of a combination, the one of
    /// largest coefficient), what it leaves, and how many tolerances of all components make as much.
    int unmet_equation = -1;
    unsolved_because linear_trouble = unsolved_because::nothing;
    bool default_atol = false;  ///< steps are chosen by the atol of options nobody has set
    Scalar unmet_rest = Scalar(0), unmet_tolerances = Scalar(0);
    found_capabilities found{};
    Scalar rtol = Scalar(0), atol = Scalar(0);  ///< of the options; atol is 0 where it was given by component

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(steps, rejected_error, rejected_newton, f, f_explicit, f_implicit, f_jacobian, jacobians,
            factorisations, solves, error_solves, linear_iterations, linear_failures, clipped, at_rounding,
            linear_trouble);
        bag(smallest_step, largest_step, largest_stages, smallest_stages);
    }

    long rejected() const { return rejected_error + rejected_newton; }

    /// Takes in the tolerances of the options.
    template <class Options>
    void set_tolerances(const Options& o) {
        rtol = o.rtol;
        atol = o.atol_components.size() > 0 ? Scalar(0) : o.atol;
        default_atol = atol == Options{}.atol && o.fixed_step == Scalar(0);
    }
    /// Takes in a run that goes on from this one.
    void add(const report& more) {
        const report first = *this;
        *this = more;
        if (first.steps == 0) return;
        steps += first.steps, rejected_error += first.rejected_error,
            rejected_newton += first.rejected_newton;
        f += first.f, f_explicit += first.f_explicit, f_implicit += first.f_implicit;
        f_jacobian += first.f_jacobian, jacobians += first.jacobians;
        factorisations += first.factorisations, solves += first.solves, error_solves += first.error_solves;
        linear_iterations += first.linear_iterations, linear_failures += first.linear_failures;
        clipped += first.clipped, at_rounding += first.at_rounding;
        if (more.steps == 0 || first.smallest_step < smallest_step) smallest_step = first.smallest_step;
        if (first.largest_step > largest_step) largest_step = first.largest_step;
        if (more.steps == 0 || first.smallest_stages < smallest_stages)
            smallest_stages = first.smallest_stages;
        if (first.largest_stages > largest_stages) largest_stages = first.largest_stages;
    }
    /// Takes in an accepted step of magnitude h by a method of so many stages.
    void count_step(const Scalar& h, int stages) {
        if (steps == 0 || h < smallest_step) smallest_step = h;
        if (h > largest_step) largest_step = h;
        if (steps == 0 || stages < smallest_stages) smallest_stages = stages;
        if (stages > largest_stages) largest_stages = stages;
        ++steps;
    }
};

}  // namespace stagecraft
