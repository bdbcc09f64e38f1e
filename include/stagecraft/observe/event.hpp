// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/observe/bracketing.hpp>
#include <stagecraft/observe/occurrence.hpp>
#include <stagecraft/owned_value.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>
#include <stagecraft/refuse/detect/taken_arguments.hpp>
#include <stagecraft/status.hpp>

namespace stagecraft {

/// Which zeros of g count, and what follows.
struct event_options {
    crossing direction = crossing::both;
    bool terminal = false;  ///< end the run at the first one, with status::event
};

/// The function of an event with its options; event() makes it.
template <class Function>
struct event_function {
    Function g;
    event_options options;
};

/// The event "g(t, y) reaches or crosses zero" for a continuous g, which returns a number; events() says
/// how zeros are found, what that costs, and what a NaN does. In a distributed run (problem.add_up) y is the part of one
/// process: g has to return the same number on all, from sums of its own. Where the numbers differ, a terminal event still
/// ends the run on all processes, but only those that saw it end at its time.
template <class Function>
event_function<Function> event(Function g, event_options o = {}) {
    return {std::move(g), o};
}

namespace detail {
struct call_of_event {
    template <class T>
    static constexpr bool say() {
        static_assert(
            never<T>,
            "event(g, options): options are {.direction = crossing::falling, .terminal = true}, where "
            "direction is crossing::both, crossing::rising or crossing::falling (of stagecraft)");
        return true;
    }
};
}  // namespace detail

/// Options of other names or types.
event_function<std::nullptr_t> event(detail::refused_call<detail::call_of_event>, detail::misnamed_options);
event_function<std::nullptr_t> event(detail::refused_call<detail::call_of_event>, ...);

namespace detail {
template <class Function, class Vector>
constexpr bool returns_bool = requires(Function& g, const typename Vector::Scalar& t, const Vector& y) {
    { g(t, y) } -> std::same_as<bool>;
};
}  // namespace detail

/// An observer that locates events on the continuous solution. Made by events(), which says how.
template <class Vector>
class event_watch {
  public:
    using scalar = typename Vector::Scalar;
    using function = std::function<scalar(const scalar&, const Vector&)>;

    /// Throws std::invalid_argument if the list is empty.
    explicit event_watch(std::vector<event_function<function>> events) : events_(std::move(events)) {
        if (events_.empty()) throw std::invalid_argument("events: give at least one event");
    }

    /// The events of the last run that this observer has seen, in the order of the run, a std::vector. (Its type is
    /// deduced: a loop over `found` without parentheses is refused in five lines then, not in a hundred.)
    const auto& found() const { return found_; }
    auto begin() const { return found_.begin(); }
    auto end() const { return found_.end(); }
    /// True if the last entry of found() has ended the run.
    bool ended() const { return ended_; }

    void start(const scalar& t0, const Vector&, const scalar& t1) {
        using std::abs;
        found_.clear();
        ended_ = false;
        first_ = true;
        span_ = std::max<scalar>(abs(t0), abs(t1));
    }

    /// False if the run ends in this step; for loops that are written by hand (steps.hpp).
    template <class Output>
    requires requires(const Output& o, const scalar& t, Vector& y) { o.evaluate(t, y); }
    bool operator()(const scalar& t, const Vector& y, const scalar& h, const Output& output) {
        return end_inside(t, y, h, output) == nullptr;
    }
    /// Finds the events of a step; the last one if it ends the run, else null.
    template <class Output>
    requires requires(const Output& o, const scalar& t, Vector& y) { o.evaluate(t, y); }
    const occurrence<Vector>* end_inside(const scalar& t, const Vector& y, const scalar&,
                                         const Output& output) {
        if (ended_) return &found_.back();
        backwards_ = t < output.t0();
        first_ = first_ || output.t0() != last_.t;
        take_samples(t, y, output);
        const step_solution<Output> solution{output, t, y, at_};
        std::size_t settled = 0;
        for (std::size_t k = 1; k < samples_.size(); ++k) {
            // Beyond a terminal event only for what takes place together with it.
            if (ended_ && !together(found_.back().t, samples_[k - 1].t)) break;
            if (!ended_) settled = found_.size();
            for (std::size_t e = 0; e < events_.size(); ++e)
                search(e, samples_[k - 1], samples_[k], solution);
            settle(settled);
            if (!ended_) demand_numbers(samples_[k]);
        }
        first_ = false;
        return ended_ ? &found_.back() : nullptr;
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
    /// True if rounding of t, of which each is found to one, can have separated these times.
    bool together(const scalar& t, const scalar& u) const {
        using std::abs;
        return !(abs(u - t) > 4 * resolution());
    }

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

    /// All g at 2 * degree (at least four) equidistant points of the step. Those at its beginning are known
    /// from the step before and are not evaluated anew, which could give another rounding.
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

    /// True if g of event e may reach zero between two samples of the same sign, judged by its variation over
    /// the step.
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
        if (is_nan(a.g[e]) || is_nan(b.g[e])) return;
        const auto g = [&](const scalar& t) {
            const scalar v = events_[e].g(t, solution(t));
            if (is_nan(v)) fail(e, t);
            return v;
        };
        search(e, {a.t, a.g[e], b.t, b.g[e]}, g, solution, 0);
    }

    /// The same between any two times. Two crossings leave the sign unchanged; they are suspected where g
    /// heads for zero at both ends. Two more beside a crossing found at r are suspected where g / (t - r)
    /// does the same.
    template <class G, class Solution>
    void search(std::size_t e, time_bracket<scalar> i, const G& g, const Solution& solution, int depth) {
        using std::abs;
        const scalar near = (i.b - i.a) / 1024;
        if (depth > 4 || abs(near) < resolution()) return add(e, i, g, solution);
        if (i.at_a == scalar(0)) {  // was reported on arrival; what counts is where g goes from here
            i.a += near;
            i.at_a = g(i.a);
            if (i.at_a == scalar(0)) return;
        }
        scalar t{}, v{};
        const auto dips = [&](const auto& f, const time_bracket<scalar>& j, const scalar& touch) {
            return heads_for_zero(j.at_a, f(j.a + near)) && heads_for_zero(j.at_b, f(j.b - near)) &&
                   find_dip(f, j, touch, t, v);
        };
        if (!changes_sign(i)) {
            // A smooth g that touches zero is as flat there as rounding of its values on the way.
            const scalar touch =
                4 * std::numeric_limits<scalar>::epsilon() * std::max<scalar>(abs(i.at_a), abs(i.at_b));
            if (!may_dip(e, i.at_a, i.at_b) || !dips(g, i, touch)) return;
            search(e, {i.a, i.at_a, t, v}, g, solution, depth + 1);
            return search(e, {t, v, i.b, i.at_b}, g, solution, depth + 1);
        }
        time_bracket<scalar> root = i;
        narrow(g, root, resolution());
        add(e, root, g, solution);
        const scalar r = root.b;
        const auto other_factor = [&](const scalar& x) {
            return x == r ? scalar(1) : scalar(g(x) / (x - r));
        };
        time_bracket<scalar> j = i;
        if (abs(r - j.a) < abs(near)) j.a += near;
        if (abs(r - j.b) < abs(near)) j.b -= near;
        j.at_a = other_factor(j.a);
        j.at_b = other_factor(j.b);
        if (changes_sign(j) || !dips(other_factor, j, scalar(0))) return;
        v *= t - r;
        const auto part = [&](const scalar& from, const scalar& at_from, const scalar& to,
                              const scalar& at_to) {
            search(e, {from, at_from, to, at_to}, g, solution, depth + 1);
        };
        if (comes_before(t, r)) {
            part(i.a, i.at_a, t, v);
            part(t, v, root.a, root.at_a);
            part(r, root.at_b, i.b, i.at_b);
        } else {
            part(i.a, i.at_a, root.a, root.at_a);
            part(r, root.at_b, t, v);
            part(t, v, i.b, i.at_b);
        }
    }

    /// True if a g with value `at` at an end of an interval and `inside` next to it comes nearer to zero.
    static bool heads_for_zero(const scalar& at, const scalar& inside) {
        return at < scalar(0) ? inside > at : inside < at;
    }

    /// The rounding of t in this step.
    scalar resolution() const {
        using std::abs;
        return std::numeric_limits<scalar>::epsilon() *
               std::max<scalar>(abs(samples_.front().t), abs(samples_.back().t));
    }

    /// Adds the one crossing in a bracket, if there is one and it counts.
    template <class G, class Solution>
    void add(std::size_t e, time_bracket<scalar> i, const G& g, const Solution& solution) {
        using std::abs;
        if (!changes_sign(i)) return;
        narrow(g, i, resolution());
        const crossing direction = i.at_a < scalar(0) ? crossing::rising : crossing::falling;
        const event_options& o = events_[e].options;
        if (o.direction != crossing::both && o.direction != direction) return;
        if (first_ && (together(samples_.front().t, i.b) || begins(e, i.b))) return;
        found_.push_back({static_cast<int>(e), i.b, solution(i.b), direction});
    }

    /// True if a crossing at t is the begin of the run itself: g starts from zero to rounding, and t is within
    /// the rounding of the times of the run, which the first step may be too short to show.
    bool begins(std::size_t e, const scalar& t) const {
        using std::abs;
        const scalar eps = std::numeric_limits<scalar>::epsilon();
        if (abs(t - samples_.front().t) > 4 * eps * span_) return false;
        scalar largest(0);
        for (const sample& s : samples_)
            if (abs(s.g[e]) > largest) largest = abs(s.g[e]);
        return !(abs(samples_.front().g[e]) > 16 * eps * largest);
    }

    /// Sorts the events added since `from` into the order of the run, and ends the run at the first terminal
    /// one and those that take place together with it.
    void settle(std::size_t from) {
        const auto begin = found_.begin() + static_cast<std::ptrdiff_t>(from);
        std::stable_sort(begin, found_.end(),
                         [this](const auto& a, const auto& b) { return comes_before(a.t, b.t); });
        const auto last = std::find_if(begin, found_.end(), [this](const auto& o) {
            return events_[static_cast<std::size_t>(o.event)].options.terminal;
        });
        if (last == found_.end()) return;
        ended_ = true;
        const scalar end = last->t;
        found_.erase(std::find_if(last, found_.end(), [&](const auto& o) { return !together(end, o.t); }),
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
/// Vector is the type of the state and must be written out. The first terminal event ends the run:
/// result.status is status::event, result.t and result.y are the time and the state of the event, or of the
/// last one that only rounding of t (four epsilon) separates from it. Events are reported in the order of the
/// run, simultaneous ones in the order of the list.
///
/// Each g(t, y) is evaluated at 2 s points of every step (at least four) and, where it comes near zero, at a
/// few more, which reveal pairs of crossings. Each crossing is narrowed down to the rounding of t; its
/// accuracy is that of the continuous solution (dense_output.hpp). Missed may be a pair closer than about
/// 1/5000 of a step, a pair with a third crossing as near as the next sample, and a g that oscillates within
/// a step: options.max_step helps. g may be evaluated anywhere in a step, also beyond a terminal event.
///
/// The time reported is the first at which g is zero or has its new sign, so that a run continued from there
/// does not meet the same event again; an event within rounding of t0 is not reported. A smooth g that
/// reaches zero to rounding and turns back is an event. A g that returns NaN ends the run with status::function_threw
/// (std::domain_error naming the event and t).
///
/// A ball that bounces to rest bounces infinitely often in finite time. Its flights become shorter than t can
/// resolve, and then it leaves the floor no more: what begins on the far side of zero meets no event, and the ball
/// falls through. Whoever makes it bounce has to end it: where the speed v after a bounce no longer matters, or
/// at the latest where the flight of 2 v/g that follows is below some 1e-12 of t, the ball lies still, and the
/// run goes on without that degree of freedom.
template <class Vector, class... Functions>
requires requires { typename Vector::Scalar; }
event_watch<Vector> events(event_function<Functions>... list) {
    using function = typename event_watch<Vector>::function;
    using scalar = typename Vector::Scalar;
    constexpr bool callable = (std::is_constructible_v<function, Functions> && ...) &&
                              !(detail::mistakes_vectors<Functions, const scalar&, const Vector&>() || ...);
    static_assert(
        callable,
        "events: g in event(g) must be callable as g(t, y), y const or by value and of the type named in "
        "events<Vector>, and return a number");
    constexpr bool numbers = !(detail::returns_bool<Functions, Vector> || ...);
    static_assert(
        numbers,
        "events: g in event(g) returns a bool, whose change of sign is none: return the number that "
        "passes zero, y[0] - 1 for y[0] > 1");
    constexpr bool objects = [] {
        if constexpr (callable && numbers)
            return (detail::owned_or_none<Functions&, const scalar&, const Vector&> && ...);
        else
            return true;
    }();
    static_assert(
        objects,
        "events: g in event(g) returns a product of Eigen's, whose operands may be gone before it is "
        "evaluated: write n.dot(y), or (n.transpose() * y).value()");
    if constexpr (callable && numbers && objects)
        return event_watch<Vector>({event_function<function>{function(std::move(list.g)), list.options}...});
    else
        return event_watch<Vector>({});
}

namespace detail {
/// What events() returns that has been refused: nothing more is said about it.
struct refused_events : event_watch<Eigen::VectorXd> {
    refused_events() : event_watch({}) {}
    void operator()(const auto&...) {}
};
}  // namespace detail

/// Without the type of the state it does not compile, nor without event().
template <class Vector = detail::unstated, class... Events>
requires(!requires(const Events&... e) {
    typename Vector::Scalar;
    (e.options, ...);
}) detail::refused_events events(const Events&...) {
    static_assert(
        detail::never<Vector>,
        "events: write events<Vector2d>(event(g)), with the type of the state and event() around g");
    return {};
}

}  // namespace stagecraft
