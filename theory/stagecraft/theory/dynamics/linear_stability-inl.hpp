// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/linear_stability.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/routh_hurwitz.hpp"
#include "stagecraft/theory/statements/verdict.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE dense<rational> shifted(dense<rational> B, const rational& gamma) {
    for (Eigen::Index i = 0; i < B.rows(); ++i) B(i, i) -= gamma;
    return B;
}

STAGECRAFT_INLINE tableaux::half_plane_count eigenvalue_count(const dense<rational>& B) {
    return count_half_planes(tableaux::characteristic_polynomial<rational>(B));
}

/// "1i and -1i": two eigenvalues whose sum is 0, to name them. They are roots of both p(x) and p(-x), p the
/// characteristic polynomial; the greatest common divisor is x^e q(x^2), and a root of q is found by the iteration of
/// Durand and Kerner, in doubles.
STAGECRAFT_INLINE std::string mirrored_pair(const dense<rational>& B) {
    const auto p = tableaux::characteristic_polynomial<rational>(B);
    const auto common = squarefree(gcd(p, reflected(p)));
    if (common[0] == 0) return "0 and 0";
    using complex = std::complex<double>;
    const int n = common.degree() / 2;
    std::vector<complex> roots(1, 1.0);
    while (static_cast<int>(roots.size()) < n) roots.push_back(roots.back() * complex(0.4, 0.9));
    for (int round = 0; round < 200; ++round) {
        for (auto& x : roots) {
            complex value = 0, others = 1;
            for (int k = n; k >= 0; --k) value = value * x + common[2 * k].to<double>();
            for (const auto& y : roots)
                if (&y != &x) others *= x - y;
            x -= value / others;
        }
    }
    const complex z = std::sqrt(roots.front());
    std::ostringstream out;
    const auto print = [&](double sign) {
        const double re = std::abs(z.real()) < 1e-9 ? 0 : sign * z.real(), im = sign * z.imag();
        if (std::abs(im) < 1e-9)
            out << re;
        else if (re == 0)
            out << im << "i";
        else
            out << re << (im < 0 ? " - " : " + ") << std::abs(im) << "i";
    };
    print(1);
    out << " and ";
    print(-1);
    return out.str();
}

/// A basis of the kernel of M, as columns.
STAGECRAFT_INLINE std::vector<column<rational>> kernel(dense<rational> M) {
    const auto pivots = tableaux::detail::eliminate<rational>(M, M.cols());
    std::vector<column<rational>> basis;
    for (Eigen::Index j = 0; j < M.cols(); ++j) {
        if (std::find(pivots.begin(), pivots.end(), j) != pivots.end()) continue;
        column<rational> v = column<rational>::Constant(M.cols(), rational(0));
        v[j] = 1;
        for (std::size_t k = 0; k < pivots.size(); ++k) v[pivots[k]] = -M(static_cast<Eigen::Index>(k), j);
        basis.push_back(v);
    }
    return basis;
}

STAGECRAFT_INLINE dense<rational> multiplied(const dense<rational>& A, const dense<rational>& B) {
    dense<rational> C = dense<rational>::Constant(A.rows(), B.cols(), rational(0));
    for (Eigen::Index i = 0; i < A.rows(); ++i)
        for (Eigen::Index k = 0; k < A.cols(); ++k)
            if (A(i, k) != 0)
                for (Eigen::Index j = 0; j < B.cols(); ++j) C(i, j) += A(i, k) * B(k, j);
    return C;
}

/// p(B), by Horner's rule.
STAGECRAFT_INLINE dense<rational> at_matrix(const polynomial<rational>& p, const dense<rational>& B) {
    dense<rational> value = dense<rational>::Constant(B.rows(), B.cols(), rational(0));
    for (int k = p.degree(); k >= 0; --k) {
        value = multiplied(value, B);
        for (Eigen::Index i = 0; i < B.rows(); ++i) value(i, i) += p[k];
    }
    return value;
}

STAGECRAFT_INLINE void require_square_system(const dense<rational>& B) {
    if (B.rows() != B.cols() || B.rows() == 0) throw std::invalid_argument("B: must be square and not empty");
}

}  // namespace detail

STAGECRAFT_INLINE dense<rational> solve_lyapunov(const dense<rational>& B, const dense<rational>& Q) {
    detail::require_square_system(B);
    const auto n = B.rows();
    if (Q.rows() != n || Q.cols() != n) throw std::invalid_argument("Q: must have the size of B");
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < i; ++j)
            if (Q(i, j) != Q(j, i)) throw std::invalid_argument("Q: must be symmetric");
    const auto index = [](Eigen::Index i, Eigen::Index j) {
        return i < j ? j * (j + 1) / 2 + i : i * (i + 1) / 2 + j;
    };
    const auto size = n * (n + 1) / 2;
    dense<rational> M = dense<rational>::Constant(size, size, rational(0)), right(size, 1);
    for (Eigen::Index j = 0; j < n; ++j) {
        for (Eigen::Index i = 0; i <= j; ++i) {
            const auto row = index(i, j);
            right(row, 0) = -Q(i, j);
            for (Eigen::Index k = 0; k < n; ++k) {
                M(row, index(i, k)) += B(k, j);
                M(row, index(k, j)) += B(k, i);
            }
        }
    }
    const auto g = tableaux::solve<rational>(M, right);
    if (!g)
        throw std::invalid_argument("B: the Lyapunov equation is singular, the eigenvalues " +
                                    detail::mirrored_pair(B) + " add up to 0");
    dense<rational> G(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) G(i, j) = (*g)(index(i, j), 0);
    return G;
}

STAGECRAFT_INLINE supremum spectral_abscissa(const dense<rational>& B, const rational& width) {
    detail::require_square_system(B);
    const auto left = [&](const rational& c) { return detail::eigenvalue_count(detail::shifted(B, c)); };
    const int n = static_cast<int>(B.rows());
    rational low = -1, high = 1;
    while (left(high).left < n) high = 2 * high;
    while (left(low).left == n) low = 2 * low;
    while (high - low > width) {
        const rational c = (low + high) / 2;
        const auto count = left(c);
        if (count.right == 0 && count.axis > 0) return {c, c, {}};
        (count.left == n ? high : low) = c;
    }
    if (const auto count = left(low); count.right == 0 && count.axis > 0) return {low, low, {}};
    return {low, high, {}};
}

STAGECRAFT_INLINE dense<rational> inner_product(const dense<rational>& B, const rational& gamma) {
    detail::require_square_system(B);
    const auto shifted = detail::shifted(B, gamma);
    if (detail::eigenvalue_count(shifted).left < B.rows())
        throw std::invalid_argument("gamma: must exceed the spectral abscissa of B, is " + gamma.str());
    const auto G = solve_lyapunov(shifted, tableaux::identity<rational>(B.rows()));
    require_inner_product(G, B.rows());
    if (!bounds(gamma, G, symmetric_part<rational>(G, B)))
        throw std::logic_error("inner_product: the inequality fails");
    return G;
}

STAGECRAFT_INLINE linear_stability_verdict linear_stability(const dense<rational>& B) {
    detail::require_square_system(B);
    const auto p = tableaux::characteristic_polynomial<rational>(B);
    const auto count = count_half_planes(p);
    if (count.right > 0)
        return {lyapunov_stability::unstable,
                std::to_string(count.right) + " eigenvalues in the right half-plane"};
    if (count.axis == 0)
        return {lyapunov_stability::asymptotically_stable, "all eigenvalues in the left half-plane"};
    // Without roots on the right, the roots that p(x) and p(-x) share are those on the axis.
    const auto s = squarefree(gcd(p, reflected(p)));
    const auto once = detail::at_matrix(s, B);
    const auto twice = detail::multiplied(once, once);
    for (const auto& v : detail::kernel(twice)) {
        const auto image = detail::multiplied(once, v);
        if (std::all_of(image.data(), image.data() + image.size(), [](const rational& a) { return a == 0; }))
            continue;
        return {lyapunov_stability::unstable, "a Jordan block of order 2 at least on the imaginary axis", v};
    }
    return {lyapunov_stability::stable, "eigenvalues on the imaginary axis in Jordan blocks of order 1"};
}

}  // namespace stagecraft::theory
