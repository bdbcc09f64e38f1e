// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "stagecraft/theory/dynamics/rk_map.hpp"

namespace stagecraft::theory {

/// What happens to a fixed point of a method's map as h changes: two meet and vanish (fold), its multiplier passes -1
/// and a cycle of period two is born (flip), or another branch crosses, the multiplier passing 1 (branching: a
/// pitchfork where f is odd).
enum class branch_event { fold, flip, branching };

struct branch_point {
    branch_event kind;
    double h, x;
};

/// A curve of fixed points (h, x) with what was met on the way. Measured, in doubles; nothing is proved.
struct branch {
    std::vector<Eigen::Vector2d> points;
    std::vector<branch_point> events;
};

namespace detail {

/// g(h, x) = (x_1 - x)/h, its gradient by central differences, and the tangent of g = 0.
template <class F>
class fixed_point_curve {
  public:
    fixed_point_curve(const tableau<double>& m, F f) : m_(m), f_(std::move(f)) {}

    double value(const Eigen::Vector2d& z) const {
        const auto y = rk_step<1>(m_, f_, state<double, 1>(z[1]), z[0]);
        return y ? ((*y)[0] - z[1]) / z[0] : std::nan("");
    }
    Eigen::Vector2d gradient(const Eigen::Vector2d& z) const {
        Eigen::Vector2d g;
        for (int k = 0; k < 2; ++k) {
            Eigen::Vector2d d = Eigen::Vector2d::Zero();
            d[k] = 1e-6 * std::max(1.0, std::abs(z[k]));
            g[k] = (value(z + d) - value(z - d)) / (2 * d[k]);
        }
        return g;
    }
    /// Of length 1, on the side of `before`.
    Eigen::Vector2d tangent(const Eigen::Vector2d& z, const Eigen::Vector2d& before) const {
        const Eigen::Vector2d g = gradient(z);
        if (!(g.norm() > 1e-9)) return before;  // branches cross here
        const Eigen::Vector2d t = Eigen::Vector2d(-g[1], g[0]).normalized();
        return t.dot(before) < 0 ? Eigen::Vector2d(-t) : t;
    }
    /// The point of the curve in the plane through z + s t at right angles to t, by Newton's method.
    std::optional<Eigen::Vector2d> next(const Eigen::Vector2d& z, const Eigen::Vector2d& t, double s) const {
        const Eigen::Vector2d guess = z + s * t;
        Eigen::Vector2d p = guess;
        for (int k = 0; k < 30; ++k) {
            Eigen::Matrix2d J;
            J.row(0) = gradient(p).transpose();
            J.row(1) = t.transpose();
            const Eigen::Vector2d r(value(p), t.dot(p - guess)), d = J.partialPivLu().solve(r);
            if (r.norm() == 0) return p;
            if (!d.allFinite() || d.norm() > 1) return {};
            p -= d;
            if (d.norm() <= 1e-11 * std::max(1.0, p.norm())) return p;
        }
        return {};
    }

  private:
    tableau<double> m_;
    F f_;
};

}  // namespace detail

/// Follows the fixed point x of a method for a scalar autonomous f from h towards larger h (or smaller, for a negative
/// `step`) by pseudo-arclength continuation, until h leaves [least, most], and locates the events on the way by
/// bisection. `step` is the length of a step in the (h, x) plane. Throws std::invalid_argument where x is no fixed
/// point at h, or the range of h is none.
template <class F>
branch follow(const tableau<double>& method, F f, double h, double x, double least, double most,
              double step = 0.02) {
    if (!(0 < least && least <= h && h <= most) || !std::isfinite(most))
        throw std::invalid_argument("h: needs 0 < least <= h <= most, finite");
    if (step == 0 || !std::isfinite(step)) throw std::invalid_argument("step: must be finite and not 0");
    const detail::fixed_point_curve<F> curve(method, std::move(f));
    Eigen::Vector2d z(h, x);
    if (!(std::abs(curve.value(z)) <= 1e-8 * std::max(1.0, std::abs(x))))
        throw std::invalid_argument("x: must be a fixed point at h");
    branch found{{z}, {}};
    Eigen::Vector2d t = curve.tangent(z, Eigen::Vector2d(step < 0 ? -1 : 1, 0));
    const double length = std::abs(step);
    for (int n = 0; n < 100'000; ++n) {
        const auto to = curve.next(z, t, length);
        if (!to || !((*to)[0] >= least && (*to)[0] <= most)) break;
        const Eigen::Vector2d turned = curve.tangent(*to, t);
        const auto locate = [&](branch_event kind, auto test) {  // where test changes its sign
            const bool before = test(z, t) > 0;
            double low = 0, high = length;
            for (int k = 0; k < 40; ++k) {
                const double s = (low + high) / 2;
                const auto p = curve.next(z, t, s);
                if (!p) break;
                ((test(*p, curve.tangent(*p, t)) > 0) == before ? low : high) = s;
            }
            if (const auto p = curve.next(z, t, high)) found.events.push_back({kind, (*p)[0], (*p)[1]});
        };
        const auto along_h = [](const Eigen::Vector2d&, const Eigen::Vector2d& d) { return d[0]; };
        const auto slope = [&](const Eigen::Vector2d& p, const Eigen::Vector2d&) {
            return curve.gradient(p)[1];
        };
        const auto flipped = [&](const Eigen::Vector2d& p, const Eigen::Vector2d&) {
            return 2 + p[0] * curve.gradient(p)[1];  // 1 + the multiplier
        };
        const auto changes = [&](auto test) { return (test(z, t) > 0) != (test(*to, turned) > 0); };
        if (changes(along_h))
            locate(branch_event::fold, along_h);
        else if (changes(slope))
            locate(branch_event::branching, slope);
        if (changes(flipped)) locate(branch_event::flip, flipped);
        z = *to;
        t = turned;
        found.points.push_back(z);
    }
    return found;
}

}  // namespace stagecraft::theory
