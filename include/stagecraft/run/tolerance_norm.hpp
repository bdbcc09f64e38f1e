// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include <stagecraft/linear/norms.hpp>
#include <stagecraft/options.hpp>
#include <stagecraft/problem/system.hpp>

namespace stagecraft {

/// The norm in which the tolerance is one: the root mean square over all processes of
///     w_i x_i,  w_i = 1/(atol_i + rtol |y_i|),
/// times |h| in components of index 2 and h^2 in those of index 3 (HLR89, section 7). Vectors have the size n of y.
/// Raised says whether the problem may have such components; without them nothing is stored or computed for them.
template <class Vector, class Sums, bool Raised>
class tolerance_norm {
  public:
    using scalar = typename Vector::Scalar;
    using sums_type = Sums;

    /// Keeps references to the options and to the list of components of index 2 and 3.
    tolerance_norm(const options<scalar>& o, const std::vector<raised_component>& raised, const Vector& y,
                   const Sums& sums)
        : options_(o), raised_(raised), sums_(sums), state_(y.size()) {
        at(y);
    }

    /// Takes the weights from the state y, at the start of a step.
    void at(const Vector& y) { set_weights(options_, y, state_); }
    /// Takes the powers of h for a step of size h.
    void over(const scalar& h) {
        if constexpr (Raised) {
            using std::abs;
            if (raised_.empty()) return;
            const scalar size = abs(h);
            step_ = state_;
            for (const auto& r : raised_) step_[r.component] *= r.power == 1 ? size : scalar(size * size);
        }
    }

    /// The weights of the state alone, and those of the step.
    const Vector& of_state() const { return state_; }
    const Vector& weights() const {
        if constexpr (Raised)
            if (!raised_.empty()) return step_;
        return state_;
    }
    const Sums& sums() const { return sums_; }

    scalar operator()(const Vector& x) const { return with(weights(), x); }
    /// Components of index 2 and 3 count `share` times.
    scalar shared(const Vector& x, const scalar& share) const {
        if constexpr (Raised) {
            if (!raised_.empty()) {
                judged_ = step_;
                for (const auto& r : raised_) judged_[r.component] *= share;
                return with(judged_, x);
            }
        }
        return with(state_, x);
    }
    /// True if x is finite on every process.
    bool finite(const Vector& x) const { return all_finite(x, static_cast<int>(x.size()), sums_); }

  private:
    scalar with(const Vector& weights, const Vector& x) const {
        return weighted_norm(x, weights, static_cast<int>(x.size()), sums_);
    }

    struct nothing {};
    const options<scalar>& options_;
    const std::vector<raised_component>& raised_;
    [[no_unique_address]] Sums sums_;
    Vector state_;
    [[no_unique_address]] std::conditional_t<Raised, Vector, nothing> step_;
    [[no_unique_address]] mutable std::conditional_t<Raised, Vector, nothing> judged_;
};

}  // namespace stagecraft
