// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/repeated_events.hpp>
#include <stagecraft/sensitivity/changes.hpp>
#include <stagecraft/sensitivity/consistent_start.hpp>
#include <stagecraft/sensitivity/crossing.hpp>
#include <stagecraft/sensitivity/forward_steps.hpp>
#include <stagecraft/sensitivity/located_events.hpp>
#include <stagecraft/sensitivity/parameters.hpp>
#include <stagecraft/sensitivity/slopes.hpp>
#include <stagecraft/sensitivity/state_events.hpp>

namespace stagecraft {

/// The result of a run with dy/dp at its end, n x m.
template <class Vector, class Matrix>
struct sensitivity_result : result<Vector> {
    Matrix S;
    std::vector<Vector> y_at{};  ///< at the times asked for, as far as the run has come
    std::vector<Matrix> S_at{};
    std::vector<event_derivative<Vector, Matrix>> events{};
    std::string message{};  ///< of status::wrong_derivative: what disagrees, and where
};

namespace detail {

/// Makes S obey the derivative of the algebraic equations at (t, y); false where these do not determine it.
template <class Problem, class Vector>
bool make_consistent(forward_derivatives<Problem, Vector>& at, const typename Vector::Scalar& t,
                     const Vector& y,
                     typename sensitivity_options<Vector, typename Problem::parameters>::matrix& S) {
    using system_type = typename forward_derivatives<Problem, Vector>::system_type;
    using mass_type = typename system_type::mass_type;
    if constexpr (!mass_type::identity && has_entries<mass_type>) {
        at.place(0, t, y);
        at.evaluate(0);
        const matrix_pair<typename system_type::matrix, mass_type> pair{at.near_jacobian(0), at.mass()};
        Vector r = y, x = y, column = y, product = y;
        const auto add = [&](const Vector& v, Vector& out) {
            at(0, v, -1, product);
            out += product;
        };
        for (Eigen::Index k = 0; k < S.cols(); ++k) {
            column = S.col(k);
            at(0, column, static_cast<int>(k), r);
            if (!solve_algebraic<typename unstructured<typename system_type::blocks>::type>(pair, r, add, x))
                return false;
            S.col(k) += x;
        }
    }
    return true;
}

/// S at t0: its algebraic components follow from the others.
template <class Forward, class Method, class Vector>
void start_consistently(Forward& along, const Method& method, const typename Vector::Scalar& t0,
                        const Vector& y0, bool given) {
    auto& at = along.derivatives();
    if (std::remove_cvref_t<decltype(at)>::system_type::mass_type::identity) return;
    auto S = along.S();
    const bool consistent = at.evaluations().largest_index() < 2 && make_consistent(at, t0, y0, S);
    if (consistent)
        along.S() = S;
    else if (!given && !forgets(as_tuple(method)))
        throw std::invalid_argument(
            "sensitivities: S0 must be given: the method does not forget its algebraic components, and the "
            "algebraic equations, which are not of index 1 at y0, do not determine them");
}

template <class Vector, class Parameters, class Scalar>
void check_sensitivity_options(const sensitivity_options<Vector, Parameters>& s, Eigen::Index n,
                               Eigen::Index m, const Scalar& t0, const Scalar& t1) {
    const auto demand = [](bool good, const char* what) {
        if (!good) throw std::invalid_argument(std::string("sensitivities: ") + what);
    };
    demand(!s.S0 || (s.S0->rows() == n && s.S0->cols() == m),
           "S0 must have a row per component and a column per parameter");
    demand(s.scale.size() == 0 || s.scale.size() == m, "scale must have one number per parameter");
    for (Eigen::Index k = 0; k < s.scale.size(); ++k)
        demand(s.scale[k] > Scalar(0) && s.scale[k] - s.scale[k] == Scalar(0),
               "scale must be positive and finite");
    Scalar before = t0;
    for (const Scalar& t : s.times) {
        demand(t0 <= t1 ? before <= t && t <= t1 : t1 <= t && t <= before,
               "times must be in the order of the run, between t0 and t1");
        before = t;
    }
}

/// y and S at the times asked for.
template <class Vector, class Matrix>
class kept_times {
    using scalar = typename Vector::Scalar;

  public:
    explicit kept_times(const std::vector<scalar>& times) : times_(times) {}
    /// Those up to run.t(). Where y changes there, `changes`, the first of equal times there has the state before that, if
    /// there are others.
    template <class Run, class Forward, class Result>
    void keep(const Run& run, const Forward& along, bool changes, Result& r) {
        const bool up = run.output().step() > scalar(0);
        for (; next_ < times_.size() && (up ? times_[next_] <= run.t() : times_[next_] >= run.t()); ++next_) {
            const scalar& t = times_[next_];
            if (t == run.t() && changes) return before(r);
            if (t == run.t())
                push(run.y(), along.S(), r);
            else
                push(run.output()(t), along.at(run.output(), t), r);
        }
    }
    /// At r.t, before a change: the first of several equal times.
    template <class Result>
    void before(Result& r) {
        if (next_ + 1 < times_.size() && times_[next_] == r.t && times_[next_ + 1] == r.t) {
            push(r.y, r.S, r);
            ++next_;
        }
    }
    /// The rest of those at r.t.
    template <class Result>
    void here(Result& r) {
        for (; next_ < times_.size() && times_[next_] == r.t; ++next_) push(r.y, r.S, r);
    }

  private:
    template <class Result>
    static void push(const Vector& y, const Matrix& S, Result& r) {
        r.y_at.push_back(y);
        r.S_at.push_back(S);
    }
    std::vector<scalar> times_;
    std::size_t next_ = 0;
};

/// A run with sensitivities, in pieces from one change to the next.
template <class Method, class Problem, class Vector, class Parameters, class Changes>
class forward_run {
    using scalar = typename Vector::Scalar;
    using bound = with_sensitivities<Problem, Parameters, Vector>;
    using forward = forward_steps<bound, Vector>;
    using matrix = typename forward::matrix;
    using result_type = sensitivity_result<Vector, matrix>;
    static constexpr bool changes = std::tuple_size_v<Changes> != 0, located = one_located<Changes>;
    static constexpr const char* who = changes ? "sensitivities_with_events" : "sensitivities";

  public:
    forward_run(const Method& method, const Problem& problem, const Parameters& p, const Vector& y0,
                const scalar& t0, const scalar& t1, const options<scalar>& o,
                const sensitivity_options<Vector, Parameters>& s, const Changes& list)
        : method_(method),
          problem_(problem),
          p_(p),
          t1_(t1),
          span_(t1 - t0),
          options_(o),
          more_(s),
          list_(list),
          times_(times_of_changes<scalar>(list_)),
          sides_(list_, p_, span_between(t0, t1), who),
          kept_(s.times),
          events_(p_, list_, y0),
          repeated_(std::tuple_size_v<Changes>) {
        options_.break_points.validate("sensitivities: break_points", t0, t1_, true);
        times_.validate("at: times", t0, t1_, true);
        options_.break_points.add(times_);
    }

    template <class Observer>
    result_type operator()(const scalar& t0, const Vector& y0, Observer& observer) {
        check_sensitivity_options(more_, y0.size(), p_.size(), t0, t1_);
        demand_answerable();
        result_type r{{t0, y0, status::success, {}, nullptr},
                      more_.S0 ? *more_.S0 : matrix(matrix::Zero(y0.size(), p_.size()))};
        try {
            start(r);
            while (r.ok() && r.t != t1_) {
                met_ = false;
                piece(r, times_.next(r.t, t1_), true, observer);
                if (!r.ok() || met_ || !times_.contains(r.t)) continue;
                demand_no_event_here(r);
                act(r);
            }
        } catch (const std::invalid_argument&) {
            throw;
        } catch (...) {
            r.status = status::function_threw;
            r.exception = std::current_exception();
        }
        return r;
    }

  private:
    static scalar span_between(const scalar& t0, const scalar& t1) {
        using std::abs;
        return t1 == t0 ? scalar(1) : scalar(abs(t1 - t0));
    }
    void demand_answerable() const {
        if (options_.consistent_start)
            throw std::invalid_argument(
                "sensitivities: options.consistent_start would move y0 and not what depends on it: give "
                "consistent_initial_values(problem, t0, y0).y as y0");
        demand_no_event_at_start(list_);
    }

    /// y and S at t0, behind what is done there.
    void start(result_type& r) {
        bound at_p(problem_, p_);
        integrator<Method, const bound, Vector> run(method_, at_p, r.y, r.t, t1_, options_);
        forward along(at_p, r.y, options_, r.S, more_);
        start_consistently(along, method_, r.t, r.y, more_.S0 != nullptr);
        r.S = along.S();
        repeated_.start(r.t);
        if (times_.contains(r.t)) {
            kept_.before(r);
            act(r);
        }
        kept_.here(r);
    }
    /// What at() does at r.t.
    void act([[maybe_unused]] result_type& r) {
        if constexpr (changes) {
            Vector y = r.y;
            matrix S = r.S;
            cross_time(sides_, sides_.timed_at(r.t), problem_, r.t, y, S, r.events);
            r.y = y;
            r.S = S;
            make_consistent_behind(r);
            kept_.here(r);
        }
    }
    void demand_no_event_here([[maybe_unused]] const result_type& r) {
        if constexpr (located) {
            const bound at_p(problem_, p_);
            Vector f = r.y;
            solution_slope<bound, Vector>(at_p, r.y, options_, who)(r.t, r.y, f);
            demand_no_event(sides_, list_, r.t, r.y, f, span_);
        }
    }
    /// Behind a change y goes to the algebraic equations, and S to their derivatives, where these are of index 1.
    void make_consistent_behind(result_type& r) {
        if constexpr (has_mass<bound>) {
            bound at_p(problem_, p_);
            forward along(at_p, r.y, options_, r.S, more_);
            move_to_constraints(method_, at_p, r.t, r.t == t1_ ? scalar(t1_ - span_) : t1_, options_, r.y);
            start_consistently(along, method_, r.t, r.y, false);
            r.S = along.S();
        }
    }

    /// From r.t to `end`, or to the first event where they are watched.
    template <class Observer>
    void piece(result_type& r, const scalar& end, bool watches, Observer& observer) {
        bound at_p(problem_, p_);
        const Vector start = r.y;
        integrator<Method, const bound, Vector> run(method_, at_p, start, r.t, end, options_);
        forward along(at_p, start, options_, r.S, more_);
        at_p.along = &along;
        if (watches) events_.start(r.t, start, end);
        if constexpr (located) run.watch_between_ends();
        while (r.ok() && run.step()) {
            if (!along.step(run)) {
                r.status = along.unsolved() ? status::newton_failed : status::wrong_derivative;
                r.message = along.refuted();
                break;
            }
            if constexpr (located)
                if (watches) {
                    const std::vector<int> found = events_.in_last_step(run);
                    if (!found.empty()) {
                        r.report.add(run.counts());
                        return meet(r, run, along, found, observer);
                    }
                }
            r.t = run.t();
            r.y = run.y();
            r.S = along.S();
            kept_.keep(run, along, !watches || times_.contains(r.t), r);
            if constexpr (!std::is_same_v<std::remove_cvref_t<Observer>, no_observer>)
                if (!observer(r.t, r.y, r.S)) run.stop();
        }
        if (r.ok()) r.status = run.status();
        if (r.status == status::step_underflow && along.unsolved()) r.status = status::newton_failed;
        r.report.add(run.counts());
    }

    /// Makes the last step again, up to the event, and goes across it.
    template <class Run, class Observer>
    void meet(result_type& r, const Run& run, const forward& along, const std::vector<int>& numbers,
              Observer& observer) {
        using std::abs;
        const scalar t = events_.t();
        r.t = run.output().t0();
        r.y = run.output().y0();
        r.S = along.S_before();
        demand_apart_from_times(who, times_, t, numbers[0], span_);
        const scalar begin = r.t;
        scalar mean(0);
        if constexpr (located)
            if (t != begin) {
                typename decltype(sides_)::derivatives g;
                sides_.take_event(numbers[0], begin, r.y, g);
                mean = g.value()[0] / (t - begin);
                piece(r, t, false, observer);
            }
        if (!r.ok()) return;
        event_crossing<bound, decltype(sides_), Vector, matrix> crossing(sides_, numbers, options_);
        scalar at = r.t, near(0);
        Vector y = r.y;
        matrix S = r.S;
        crossing(problem_, at, y, S, mean, near, r.events, [&](const auto& problem, Vector& state) {
            if constexpr (has_mass<bound>) {
                const bound at_p(problem, p_);
                move_to_constraints(method_, at_p, at, at == t1_ ? scalar(t1_ - span_) : t1_, options_,
                                    state);
            }
        });
        r.t = at;
        r.y = y;
        r.S = S;
        if constexpr (has_mass<bound>) {
            bound at_p(problem_, p_);
            forward again(at_p, r.y, options_, r.S, more_);
            start_consistently(again, method_, r.t, r.y, false);
            r.S = again.S();
        }
        kept_.here(r);
        met_ = true;
        events_.passed(numbers[0], near, scalar(abs(t1_ - r.t)));
        end_or_go_on(r, numbers);
    }
    void end_or_go_on(result_type& r, const std::vector<int>& numbers) {
        std::vector<char> now(std::tuple_size_v<Changes>, 0);
        for (const int number : numbers) {
            now[static_cast<std::size_t>(number)] = 1;
            if (sides_.terminal(number)) r.status = status::event;
        }
        if (r.status == status::event || !repeated_.too_often(r.t, now)) return;
        r.status = status::chattering;
        r.exception = std::make_exception_ptr(std::runtime_error(repeated_.described(r.t)));
    }
    const Method& method_;
    Problem problem_;
    const Parameters& p_;
    scalar t1_, span_;
    options<scalar> options_;
    const sensitivity_options<Vector, Parameters>& more_;
    Changes list_;
    break_times<scalar> times_;  // of what is done at given times
    change_sides<Vector, Parameters, Changes> sides_;
    kept_times<Vector, matrix> kept_;
    located_events<Vector, Parameters, Changes> events_;
    repeated_events<scalar> repeated_;
    bool met_ = false;
};

}  // namespace detail

}  // namespace stagecraft
