// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace stagecraft {

/// Which of several events take place again and again in a moment: more than four times within 1e-11 of t, or of t - t0.
template <class Scalar>
class repeated_events {
  public:
    explicit repeated_events(std::size_t events) : last_times_(events) { start(Scalar(0)); }
    void start(const Scalar& t0) {
        t0_ = t0;
        alternating_.clear();
        for (auto& times : last_times_) times.fill(std::numeric_limits<Scalar>::quiet_NaN());
    }
    /// Takes in that some take place at t, now[e] != 0; true if that is too often, of which alternating() says the numbers.
    bool too_often(const Scalar& t, const std::vector<char>& now) {
        using std::abs;
        const Scalar moment = std::max<Scalar>(abs(t), abs(t - t0_)) / Scalar(100000000000);
        bool too_often = false;
        for (std::size_t e = 0; e < now.size(); ++e) {
            if (!now[e]) continue;
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
    const std::vector<int>& alternating() const { return alternating_; }
    std::string described(const Scalar& t) const {
        std::ostringstream text;
        text.precision(std::numeric_limits<Scalar>::max_digits10);
        text << (alternating_.size() > 1 ? "events: events" : "events: event");
        for (std::size_t k = 0; k < alternating_.size(); ++k)
            text << (k == 0 ? " " : k + 1 < alternating_.size() ? ", " : " and ") << alternating_[k];
        text << (alternating_.size() > 1 ? " take" : " takes") << " place again and again at t = " << t
             << ": the solution slides along the zeros of g, or comes to rest there";
        return text.str();
    }

  private:
    static constexpr std::size_t bound = 5;
    std::vector<std::array<Scalar, bound>> last_times_;
    std::vector<int> alternating_;
    Scalar t0_{0};
};

}  // namespace stagecraft
