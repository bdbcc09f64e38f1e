// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

namespace stagecraft {

/// How an attempt to solve the stage equations ended.
enum class newton_end { converged, diverged, non_finite };

/// What Newton's iteration for the stages of one step came to.
template <class Scalar>
struct newton_outcome {
    newton_end end = newton_end::diverged;
    int iterations = 0;
    Scalar theta{0};  ///< observed contraction; 0 if one iteration was enough to know
};

/// What the iteration is told: it stops when the error left in Z is below `factor` in the weighted norm, in
/// which the tolerance is 1. `floor` is the size of an increment that is only rounding; below `noise` an
/// iteration that no longer contracts has reached rounding as well. The contraction is measured in every
/// step, so at least two iterations are made. The contraction of the step before
/// would save one of them, at the cost of three digits on Robertson's problem: the errors left over all have the same sign.
template <class Scalar>
struct newton_limits {
    Scalar factor, floor, noise;
    int iterations;
    bool affine = false;   ///< f is affine in y with the Jacobian in use: the first iteration is exact
    int patience = 1;      ///< contractions to be seen before slow ones are believed
    int most_at_once = 2;  ///< tolerances that the second increment may have where it is the last one
    Scalar far{0};         ///< > 0: a guess that the first increment leaves so far behind is given up at once
};

/// Iterations a step by s coupled stages may take.
inline int usual_iterations(int s) { return 7 + (s > 3 ? (5 * (s - 3)) / 2 : 0); }

/// Whether the polynomial of the last step is good enough to start the next iteration. Errors within the
/// tolerance in components of index 2 and 3, about rtol / h, and those that linear solvers leave which iterate, grow by
/// orders of magnitude when a polynomial of many stages is extrapolated. So after an iteration has failed, the same step is tried from a constant, and
/// so are the next ones, twice as many after each failure.
class extrapolation_trust {
  public:
    bool trusted() const { return skipped_ == 0; }
    void failed() {
        if (skip_ < 8) skip_ = 2 * skip_ + 1;
        skipped_ = skip_;
    }
    void stepped() {
        if (skipped_ == 0)
            skip_ = 0;
        else
            --skipped_;
    }

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(skip_, skipped_);
    }

  private:
    int skip_ = 0, skipped_ = 0;
};

/// Watches a simplified Newton iteration by the sizes of its increments and says when it is over.
template <class Scalar>
class newton_monitor {
  public:
    explicit newton_monitor(const newton_limits<Scalar>& limits) : limits_(limits) {}

    const newton_outcome<Scalar>& outcome() const { return outcome_; }
    /// True while the limits allow another iteration.
    bool may_go_on() const { return outcome_.iterations < limits_.iterations; }

    /// Linear solvers that iterate may have left `part` of the residual, and with it an error of `smooth` in components in
    /// which J is small.
    void leave(const Scalar& part, const Scalar& smooth) {
        part_left_ = part;
        smooth_left_ = smooth;
    }
    /// Takes the size of the increment just made; true if the iteration ends with it (outcome().end).
    bool over(const Scalar& size) {
        using std::sqrt;
        const int k = outcome_.iterations++;
        if (!(size - size == Scalar(0))) return end(newton_end::non_finite);
        if (size <= limits_.floor && !(smooth_left_ > limits_.factor)) return end(newton_end::converged);
        if (limits_.affine && part_left_ == Scalar(0)) return end(newton_end::converged);
        if (k == 0 && limits_.far > Scalar(0) && size > limits_.far) return end(newton_end::diverged);
        if (k > 0) {
            const Scalar rate = size / last_;
            Scalar& theta = outcome_.theta;
            const Scalar least = limits_.factor / 10;
            theta = k == 1 ? rate : Scalar(sqrt(rate * (theta < least ? least : theta)));
            if (size <= limits_.noise && rate > Scalar(1) / 4) return end(newton_end::converged);
            if (theta < Scalar(99) / 100) {
                // After a bad guess the first rate measures the return to the basin, not the rate near the solution: alone
                // it is not believed where the last increment is larger than so many tolerances.
                const Scalar once = limits_.factor / Scalar(limits_.most_at_once);
                Scalar believed = !contracted_ && theta < once ? once : theta;
                if (believed < part_left_) believed = part_left_;
                const Scalar left = size * believed / (Scalar(1) - believed) + smooth_left_;
                if (left <= limits_.factor) return end(newton_end::converged);
                // Give up if the iterations that remain cannot reach the goal at the observed rate.
                if (k >= limits_.patience && left * power(theta, limits_.iterations - 1 - k) > limits_.factor)
                    return end(newton_end::diverged);
            } else if (k >= limits_.patience) {
                return end(newton_end::diverged);
            }
            contracted_ = contracted_ || 2 * size < last_;
        }
        last_ = size;
        return false;
    }

  protected:
    newton_limits<Scalar> limits_;
    newton_outcome<Scalar> outcome_;
    Scalar last_{0}, part_left_{0}, smooth_left_{0};
    bool contracted_ = false;  // by a half at least, in some iteration

  private:
    bool end(newton_end how) {
        outcome_.end = how;
        return true;
    }
    static Scalar power(const Scalar& x, int k) {
        Scalar result = Scalar(1);
        for (; k > 0; --k) result *= x;
        return result;
    }
};

/// The same where the linear systems are solved by iteration: it tells them how exactly, and takes what they leave as
/// left. Increments are taken to shrink as the residuals do, so that from the second one on its size is known before.
/// (Measured on the Brusselator in two dimensions: a size between a half and two and a half times the one that came.)
template <class Scalar>
class inexact_newton_monitor : public newton_monitor<Scalar> {
    using base = newton_monitor<Scalar>;

  public:
    using base::base;

    /// The part of a residual of this size that the next solve may leave; 0: as little as is usual. It is half of what
    /// the whole iteration may leave, but at most a quarter of the increment, so that the contraction can be seen.
    Scalar may_leave(const Scalar& residual) {
        part_ = Scalar(0);
        if (this->outcome_.iterations > 0) {
            const Scalar expected = this->last_ * (residual / residual_), most = Scalar(1) / 4;
            part_ = this->limits_.factor / (2 * expected);
            if (!(part_ < most)) part_ = most;
        }
        residual_ = residual;
        return part_;
    }
    /// As newton_monitor::over.
    bool over(const Scalar& size) {
        const bool ended = base::over(size);
        const Scalar part = part_ < this->part_left_ ? this->part_left_ : part_;
        const bool left = size * part > this->limits_.factor * (Scalar(1) - part);
        if (!left || this->outcome_.end != newton_end::converged) return ended;
        this->outcome_.end = newton_end::diverged;  // unless another iteration mends it
        this->last_ = size;
        return false;
    }

  private:
    Scalar residual_{0}, part_{0};
};

}  // namespace stagecraft
