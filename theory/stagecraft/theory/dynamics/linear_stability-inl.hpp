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

/// The polynomial with the eigenvalues of B on the imaginary axis as its simple roots, p that of B, none on the right:
/// the roots that p(x) and p(-x) share are those on the axis.
STAGECRAFT_INLINE polynomial<rational> axis_polynomial(const polynomial<rational>& p) {
    return squarefree(gcd(p, reflected(p)));
}

/// The operator G -> G B + B^T G on symmetric matrices, which are numbered by their upper triangles.
struct lyapunov_operator {
    dense<rational> matrix;
    Eigen::Index n;

    explicit lyapunov_operator(const dense<rational>& B) : n(B.rows()) {
        const auto size = n * (n + 1) / 2;
        matrix = dense<rational>::Constant(size, size, rational(0));
        for (Eigen::Index j = 0; j < n; ++j)
            for (Eigen::Index i = 0; i <= j; ++i)
                for (Eigen::Index k = 0; k < n; ++k) {
                    matrix(index(i, j), index(i, k)) += B(k, j);
                    matrix(index(i, j), index(k, j)) += B(k, i);
                }
    }
    static Eigen::Index index(Eigen::Index i, Eigen::Index j) {
        return i < j ? j * (j + 1) / 2 + i : i * (i + 1) / 2 + j;
    }
    dense<rational> numbered(const dense<rational>& Q) const {
        dense<rational> q(matrix.rows(), 1);
        for (Eigen::Index j = 0; j < n; ++j)
            for (Eigen::Index i = 0; i <= j; ++i) q(index(i, j), 0) = Q(i, j);
        return q;
    }
    dense<rational> symmetric(const dense<rational>& g) const {
        dense<rational> G(n, n);
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = 0; j < n; ++j) G(i, j) = g(index(i, j), 0);
        return G;
    }
};

/// The mean over all times of e^(t B)^T e^(t B), for a B with semisimple eigenvalues on the imaginary axis: G > 0 with
/// G B + B^T G = 0. The operator L of that equation is semisimple as well, so its kernel and its image are complements, and
/// the mean is the part of 1 in the kernel: 1 - L H with L L H = L 1.
STAGECRAFT_INLINE dense<rational> mean_inner_product(const dense<rational>& B) {
    const lyapunov_operator L(B);
    const dense<rational> one = L.numbered(tableaux::identity<rational>(B.rows()));
    const auto size = L.matrix.rows();
    dense<rational> work(size, size + 1);
    work.leftCols(size) = multiplied(L.matrix, L.matrix);
    work.rightCols(1) = multiplied(L.matrix, one);
    const auto pivots = tableaux::detail::eliminate<rational>(work, size);
    dense<rational> H = dense<rational>::Constant(size, 1, rational(0));
    for (std::size_t k = 0; k < pivots.size(); ++k)
        H(pivots[k], 0) = work(static_cast<Eigen::Index>(k), size);
    const dense<rational> image = multiplied(L.matrix, H);
    dense<rational> mean = one;
    for (Eigen::Index i = 0; i < size; ++i) mean(i, 0) -= image(i, 0);
    return L.symmetric(mean);
}

/// B, all eigenvalues on the left or on the axis, in a basis of ker s(B) and im s(B), s of `axis_polynomial`.
struct axis_splitting {
    dense<rational> basis;     ///< columns; not square where the two are no complements
    Eigen::Index on_axis = 0;  ///< how many of them span ker s(B)
};

STAGECRAFT_INLINE axis_splitting split_off_axis(const dense<rational>& B) {
    const auto once = at_matrix(axis_polynomial(tableaux::characteristic_polynomial<rational>(B)), B);
    const auto axis = kernel(once);
    dense<rational> work = once;
    const auto pivots = tableaux::detail::eliminate<rational>(work, work.cols());
    axis_splitting split{dense<rational>(B.rows(), B.rows()), static_cast<Eigen::Index>(axis.size())};
    Eigen::Index column = 0;
    for (const auto& v : axis) split.basis.col(column++) = v;
    for (const auto j : pivots) split.basis.col(column++) = once.col(j);
    return split;
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
    const detail::lyapunov_operator L(B);
    dense<rational> right = L.numbered(Q);
    for (Eigen::Index i = 0; i < right.rows(); ++i) right(i, 0) = -right(i, 0);
    const auto g = tableaux::solve<rational>(L.matrix, right);
    if (!g)
        throw std::invalid_argument("B: the Lyapunov equation is singular, the eigenvalues " +
                                    detail::mirrored_pair(B) + " add up to 0");
    return L.symmetric(*g);
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

namespace detail {

/// An inner product in which B, without eigenvalues on the right and with some on the axis, is dissipative; nothing where
/// one of these has a Jordan block of order 2 or more.
STAGECRAFT_INLINE std::optional<dense<rational>> marginal_inner_product(const dense<rational>& B) {
    const auto split = split_off_axis(B);
    const auto inverse = tableaux::inverse<rational>(split.basis);
    if (!inverse) return {};
    const auto n = B.rows(), k = split.on_axis;
    const dense<rational> parts = multiplied(*inverse, multiplied(B, split.basis));
    dense<rational> G = dense<rational>::Constant(n, n, rational(0));
    G.topLeftCorner(k, k) = mean_inner_product(parts.topLeftCorner(k, k));
    if (k < n)
        G.bottomRightCorner(n - k, n - k) =
            solve_lyapunov(parts.bottomRightCorner(n - k, n - k), tableaux::identity<rational>(n - k));
    return multiplied(inverse->transpose(), multiplied(G, *inverse));
}

}  // namespace detail

STAGECRAFT_INLINE dense<rational> inner_product(const dense<rational>& B, const rational& gamma) {
    detail::require_square_system(B);
    const auto shifted = detail::shifted(B, gamma);
    const auto count = detail::eigenvalue_count(shifted);
    std::optional<dense<rational>> G;
    if (count.right == 0 && count.axis > 0) G = detail::marginal_inner_product(shifted);
    if (count.right == 0 && count.axis == 0)
        G = solve_lyapunov(shifted, tableaux::identity<rational>(B.rows()));
    if (!G)
        throw std::invalid_argument(
            "gamma: must exceed the spectral abscissa of B, or equal it where the eigenvalues there have "
            "Jordan "
            "blocks of order 1; is " +
            gamma.str());
    require_inner_product(*G, B.rows());
    if (!bounds(gamma, *G, symmetric_part<rational>(*G, B)))
        throw std::logic_error("inner_product: the inequality fails");
    return *G;
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
    const auto once = detail::at_matrix(detail::axis_polynomial(p), B);
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
