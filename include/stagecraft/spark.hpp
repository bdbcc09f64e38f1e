// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/integrate.hpp>
#include <stagecraft/method/spark_method.hpp>
#include <stagecraft/step/spark_step.hpp>

namespace stagecraft {

/// The pair of Lobatto IIIA and IIIB for holonomic mechanical systems (Jay 1996, SPARK; with two stages RATTLE), of order
/// 2 s - 2 in position and velocity:
///
///     integrate(spark(lobatto_iiia<2>(), lobatto_iiib<2>()), index_reduced(model), model_start, t0, t1, {.fixed_step = h})
///
/// for a model with position constraints g (mechanics/model.hpp), in the state (q, v). g(q, t) and G v + b vanish to rounding
/// at the end of every step, and the energy of a conservative model does not drift (Hairer-Lubich-Wanner VII.1.4): the
/// method is symplectic in q and M(q) v. Steps are equal, q and v at the start satisfy the constraints; the
/// iteration ends at rounding with .rtol = 1e-12, .atol = 1e-12. For equations that
/// are not stiff: the iteration takes M and G from the start of the step, and ends in status::newton_failed where the step
/// is too long for it. std::invalid_argument for tableaux of another form.
template <class Scalar, int First, int Second>
auto spark(const tableau<Scalar, First>& first, const tableau<Scalar, Second>& second) {
    constexpr bool equal = First == Second || First == dynamic || Second == dynamic;
    static_assert(equal, "spark(first, second): both tableaux must have the same number of stages");
    constexpr int s = equal ? detail::common_stages<First, Second> : dynamic;
    const spark_method<Scalar, s> m{
        detail::pair_of<partitioned_method<Scalar, s>>(first, second, "spark", false)};
    detail::check_spark(m.pair);
    return m;
}

}  // namespace stagecraft
