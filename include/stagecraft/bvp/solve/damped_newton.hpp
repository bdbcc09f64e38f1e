// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <stagecraft/bvp/judge/mesh_evidence.hpp>
#include <stagecraft/bvp/judge/newton_damping.hpp>
#include <stagecraft/bvp/result.hpp>

namespace stagecraft {

/// How Newton's iteration ended; `remainder` estimates the error left, relative as options.rtol is.
template <class Scalar>
struct damped_newton_outcome {
    damped_newton_end end;
    Scalar remainder;
};

/// Newton's iteration with affine-invariant damping (judge/newton_damping.hpp): a step is accepted if the simplified
/// correction that follows it is smaller. The full step is tried first, which finds solutions that cautious predictions of
/// the damping do not. The factors are kept as long as these corrections contract. A linear problem takes one factorisation and no more, once its Jacobians have
/// been found to be the same at the end of the first step.
template <class Equations>
class damped_newton {
  public:
    using iterate = typename Equations::iterate;
    using scalar = std::decay_t<decltype(iterate{}.t[0])>;
    using outcome = damped_newton_outcome<scalar>;

    damped_newton(Equations& equations, bvp_report& counts, const scalar& threshold)
        : equations_(equations), counts_(counts), threshold_(threshold) {}

    /// Improves x until the error left is estimated below `target`, with at most `most` factorisations.
    outcome run(iterate& x, const scalar& target, int most, bool bold = false) {
        using std::sqrt;
        constexpr int rounding_errors = 100;  // that a correction may be, without anything left to correct
        const scalar rounding = rounding_errors * std::numeric_limits<scalar>::epsilon();
        equations_.resize(x);
        for (int step = 0; step < most; ++step) {
            ++counts_.newton_steps;
            if (!equations_.linearise(x)) return {damped_newton_end::non_finite, scalar(0)};
            ++counts_.factorisations;
            moved_ = scalar(0);
            solve(x, d_);
            weigh(x);
            const scalar size = norm(d_);
            if (!(size - size == scalar(0))) return {damped_newton_end::failed, size};
            const scalar left = accuracy(x, d_);
            const bool test = !tested_ && left > scalar(visible_step);
            if (test) {
                add(x, scalar(1), d_, trial_);
                linear_ = !equations_.jacobians_differ(trial_);
                tested_ = true;
            }
            if (linear_ &&
                !(test && differences())) {  // errors of differences leave something of a large step
                moved_ = left;
                add(x, scalar(1), d_, x);
                return {damped_newton_end::converged, std::numeric_limits<scalar>::epsilon() * moved_};
            }
            damping step_length(size, bold);
            scalar next(0);
            const bool decreased = search(x, sqrt(rounding), step_length, next);
            if (!decreased && !(left <= sqrt(rounding))) return {damped_newton_end::failed, left};
            const bool full = step_length.full();
            moved_ = step_length.lambda() * left;
            // Corrections that are rounding errors do not decrease; they still make the slopes fit y.
            if (decreased || (full && next < 2 * size)) std::swap(x, trial_);
            if (!decreased) return {damped_newton_end::converged, left};
            if (full && damping::keeps_factors(size, next)) {
                const outcome now = keep_factors(x, size, next, std::max(target, rounding));
                if (now.end == damped_newton_end::converged) return now;
            }
        }
        return {damped_newton_end::failed, accuracy(x, d_)};
    }

    /// How far x has gone from where the factors were computed, relative as options.rtol is.
    const scalar& moved() const { return moved_; }

    /// Do the factors hold for every x, as far as one step shows?
    bool linear() const { return linear_; }
    /// Has a step shown that they do not?
    bool nonlinear() const { return tested_ && !linear_; }

  private:
    bool differences() {
        const auto& functions = equations_.system();
        return functions.differences || functions.conditions_by_differences;
    }
    using damping = detail::newton_damping<scalar>;
    /// A relative step of this size shows whether Jacobians depend on x.
    static constexpr double visible_step = 1e-3;
    /// Corrections with the factors of one iterate: with a contraction by four they add five digits.
    static constexpr int most_kept = 8;

    /// x := x + bar with the factors of an earlier iterate while the corrections contract.
    outcome keep_factors(iterate& x, scalar before, scalar bar, const scalar& target) {
        for (int k = 0; k < most_kept; ++k) {
            const scalar rate = before > scalar(0) ? bar / before : scalar(0), left = accuracy(x, bar_);
            moved_ += left;
            add(x, scalar(1), bar_, x);
            if (rate * left <= target || bar == scalar(0)) return {damped_newton_end::converged, rate * left};
            if (!equations_.residual(x)) {  // the step is taken back, for new factors and damping
                add(x, scalar(-1), bar_, x);
                break;
            }
            solve(x, bar_);
            ++counts_.newton_steps;
            before = bar;
            bar = norm(bar_);
            if (!damping::keeps_factors(before, bar)) {
                const scalar rest = accuracy(x, bar_);  // rounding errors do not contract
                if (rest <= target) return {damped_newton_end::converged, rest};
                break;
            }
        }
        return {damped_newton_end::failed, scalar(0)};
    }

    /// False where no damped step decreases, or the full one does not and is below `rounding`.
    bool search(const iterate& x, const scalar& rounding, damping& step, scalar& next) {
        while (!step.gives_up()) {
            add(x, step.lambda(), d_, trial_);
            if (!equations_.residual(trial_)) {
                step.not_finite();
                continue;
            }
            solve(x, bar_);
            next = norm(bar_);
            if (step.accepts(next)) return true;
            if (step.full() && accuracy(x, d_) <= rounding) return false;
            combine(bar_, 1 - step.lambda(), d_, difference_);
            step.refused(norm(difference_));
        }
        return false;
    }

    void solve(const iterate& x, iterate& d) {
        equations_.solve(x, d);
        ++counts_.solves;
    }

    /// Components are weighed by the largest value they take, so that the test does not change its mind
    /// while a solution moves through zero.
    void weigh(const iterate& x) {
        weights_.resize(x.y.rows());
        for (Eigen::Index c = 0; c < x.y.rows(); ++c)
            weights_[c] = scalar(1) / (threshold_ + x.y.row(c).cwiseAbs().maxCoeff());
        scale_p_ = x.p.cwiseAbs();
    }
    scalar norm(const iterate& d) const {
        using std::abs;
        using std::sqrt;
        scalar sum(0);
        for (Eigen::Index c = 0; c < d.y.rows(); ++c)
            sum += weights_[c] * weights_[c] * (d.y.row(c).squaredNorm() + d.Z.row(c).squaredNorm());
        sum /= scalar(d.y.size() + d.Z.size());
        for (Eigen::Index k = 0; k < d.p.size(); ++k) {
            const scalar e = d.p[k] / (threshold_ + scale_p_[k]);
            sum += e * e;
        }
        return sqrt(sum);
    }
    scalar accuracy(const iterate& x, const iterate& d) const {
        using std::abs;
        scalar worst(0);
        for (Eigen::Index i = 0; i < d.y.cols(); ++i)
            for (Eigen::Index c = 0; c < d.y.rows(); ++c)
                worst = std::max(worst, scalar(abs(d.y(c, i)) / (threshold_ + abs(x.y(c, i)))));
        for (Eigen::Index k = 0; k < d.p.size(); ++k)
            worst = std::max(worst, scalar(abs(d.p[k]) / (threshold_ + abs(x.p[k]))));
        return worst;
    }
    static void add(const iterate& x, const scalar& factor, const iterate& d, iterate& out) {
        if (&x != &out) out.t = x.t;
        out.y = x.y + factor * d.y;
        out.Z = x.Z + factor * d.Z;
        out.p = x.p + factor * d.p;
    }
    static void combine(const iterate& a, const scalar& factor, const iterate& b, iterate& out) {
        out.y = a.y - factor * b.y;
        out.Z = a.Z - factor * b.Z;
        out.p = a.p - factor * b.p;
    }

    Equations& equations_;
    bvp_report& counts_;
    scalar threshold_, moved_{0};
    /// The first step that moved x found the same Jacobians where it led to: steps are taken without a test, as the error
    /// estimate evaluates f and r and sees what they leave.
    bool linear_ = false, tested_ = false;
    iterate d_, bar_, trial_, difference_;
    typename Equations::state weights_;
    typename Equations::parameters scale_p_;
};

}  // namespace stagecraft
