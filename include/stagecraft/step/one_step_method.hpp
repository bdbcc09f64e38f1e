// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <stdexcept>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/linear/norms.hpp>
#include <stagecraft/stages/newton.hpp>

// What the integrator asks of a method: the concept, and defaults for what a method need not say.

namespace stagecraft {

/// Where the steps of a run live: states of type Vector, the columns that a continuous solution may need
/// (`dynamic`: known at run time), and the solvers of the linear systems (problem/capabilities.hpp).
template <class Vector, int Columns, class Blocks>
struct step_space {
    using vector = Vector;
    using scalar = typename Vector::Scalar;
    using blocks = Blocks;
    using output = dense_output<Vector, Columns>;
    static constexpr int columns = Columns;
};

/// What a run asks of its method beforehand.
struct run_demands {
    bool fixed = false;  ///< equal steps: errors are not estimated
    bool output = true;  ///< somebody will look at the continuous solution
    bool jumps = true;   ///< jumps of f are looked for that the error estimate does not see
};

/// A method as the integrator sees it: an object that makes one step at a time and keeps nothing from step to
/// step but slopes that the next one begins with. Models: collocation_step, tableau_step.
///
/// Notation: m the method, t, y, h the step, y1 the state at its end, norm that of the tolerance, `now` an
/// output (its increments are z_i = Y_i - y), s the stages. Vectors have size n. Nothing allocates.
///
/// Expression, meaning, and cost of those that are made in every step:
///   - m.prepare(system, demands): once, before all others; std::invalid_argument where it cannot serve them.
///   - m.stages(): the solver of the stage equations, with factor(system, h) -> bool and
///     solve(system, t, y, h, norm, limits, Z, solves) -> newton_outcome.
///   - m.method(), m.order(): its tableau and its order, by which a checkpoint knows it again.
///   - m.count(): s. m.coupled_stages_count(): how many of them one Newton iteration solves for.
///   - m.columns(): columns of increments that an output needs.
///   - m.implicit(): false if no stage needs a Jacobian. m.stiffly_accurate(): y1 is the last stage.
///   - m.has_stage_order_two(): C(2) holds.
///   - m.estimate_power(): q, the estimate is O(h^q).
///   - m.estimate_ratio(rtol): the estimate times this has tolerance 1 where the solution is smooth.
///   - m.guess(before, y, h, now, from): first guess of the stages by the step before (or null); s^2 n.
///   - m.advance(y, now, y1): y1 := the new state; s n.
///   - m.estimate(system, h, f0, now, e): e := the estimate, f0 = f(t, y); returns the solves made, 0 or 1.
///   - m.error_size(system, now, r, e, solves, size): the size of e times r, or more where the order is
///     reduced; size(x, reduced) measures a vector; up to four solves, which it counts.
///   - m.finish(t, y, h, y1, now): the step is accepted, now := its continuous solution; s^2 n.
///
/// Everything else may be left to step_defaults, from which a model derives; its docstrings say what it means.
template <class Step, class System>
concept one_step_method = requires(
    Step& m, const Step& c, System& system, const run_demands& demands, const typename Step::vector& x,
    typename Step::vector& out, const typename Step::vector::Scalar& h, const typename Step::output* before,
    typename Step::output& now, const weighted_root_mean_square<typename Step::vector>& norm,
    const newton_limits<typename Step::vector::Scalar>& limits, long& solves,
    typename Step::vector::Scalar (*size)(const typename Step::vector&, bool reduced)) {
    m.prepare(system, demands);
    { m.stages().factor(system, h) } -> std::same_as<bool>;
    {
        m.stages().solve(system, h, x, h, norm, limits, now.increments(), solves)
        } -> std::same_as<newton_outcome<typename Step::vector::Scalar>>;
    c.method().c[0];
    { c.order() } -> std::same_as<int>;
    { c.count() } -> std::same_as<int>;
    { c.coupled_stages_count() } -> std::same_as<int>;
    { c.columns() } -> std::same_as<int>;
    { c.implicit() } -> std::same_as<bool>;
    { c.stiffly_accurate() } -> std::same_as<bool>;
    { c.has_stage_order_two() } -> std::same_as<bool>;
    { c.estimate_power() } -> std::same_as<int>;
    { c.estimate_ratio(h) } -> std::convertible_to<typename Step::vector::Scalar>;
    m.guess(before, x, h, now, h);
    m.advance(x, now, out);
    m.finish(h, x, h, x, now);
    { m.estimate(system, h, x, now, out) } -> std::same_as<int>;
    { m.error_size(system, now, h, x, solves, size) } -> std::convertible_to<typename Step::vector::Scalar>;
    // What step_defaults has for all.
    { c.iterates() } -> std::same_as<bool>;
    { c.needs_left_value(true) } -> std::same_as<bool>;
    { c.needs_right_value() } -> std::same_as<bool>;
    { c.ends_with_value() } -> std::same_as<bool>;
    m.begin(x);
    m.end(x);
    m.end_without_value(h, x, x);
    m.accepted();
    m.replaced();
    { c.forgets() } -> std::same_as<bool>;
    { c.estimates_from_start() } -> std::same_as<bool>;
    { m.estimate_again(system, h, x, h, now, out, out) } -> std::same_as<int>;
    { m.estimate_right(system, h, x, now, out) } -> std::same_as<int>;
    { m.solve_for_defect(system, h, out) } -> std::same_as<int>;
    m.compare_with_start(system, now, h, out);
    m.without_start(system, now, out);
    { m.right_ratio(h) } -> std::convertible_to<typename Step::vector::Scalar>;
    { m.jump_ratio(h) } -> std::convertible_to<typename Step::vector::Scalar>;
    { c.knows_output_error() } -> std::same_as<bool>;
    { m.output_error(now, norm) } -> std::convertible_to<typename Step::vector::Scalar>;
    { c.sees_constant_slope(now) } -> std::same_as<bool>;
    { c.blind_spot_count() } -> std::same_as<int>;
    { c.blind_spot_power() } -> std::same_as<int>;
    { c.knows_slopes() } -> std::same_as<bool>;
    c.weigh_slopes(0, h, out);
    { m.damp(system, out) } -> std::same_as<bool>;
};

/// What the choice among several methods asks besides: how fast the Legendre coefficients of the stage polynomial fall, and
/// what a step costs without its linear systems and they by themselves (judge/order.hpp).
template <class Step, class System>
concept variable_order_method = one_step_method<Step, System> &&
    requires(Step& m, System& system, const typename Step::output& now,
             const weighted_root_mean_square<typename Step::vector>& norm) {
    { m.decay(now, norm) } -> std::convertible_to<typename Step::vector::Scalar>;
    m.stages().work(1).iteration;
    m.stages().linear_work(system).per_stage;
};

/// What a method need not say. A model hides what it knows better.
template <class Space>
class step_defaults {
  public:
    using vector = typename Space::vector;
    using scalar = typename Space::scalar;
    using output = typename Space::output;

    /// False if all stages are explicit, so that solve() asks nothing of its limits and tells nothing of an iteration.
    static constexpr bool iterates() { return true; }

    // Values of f at the ends of the step.

    /// True if the next step uses f(t, y), for its stages or (unless `fixed`) its estimate.
    static constexpr bool needs_left_value(bool /*fixed*/) { return false; }
    /// An attempt begins: f0 = f(t, y) where needs_left_value().
    static void begin(const vector& /*f0*/) {}
    /// True if f(t1, y1) is asked for before the step is judged.
    static constexpr bool needs_right_value() { return false; }
    /// True if the continuous solution uses f(t1, y1): then end() is called with it, or, where it is not
    /// finite, end_without_value().
    static constexpr bool ends_with_value() { return false; }
    static void end(const vector& /*f1*/) {}
    static void end_without_value(const scalar& /*h*/, const vector& /*y*/, const vector& /*y1*/) {}
    /// The step has been accepted, all of it done.
    static void accepted() {}
    /// y1 has been replaced: what was kept of it for the next step is not valid.
    static void replaced() {}
    /// True if y1 is to be moved onto the constraints by end_on_constraints() before the next step.
    static constexpr bool ends_off_constraints() { return false; }
    template <class System>
    static int end_on_constraints(const System&, const scalar& /*h*/, const vector& /*f1*/, output&,
                                  vector& /*y1*/) {
        return 0;
    }
    /// False if |R(infinity)| is one: what a step leaves in algebraic components stays for ever.
    static constexpr bool forgets() { return true; }
    /// bag(...) with what is kept for the next step (checkpoint.hpp).
    template <class Bag>
    static void carry(Bag&) {}

    // Further estimates. Each returns the number of solves made, 0 where there is none.

    /// The estimate once more filtered, for the first step and after a rejection; f is scratch.
    template <class System>
    static int estimate_again(System&, const scalar& /*t*/, const vector& /*y*/, const scalar& /*h*/,
                              const output&, vector& /*f*/, vector& /*error*/) {
        return 0;
    }
    /// d := (M/(h a) - J)^-1 d with an a of the method's own: about what a defect d changes in the solution.
    template <class System>
    static int solve_for_defect(const System&, const scalar& /*h*/, vector& /*d*/) {
        return 0;
    }
    /// True if y1 is the last stage and the estimate compares the stages with the state at the start, also
    /// in components that hand nothing on from step to step.
    static constexpr bool estimates_from_start() { return false; }
    /// Then: what the comparison with that state adds to the estimate, `rest` times where no step hands it on.
    template <class System>
    static void compare_with_start(const System&, const output&, const scalar& /*rest*/, vector& /*error*/) {}
    /// In the repeated first step: what the estimate owes to components of index 2 and 3 at the start, which
    /// need not be consistent, is replaced.
    template <class System>
    static void without_start(const System&, const output&, vector& /*error*/) {}
    /// An estimate that uses f1 = f(t1, y1). Called where needs_right_value().
    template <class System>
    static int estimate_right(const System&, const scalar& /*h*/, const vector& /*f1*/, const output&,
                              vector& /*error*/) {
        return 0;
    }
    /// What that one stands for where the other stands for `ratio`.
    static const scalar& right_ratio(const scalar& ratio) { return ratio; }

    // The continuous solution.

    /// True if output_error(now, norm) bounds its error between the ends.
    static constexpr bool knows_output_error() { return false; }
    template <class Norm>
    static scalar output_error(const output&, const Norm&) {
        return scalar(0);
    }

    // Jumps of f (judge/guards/jumps.hpp).

    /// True if some component of y' is found to be the same at all nodes of the step, and not zero.
    static bool sees_constant_slope(const output&) { return false; }

    /// What an estimate of 1 stands for across a jump of f, `smooth` where there is none.
    static const scalar& jump_ratio(const scalar& smooth) { return smooth; }
    /// How many combinations of the slopes see jumps that the estimate does not (method/blind_spots.hpp), and the power
    /// of h by which they fall where f is smooth.
    static constexpr int blind_spot_count() { return 0; }
    static constexpr int blind_spot_power() { return 0; }
    /// True if the slopes are known that these ask for.
    static constexpr bool knows_slopes() { return false; }
    /// x := h times combination number g.
    static void weigh_slopes(int /*g*/, const scalar& /*h*/, vector& /*x*/) {}
    /// Damps stiff components of x by (M - h a J)^-1 M; false where there is no such filter.
    template <class System>
    static bool damp(const System&, vector& /*x*/) {
        return false;
    }
};

/// Throws std::invalid_argument where the method cannot serve steps that are not equal, with components of that
/// index, and with errors between the ends of the steps controlled as well (`continuous`).
template <class Step>
void demand_free_steps(const Step& m, int largest_index, bool continuous) {
    if (largest_index > 1 && !m.forgets())  // HLR89, section 4
        throw std::invalid_argument(
            "integrate: method must have |R(infinity)| < 1 for problem.index() 2 "
            "and 3, whose errors it would keep for ever; use options.fixed_step");
    if (largest_index > 2 && !m.stiffly_accurate())
        throw std::invalid_argument(
            "integrate: method must be stiffly accurate for problem.index() 3, "
            "where the errors of others have no bound; use options.fixed_step");
    // What a step of stage order q leaves in u is O(h^{q-1}) (HLR89, section 6). Implicit Euler's u converges if all steps
    // are equal, since then what z leaves, divided by h, is the same in every step and cancels.
    if (largest_index > 2 && !m.has_stage_order_two())
        throw std::invalid_argument(
            "integrate: method must have stage order 2 at least, sum_j a_ij c_j = c_i^2/2 in every stage, "
            "for problem.index() 3: with less, components of index 3 do not converge; take radau_iia<3>() or "
            "radau_iia_variable(), a formulation of index 2, or options.fixed_step");
    if (continuous && !m.knows_output_error())
        throw std::invalid_argument(
            "integrate: continuous needs a transformed_tableau of two stages at least, other than Radau IA");
}

}  // namespace stagecraft
