// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include <stagecraft/bvp/judge/mesh_points.hpp>
#include <stagecraft/bvp/judge/mesh_refinement.hpp>
#include <stagecraft/bvp/measure/error_estimate.hpp>
#include <stagecraft/bvp/measure/missed_phase.hpp>
#include <stagecraft/bvp/options.hpp>

namespace stagecraft::detail {

/// The mesh that follows a solution x and its estimated errors.
template <class Equations>
class mesh_choice {
  public:
    using iterate = typename Equations::iterate;
    using Scalar = std::decay_t<decltype(iterate{}.t[0])>;

    mesh_choice(Equations& equations, const error_estimate<Equations>& estimate, const iterate& x,
                const bvp_options<Scalar>& o)
        : equations_(equations), estimate_(estimate), x_(x), o_(o) {}

    /// The next mesh by the errors (judge/mesh_refinement.hpp). Contributions to the global error go with h^p, or with h^(s+1)
    /// where stiffness leaves nothing of superconvergence.
    std::vector<Scalar> refined(const Scalar& error, const Scalar& threshold, bool doubled, bool divide) {
        const interval_errors<Scalar> e = errors(threshold);
        const int s = equations_.s(), worst = e.worst();
        const bool superconvergent =
            e.superconvergent(worst) || x_.h(worst) < resolving_steps * reach(worst, 0);
        return refined_mesh(x_.t, e,
                            {s, superconvergent ? estimate_.order() : s + 1, error, o_.rtol, doubled, divide,
                             o_.fixed_points});
    }

    /// The next mesh where the solution is wrong in its first digit and errors say nothing of where it is hard: the same
    /// share of the variation of y and of the length for every interval, and the ends resolved.
    std::vector<Scalar> spread() {
        using std::abs;
        const int L = x_.intervals(), n = equations_.n(), s = equations_.s();
        if (missed_phase(equations_, x_, estimate_.order()) > Scalar(lost_phase)) return following_turns();
        std::vector<Scalar> part(static_cast<std::size_t>(L)), variation(part);
        for (int i = 0; i < L; ++i) part[i] = Scalar(1) / Scalar(L);
        for (int c = 0; c < n; ++c) {
            Scalar all(0);
            for (int i = 0; i < L; ++i) {
                variation[i] = Scalar(0);
                for (int j = 0; j < s; ++j)
                    variation[i] += equations_.method().b[j] * abs(x_.Z(c, i * s + j));
                all += variation[i];
            }
            if (!(all > Scalar(0)) || !(all - all == Scalar(0))) continue;
            for (int i = 0; i < L; ++i) part[i] += variation[i] / (all * Scalar(n));
        }
        return resolving(equidistributed(x_.t, mesh_density(x_.t, part, Scalar(density_ratio)),
                                         std::max(least_spread, 3 * L / 2), o_.fixed_points));
    }

    /// A mesh with points added where layers may be, whether y has them or not: at the ends, and inside.
    std::vector<Scalar> resolving(std::vector<Scalar> mesh) {
        using std::sqrt;
        const int L = x_.intervals(), s = equations_.s();
        if (!begins_singular()) mesh = graded(mesh, x_.t.front(), reach(0, 0));
        if (!ends_singular()) mesh = graded(mesh, x_.t.back(), reach(L - 1, s - 1));
        // Layers inside are where modes that grow turn into modes that decay. Where that would make most of the mesh, they are
        // those of an iterate that no mesh has resolved, and the mesh stays as it is.
        const std::vector<Scalar> ends = mesh;
        for (int k = 1; k < s * L; ++k) {
            const Scalar before = trace(k - 1), after = trace(k);
            if (!(before > Scalar(0) && after < Scalar(0))) continue;
            const Scalar t = node(k - 1), step = node(k) - t;
            mesh = graded(mesh, Scalar(t + step * before / (before - after)),
                          Scalar(2 * sqrt(step / (before - after))));
        }
        return mesh.size() <= most_growth * ends.size() ? mesh : ends;
    }

    /// Is the end a a singular point of the first kind: does the Jacobian go like 1/(t - a) in the first interval? Its modes
    /// are as fast beside any mesh, however fine, so that none resolves them, and none has to.
    bool begins_singular() {
        const auto& c = equations_.method().c;
        const int last = equations_.s() - 1;
        return in_proportion(reach(0, 0), c[0], reach(0, last), c[last]);
    }
    /// The same at b.
    bool ends_singular() {
        const auto& c = equations_.method().c;
        const int L = x_.intervals(), last = equations_.s() - 1;
        return in_proportion(reach(L - 1, last), 1 - c[last], reach(L - 1, 0), 1 - c[0]);
    }

  private:
    /// Steps of the length at which the fastest mode is resolved: with fewer in an interval there is superconvergence.
    static constexpr int resolving_steps = 5;
    static constexpr int density_ratio = refinement<Scalar>::density_ratio,
                         longer_than_mean = refinement<Scalar>::longer_than_mean,
                         most_growth = refinement<Scalar>::most_growth;
    /// A mesh that follows y has at least so many intervals, and half as many again as the one before.
    static constexpr int least_spread = 16;
    /// Modes that a mesh misses by more than this (radian) are what makes its solution wrong.
    static constexpr int lost_phase = 1;
    /// An interval may hold two radians of the fastest turn.
    static constexpr int turn = 2;

    /// The next mesh where modes turn faster than this one shows: the same angle for every interval, two radians where
    /// max_intervals are enough for that.
    std::vector<Scalar> following_turns() {
        const int L = x_.intervals();
        std::vector<Scalar> part(static_cast<std::size_t>(L));
        Scalar all(0);
        for (int i = 0; i < L; ++i) {
            part[i] = fastest_turn(middle_jacobian(equations_, x_, i), Scalar(0)).angle;
            all += part[i];
        }
        for (Scalar& p : part) p = std::max(p, Scalar(all / Scalar(longer_than_mean * L)));
        const Scalar wanted = std::min(Scalar(all / turn), Scalar(o_.max_intervals));
        const int intervals = static_cast<int>(static_cast<double>(wanted));
        return equidistributed(x_.t, mesh_density(x_.t, part, Scalar(density_ratio)),
                               std::max(3 * L / 2, intervals), o_.fixed_points);
    }
    /// Is the step that resolves the fastest mode longer by what the distance from the end is longer, within a third?
    static bool in_proportion(const Scalar& near_reach, const Scalar& near, const Scalar& far_reach,
                              const Scalar& far) {
        return far > 3 * near / 2 && 3 * far_reach * near > 2 * near_reach * far;
    }
    interval_errors<Scalar> errors(const Scalar& threshold) const {
        using std::abs;
        const int L = x_.intervals(), n = equations_.n();
        const Scalar most(1e30);  // whatever an error is, sums stay finite
        interval_errors<Scalar> e(L);
        e.jumps = estimate_.jumps();
        for (int i = 0; i < L; ++i) {
            for (int c = 0; c < n; ++c) {
                const Scalar size = threshold + std::max(abs(x_.y(c, i)), abs(x_.y(c, i + 1)));
                // Errors between mesh points leave their interval only through f_y: they count little.
                const Scalar local = estimate_.local(c, i) + abs(estimate_.inner()(c, i)) / 20;
                e.local[i] = std::max(e.local[i], Scalar(local / (o_.rtol * size)));
                e.removed[i] = std::max(e.removed[i], Scalar(estimate_.removed()(c, i) / (o_.rtol * size)));
            }
            if (!(e.local[i] < most)) e.local[i] = most;
            if (!(e.removed[i] < most)) e.removed[i] = most;
        }
        return e;
    }
    Scalar node(int k) const {
        const int s = equations_.s();
        return x_.t[k / s] + equations_.method().c[k % s] * x_.h(k / s);
    }
    Scalar trace(int k) {
        const int s = equations_.s(), width = equations_.n() + equations_.np();
        const auto J = equations_.jacobians(k / s);
        Scalar sum(0);
        for (int c = 0; c < equations_.n(); ++c) sum += J(c, (k % s) * width + c);
        return sum;
    }
    /// The step that resolves the fastest mode at node j of interval i: 2 over the spectral radius of the Jacobian.
    Scalar reach(int i, int j) {
        using std::sqrt;
        const int n = equations_.n();
        typename Equations::square J = equations_.jacobians(i).middleCols(j * (n + equations_.np()), n);
        Scalar step(2);  // over |J^16|^(1/16), by squares that are kept near 1
        for (const int root : {1, 2, 4, 8, 16}) {
            Scalar size = J.cwiseAbs().maxCoeff();
            if (!(size > Scalar(0))) return x_.t.back() - x_.t.front();
            J /= size;
            J = J.lazyProduct(J).eval();
            for (int k = root; k > 1; k /= 2) size = sqrt(size);
            step /= size;
        }
        return step;
    }

    Equations& equations_;
    const error_estimate<Equations>& estimate_;
    const iterate& x_;
    const bvp_options<Scalar>& o_;
};

}  // namespace stagecraft::detail
