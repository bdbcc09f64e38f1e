// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <stdexcept>
#include <utility>

namespace stagecraft {

/// Observer that bounds the global error |x(t) - y(t)|_2 of a run for y' = f(t, y) by the defect
/// d(s) = u'(s) - f(s, u(s)) of its continuous solution u, which holds everything that was done wrong, unsolved stage
/// equations too (the delta_n of lecture, section 2.3):
///   - bound(): with a one-sided Lipschitz constant gamma of f, E' <= gamma E + |d|, hence over a step
///     E <- e^(gamma h) E + (e^(gamma h) - 1)/gamma max |d| (Hairer-Norsett-Wanner I, Theorem I.10.6);
///   - lipschitz_bound(): the lecture's (e^(L (t - t0)) - 1)/L max |d| over the whole run, L a Lipschitz constant.
/// The maximum over a step is taken over nine samples, both ends among them, where the defect of collocation, a multiple of
/// the nodal polynomial, is largest: the bounds hold as far as these show the defect, and are as sharp as the constants and
/// u are: the defect of s-stage collocation is O(h^s), of whatever order y itself is. u must be continuous with u' in every
/// step. Cost: nine evaluations of f and of the continuous solution in every step.
/// Forward in time only.
template <class Vector, class Problem>
class global_error {
  public:
    using scalar = typename Vector::Scalar;

    /// `problem` as in integrate(), without mass(); gamma <= lipschitz, both finite, lipschitz > 0: std::invalid_argument
    /// else.
    global_error(Problem problem, const scalar& gamma, const scalar& lipschitz)
        : problem_(std::move(problem)), gamma_(gamma), lipschitz_(lipschitz) {
        if (!(lipschitz > scalar(0)) || !(lipschitz - lipschitz == scalar(0)))
            throw std::invalid_argument("global_error: lipschitz must be positive and finite");
        if (!(gamma <= lipschitz) || !(gamma - gamma == scalar(0)))
            throw std::invalid_argument("global_error: gamma must be finite and at most lipschitz");
    }

    /// The run begins, from an exact initial value.
    void start(const scalar& t0, const Vector& y0, const scalar& t1) {
        if (t1 < t0) throw std::invalid_argument("global_error: t1 must not be below t0");
        begin_ = now_ = t0;
        error_ = largest_ = scalar(0);
        value_ = slope_ = y0;
    }
    template <class Output>
    void operator()(const scalar& t, const Vector&, const scalar& h, const Output& output) {
        using std::exp;
        using std::expm1;
        scalar most(0);
        for (int k = 0; k <= parts; ++k) {
            const scalar s = t - h + h * (scalar(k) / scalar(parts));
            value_ = output(s);
            problem_(s, value_, slope_);
            const scalar size = (output.derivative(s) - slope_).norm();
            if (!(size <= most)) most = size;
        }
        const scalar growth = gamma_ * h;
        error_ = exp(growth) * error_ + most * (gamma_ == scalar(0) ? h : scalar(expm1(growth) / gamma_));
        if (!(most <= largest_)) largest_ = most;
        now_ = t;
    }

    /// Bounds of the error at the time reached.
    const scalar& bound() const { return error_; }
    scalar lipschitz_bound() const {
        using std::expm1;
        return expm1(lipschitz_ * (now_ - begin_)) / lipschitz_ * largest_;
    }
    /// The largest |d| seen.
    const scalar& largest_defect() const { return largest_; }

  private:
    static constexpr int parts = 8;
    Problem problem_;
    scalar gamma_, lipschitz_, begin_{0}, now_{0}, error_{0}, largest_{0};
    Vector value_, slope_;
};

}  // namespace stagecraft
