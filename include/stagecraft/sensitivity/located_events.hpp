// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/sensitivity/changes.hpp>

namespace stagecraft::detail {

/// Times nearer than this are one, in a run over `span`, which is negative backwards.
template <class Scalar>
Scalar nearness(const Scalar& t, const Scalar& span) {
    using std::abs;
    return 64 * std::numeric_limits<Scalar>::epsilon() * (abs(t) + 10000 * abs(span));
}
template <class Scalar>
[[noreturn]] void refuse_together(const char* who, const Scalar& t, int number) {
    no_derivative(who, t,
                  "event " + std::to_string(number) +
                      " takes place together with an at(): which comes first depends on p, and there is no "
                      "derivative");
}

/// Finds the events of a run in pieces, from one to the next, at one p; nothing of lists without any.
template <class Vector, class Parameters, class Changes>
class located_events {
    using scalar = typename Vector::Scalar;

  public:
    static constexpr bool exist = one_located<Changes>;

    located_events(const Parameters& p, const Changes& list, const Vector& y0)
        : watch_(watch_for(p, list, y0)) {}

    /// A piece begins.
    void start(const scalar& t, const Vector& y, const scalar& end) {
        from_ = t;
        if constexpr (exist) watch_.start(t, y, end);
    }
    /// The numbers of the first events of the last step, at t(), that take place together. Not the one at which the piece
    /// began, of which rounding may have left g on either side of zero.
    template <class Run>
    std::vector<int> in_last_step([[maybe_unused]] const Run& run) {
        using std::abs;
        std::vector<int> numbers;
        if constexpr (exist) {
            watch_(run.t(), run.y(), run.output().step(), run.output());
            for (const auto& one : watch_.found()) {
                if (last_ == one.event && !(abs(one.t - from_) > 100 * near_)) continue;
                if (numbers.empty()) t_ = one.t;
                if (abs(one.t - t_) > 64 * std::numeric_limits<scalar>::epsilon() * abs(t_)) break;
                numbers.push_back(one.event);
            }
        }
        return numbers;
    }
    const scalar& t() const { return t_; }
    /// Event `number` has been passed; g takes `near` to zero from what it is behind it, with `rest` to go.
    void passed(int number, const scalar& near, const scalar& rest) {
        last_ = number;
        // Where the jump leads away from zero, this is no rounding.
        near_ = near < rest / 1000000000 ? near : scalar(0);
    }

  private:
    decltype(watch_for(std::declval<const Parameters&>(), std::declval<const Changes&>(),
                       std::declval<const Vector&>())) watch_;
    int last_ = -1;
    scalar near_{0}, from_{0}, t_{0};
};

/// Refuses an event at t where something is done at a time within rounding of that: which comes first depends on p.
template <class Scalar>
void demand_apart_from_times(const char* who, const break_times<Scalar>& times, const Scalar& t, int number,
                             const Scalar& span) {
    using std::abs;
    const Scalar near = nearness(t, span), other = times.next(Scalar(t - near), Scalar(t + near));
    if (abs(other - t) < near && times.contains(other)) refuse_together(who, t, number);
}
/// The same at a time t at which something is done: of events that the solution, of slope f, would meet within rounding of t.
template <class Sides, class Vector, class Changes>
void demand_no_event(const Sides& sides, const Changes& list, const typename Vector::Scalar& t,
                     const Vector& y, const Vector& f, const typename Vector::Scalar& span) {
    using std::abs;
    using scalar = typename Vector::Scalar;
    int number = 0;
    const auto look = [&](const auto& one) {
        if constexpr (is_located<std::remove_cvref_t<decltype(one)>>) {
            typename Sides::derivatives g;
            sides.take_event(number, t, y, g);
            const scalar rate = g.along(scalar(1), f, -1)[0];
            const bool rises = (rate > scalar(0)) == (span > scalar(0));
            const bool counts = one.options.direction == crossing::both ||
                                (one.options.direction == crossing::rising) == rises;
            if (rate != scalar(0) && counts && abs(g.value()[0]) <= abs(rate) * nearness(t, span))
                refuse_together(sides.who(), t, number);
        }
        ++number;
    };
    std::apply([&](const auto&... one) { (look(one), ...); }, list);
}

}  // namespace stagecraft::detail
