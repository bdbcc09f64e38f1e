// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace stagecraft::detail {

/// Every interval halved.
template <class Scalar>
std::vector<Scalar> halved(const std::vector<Scalar>& t) {
    std::vector<Scalar> fine;
    for (std::size_t i = 0; i + 1 < t.size(); ++i) {
        fine.push_back(t[i]);
        fine.push_back((t[i] + t[i + 1]) / 2);
    }
    fine.push_back(t.back());
    return fine;
}

/// A density of mesh points, linear between those of a mesh t: that of `part` (one number per interval), no part being
/// more than `ratio` times as dense as the next, averaged over neighbours. Symmetric methods with R(inf) = -1
/// add the local errors of stiff components up with alternating signs, so that these cancel where the steps change
/// smoothly and do not where they jump.
template <class Scalar>
std::vector<Scalar> mesh_density(const std::vector<Scalar>& t, const std::vector<Scalar>& part,
                                 const Scalar& ratio) {
    const std::size_t L = part.size();
    std::vector<Scalar> of(L), at(L + 1);
    for (std::size_t i = 0; i < L; ++i) of[i] = part[i] / (t[i + 1] - t[i]);
    for (std::size_t i = 1; i < L; ++i) of[i] = std::max(of[i], Scalar(of[i - 1] / ratio));
    for (std::size_t i = L - 1; i-- > 0;) of[i] = std::max(of[i], Scalar(of[i + 1] / ratio));
    at[0] = of[0], at[L] = of[L - 1];
    for (std::size_t i = 1; i < L;
         ++i) {  // by the inverse steps: large steps count for little beside small ones
        const Scalar left = t[i] - t[i - 1], right = t[i + 1] - t[i];
        at[i] = (of[i - 1] * right + of[i] * left) / (left + right);
    }
    return at;
}

/// A mesh of about `intervals` intervals, each with the same share of the integral of `density` (linear between its values
/// at the points of t); the points between `fixed` are placed for themselves.
template <class Scalar>
std::vector<Scalar> equidistributed(const std::vector<Scalar>& t, const std::vector<Scalar>& density,
                                    int intervals, const std::vector<Scalar>& fixed) {
    using std::ceil;
    using std::sqrt;
    std::vector<Scalar> sum{Scalar(0)};
    sum.reserve(t.size());
    for (std::size_t i = 0; i + 1 < t.size(); ++i)
        sum.push_back(sum.back() + (t[i + 1] - t[i]) * (density[i] + density[i + 1]) / 2);
    std::vector<std::size_t> ends{0};
    for (const Scalar& point : fixed)
        ends.push_back(static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), point) - t.begin()));
    ends.push_back(t.size() - 1);
    std::vector<Scalar> mesh;
    mesh.reserve(static_cast<std::size_t>(intervals) + ends.size() + 1);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        const Scalar begin = sum[ends[k]], share = sum[ends[k + 1]] - begin;
        const double wanted = static_cast<double>(Scalar(share / sum.back())) * intervals;
        const int count = std::max(1, static_cast<int>(std::ceil(wanted - 1e-9)));
        std::size_t i = ends[k];
        mesh.push_back(t[i]);
        for (int j = 1; j < count; ++j) {
            const Scalar level = begin + share * Scalar(j) / Scalar(count);
            while (i + 1 < ends[k + 1] && sum[i + 1] < level) ++i;
            // d x + (e - d) x^2 / 2 = c for the part x of the interval, d and e being the densities at its ends
            const Scalar h = t[i + 1] - t[i], c = (level - sum[i]) / h, d = density[i],
                         e = density[i + 1] - d;
            const Scalar root = sqrt(std::max(Scalar(d * d + 2 * e * c), Scalar(0)));
            const Scalar next = t[i] + h * std::min(Scalar(2 * c / (d + root)), Scalar(1));
            if (next > mesh.back() && next < t[ends[k + 1]]) mesh.push_back(next);
        }
    }
    mesh.push_back(t.back());
    return mesh;
}

/// t with points added that approach `place` geometrically from both sides until a step is no longer than `finest`:
/// whatever layer is there is then seen.
template <class Scalar>
std::vector<Scalar> graded(const std::vector<Scalar>& t, Scalar place, const Scalar& finest) {
    std::vector<Scalar> mesh = t;
    for (const Scalar& point : t)
        if (point - place <= finest / 2 && place - point <= finest / 2) place = point;
    if (!std::binary_search(t.begin(), t.end(), place)) mesh.push_back(place);
    const auto after = std::upper_bound(t.begin(), t.end(), place);
    const auto before = std::lower_bound(t.begin(), t.end(), place);
    if (before != t.begin())
        for (Scalar h = (place - *(before - 1)) / 3; 3 * h > finest && place - h < place; h /= 3)
            mesh.push_back(place - h);
    if (after != t.end())
        for (Scalar h = (*after - place) / 3; 3 * h > finest && place + h > place; h /= 3)
            mesh.push_back(place + h);
    std::sort(mesh.begin(), mesh.end());
    return mesh;
}

/// t with [a, b] in `count` equal intervals; points nearer to it than half of one go, but for the ends and those of `fixed`.
template <class Scalar>
std::vector<Scalar> subdivided(const std::vector<Scalar>& t, const Scalar& a, const Scalar& b, int count,
                               const std::vector<Scalar>& fixed) {
    const Scalar step = (b - a) / Scalar(count), begin = a - step / 2, end = b + step / 2;
    std::vector<Scalar> mesh;
    for (const Scalar& point : t)
        if (point < begin || point > end || point == t.front() || point == t.back() ||
            std::binary_search(fixed.begin(), fixed.end(), point))
            mesh.push_back(point);
    for (int k = 0; k <= count; ++k) mesh.push_back(k < count ? Scalar(a + step * Scalar(k)) : b);
    std::sort(mesh.begin(), mesh.end());
    mesh.erase(std::unique(mesh.begin(), mesh.end()), mesh.end());
    return mesh;
}

}  // namespace stagecraft::detail
