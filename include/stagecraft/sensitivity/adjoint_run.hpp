// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include <stagecraft/integrate.hpp>
#include <stagecraft/sensitivity/adjoint_steps.hpp>
#include <stagecraft/sensitivity/functionals.hpp>
#include <stagecraft/sensitivity/halved_steps.hpp>

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

/// A run forward with checkpoints, from one data time to the next, and back; and, where the error of the gradient is to be
/// estimated, a second one beside it whose steps are halved.
template <class Method, class Problem, class Vector, class Functionals>
class adjoint_run {
    using scalar = typename Vector::Scalar;
    using run_type = integrator<Method, const Problem, Vector>;
    using steps_type = adjoint_steps<Method, Problem, Vector, Functionals>;
    using finer_type = halved_steps<Method, Problem, Vector>;

  public:
    adjoint_run(const Method& method, const Problem& problem, const Vector& y0, const scalar& t0,
                const scalar& t1, const Functionals& functionals, const options<scalar>& o, bool estimate)
        : method_(method),
          problem_(problem),
          y0_(y0),
          options_(o),
          ends_(data_times(functionals, t0, t1)),
          functionals_(functionals) {
        // Arguments are checked before anything else is made.
        run_type(method_, problem_, y0_, t0, t1, options_);
        if (options_.consistent_start)
            throw std::invalid_argument(
                "adjoint_gradient: options.consistent_start would move y0 and not what depends on it: give "
                "consistent_initial_values(problem, t0, y0).y as y0");
        options_.break_points.validate("adjoint_gradient: break_points", t0, t1, true);
        if (estimate) finer_.emplace(method, problem, y0, o);
    }

    /// The whole run, into r.
    template <class Result>
    void forward(Result& r) {
        scalar t = ends_.front();
        Vector y = y0_, finer = y0_;
        for (std::size_t k = 1; k < ends_.size() && r.ok(); ++k) {
            pieces_.push_back({{}, y, finer});
            piece& now = pieces_.back();
            run_type run(method_, problem_, y, t, ends_[k], options_);
            do now.kept.save([&] { return point{checkpoint_of(run), finer}; });
            while (advance(run, finer));
            r.t = t = run.t();
            r.y = y = run.y();
            r.status = run.status();
            r.report.add(run.counts());
            now.end = y;
            now.finer_end = finer;
        }
    }

    /// Back again; false, with a status in r, where that fails.
    template <class Result>
    bool backward(Result& r) {
        coarse_.emplace(method_, problem_, y0_, options_, functionals_);
        if (finer_) fine_.emplace(method_, problem_, y0_, options_, functionals_);
        for (std::size_t k = pieces_.size(); k > 0; --k) {
            piece& now = pieces_[k - 1];
            at_end(k + 1 == ends_.size(), ends_[k], now.end, now.finer_end);
            for (auto& points = now.kept.points(); !points.empty(); points.pop_back())
                if (!back(now, points.back(), ends_[k], r)) return false;
            pieces_.pop_back();
        }
        // What is left of the data is at t0; in a run from t0 to t0 the end is there as well.
        at_end(ends_.size() == 1, ends_.front(), y0_, y0_);
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
    struct piece {
        thinned_points<point> kept;
        Vector end, finer_end;
    };

    /// t0, the data times beyond it, t1.
    static std::vector<scalar> data_times(const Functionals& functionals, const scalar& t0,
                                          const scalar& t1) {
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
        std::sort(all.begin(), all.end());
        if (!up) std::reverse(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }

    /// A step of the run, and of the one beside it; false at the end.
    bool advance(run_type& run, Vector& finer) {
        if (!run.step()) return false;
        if (finer_ && !finer_->follow(run.output(), run.last_method(), finer, [](const auto&) {}))
            finer_.reset();
        return true;
    }

    void at_end(bool last, const scalar& t, const Vector& y, const Vector& finer) {
        const auto add = [&](auto& steps, const Vector& at) {
            if (last) steps->end(at);
            steps->data(t, at);
        };
        add(coarse_, y);
        if (fine_) add(fine_, finer);
    }

    /// The steps from one checkpoint on, made again and taken back.
    template <class Result>
    bool back(piece& now, point& from, const scalar& t1, Result& r) {
        using output_type = typename run_type::output_type;
        std::vector<std::pair<output_type, int>> steps, halves;
        run_type again(method_, problem_, from.at.y, from.at.t, t1, options_);
        restore(again, from.at);
        while (static_cast<long>(steps.size()) < now.kept.spacing() && again.step()) {
            steps.emplace_back(again.output(), again.last_method());
            if (finer_)
                finer_->follow(again.output(), again.last_method(), from.finer,
                               [&](const auto& half) { halves.emplace_back(half, again.last_method()); });
        }
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
    const Problem& problem_;
    Vector y0_;
    options<scalar> options_;
    std::vector<scalar> ends_;
    const Functionals& functionals_;
    std::vector<piece> pieces_;
    std::optional<finer_type> finer_;
    std::optional<steps_type> coarse_, fine_;
};

}  // namespace stagecraft::detail
