// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <stagecraft/observe/changed_state.hpp>
#include <stagecraft/observe/event_watch.hpp>

namespace stagecraft {

namespace detail {
template <class Vector>
using action = std::function<void(const typename Vector::Scalar&, Vector&)>;
template <class Vector, class Action>
action<Vector> action_function(Action a) {
    return action<Vector>(std::move(a));
}
template <class Vector>
action<Vector> action_function(no_action) {
    return {};
}
}  // namespace detail

/// Events at which something is done; made by events(), which says the rules.
template <class Vector>
class acting_event_watch : public event_watch<Vector> {
    using base = event_watch<Vector>;

  public:
    using scalar = typename Vector::Scalar;
    using function = typename base::function;

    acting_event_watch(std::vector<event_function<function>> events,
                       std::vector<detail::action<Vector>> actions)
        : base(cut_at_actions(events, actions)), actions_(std::move(actions)), last_times_(actions_.size()) {}

    void start(const scalar& t0, const Vector& y0, const scalar& t1) {
        base::start(t0, y0, t1);
        t0_ = t0;
        acted_ = 0;
        alternating_.clear();
        for (auto& times : last_times_) times.fill(std::numeric_limits<scalar>::quiet_NaN());
    }
    /// Does what is to be done at the events found last, which end at t.
    bool change(const scalar& t, Vector& y) {
        if (!this->ended() || this->found().back().t != t) return false;
        std::vector<char> now(actions_.size(), 0);
        bool terminal = false;
        for (std::size_t k = acted_; k < this->found().size(); ++k) {
            const auto& o = this->found()[k];
            if (!took_place_with(o.t, t)) continue;
            const auto e = static_cast<std::size_t>(o.event);
            now[e] = 1;
            terminal = terminal || (this->list()[e].options.terminal && !actions_[e]);
        }
        if (terminal || chatters(t, now)) return false;
        for (std::size_t e = 0; e < actions_.size(); ++e)
            if (now[e] && actions_[e])
                detail::change_by(actions_[e], t, y, "event: the action of event " + std::to_string(e));
        acted_ = this->found().size();
        this->set_quiet(std::move(now));
        this->go_on();
        return true;
    }
    void changed(const scalar& t, const Vector& y) {
        base::changed(t, y);
        acted_ = std::min(acted_, this->found().size());
    }
    /// The numbers of the events that alternate where the run has ended in status::chattering.
    const std::vector<int>& alternating() const { return alternating_; }

    template <class Result>
    void conclude(Result& r) {
        if (!alternating_.empty() && r.status == status::stopped) {
            r.status = status::chattering;
            r.exception = std::make_exception_ptr(std::runtime_error(described(r.t)));
            this->go_on();
        }
        base::conclude(r);
    }

  private:
    static std::vector<event_function<function>> cut_at_actions(
        std::vector<event_function<function>> events, const std::vector<detail::action<Vector>>& actions) {
        for (std::size_t e = 0; e < events.size(); ++e)
            if (actions[e]) events[e].options.terminal = true;
        return events;
    }
    /// By no more than rounding apart, as event_watch takes them together.
    static bool took_place_with(const scalar& t, const scalar& u) {
        using std::abs;
        return !(abs(u - t) > 16 * std::numeric_limits<scalar>::epsilon() * abs(u));
    }
    /// True if one of the events has taken place `bound` times in a moment, this time included.
    bool chatters(const scalar& t, const std::vector<char>& now) {
        using std::abs;
        const scalar moment = std::max<scalar>(abs(t), abs(t - t0_)) / scalar(100000000000);
        bool too_often = false;
        for (std::size_t e = 0; e < now.size(); ++e) {
            if (!now[e] || !actions_[e]) continue;
            auto& times = last_times_[e];
            std::rotate(times.begin(), times.begin() + 1, times.end());
            times.back() = t;
            too_often = too_often || abs(t - times.front()) <= moment;
        }
        if (!too_often) return false;
        for (std::size_t e = 0; e < now.size(); ++e)
            if (abs(t - last_times_[e].back()) <= moment) alternating_.push_back(static_cast<int>(e));
        return true;
    }
    std::string described(const scalar& t) const {
        std::ostringstream text;
        text.precision(std::numeric_limits<scalar>::max_digits10);
        text << (alternating_.size() > 1 ? "events: events" : "events: event");
        for (std::size_t k = 0; k < alternating_.size(); ++k)
            text << (k == 0 ? " " : k + 1 < alternating_.size() ? ", " : " and ") << alternating_[k];
        text << (alternating_.size() > 1 ? " take" : " takes") << " place again and again at t = " << t
             << ": the solution slides along the zeros of g, or comes to rest there";
        return text.str();
    }

    static constexpr std::size_t bound = 5;
    std::vector<detail::action<Vector>> actions_;
    std::vector<std::array<scalar, bound>> last_times_;
    std::vector<int> alternating_;
    std::size_t acted_ = 0;  // of found(), those behind which y has been changed
    scalar t0_{0};
};

}  // namespace stagecraft
