// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include <stagecraft/bvp/equations/mesh.hpp>
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

    /// The next mesh. Its density is that of the errors of the collocation polynomial, which go with h^(s+1) and change
    /// smoothly; its size follows from what every interval contributes to the global error, which goes with h^p, or
    /// with h^(s+1) where stiffness leaves nothing of superconvergence.
    /// Where f jumps in few of them and their errors count, these are divided for themselves (`divide`): no mesh
    /// that is finer elsewhere helps there.
    std::vector<Scalar> refined(const Scalar& error, const Scalar& floor, bool double_it, bool divide) {
        using std::abs;
        using std::pow;
        const int L = x_.intervals(), n = equations_.n(), s = equations_.s();
        std::vector<Scalar> part(static_cast<std::size_t>(L)), local(part);
        Scalar total(0), all(0);
        int worst = 0;
        bool superconvergent = true;
        for (int i = 0; i < L; ++i) {
            Scalar raised(0);
            for (int c = 0; c < n; ++c) {
                const Scalar size = floor + std::max(abs(x_.y(c, i)), abs(x_.y(c, i + 1)));
                local[i] = std::max(
                    local[i],
                    Scalar((estimate_.local(c, i) + abs(estimate_.inner()(c, i)) / 20) / (o_.rtol * size)));
                raised = std::max(raised, Scalar(estimate_.raised()(c, i) / (o_.rtol * size)));
            }
            if (!(local[i] < Scalar(1e30))) local[i] = Scalar(1e30);
            if (!(raised < Scalar(1e30))) raised = Scalar(1e30);
            total += local[i];
            if (local[i] >= local[worst]) worst = i, superconvergent = 10 * local[i] < raised;
            part[i] = pow(Scalar(std::max(raised, local[i]) + Scalar(1e-12)), Scalar(1) / Scalar(s + 1));
            all += part[i];
        }
        std::vector<int> apart;
        if (divide) apart = set_apart(local, part, total, all);
        // No step becomes much longer at once: what hides behind larger errors elsewhere stays resolved. Where the shares
        // differ by little, the mesh keeps its shape (Ascher-Christiansen-Russell 1981): symmetric methods leave of the
        // local errors of stiff components what changes from interval to interval, which other steps would enlarge.
        const bool even = *std::max_element(part.begin(), part.end()) * Scalar(L) < 2 * all;
        for (Scalar& p : part) p = even ? Scalar(1) : std::max(p, Scalar(all / Scalar(10 * L)));
        const int order = superconvergent || x_.h(worst) < 5 * reach(worst, 0) ? estimate_.order() : s + 1;
        const auto density = mesh_density(x_.t, part, Scalar(5));
        Scalar sum(0), needed(0);
        for (int i = 0; i < L; ++i) {
            part[i] = x_.h(i) * (density[i] + density[i + 1]) / 2;
            sum += part[i];
        }
        for (int i = 0; i < L; ++i) needed += local[i] * pow(Scalar(sum / part[i]), Scalar(order));
        const Scalar gain = error / (o_.rtol * std::max(total, Scalar(1e-20)));
        const Scalar wanted = pow(Scalar(gain * needed / Scalar(0.25)), Scalar(1) / Scalar(order));
        const int least = even ? L + 1 : std::max(3, L / 2), most = 4 * L;
        int intervals = wanted < Scalar(most) ? static_cast<int>(static_cast<double>(wanted)) + 1 : most;
        intervals = std::clamp(intervals, least, most);
        if (double_it && apart.empty()) intervals = std::max(intervals, 2 * L);
        auto mesh = equidistributed(x_.t, density, intervals, o_.fixed_points);
        const Scalar ratio = std::min(Scalar(2 * error / o_.rtol), Scalar(8));
        for (const int i : apart)
            mesh = subdivided(mesh, x_.t[i], x_.t[i + 1],
                              std::max(2, static_cast<int>(static_cast<double>(ratio))), o_.fixed_points);
        return mesh;
    }

    /// The next mesh where the solution is wrong in its first digit and errors say nothing of where it is hard: the same
    /// share of the variation of y and of the length for every interval, and the ends resolved.
    std::vector<Scalar> spread() {
        using std::abs;
        const int L = x_.intervals(), n = equations_.n(), s = equations_.s();
        if (missed_phase(equations_, x_, estimate_.order()) > Scalar(1)) return following_turns();
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
        return resolving(equidistributed(x_.t, mesh_density(x_.t, part, Scalar(5)), std::max(16, 3 * L / 2),
                                         o_.fixed_points));
    }

    /// A mesh with points added where layers may be, whether y has them or not: at the ends, and inside.
    std::vector<Scalar> resolving(std::vector<Scalar> mesh) {
        using std::sqrt;
        const int L = x_.intervals(), s = equations_.s();
        if (!begins_singular()) mesh = graded(mesh, x_.t.front(), reach(0, 0));
        if (!ends_singular()) mesh = graded(mesh, x_.t.back(), reach(L - 1, s - 1));
        // Layers inside are where modes that grow turn into modes that decay.
        for (int k = 1; k < s * L; ++k) {
            const Scalar before = trace(k - 1), after = trace(k);
            if (!(before > Scalar(0) && after < Scalar(0))) continue;
            const Scalar t = node(k - 1), step = node(k) - t;
            mesh = graded(mesh, Scalar(t + step * before / (before - after)),
                          Scalar(2 * sqrt(step / (before - after))));
        }
        return mesh;
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
        for (Scalar& p : part) p = std::max(p, Scalar(all / Scalar(10 * L)));
        const Scalar wanted = std::min(Scalar(all / 2), Scalar(o_.max_intervals));
        const int intervals = static_cast<int>(static_cast<double>(wanted));
        return equidistributed(x_.t, mesh_density(x_.t, part, Scalar(5)), std::max(3 * L / 2, intervals),
                               o_.fixed_points);
    }
    /// Is the step that resolves the fastest mode longer by what the distance from the end is longer, within a third?
    static bool in_proportion(const Scalar& near_reach, const Scalar& near, const Scalar& far_reach,
                              const Scalar& far) {
        return far > 3 * near / 2 && 3 * far_reach * near > 2 * near_reach * far;
    }
    /// The intervals in which f jumps, if these are few and their errors count. They are as others from then on.
    std::vector<int> set_apart(std::vector<Scalar>& local, std::vector<Scalar>& part, const Scalar& total,
                               Scalar& all) const {
        const int L = x_.intervals();
        std::vector<int> apart;
        Scalar of_jumps(0), other(0);
        for (int i = 0; i < L; ++i) {
            if (estimate_.jumps()[i])
                apart.push_back(i), of_jumps += local[i];
            else
                other += part[i];
        }
        const int count = static_cast<int>(apart.size());
        if (4 * count > L || !(10 * of_jumps > total)) return {};
        for (const int i : apart) local[i] = Scalar(0), part[i] = other / Scalar(L - count);
        all = other * Scalar(L) / Scalar(L - count);
        return apart;
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
