// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <stagecraft/break_points.hpp>

namespace stagecraft {

/// Everything that solve_bvp may be told; the defaults suit a first try. The tolerance is
/// atol + rtol |y_i(t)| for every component of y(t), everywhere in [a, b], and for p.
template <class Scalar>
struct bvp_options {
    Scalar rtol = Scalar(1) / 1000000;  ///< relative tolerance, at least 4 epsilon
    Scalar atol{0};                     ///< absolute tolerance; 0: the same number as rtol
    int intervals = 0;           ///< of the first mesh, equally spaced; 0: 6, and 10 where these are too few
    std::vector<Scalar> mesh{};  ///< instead of it: a ... b, increasing
    std::vector<Scalar> fixed_points{};  ///< points that belong to every mesh (jumps of f, say)
    int max_intervals = 10000;           ///< above it the run ends in bvp_status::too_many_intervals
    bool adapt = true;  ///< false: the first mesh is the only one, whatever the error turns out to be
    int newton_iterations = 50;  ///< at most this many factorisations on one mesh
    break_times<Scalar>
        break_points{};        ///< where f jumps or has a kink, as for integrate(): fixed points too
    bool conditioning = true;  ///< false: kappa1, kappa2, ... are not computed
};

namespace detail {

inline void demand_bvp(bool good, const char* what, const char* who = "solve_bvp") {
    if (!good) throw std::invalid_argument(std::string(who) + ": " + what);
}

template <class Scalar>
void validate(const bvp_options<Scalar>& o, const Scalar& a, const Scalar& b, const char* who = "solve_bvp") {
    const auto finite = [](const Scalar& x) { return x - x == Scalar(0); };
    const auto demand = [who](bool good, const char* what) { demand_bvp(good, what, who); };
    demand(finite(a) && finite(b), "a and b must be finite");
    demand(a < b, "a must be below b");
    demand(finite(o.rtol) && o.rtol >= 4 * std::numeric_limits<Scalar>::epsilon(),
           "rtol must be finite and at least four times the epsilon of the scalar");
    demand(finite(o.atol) && o.atol >= Scalar(0), "atol must be finite and not negative");
    demand(o.atol == Scalar(0) || o.atol >= 4 * std::numeric_limits<Scalar>::epsilon() * o.rtol,
           "atol must be zero (that of rtol) or not negligible beside rtol");
    demand(o.intervals >= 0 && o.max_intervals > 0,
           "intervals must not be negative, max_intervals must be positive");
    demand((o.mesh.empty() ? o.intervals : static_cast<int>(o.mesh.size()) - 1) <= o.max_intervals,
           o.mesh.empty() ? "intervals must not be more than max_intervals"
                          : "the intervals of mesh must not be more than max_intervals");
    demand(o.newton_iterations > 0, "newton_iterations must be positive");
    if (!o.mesh.empty()) {
        demand(o.mesh.size() > 1 && o.mesh.front() == a && o.mesh.back() == b,
               "mesh must begin with a and end with b");
        for (std::size_t i = 0; i + 1 < o.mesh.size(); ++i)
            demand(o.mesh[i] < o.mesh[i + 1], "mesh must increase");
    }
    for (std::size_t i = 0; i < o.fixed_points.size(); ++i) {
        demand(o.fixed_points[i] > a && o.fixed_points[i] < b, "fixed_points must lie inside (a, b)");
        demand(i == 0 || o.fixed_points[i - 1] < o.fixed_points[i], "fixed_points must increase");
    }
}

/// Break points inside (a, b) become fixed points, too.
template <class Scalar>
void take_break_points(bvp_options<Scalar>& o, const break_times<Scalar>& times, const Scalar& a,
                       const Scalar& b) {
    if (times.empty()) return;
    times.validate("solve_bvp: break_points", a, b, false);
    for (Scalar t = times.next(a, b); t < b; t = times.next(t, b)) o.fixed_points.push_back(t);
    std::sort(o.fixed_points.begin(), o.fixed_points.end());
    o.fixed_points.erase(std::unique(o.fixed_points.begin(), o.fixed_points.end()), o.fixed_points.end());
}

}  // namespace detail

}  // namespace stagecraft
