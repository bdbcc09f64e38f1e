// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include <stagecraft/bvp/equations/mesh.hpp>
#include <stagecraft/bvp/measure/regularity.hpp>

namespace stagecraft::detail {

/// Is M of a linear problem known on the mesh of x as well, where `finer` are its equations, and its relative condition number
/// `kappa` but for a factor of 2?
template <class Equations>
bool confirms_condition(Equations& finer, typename Equations::iterate x,
                        std::shared_ptr<const typename Equations::rule> rule,
                        const typename regularity<Equations>::scalar& floor,
                        const typename regularity<Equations>::scalar& kappa) {
    finer.resize(x);
    if (!finer.linearise(x)) return false;
    conditioning_of<Equations> conditioning(finer, x);
    lifting_elimination<Equations> elimination(finer, std::move(rule));
    if (regularity<Equations>(finer, conditioning, x, elimination).unknown(floor)) return false;
    const auto found = conditioning.relative(floor);
    return found < 2 * kappa && kappa < 2 * found;
}

/// The dimension of the kernel of M at x, which is known to be singular: with every interval halved until the mesh shows what
/// it does to each mode. `at` gives x on another mesh, `own` are equations for it.
template <class Equations, class At>
int kernel_dimension(Equations& own, const At& at, typename Equations::iterate x,
                     std::shared_ptr<const typename Equations::rule> rule,
                     const typename regularity<Equations>::scalar& floor, bool linear, int most) {
    int dimension = 1;
    for (int pass = 0; pass < 8; ++pass) {
        own.resize(x);
        if (!own.linearise(x)) break;
        conditioning_of<Equations> conditioning(own, x);
        lifting_elimination<Equations> elimination(own, rule);
        const auto found = regularity<Equations>(own, conditioning, x, elimination).kernel(floor, linear);
        dimension = std::max(found.dimension, 1);
        if (found.certain || 2 * x.intervals() > most) break;
        x = at(halved(x.t));
    }
    return dimension;
}

}  // namespace stagecraft::detail
