// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include <stagecraft/observe/bracketing.hpp>
#include <stagecraft/observe/occurrence.hpp>
#include <stagecraft/status.hpp>

namespace stagecraft {

/// Which zeros of g count, and what follows.
struct event_options {
    crossing direction = crossing::both;
    bool terminal = false;  ///< end the run at the first one, with status::event
    bool at_start =
        false;  ///< g(t0, y0) = 0 is an event as well, whatever its direction (occurrence: crossing::both)
};

/// What is done at an event, if anything.
struct no_action {};

/// The function of an event with its options and what is done there; event() makes it.
template <class Function, class Action = no_action>
struct event_function {
    Function g;
    event_options options;
    [[no_unique_address]] Action action;
};

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

    void start(const scalar& t0, const Vector& y0, const scalar& t1) {
        using std::abs;
        found_.clear();
        ended_ = false;
        first_ = true;
        quiet_.clear();
        backwards_ = t1 < t0;
        for (std::size_t e = 0; e < events_.size(); ++e)
            if (events_[e].options.at_start && events_[e].g(t0, y0) == scalar(0)) {
                found_.push_back({static_cast<int>(e), t0, y0, crossing::both});
                ended_ = ended_ || events_[e].options.terminal;
            }
        span_ = std::max<scalar>(abs(t0), abs(t1));
    }

    /// True if the run ends before its first step.
    bool ends_at_start() const { return ended_; }
    /// The state has been changed at t: what was found beyond is void, and the run begins there.
    void changed(const scalar& t, const Vector&) {
        while (!found_.empty() && comes_before(t, found_.back().t)) found_.pop_back();
        ended_ = false;
        first_ = true;
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
        first_ = first_ || !follows(output.t0(), last_.t);
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

  protected:
    /// The events of which g = 0 where the run begins, or goes on behind a change, is known and not found again: all of them
    /// where the list is empty.
    void set_quiet(std::vector<char> quiet) { quiet_ = std::move(quiet); }
    const std::vector<event_function<function>>& list() const { return events_; }
    bool comes_before(const scalar& t, const scalar& u) const { return backwards_ ? t > u : t < u; }
    void go_on() { ended_ = false; }

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

    bool known_at_start(std::size_t e) const { return quiet_.empty() || quiet_[e] != 0; }
    /// True if rounding of t, of which each is found to one, can have separated these times.
    bool together(const scalar& t, const scalar& u) const {
        using std::abs;
        return !(abs(u - t) > 4 * resolution());
    }

    /// True if a step that begins at t follows one that ended at `end`, beyond a break point perhaps.
    static bool follows(const scalar& t, const scalar& end) {
        using std::abs;
        return !(abs(t - end) >
                 std::numeric_limits<scalar>::epsilon() * abs(end) + std::numeric_limits<scalar>::min());
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
            const scalar v = g(i.a + near);
            if (v == scalar(0)) return;
            if (first_ && !known_at_start(e) &&
                i.a == samples_.front().t) {  // what another one's change has led to
                i.at_a =
                    v < scalar(0) ? std::numeric_limits<scalar>::min() : -std::numeric_limits<scalar>::min();
            } else {
                i.a += near;
                i.at_a = v;
            }
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
        if (first_ && known_at_start(e) && (together(samples_.front().t, i.b) || begins(e, i.b))) return;
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
    std::vector<char> quiet_;
    bool first_ = true, ended_ = false, backwards_ = false;
    scalar span_{0};  // the largest |t| of the run, where it is known
};

}  // namespace stagecraft
