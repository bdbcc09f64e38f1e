// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "stagecraft/theory/dynamics/rk_map.hpp"
#include "stagecraft/theory/stability/algebraic_stability.hpp"

namespace stagecraft::theory {

/// Values z_i with Re z_i <= 0 at which a method expands: |K(Z)| > 1, K(Z) = 1 + b^T Z (I - A Z)^-1 1, Z = diag(z_i). For
/// distinct nodes they are values h lambda(t_0 + c_i h) of one function with Re lambda <= 0: the linear problem
/// x' = lambda(t) x is contractive and one step of the method moves solutions apart.
template <class K>
struct expansion {
    std::vector<rational> real, imaginary;
    K squared_factor;  ///< |K(Z)|^2 > 1, exactly
    tableau<double> method;

    double factor() const { return std::sqrt(detail_value(squared_factor)); }

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

  private:
    static double detail_value(const K& x) {
        if constexpr (requires { x.template to<double>(); }) {
            return x.template to<double>();
        } else {
            return tableaux::to_range(x).middle().template to<double>();
        }
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

/// Where a method with distinct nodes is not algebraically stable: an exact Z at which it expands (the converse of
/// Crouzeix's theorem; Hairer-Wanner II, section IV.12, proof of Theorem 12.13); nothing where it is. Large real z_i at one node are tried
/// first; else with v^T M v < 0 |K|^2 = 1 - eps^2 v^T M v + O(eps^3) at Z = i eps diag(v), and with b_k < 0
/// K = 1 - eps b_k + O(eps^2) at z_k = -eps. Throws std::invalid_argument where nodes coincide.
template <class K>
std::optional<expansion<K>> expansion_witness(const tableau<K>& t) {
    require_shape(t);
    if (algebraically_stable(t).is_proved()) return {};
    const auto s = t.b.size();
    for (Eigen::Index i = 0; i < s; ++i)
        for (Eigen::Index j = 0; j < i; ++j)
            if (t.c[i] == t.c[j])
                throw std::invalid_argument("method: its nodes must be distinct, c[" + std::to_string(j + 1) +
                                            "] = c[" + std::to_string(i + 1) + "]");
    const std::vector<rational> zero(static_cast<std::size_t>(s), rational(0));
    std::optional<expansion<K>> found;
    const auto expands = [&](const std::vector<rational>& re, const std::vector<rational>& im) {
        const auto k = squared_amplification(t, re, im);
        if (k && K(1) < *k) found = expansion<K>{re, im, *k, in_doubles(t)};
        return found.has_value();
    };
    for (const int size : {6, 20, 2, 100}) {
        for (std::size_t i = 0; i < zero.size(); ++i) {
            auto re = zero;
            re[i] = -size;
            if (expands(re, zero)) return found;
        }
    }
    for (std::size_t i = 0; i < zero.size(); ++i) {
        if (!(t.b[static_cast<Eigen::Index>(i)] < K(0))) continue;
        auto re = zero;
        for (re[i] = -1;; re[i] = re[i] / 2)
            if (expands(re, zero)) return found;
    }
    const auto v = tableaux::diagonalise<K>(stability_matrix(t)).negative_direction();
    double largest = 0;
    std::vector<double> near;
    for (Eigen::Index i = 0; i < s; ++i) {
        if constexpr (requires { (*v)[i].template to<double>(); }) {
            near.push_back((*v)[i].template to<double>());
        } else {
            near.push_back(tableaux::to_range((*v)[i]).middle().template to<double>());
        }
        largest = std::max(largest, std::abs(near.back()));
    }
    auto im = zero;
    for (double scale = 1; scale > 1e-9; scale /= 2) {
        for (std::size_t i = 0; i < im.size(); ++i) im[i] = exactly(scale * near[i] / largest);
        if (expands(zero, im)) return found;
    }
    throw std::logic_error("expansion_witness: none found down to 1e-9");
}

}  // namespace stagecraft::theory
