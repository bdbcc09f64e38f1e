// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace stagecraft {

/// Times at which a run makes a step end exactly, and the next begin afresh: where f jumps, or has a kink, and the user knows
/// it. A braced list, a std::vector, a vector of Eigen's, or every(period, first):
///
///     integrate(run, {.break_points = {8.0, 9.5}})
///     integrate(run, {.break_points = every(24.0, 8.0)})           // 8, 32, 56, ...
///     integrate(run, {.break_points = every(24.0, {7.0, 8.0})})    // 7, 8, 31, 32, ...
///
/// On each side f is asked only at times of that side, the neighbouring doubles of the break point at the nearest, so that
/// `t < 8` in f means what it says on both. Behind one everything is as at t0: no step is extrapolated or judged by those
/// before, the Jacobian is new, the first step is chosen anew. A list is strictly increasing, or decreasing; those of options
/// lie between t0 and t1, which may be break points as well: f is then asked on their inner side alone (at t1 it is told the
/// number before in every run). A problem says those that it knows itself by a member `auto break_points() const` that
/// returns such times, of any interval. Costs one first step each.
template <class Scalar>
class break_times {
  public:
    break_times() = default;
    break_times(std::initializer_list<Scalar> times) { add_group(Scalar(0), times); }
    template <class Times>
    requires requires(const Times& times) {
        times.begin() != times.end();
        Scalar(*times.begin());
    }
    break_times(const Times& times) { add_group(Scalar(0), times); }
    /// Those of another scalar.
    template <class Other>
    requires(!std::is_same_v<Other, Scalar>) break_times(const break_times<Other>& other)
        : numbers_(other.numbers().begin(), other.numbers().end()), rules_(&written) {}

    bool empty() const { return numbers_.empty(); }
    /// Groups of times, one after the other: the period with which they are repeated (0: not at all), how many, they.
    const std::vector<Scalar>& numbers() const { return numbers_; }
    std::vector<Scalar>& numbers() {
        rules_ = &written;
        return numbers_;
    }
    /// Takes in others.
    void add(const break_times& more) {
        rules_ = &written;
        numbers_.insert(numbers_.end(), more.numbers_.begin(), more.numbers_.end());
    }
    template <class Times>
    void add_group(const Scalar& period, const Times& times) {
        rules_ = &written;
        const std::size_t at = numbers_.size();
        numbers_.push_back(period);
        numbers_.push_back(Scalar(0));
        for (const auto& t : times) numbers_.push_back(Scalar(t));
        if (numbers_.size() == at + 2)
            numbers_.resize(at);
        else
            numbers_[at + 1] = Scalar(static_cast<long>(numbers_.size() - at - 2));
    }

    /// The first one beyond t on the way to `end`, which is `end` where there is none before.
    Scalar next(const Scalar& t, const Scalar& end) const {
        return rules_ ? rules_->next(*this, t, end) : end;
    }
    bool contains(const Scalar& t) const { return rules_ && rules_->contains(*this, t); }

    /// Throws std::invalid_argument, which begins with `who`, where times are not finite or not in order, and where they are
    /// repeated with a period that t does not resolve between t0 and t1. With `inside` all have to lie there.
    void validate(const char* who, const Scalar& t0, const Scalar& t1, bool inside) const {
        if (rules_) rules_->validate(*this, who, t0, t1, inside);
    }

  private:
    /// What is asked of times, by pointers that are set where times are written: a program that writes none has no code of it.
    struct rules {
        Scalar (*next)(const break_times&, const Scalar& t, const Scalar& end);
        bool (*contains)(const break_times&, const Scalar& t);
        void (*validate)(const break_times&, const char* who, const Scalar& t0, const Scalar& t1,
                         bool inside);
    };

    static Scalar find_next(const break_times& times, const Scalar& t, const Scalar& end) {
        Scalar nearest = end;
        const bool up = t < end;
        times.each_near(t, [&](const Scalar& x) {
            if (up ? t < x && x < nearest : t > x && x > nearest) nearest = x;
        });
        return nearest;
    }
    static bool find(const break_times& times, const Scalar& t) {
        bool found = false;
        times.each_near(t, [&](const Scalar& x) { found = found || x == t; });
        return found;
    }
    static void check(const break_times& times, const char* who, const Scalar& t0, const Scalar& t1,
                      bool inside) {
        const auto demand = [&](bool good, const char* what) {
            if (!good) throw std::invalid_argument(std::string(who) + what);
        };
        const Scalar low = t0 < t1 ? t0 : t1, high = t0 < t1 ? t1 : t0;
        times.each_group([&](const Scalar& period, const Scalar* x, std::size_t n) {
            for (std::size_t i = 0; i < n; ++i) demand(x[i] - x[i] == Scalar(0), " must be finite");
            for (std::size_t i = 1; i < n; ++i)
                demand(n < 2 || (x[0] < x[1] ? x[i - 1] < x[i] : x[i - 1] > x[i]),
                       " must be in order, each one once");
            if (period != Scalar(0)) {
                using std::abs;
                demand(period > Scalar(0) && period - period == Scalar(0),
                       ": the period of every() must be positive and finite");
                demand(period > 16 * std::numeric_limits<Scalar>::epsilon() * (abs(low) + abs(high)),
                       ": t does not resolve the period of every()");
                demand(abs(x[n - 1] - x[0]) < period, ": the times of every() must lie within one period");
            } else if (inside) {
                for (std::size_t i = 0; i < n; ++i)
                    demand(low <= x[i] && x[i] <= high, " must lie between t0 and t1");
            }
        });
    }
    template <class Visit>
    void each_group(const Visit& visit) const {
        for (std::size_t at = 0; at < numbers_.size();) {
            const std::size_t n = static_cast<std::size_t>(static_cast<long>(numbers_[at + 1]));
            visit(numbers_[at], numbers_.data() + at + 2, n);
            at += n + 2;
        }
    }
    /// The times about t.
    template <class Visit>
    void each_near(const Scalar& t, const Visit& visit) const {
        using std::floor;
        each_group([&](const Scalar& period, const Scalar* x, std::size_t n) {
            if (period == Scalar(0)) {
                const bool up = x[0] < x[n - 1];
                const Scalar* const at = std::partition_point(
                    x, x + n, [&](const Scalar& before) { return up ? before < t : before > t; });
                for (const Scalar* i = at == x ? at : at - 1; i != x + n && i <= at + 1; ++i) visit(*i);
                return;
            }
            for (std::size_t i = 0; i < n; ++i) {
                const Scalar k = floor((t - x[i]) / period);
                for (int more = -1; more <= 2; ++more)
                    if (k + Scalar(more) >= Scalar(0)) visit(Scalar(x[i] + (k + Scalar(more)) * period));
                if (k < Scalar(0)) visit(x[i]);
            }
        });
    }

    static constexpr rules written{&find_next, &find, &check};

    std::vector<Scalar> numbers_;
    const rules* rules_ = nullptr;
};

/// Optional: `problem.break_points()` returns the times at which f jumps or has a kink: a std::vector, a break_times, or
/// every(period, first). Steps end there; those beyond the run do not matter. Observers may have such a member as well.
template <class Problem>
concept has_break_points = requires(Problem& p) {
    p.break_points().begin();
}
|| requires(Problem& p) { p.break_points().numbers(); };

/// The times first, first + period, first + 2 period, ... without end, for options.break_points.
template <class Scalar>
requires std::is_arithmetic_v<Scalar>
auto every(Scalar period, std::type_identity_t<Scalar> first = 0) {
    using real = std::conditional_t<std::is_integral_v<Scalar>, double, Scalar>;
    break_times<real> times;
    times.add_group(period == Scalar(0) ? real(-1) : real(period), std::initializer_list<real>{real(first)});
    return times;
}
/// Several times in each period, {7.0, 8.0}, say.
template <class Scalar>
requires std::is_arithmetic_v<Scalar>
auto every(Scalar period, std::initializer_list<std::type_identity_t<Scalar>> times_of_first_period) {
    using real = std::conditional_t<std::is_integral_v<Scalar>, double, Scalar>;
    break_times<real> times;
    times.add_group(period == Scalar(0) ? real(-1) : real(period), times_of_first_period);
    return times;
}

}  // namespace stagecraft
