// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cmath>

#include <stagecraft/linear/block_work.hpp>

namespace stagecraft {

/// What an accepted step tells about the neighbouring orders.
template <class Scalar>
struct order_evidence {
    Scalar h;                ///< size of the step
    Scalar error;            ///< its estimate, tolerance 1
    Scalar decay;            ///< ratio of successive Legendre coefficients of the stage polynomial
    Scalar theta;            ///< contraction of Newton's iteration
    int iterations;          ///< how many it took
    step_work<Scalar> work;  ///< what its linear systems cost
};

/// One of the methods as the choice sees it.
template <class Scalar>
struct order_candidate {
    int stages;
    int power;                ///< the estimate is O(h^power)
    Scalar ratio;             ///< estimates are multiplied by it to have tolerance 1
    block_work<Scalar> work;  ///< without the linear systems
};

/// Chooses among `Count` methods ordered by their number of stages. With one method it holds and decides
/// nothing.
template <class Scalar, int Count>
class order_controller {
  public:
    static constexpr int current() { return 0; }
    static constexpr void start() {}
    template <class Bag>
    static void carry(Bag&) {}
};

/// Takes the method that promises the longest step for its work. The step each could take follows from the
/// estimate of the present one and the decay q of the Legendre coefficients of its polynomial (two stages
/// more change the estimate by q^2); Newton's contraction is taken as proportional to the step. The work is
/// counted in operations, not in seconds, so the choice is the same on every machine; that of linear systems as the
/// factors of each method told it last, the present one's where it has not been used. Attempts that
/// Newton's iteration fails to solve count as well, as often as each method made them lately.
template <class Scalar, int Count>
requires(Count > 1) class order_controller<Scalar, Count> {
  public:
    int current() const { return current_; }
    /// A run begins: with the fewest stages.
    void start() { current_ = 0, wait_ = 2; }

    /// Makes method k known. More than seven stages are chosen only where rtol <= 1e-10: above it their gain
    /// is not worth their Newton iterations.
    void prepare(int k, const order_candidate<Scalar>& c, const Scalar& rtol) {
        candidates_[k] = c;
        admitted_[k] = c.stages <= 7 || rtol <= Scalar(1) / 10000000000;
    }

    /// Newton's iteration has failed to solve an attempt, `again` in this step: methods of fewer stages are less
    /// demanding.
    void newton_failed(bool again) {
        failing_[current_] += Scalar(1) / 8;
        if (!again || current_ == 0) return;
        --current_;
        wait_ = 10;
    }
    /// A step has been accepted. Of the other methods less is forgotten, but all in time: conditions change.
    void accepted() {
        for (Scalar& share : failing_) share -= share / (&share == &failing_[current_] ? 8 : 64);
    }
    bool wants_evidence() { return --wait_ <= 0; }

    /// Decides; returns the factor by which the step of `e` changes for the new order, or 0 if the order
    /// stays.
    Scalar decide(const order_evidence<Scalar>& e) {
        wait_ = 6;
        known_[current_] = e.work;
        const Scalar here = work_per_length(current_, e);
        int best = current_;
        Scalar least = here;
        for (int k = current_ - 1; k <= current_ + 1; k += 2) {
            if (k < 0 || k >= Count || !admitted_[k]) continue;
            // A change has to promise a gain, and a larger one if it adds stages, which is the bolder
            // prediction.
            const Scalar w = work_per_length(k, e) * (k > current_ ? Scalar(5) / 4 : Scalar(10) / 9);
            if (w < least) least = w, best = k;
        }
        if (best == current_) return Scalar(0);
        Scalar factor = step_of(best, e);
        current_ = best;
        wait_ = 8;
        const Scalar low = Scalar(1) / 5, high = Scalar(3);
        return factor < low ? low : factor > high ? high : factor;
    }

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(current_, wait_, failing_);
        for (auto& [once, per_stage] : known_)
            bag(once.step, once.iteration, per_stage.step, per_stage.iteration);
    }

  private:
    /// Step of method k for an estimate of 1, as a multiple of h.
    Scalar step_of(int k, const order_evidence<Scalar>& e) const {
        using std::pow;
        const auto &now = candidates_[current_], &then = candidates_[k];
        Scalar error = e.error * then.ratio / now.ratio * pow(e.decay, Scalar(then.stages - now.stages));
        const Scalar least = Scalar(1) / 100000000;
        if (error < least) error = least;
        const Scalar f = Scalar(8) / Scalar(10) / pow(error, Scalar(1) / Scalar(then.power));
        return f < Scalar(4) ? f : Scalar(4);
    }

    Scalar work_per_length(int k, const order_evidence<Scalar>& e) const {
        using std::log;
        const Scalar step = step_of(k, e);
        Scalar theta = e.theta * step;
        const Scalar low = Scalar(1) / 1000, high = Scalar(9) / 10;
        theta = theta < low ? low : theta > high ? high : theta;
        const Scalar now = e.theta < low ? low : e.theta > high ? high : e.theta;
        const Scalar iterations = Scalar(e.iterations) * log(now) / log(theta);
        const auto& [stages, power, ratio, own] = candidates_[k];
        const auto& known = known_[k];
        const auto& [once, per_stage] =
            known.once.step + known.per_stage.iteration > Scalar(0) ? known : e.work;
        const Scalar once_a_step = own.step + (once.step + Scalar(stages) * per_stage.step),
                     iteration = own.iteration + (once.iteration + Scalar(stages) * per_stage.iteration);
        // An attempt that fails is given up after about two iterations. More stages fail no less.
        const bool more = k > current_ && failing_[k] < failing_[current_];
        const Scalar failed = failing_[more ? current_ : k] * (once_a_step + 2 * iteration);
        return (once_a_step + iterations * iteration + failed) / step;
    }

    std::array<order_candidate<Scalar>, static_cast<std::size_t>(Count)> candidates_{};
    std::array<bool, static_cast<std::size_t>(Count)> admitted_{};
    std::array<Scalar, static_cast<std::size_t>(Count)> failing_{};
    std::array<step_work<Scalar>, static_cast<std::size_t>(Count)> known_{};
    int current_ = 0, wait_ = 2;
};

}  // namespace stagecraft
