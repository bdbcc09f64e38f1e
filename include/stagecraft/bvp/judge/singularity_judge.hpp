// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <optional>

#include <stagecraft/bvp/judge/regularity_judge.hpp>

namespace stagecraft::detail {

/// Says whether M is singular to rounding, and whether solutions exist then; and whether rounding errors are all that is left.
/// Where Newton's iteration of a nonlinear problem has failed, M is that of an iterate and says nothing of the problem.
template <class Scalar>
class singularity_judge {
  public:
    using verdict = mesh_verdict<Scalar>;

    /// A condition number above 1/(1000 epsilon) leaves three digits or less.
    static constexpr int lost_digits = 1000;
    /// u is a solution if rounding errors change it by less than this part.
    static constexpr double part_of_u = 1e-4;
    /// Estimated with all signs in favour, the sum of rounding errors may be a hundredth of what it is.
    static constexpr int signs_in_favour = 100;
    /// Every rounding error counts as large as it may be: their sum is mostly less than a tenth of that.
    static constexpr int mostly_less = 10;
    /// The condition of a family's members differs by more than this from iterate to iterate, as M is as singular as
    /// an iterate is close to the family.
    static constexpr double same_condition = 2;
    /// Jacobians by differences are wrong by sqrt(epsilon): M may be all error if u answers 1/1000 of the inverse of that,
    /// and errors of that size change u by a tenth.
    static constexpr double answer_of_differences = 1e-3, change_of_differences = 0.1;

    singularity_judge(const evidence_reader<Scalar>& r, const mesh_limits<Scalar>& limits)
        : r_(r), limits_(limits) {}

    /// How the run ends if M is singular to rounding; nothing if it is not, or if it is only that of an iterate.
    std::optional<verdict> singular() const {
        if (!looks_singular()) return {};
        if (dependent() < 0 && !of_iterate() && grows())
            return verdict::end(bvp_status::ill_conditioned,
                                "kappa1 exceeds 1/(1000 epsilon): solutions grow");
        if (solved()) return family();
        if (of_iterate()) return {};
        return because(verdict::end(bvp_status::singular, ""));
    }

    /// How the run ends if an error that stays is made of rounding errors, and no mesh will make it less.
    std::optional<verdict> hopeless(const Scalar& error) const {
        if (const auto end = singular()) return end;
        const bool nonlinear = of_iterate();
        if (regularity_judge<Scalar>(r_).decide(Scalar(0)).undecided) {
            if (r_.converged() || nonlinear) return {};
            return verdict::end(bvp_status::singular, "M is singular as far as any mesh shows");
        }
        if (!(error < signs_in_favour * r_(quantity::rounding)) &&
            (nonlinear || !(error < r_(quantity::rounding_of_y))))
            return {};
        if (nonlinear) {
            if (!solved() || r_(quantity::full_norm) < Scalar(0)) return {};
            const Scalar before = r_(quantity::norm), after = r_(quantity::full_norm);
            if (after > Scalar(same_condition) * before || before > Scalar(same_condition) * after)
                return family();
        }
        return by_rounding();
    }

    /// Whether rounding errors spoil a solution within the tolerance.
    bool spoilt() const {
        return (r_(quantity::rounding) > limits_.rtol &&
                r_(quantity::norm) * limits_.epsilon > limits_.rtol) ||
               r_(quantity::rounding_of_y) > mostly_less * limits_.rtol ||
               r_(quantity::range) * limits_.epsilon > lost_digits * limits_.rtol;
    }
    /// Can the errors of differences, from which a nonlinear f has its Jacobian, be all there is of M?
    bool differences_alone() const {
        using std::sqrt;
        if (!r_->differences) return false;
        const Scalar noise = sqrt(limits_.epsilon);
        return r_(quantity::answer) * noise > Scalar(answer_of_differences) &&
               r_(quantity::rounding_of_u) * noise / limits_.epsilon > Scalar(change_of_differences) &&
               r_.yes(quantity::nonlinear);
    }

    verdict family() const {
        auto v = verdict::end(bvp_status::not_isolated, "solutions form a family");
        v.dependent = dependent();
        if (v.dependent >= 0) v.reason = "";
        v.family = true;
        return v;
    }
    static verdict by_rounding() {
        return verdict::end(bvp_status::ill_conditioned, "rounding errors exceed the tolerance");
    }
    /// The same verdict with the cause, if M is singular.
    verdict because(verdict v) const {
        if (!looks_singular()) return v;
        v.cause = "M is singular to rounding", v.dependent = dependent();
        return v;
    }

  private:
    Scalar largest() const { return Scalar(1) / (lost_digits * limits_.epsilon); }
    /// Do the fundamental solutions leave their own equations by more than rounding? Of a singular M elimination makes a regular
    /// one of its rounding errors, whose answers do; those of an M that only answers much, in whatever units, do not.
    bool contradict() const {
        using std::sqrt;
        return !(r_(quantity::residual) < sqrt(limits_.epsilon));
    }
    bool looks_singular() const {
        if (r_(quantity::norm) < largest()) return false;
        // Of components as large as that, rounding errors may be as small as of others.
        const bool of_units = r_.converged() && r_(quantity::error) <= limits_.rtol &&
                              r_(quantity::kappa) < largest() &&
                              r_(quantity::rounding_of_u) < Scalar(part_of_u);
        return !of_units || contradict();
    }
    bool of_iterate() const { return !r_.converged() && (r_->changes || r_.yes(quantity::nonlinear)); }
    /// Is u large because solutions grow from one end to the other, rounding errors leaving it what it is? M is regular then.
    bool grows() const {
        using std::sqrt;
        return r_(quantity::rounding_of_u) < Scalar(part_of_u) &&
               r_(quantity::contrast) < sqrt(limits_.epsilon);
    }
    /// With M singular: does x solve the equations, at a size that is not 1 / epsilon?
    bool solved() const {
        using std::sqrt;
        return r_(r_.converged() ? quantity::size : quantity::full_size) <
               sqrt(r_(quantity::norm)) * r_->guess_size;
    }
    int dependent() const { return static_cast<int>(static_cast<double>(r_(quantity::dependent))); }

    const evidence_reader<Scalar>& r_;
    const mesh_limits<Scalar>& limits_;
};

}  // namespace stagecraft::detail
