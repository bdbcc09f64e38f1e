// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <type_traits>

#include <stagecraft/bvp/measure/conditioning.hpp>

namespace stagecraft::detail {

/// Does f give the same at other times, in the middle of every interval of x?
template <class Equations, class Iterate>
bool is_autonomous(Equations& equations, const Iterate& x) {
    const int L = x.intervals();
    const auto middle = [&](int i) { return (x.t[i] + x.t[i + 1]) / 2; };
    for (int i = 0; i < L; ++i) {
        const typename Equations::state y = (x.y.col(i) + x.y.col(i + 1)) / 2,
                                        here = equations.slope(middle(i), y, x.p);
        if (!(here == equations.slope(middle((i + L / 2 + 1) % L), y, x.p))) return false;
    }
    return true;
}

/// The derivative of a solution of y' = f(y) solves the equations linearised at it, so that y' = Phi d with
/// d = B_a y'(a) + B_b y'(b): where d is small, the problem hardly says where y lies in time (layers held in place by
/// exponentially small terms, Carr-Pego 1989). By how much do the answers on the mesh to d differ from y', as a part of y'?
/// About 1 where the mesh holds in place what the problem does not, and M on it is not that of the problem. 0 where f depends
/// on t, where mass() stands before y', and where `error`, that of x, leaves nothing of y'.
template <class Equations, class Iterate, class Scalar>
Scalar translation_missed(Equations& equations, conditioning_of<Equations>& conditioning, const Iterate& x,
                          const Scalar& threshold, const Scalar& error) {
    using std::abs;
    if (!equations.mass().identity() || !is_autonomous(equations, x)) return Scalar(0);
    const int n = equations.n(), np = equations.np(), L = x.intervals();
    typename Equations::wide v(n, L + 1);
    for (int i = 0; i <= L; ++i) v.col(i) = equations.slope((x.t[0] + x.t[1]) / 2, x.y.col(i), x.p);
    if (!(v.sum() - v.sum() == Scalar(0))) return Scalar(0);
    typename Equations::state scale(n);
    for (int c = 0; c < n; ++c) scale[c] = threshold + x.y.row(c).cwiseAbs().maxCoeff();
    const auto size = [&] {  // of v beside y
        Scalar most(0);
        for (int i = 0; i <= L; ++i)
            for (int c = 0; c < n; ++c) most = std::max(most, Scalar(abs(v(c, i)) / scale[c]));
        return most;
    };
    const Scalar whole = size();
    Scalar noise(0);  // what `error` makes of f
    for (int i = 0; i < L; ++i) {
        const auto J = equations.jacobians(i);
        for (int c = 0; c < n; ++c) {
            Scalar sum(0);
            for (int d = 0; d < n; ++d) sum += abs(J(c, d)) * scale[d];
            noise = std::max(noise, Scalar(sum * error / scale[c]));
        }
    }
    if (!(whole > 20 * noise)) return Scalar(0);
    const auto& B = equations.conditions();
    conditioning.fundamental();
    const typename Equations::wide slopes = v;
    for (int k = 0; k < n + np; ++k) {
        Scalar d(0);
        for (int c = 0; c < n; ++c) d += B(k, c) * slopes(c, 0) + B(k, n + c) * slopes(c, L);
        v -= d * conditioning.response(k);
    }
    return size() / whole;
}

}  // namespace stagecraft::detail
