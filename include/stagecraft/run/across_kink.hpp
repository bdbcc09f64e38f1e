// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/split_lu.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/stages/coupled_systems.hpp>
#include <stagecraft/stages/newton.hpp>

namespace stagecraft {

/// Whether an iteration contracts no faster than the one of a longer step, `failures` having failed in this step, `in_a_row`
/// with those of the steps just before. Where f is smooth theta is O(h), or falls with what J changes over the step. Across
/// a kink of an algebraic equation it is the quotient of two slopes less one, whatever h is. Strong nonlinearities contract
/// alike for some halvings as well, and may be led to another solution there (the transistor amplifier at 1e-2): so three
/// attempts fail first. Steps that end just before the kink fail once or twice each, are ever shorter, and never pass it:
/// eight such steps are enough.
template <class Scalar>
bool meets_a_kink(const Scalar& theta, const Scalar& theta_of_longer, int failures, int in_a_row) {
    return (failures >= 3 || in_a_row >= 16) && theta_of_longer > Scalar(0) && theta > Scalar(1) / 2 &&
           theta > theta_of_longer * Scalar(4) / 5;
}

/// Stage equations may have kinks that no shorter step takes away where M may be singular; the methods that can be led across
/// them are those whose solve() goes on from any increments.
template <class Step, class System>
inline constexpr bool meets_kinks = !System::mass_type::identity && System::sums_type::complete && requires {
    std::remove_reference_t<decltype(std::declval<Step&>().stages())>::iterates_on_increments;
};

/// Newton's iteration for the stages of a step h from (t, y), begun in `now`, each stage with its own Jacobian: beyond a kink
/// one stage has another slope than the next. At most 20 iterations, until an increment is as small as what may be left, or
/// rounding; each factors a full matrix of as many rows as there are numbers in all stages.
template <class Step, class System, class Vector, class Norm, class Scalar>
newton_outcome<Scalar> solve_stage_by_stage(Step& method, System& system, const Scalar& t, const Vector& y,
                                            const Scalar& h, const Norm& norm,
                                            const newton_limits<Scalar>& limits, const Vector& negligible,
                                            typename Step::output& now, report<Scalar>& counts) {
    using std::sqrt;
    const auto& m = method.stages().method();
    const int n = static_cast<int>(y.size()), s = m.stages(), all = s * n;
    auto& Z = now.increments();
    split_lu<Scalar, -1> lu(all);
    std::vector<Scalar> x(static_cast<std::size_t>(all));
    Vector point = y, f = y, slope = y;
    newton_outcome<Scalar> newton{newton_end::diverged, 0, Scalar(1)};
    for (Scalar last(0); newton.iterations < 20; ++newton.iterations) {
        Scalar* e = lu.entries();
        for (int k = 0; k < all * all; ++k) e[k] = Scalar(0);
        for (int i = 0; i < s; ++i) {
            const Scalar at = t + m.c[i] * h;
            point = y + Z.col(i);
            system.evaluate(at, point, f);
            system.evaluate_jacobian(at, point, f, negligible);
            slope.setZero();
            const auto entry = [&](int r, int j, int c) -> Scalar& {
                return e[i * n + r + (j * n + c) * all];
            };
            detail::for_each_entry(system.jacobian(),
                                   [&](int r, int c, const Scalar& value) { entry(r, i, c) = -value; });
            for (int j = 0; j < s; ++j) {
                const Scalar factor = m.A_inverse(i, j) / h;
                slope -= factor * Z.col(j);
                for (const auto& one : system.mass().entries())
                    entry(one.row, j, one.column) += factor * one.value;
            }
            add_mass_times(system.mass(), Scalar(1), slope.data(), f.data(), n);
            for (int r = 0; r < n; ++r) x[static_cast<std::size_t>(i * n + r)] = f[r];
        }
        ++counts.factorisations;
        ++counts.solves;
        if (!lu.factor()) break;
        lu.solve(x.data());
        Scalar square(0);
        for (int i = 0; i < s; ++i) {
            for (int r = 0; r < n; ++r) point[r] = x[static_cast<std::size_t>(i * n + r)];
            square += norm(point) * norm(point) / Scalar(s);
        }
        const Scalar size = sqrt(square);
        if (!(size - size == Scalar(0))) break;
        // Two iterates, one on either side of the kink, may lead to each other: half of the way leads to neither.
        const Scalar part = last > Scalar(0) && size >= last ? Scalar(1) / 2 : Scalar(1);
        for (int i = 0; i < s; ++i)
            for (int r = 0; r < n; ++r) Z(r, i) += part * x[static_cast<std::size_t>(i * n + r)];
        if (size <= limits.factor || (size <= limits.noise && 4 * size > last)) {
            newton.end = newton_end::converged;
            break;
        }
        last = size;
    }
    return newton;
}

/// Solves the stage equations of a step h from (t, y) that Newton's iteration could not solve with a Jacobian of the left end,
/// at a rate that no shorter step makes better: beyond a kink of an algebraic equation the slope is another one. Up to 300
/// numbers in all stages each has its own Jacobian; of more, and where entries are not here, all have that of the end which
/// the step `before` predicts (null: at y). Jacobian and factors are those of the right end afterwards, for the estimate, or
/// those of the left end again, for a shorter step. Takes storage where it is called.
template <class Step, class System, class Scalar, class Vector, class Norm>
[[gnu::noinline, gnu::cold]] newton_outcome<Scalar> solve_across_kink(
    Step& method, System& system, const typename Step::output* before, const Scalar& t, const Vector& y,
    const Scalar& h, const Norm& norm, const newton_limits<Scalar>& limits, typename Step::output& now,
    report<Scalar>& counts) {
    Vector point = y, f = y, negligible = y;
    for (int i = 0; i < y.size(); ++i) negligible[i] = Scalar(1) / norm.weights()[i];
    const auto factor_at = [&](const Scalar& at) {
        if constexpr (System::finite_difference) system.evaluate(at, point, f);
        system.evaluate_jacobian(at, point, f, negligible);
        ++counts.factorisations;
        return method.stages().factor(system, h);
    };
    newton_outcome<Scalar> newton{newton_end::diverged, 0, Scalar(1)};
    method.guess(nullptr, y, h, now);
    constexpr bool has_all_entries = !System::opaque && has_entries<typename System::mass_type>;
    if (has_all_entries && y.size() * method.columns() <= 300) {
        if constexpr (has_all_entries)
            newton = solve_stage_by_stage(method, system, t, y, h, norm, limits, negligible, now, counts);
    } else {
        if (before != nullptr) before->evaluate(t + h, point);
        if (factor_at(t + h))
            newton = method.stages().solve(system, t, y, h, norm, limits, now.increments(), counts.solves);
        newton.theta = Scalar(1);
    }
    const bool solved = newton.end == newton_end::converged;
    point = y;
    if (solved) point += now.increments().col(method.columns() - 1);
    if (!factor_at(solved ? Scalar(t + h) : t)) newton.end = newton_end::diverged;
    return newton;
}

}  // namespace stagecraft
