// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/sensitivity/call_derivatives.hpp>
#include <stagecraft/sensitivity/changes.hpp>
#include <stagecraft/sensitivity/slopes.hpp>
#include <stagecraft/step/method_set.hpp>

namespace stagecraft::detail {

/// Differences good for fewer digits than these are refused: no function with a derivative has such.
template <class Scalar>
void demand_derivative(const char* who, const Scalar& t, int number, const Scalar& error) {
    if (!(error * 10000 < Scalar(1)))
        no_derivative(
            who, t,
            "g, or what is done, of change " + std::to_string(number) +
                " has no derivative that differences find: write it generic, const auto& and auto&");
}

/// What lies on both sides of a change of the state, at one point of p.
template <class Vector, class Parameters, class Changes>
class change_sides {
    using scalar = typename Vector::Scalar;

  public:
    using derivatives = call_derivatives<Vector, Parameters>;

    change_sides(const Changes& changes, const Parameters& p, const scalar& span, const char* who)
        : changes_(changes), p_(p), span_(span), who_(who) {}

    /// g of event `number` at (t, y).
    void take_event(int number, const scalar& t, const Vector& y, derivatives& g) const {
        visit_at(changes_, number, [&](const auto& one) {
            if constexpr (is_located<std::remove_cvref_t<decltype(one)>>)
                g.at(event_value<std::remove_cvref_t<decltype(one.g)>>{one.g}, t, y, p_, true, span_);
        });
    }
    /// What change `number` makes of y; std::domain_error where that is not finite or of another size.
    void take_change(int number, const scalar& t, const Vector& y, bool time_moves, derivatives& to) const {
        visit_at(changes_, number, [&](const auto& one) { to.at(behind(one), t, y, p_, time_moves, span_); });
        if (to.value().size() != y.size() || !to.value().allFinite())
            no_derivative(who_, t,
                          "the action of change " + std::to_string(number) +
                              " must leave y finite and of the same size");
    }
    template <class Problem>
    void change(int number, Problem& problem) const {
        visit_at(changes_, number, [&](const auto& one) { change_problem(one, problem); });
    }
    bool terminal(int number) const {
        return visit_at(changes_, number, [](const auto& one) {
            if constexpr (is_located<std::remove_cvref_t<decltype(one)>>)
                return one.options.terminal;
            else
                return false;
        });
    }
    /// The numbers of the at() that act at t, in their order.
    std::vector<int> timed_at(const scalar& t) const {
        std::vector<int> numbers;
        int k = 0;
        const auto look = [&](const auto& one) {
            if constexpr (is_timed<std::remove_cvref_t<decltype(one)>>)
                if (break_times<scalar>(one.break_points()).contains(t)) numbers.push_back(k);
            ++k;
        };
        std::apply([&](const auto&... one) { (look(one), ...); }, changes_);
        return numbers;
    }
    const Parameters& p() const { return p_; }
    const char* who() const { return who_; }

    /// The rate of g along the solution; refused where it vanishes beside the mean slope of g in the step before.
    scalar rate_of(derivatives& g, int number, const scalar& t, const Vector& slope,
                   const scalar& mean) const {
        using std::abs;
        const scalar rate = g.along(scalar(1), slope, -1)[0];
        if (!(abs(rate) * 1000000 > abs(mean)) || rate == scalar(0))
            no_derivative(who_, t,
                          "event " + std::to_string(number) + " is grazing: its time has no derivative");
        return rate;
    }

  private:
    const Changes& changes_;
    const Parameters& p_;
    scalar span_;
    const char* who_;
};

/// Goes across what is done at a given time: S := d/dp of the state behind it.
template <class Sides, class Problem, class Vector, class Matrix>
void cross_time(const Sides& sides, const std::vector<int>& numbers, Problem& problem,
                const typename Vector::Scalar& t, Vector& y, Matrix& S,
                std::vector<event_derivative<Vector, Matrix>>& passed) {
    using scalar = typename Vector::Scalar;
    typename Sides::derivatives change;
    for (const int number : numbers) {
        event_derivative<Vector, Matrix> r{number, t, {}, y, S};
        r.dt.setZero(S.cols());
        sides.take_change(number, t, y, false, change);
        r.error = change.error();
        demand_derivative(sides.who(), t, number, r.error);
        for (Eigen::Index k = 0; k < S.cols(); ++k) S.col(k) = change.along(scalar(0), r.dy.col(k), k);
        y = change.value();
        passed.push_back(r);
        sides.change(number, problem);
    }
}

/// The events that take place together, of one run of S; see sensitivities_with_events().
template <class Bound, class Sides, class Vector, class Matrix>
class event_crossing {
    using scalar = typename Vector::Scalar;
    using slope_type = solution_slope<Bound, Vector>;
    using passed_type = event_derivative<Vector, Matrix>;

  public:
    event_crossing(const Sides& sides, std::vector<int> numbers, const options<scalar>& o)
        : sides_(sides), numbers_(std::move(numbers)), options_(o) {}

    /// From (t, y, S) before the events to behind them; moves t by what g there asks for. behind(problem, y) makes y the state
    /// from which the run goes on. `mean` is the mean slope of g in the step before, `near` becomes how long g takes to
    /// zero from what it is behind the event.
    template <class Problem, class Behind>
    void operator()(Problem& problem, scalar& t, Vector& y, Matrix& S, const scalar& mean, scalar& near,
                    std::vector<passed_type>& passed, const Behind& behind) {
        using std::abs;
        const Bound before(problem, sides_.p());
        slope_type slope(before, y, options_, sides_.who());
        Vector f = y;
        const scalar rate = locate(slope, t, y, S, f, mean);
        passed_type r{numbers_[0], t, {}, y, S};
        r.dt.resize(S.cols());
        for (Eigen::Index k = 0; k < S.cols(); ++k) {
            r.dt[k] = -g_.along(scalar(0), S.col(k), k)[0] / rate;
            r.dy.col(k) = S.col(k) + r.dt[k] * f;
        }
        r.error = g_.error();
        demand_derivative(sides_.who(), t, numbers_[0], r.error);
        for (std::size_t i = 1; i < numbers_.size(); ++i) demand_same_time(numbers_[i], r, S, f);
        const std::size_t first = passed.size();
        for (const int number : numbers_) {
            r.event = number;
            passed.push_back(r);
            act(number, r);
            passed.back().error = r.error;
        }
        y = r.y;
        for (std::size_t i = first; i < passed.size(); ++i) sides_.change(passed[i].event, problem);
        behind(problem, y);
        const Bound now(problem, sides_.p());
        slope_type slope_now(now, y, options_, sides_.who());
        slope_now(t, y, f);
        for (Eigen::Index k = 0; k < S.cols(); ++k) S.col(k) = r.dy.col(k) - r.dt[k] * f;
        sides_.take_event(numbers_[0], t, y, g_);
        near = abs(g_.value()[0] / g_.along(scalar(1), f, -1)[0]);
    }

  private:
    /// The time was found on the continuous solution, which is less accurate than y: one step of Newton's. The rate of g.
    scalar locate(slope_type& slope, scalar& t, Vector& y, Matrix& S, Vector& f, const scalar& mean) {
        using std::abs;
        slope(t, y, f);
        sides_.take_event(numbers_[0], t, y, g_);
        const scalar change = -g_.value()[0] / g_.along(scalar(1), f, -1)[0];
        const scalar reach = abs(change) * f.template lpNorm<Eigen::Infinity>();
        if (reach - reach == scalar(0) && change != scalar(0)) {
            slope.move(t, y, change, S);
            y += change * f;
            t += change;
            slope(t, y, f);
            sides_.take_event(numbers_[0], t, y, g_);
        }
        return sides_.rate_of(g_, numbers_[0], t, f, mean);
    }
    /// Another event is at the same time for all p near, or which of the two comes first depends on p.
    void demand_same_time(int number, passed_type& r, const Matrix& S, const Vector& f) {
        using std::abs;
        sides_.take_event(number, r.t, r.y, other_);
        const scalar rate = sides_.rate_of(other_, number, r.t, f, scalar(0));
        scalar apart(0), size = std::numeric_limits<scalar>::min();
        for (Eigen::Index k = 0; k < S.cols(); ++k) {
            const scalar dt = -other_.along(scalar(0), S.col(k), k)[0] / rate;
            apart = std::max<scalar>(apart, abs(dt - r.dt[k]));
            size = std::max<scalar>(size, abs(r.dt[k]));
        }
        if (!(apart * 100000 <= size))
            no_derivative(
                sides_.who(), r.t,
                "events " + std::to_string(numbers_[0]) + " and " + std::to_string(number) +
                    " take place together, and which comes first depends on p: S has no derivative");
    }
    /// r.y and r.dy behind what is done at one event.
    void act(int number, passed_type& r) {
        sides_.take_change(number, r.t, r.y, true, other_);
        demand_derivative(sides_.who(), r.t, number, other_.error());
        if (other_.error() > r.error) r.error = other_.error();
        for (Eigen::Index k = 0; k < r.dy.cols(); ++k) {
            const Vector moved = r.dy.col(k);
            r.dy.col(k) = other_.along(r.dt[k], moved, k);
        }
        r.y = other_.value();
    }

    const Sides& sides_;
    std::vector<int> numbers_;
    const options<scalar>& options_;
    typename Sides::derivatives g_, other_;
};

}  // namespace stagecraft::detail
