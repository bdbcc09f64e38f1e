// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <stagecraft/observe/changed_state.hpp>
#include <stagecraft/observe/event_watch.hpp>
#include <stagecraft/observe/repeated_events.hpp>

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
        : base(cut_at_actions(events, actions)), actions_(std::move(actions)), repeated_(actions_.size()) {}

    void start(const scalar& t0, const Vector& y0, const scalar& t1) {
        base::start(t0, y0, t1);
        acted_ = 0;
        repeated_.start(t0);
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
    const std::vector<int>& alternating() const { return repeated_.alternating(); }

    template <class Result>
    void conclude(Result& r) {
        if (!alternating().empty() && r.status == status::stopped) {
            r.status = status::chattering;
            r.exception = std::make_exception_ptr(std::runtime_error(repeated_.described(r.t)));
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
    bool chatters(const scalar& t, std::vector<char> now) {
        for (std::size_t e = 0; e < now.size(); ++e) now[e] = now[e] && actions_[e];
        return repeated_.too_often(t, now);
    }

    std::vector<detail::action<Vector>> actions_;
    repeated_events<scalar> repeated_;
    std::size_t acted_ = 0;  // of found(), those behind which y has been changed
};

}  // namespace stagecraft
