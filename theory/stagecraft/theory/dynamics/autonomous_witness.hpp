// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/simplifying.hpp"
#include "stagecraft/tableaux/small_solve.hpp"
#include "stagecraft/theory/dynamics/tableau_numbers.hpp"

namespace stagecraft::theory {

using tableaux::rational;

/// A scalar autonomous problem x' = f(x), f decreasing, piecewise linear with f(0) = 0, on which one step of size 1
/// takes 1 to `end`, |end| > 1, while 0 stays: f is contractive and the method is not. Exact.
template <class K>
struct autonomous_expansion {
    std::vector<std::pair<K, K>> points;  ///< (x, f(x)), x increasing, f not; 0 is among them
    K end;

    /// f(x), in doubles: linear between the points, constant outside.
    double operator()(double x) const {
        const auto at = [&](std::size_t i) {
            return std::pair{near_double(points[i].first), near_double(points[i].second)};
        };
        if (!(x > at(0).first)) return at(0).second;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const auto [u, p] = at(i - 1);
            const auto [v, q] = at(i);
            if (x <= v) return p + (q - p) * ((x - u) / (v - u));
        }
        return at(points.size() - 1).second;
    }
};

namespace detail {

/// The points (X_i, z_i X_i) of the stages from x = 1 and (0, 0), where they lie on a decreasing function and the step
/// ends outside of [-1, 1].
template <class K>
std::optional<autonomous_expansion<K>> decreasing_data(const tableau<K>& t, const std::vector<rational>& z) {
    const auto s = t.b.size();
    tableaux::dense<K> M(s, s), one(s, 1);
    for (Eigen::Index i = 0; i < s; ++i) {
        one(i, 0) = K(1);
        for (Eigen::Index j = 0; j < s; ++j)
            M(i, j) = K(i == j ? 1 : 0) - t.A(i, j) * K(z[static_cast<std::size_t>(j)]);
    }
    const auto X = tableaux::solve<K>(M, one);
    if (!X) return {};
    autonomous_expansion<K> found{{{K(0), K(0)}}, K(1)};
    for (Eigen::Index i = 0; i < s; ++i) {
        const K slope = K(z[static_cast<std::size_t>(i)]) * (*X)(i, 0);
        found.end = found.end + t.b[i] * slope;
        found.points.emplace_back((*X)(i, 0), slope);
    }
    if (!(K(1) < found.end * found.end)) return {};
    std::sort(found.points.begin(), found.points.end(), [](const auto& p, const auto& q) {
        return p.first < q.first || (p.first == q.first && q.second < p.second);
    });
    for (std::size_t i = 1; i < found.points.size(); ++i) {
        const auto& [x, f] = found.points[i - 1];
        const auto& [y, g] = found.points[i];
        if (f < g || (x == y && !(f == g))) return {};
    }
    found.points.erase(std::unique(found.points.begin(), found.points.end()), found.points.end());
    return found;
}

}  // namespace detail

/// A scalar autonomous problem that refutes B-stability, looked for among linear ones and `tries` random values
/// z_i = f(X_i)/X_i of the stages: what is found is exact, nothing found says nothing. For methods whose nodes coincide, where no
/// non-autonomous linear problem can have different values at equal times (expansion_witness.hpp).
template <class K>
std::optional<autonomous_expansion<K>> autonomous_witness(const tableau<K>& t, int tries = 2000) {
    tableaux::require_shape(t);
    const std::array<rational, 10> values{0,   rational(-1, 4), rational(-1, 2), -1, -2, -4, -8, -20, -50,
                                          -200};
    std::mt19937 random(1);
    for (std::size_t k = 0; k < values.size() + static_cast<std::size_t>(tries); ++k) {
        std::vector<rational> z;  // first f(x) = z x
        for (Eigen::Index i = 0; i < t.b.size(); ++i)
            z.push_back(values[k < values.size() ? k : random() % values.size()]);
        if (auto found = detail::decreasing_data(t, z)) return found;
    }
    return {};
}

}  // namespace stagecraft::theory
