// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/repeated_events.hpp>
#include <stagecraft/sensitivity/adjoint_steps.hpp>
#include <stagecraft/sensitivity/functionals.hpp>
#include <stagecraft/sensitivity/halved_steps.hpp>
#include <stagecraft/sensitivity/passage.hpp>

namespace stagecraft::detail {

/// Points along a run of unknown length, at most twice as many as there are steps between two.
template <class Point>
class thinned_points {
  public:
    template <class Take>
    void save(const Take& take) {
        if (steps_++ % spacing_ != 0) return;
        points_.push_back(take());
        if (points_.size() < 2 * static_cast<std::size_t>(spacing_)) return;
        spacing_ *= 2;
        for (std::size_t k = 1; 2 * k < points_.size(); ++k) points_[k] = std::move(points_[2 * k]);
        points_.resize((points_.size() + 1) / 2);
    }
    std::vector<Point>& points() { return points_; }
    long spacing() const { return spacing_; }

  private:
    std::vector<Point> points_;
    long steps_ = 0, spacing_ = 8;
};

/// A run forward with checkpoints, from one data time or change to the next, and back; and, where the error of the gradient is
/// to be estimated, a second one beside it whose steps are halved.
template <class Method, class Problem, class Vector, class Functionals, class Changes>
class adjoint_run {
    using scalar = typename Vector::Scalar;
    using run_type = integrator<Method, const Problem, Vector>;
    using steps_type = adjoint_steps<Method, Problem, Vector, Functionals>;
    using finer_type = halved_steps<Method, Problem, Vector>;
    using parameters = typename Problem::parameters;
    using sides_type = change_sides<Vector, parameters, Changes>;
    static constexpr bool changes = std::tuple_size_v<Changes> != 0, located = one_located<Changes>;
    static constexpr const char* who = changes ? "adjoint_gradient_with_events" : "adjoint_gradient";

  public:
    adjoint_run(const Method& method, const Problem& problem, const Vector& y0, const scalar& t0,
                const scalar& t1, const Functionals& functionals, const Changes& list,
                const options<scalar>& o, bool estimate)
        : method_(method),
          y0_(y0),
          options_(o),
          t1_(t1),
          functionals_(functionals),
          list_(list),
          times_(times_of_changes<scalar>(list_)),
          p_(problem.p),
          sides_(list_, p_, t1 == t0 ? scalar(1) : scalar(t1 < t0 ? t0 - t1 : t1 - t0), who),
          events_(p_, list_, y0) {
        problems_.push_back(problem);
        // Arguments are checked before anything else is made.
        run_type(method_, problems_[0], y0_, t0, t1, options_);
        if (options_.consistent_start)
            throw std::invalid_argument(
                "adjoint_gradient: options.consistent_start would move y0 and not what depends on it: give "
                "consistent_initial_values(problem, t0, y0).y as y0");
        options_.break_points.validate("adjoint_gradient: break_points", t0, t1, true);
        times_.validate("at: times", t0, t1, true);
        demand_no_event_at_start(list_);
        ends_ = data_times(functionals, t0, t1);
        options_.break_points.add(times_);
        span_ = t1 - t0;
        repeated_.start(t0);
        // Beside one with events a second run would have events of its own.
        if (estimate && !located) finer_.emplace(method, problems_[0], y0, o);
    }

    /// The whole run, into r.
    template <class Result>
    void forward(Result& r) {
        const scalar t0 = ends_.front();
        scalar t = t0;
        Vector y = y0_, finer = y0_;
        if (changes && times_.contains(t0)) {
            begin_piece(t0, y, finer);
            change(t, y, finer);
            pieces_.back().end = y;
            pieces_.back().finer_end = finer;
            r.y = y;
        }
        for (std::size_t k = 1; k < ends_.size() && r.ok();) {
            if (!stretch(ends_[k], t, y, finer, r)) return;
            while (k < ends_.size() && (t == ends_[k] || (t < ends_[k]) != (t0 < t1_))) ++k;
        }
    }

    /// Back again; false, with a status in r, where that fails.
    template <class Result>
    bool backward(Result& r) {
        problem_ = problems_.size() - 1;
        coarse_.emplace(method_, problems_[problem_], y0_, options_, functionals_);
        if (finer_) fine_.emplace(method_, problems_[problem_], y0_, options_, functionals_);
        bool last = true;
        for (; !pieces_.empty(); pieces_.pop_back()) {
            piece& now = pieces_.back();
            at_end(std::exchange(last, false), now.t_end, now.end, now.finer_end);
            Vector expected = now.end;
            if (!now.passed.empty()) {
                expected = now.passed[0].located ? now.passed[0].y_found : now.passed[0].states.front();
                back_over(now);
            }
            for (auto& points = now.kept.points(); !points.empty(); points.pop_back())
                if (!back(now, points.back(), expected, r)) return false;
        }
        // What is left of the data is at t0; in a run from t0 to t0 the end is there as well. What is done at t0 has been
        // taken back.
        if (last || !times_.contains(ends_.front())) at_end(last, ends_.front(), y0_, y0_);
        if (!forgets(as_tuple(method_))) {
            coarse_->make_consistent(ends_.front(), y0_);
            if (fine_) fine_->make_consistent(ends_.front(), y0_);
        }
        return true;
    }

    bool estimates() const { return finer_.has_value(); }
    const auto& states() const { return coarse_->states(); }
    const auto& finer_states() const { return fine_ ? fine_->states() : coarse_->states(); }

  private:
    struct point {
        checkpoint<Vector> at;
        Vector finer;
    };
    /// Steps from one end to the next, and what is passed there: by the run, and by the one beside it.
    struct piece {
        scalar planned, t_end;  // of the run, and where the steps end
        std::size_t problem;
        thinned_points<point> kept{};
        long steps = 0;
        Vector end, finer_end;
        std::vector<passage<Vector>> passed{};
    };

    /// t0, the data times and those of changes beyond it, t1.
    std::vector<scalar> data_times(const Functionals& functionals, const scalar& t0, const scalar& t1) const {
        std::vector<scalar> all{t0, t1};
        const bool up = t0 <= t1;
        const auto add = [&](const auto& g) {
            if constexpr (is_data_sum<std::remove_cvref_t<decltype(g)>>)
                for (const auto& t : g.times) {
                    const scalar at(t);
                    if (!(up ? t0 <= at && at <= t1 : t1 <= at && at <= t0))
                        throw std::invalid_argument("sum_over: times must be between t0 and t1");
                    all.push_back(at);
                }
        };
        std::apply([&](const auto&... g) { (add(g), ...); }, functionals);
        for (scalar t = t0; t != t1;) {
            t = times_.next(t, t1);
            all.push_back(t);
        }
        std::sort(all.begin(), all.end());
        if (!up) std::reverse(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }

    piece& begin_piece(const scalar& end, const Vector& y, const Vector& finer) {
        pieces_.push_back({end, end, problems_.size() - 1, {}, 0, y, finer, {}});
        return pieces_.back();
    }

    /// From (t, y) to `end`, or across the first event before that; false where the run ends.
    template <class Result>
    bool stretch(const scalar& end, scalar& t, Vector& y, Vector& finer, Result& r) {
        piece& now = begin_piece(end, y, finer);
        events_.start(t, y, end);
        std::vector<int> met;
        {
            run_type run(method_, problems_.back(), y, t, end, options_);
            take_steps(run, now, finer, &met);
            r.report.add(run.counts());
            r.status = run.status();
            t = r.t = met.empty() ? run.t() : run.output().t0();
            y = r.y = met.empty() ? run.y() : run.output().y0();
        }
        now.t_end = t;
        now.end = y;
        now.finer_end = finer;
        if (!r.ok()) return false;
        if constexpr (located)
            if (!met.empty()) return up_to_event(met, t, y, finer, r);
        if (!times_.contains(t)) return true;
        if constexpr (located)
            if (t == end) {
                Vector f = y;
                problems_.back()(t, std::as_const(y), f);
                demand_no_event(sides_, list_, t, y, f, span_);
            }
        change(t, y, finer);
        r.y = now.end = y;
        now.finer_end = finer;
        return true;
    }
    /// The steps of a run into a piece; until one of them has an event, which is not among them, if `met` is given.
    void take_steps(run_type& run, piece& now, Vector& finer, std::vector<int>* met) {
        for (;;) {
            now.kept.save([&] { return point{checkpoint_of(run), finer}; });
            if (!run.step()) return;
            if constexpr (located)
                if (met) {
                    *met = events_.in_last_step(run);
                    if (!met->empty()) return;
                }
            ++now.steps;
            if (finer_ && !finer_->follow(run.output(), run.last_method(), finer, [](const auto&) {}))
                finer_.reset();
        }
    }
    /// A step to an event, and across it.
    template <class Result>
    bool up_to_event(const std::vector<int>& met, scalar& t, Vector& y, Vector& finer, Result& r) {
        using std::abs;
        const scalar begin = t;
        demand_apart_from_times(who, times_, events_.t(), met[0], span_);
        if (met.size() > 1)
            no_derivative(who, events_.t(),
                          "events " + std::to_string(met[0]) + " and " + std::to_string(met[1]) +
                              " take place together: sensitivities_with_events() knows whether S exists");
        scalar mean(0);
        if (events_.t() != t) {
            typename sides_type::derivatives g;
            sides_.take_event(met[0], t, y, g);
            mean = g.value()[0] / (events_.t() - begin);
            piece& now = begin_piece(events_.t(), y, finer);
            run_type run(method_, problems_.back(), y, t, events_.t(), options_);
            take_steps(run, now, finer, nullptr);
            r.report.add(run.counts());
            r.status = run.status();
            t = r.t = run.t();
            y = r.y = run.y();
            now.t_end = t;
            now.end = y;
            if (!r.ok()) return false;
        }
        scalar near(0);
        piece& now = pieces_.back();
        Problem next = problems_.back();
        now.passed.push_back(pass_event(sides_, met[0], next, t, y, mean, near));
        r.t = t;
        r.y = now.end = y;
        now.t_end = t;
        problems_.push_back(next);
        events_.passed(met[0], near, scalar(abs(t1_ - t)));
        r.status = ended_by(now.passed[0], r);
        return r.ok();
    }
    template <class Result>
    status ended_by(const passage<Vector>& passed, Result& r) {
        if (passed.terminal) {
            for (const scalar& t : ends_)
                if (t != t1_ && (t1_ < r.t ? t < r.t : t > r.t) && !times_.contains(t))
                    no_derivative(who, r.t, "the run ends, before the last time of sum_over()");
            return status::event;
        }
        std::vector<char> now(std::tuple_size_v<Changes>, 0);
        now[static_cast<std::size_t>(passed.numbers[0])] = 1;
        if (!repeated_.too_often(r.t, now)) return status::success;
        r.exception = std::make_exception_ptr(std::runtime_error(repeated_.described(r.t)));
        return status::chattering;
    }
    /// What is done at t, at the end of the last piece.
    void change(const scalar& t, Vector& y, Vector& finer) {
        if constexpr (changes) {
            piece& now = pieces_.back();
            Problem next = problems_.back(), beside = next;
            now.passed.push_back(pass_time(sides_, next, t, y));
            if (finer_) now.passed.push_back(pass_time(sides_, beside, t, finer));
            if constexpr (has_mass<Problem>) {
                move_to_constraints(method_, std::as_const(next), t, t == t1_ ? scalar(t1_ - span_) : t1_,
                                    options_, y);
                if (finer_)
                    move_to_constraints(method_, std::as_const(next), t, t == t1_ ? scalar(t1_ - span_) : t1_,
                                        options_, finer);
            }
            problems_.push_back(next);
        }
    }

    void at_end(bool last, const scalar& t, const Vector& y, const Vector& finer) {
        const auto add = [&](auto& steps, const Vector& at) {
            if (last) steps->end(at);
            steps->data(t, at);
        };
        add(coarse_, y);
        if (fine_) add(fine_, finer);
    }
    /// Back over what is passed at the end of a piece, and to its problem.
    void back_over([[maybe_unused]] const piece& now) {
        if constexpr (changes) {
            // Algebraic components followed from the others there.
            coarse_->make_consistent(now.t_end, now.end);
            if (fine_) fine_->make_consistent(now.t_end, now.finer_end);
            use(now.problem);
            coarse_->back(now.passed.front(), sides_);
            if (fine_) fine_->back(now.passed.back(), sides_);
        }
    }
    void use(std::size_t problem) {
        if (problem_ == problem) return;
        problem_ = problem;
        const auto again = [&](auto& steps) {
            const auto states = steps->states();
            steps.emplace(method_, problems_[problem_], y0_, options_, functionals_);
            steps->states(states);
        };
        again(coarse_);
        if (fine_) again(fine_);
    }

    /// The steps from one checkpoint on, made again and taken back. They end at `expected`, which becomes where they begin.
    template <class Result>
    bool back(piece& now, point& from, Vector& expected, Result& r) {
        using output_type = typename run_type::output_type;
        std::vector<std::pair<output_type, int>> steps, halves;
        run_type again(method_, problems_[now.problem], from.at.y, from.at.t, now.planned, options_);
        restore(again, from.at);
        const long first = static_cast<long>(now.kept.points().size() - 1) * now.kept.spacing();
        const auto count = static_cast<std::size_t>(std::min(now.kept.spacing(), now.steps - first));
        while (steps.size() < count && again.step()) {
            steps.emplace_back(again.output(), again.last_method());
            if (finer_)
                finer_->follow(again.output(), again.last_method(), from.finer,
                               [&](const auto& half) { halves.emplace_back(half, again.last_method()); });
        }
        if (changes && again.y() != expected)
            no_derivative(
                who, again.t(),
                "f is not what it was at the same place before: what an action changes beside y, on the "
                "way back no action does; let change(problem) of sensitivity_event() set it");
        expected = from.at.y;
        const auto take_back = [&](auto& adjoint, const auto& list) {
            for (auto step = list.rbegin(); step != list.rend(); ++step)
                if (!adjoint->back(step->first, step->second)) {
                    r.message = adjoint->refuted();
                    r.status = r.message.empty() ? status::newton_failed : status::wrong_derivative;
                    return false;
                }
            return true;
        };
        if (!take_back(coarse_, steps)) return false;
        return !finer_ || take_back(fine_, halves);
    }

    const Method& method_;
    Vector y0_;
    options<scalar> options_;
    scalar t1_, span_{0};
    const Functionals& functionals_;
    Changes list_;
    break_times<scalar> times_;  // of what is done at given times
    parameters p_;
    sides_type sides_;
    located_events<Vector, parameters, Changes> events_;
    repeated_events<scalar> repeated_{std::tuple_size_v<Changes>};
    std::vector<scalar> ends_;
    std::deque<Problem> problems_;  // as they follow each other
    std::size_t problem_ = 0;       // on the way back
    std::vector<piece> pieces_;
    std::optional<finer_type> finer_;
    std::optional<steps_type> coarse_, fine_;
};

}  // namespace stagecraft::detail
