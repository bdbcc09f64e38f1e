// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include <stagecraft/bracketing.hpp>
#include <stagecraft/status.hpp>

namespace stagecraft {

/// The way g goes through zero as the run proceeds, which is backwards in time when t1 < t0.
enum class crossing { both, rising, falling };

struct event_options {
    crossing direction = crossing::both;
    bool terminal = false;  ///< end the run at the first one, with status::event
};

template <class Function>
struct event_function {
    Function g;
    event_options options;
};

/// The event "g(t, y) reaches or crosses zero", g continuous.
template <class Function>
event_function<Function> event(Function g, event_options o = {}) {
    return {std::move(g), o};
}

/// An event that took place.
template <class Vector>
struct occurrence {
    int event;  ///< its place in the list given to events()
    typename Vector::Scalar t;
    Vector y;
    crossing direction;  ///< rising or falling
};

/// An observer that locates events on the continuous solution; made by events(). See there.
template <class Vector>
class event_watch {
  public:
    using scalar = typename Vector::Scalar;
    using function = std::function<scalar(const scalar&, const Vector&)>;

    /// Throws std::invalid_argument if the list is empty.
    explicit event_watch(std::vector<event_function<function>> events) : events_(std::move(events)) {
        if (events_.empty()) throw std::invalid_argument("events: give at least one event");
    }

    /// What took place, in the order of the run; of the last run this observer has seen.
    const std::vector<occurrence<Vector>>& found() const { return found_; }
    /// True if the last entry of found() has ended the run.
    bool ended() const { return ended_; }

    void start(const scalar& t0, const Vector&, const scalar& t1) {
        using std::abs;
        found_.clear();
        ended_ = false;
        first_ = true;
        span_ = std::max<scalar>(abs(t0), abs(t1));
    }

    template <class Output>
    bool operator()(const scalar& t, const Vector& y, const scalar&, const Output& output) {
        if (ended_) return false;
        backwards_ = t < output.t0();
        first_ = first_ || output.t0() != last_.t;
        take_samples(t, y, output);
        const step_solution<Output> solution{output, t, y, at_};
        for (std::size_t k = 1; k < samples_.size() && !ended_; ++k) {
            const std::size_t settled = found_.size();
            for (std::size_t e = 0; e < events_.size(); ++e)
                search(e, samples_[k - 1], samples_[k], solution);
            settle(settled);
            if (!ended_) demand_numbers(samples_[k]);
        }
        first_ = false;
        return !ended_;
    }

    template <class Result>
    void conclude(Result& r) {
        const bool replaces = r.status == status::stopped || r.status == status::event;
        if (ended_ && replaces && !comes_before(r.t, found_.back().t)) {
            r.t = found_.back().t;
            r.y = found_.back().y;
            r.status = status::event;
        }
        while (!found_.empty() && comes_before(r.t, found_.back().t)) {
            found_.pop_back();
            ended_ = false;
        }
    }

  private:
    struct sample {
        scalar t;
        std::vector<scalar> g;
    };

    /// The state at a time of the step; at its end the accepted one.
    template <class Output>
    struct step_solution {
        const Output& output;
        const scalar& end;
        const Vector& y_end;
        Vector& scratch;

        const Vector& operator()(const scalar& t) const {
            if (t == end) return y_end;
            output.evaluate(t, scratch);
            return scratch;
        }
    };

    bool comes_before(const scalar& t, const scalar& u) const { return backwards_ ? t > u : t < u; }

    static bool is_nan(const scalar& v) { return v != v; }
    [[noreturn]] static void fail(std::size_t event, const scalar& t) {
        std::ostringstream message;
        message.precision(std::numeric_limits<scalar>::max_digits10);
        message << "events: event " << event << " is NaN at t = " << t;
        throw std::domain_error(message.str());
    }
    void demand_numbers(const sample& s) const {
        for (std::size_t e = 0; e < events_.size(); ++e)
            if (is_nan(s.g[e])) fail(e, s.t);
    }

    /// All g at 2 * degree (at least four) equal parts of the step; those at its begin are known from the
    /// step before, so they are taken over rather than evaluated with other rounding.
    template <class Output>
    void take_samples(const scalar& t, const Vector& y, const Output& output) {
        const int parts = std::max(4, 2 * output.degree());
        const scalar t0 = output.t0();
        at_ = y;
        const step_solution<Output> solution{output, t, y, at_};
        samples_.resize(static_cast<std::size_t>(parts) + 1);
        for (sample& s : samples_) s.g.resize(events_.size());
        if (!first_) samples_[0] = last_;
        for (int k = first_ ? 0 : 1; k <= parts; ++k) {
            sample& s = samples_[static_cast<std::size_t>(k)];
            s.t = k == parts ? t : scalar(t0 + (t - t0) * scalar(k) / scalar(parts));
            const Vector& state = solution(s.t);
            for (std::size_t e = 0; e < events_.size(); ++e) s.g[e] = events_[e].g(s.t, state);
        }
        if (first_) demand_numbers(samples_[0]);
        last_ = samples_.back();
    }

    /// True if g of event e comes near enough to zero between two samples of one sign, as far as its
    /// variation over the step can tell.
    bool may_dip(std::size_t e, const scalar& at_a, const scalar& at_b) const {
        using std::abs;
        scalar low = at_a, high = at_a;
        for (const sample& s : samples_) {
            if (s.g[e] < low) low = s.g[e];
            if (s.g[e] > high) high = s.g[e];
        }
        return !(std::min<scalar>(abs(at_a), abs(at_b)) > high - low);
    }

    /// Adds the crossings of event e after sample a, up to sample b, to found_.
    template <class Solution>
    void search(std::size_t e, const sample& a, const sample& b, const Solution& solution) {
        time_bracket<scalar> i{a.t, a.g[e], b.t, b.g[e]};
        if (is_nan(i.at_a) || is_nan(i.at_b)) return;
        const auto g = [&](const scalar& t) {
            const scalar v = events_[e].g(t, solution(t));
            if (is_nan(v)) fail(e, t);
            return v;
        };
        const scalar near = (i.b - i.a) / 1024;
        if (i.at_a == scalar(0)) {  // was reported on arrival; what counts is where g goes from here
            i.a += near;
            i.at_a = g(i.a);
            if (i.at_a == scalar(0)) return;
        }
        if (changes_sign(i)) return add(e, i, g, solution);
        if (!may_dip(e, i.at_a, i.at_b)) return;
        // Of one sign at both ends: there may be two crossings if g heads for zero at both.
        const bool negative = i.at_a < scalar(0);
        const auto heads_for_zero = [&](const scalar& at, const scalar& inside) {
            return negative ? inside > at : inside < at;
        };
        if (!heads_for_zero(i.at_a, g(i.a + near)) || !heads_for_zero(i.at_b, g(i.b - near))) return;
        scalar t{}, v{};
        if (!find_dip(g, i, t, v)) return;
        add(e, {i.a, i.at_a, t, v}, g, solution);
        if (v != scalar(0)) add(e, {t, v, i.b, i.at_b}, g, solution);
    }

    template <class G, class Solution>
    void add(std::size_t e, time_bracket<scalar> i, const G& g, const Solution& solution) {
        using std::abs;
        const crossing direction = i.at_a < scalar(0) ? crossing::rising : crossing::falling;
        const event_options& o = events_[e].options;
        if (o.direction != crossing::both && o.direction != direction) return;
        const scalar t0 = samples_.front().t;
        const scalar largest = std::max<scalar>(abs(t0), abs(samples_.back().t));
        const scalar rounding = std::numeric_limits<scalar>::epsilon();
        narrow(g, i, rounding * largest);
        if (first_ && !(abs(i.b - t0) > 4 * rounding * std::max<scalar>(largest, span_))) return;
        found_.push_back({static_cast<int>(e), i.b, solution(i.b), direction});
    }

    /// Puts what was added since `from` into the order of the run, and ends it at the first terminal one.
    void settle(std::size_t from) {
        const auto begin = found_.begin() + static_cast<std::ptrdiff_t>(from);
        std::stable_sort(begin, found_.end(),
                         [this](const auto& a, const auto& b) { return comes_before(a.t, b.t); });
        const auto last = std::find_if(begin, found_.end(), [this](const auto& o) {
            return events_[static_cast<std::size_t>(o.event)].options.terminal;
        });
        if (last == found_.end()) return;
        ended_ = true;
        found_.erase(
            std::find_if(last, found_.end(), [&](const auto& o) { return comes_before(last->t, o.t); }),
            found_.end());
    }

    std::vector<event_function<function>> events_;
    std::vector<occurrence<Vector>> found_;
    std::vector<sample> samples_;
    sample last_{};
    Vector at_;
    bool first_ = true, ended_ = false, backwards_ = false;
    scalar span_{0};  // the largest |t| of the run, where it is known
};

/// An observer that locates events on the continuous solution, e.g.
///
///     auto watch = events<Vector2d>(event(height, {.terminal = true}), event(speed));
///     const auto r = integrate(method, problem, y0, t0, t1, options, watch);  // then watch.found()
///
/// Every g(t, y) is evaluated at 2 s points of each step (at least four) and, where it comes near zero
/// without changing sign, at the few more that show two crossings; each crossing is then narrowed down to the
/// rounding of t. Two crossings closer than about a 500th of a step, or a g that oscillates within a step,
/// may be missed: options.max_step is the cure. The time reported is the first at which g is zero or has its
/// new sign, so that a run continued from there does not meet the event again; one within rounding of t0 is
/// not reported. A g that reaches zero and turns back counts as reaching it. g may be evaluated anywhere in a
/// step, also beyond a terminal event. Events are reported in the order of the run, simultaneous ones in the
/// order of the list; the first terminal one ends the run: result.t and result.y are its, result.status is
/// status::event. A g that gives NaN within the run ends it with status::function_threw (std::domain_error
/// naming the event and t).
template <class Vector, class... Functions>
event_watch<Vector> events(event_function<Functions>... list) {
    using function = typename event_watch<Vector>::function;
    return event_watch<Vector>({event_function<function>{function(std::move(list.g)), list.options}...});
}

}  // namespace stagecraft
