// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace stagecraft::detail {

/// How far to go along a correction d of Newton's iteration, decided by norms: `size` of d, `next` of the simplified
/// correction that follows the step lambda d, `change` of next - (1 - lambda) d, which Newton's iteration on a linear problem
/// leaves zero (Deuflhard 2004, section 3.3: the error-oriented method).
template <class Scalar>
class newton_damping {
  public:
    /// Shorter steps lead nowhere.
    static constexpr double least_step = 1e-4;
    /// A bold iteration takes such a step even where a larger correction follows it: that leads past iterates at which the
    /// equations are singular, before which damping ends.
    static constexpr double bold_step = 0.0625;
    /// A step to where f is not finite says nothing of how far it may be.
    static constexpr int shorter_where_not_finite = 4;
    /// The correction after a step lambda has to be smaller by lambda/4.
    static constexpr int decrease = 4;
    /// lambda changes by a factor between 1/10 and 1/2, whatever the prediction says.
    static constexpr int shorter_by_at_most = 10, shorter_by_at_least = 2;
    /// Factors are kept while corrections contract by this.
    static constexpr int contraction = 4;

    newton_damping(const Scalar& size, bool bold) : size_(size), bold_(bold) {}

    const Scalar& lambda() const { return lambda_; }
    bool full() const { return lambda_ == Scalar(1); }
    bool gives_up() const { return !(lambda_ >= Scalar(least_step)); }
    void not_finite() { lambda_ /= shorter_where_not_finite; }
    bool accepts(const Scalar& next) const {
        return next <= (1 - lambda_ / decrease) * size_ || (bold_ && lambda_ <= Scalar(bold_step));
    }
    /// The step after one that was refused: the prediction size lambda^2 / (2 change).
    void refused(const Scalar& change) {
        const Scalar predicted =
            change > Scalar(0) ? Scalar(size_ * lambda_ * lambda_ / (2 * change)) : Scalar(0);
        const Scalar most = lambda_ / shorter_by_at_least, least = lambda_ / shorter_by_at_most;
        lambda_ = predicted < most ? (predicted > least ? predicted : least) : most;
        if (bold_ && lambda_ < Scalar(bold_step)) lambda_ = Scalar(bold_step);
    }
    /// Are the factors good for the next correction too, once this one is followed by one of the size `next`?
    static bool keeps_factors(const Scalar& before, const Scalar& next) {
        return contraction * next <= before;
    }

  private:
    Scalar size_, lambda_{1};
    bool bold_;
};

}  // namespace stagecraft::detail
