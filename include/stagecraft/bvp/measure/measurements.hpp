// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <initializer_list>
#include <limits>
#include <type_traits>

#include <stagecraft/bvp/judge/regularity_judge.hpp>
#include <stagecraft/bvp/measure/conditioning.hpp>
#include <stagecraft/bvp/measure/fundamental_solution.hpp>
#include <stagecraft/bvp/measure/missed_phase.hpp>
#include <stagecraft/bvp/measure/residual_of_answers.hpp>
#include <stagecraft/bvp/measure/translation.hpp>

namespace stagecraft::detail {

/// Measures what a judge may ask of the problem linearised at x, with the factors that the equations hold: one number for
/// each quantity, from matrices and vectors that stay here. No answer depends on what was asked before.
template <class Equations>
class measurements {
  public:
    using iterate = typename Equations::iterate;
    using scalar = std::decay_t<decltype(iterate{}.t[0])>;
    using evidence = mesh_evidence<scalar>;

    measurements(Equations& equations, const iterate& x, lifting_elimination<Equations>& elimination,
                 const scalar& threshold)
        : equations_(equations),
          x_(x),
          elimination_(elimination),
          threshold_(threshold),
          conditioning_(equations, x),
          u_(equations, conditioning_, x, elimination, threshold) {}

    conditioning_of<Equations>& conditioning() { return conditioning_; }
    fundamental_solution<Equations>& fundamental() { return u_; }
    /// The factors are those of another matrix from now on, or x is another.
    void forget() { conditioning_.forget(), u_.forget(); }

    /// Measures q, and what is mostly asked for after it: judging again costs more than some of these numbers.
    void measure(quantity q, evidence& e, const scalar& rtol) {
        const auto also = [&](std::initializer_list<quantity> others) {
            for (const quantity other : others)
                if (!e.knows(other)) e.set(other, number(other, e, rtol));
        };
        switch (q) {
            case quantity::mesh_error:
            case quantity::resolved: {
                const auto found = u_.mesh_error();
                e.set(quantity::mesh_error, found.size);
                return e.set(quantity::resolved, scalar(found.resolved ? 1 : 0));
            }
            case quantity::kappa:
                return also({q, quantity::missed_phase, quantity::answer});
            case quantity::norm:
                return also({q, quantity::rounding});
            case quantity::rounding_of_y:
                return also({q, quantity::range});
            default:
                return also({q});
        }
    }

  private:
    scalar number(quantity q, const evidence& e, const scalar& rtol) {
        switch (q) {
            case quantity::size:
                return x_.y.cwiseAbs().maxCoeff();
            case quantity::missed_phase:
                return stagecraft::detail::missed_phase(equations_, x_, elimination_.lifting().order);
            case quantity::answer:
                return u_.answer();
            case quantity::change:
                return u_.change(e[quantity::error]);
            case quantity::translation:
                return translation_missed(equations_, conditioning_, x_, threshold_, e[quantity::error]);
            case quantity::error_bound:
                return u_.error_bound();
            case quantity::kernel_radius:
                return u_.kernel_radius(regularity_judge<scalar>(evidence_reader<scalar>(e)).turns());
            case quantity::kappa:
                return conditioning_.fundamental(), conditioning_.relative(threshold_);
            case quantity::norm:
                return conditioning_.fundamental(), conditioning_.norm(counting_norm(rtol));
            case quantity::dependent:
                return scalar(dependent_condition(equations_.conditions()));
            case quantity::residual:
                return largest_residual(equations_, conditioning_, x_);
            case quantity::nonlinear:
                return scalar(u_.nonlinear(e.guess_size) ? 1 : 0);
            case quantity::contrast:
                return u_.contrast();
            case quantity::rounding:
                return conditioning_.fundamental(), conditioning_.rounding(threshold_);
            case quantity::rounding_of_u:
                return u_.rounding();
            case quantity::rounding_of_y:
                return u_.rounding_of_y();
            case quantity::range:
                return conditioning_.range(threshold_);
            default:
                return scalar(0);
        }
    }
    /// Smaller norms are not worth the singular values of every Phi(t_i): neither is M singular to rounding, nor does one
    /// rounding error times the norm reach the tolerance.
    static scalar counting_norm(const scalar& rtol) {
        return std::min(scalar(1000 * rtol), scalar(1)) *
               (scalar(1) / (1000 * std::numeric_limits<scalar>::epsilon()));
    }

    Equations& equations_;
    const iterate& x_;
    lifting_elimination<Equations>& elimination_;
    scalar threshold_;
    conditioning_of<Equations> conditioning_;
    fundamental_solution<Equations> u_;
};

}  // namespace stagecraft::detail
