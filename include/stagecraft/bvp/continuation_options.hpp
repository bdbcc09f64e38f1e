// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/bvp/options.hpp>

namespace stagecraft {

/// The kind of a point of a path. Beside regular points: where the parameter turns back, where two paths cross, and on
/// paths of periodic orbits where a multiplier passes -1 or a pair of complex ones the unit circle, the equilibrium to
/// which the orbits shrink in the end, and the homoclinic orbit towards which their period grows without bound
/// (orbit_continuation).
enum class point_kind { regular, fold, branch_point, period_doubling, torus, hopf, homoclinic };

/// The kind as words.
constexpr const char* name(point_kind k) {
    constexpr const char* names[] = {"regular", "fold",       "branch point",    "period doubling",
                                     "torus",   "Hopf point", "homoclinic orbit"};
    return names[static_cast<int>(k)];
}

/// The options of continuation and orbit_continuation.
template <class Scalar>
struct continuation_options {
    Scalar from{0};               ///< the parameter of the first point
    Scalar to = Scalar(1e30);     ///< the path ends where the parameter leaves [min(from, to), max(from, to)]
    Scalar rtol = Scalar(1e-10);  ///< of every point; see bvp_options
    Scalar step = Scalar(1) / 4;  ///< the first step in arclength; later ones follow from the work
    Scalar largest_step{1};
    int max_points = 60;  ///< the path ends after so many, wherever p is; the last point's message says so
    int intervals = 10;
};

namespace detail {

template <class Scalar>
void validate(const continuation_options<Scalar>& o, const Scalar& a, const Scalar& b, const char* who) {
    const auto demand = [who](bool good, const char* what) { demand_bvp(good, what, who); };
    demand(o.from - o.from == Scalar(0), "from must be finite");
    demand(o.to == o.to, "to must be a number");
    demand(o.step > Scalar(0) && o.largest_step >= o.step, "step must be positive, largest_step no less");
    demand(o.max_points > 0, "max_points must be positive");
    bvp_options<Scalar> tolerances;
    tolerances.rtol = o.rtol, tolerances.intervals = o.intervals;
    validate(tolerances, a, b, who);
}

/// Why a path ends at this parameter, in words: "" where it has passed `to`, nullptr where it goes on.
template <class Scalar>
const char* end_of_path(const continuation_options<Scalar>& o, const Scalar& p) {
    if (o.from < o.to ? p > o.to : p < o.to) return "";
    if (o.from < o.to ? p < o.from : p > o.from) return "the path has come back to `from`";
    return nullptr;
}
inline constexpr const char* too_many_points = "the path has max_points before it reaches `to`";

}  // namespace detail

}  // namespace stagecraft
