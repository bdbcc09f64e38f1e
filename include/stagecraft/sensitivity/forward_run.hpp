// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
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
#include <stagecraft/observe/event.hpp>
#include <stagecraft/sensitivity/consistent_start.hpp>
#include <stagecraft/sensitivity/forward_steps.hpp>
#include <stagecraft/sensitivity/parameters.hpp>
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
    template <class Result>
    void begin(const std::vector<scalar>& times, Result& r) {
        times_ = times;
        for (; next_ < times_.size() && times_[next_] == r.t; ++next_) push(r.y, r.S, r);
    }
    template <class Run, class Forward, class Result>
    void keep(const Run& run, const Forward& along, Result& r) {
        const bool up = run.output().step() > scalar(0);
        for (; next_ < times_.size() && (up ? times_[next_] <= run.t() : times_[next_] >= run.t()); ++next_) {
            const scalar& t = times_[next_];
            if (t == run.t())
                push(run.y(), along.S(), r);
            else
                push(run.output()(t), along.at(run.output(), t), r);
        }
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

/// A run with sensitivities, in pieces from one event to the next.
template <class Method, class Problem, class Vector, class Parameters, class Events>
class forward_run {
    using scalar = typename Vector::Scalar;
    using bound = with_sensitivities<Problem, Parameters, Vector>;
    using forward = forward_steps<bound, Vector>;
    using matrix = typename forward::matrix;
    using result_type = sensitivity_result<Vector, matrix>;
    static constexpr int event_count = static_cast<int>(std::tuple_size_v<Events>);

  public:
    forward_run(const Method& method, const Problem& problem, const Parameters& p, const scalar& t1,
                const options<scalar>& o, const sensitivity_options<Vector, Parameters>& s,
                const Events& events)
        : method_(method), problem_(problem), p_(p), t1_(t1), options_(o), more_(s), events_(events) {
        static_assert(event_count == 0 || !has_mass<bound>,
                      "sensitivities_with_events: not of a problem with mass()");
    }

    template <class Observer>
    result_type operator()(const scalar& t0, const Vector& y0, Observer& observer) {
        check_sensitivity_options(more_, y0.size(), p_.size(), t0, t1_);
        if (options_.consistent_start)
            throw std::invalid_argument(
                "sensitivities: options.consistent_start would move y0 and not what depends on it: give "
                "consistent_initial_values(problem, t0, y0).y as y0");
        options_.break_points.validate("sensitivities: break_points", t0, t1_, true);
        result_type r{{t0, y0, status::success, {}, nullptr},
                      more_.S0 ? *more_.S0 : matrix(matrix::Zero(y0.size(), p_.size()))};
        bool begins = true;
        try {
            while (begins || (event_ && r.ok() && r.t != t1_)) {
                event_ = false;
                piece(r, t1_, begins, event_count > 0, observer);
                begins = false;
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
    /// From r.t to `end`, or to the first event where they are watched.
    template <class Observer>
    void piece(result_type& r, const scalar& end, bool begins, bool watches, Observer& observer) {
        bound at_p(problem_, p_);
        const Vector start = r.y;
        integrator<Method, const bound, Vector> run(method_, at_p, start, r.t, end, options_);
        forward along(at_p, start, options_, r.S, more_);
        at_p.along = &along;
        if (begins) {
            start_consistently(along, method_, r.t, start, more_.S0 != nullptr);
            r.S = along.S();
            times_.begin(more_.times, r);
        }
        const scalar from = r.t;
        auto watch = watch_for(problem_, p_, events_, start);
        if constexpr (event_count > 0) watch.start(from, start, end);
        while (r.ok() && run.step()) {
            if (!along.step(run)) {
                r.status = along.unsolved() ? status::newton_failed : status::wrong_derivative;
                r.message = along.refuted();
                break;
            }
            if constexpr (event_count > 0)
                if (watches) {
                    watch(run.t(), run.y(), run.output().step(), run.output());
                    if (const auto* found = first_beyond(watch.found(), from)) {
                        r.report.add(run.counts());
                        return meet(r, run, along, found->event, found->t, observer);
                    }
                }
            r.t = run.t();
            r.y = run.y();
            r.S = along.S();
            times_.keep(run, along, r);
            if constexpr (!std::is_same_v<std::remove_cvref_t<Observer>, no_observer>)
                if (!observer(r.t, r.y, r.S)) run.stop();
        }
        if (r.ok()) r.status = run.status();
        if (r.status == status::step_underflow && along.unsolved()) r.status = status::newton_failed;
        r.report.add(run.counts());
    }

    /// The first of the events found that is not the one at which the piece began, of which rounding may have left g on
    /// either side of zero.
    template <class List>
    auto first_beyond(const List& list, const scalar& from) const -> decltype(list.data()) {
        using std::abs;
        for (const auto& one : list)
            if (one.event != last_event_ || abs(one.t - from) > 100 * near_) return &one;
        return nullptr;
    }

    /// Makes the last step again, up to the event, and goes across it.
    template <class Run, class Observer>
    void meet(result_type& r, const Run& run, const forward& along, int event, const scalar& t,
              Observer& observer) {
        using std::abs;
        r.t = run.output().t0();
        r.y = run.output().y0();
        r.S = along.S_before();
        const scalar begin = r.t;
        const Vector y_begin = r.y;
        if (t != r.t) piece(r, t, false, false, observer);
        if (!r.ok()) return;
        visit_at(events_, event, [&](const auto& one) {
            const scalar mean =
                (t - begin) == scalar(0) ? scalar(0) : scalar(one.g(begin, y_begin, p_)) / (t - begin);
            r.events.push_back(cross(one, event, problem_, p_, r.t, r.y, r.S, mean, near_));
            event_ = true;
            last_event_ = event;
            // Where the jump leads away from zero, this is no rounding.
            if (!(near_ < abs(t1_ - r.t) / 1000000000)) near_ = scalar(0);
            if (one.options.terminal) r.status = status::event;
        });
    }

    const Method& method_;
    Problem problem_;
    const Parameters& p_;
    scalar t1_;
    options<scalar> options_;
    const sensitivity_options<Vector, Parameters>& more_;
    Events events_;
    kept_times<Vector, matrix> times_;
    bool event_ = false;
    int last_event_ = -1;
    scalar near_{0};
};

}  // namespace detail

}  // namespace stagecraft
