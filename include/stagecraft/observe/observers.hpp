// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <tuple>
#include <type_traits>
#include <utility>

#include <stagecraft/break_points.hpp>
#include <stagecraft/observe/observer.hpp>

namespace stagecraft {

namespace detail {

/// A member correct(t, y) for a List of observers of which one has that.
template <class List, bool Exists>
struct optional_correction {};
template <class List>
struct optional_correction<List, true> {
    template <class Scalar, class Vector>
    bool correct(const Scalar& t, Vector& y) {
        return static_cast<List&>(*this).correct_all(t, y);
    }
};

/// A member change(t, y) for a List of observers of which one has that.
template <class List, bool Exists>
struct optional_change {};
template <class List>
struct optional_change<List, true> {
    template <class Scalar, class Vector>
    bool change(const Scalar& t, Vector& y) {
        return static_cast<List&>(*this).change_all(t, y);
    }
};

/// A member save(take) for a List of observers of which one has that.
template <class List, bool Exists>
struct optional_saving {};
template <class List>
struct optional_saving<List, true> {
    template <class Take>
    void save(const Take& take) {
        static_cast<List&>(*this).save_all(take);
    }
};

template <class Observer>
struct breaks_of {
    using scalar = float;  // gives way to any other
};
template <has_break_points Observer>
struct breaks_of<Observer> {
    using scalar = std::remove_cvref_t<decltype(*std::declval<Observer&>().break_points().numbers().begin())>;
};
template <class Observer>
using scalar_of_breaks = typename breaks_of<Observer>::scalar;
template <class Observer, class Breaks>
void add_breaks([[maybe_unused]] const Observer& observer, [[maybe_unused]] Breaks& all) {
    if constexpr (has_break_points<const Observer>) all.add(Breaks(observer.break_points()));
}

/// True if one of the observers has a member so named, or may have.
template <class Named, class... Observers>
inline constexpr bool one_may_have = ((has_member_named<std::remove_reference_t<Observers>, Named> ||
                                       std::is_final_v<std::remove_reference_t<Observers>>) ||
                                      ...);

}  // namespace detail

/// Several observers as one; made by observers().
template <class... Observers>
class observer_list
    : public detail::optional_correction<observer_list<Observers...>,
                                         detail::one_may_have<detail::correct_member, Observers...>>,
      public detail::optional_change<observer_list<Observers...>,
                                     detail::one_may_have<detail::change_member, Observers...>>,
      public detail::optional_saving<observer_list<Observers...>,
                                     detail::one_may_have<detail::save_member, Observers...>> {
  public:
    explicit observer_list(Observers&&... o) : list_(std::forward<Observers>(o)...) {}

    template <class Scalar, class Vector>
    void start(const Scalar& t0, const Vector& y0, const Scalar& t1) {
        each([&](auto& o) { detail::announce(o, t0, y0, t1); });
    }
    template <class Scalar, class Vector, class Output>
    requires(detail::can_observe<std::remove_reference_t<Observers>, Vector, Output>&&...) bool operator()(
        const Scalar& t, const Vector& y, const Scalar& h, const Output& output) {
        return detail::tell_until(end_inside(t, y, h, output), *this, t, y, h, output);
    }
    /// The first end of the run inside the step that one of them finds.
    template <class Scalar, class Vector, class Output>
    const occurrence<Vector>* end_inside(const Scalar& t, const Vector& y, const Scalar& h,
                                         const Output& output) {
        const occurrence<Vector>* first = nullptr;
        each([&](auto& o) {
            const occurrence<Vector>* end = detail::end_inside(o, t, y, h, output);
            if (end && (!first || (h < Scalar(0) ? end->t > first->t : end->t < first->t))) first = end;
        });
        return first;
    }
    template <class Scalar, class Vector, class Output>
    bool tell(const Scalar& t, const Vector& y, const Scalar& h, const Output& output) {
        bool go_on = true;
        each([&](auto& o) { go_on = detail::tell(o, t, y, h, output) && go_on; });
        return go_on;
    }
    /// The corrections of all observers that make any, one after the other.
    template <class Scalar, class Vector>
    bool correct_all(const Scalar& t, Vector& y) {
        bool changed = false;
        each([&](auto& o) { changed = detail::correct_state(o, t, y) || changed; });
        return changed;
    }
    /// The changes of all, in the order given, each of what those before it have left.
    template <class Scalar, class Vector>
    bool change_all(const Scalar& t, Vector& y) {
        bool changed = false;
        each([&](auto& o) { changed = detail::change_state(o, t, y) || changed; });
        return changed;
    }
    template <class Scalar, class Vector>
    void changed(const Scalar& t, const Vector& y) {
        each([&](auto& o) { detail::tell_change(o, t, y); });
    }
    bool ends_at_start() const {
        return std::apply([](const auto&... o) { return (detail::ends_at_start(o) || ...); }, list_);
    }
    /// Those of all.
    auto break_points() const requires((has_break_points<std::remove_reference_t<Observers>> || ...)) {
        using scalar = std::common_type_t<detail::scalar_of_breaks<std::remove_reference_t<Observers>>...>;
        break_times<scalar> all;
        std::apply([&](const auto&... o) { (detail::add_breaks(o, all), ...); }, list_);
        return all;
    }
    template <class Take>
    void save_all(const Take& take) {
        each([&](auto& o) { detail::save(o, take); });
    }
    /// Repeated as long as one of them shortens the run, so that all end at the same t whatever their order
    /// is.
    template <class Result>
    void conclude(Result& r) {
        for (bool shortened = true; shortened;) {
            const auto t = r.t;
            each([&](auto& o) { detail::conclude(o, r); });
            shortened = r.t != t;
        }
    }

  private:
    template <class F>
    void each(F&& f) {
        std::apply([&](auto&... o) { (f(o), ...); }, list_);
    }

    std::tuple<Observers...> list_;
};

namespace detail {
template <class... Observers, class Vector, class Output>
inline constexpr bool looks_between<observer_list<Observers...>, Vector, Output> =
    (looks_between<std::remove_reference_t<Observers>, Vector, Output> || ...);
}  // namespace detail

/// One observer that calls several after every step, in the order given. The run goes on if none of them ends
/// it; where events() ends it inside a step, all of them see the step up to there, wherever events() stands in the list. Lvalues are kept by reference, temporaries are moved in.
template <class... Observers>
observer_list<Observers...> observers(Observers&&... o) {
    return observer_list<Observers...>(std::forward<Observers>(o)...);
}

}  // namespace stagecraft
