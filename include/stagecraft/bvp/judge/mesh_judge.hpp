// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>

#include <stagecraft/bvp/judge/mesh_history.hpp>
#include <stagecraft/bvp/judge/singularity_judge.hpp>

namespace stagecraft::detail {

/// Decides after Newton's iteration on a mesh what comes next: another mesh, another beginning, or the end. Numbers in, a
/// verdict with its reason out; it holds no state, and history is added to by who acts on the verdict.
template <class Scalar>
class mesh_judge {
  public:
    using evidence = mesh_evidence<Scalar>;
    using verdict = mesh_verdict<Scalar>;
    using history = mesh_history<Scalar>;

    /// Newton's iteration begins again so often: from the guess's mesh up to 64 times as fine.
    static constexpr int most_failures = 6;
    /// And so often before other guesses than the user's are tried.
    static constexpr int failures_of_guess = 3;
    /// With more evaluations of f than this for an interval of the first mesh finer meshes for the guess are not tried.
    static constexpr long most_work = 50000;
    /// A condition number that is not more than so many times another stays; with singular ends 1/h enters it, which
    /// doubles with every mesh.
    static constexpr double stays = 2, stays_at_singular_end = 4;
    /// The condition number may be anything up to 1/(100 rtol): the errors of x leave 99 % of M.
    static constexpr double harmless = 0.01;
    /// M of a linear problem does not depend on x: it is enough that u is known to five digits.
    static constexpr double known_digits = 1e-5;
    /// Looks at the condition number, each on a finer mesh, until it is taken as it is.
    static constexpr int most_looks = 6;
    /// Where three digits are left of M, finer meshes show no more of it.
    static constexpr double three_digits = 1e-3;
    /// A condition number that has grown so many times since the first look may go on to infinity: M may vanish.
    static constexpr double vanishing = 10;
    /// A solution wrong in its first digit: its errors say nothing of where it is hard.
    static constexpr double first_digit = 0.1;
    /// Meshes in a row that take no hundredth off the error before the search ends; those that close in on a jump or a
    /// singularity take some off each.
    static constexpr int most_stuck = 20;
    /// f jumps where it seems to on more meshes in a row than this: no layer is mistaken for a jump.
    static constexpr int seen_jumps = 2;
    /// An error of a linear problem below so many rounding errors is what rounding makes; that of another may be Newton's.
    static constexpr int rounding_errors = 10;
    /// A mesh of more than max_intervals is asked for by an error that rounding may have made ten times as large.
    static constexpr int overestimated = 10;

    explicit mesh_judge(const mesh_limits<Scalar>& limits) : limits_(limits) {}

    verdict operator()(const evidence& e, const history& h) const {
        const evidence_reader<Scalar> r(e);
        verdict v = e.trial                                    ? on_trial(r, h)
                    : e.newton == damped_newton_end::converged ? of_solution(r, h)
                                                               : unsolved(r, h);
        if (!r.missing()) return v;
        v.planned = v.act, v.act = mesh_act::measure, v.missing = *r.missing();
        return v;
    }

    /// The error that Newton's iteration may leave: a fiftieth of the tolerance; more where the mesh will be refined anyway,
    /// a hundredth of the least error so far and at most 1e-4.
    Scalar newton_target(const history& h) const {
        const Scalar tight = limits_.rtol / 50,
                     loose = std::min(Scalar(Scalar(1) / 10000), Scalar(h.least / 100));
        return tight > loose || !limits_.adapt ? tight : loose;
    }
    /// Every second failure is followed by steps that need not decrease.
    bool bold(const history& h) const { return h.failures % 2 == 1; }

    /// A solution wrong in its first digit.
    static bool rough(const Scalar& error) { return !(error < Scalar(first_digit)); }

  private:
    using reader = evidence_reader<Scalar>;

    bool within(const reader& r) const { return r(quantity::error) <= limits_.rtol; }

    /// The first mesh has few intervals. If they are enough, all is well; nothing is refused because of what they show.
    verdict on_trial(const reader& r, const history& h) const {
        using std::sqrt;
        const verdict usual = verdict::go(mesh_act::usual_mesh);
        if (r->newton != damped_newton_end::converged) return usual;
        // Errors at mesh points are at best the squares of those between. A nonlinear x is a guess.
        if (r->linear && !(r(quantity::unresolved) <= sqrt(limits_.rtol))) return usual;
        if (!r.yes(quantity::evaluable)) return usual;
        if (!within(r)) return refined(r, h);
        if (!r.converged()) return usual;
        const condition c = look_at(r, h);
        if (!c.settled || !c.resolved || coincident(r, c)) return usual;
        const verdict v = accepted(r, c);
        return v.status == bvp_status::success ? v : usual;
    }

    verdict of_solution(const reader& r, const history& h) const {
        if (!r.yes(quantity::evaluable)) return not_evaluable(r, h);
        if (!limits_.adapt) return accepted(r, condition{});
        verdict v;
        if (within(r) && r.converged()) {
            const condition c = look_at(r, h);
            if ((c.settled || confirmed(r, c)) && !coincident(r, c)) return accepted(r, c);
            v = refined(r, h);
            v.unsettled = c.unsettled;
            return v;
        }
        return refined(r, h);
    }

    /// After Newton has failed: a finer mesh, from the guess or from the last solution.
    verdict unsolved(const reader& r, const history& h) const {
        // Where f is not finite there are no factors, or those of another mesh.
        const bool finite = r->newton != damped_newton_end::non_finite;
        if (!finite && r->from_guess) return not_finite();
        const singularity_judge<Scalar> singularity(r, limits_);
        if (finite)
            if (const auto end = singularity.hopeless(r->remainder)) return *end;
        verdict v = verdict::end(bvp_status::newton_failed, "Newton's iteration found no decrease");
        if (finite) v = singularity.because(v);
        if (!limits_.adapt) return finite ? v : not_finite();
        const bool again = !h.solved || rough(h.error) || !finite;
        if (again && r->other_guesses > 0 && (h.failures >= failures_of_guess || r->dear)) {
            v.act = mesh_act::other_guess;
            return v;
        }
        const int next = 2 * (again ? std::max(r->intervals, r->guess_intervals) : r->intervals);
        if (h.failures >= most_failures || next > limits_.max_intervals || (again && r->dear))
            return finite ? v : not_finite();
        v.act = again ? mesh_act::finer_guess : mesh_act::halve_last;
        return v;
    }

    /// Between its points a coarse solution may lead to where f cannot be evaluated.
    verdict not_evaluable(const reader& r, const history& h) const {
        if (h.failures >= most_failures || !limits_.adapt) return not_finite();
        return too_many(r) ? not_finite() : verdict::go(mesh_act::straight);
    }
    /// Does the mesh that follows have more intervals than it may?
    bool too_many(const reader& r) const {
        return static_cast<double>(r(quantity::next_intervals)) > limits_.max_intervals;
    }
    static verdict not_finite() {
        verdict v = verdict::end(bvp_status::non_finite, "");
        v.at_place = true;
        return v;
    }

    verdict refined(const reader& r, const history& before) const {
        const history h = before.with(r, limits_.rtol);
        const singularity_judge<Scalar> singularity(r, limits_);
        const Scalar& error = r(quantity::error);
        if (h.idle > 1 || (h.idle == 1 && rounding_only(r)))
            if (const auto end = singularity.hopeless(error)) return *end;
        if (h.stuck > most_stuck)
            return verdict::end(bvp_status::tolerance_not_met,
                                "the error stays, however the mesh is refined");
        // Where spreading has stopped to help, errors decide.
        const bool spread = rough(error) && h.idle < 2;
        verdict v = verdict::go(error <= limits_.rtol ? mesh_act::resolve
                                : spread              ? mesh_act::spread
                                                      : mesh_act::refine);
        v.doubled = h.idle > 0, v.divide = h.jumped > seen_jumps;
        if (too_many(r)) {
            if (const auto end = singularity.hopeless(overestimated * error)) return *end;
            return verdict::end(bvp_status::too_many_intervals,
                                "the tolerance asks for more than max_intervals");
        }
        return v;
    }

    bool rounding_only(const reader& r) const {
        return r->linear && r(quantity::error) < rounding_errors * r(quantity::rounding_of_y);
    }

    /// The condition of the problem, looked at where x is within the tolerance.
    struct condition {
        bool settled = false;    ///< M is regular, and the condition number known as well as it has to be
        bool vanishing = false;  ///< M may be singular: it is not known, or has become ever smaller
        bool resolved = true;    ///< as far as they had to be looked at, are fundamental solutions resolved?
        bool unsettled = false;  ///< this look counts
        int looks = 0;
    };
    condition look_at(const reader& r, const history& h) const {
        const regularity_judge<Scalar> regularity(r);
        const Scalar &kappa = r(quantity::kappa), &last = h.kappa,
                     first = last < Scalar(0) ? kappa : h.first_kappa;
        const auto near = [&](double growth) {
            return kappa < Scalar(growth) * last && last < Scalar(growth) * kappa;
        };
        const auto found = regularity.decide(r->linear ? Scalar(0) : r(quantity::error));
        const bool stayed = near(stays) || (near(stays_at_singular_end) && r.yes(quantity::singular_end));
        condition c;
        c.vanishing = found.undecided ||
                      (found.resolved && kappa > Scalar(vanishing) * first && !r.yes(quantity::singular_end));
        bool known = !found.undecided && (stayed || kappa * limits_.rtol < Scalar(harmless));
        c.resolved = found.resolved;
        if (r->linear && !known && !found.undecided) {
            known = regularity.mesh_error() < Scalar(known_digits);
            c.resolved = regularity.resolved();
        }
        c.unsettled = !known && !regularity.turns();
        c.looks = h.unsettled + c.unsettled;
        c.settled =
            known || (c.unsettled && c.looks > most_looks) || kappa * limits_.epsilon > Scalar(three_digits);
        return c;
    }
    /// Where this mesh leaves it open by how much fundamental solutions are wrong, the mesh halved says whether the
    /// condition number stays: of a linear problem by its Jacobians, without its solution there.
    bool confirmed(const reader& r, const condition& c) const {
        if (!r->linear || (c.vanishing && c.resolved) || 2 * r->intervals > limits_.max_intervals)
            return false;
        const Scalar &kappa = r(quantity::kappa), &halved = r(quantity::halved_kappa);
        return halved < Scalar(stays) * kappa && kappa < Scalar(stays) * halved;
    }
    /// Is it by chance that the condition number stays, which has grown to what the errors of a nonlinear x may make of it?
    static bool coincident(const reader& r, const condition& c) {
        return c.vanishing && c.looks <= most_looks && !r->linear &&
               r(quantity::kappa) * r(quantity::error) > Scalar(1);
    }

    /// The end of a run whose solution is taken as it is, unless M is singular or rounding errors count.
    verdict accepted(const reader& r, const condition& c) const {
        const singularity_judge<Scalar> singularity(r, limits_);
        if (const auto end = singularity.singular()) return *end;
        if (c.vanishing && c.looks > most_looks) return singularity.family();
        if (singularity.differences_alone())
            return verdict::end(bvp_status::ill_conditioned,
                                "M is no larger than the errors of differences of f");
        if (singularity.spoilt()) return singularity.by_rounding();
        if (within(r)) return verdict::end(bvp_status::success, "");
        return verdict::end(bvp_status::tolerance_not_met,
                            "the error on the given mesh exceeds the tolerance");
    }

    mesh_limits<Scalar> limits_;
};

}  // namespace stagecraft::detail
