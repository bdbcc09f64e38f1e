// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

namespace stagecraft {

/// The two ends of an interval of time and the values of a function there; b may lie before a.
template <class Scalar>
struct time_bracket {
    Scalar a, at_a, b, at_b;
};

/// True if g, nonzero at a, reaches or crosses zero towards b.
template <class Scalar>
bool changes_sign(const time_bracket<Scalar>& i) {
    return (i.at_a < Scalar(0) && i.at_b >= Scalar(0)) || (i.at_a > Scalar(0) && i.at_b <= Scalar(0));
}

/// Narrows a bracket with changes_sign() until its length is at most `resolution` (> 0) or no floating-point
/// number lies between its ends. Then g is zero or has its new sign at b, and its old sign at a.
/// Regula falsi with the Illinois weights, and a bisection whenever three steps have not halved the interval;
/// where g is zero at b, leaps back from b that grow while it stays zero. About ten evaluations for a smooth
/// g, at most four per halving. g must not return NaN.
template <class Scalar, class F>
void narrow(F&& g, time_bracket<Scalar>& i, const Scalar& resolution) {
    using std::abs;
    Scalar weight_a = i.at_a, weight_b = i.at_b, goal = (i.b - i.a) / 2, leap = Scalar(1);
    int steps = 0, side = 0;
    for (;;) {
        const Scalar width = i.b - i.a;
        if (!(abs(width) > resolution)) return;
        if (abs(width) <= abs(goal)) {
            goal = width / 2;
            steps = 0;
        }
        const Scalar middle = i.a + width / 2, step = width < Scalar(0) ? Scalar(-resolution) : resolution;
        Scalar t = middle;
        if (steps++ < 3 && abs(width) > 2 * resolution) {
            const Scalar guess =
                i.at_b == Scalar(0) ? i.b - leap * step : i.b - weight_b * (width / (weight_b - weight_a));
            // A point close to an end is moved inwards, so that the next one may close in from there.
            const Scalar from_a = (guess - i.a) / step, to_b = (i.b - guess) / step;
            if (from_a < Scalar(1))
                t = i.at_b == Scalar(0) ? middle : Scalar(i.a + step);
            else if (to_b < Scalar(1))
                t = i.b - step;
            else if (from_a - from_a == Scalar(0))
                t = guess;
        }
        if (t == i.a || t == i.b) t = middle;
        if (t == i.a || t == i.b) return;
        const Scalar v = g(t);
        if (v != Scalar(0) && (v < Scalar(0)) == (i.at_a < Scalar(0))) {
            i.a = t;
            i.at_a = weight_a = v;
            if (side == -1) weight_b /= 2;
            side = -1;
            leap = Scalar(1);
        } else {
            i.b = t;
            i.at_b = weight_b = v;
            if (side == 1) weight_a /= 2;
            side = 1;
            leap *= 4;
        }
    }
}

/// Looks for a point where g, which has the same sign at both ends of the bracket, is zero or has the other
/// sign. A golden section search follows the extremum to 1e-8 of the interval and ends as soon as such a
/// point is met: then it returns true and sets t and value. An extremum of at most `touch` is taken for zero. g must not
/// return NaN.
template <class Scalar, class F>
bool find_dip(F&& g, const time_bracket<Scalar>& i, const Scalar& touch, Scalar& t, Scalar& value) {
    using std::sqrt;
    const bool negative = i.at_a < Scalar(0);
    const Scalar golden = (Scalar(3) - sqrt(Scalar(5))) / 2;
    const auto height = [&](const Scalar& x) {
        t = x;
        value = g(x);
        return negative ? Scalar(-value) : value;
    };
    Scalar left = i.a, right = i.b;
    Scalar x = left + golden * (right - left), y = right - golden * (right - left);
    Scalar at_x = height(x);
    if (at_x <= Scalar(0)) return true;
    Scalar at_y = height(y);
    for (int k = 0; at_y > Scalar(0) && k < 40; ++k) {
        if (at_x < at_y) {
            right = y;
            y = x;
            at_y = at_x;
            x = left + golden * (right - left);
            at_x = height(x);
            if (at_x <= Scalar(0)) return true;
        } else {
            left = x;
            x = y;
            at_x = at_y;
            y = right - golden * (right - left);
            at_y = height(y);
        }
    }
    if (at_y > touch) return false;
    if (at_y > Scalar(0)) t = y, value = Scalar(0);
    return true;
}

}  // namespace stagecraft
