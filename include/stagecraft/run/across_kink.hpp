// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <type_traits>
#include <utility>

#include <stagecraft/report.hpp>
#include <stagecraft/stages/newton.hpp>

namespace stagecraft {

/// Whether an iteration that has failed `failures` times in this step contracts no faster than the one before, at a longer step.
/// Where f is smooth theta is O(h), or falls with what J changes over the step. Across a kink of an algebraic equation it is
/// the quotient of two slopes less one, whatever h is. Strong nonlinearities contract alike for some halvings as well, and
/// secants may lead to another solution there (the transistor amplifier at 1e-2): so three attempts fail first.
template <class Scalar>
bool meets_a_kink(const Scalar& theta, const Scalar& theta_of_longer, int failures) {
    return failures >= 3 && theta_of_longer > Scalar(0) && theta > Scalar(1) / 2 &&
           theta > theta_of_longer * Scalar(4) / 5;
}

/// Stage equations may have kinks that no shorter step takes away where M may be singular; the methods that can be led across
/// them are those whose solve() goes on from any increments.
template <class Step, class System>
inline constexpr bool meets_kinks = !System::mass_type::identity && System::sums_type::complete && requires {
    std::remove_reference_t<decltype(std::declval<Step&>().stages())>::iterates_on_increments;
};

/// Newton's iteration for the stages of a step h from (t, y), begun in `now` and led along secants: each iterate follows from
/// the point of the line through the last two at which the increment would be smallest (Anderson 1965, with one iterate
/// remembered). Where the matrices are wrong by a common factor, that factor is found. At most 20 iterations; as what a
/// secant leaves does not follow from how increments fall, the last one has to be as small as what may be left.
template <class Step, class System, class Vector, class Norm, class Scalar>
newton_outcome<Scalar> solve_by_secants(Step& method, System& system, const Scalar& t, const Vector& y,
                                        const Scalar& h, const Norm& norm, newton_limits<Scalar> limits,
                                        typename Step::output& now, long& solves) {
    using std::sqrt;
    typename Step::output::stage_matrix from, made, made_before, change, increment;
    const auto product = [&](const auto& a, const auto& b) {
        Scalar sum(0);
        for (int j = 0; j < method.columns(); ++j)
            sum += (norm.weights().array().square() * a.col(j).array() * b.col(j).array()).sum();
        return Scalar(sum / Scalar(y.size() * method.columns()));
    };
    const auto size = [&](const auto& a) { return Scalar(sqrt(product(a, a))); };
    auto& Z = now.increments();
    limits.iterations = 1;
    limits.affine = false;
    limits.far = Scalar(0);
    newton_outcome<Scalar> newton{newton_end::diverged, 0, Scalar(1)};
    while (newton.end == newton_end::diverged && newton.iterations < 20) {
        from = Z;
        newton.end = method.stages().solve(system, t, y, h, norm, limits, Z, solves).end;
        if (++newton.iterations; newton.end != newton_end::diverged) break;
        made = Z - from;
        if (newton.iterations > 1) {
            change = made - made_before;
            const Scalar square = product(change, change), part = product(made, change);
            increment = square > Scalar(0) ? (made - (part / square) * (increment + change)).eval() : made;
        } else {
            increment = made;
        }
        made_before = made;
        Z = from + increment;
        if (size(made) <= limits.factor && size(increment) <= limits.factor)
            newton.end = newton_end::converged;
    }
    return newton;
}

/// Solves the stage equations of a step h from (t, y) that Newton's iteration could not solve with a Jacobian of the left end,
/// at a rate that no shorter step makes better: beyond a kink of an algebraic equation the slope is another one. Secants lead
/// the iteration, with that Jacobian, then with that of the end which the step `before` predicts (null: at y). Jacobian and
/// factors are those of the left end again afterwards, for the estimate, or for a shorter step.
///
/// At most 40 iterations and three factorisations; storage for five stage matrices, where it is called.
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
    const auto solve = [&] {
        method.guess(nullptr, y, h, now);
        return solve_by_secants(method, system, t, y, h, norm, limits, now, counts.solves);
    };
    if (!factor_at(t)) return {};
    newton_outcome<Scalar> newton = solve();
    if (newton.end == newton_end::converged) return newton;
    if (before != nullptr) before->evaluate(t + h, point);
    if (factor_at(t + h)) newton = solve();
    point = y;
    if (!factor_at(t)) newton.end = newton_end::diverged;
    return newton;
}

}  // namespace stagecraft
