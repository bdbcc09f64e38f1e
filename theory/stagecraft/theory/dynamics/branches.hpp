// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "stagecraft/theory/dynamics/rk_map.hpp"

namespace stagecraft::theory {

/// What happens to a fixed point of a method's map as h changes: two meet and vanish (fold), a multiplier passes -1
/// and a cycle of period two is born (flip), or another branch crosses, a multiplier passing 1 (branching: a
/// pitchfork where f is odd).
enum class branch_event { fold, flip, branching };

/// Where it happens: (h, x).
template <int N>
struct branch_point {
    branch_event kind;
    double h;
    state<double, N> x;
};

/// A curve of fixed points (h, x), x of N numbers, with what was met on the way. Measured, in doubles; nothing is
/// proved.
template <int N>
struct branch {
    std::vector<Eigen::Matrix<double, N + 1, 1>> points;
    std::vector<branch_point<N>> events;
};

namespace detail {

/// g(h, x) = (x_1 - x)/h, its derivative D = (g_h, g_x) by central differences, and the tangent of g = 0.
template <int N, class F>
class fixed_point_curve {
  public:
    using point = Eigen::Matrix<double, N + 1, 1>;
    using derivatives = Eigen::Matrix<double, N, N + 1>;
    using square = Eigen::Matrix<double, N + 1, N + 1>;

    fixed_point_curve(const tableau<double>& m, F f) : m_(m), f_(std::move(f)) {}

    state<double, N> value(const point& z) const {
        const state<double, N> x = z.template tail<N>();
        const auto y = rk_step<N>(m_, f_, x, z[0]);
        if (!y) return state<double, N>::Constant(std::nan(""));
        return (*y - x) / z[0];
    }
    derivatives derivative(const point& z) const {
        derivatives D;
        for (int k = 0; k <= N; ++k) {
            point d = point::Zero();
            d[k] = 1e-6 * std::max(1.0, std::abs(z[k]));
            D.col(k) = (value(z + d) - value(z - d)) / (2 * d[k]);
        }
        return D;
    }
    /// D above the row t.
    square bordered(const point& z, const point& t) const {
        square J;
        J << derivative(z), t.transpose();
        return J;
    }
    /// Of length 1, on the side of `before`; `before` itself where branches cross.
    point tangent(const point& z, const point& before) const {
        const Eigen::FullPivLU<square> lu(bordered(z, before));
        const point t = lu.solve(point::Unit(N));
        if (!t.allFinite() || !(t.norm() < 1e8)) return before;
        return t.normalized();
    }
    /// The point of the curve in the plane through z + s t at right angles to t, by Newton's method.
    std::optional<point> next(const point& z, const point& t, double s) const {
        const point guess = z + s * t;
        point p = guess;
        for (int k = 0; k < 30; ++k) {
            point r;
            r << value(p), t.dot(p - guess);
            if (r.norm() == 0) return p;
            const point d = Eigen::FullPivLU<square>(bordered(p, t)).solve(r);
            if (!d.allFinite() || d.norm() > 1) return {};
            p -= d;
            if (d.norm() <= 1e-11 * std::max(1.0, p.norm())) return p;
        }
        return {};
    }
    /// Functions whose sign changes show the events: dh along the curve; the determinant of D bordered by the tangent
    /// (Allgower-Georg, Numerical Continuation Methods, chapter 8); det(1 + the map's derivative) = det(2 + h g_x).
    double sign_of(branch_event kind, const point& z, const point& t) const {
        if (kind == branch_event::fold) return t[0];
        if (kind == branch_event::branching) return bordered(z, t).determinant();
        Eigen::Matrix<double, N, N> flip = z[0] * derivative(z).template rightCols<N>();
        flip.diagonal().array() += 2;
        return flip.determinant();
    }

  private:
    tableau<double> m_;
    F f_;
};

/// Where the sign for `kind` changes within `length` of z along the curve, by bisection.
template <int N, class F>
std::optional<branch_point<N>> located(const fixed_point_curve<N, F>& curve, branch_event kind,
                                       const Eigen::Matrix<double, N + 1, 1>& z,
                                       const Eigen::Matrix<double, N + 1, 1>& t, double length) {
    const bool before = curve.sign_of(kind, z, t) > 0;
    double low = 0, high = length;
    for (int k = 0; k < 40; ++k) {
        const double s = (low + high) / 2;
        const auto p = curve.next(z, t, s);
        if (!p) break;
        ((curve.sign_of(kind, *p, curve.tangent(*p, t)) > 0) == before ? low : high) = s;
    }
    const auto p = curve.next(z, t, high);
    if (!p) return {};
    return branch_point<N>{kind, (*p)[0], p->template tail<N>()};
}

}  // namespace detail

/// Follows the fixed point x of a method for an autonomous f of N unknowns from h towards larger h (or smaller, for a
/// negative `step`) by pseudo-arclength continuation, until h leaves [least, most], and locates the events on the way
/// by bisection. `step` is the length of a step in (h, x). Throws std::invalid_argument where x is no fixed point at h,
/// or the range of h is none. Cost: about 4 (N + 1) steps of the method for each point, 40 times that for an event.
template <int N, class F>
branch<N> follow(const tableau<double>& method, F f, double h, const state<double, N>& x, double least,
                 double most, double step = 0.02) {
    using point = Eigen::Matrix<double, N + 1, 1>;
    if (!(0 < least && least <= h && h <= most) || !std::isfinite(most))
        throw std::invalid_argument("h: needs 0 < least <= h <= most, finite");
    if (step == 0 || !std::isfinite(step)) throw std::invalid_argument("step: must be finite and not 0");
    const detail::fixed_point_curve<N, F> curve(method, std::move(f));
    point z;
    z << h, x;
    if (!(curve.value(z).norm() <= 1e-8 * std::max(1.0, x.norm())))
        throw std::invalid_argument("x: must be a fixed point at h");
    branch<N> found{{z}, {}};
    point t = curve.tangent(z, point::Unit(0) * (step < 0 ? -1 : 1));
    for (int n = 0; n < 100'000; ++n) {
        const auto to = curve.next(z, t, std::abs(step));
        if (!to || !((*to)[0] >= least && (*to)[0] <= most)) break;
        const point turned = curve.tangent(*to, t);
        for (const auto kind : {branch_event::fold, branch_event::branching, branch_event::flip})
            if ((curve.sign_of(kind, z, t) > 0) != (curve.sign_of(kind, *to, turned) > 0))
                if (const auto event = detail::located<N>(curve, kind, z, t, std::abs(step)))
                    found.events.push_back(*event);
        z = *to;
        t = turned;
        found.points.push_back(z);
    }
    return found;
}

}  // namespace stagecraft::theory
