// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include <stagecraft/bvp/judge/mesh_points.hpp>
#include <stagecraft/bvp/measure/measurements.hpp>

namespace stagecraft::detail {

/// The relative condition number of a linear problem on the mesh of x, whose equations are `own`; infinity where M is not known
/// there either.
template <class Equations>
auto condition_on(Equations& own, typename Equations::iterate x,
                  std::shared_ptr<const typename Equations::rule> rule,
                  const typename measurements<Equations>::scalar& threshold) {
    using scalar = typename measurements<Equations>::scalar;
    const scalar unknown = std::numeric_limits<scalar>::infinity();
    own.resize(x);
    if (!own.linearise(x)) return unknown;
    lifting_elimination<Equations> elimination(own, std::move(rule));
    measurements<Equations> measured(own, x, elimination, threshold);
    mesh_evidence<scalar> e;
    e.unknowns = own.n() + own.np(), e.no_mass = own.mass().identity();
    for (;;) {
        const evidence_reader<scalar> r(e);
        const bool undecided = regularity_judge<scalar>(r).decide(scalar(0)).undecided;
        const scalar kappa = undecided ? unknown : r(quantity::kappa);
        if (!r.missing()) return kappa;
        measured.measure(*r.missing(), e, scalar(0));
    }
}

/// The dimension of the kernel of M at x, which is known to be singular: with every interval halved until the mesh shows what
/// it does to each mode. `at` gives x on another mesh, `own` are equations for it; meshes have at most `most` intervals.
template <class Equations, class At>
int kernel_dimension(Equations& own, const At& at, typename Equations::iterate x,
                     std::shared_ptr<const typename Equations::rule> rule,
                     const typename measurements<Equations>::scalar& threshold, bool linear, int most) {
    constexpr int halvings = 8;
    int dimension = 1;
    for (int pass = 0; pass < halvings; ++pass) {
        own.resize(x);
        if (!own.linearise(x)) break;
        lifting_elimination<Equations> elimination(own, rule);
        measurements<Equations> measured(own, x, elimination, threshold);
        const auto found = measured.fundamental().kernel(linear);
        dimension = std::max(found.dimension, 1);
        if (found.certain || 2 * x.intervals() > most) break;
        x = at(halved(x.t));
    }
    return dimension;
}

}  // namespace stagecraft::detail
