// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <chrono>
#include <utility>

#include <stagecraft/work.hpp>

namespace stagecraft {

/// Where the time of one or more runs went, in seconds; with_time_split() adds to it.
struct time_split {
    double f = 0;              ///< the right-hand side, outside of the Jacobian
    double jacobian = 0;       ///< the Jacobian, with what it spends on the right-hand side
    double factorisation = 0;  ///< of the real and complex blocks
    double solves = 0;         ///< with these factors, those of the error estimate included
    double total = 0;          ///< life of the run, its storage and its observers included

    /// Everything else: transformations, norms, step control, observers, and the clock itself.
    double rest() const { return total - f - jacobian - factorisation - solves; }
};

namespace detail {

template <class Clock>
class lap {
  public:
    explicit lap(double& seconds) : seconds_(seconds), begin_(Clock::now()) {}
    ~lap() { seconds_ += std::chrono::duration<double>(Clock::now() - begin_).count(); }
    lap(const lap&) = delete;
    lap& operator=(const lap&) = delete;

  private:
    double& seconds_;
    typename Clock::time_point begin_;
};

template <class Rhs, class Clock>
struct rhs_with_time_split : Rhs {
    time_split* split;
    rhs_with_time_split(Rhs r, time_split& s) : Rhs(std::move(r)), split(&s) {}
    using Rhs::operator();
    lap<Clock> measure(work kind) const {
        switch (kind) {
            case work::f:
                return lap<Clock>(split->f);
            case work::jacobian:
                return lap<Clock>(split->jacobian);
            case work::factorisation:
                return lap<Clock>(split->factorisation);
            case work::solve:
                return lap<Clock>(split->solves);
            case work::run:
                break;
        }
        return lap<Clock>(split->total);
    }
};

}  // namespace detail

/// A problem whose runs add the time they spend to `split`, which must outlive them:
///
///     time_split split;
///     const auto r = integrate(method, with_time_split(problem, split), y0, t0, t1);
///     print(std::cout, split);                                   // report_text.hpp
///
/// A clock is read twice per evaluation, factorisation and solve, which costs some 40 ns each time; a run
/// without it reads none and holds nothing for it. Keeps a copy of the problem.
template <class Clock = std::chrono::steady_clock, class Rhs>
auto with_time_split(Rhs rhs, time_split& split) {
    return detail::rhs_with_time_split<Rhs, Clock>(std::move(rhs), split);
}

}  // namespace stagecraft
