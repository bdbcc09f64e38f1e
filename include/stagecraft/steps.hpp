// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>

#include <stagecraft/integrate.hpp>

namespace stagecraft {

/// One accepted step as a loop sees it. t, y and output refer to the run and are valid until the next step.
template <class Vector, class Output>
struct step_view {
    const typename Vector::Scalar& t;  ///< the end of the step
    const Vector& y;                   ///< the state there
    typename Vector::Scalar h;         ///< negative when time runs backwards
    const Output& output;              ///< the continuous solution over the step
};

/// The accepted steps of a run, taken while the loop asks for them; made by steps(). See there.
template <class Method, class Problem, class Vector>
class step_range {
    using run_type = integrator<Method, std::remove_reference_t<Problem>, Vector>;

  public:
    using scalar = typename Vector::Scalar;
    using value_type = step_view<Vector, typename run_type::output_type>;

    class iterator {
      public:
        using value_type = typename step_range::value_type;
        using difference_type = std::ptrdiff_t;
        using iterator_concept = std::input_iterator_tag;

        iterator() = default;
        explicit iterator(step_range* range) : range_(range) {}
        value_type operator*() const { return range_->current(); }
        iterator& operator++() {
            range_->advance();
            return *this;
        }
        void operator++(int) { ++*this; }
        friend bool operator==(const iterator& i, std::default_sentinel_t) { return i.at_end(); }

      private:
        bool at_end() const { return !range_->has_step_; }

        step_range* range_ = nullptr;
    };

    step_range(const Method& method, Problem&& problem, const Vector& y0, const scalar& t0, const scalar& t1,
               const options<scalar>& o)
        : problem_(std::forward<Problem>(problem)), run_(method, problem_, y0, t0, t1, o) {
        run_.make_consistent();
    }

    template <class Correction>
    step_range(const Method& method, Problem&& problem, const Vector& y0, const scalar& t0, const scalar& t1,
               const options<scalar>& o, Correction&& correction)
        : step_range(method, std::forward<Problem>(problem), y0, t0, t1, o) {
        detail::announce(correction, t0, run_.y(), t1);
        if constexpr (std::is_lvalue_reference_v<Correction>) {
            correct_ = [&correction, y = y0](run_type& run) mutable { detail::correct(correction, run, y); };
        } else {
            auto own = std::make_shared<Correction>(std::move(correction));
            correct_ = [own, y = y0](run_type& run) mutable { detail::correct(*own, run, y); };
        }
    }

    step_range(const Method& method, Problem&& problem, const checkpoint<Vector>& from, const scalar& t1,
               const options<scalar>& o)
        : step_range(method, std::forward<Problem>(problem), from.y, from.t, t1, o) {
        restore(run_, from);
    }

    /// Takes the first step; a later call continues where the previous loop stopped.
    iterator begin() {
        if (!begun_) advance();
        return iterator(this);
    }
    std::default_sentinel_t end() const { return {}; }

    const scalar& t() const { return run_.t(); }
    const Vector& y() const { return run_.y(); }
    /// status::success if t1 was reached, status::stopped if the loop was left before that, else the reason
    /// why there are no more steps.
    stagecraft::status status() const {
        if (resized_) return status::size_changed;
        return run_.finished() ? run_.status() : status::stopped;
    }
    const stagecraft::report<scalar>& report() const { return run_.counts(); }
    /// A checkpoint of the run where it is (checkpoint.hpp), without the correction.
    checkpoint<Vector> save() { return checkpoint_of(run_); }

  private:
    void advance() {
        begun_ = true;
        has_step_ = false;
        try {
            const bool taken = run_.step();
            if (taken && correct_) correct_(run_);
            has_step_ = taken;
        } catch (const size_change&) {
            resized_ = true;
        }
    }
    value_type current() const { return {run_.t(), run_.y(), run_.output().step(), run_.output()}; }

    Problem problem_;
    run_type run_;
    std::function<void(run_type&)> correct_;
    bool begun_ = false, has_step_ = false, resized_ = false;
};

/// A run as a range over its steps, for programs that want to write the loop themselves:
///
///     auto run = steps(method, problem, y0, t0, t1, options);
///     for (const auto& step : run)
///         if (step.y[0] < 0) break;                              // then run.t(), run.status(), run.report()
///
/// It is an input range, which the algorithms of std::ranges accept as an lvalue. Arguments and errors are
/// those of integrate(), except that an exception of the problem leaves the loop. Observers are called by
/// hand: watch.start(t0, y0, t1) before the loop if the observer has it (solution, output_times, events),
/// then watch(step.t, step.y, step.h, step.output) in it, where false ends the loop: with events() first, as the loop sees
/// whole steps, and a terminal event ends the run inside one, at watch.found().back(); observers(watch, table), called in
/// this way, shows the table the step up to there.
///
/// Only a correction of the states must act before the loop sees the step, and is given as the last argument:
/// projection(problem), projection_onto<M>(g) (dae/projection.hpp) or anything else with correct(t, y)
/// (observe/observer.hpp). An lvalue is kept by reference. Its start() is called, its other members are not.
/// An exception from it leaves the loop, with t() and y() at the state that was to be corrected.
template <class Method, class Problem, class Derived>
auto steps(const Method& method, Problem&& problem, const Eigen::MatrixBase<Derived>& y0,
           std::type_identity_t<typename Derived::Scalar> t0,
           std::type_identity_t<typename Derived::Scalar> t1,
           const options<typename Derived::Scalar>& o = {}) {
    using vector = typename Derived::PlainObject;
    constexpr bool callable = checked_call<std::remove_reference_t<Problem>, vector>::good;
    static_assert(
        callable,
        "steps: the problem must be callable as problem(t, y, f) and write f(t, y) into f, as `void "
        "operator()(double "
        "t, const Vector& y, Vector& f) const` with Vector the type of y0 (of fixed size if that is); "
        "integrate() says more");
    constexpr bool fit = detail::fit_in_parts<Method, std::remove_reference_t<Problem>>;
    static_assert(fit,
                  "steps: an additive method and a problem split(f_explicit, f_implicit) belong together: "
                  "neither runs without the other");
    o.break_points.validate("steps: break_points", t0, t1, true);
    if constexpr (callable && fit)
        return step_range<Method, Problem, vector>(method, std::forward<Problem>(problem), y0, t0, t1, o);
    else
        return std::initializer_list<result<vector>>();
}

/// The rest of a run of which a checkpoint was taken, as integrate() goes on from one: with these options, or with those
/// of the run where none are given or {} stands in their place.
template <class Method, class Problem, class Vector>
requires right_hand_side<std::remove_reference_t<Problem>, Vector> step_range<Method, Problem, Vector> steps(
    const Method& method, Problem&& problem, const checkpoint<Vector>& from,
    std::type_identity_t<typename Vector::Scalar> t1, const options<typename Vector::Scalar>& o) {
    return {method, std::forward<Problem>(problem), from, t1, o};
}
template <class Method, class Problem, class Vector>
requires right_hand_side<std::remove_reference_t<Problem>, Vector> step_range<Method, Problem, Vector> steps(
    const Method& method, Problem&& problem, const checkpoint<Vector>& from,
    std::type_identity_t<typename Vector::Scalar> t1, std::nullptr_t = {}) {
    return {method, std::forward<Problem>(problem), from, t1, detail::options_of(from)};
}

/// The same with a correction of every step.
template <class Method, class Problem, class Derived,
          detail::correcting_observer<typename Derived::Scalar, typename Derived::PlainObject> Correction>
step_range<Method, Problem, typename Derived::PlainObject> steps(
    const Method& method, Problem&& problem, const Eigen::MatrixBase<Derived>& y0,
    std::type_identity_t<typename Derived::Scalar> t0, std::type_identity_t<typename Derived::Scalar> t1,
    const options<typename Derived::Scalar>& o, Correction&& correction) {
    o.break_points.validate("steps: break_points", t0, t1, true);
    return {method, std::forward<Problem>(problem), y0, t0, t1, o, std::forward<Correction>(correction)};
}

namespace detail {
struct call_of_steps {
    template <class T>
    static constexpr bool say() {
        static_assert(never<T>,
                      "steps(method, problem, y0, t0, t1, options): y0 is a column vector of Eigen's, t0 and "
                      "t1 are numbers, and options have the names that they have for integrate()");
        return true;
    }
};
}  // namespace detail

/// Options of names that there are not, or other arguments.
std::initializer_list<result<Eigen::VectorXd>> steps(detail::refused_call<detail::call_of_steps>,
                                                     detail::anything, detail::anything, detail::anything,
                                                     detail::anything, const detail::misnamed_options&);
std::initializer_list<result<Eigen::VectorXd>> steps(detail::refused_call<detail::call_of_steps>, ...);

}  // namespace stagecraft
