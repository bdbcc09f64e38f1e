// SPDX-License-Identifier: BSL-1.0
// Crossings of levels by y = (sin(omega t + phi), ...), known exactly.
#include <numbers>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>

#include "problem.hpp"

namespace campaign {

/// Levels anywhere within the amplitude, near its top as well (where two crossings are close), from t0 in 0 ...
/// 1e9. Only crossings that rounding of t or the tolerance could make or lose are left out of the count.
outcome run_events(dice d, double tol) {
    const double starts[] = {0, 0, 1, 1e3, 1e6, 1e9};
    const double t0 = starts[d.integer(0, 5)], omega = d.log_between(0.3, 10), phi = d.between(-3, 3);
    const double span = d.log_between(1, 30);
    const double level = d.coin() ? d.between(-0.9, 0.9) : d.sign() * (1 - d.log_between(1e-3, 1e-1));
    const double t1 = t0 + span;
    // sin(x) = level at x = a + 2 pi k and pi - a + 2 pi k, x = omega (t - t0) + phi.
    std::vector<double> expected;
    const double a = std::asin(level), full = 2 * std::numbers::pi;
    for (const double first : {a, std::numbers::pi - a})
        for (double x = first - 10 * full; x < phi + omega * span; x += full)
            if (x > phi) expected.push_back((x - phi) / omega);
    std::sort(expected.begin(), expected.end());
    auto watch = stagecraft::events<Eigen::Vector2d>(
        stagecraft::event([&](double, const Eigen::Vector2d& y) { return y[0] - level; }));
    const auto r = stagecraft::integrate(
        stagecraft::radau_iia<3>(),
        [&](const auto&, const auto& y, auto& f) {
            f[0] = omega * y[1];
            f[1] = -omega * y[0];
        },
        Eigen::Vector2d(std::sin(phi), std::cos(phi)), t0, t1, {.rtol = tol, .atol = tol}, watch);
    outcome o;
    o.status = stagecraft::name(r.status);
    o.t = r.t;
    o.steps = r.report.steps;
    o.success = r.ok();
    if (!o.success) return o;
    // The times move by the error of y over its slope, that of t0 and t by rounding.
    const double slope = omega * std::sqrt(1 - level * level), rounding = 8 * 2.3e-16 * std::max(t0, 1.0);
    if (watch.found().size() != expected.size()) {
        o.worst = INFINITY;
        for (const double e : expected)  // one at an end of the run counts either way
            if (std::min(e, std::abs(span - e)) < 1000 * (tol / slope + rounding)) o.worst = 0;
        return o;
    }
    for (std::size_t k = 0; k < expected.size(); ++k)
        o.worst =
            std::max(o.worst, std::abs(watch.found()[k].t - t0 - expected[k]) / (tol / slope + rounding));
    return o;
}

}  // namespace campaign
