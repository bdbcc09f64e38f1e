// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "stagecraft/theory/dynamics/tableau_numbers.hpp"
#include "stagecraft/theory/stability/algebraic_stability.hpp"

namespace stagecraft::theory {

using tableaux::rational;

/// Values z_i with Re z_i <= 0 at which a method expands: |K(Z)| > 1, K(Z) = 1 + b^T Z (I - A Z)^-1 1, Z = diag(z_i),
/// z_i = z_j where c_i = c_j. They are values h lambda(t_0 + c_i h) of one function with Re lambda <= 0: the linear
/// problem x' = lambda(t) x is contractive and one step of the method moves solutions apart.
template <class K>
struct expansion {
    std::vector<rational> real, imaginary;
    K squared_factor;  ///< |K(Z)|^2 > 1, exactly
    tableau<double> method;

    double factor() const { return std::sqrt(near_double(squared_factor)); }

    /// The problem for step size h from t = 0, in the plane: x' = (Re lambda + Im lambda J) x with lambda h through the
    /// z_i at the nodes, linear between them and constant outside.
    template <class T, class X, class Y>
    void field(const T& t, const X& x, Y& f, double h) const {
        const auto at = [&](const std::vector<rational>& z) {
            std::vector<std::pair<double, double>> points;
            for (std::size_t i = 0; i < z.size(); ++i)
                points.emplace_back(method.c[static_cast<Eigen::Index>(i)] * h,
                                    z[i].template to<double>() / h);
            std::sort(points.begin(), points.end());
            if (!(t > points.front().first)) return points.front().second;
            for (std::size_t i = 1; i < points.size(); ++i) {
                const auto [u, p] = points[i - 1];
                const auto [v, q] = points[i];
                if (t <= v) return p + (q - p) * ((t - u) / (v - u));
            }
            return points.back().second;
        };
        const double a = at(real), b = at(imaginary);
        f[0] = a * x[0] - b * x[1];
        f[1] = b * x[0] + a * x[1];
    }
};

/// |K(Z)|^2, exactly; nothing where I - A Z is singular. One real system of size 2s.
template <class K>
std::optional<K> squared_amplification(const tableau<K>& t, const std::vector<rational>& real,
                                       const std::vector<rational>& imaginary) {
    const auto s = t.b.size();
    const auto re = [&](Eigen::Index i) { return K(real[static_cast<std::size_t>(i)]); };
    const auto im = [&](Eigen::Index i) { return K(imaginary[static_cast<std::size_t>(i)]); };
    tableaux::dense<K> M(2 * s, 2 * s), right(2 * s, 1);
    for (Eigen::Index i = 0; i < s; ++i) {
        right(i, 0) = K(1);
        right(s + i, 0) = K(0);
        for (Eigen::Index j = 0; j < s; ++j) {
            const K unit(i == j ? 1 : 0);
            M(i, j) = M(s + i, s + j) = unit - t.A(i, j) * re(j);
            M(i, s + j) = t.A(i, j) * im(j);
            M(s + i, j) = K(0) - t.A(i, j) * im(j);
        }
    }
    const auto x = tableaux::solve<K>(M, right);
    if (!x) return {};
    K u(1), v(0);
    for (Eigen::Index i = 0; i < s; ++i) {
        u = u + t.b[i] * (re(i) * (*x)(i, 0) - im(i) * (*x)(s + i, 0));
        v = v + t.b[i] * (re(i) * (*x)(s + i, 0) + im(i) * (*x)(i, 0));
    }
    return u * u + v * v;
}

namespace detail {

/// The stages in groups of equal nodes.
template <class K>
std::vector<std::vector<std::size_t>> stages_by_node(const tableau<K>& t) {
    std::vector<std::vector<std::size_t>> groups;
    for (Eigen::Index i = 0; i < t.c.size(); ++i) {
        auto g = std::find_if(groups.begin(), groups.end(), [&](const auto& stages) {
            return t.c[static_cast<Eigen::Index>(stages.front())] == t.c[i];
        });
        if (g == groups.end()) g = groups.insert(g, std::vector<std::size_t>{});
        g->push_back(static_cast<std::size_t>(i));
    }
    return groups;
}

/// A direction v, constant on equal nodes, with v^T M v < 0, scaled to max |v_i| = 1 and rounded to 1/64ths where it
/// is as good; nothing where there is none.
template <class K>
std::optional<std::vector<rational>> negative_direction(const tableau<K>& t,
                                                        const std::vector<std::vector<std::size_t>>& groups) {
    const auto M = stability_matrix(t);
    const auto n = static_cast<Eigen::Index>(groups.size());
    tableaux::dense<K> sums = tableaux::dense<K>::Constant(n, n, K(0));
    for (Eigen::Index p = 0; p < n; ++p)
        for (Eigen::Index q = 0; q < n; ++q)
            for (const auto i : groups[static_cast<std::size_t>(p)])
                for (const auto j : groups[static_cast<std::size_t>(q)])
                    sums(p, q) = sums(p, q) + M(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    const auto v = tableaux::diagonalise<K>(sums).negative_direction();
    if (!v) return {};
    double largest = 0;
    for (Eigen::Index p = 0; p < n; ++p) largest = std::max(largest, std::abs(near_double((*v)[p])));
    for (const double grid : {64.0, 0x1p20, 0x1p50}) {
        std::vector<rational> rounded;
        for (Eigen::Index p = 0; p < n; ++p)
            rounded.push_back(theory::exactly(std::round(near_double((*v)[p]) / largest * grid) / grid));
        K value(0);
        for (Eigen::Index p = 0; p < n; ++p)
            for (Eigen::Index q = 0; q < n; ++q)
                value = value + K(rounded[static_cast<std::size_t>(p)]) * sums(p, q) *
                                    K(rounded[static_cast<std::size_t>(q)]);
        if (value < K(0)) return rounded;
    }
    return {};
}

}  // namespace detail

/// Where a method is not algebraically stable: an exact Z at which it expands. For distinct nodes there is one always
/// (the converse of Crouzeix's theorem; Hairer-Wanner II, section IV.12, proof of Theorem 12.13). Where nodes coincide
/// Z is sought among those that are constant on equal nodes; there need not be one, and nothing returned says nothing
/// then (autonomous_witness.hpp goes on). Large real z at one node are tried first, then equal z everywhere; else with
/// v^T M v < 0 |K|^2 = 1 - eps^2 v^T M v + O(eps^3) at Z = i eps diag(v), and with weights b_k < 0 at one node
/// K = 1 - eps b_k + O(eps^2) at z = -eps there. Nothing for an algebraically stable method.
template <class K>
std::optional<expansion<K>> expansion_witness(const tableau<K>& t) {
    tableaux::require_shape(t);
    if (algebraically_stable(t).is_proved()) return {};
    const auto groups = detail::stages_by_node(t);
    const std::vector<rational> zero(static_cast<std::size_t>(t.b.size()), rational(0));
    std::optional<expansion<K>> found;
    const auto expands = [&](const std::vector<rational>& re, const std::vector<rational>& im) {
        const auto k = squared_amplification(t, re, im);
        if (k && K(1) < *k) found = expansion<K>{re, im, *k, in_doubles(t)};
        return found.has_value();
    };
    const std::vector<rational> large{-6, -20, -2, -100};
    for (const rational& z : large) {
        for (const auto& g : groups) {
            auto re = zero;
            for (const auto i : g) re[i] = z;
            if (expands(re, zero)) return found;
        }
    }
    for (const rational& z : large)
        if (expands(std::vector<rational>(zero.size(), z), zero)) return found;
    for (const auto& g : groups) {
        K weight(0);
        for (const auto i : g) weight = weight + t.b[static_cast<Eigen::Index>(i)];
        if (!(weight < K(0))) continue;
        auto re = zero;
        for (rational z = -1;; z = z / 2) {
            for (const auto i : g) re[i] = z;
            if (expands(re, zero)) return found;
        }
    }
    const auto v = detail::negative_direction(t, groups);
    if (!v) return {};
    for (int halvings = 0; halvings < 60; ++halvings) {
        auto im = zero;
        for (std::size_t g = 0; g < groups.size(); ++g)
            for (const auto i : groups[g]) im[i] = tableaux::scaled((*v)[g], -halvings);
        if (expands(zero, im)) return found;
    }
    throw std::logic_error("expansion_witness: none found down to 2^-60");
}

}  // namespace stagecraft::theory
