// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <utility>

namespace stagecraft {

/// An observer that hands out checkpoints; made by save_every(). See there.
template <class Store>
class saving_observer {
  public:
    saving_observer(long steps, Store store) : every_(steps), store_(std::move(store)) {
        if (steps < 1) throw std::invalid_argument("save_every: steps must be positive");
    }
    template <class Scalar, class Vector>
    void operator()(const Scalar&, const Vector&) {}
    template <class Take>
    void save(const Take& take) {
        if (++steps_ % every_ == 0) store_(take());
    }

  private:
    long every_, steps_ = 0;
    Store store_;
};

/// An observer that calls store(point) with a checkpoint of the run (checkpoint.hpp) after every so many steps:
///
///     checkpoint<Vector3d> last;
///     integrate(method, problem, y0, t0, t1, options, save_every(1, [&](auto point) { last = std::move(point); }));
///     integrate(method, problem, last, t1);                     // goes on from there with the same options
///
/// `file << last` writes it, `file >> last` reads it. Together with others: observers(watch, save_every(...)). A
/// checkpoint costs a copy of the Jacobian and a few states. None is taken of a step that an event ends the run in.
/// std::invalid_argument unless steps > 0.
template <class Store>
auto save_every(long steps, Store store) {
    constexpr bool takes_points = !requires { store.y; };
    static_assert(takes_points,
                  "save_every(steps, store): store is called with each checkpoint: write "
                  "[&](auto point) { last = std::move(point); } in place of last");
    if constexpr (takes_points)
        return saving_observer<Store>(steps, std::move(store));
    else
        return saving_observer(steps, [](const auto&) {});
}

}  // namespace stagecraft
