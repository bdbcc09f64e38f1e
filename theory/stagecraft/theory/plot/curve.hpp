// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

namespace stagecraft::theory::plot {

using complex = std::complex<double>;

/// A part of the complex plane, sides parallel to the axes.
struct window {
    double left, right, bottom, top;

    double width() const { return right - left; }
    double height() const { return top - bottom; }
    double diagonal() const { return std::hypot(width(), height()); }
    bool contains(complex z) const;
    /// Distance of z from the window, 0 inside.
    double distance(complex z) const;
};

/// Throws std::invalid_argument unless the window has a finite, positive width and height.
void require_window(const window& w);

/// log|f(z)| and f'(z)/f(z): all that a level curve of |f| needs of an analytic f.
struct log_value {
    double log_modulus;
    complex log_derivative;
};

/// A traced curve; `closed` where its last point is its first.
struct curve {
    std::vector<complex> points;
    bool closed = false;
};

/// Traces the curves |f| = 1 of an analytic function by predictor and corrector: a step along the tangent
/// i conj(f'/f), then Newton's method z -= log|f| / (f'/f), which moves at right angles to the curve. A step
/// is halved where Newton moves the point by more than a quarter of it or where the tangent turns by more
/// than 30 degrees. Points lie on the curve up to rounding. `f` maps complex to log_value.
template <class F>
class level_tracer {
  public:
    /// `step`: distance of neighbouring points inside the window (outside, where nothing is drawn, it grows
    /// with the distance); a curve is left where it is farther than `reach` from the window.
    /// Curves end at 0 when they come nearer to it than `hole`: where log|f| vanishes there of a high order,
    /// its sign drowns in rounding.
    level_tracer(F f, const window& view, double step, double reach, double hole = 0)
        : f_(std::move(f)), view_(view), step_(step), reach_(reach), hole_(hole) {
        require_window(view);
        if (!(step > 0)) throw std::invalid_argument("step: must be positive");
    }

    /// The point of the curve that Newton's method finds from z; nothing where it finds none close by.
    std::optional<complex> onto_curve(complex z) const {
        double last = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 40; ++k) {
            const log_value v = f_(z);
            const complex move = v.log_modulus / v.log_derivative;
            if (!std::isfinite(move.real()) || !std::isfinite(move.imag())) return {};
            z -= move;
            const double size = std::abs(move);
            if (size <= 1e-14 * (1 + std::abs(z)) || (k > 3 && size >= last)) {
                if (size > 1e-8 * (1 + std::abs(z))) return {};
                return z;
            }
            last = size;
        }
        return {};
    }

    /// The whole curve through `start`, a point on it, followed both ways until it closes, leaves the reach
    /// or runs into a critical point of f.
    curve trace(complex start) const {
        curve forward = half(start, 1);
        if (forward.closed) return forward;
        curve backward = half(start, -1);
        std::reverse(backward.points.begin(), backward.points.end());
        backward.points.insert(backward.points.end(), forward.points.begin() + 1, forward.points.end());
        return backward;
    }

    /// The curves through the starting points, each once. Starts within a quarter of a step of an earlier
    /// curve are taken to lie on it.
    std::vector<curve> trace_all(const std::vector<complex>& starts) const {
        std::vector<curve> all;
        for (const complex s : starts) {
            const auto z = onto_curve(s);
            if (!z || view_.distance(*z) > reach_) continue;
            const double near = 0.25 * local_step(*z);
            if (std::none_of(all.begin(), all.end(), [&](const curve& c) { return passes(c, *z, near); }))
                all.push_back(trace(*z));
        }
        return all;
    }

  private:
    double local_step(complex z) const { return step_ * (1 + 20 * view_.distance(z) / view_.diagonal()); }
    complex tangent(complex z, double direction) const {
        const complex g = f_(z).log_derivative;
        return direction * complex(0, 1) * std::conj(g) / std::abs(g);
    }

    static double distance(complex z, complex a, complex b) {
        const double length = std::norm(b - a);
        const double t =
            length > 0 ? std::clamp((std::conj(b - a) * (z - a)).real() / length, 0.0, 1.0) : 0.0;
        return std::abs(z - a - t * (b - a));
    }
    static bool passes(const curve& c, complex z, double near) {
        for (std::size_t k = 1; k < c.points.size(); ++k)
            if (distance(z, c.points[k - 1], c.points[k]) < near) return true;
        return false;
    }

    curve half(complex start, double direction) const {
        curve c{{start}, false};
        complex z = start, t = tangent(z, direction);
        double h = local_step(z);
        for (int k = 0; k < most_points; ++k) {
            h = std::min(2 * h, local_step(z));
            std::optional<complex> next;
            for (; h > 1e-6 * step_; h /= 2) {
                next = onto_curve(z + h * t);
                if (next && std::abs(*next - z - h * t) < 0.25 * h) {
                    const complex turned = tangent(*next, direction);
                    if ((std::conj(t) * turned).real() > cos_30_degrees) {
                        t = turned;
                        break;
                    }
                }
                next.reset();
            }
            if (!next) return c;  // a critical point of f on the curve
            if (k > 2 && distance(start, z, *next) < 0.25 * std::abs(*next - z) &&
                (std::conj(t) * tangent(start, direction)).real() > 0) {
                c.points.push_back(start);
                c.closed = true;
                return c;
            }
            z = *next;
            if (std::abs(z) < hole_) {
                c.points.emplace_back(0);
                return c;
            }
            c.points.push_back(z);
            if (view_.distance(z) > reach_) return c;
        }
        return c;
    }

    static constexpr int most_points = 100'000;
    static constexpr double cos_30_degrees = 0.8660254037844387;

    F f_;
    window view_;
    double step_;
    double reach_;
    double hole_;
};

}  // namespace stagecraft::theory::plot

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/plot/curve-inl.hpp"
#endif
