// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <stagecraft/bvp/judge/mesh_points.hpp>

namespace stagecraft::detail {

/// The contribution of every interval of a mesh to the error, in units of the tolerance.
template <class Scalar>
struct interval_errors {
    std::vector<Scalar> local;    ///< local errors of the solution
    std::vector<Scalar> removed;  ///< those of the collocation polynomial, which lifting has removed
    std::vector<char> jumps;      ///< does f seem to jump in it?

    explicit interval_errors(int intervals)
        : local(static_cast<std::size_t>(intervals)),
          removed(local),
          jumps(static_cast<std::size_t>(intervals)) {}

    int size() const { return static_cast<int>(local.size()); }
    /// The interval of the largest local error, the last one of equals.
    int worst() const {
        int at = 0;
        for (int i = 0; i < size(); ++i)
            if (local[i] >= local[at]) at = i;
        return at;
    }
    /// Is the solution much better than the polynomial there, as it is where superconvergence holds?
    bool superconvergent(int i) const { return 10 * local[i] < removed[i]; }
};

/// How a mesh is refined.
template <class Scalar>
struct refinement {
    int stages, order;     ///< errors of the polynomial go with h^(stages + 1), contributions with h^order
    Scalar error, rtol;    ///< the global error, and what it may be
    bool doubled, divide;  ///< at least twice the intervals; those where f jumps for themselves
    const std::vector<Scalar>& fixed;

    /// The next mesh aims at a quarter of the tolerance.
    static constexpr double aim = 0.25;
    /// No step becomes more than ten times as long as the mean: what hides behind larger errors elsewhere stays resolved.
    static constexpr int longer_than_mean = 10;
    /// Where the largest share is less than twice the mean, the mesh keeps its shape (Ascher-Christiansen-Russell 1981):
    /// symmetric methods leave of the local errors of stiff components what changes from interval to interval, which other
    /// steps would enlarge.
    static constexpr int even_share = 2;
    /// A mesh has at most four times the intervals of the one before, and at least half as many.
    static constexpr int most_growth = 4, most_shrinking = 2;
    /// One interval is at most five times as dense as the next.
    static constexpr int density_ratio = 5;
    /// Intervals with a jump are divided for themselves if they are at most a quarter of all and make a tenth of the error:
    /// no mesh that is finer elsewhere helps there. Into eight parts at most.
    static constexpr int few_jumps = 4, counting_share = 10, most_parts = 8;
};

/// The intervals in which f jumps, if these are few and their errors count. They are as others from then on: `part` and `local`
/// are changed.
template <class Scalar>
std::vector<int> set_apart(const refinement<Scalar>& by, interval_errors<Scalar>& e,
                           std::vector<Scalar>& part, const Scalar& total, Scalar& all) {
    const int L = e.size();
    std::vector<int> apart;
    Scalar of_jumps(0), other(0);
    for (int i = 0; i < L; ++i) {
        if (e.jumps[i])
            apart.push_back(i), of_jumps += e.local[i];
        else
            other += part[i];
    }
    const int count = static_cast<int>(apart.size());
    if (by.few_jumps * count > L || !(by.counting_share * of_jumps > total)) return {};
    for (const int i : apart) e.local[i] = Scalar(0), part[i] = other / Scalar(L - count);
    all = other * Scalar(L) / Scalar(L - count);
    return apart;
}

/// The next mesh. Its density is that of the errors of the collocation polynomial, which change smoothly; its size follows from
/// what every interval contributes to the global error, which goes with h^order.
template <class Scalar>
std::vector<Scalar> refined_mesh(const std::vector<Scalar>& t, interval_errors<Scalar> e,
                                 const refinement<Scalar>& by) {
    using std::pow;
    const int L = e.size();
    std::vector<Scalar> part(e.local);
    Scalar total(0), all(0);
    for (int i = 0; i < L; ++i) {
        total += e.local[i];
        part[i] = pow(Scalar(std::max(e.removed[i], e.local[i]) + Scalar(1e-12)),
                      Scalar(1) / Scalar(by.stages + 1));
        all += part[i];
    }
    std::vector<int> apart;
    if (by.divide) apart = set_apart(by, e, part, total, all);
    const bool even = *std::max_element(part.begin(), part.end()) * Scalar(L) < by.even_share * all;
    for (Scalar& p : part) p = even ? Scalar(1) : std::max(p, Scalar(all / Scalar(by.longer_than_mean * L)));
    const auto density = mesh_density(t, part, Scalar(by.density_ratio));
    Scalar sum(0), needed(0);
    for (int i = 0; i < L; ++i) {
        part[i] = (t[i + 1] - t[i]) * (density[i] + density[i + 1]) / 2;
        sum += part[i];
    }
    for (int i = 0; i < L; ++i) needed += e.local[i] * pow(Scalar(sum / part[i]), Scalar(by.order));
    const Scalar gain = by.error / (by.rtol * std::max(total, Scalar(1e-20)));
    const Scalar wanted = pow(Scalar(gain * needed / Scalar(by.aim)), Scalar(1) / Scalar(by.order));
    const int least = even ? L + 1 : std::max(3, L / by.most_shrinking), most = by.most_growth * L;
    int intervals = wanted < Scalar(most) ? static_cast<int>(static_cast<double>(wanted)) + 1 : most;
    intervals = std::clamp(intervals, least, most);
    if (by.doubled && apart.empty()) intervals = std::max(intervals, 2 * L);
    auto mesh = equidistributed(t, density, intervals, by.fixed);
    const Scalar parts = std::min(Scalar(2 * by.error / by.rtol), Scalar(by.most_parts));
    for (const int i : apart)
        mesh = subdivided(mesh, t[i], t[i + 1], std::max(2, static_cast<int>(static_cast<double>(parts))),
                          by.fixed);
    return mesh;
}

}  // namespace stagecraft::detail
