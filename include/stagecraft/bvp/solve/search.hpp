// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/equations/collocation_equations.hpp>
#include <stagecraft/bvp/equations/guess.hpp>
#include <stagecraft/bvp/equations/trajectory.hpp>
#include <stagecraft/bvp/judge/mesh_judge.hpp>
#include <stagecraft/bvp/judge/mesh_points.hpp>
#include <stagecraft/bvp/measure/error_estimate.hpp>
#include <stagecraft/bvp/measure/finer_meshes.hpp>
#include <stagecraft/bvp/measure/largest_errors.hpp>
#include <stagecraft/bvp/measure/measurements.hpp>
#include <stagecraft/bvp/result.hpp>
#include <stagecraft/bvp/solve/damped_newton.hpp>
#include <stagecraft/bvp/solve/mesh_choice.hpp>
#include <stagecraft/problem/two_point_functions.hpp>

namespace stagecraft::detail {

/// One problem on its way to the solution: Newton's iteration on a coarse mesh, the errors, the next mesh, until
/// the tolerance holds or it is clear that it will not. It measures and acts; judge/mesh_judge.hpp decides.
///
/// Nothing here depends on the types of f, r and the guess: problems of the same sizes share one bvp_solver.
template <int S, class Vector, class Parameters>
class bvp_solver {
    using Scalar = typename Vector::Scalar;

  public:
    using functions = two_point_functions<Scalar, Vector::RowsAtCompileTime, Parameters::RowsAtCompileTime>;
    using guess_type = guess_view<Vector>;

  private:
    using equations_type = collocation_equations<functions, S>;
    using iterate = typename equations_type::iterate;
    using result_type = bvp_result<Vector, Parameters>;
    using evidence = mesh_evidence<Scalar>;
    using verdict = mesh_verdict<Scalar>;

  public:
    bvp_solver(const tableau<Scalar, S>& method, functions& problem, const Parameters& p,
               const bvp_options<Scalar>& o, int positions = 0)
        : o_(o),
          threshold_(o.atol > Scalar(0) ? Scalar(o.atol / o.rtol) : Scalar(1)),
          judge_({o.rtol, std::numeric_limits<Scalar>::epsilon(), o.max_intervals, o.adapt}),
          system_(problem),
          mass_(problem.mass()),
          equations_(method, system_, mass_, positions),
          elimination_(equations_, lifting_rule_of(method)),
          estimate_(equations_, elimination_, o.fixed_points),
          newton_(equations_, result_.report, threshold_),
          measured_(equations_, x_, elimination_, threshold_) {
        x_.p = p;
    }

    /// Looks whether the first equations are q' = v: in the middle, near the guess. From then on they are taken for it, and
    /// run() throws not_of_second_order where another evaluation of f shows that they are not.
    void look_for_second_order(const guess_type& guess, const Scalar& a, const Scalar& b) {
        if (!mass_.identity()) return;
        try {
            equations_.look_for_second_order((a + b) / 2, guess((a + b) / 2), x_.p);
        } catch (...) {
        }  // run() says what is wrong with f
    }
    bool of_second_order() const { return equations_.positions() > 0; }
    /// Where Newton's iteration fails from the guess, it begins at zero and on a trajectory as well. Not for orbits, whose
    /// guess is not to be left for a point.
    void try_other_guesses() { other_guesses_ = guesses_elsewhere; }
    /// Has it evaluated f more often than further trials are worth?
    bool dear() const {
        return system_.counts().f > mesh_judge<Scalar>::most_work * static_cast<long>(other_mesh_.size() - 1);
    }
    /// Adds the work of another solver of the same problem, which was given up.
    void count_work_of(const bvp_solver& other) { result_.report = other.result_.report; }

    result_type run(const guess_type& guess, const Scalar& a, const Scalar& b) {
        guess_mesh_ = other_mesh_ = first_mesh(o_, a, b, usual_intervals);
        trial_ = o_.intervals == 0 && o_.mesh.empty() && o_.adapt;
        begin(guess, trial_ ? first_mesh(o_, a, b, trial_intervals) : guess_mesh_);
        try {
            search(guess);
        } catch (const bad_problem&) {
            throw;
        } catch (const not_of_second_order&) {
            throw;
        } catch (const size_change&) {
            end(bvp_status::size_changed, "f or r resized its output");
        } catch (...) {
            end(bvp_status::function_threw, "f or r threw an exception");
            result_.exception = std::current_exception();
        }
        finish();
        return std::move(result_);
    }

    /// For what is built on a solution: its equations, linearised at it.
    equations_type& linearised() {
        equations_.resize(x_);
        equations_.linearise(x_);
        return equations_;
    }
    const iterate& solution_on_mesh() const { return x_; }
    /// The derivative of y at the mesh points and of p with respect to the value of a condition.
    iterate response(int condition) { return linearised().response(x_, condition); }
    /// The same problem on a mesh with every interval halved; false where Newton's iteration fails there.
    bool halve() {
        move_to(halved(x_.t));
        iterate_on_mesh();
        return converged() && estimate();
    }

  private:
    /// Without fast modes the intervals of the trial are mostly enough; where they are not, they cost little.
    static constexpr int usual_intervals = 10, trial_intervals = 6;
    /// Zero and a trajectory, on two meshes.
    static constexpr int guesses_elsewhere = 4;

    /// Newton on meshes that follow the error, coarse first.
    void search(const guess_type& guess) {
        if (trial_ && !slow_beside(x_, system_, equations_.s())) trial_ = false, begin(guess, guess_mesh_);
        for (;;) {
            evidence e = iterate_on_mesh();
            verdict v = judge_(e, history_);
            for (; v.act == mesh_act::measure; v = judge_(e, history_)) measure(v, e);
            history_.add(e, v, o_.rtol);
            if (v.act == mesh_act::finish || !go_on(v, guess)) return finish_with(v);
        }
    }
    /// The next mesh and x on it; false where that cannot be computed.
    bool go_on(const verdict& v, const guess_type& guess) {
        if (v.act == mesh_act::halve_last) return halve_last();
        if (v.act == mesh_act::usual_mesh)
            begin(guess, guess_mesh_);
        else if (v.act == mesh_act::finer_guess)
            begin(guess, guess_mesh_ = halved(guess_mesh_));
        else if (v.act == mesh_act::other_guess)
            begin_elsewhere(guess);
        else if (v.act == mesh_act::straight)
            begin(straight_between<Vector>(x_), next_), from_guess_ = false;
        else
            follow(next_);
        return true;
    }

    void begin(const guess_type& guess, const std::vector<Scalar>& mesh) {
        from_guess_ = true, at_zero_ = false;
        x_.t = mesh;
        take_guess(guess, system_.size(), equations_.method().c, x_);
        guess_size_ = threshold_ + x_.y.cwiseAbs().maxCoeff();
    }

    /// At zero with bold steps and the user's p, unless that is the guess or solves the problem; on the trajectory from the
    /// guess at a; then both on a mesh twice as fine.
    void begin_elsewhere(const guess_type& guess) {
        const int round = (guesses_elsewhere - other_guesses_) / 2;
        auto mesh = other_mesh_;
        for (int k = 0; k <= round && 2 * static_cast<int>(mesh.size() - 1) <= o_.max_intervals; ++k)
            mesh = halved(mesh);
        begin(guess, mesh);
        from_guess_ = false, tried_elsewhere_ = true;
        if (other_guesses_-- % 2 == 0) {
            at_zero_ = begin_at_zero();
            if (at_zero_) return;
            --other_guesses_;
        }
        follow_trajectory<Vector>(system_, equations_.s(), x_);
    }
    bool begin_at_zero() {
        using std::sqrt;
        if (x_.y.isZero(0)) return false;
        before_ = x_;
        x_.y.setZero(), x_.Z.setZero();
        equations_.resize(x_);
        if (equations_.residual(x_) &&
            equations_.residual_size() > sqrt(std::numeric_limits<Scalar>::epsilon()) * guess_size_)
            return true;
        x_ = before_;
        return false;
    }

    bool bold() const { return tried_elsewhere_ && !from_guess_ ? at_zero_ : judge_.bold(history_); }
    bool converged() const { return outcome_.end == damped_newton_end::converged; }
    evidence iterate_on_mesh() {
        ++result_.report.meshes;
        measured_.forget();
        outcome_ = newton_.run(x_, judge_.newton_target(history_), o_.newton_iterations, bold());
        remainder_ = outcome_.remainder;
        evidence e;
        e.newton = outcome_.end, e.converged = converged();
        e.remainder = outcome_.remainder, e.linear = newton_.linear();
        e.changes = newton_.nonlinear();
        e.guess_intervals = static_cast<int>(guess_mesh_.size()) - 1;
        e.intervals = x_.intervals(), e.unknowns = equations_.n() + equations_.np();
        e.trial = std::exchange(trial_, false), e.from_guess = from_guess_, e.guess_size = guess_size_;
        e.other_guesses = other_guesses_;
        e.dear = dear();
        e.differences = system_.differences, e.no_mass = mass_.identity();
        return e;
    }

    void measure(const verdict& v, evidence& e) {
        switch (v.missing) {
            case quantity::unresolved:
                return e.set(v.missing, unresolved(equations_, x_, threshold_));
            case quantity::evaluable:
            case quantity::error:
            case quantity::jumps:
                return measure_error(e);
            case quantity::next_intervals:
                next_ = mesh_of(v);
                return e.set(v.missing, Scalar(static_cast<int>(next_.size()) - 1));
            case quantity::singular_end: {
                auto ends = choice();
                return e.set(v.missing, Scalar(ends.begins_singular() || ends.ends_singular() ? 1 : 0));
            }
            case quantity::halved_kappa:
                return e.set(v.missing, halved_kappa());
            case quantity::full_size: {
                const bool solves = measured_.fundamental().full_step(guess_size_, full_);
                return e.set(v.missing, solves ? Scalar(full_.y.cwiseAbs().maxCoeff())
                                               : std::numeric_limits<Scalar>::infinity());
            }
            case quantity::full_norm:
                x_ = full_;
                if (!equations_.linearise(x_)) return e.set(v.missing, Scalar(-1));
                measured_.forget();
                measured_.conditioning().fundamental();
                return e.set(v.missing, measured_.conditioning().norm(Scalar(0)));
            default:
                measured_.measure(v.missing, e, o_.rtol);
        }
    }

    /// The error of x. Where it is within the tolerance verdicts follow, which are those of the problem linearised at the
    /// solution: with new factors where those at hand are of an iterate too far from it for the condition number found.
    void measure_error(evidence& e) {
        bool known = estimate();
        if (known && (error_ <= o_.rtol || !o_.adapt) && refresh()) known = estimate();
        e.converged = converged(), e.linear = newton_.linear();
        e.set(quantity::evaluable, Scalar(known ? 1 : 0));
        e.set(quantity::error, known ? error_ : std::numeric_limits<Scalar>::infinity());
        const auto& marks = estimate_.jumps();
        e.set(quantity::jumps, Scalar(std::find(marks.begin(), marks.end(), 1) == marks.end() ? 0 : 1));
    }
    bool refresh() {
        constexpr double harmless_change = 1e-3;  // of M, by the distance of x from where its factors are
        if (newton_.linear() ||
            !(newton_.moved() * std::max(Scalar(1), relative_kappa()) > Scalar(harmless_change)) ||
            !equations_.linearise(x_))
            return false;
        ++result_.report.factorisations;
        measured_.forget();
        return true;
    }
    Scalar relative_kappa() {
        measured_.conditioning().fundamental();
        return measured_.conditioning().relative(threshold_);
    }
    /// The errors of x, and what Newton's iteration has left, which is to be a tenth of that.
    bool estimate() {
        constexpr int most_passes = 3;
        constexpr int of_tolerance = 20, of_error = 10;  // parts that the remainder may have of them
        constexpr int safety = 4;                        // of Newton's own estimate of the remainder
        // Errors far above the tolerance need not be known as well as what is accepted.
        bool closely = !o_.adapt || resolves(equations_, x_, threshold_, o_.rtol);
        for (int pass = 1;; ++pass) {
            ++result_.report.error_solves;
            do {
                if (!estimate_.run(x_, threshold_, negligible(), closely)) return false;
                error_ = largest_errors(estimate_, x_, threshold_, result_.error);
            } while (error_ <= o_.rtol && !std::exchange(closely, true));
            const Scalar wanted = std::max(Scalar(o_.rtol / of_tolerance), Scalar(error_ / of_error));
            if (remainder_ <= wanted || pass == most_passes) break;
            measured_.forget();
            outcome_ = newton_.run(x_, wanted / safety, o_.newton_iterations);
            if (!converged()) break;
            remainder_ = outcome_.remainder;
        }
        error_ += remainder_;
        return true;
    }
    /// Errors below this part of the tolerance need not be known.
    Scalar negligible() const { return o_.rtol / 100; }

    Scalar halved_kappa() {
        ++result_.report.factorisations;
        equations_type finer(equations_.method(), system_, mass_, equations_.positions());
        return condition_on(finer, estimate_.on(halved(x_.t), x_), elimination_.shared_lifting(), threshold_);
    }

    mesh_choice<equations_type> choice() { return {equations_, estimate_, x_, o_}; }
    std::vector<Scalar> mesh_of(const verdict& v) {
        if (v.planned == mesh_act::resolve) return choice().resolving(halved(x_.t));
        if (v.planned == mesh_act::spread || v.planned == mesh_act::straight) return choice().spread();
        return choice().refined(error_, threshold_, v.doubled, v.divide);
    }
    /// Where the errors are large, the collocation polynomial is a better start than what was to correct it.
    void follow(const std::vector<Scalar>& mesh) {
        before_ = x_;
        if (judge_.rough(error_)) estimate_.unlift(x_);
        move_to(mesh);
    }
    void move_to(const std::vector<Scalar>& t) { x_ = estimate_.on(t, x_), from_guess_ = false; }
    bool halve_last() {
        const auto finer = halved(x_.t);
        x_ = before_;
        equations_.resize(x_);
        measured_.forget();
        if (!equations_.linearise(x_) || !estimate_.run(x_, threshold_, negligible())) return false;
        move_to(finer);
        return true;
    }
    void finish_with(const verdict& v) {
        end(v.status, v.at_place ? where_not_finite() : words_of(v));
        if (v.status == bvp_status::newton_failed && tried_elsewhere_)
            result_.message +=
                "; nor from zero or a trajectory: try a guess nearer to the solution, shooting(), or "
                "continuation() from a problem that is solved";
        if (!v.family) return;
        if (!converged()) x_ = full_;
        equations_type own(equations_.method(), system_, mass_, equations_.positions());
        const bool usable = estimate_.run(x_, threshold_, negligible());
        result_.kernel = kernel_dimension(
            own, [&](const std::vector<Scalar>& t) { return estimate_.on(t, x_); }, x_,
            elimination_.shared_lifting(), threshold_, newton_.linear(), usable ? o_.max_intervals : 0);
    }
    void end(bvp_status status, const std::string& message) {
        result_.status = status;
        result_.message = message;
    }
    std::string where_not_finite() const {
        if (!converged() && equations_.conditions_at_fault())
            return "the conditions r gave NaN or infinity, or left a number unwritten";
        const Scalar& t = converged() ? estimate_.place() : equations_.place();
        const auto& c = equations_.method().c;
        const bool first = t == x_.t.front() && c[0] == Scalar(0),
                   last = t == x_.t.back() && c[c.size() - 1] == Scalar(1);
        return not_finite_at(t, first || last);
    }
    void finish() {
        auto& r = result_.report;
        r.intervals = x_.intervals();
        r.f = system_.counts().f, r.f_jacobian = system_.counts().f_jacobian;
        r.jacobians = system_.counts().jacobians;
        result_.p = x_.p, result_.mesh = x_.t;
        const bool known = converged() && result_.status != bvp_status::non_finite;
        result_.error.global = error_;
        if (!known) result_.error.forget(system_.size(), system_.parameters());
        if (!usable()) return;
        const bool estimated = converged() && estimate_.knows(x_.intervals());
        if (estimated || estimate_.run(x_, threshold_, negligible())) {
            result_.error.defect = estimate_.defect(x_);
            estimate_.write(x_, result_.y);
        }
        auto& conditioning = measured_.conditioning();
        if (o_.conditioning) result_.conditioning = conditioning.run();
        r.conditioning_solves = conditioning.solves();
    }
    /// Can f be evaluated along x, and are there factors?
    bool usable() const {
        return result_.status != bvp_status::non_finite && result_.status != bvp_status::function_threw &&
               result_.status != bvp_status::size_changed && outcome_.end != damped_newton_end::non_finite;
    }

    bvp_options<Scalar> o_;
    Scalar threshold_;  ///< values below it count as if they were of that size: atol/rtol
    mesh_judge<Scalar> judge_;
    mesh_history<Scalar> history_;
    result_type result_;
    functions& system_;
    optional_mass<Scalar> mass_;
    equations_type equations_;
    lifting_elimination<equations_type> elimination_;
    error_estimate<equations_type> estimate_;
    damped_newton<equations_type> newton_;
    iterate x_, before_, full_;
    measurements<equations_type> measured_;
    std::vector<Scalar> guess_mesh_, other_mesh_, next_;
    int other_guesses_ = 0;
    bool at_zero_ = false, tried_elsewhere_ = false;
    damped_newton_outcome<Scalar> outcome_{damped_newton_end::failed, Scalar(0)};
    Scalar error_{std::numeric_limits<Scalar>::infinity()}, remainder_{0}, guess_size_{1};
    bool trial_ = false, from_guess_ = true;
};

}  // namespace stagecraft::detail
