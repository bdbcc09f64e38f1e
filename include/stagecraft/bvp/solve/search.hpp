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
#include <stagecraft/bvp/equations/mesh.hpp>
#include <stagecraft/bvp/measure/conditioning.hpp>
#include <stagecraft/bvp/measure/contradiction.hpp>
#include <stagecraft/bvp/measure/error_estimate.hpp>
#include <stagecraft/bvp/measure/finer_meshes.hpp>
#include <stagecraft/bvp/measure/largest_errors.hpp>
#include <stagecraft/bvp/result.hpp>
#include <stagecraft/bvp/solve/damped_newton.hpp>
#include <stagecraft/bvp/solve/mesh_choice.hpp>
#include <stagecraft/problem/two_point.hpp>

namespace stagecraft::detail {

/// One problem on its way to the solution: Newton's iteration on a coarse mesh, the errors, the next mesh, until
/// the tolerance holds or it is clear that it will not.
template <class Scalar, int S, class Problem, class Vector, class Parameters>
class bvp_solver {
    using system_type = two_point_system<Problem, Vector, Parameters>;
    using equations_type = collocation_equations<system_type, S>;
    using iterate = typename equations_type::iterate;
    using result_type = bvp_result<Vector, Parameters>;

  public:
    bvp_solver(const tableau<Scalar, S>& method, Problem& problem, int n, const Parameters& p,
               const bvp_options<Scalar>& o, int positions = 0)
        : o_(o),
          floor_(o.atol > Scalar(0) ? Scalar(o.atol / o.rtol) : Scalar(1)),
          system_(problem.f, problem.r, n, static_cast<int>(p.size()), counts_),
          mass_(make_mass<Scalar>(problem.f, n)),
          equations_(method, system_, mass_, positions),
          elimination_(equations_, lifting_rule_of(method)),
          estimate_(equations_, elimination_, o.fixed_points),
          newton_(equations_, result_.report, floor_) {
        x_.p = p;
    }

    /// Looks whether the first equations are q' = v: in the middle, near the guess. From then on they are taken for it, and
    /// run() throws not_of_second_order where another evaluation of f shows that they are not.
    template <class Guess>
    void look_for_second_order(const Guess& guess, const Scalar& a, const Scalar& b) {
        if (!decltype(mass_)::identity) return;
        try {
            equations_.look_for_second_order((a + b) / 2, guess_value(guess, (a + b) / 2), x_.p);
        } catch (...) {
        }  // run() says what is wrong with f
    }
    bool of_second_order() const { return equations_.positions() > 0; }
    /// Adds the work of another solver, which was given up.
    void count_work_of(const bvp_solver& other) {
        counts_ = other.counts_;
        result_.report = other.result_.report;
    }

    template <class Guess>
    result_type run(const Guess& guess, const Scalar& a, const Scalar& b) {
        // Without fast modes six intervals are mostly enough; where they are not, they cost little.
        few_ = o_.intervals == 0 && o_.mesh.empty() && o_.adapt;
        guess_mesh_ = first_mesh(o_, a, b, 10);
        begin(guess, few_ ? first_mesh(o_, a, b, 6) : guess_mesh_);
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

    /// For what is built on a solution: its equations, linearised at it, and the derivative of y at the mesh
    /// points and of p with respect to the value of a condition.
    equations_type& linearised() {
        equations_.resize(x_);
        equations_.linearise(x_);
        return equations_;
    }
    const iterate& solution_on_mesh() const { return x_; }
    iterate response(int condition) { return linearised().response(x_, condition); }
    /// The same problem on a mesh with every interval halved; false where Newton's iteration fails there.
    bool halve() { return move_to(halved(x_.t)), newton(error_) && estimate(); }

  private:
    template <class Guess>
    void begin(const Guess& guess, const std::vector<Scalar>& mesh) {
        from_guess_ = true;
        x_.t = mesh;
        take_guess(guess, system_.size(), equations_.method().c, x_);
        guess_size_ = floor_ + x_.y.cwiseAbs().maxCoeff();
    }

    /// Newton on meshes that follow the error, coarse first.
    template <class Guess>
    void search(const Guess& guess) {
        // The least error so far, and the meshes in a row that did not halve it: these double the mesh, so that
        // the loop ends by max_intervals even where the error is nothing but rounding and goes up and down. Those that
        // close in on a jump or a singularity do not: `stuck` counts meshes in a row that took no hundredth off.
        Scalar least = std::numeric_limits<Scalar>::infinity();
        int idle = 0, jumped = 0, stuck = 0;
        if (few_ && !slow_beside(x_, system_, equations_.s())) few_ = false, begin(guess, guess_mesh_);
        for (;;) {
            if (from_guess_) least = std::numeric_limits<Scalar>::infinity(), idle = 0;  // anew
            const bool few = std::exchange(few_, false), solved = newton(least),
                       estimated = solved && (!few || promising()) && estimate() &&
                                   (!(error_ <= o_.rtol || !o_.adapt) || !refresh() || estimate());
            if (few && !estimated) begin(guess, guess_mesh_);
            if (!few && !solved && !recover(guess)) return;
            if (!solved || (few && !estimated)) continue;
            if (!estimated) {  // between its points a coarse solution may lead to where f cannot be evaluated
                if (++failures_ > 6 || !o_.adapt) return end_at(estimate_.place());
                const auto next = mesh_choice<equations_type>(equations_, estimate_, x_, o_).spread();
                begin(straight_between<Vector>(x_), next), from_guess_ = false;
                continue;
            }
            if (!o_.adapt ||
                (error_ <= o_.rtol && converged() &&
                 (few ? settled() && regular_.resolved() : settled() || confirmed()) && !coincident())) {
                accept();
                if (!few || result_.ok()) return;
            }
            if (few && error_ <= o_.rtol) {  // nothing is refused because of what so few intervals show
                result_.status = bvp_status::newton_failed, result_.kernel = 0;
                last_kappa_ = Scalar(-1), checks_ = 0;
                begin(guess, guess_mesh_);
                continue;
            }
            before_ = x_;
            stuck = error_ < 99 * least / 100 ? 0 : stuck + 1;
            idle = error_ <= o_.rtol || error_ < least / 2 ? 0 : idle + 1;
            if ((idle > 1 || (idle == 1 && rounding_only())) && hopeless(error_)) return;
            if (stuck > 20)
                return end(bvp_status::tolerance_not_met, "the error stays, however the mesh is refined");
            least = std::min(least, error_);
            const auto& jumps =
                estimate_.jumps();  // in one mesh after the other: no layer is mistaken for one
            jumped = std::find(jumps.begin(), jumps.end(), 1) == jumps.end() ? 0 : jumped + 1;
            mesh_choice<equations_type> choice(equations_, estimate_, x_, o_);
            const bool spread = rough() && idle < 2;  // where spreading has stopped to help, errors decide
            const auto next = error_ <= o_.rtol ? choice.resolving(halved(x_.t))
                              : spread          ? choice.spread()
                                                : choice.refined(error_, floor_, idle > 0, jumped > 2);
            if (static_cast<int>(next.size()) - 1 > o_.max_intervals) {
                if (!hopeless(10 * error_))
                    end(bvp_status::too_many_intervals, "the tolerance asks for more than max_intervals");
                return;
            }
            if (rough()) estimate_.unlift(x_);
            move_to(next);
        }
    }

    /// A solution that is wrong in its first digit.
    bool rough() const { return !(error_ < Scalar(1) / 10); }
    /// An error of a linear problem that is what rounding makes; another one may be that of Newton's iteration.
    bool rounding_only() { return newton_.linear() && error_ < 10 * regular_.rounding_of_y(floor_); }
    bool converged() const { return outcome_.end == damped_newton_end::converged; }
    bool newton(const Scalar& expected) {
        ++result_.report.meshes;
        conditioning_.forget();
        const Scalar tight = o_.rtol / 50,
                     loose = std::min(Scalar(Scalar(1) / 10000), Scalar(expected / 100));
        outcome_ = newton_.run(x_, tight > loose || !o_.adapt ? tight : loose, o_.newton_iterations,
                               failures_ % 2 == 1);
        remainder_ = outcome_.remainder;
        return converged();
    }

    /// Verdicts are those of the problem linearised at the solution: new factors where those at hand are of an iterate
    /// too far from it for the condition number found.
    bool refresh() {
        if (newton_.linear() ||
            !(newton_.moved() * std::max(Scalar(1), relative_kappa()) > Scalar(1) / 1000) ||
            !equations_.linearise(x_))
            return false;
        ++result_.report.factorisations;
        conditioning_.forget();
        return true;
    }

    /// The errors of x, and its remainder below them.
    bool estimate() {
        // Errors far above the tolerance need not be known as well as what is accepted.
        bool closely = !o_.adapt || resolves(equations_, x_, floor_, o_.rtol);
        for (int pass = 0;; ++pass) {
            ++result_.report.error_solves;
            do {
                if (!estimate_.run(x_, floor_, o_.rtol / 100, closely)) return false;
                error_ = largest_errors(estimate_, x_, floor_, result_.error);
            } while (error_ <= o_.rtol && !std::exchange(closely, true));
            const Scalar wanted = std::max(Scalar(o_.rtol / 20), Scalar(error_ / 10));
            if (remainder_ <= wanted || pass > 1) break;
            conditioning_.forget();
            outcome_ = newton_.run(x_, wanted / 4, o_.newton_iterations);
            if (!converged()) break;
            remainder_ = outcome_.remainder;
        }
        error_ += remainder_;
        return true;
    }

    /// Can x be within the tolerance? A nonlinear one is a guess.
    bool promising() const { return !newton_.linear() || resolves(equations_, x_, floor_, o_.rtol); }
    void move_to(const std::vector<Scalar>& t) { x_ = estimate_.on(t, x_), from_guess_ = false; }

    /// After Newton has failed: a finer mesh, from the guess or from the last solution.
    template <class Guess>
    bool recover(const Guess& guess) {
        // Where f is not finite there are no factors, or those of another mesh.
        const bool finite = outcome_.end != damped_newton_end::non_finite;
        if (!finite && from_guess_) return end_where_not_finite(), false;
        if (finite && hopeless(outcome_.remainder)) return false;
        if (++failures_ > 6 || 2 * x_.intervals() > o_.max_intervals || !o_.adapt) {
            if (!finite) return end_where_not_finite(), false;
            end(bvp_status::newton_failed, "Newton's iteration found no decrease" +
                                               (failure_.empty() ? "" : "; at its last iterate " + failure_));
            return false;
        }
        if (before_.t.empty() || rough() || !finite) {
            begin(guess, guess_mesh_ = halved(guess_mesh_));
        } else {
            const auto finer = halved(x_.t);
            x_ = before_;
            equations_.resize(x_);
            conditioning_.forget();
            if (!equations_.linearise(x_) || !estimate_.run(x_, floor_, o_.rtol / 100)) return false;
            move_to(finer);
        }
        return true;
    }

    /// Is what is known of M as good as it has to be? Where this mesh does not show whether M is regular, or the condition
    /// number is so large that what the errors of x leave of M may be all there is, the mesh is halved until both stay. M of a
    /// linear problem does not depend on x: it is enough that its fundamental solutions are known to some digits.
    bool settled() {
        const Scalar kappa = relative_kappa(), last = last_kappa_;
        const auto within = [&](const Scalar& growth) {
            return kappa < growth * last && last < growth * kappa;
        };
        const bool unknown = regular_.unknown(floor_, newton_.linear() ? Scalar(0) : error_),
                   stays = within(Scalar(2)) || (within(Scalar(4)) && singular_end());
        if (last < Scalar(0)) first_kappa_ = kappa;
        last_kappa_ = kappa;
        vanishes_ = unknown || (regular_.resolved() && kappa > 10 * first_kappa_ && !singular_end());
        return (!unknown && (stays || kappa * o_.rtol < Scalar(1) / 100 ||
                             (newton_.linear() && regular_.doubt() < Scalar(1e-5)))) ||
               !o_.adapt || (!regular_.turns() && ++checks_ > 6) ||
               kappa * std::numeric_limits<Scalar>::epsilon() > Scalar(1) / 1000;
    }
    /// Where this mesh leaves it open by how much fundamental solutions are wrong, the mesh halved says whether the condition
    /// number stays: of a linear problem by its Jacobians, without its solution there.
    bool confirmed() {
        if (!newton_.linear() || (vanishes_ && regular_.resolved()) || 2 * x_.intervals() > o_.max_intervals)
            return false;
        ++result_.report.factorisations;
        equations_type finer(equations_.method(), system_, mass_, equations_.positions());
        return confirms_condition(finer, estimate_.on(halved(x_.t), x_), elimination_.shared_lifting(),
                                  floor_, last_kappa_);
    }
    /// Is it by chance that the condition number stays, which has grown to what the errors of a nonlinear x may make of it?
    bool coincident() const {
        return vanishes_ && checks_ <= 6 && !newton_.linear() && last_kappa_ * error_ > Scalar(1);
    }
    /// At a singular end point the answer of slopes to a value there goes with 1/h, and doubles with every mesh.
    bool singular_end() {
        mesh_choice<equations_type> choice(equations_, estimate_, x_, o_);
        return choice.begins_singular() || choice.ends_singular();
    }
    Scalar relative_kappa() { return conditioning_.fundamental(), conditioning_.relative(floor_); }
    /// Is an error that stays what rounding leaves, and no mesh will make it less?
    bool hopeless(const Scalar& error) {
        if (is_singular()) return true;
        const bool failed = !converged(), nonlinear = failed && regular_.nonlinear(guess_size_);
        if (regular_.unknown(floor_)) {
            if (failed && !nonlinear) end(bvp_status::singular, "M is singular as far as any mesh shows");
            return failed && !nonlinear;
        }
        if (!(error < 100 * rounding_) && (nonlinear || !(error < regular_.rounding_of_y(floor_))))
            return false;
        if (nonlinear) {
            // Near solutions that form a family M is as singular as x is close to them, which no two iterates are alike.
            const Scalar before = kappa_;
            if (!solved() || !equations_.linearise(x_)) return false;
            conditioning_.forget();
            find_kappa(Scalar(0));
            if (kappa_ > 2 * before || before > 2 * kappa_) return end_in_family(), true;
        }
        return end_by_rounding(), true;
    }

    void find_kappa(const Scalar& least) {
        conditioning_.fundamental();
        kappa_ = conditioning_.norm(least);
    }
    void end_in_family() {
        equations_type own(equations_.method(), system_, mass_, equations_.positions());
        const bool usable = estimate_.run(x_, floor_, o_.rtol / 100);
        result_.kernel = kernel_dimension(
            own, [&](const std::vector<Scalar>& t) { return estimate_.on(t, x_); }, x_,
            elimination_.shared_lifting(), floor_, newton_.linear(), usable ? o_.max_intervals : 0);
        const std::string which = dependent_condition(equations_.conditions());
        end(bvp_status::not_isolated, which.empty() ? "solutions form a family" : which);
    }

    /// M singular to rounding: says whether solutions exist. Where Newton's iteration of a nonlinear problem has failed, M is
    /// that of an iterate and says nothing of the problem.
    bool is_singular() {
        const Scalar least = Scalar(1) / (1000 * std::numeric_limits<Scalar>::epsilon());
        conditioning_.fundamental();
        rounding_ = conditioning_.rounding(floor_);
        find_kappa(std::min(Scalar(1000 * o_.rtol), Scalar(1)) * least);
        const bool large = !(kappa_ < least);
        if (!large && equations_.replaced_pivots() == 0) return false;
        // Of components as large as that, rounding errors may be as small as of others.
        if ((!large || (converged() && error_ <= o_.rtol && relative_kappa() < least &&
                        regular_.rounding(floor_) < Scalar(1) / 10000)) &&
            !answers_contradict(equations_, conditioning_, x_))
            return false;
        if (!large) find_kappa(Scalar(0));
        const std::string which = dependent_condition(equations_.conditions());
        const bool of_iterate = !converged() && regular_.nonlinear(guess_size_);
        if (which.empty() && !of_iterate && regular_.grows(floor_))
            return end(bvp_status::ill_conditioned, "kappa1 exceeds 1/(1000 epsilon): solutions grow"), true;
        if (solved()) return end_in_family(), true;
        failure_ = which.empty() ? "M is singular to rounding" : which;
        if (of_iterate) return false;
        return end(bvp_status::singular, failure_), true;
    }
    /// With M singular: does x solve the equations, at a size that is not 1 / epsilon?
    bool solved() {
        using std::sqrt;
        return (converged() || regular_.full_step(guess_size_)) &&
               x_.y.cwiseAbs().maxCoeff() < sqrt(kappa_) * guess_size_;
    }
    void accept() {
        if (is_singular()) return;
        if (vanishes_ && !o_.adapt) return end(bvp_status::tolerance_not_met, "the mesh does not show M");
        if (vanishes_ && checks_ > 6) return end_in_family();
        if (regular_.hidden(floor_, guess_size_))
            return end(bvp_status::ill_conditioned, "M is no larger than the errors of differences of f");
        // Every rounding error counts as large as it may be: what they come to is mostly less than a tenth of that.
        if ((rounding_ > o_.rtol && kappa_ * std::numeric_limits<Scalar>::epsilon() > o_.rtol) ||
            regular_.rounding_of_y(floor_) > 10 * o_.rtol ||
            conditioning_.spread(floor_) * std::numeric_limits<Scalar>::epsilon() > 1000 * o_.rtol)
            return end_by_rounding();
        if (error_ <= o_.rtol) return end(bvp_status::success, "");
        end(bvp_status::tolerance_not_met, "the error on the given mesh exceeds the tolerance");
    }
    void end_by_rounding() { end(bvp_status::ill_conditioned, "rounding errors exceed the tolerance"); }
    void end(bvp_status status, const std::string& message) {
        result_.status = status;
        result_.message = message;
    }
    void end_where_not_finite() {
        if (!equations_.conditions_at_fault()) return end_at(equations_.place());
        end(bvp_status::non_finite, "the conditions r gave NaN or infinity, or left a number unwritten");
    }
    void end_at(const Scalar& t) {
        const auto& c = equations_.method().c;
        const bool first = t == x_.t.front() && c[0] == Scalar(0),
                   last = t == x_.t.back() && c[c.size() - 1] == Scalar(1);
        end(bvp_status::non_finite, not_finite_at(t, first || last));
    }
    void finish() {
        auto& r = result_.report;
        r.intervals = x_.intervals();
        r.f = counts_.f, r.f_jacobian = counts_.f_jacobian;
        r.jacobians = counts_.jacobians;
        result_.p = x_.p, result_.mesh = x_.t;
        const bool known = converged() && result_.status != bvp_status::non_finite;
        result_.error.global = error_;
        if (!known) result_.error.forget(system_.size(), system_.parameters());
        if (!usable()) return;
        const bool estimated = converged() && estimate_.knows(x_.intervals());
        if (estimated || estimate_.run(x_, floor_, o_.rtol / 100)) {
            result_.error.defect = estimate_.defect(x_);
            estimate_.write(x_, result_.y);
        }
        if (o_.conditioning) result_.conditioning = conditioning_.run();
        r.conditioning_solves = conditioning_.solves();
    }
    /// Can f be evaluated along x, and are there factors?
    bool usable() const {
        return result_.status != bvp_status::non_finite && result_.status != bvp_status::function_threw &&
               result_.status != bvp_status::size_changed && outcome_.end != damped_newton_end::non_finite;
    }

    bvp_options<Scalar> o_;
    Scalar floor_;
    report<Scalar> counts_;
    result_type result_;
    system_type system_;
    typename system_type::mass_type mass_;
    equations_type equations_;
    lifting_elimination<equations_type> elimination_;
    error_estimate<equations_type> estimate_;
    damped_newton<equations_type> newton_;
    iterate x_, before_;
    conditioning_of<equations_type> conditioning_{equations_, x_};
    regularity<equations_type> regular_{equations_, conditioning_, x_, elimination_};
    std::vector<Scalar> guess_mesh_;
    damped_newton_outcome<Scalar> outcome_{damped_newton_end::failed, Scalar(0)};
    Scalar error_{std::numeric_limits<Scalar>::infinity()}, remainder_{0}, kappa_{0}, rounding_{0},
        last_kappa_{-1}, first_kappa_{0}, guess_size_{1};
    std::string failure_;
    bool few_ = false, from_guess_ = true, vanishes_ = false;
    int failures_ = 0, checks_ = 0;
};

}  // namespace stagecraft::detail
