// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <stagecraft/tableaux/correct_rounding.hpp>
#include <stagecraft/tableaux/polynomial.hpp>
#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/tableaux/routh_hurwitz.hpp>
#include <stagecraft/tableaux/small_solve.hpp>
#include <stagecraft/theory/export/coq_text.hpp>
#include <string>
#include <vector>

/// Sums of squares, which show Coq that something is not negative.
namespace stagecraft::theory::coq {

using scalar = tableaux::quadratic;
using form = tableaux::dense<scalar>;

/// D L L^T, with D > 0.
struct square {
    scalar weight;
    std::vector<scalar> vector;
};

/// g as a sum of squares; nothing where g has a negative direction. O(n^3) operations.
inline std::optional<std::vector<square>> squares(form g) {
    std::vector<square> items;
    for (int k = 0; k < g.rows(); ++k) {
        const scalar d = g(k, k);
        if (tableaux::sign_of(d) < 0) return {};
        if (d == 0) {
            for (int i = 0; i < g.rows(); ++i)
                if (!(g(i, k) == 0)) return {};
            continue;
        }
        std::vector<scalar> l;
        for (int i = 0; i < g.rows(); ++i) l.push_back(g(i, k) / d);
        for (int i = 0; i < g.rows(); ++i)
            for (int j = 0; j < g.rows(); ++j)
                g(i, j) -= d * l[static_cast<std::size_t>(i)] * l[static_cast<std::size_t>(j)];
        items.push_back({d, std::move(l)});
    }
    return items;
}

inline std::string text(const std::vector<square>& items) {
    std::string out;
    for (const auto& x : items)
        out += (out.empty() ? "  [ " : ";\n    ") + ("(" + pair(x.weight)) + "%Q, " +
               coefficients(x.vector, "     ") + ")";
    return out.empty() ? "  []" : out + " ]";
}

inline double approximately(const scalar& x) {
    const auto number = [](const tableaux::rational& q) {
        return q == 0 ? 0.0 : std::stod(tableaux::decimal_text(q, 17));
    };
    double sum = number(x.rational_part());
    for (const auto& s : x.surds()) sum += number(s.factor) * std::sqrt(static_cast<double>(s.radicand));
    return sum;
}

/// An s with |s(iy)|^2 = f(y^2), rounded to so many bits, where f(t) > 0 for t >= 0: Wilson 1969,
/// Newton's method for s(z) s(-z) = f(-z^2) from a polynomial with all roots on the left.
inline std::vector<scalar> spectral_factor(const std::vector<double>& f, int bits) {
    const int n = static_cast<int>(f.size()) - 1;
    const auto at = [](int k) { return static_cast<std::size_t>(k); };
    std::vector<double> s{std::sqrt(f.back())};
    const double radius = std::pow(f.front() / f.back(), 0.5 / std::max(n, 1));
    for (int k = 0; k < n; ++k) {  // times z + radius
        s.insert(s.begin(), 0);
        for (int i = 0; i <= k; ++i) s[at(i)] += radius * s[at(i + 1)];
    }
    for (int iteration = 0; iteration < 60; ++iteration) {
        Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n + 1, n + 1);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 1);
        for (int k = 0; k <= n; ++k) {
            right[k] = (k % 2 == 0 ? 1 : -1) * f[at(k)];
            for (int j = std::max(0, 2 * k - n); j <= std::min(n, 2 * k); ++j) {
                const double sign = j % 2 == 0 ? 1 : -1;
                m(k, j) = 2 * sign * s[at(2 * k - j)];
                right[k] += sign * s[at(j)] * s[at(2 * k - j)];
            }
        }
        const Eigen::VectorXd next = m.fullPivLu().solve(right);
        for (int j = 0; j <= n; ++j) s[at(j)] = next[j];
    }
    std::vector<scalar> rounded;
    for (const double x : s) {
        int exponent = 0;
        const auto digits = std::isfinite(x) ? std::llround(std::ldexp(std::frexp(x, &exponent), bits)) : 0;
        tableaux::rational q(static_cast<long long>(digits));
        for (int k = exponent - bits; k < 0; ++k) q /= tableaux::rational(2);
        for (int k = exponent - bits; k > 0; --k) q *= tableaux::rational(2);
        rounded.emplace_back(q);
    }
    return rounded;
}

/// Polynomials h with f(y^2) = sum of D |h(iy)|^2, where f(t) > 0 for t >= 0: powers of z where no coefficient is
/// negative; else an approximate spectral factor of a little less than f, and for the rest powers of z again.
inline std::optional<std::vector<square>> squares_of_positive(const tableaux::polynomial<scalar>& f) {
    const int n = f.degree();
    const auto with_powers = [n](const tableaux::polynomial<scalar>& rest,
                                 std::vector<square> all) -> std::optional<std::vector<square>> {
        for (int k = 0; k <= n; ++k) {
            if (tableaux::sign_of(scalar(rest[k])) < 0) return {};
            if (rest[k] == 0) continue;
            std::vector<scalar> power(static_cast<std::size_t>(k) + 1);
            power.back() = scalar(1);
            all.push_back({rest[k], std::move(power)});
        }
        return all;
    };
    if (auto found = with_powers(f, {})) return found;
    std::vector<double> coefficients;
    for (int k = 0; k <= n; ++k) coefficients.push_back(approximately(f[k]));
    for (const int bits : {4, 8, 12, 18, 24}) {
        const double less = std::ldexp(1.0, -bits);
        auto lower = coefficients;
        for (int k = 0; k <= n; ++k)
            lower[static_cast<std::size_t>(k)] -= less * std::pow(coefficients.front(), 1 - double(k) / n) *
                                                  std::pow(coefficients.back(), double(k) / n);
        const auto s = spectral_factor(lower, bits + 12);
        const auto axis = tableaux::on_imaginary_axis(tableaux::polynomial<scalar>(s));
        const auto squared = axis.real * axis.real + axis.imaginary * axis.imaginary;
        tableaux::polynomial<scalar> rest = f;
        for (int k = 0; k <= n; ++k) {
            std::vector<scalar> term(static_cast<std::size_t>(k) + 1);
            term.back() = scalar(squared[2 * k]);
            rest = rest - tableaux::polynomial<scalar>(std::move(term));
        }
        if (auto found = with_powers(rest, {{scalar(1), s}})) return found;
    }
    return {};
}

/// The same where f(t) >= 0 for t >= 0: roots that do not change the sign are taken off, and put into the h.
inline std::optional<std::vector<square>> squares_on_axis(const tableaux::polynomial<scalar>& f) {
    using poly = tableaux::polynomial<scalar>;
    if (f.is_zero()) return std::vector<square>{};
    const poly minus_z_squared{scalar(0), scalar(0), scalar(-1)};
    poly odd(f.leading()), outside(scalar(1));
    for (const auto& [factor, multiplicity] : tableaux::squarefree_split(f)) {
        poly at(scalar(0));
        for (int k = factor.degree(); k >= 0; --k) at = at * minus_z_squared + poly(scalar(factor[k]));
        for (int k = 0; k < multiplicity / 2; ++k) outside *= at;
        if (multiplicity % 2 != 0) odd *= factor;
    }
    if (odd[0] == 0) {  // t = |z|^2
        odd = odd / poly{scalar(0), scalar(1)};
        outside *= poly{scalar(0), scalar(1)};
    }
    auto found = squares_of_positive(odd);
    if (!found) return {};
    for (auto& [weight, h] : *found) {
        const poly product = poly(h) * outside;
        h.clear();
        for (int k = 0; k <= product.degree(); ++k) h.push_back(product[k]);
    }
    return found;
}

/// g(z, z') as sums of squares, on the imaginary axis and off it: g = sum of D |h(z)|^2 + u sum of D |k(z)|^2 at z = -u + iy.
/// (The form of the k is the one of the Lyapunov equation: it is not negative where poles are on the right.)
struct half_plane_squares {
    std::vector<square> on_axis, inside;
};
inline std::optional<half_plane_squares> squares_on_half_plane(form g) {
    const auto n = static_cast<int>(g.rows());
    std::vector<scalar> e;  // of t = y^2
    for (int m = 0; m < n; ++m) {
        e.emplace_back(0);
        for (int i = std::max(0, 2 * m - n + 1); i <= std::min(n - 1, 2 * m); ++i)
            e.back() += (i - m) % 2 == 0 ? g(i, 2 * m - i) : scalar(-g(i, 2 * m - i));
    }
    const auto on_axis = squares_on_axis(tableaux::polynomial<scalar>(e));
    if (!on_axis) return {};
    for (const auto& [weight, h] : *on_axis)
        for (std::size_t i = 0; i < h.size(); ++i)
            for (std::size_t j = 0; j < h.size(); ++j)
                g(static_cast<int>(i), static_cast<int>(j)) -= weight * h[i] * h[j];
    form k = form::Constant(n - 1, n - 1, scalar(0));
    for (int i = 0; i < n - 1; ++i)
        for (int j = 0; j < n - 1; ++j)
            k(i, j) = scalar(-2) * g(i, j + 1) - (i > 0 && j + 1 < n - 1 ? k(i - 1, j + 1) : scalar(0));
    const auto inside = squares(k);
    if (!inside) return {};
    return {{*on_axis, *inside}};
}

}  // namespace stagecraft::theory::coq
