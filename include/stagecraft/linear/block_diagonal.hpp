// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <utility>
#include <vector>

namespace stagecraft {

/// A real matrix as T D T^-1 with D = diag(real_1, ..., [alpha beta; -beta alpha], ...) for its real
/// eigenvalues and its pairs alpha +- i beta; column-major.
struct block_diagonal_form {
    std::vector<double> T, T_inverse, real;
    std::vector<std::complex<double>> pairs;  ///< those with beta > 0
};

namespace detail {

/// Solves A X = B with row pivoting for `columns` right-hand sides, in place; all column-major. A pivot of
/// zero becomes `least`, so that inverse iteration can be done at an eigenvalue.
template <class T>
void eliminate(std::vector<T> a, std::vector<T>& b, int n, int columns, double least) {
    for (int k = 0; k < n; ++k) {
        int p = k;
        for (int i = k + 1; i < n; ++i)
            if (std::abs(a[i + k * n]) > std::abs(a[p + k * n])) p = i;
        for (int j = 0; j < n; ++j) std::swap(a[k + j * n], a[p + j * n]);
        for (int j = 0; j < columns; ++j) std::swap(b[k + j * n], b[p + j * n]);
        if (std::abs(a[k + k * n]) < least) a[k + k * n] = least;
        for (int i = k + 1; i < n; ++i) {
            const T f = a[i + k * n] / a[k + k * n];
            for (int j = k; j < n; ++j) a[i + j * n] -= f * a[k + j * n];
            for (int j = 0; j < columns; ++j) b[i + j * n] -= f * b[k + j * n];
        }
    }
    for (int j = 0; j < columns; ++j)
        for (int i = n - 1; i >= 0; --i) {
            for (int k = i + 1; k < n; ++k) b[i + j * n] -= a[i + k * n] * b[k + j * n];
            b[i + j * n] /= a[i + i * n];
        }
}

inline std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b, int n) {
    std::vector<double> c(a.size(), 0.0);
    for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k)
            for (int i = 0; i < n; ++i) c[i + j * n] += a[i + k * n] * b[k + j * n];
    return c;
}

/// Coefficients of det(x - A), ascending, by Faddeev and Leverrier.
inline std::vector<double> characteristic_polynomial(const std::vector<double>& a, int n) {
    std::vector<double> p(static_cast<std::size_t>(n) + 1, 0.0), m(a.size(), 0.0);
    p[n] = 1;
    for (int k = 1; k <= n; ++k) {
        m = product(a, m, n);
        for (int i = 0; i < n; ++i) m[i + i * n] += p[n - k + 1];
        const auto am = product(a, m, n);
        for (int i = 0; i < n; ++i) p[n - k] -= am[i + i * n] / k;
    }
    return p;
}

/// All roots of a polynomial with leading coefficient one, at once (Aberth and Ehrlich).
inline std::vector<std::complex<double>> all_roots(const std::vector<double>& p) {
    const int n = static_cast<int>(p.size()) - 1;
    std::vector<std::complex<double>> z;
    double radius = 0;  // Fujiwara's bound
    for (int k = 0; k < n; ++k) radius = std::max(radius, 2 * std::pow(std::abs(p[k]), 1.0 / (n - k)));
    for (int k = 0; k < n; ++k) z.push_back(std::polar(radius / 2, 0.4 + 6.283185307179586 * k / n));
    for (int iteration = 0; iteration < 200; ++iteration) {
        double change = 0;
        for (int k = 0; k < n; ++k) {
            std::complex<double> value = p[n], slope = 0, others = 0;
            for (int i = n - 1; i >= 0; --i) {
                slope = slope * z[k] + value;
                value = value * z[k] + p[i];
            }
            if (value == 0.0) continue;
            for (int j = 0; j < n; ++j)
                if (j != k) others += 1.0 / (z[k] - z[j]);
            const std::complex<double> step = 1.0 / (slope / value - others);
            z[k] -= step;
            change = std::max(change, std::abs(step));
        }
        if (change <= 1e-15 * radius) break;
    }
    return z;
}

/// The eigenvector of `a` for an eigenvalue near lambda, its largest entry 1, by inverse iteration; lambda becomes the
/// eigenvalue of that vector, real where `real` says so.
inline std::vector<std::complex<double>> eigenvector(const std::vector<double>& a, int n,
                                                     std::complex<double>& lambda, bool real) {
    using complex = std::complex<double>;
    std::vector<complex> v(static_cast<std::size_t>(n)), shifted(a.size());
    for (int i = 0; i < n; ++i) v[i] = std::cos(1.0 + 3.7 * i);  // no special direction
    for (int repeat = 0; repeat < 4; ++repeat) {
        for (std::size_t i = 0; i < a.size(); ++i) shifted[i] = a[i];
        for (int i = 0; i < n; ++i) shifted[i + i * n] -= lambda;
        auto w = v;
        eliminate(shifted, w, n, 1, 1e-16);
        int top = 0;
        for (int i = 1; i < n; ++i)
            if (std::abs(w[i]) > std::abs(w[top])) top = i;
        if (repeat > 0) lambda += v[top] / w[top];
        if (real) lambda = lambda.real();
        for (int i = 0; i < n; ++i) v[i] = w[i] / w[top];
    }
    return v;
}

}  // namespace detail

/// The form of an n x n matrix (column-major). Nothing if it is not found to 1e-8 of the largest entry, or if
/// T is nearly singular, which means multiple eigenvalues without as many eigenvectors, or n larger than
/// about 15. Meant for the small matrices of methods, where it preconditions an iteration: its accuracy
/// affects only the speed of that iteration.
inline std::optional<block_diagonal_form> block_diagonal(const std::vector<double>& a, int n) {
    using complex = std::complex<double>;
    double size = 0;
    for (const double x : a) size = std::max(size, std::abs(x));
    if (n == 0 || !(size > 0) || !std::isfinite(size)) return {};
    std::vector<double> scaled = a;
    for (double& x : scaled) x /= size;
    block_diagonal_form form;
    std::vector<double> columns;
    std::vector<complex> upper;
    for (const complex& z : detail::all_roots(detail::characteristic_polynomial(scaled, n))) {
        const bool real = std::abs(z.imag()) <= 1e-7;
        if (!real && z.imag() < 0) continue;
        complex lambda = real ? complex(z.real()) : z;
        const auto v = detail::eigenvector(scaled, n, lambda, real);
        if (real) {
            form.real.push_back(lambda.real() * size);
            for (int i = 0; i < n; ++i) columns.push_back(v[i].real());
        } else {
            form.pairs.push_back(lambda * size);
            upper.insert(upper.end(), v.begin(), v.end());
        }
    }
    for (std::size_t k = 0; k < form.pairs.size(); ++k)
        for (const int part : {0, 1})
            for (int i = 0; i < n; ++i) {
                const complex& x = upper[i + k * n];
                columns.push_back(part == 0 ? x.real() : x.imag());
            }
    if (columns.size() != a.size()) return {};
    form.T = std::move(columns);
    form.T_inverse.assign(a.size(), 0.0);
    for (int i = 0; i < n; ++i) form.T_inverse[i + i * n] = 1;
    detail::eliminate(form.T, form.T_inverse, n, n, 1e-300);
    for (const double x : form.T_inverse)  // columns of nearly the same direction; those of T have size one
        if (!(std::abs(x) <= 1e6)) return {};
    auto rest = detail::product(form.T_inverse, detail::product(a, form.T, n), n);
    const int real = static_cast<int>(form.real.size());
    for (int i = 0; i < real; ++i) rest[i + i * n] -= form.real[i];
    for (std::size_t k = 0; k < form.pairs.size(); ++k) {
        const int i = real + 2 * static_cast<int>(k), j = i + 1;
        rest[i + i * n] -= form.pairs[k].real();
        rest[j + j * n] -= form.pairs[k].real();
        rest[i + j * n] -= form.pairs[k].imag();
        rest[j + i * n] += form.pairs[k].imag();
    }
    for (const double x : rest)
        if (!(std::abs(x) <= 1e-8 * size)) return {};
    return form;
}

}  // namespace stagecraft
