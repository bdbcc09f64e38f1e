// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <type_traits>
#include <utility>

namespace stagecraft {

/// An observer that tells how far a run has come; made by progress(). See there.
template <class Tell>
class progress_observer {
  public:
    progress_observer(Tell tell, double every) : tell_(std::move(tell)), every_(every) {
        if (!(every > 0)) throw std::invalid_argument("progress: every must be positive");
    }

    template <class Scalar, class Vector>
    void start(const Scalar& t0, const Vector&, const Scalar& t1) {
        t0_ = static_cast<double>(t0);
        span_ = static_cast<double>(t1 - t0);
        next_ = every_;
    }
    template <class Scalar, class Vector>
    bool operator()(const Scalar& t, const Vector&) {
        const double part = (static_cast<double>(t) - t0_) / span_;
        if (part < next_ && part < 1) return true;
        while (next_ <= part) next_ += every_;
        if constexpr (std::is_convertible_v<std::invoke_result_t<Tell&, double>, bool>) {
            return static_cast<bool>(tell_(part));
        } else {
            tell_(part);
            return true;
        }
    }

  private:
    Tell tell_;
    double every_, t0_ = 0, span_ = 1, next_ = 0;
};

/// An observer that calls tell(part) with the part of [t0, t1] done, 1 at the end, whenever another `every` of it
/// is; what tell returns, if it is false, ends the run (status::stopped):
///
///     integrate(method, problem, y0, t0, t1, options, progress([&](double part) {
///         std::cerr << std::lround(100 * part) << " %\r";
///         return !cancelled;
///     }));
///
/// Together with others: observers(progress(...), watch). std::invalid_argument unless every > 0.
template <class Tell>
auto progress(Tell tell, double every = 0.01) {
    constexpr bool callable = std::is_invocable_v<Tell&, double>;
    static_assert(callable, "progress(tell, every): tell must be callable as tell(part), part a double");
    if constexpr (callable)
        return progress_observer<Tell>(std::move(tell), every);
    else
        return [](auto&&...) {};
}

}  // namespace stagecraft
