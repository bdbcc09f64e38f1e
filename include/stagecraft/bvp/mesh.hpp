// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <type_traits>
#include <vector>

#include <stagecraft/bvp/options.hpp>
#include <stagecraft/tableau/order_conditions.hpp>

namespace stagecraft::detail {

/// The first mesh: options.mesh, or equal intervals with options.fixed_points among its points.
template <class Scalar>
std::vector<Scalar> first_mesh(const bvp_options<Scalar>& o, const Scalar& a, const Scalar& b) {
    std::vector<Scalar> t = o.mesh;
    if (t.empty()) {
        for (int i = 0; i < o.intervals; ++i) t.push_back(a + (b - a) * Scalar(i) / Scalar(o.intervals));
        t.push_back(b);
    }
    for (const Scalar& point : o.fixed_points) {
        const auto at = std::lower_bound(t.begin(), t.end(), point);
        if (*at != point) t.insert(at, point);
    }
    demand_bvp(std::adjacent_find(t.begin(), t.end(), std::greater_equal<Scalar>()) == t.end(),
               "b - a must be so large that the mesh points differ");
    return t;
}

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

/// No density more than `ratio` below that of its neighbours, so that the mesh does not jump.
template <class Scalar>
void smooth(const std::vector<Scalar>& t, std::vector<Scalar>& part, const Scalar& ratio) {
    const std::size_t L = part.size();
    const auto density = [&](std::size_t i) { return Scalar(part[i] / (t[i + 1] - t[i])); };
    for (std::size_t i = 1; i < L; ++i) {
        const Scalar least = density(i - 1) / ratio;
        if (density(i) < least) part[i] = least * (t[i + 1] - t[i]);
    }
    for (std::size_t i = L - 1; i-- > 0;) {
        const Scalar least = density(i + 1) / ratio;
        if (density(i) < least) part[i] = least * (t[i + 1] - t[i]);
    }
}

/// A mesh of about `intervals` intervals, each with the same share of the sum of `part` (one number per
/// interval of t); the points between `fixed` are placed for themselves.
template <class Scalar>
std::vector<Scalar> equidistributed(const std::vector<Scalar>& t, const std::vector<Scalar>& part,
                                    int intervals, const std::vector<Scalar>& fixed) {
    std::vector<Scalar> sum{Scalar(0)};
    for (const Scalar& p : part) sum.push_back(sum.back() + p);
    std::vector<std::size_t> ends{0};
    for (const Scalar& point : fixed)
        ends.push_back(static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), point) - t.begin()));
    ends.push_back(part.size());
    std::vector<Scalar> mesh;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        const Scalar begin = sum[ends[k]], share = sum[ends[k + 1]] - begin;
        using std::ceil;
        const double wanted = static_cast<double>(Scalar(share / sum.back())) * intervals;
        const int count = std::max(1, static_cast<int>(std::ceil(wanted - 1e-9)));
        std::size_t i = ends[k];
        mesh.push_back(t[i]);
        for (int j = 1; j < count; ++j) {
            const Scalar level = begin + share * Scalar(j) / Scalar(count);
            while (i + 1 < ends[k + 1] && sum[i + 1] < level) ++i;
            const Scalar next = t[i] + (t[i + 1] - t[i]) * ((level - sum[i]) / part[i]);
            if (next > mesh.back() && next < t[ends[k + 1]]) mesh.push_back(next);
        }
    }
    mesh.push_back(t.back());
    return mesh;
}

/// Throws unless the method is collocation with distinct nodes: C(s) and B(s). Its order at mesh points.
template <class Scalar, int S>
int collocation_order(const tableau<Scalar, S>& m) {
    const int s = m.stages();
    demand_bvp(s > 0 && m.A.rows() == s && m.A.cols() == s && m.c.size() == s,
               "method must be a tableau with s x s numbers in A and s in b and c");
    bool distinct = true;
    for (int i = 0; i < s; ++i)
        for (int j = 0; j < i; ++j) distinct = distinct && !(m.c[i] == m.c[j]);
    demand_bvp(distinct && stage_conditions(m, s) >= s && quadrature_conditions(m, s) >= s,
               "method must be a collocation tableau with distinct nodes: C(s) and B(s)");
    return quadrature_conditions(m, 2 * s);
}

/// A guess as value and slope at t: a constant vector, a function of t, or one with derivative(t).
template <class Guess>
concept constant_guess = requires {
    typename Guess::PlainObject;
};

template <class Scalar, class Guess>
auto guess_value(const Guess& guess, const Scalar& t) {
    if constexpr (constant_guess<Guess>)
        return typename Guess::PlainObject(guess);
    else
        return typename std::decay_t<decltype(guess(t))>::PlainObject(guess(t));
}
template <class Scalar, class Guess>
auto guess_slope(const Guess& guess, const Scalar& t, const Scalar& h) {
    using vector = decltype(guess_value(guess, t));
    if constexpr (constant_guess<Guess>) {
        return vector(vector::Zero(guess.size()));
    } else if constexpr (requires { guess.derivative(t); }) {
        return vector(guess.derivative(t));
    } else {
        const Scalar step = h / 64;
        return vector((guess_value(guess, Scalar(t + step)) - guess_value(guess, Scalar(t - step))) /
                      (2 * step));
    }
}

}  // namespace stagecraft::detail
