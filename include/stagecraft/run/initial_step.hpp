// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <type_traits>

#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/norms.hpp>

namespace stagecraft {

/// A first step size: one that changes the solution by about one per cent in the weighted norm, and at most a
/// thousandth of the span if the solution hardly moves. f is scaled to a derivative by the rows of M (their largest
/// entries, or their sums where products are all that is known); algebraic equations do not
/// enter. The error test corrects a bad guess.
template <class Mass, class Vector, class Norm>
typename Vector::Scalar initial_step(const Mass& mass, const Vector& y, const Vector& f, const Norm& norm,
                                     const typename Vector::Scalar& span) {
    using scalar = typename Vector::Scalar;
    using std::abs;
    const int n = static_cast<int>(y.size());
    if (std::remove_cvref_t<decltype(norm.sums())>::complete && n == 0) return span;
    Vector slope = f;
    if constexpr (!Mass::identity) {
        Vector row = Vector::Zero(n);
        if constexpr (has_entries<Mass>) {
            for (const auto& e : mass.entries())
                if (abs(e.value) > row[e.row]) row[e.row] = abs(e.value);
        } else {
            const Vector ones = Vector::Ones(n);
            add_mass_times(mass, scalar(1), ones.data(), row.data(), n);
            row = row.cwiseAbs();
        }
        for (int i = 0; i < n; ++i) slope[i] = row[i] > scalar(0) ? scalar(f[i] / row[i]) : scalar(0);
    }
    scalar size = norm(y);
    const scalar change = norm(slope);
    if (size < scalar(1)) size = scalar(1);
    return change * span > size / 1000 ? scalar(size / change / scalar(100)) : scalar(span / 1000);
}

/// The same of a run from (t, y), f = f(t, y), to `end`.
template <class System, class Norm, class Vector>
[[gnu::cold]] typename Vector::Scalar initial_step(const System& system, const Norm& norm,
                                                   const typename Vector::Scalar& t, const Vector& y,
                                                   const Vector& f, const typename Vector::Scalar& end) {
    using std::abs;
    const weighted_root_mean_square of_state(norm.of_state(), norm.sums());
    const typename Vector::Scalar span = abs(end - t);
    if constexpr (System::has_explicit_part) {
        Vector whole = f;
        system.add_explicit_part(t, y, whole);
        return initial_step(system.mass(), y, whole, of_state, span);
    } else {
        return initial_step(system.mass(), y, f, of_state, span);
    }
}

}  // namespace stagecraft
