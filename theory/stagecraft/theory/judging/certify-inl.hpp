// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/certify.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/models/legendre_simplifying.hpp"
#include "stagecraft/theory/stability/a_stability.hpp"
#include "stagecraft/theory/stability/schwarz.hpp"
#include "stagecraft/theory/trees/tree_order.hpp"
#include "stagecraft/theory/trees/tree_text.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE std::string condition(char letter, int k) {
    return letter + (k == every ? "(k) for every k" : "(" + std::to_string(k) + ")");
}

STAGECRAFT_INLINE std::string bound_text(const simplifying& k) {
    return condition('B', k.b) + ", " + condition('C', k.c) + ", " + condition('D', k.d);
}

// b^T c^B - 1/(B+1): x^B = q w + remainder, and the integral of q w is w_r / lead(w) times that of x^r P_r.
STAGECRAFT_INLINE rational first_quadrature_residual(const exact_model& m) {
    const int s = m.stages(), r = m.orthogonality();
    rational value = -m.w()[static_cast<std::size_t>(r)];
    for (int k = 1; k <= r; ++k) value *= rational(k, 2 * (2 * k + 1));  // (r!)^2 / (2r+1)!
    for (int k = 1; k <= s; ++k) value *= rational(k, 2 * (2 * k - 1));  // 1 / binom(2s, s)
    return value;
}

STAGECRAFT_INLINE std::string quadrature_failure(const exact_model& m, int b) {
    return "B(" + std::to_string(b + 1) + ") fails: b^T c^" + std::to_string(b) + " - 1/" +
           std::to_string(b + 1) + " = " + first_quadrature_residual(m).str();
}

STAGECRAFT_INLINE void certify_order(const exact_model& m, certificate& out) {
    const simplifying& k = out.simplifying;
    out.order = k.order_bound();
    const std::string least = bound_text(k) + ": order >= min(B, C+D+1, 2C+2) = " + std::to_string(out.order);
    if (k.bound_is_order()) {
        out.order_verdict = verdict::proved(least + "; " + quadrature_failure(m, k.b));
        return;
    }
    const int reach = std::min(k.b + 1, rooted_tree::max_order);
    const auto found = order_of(m, reach);
    const bool only_autonomous = k.c == 0;  // A 1 differs from c: the trees speak of y' = f(y)
    if (found.is_exact() && (!only_autonomous || found.order == out.order)) {
        out.order = found.order;
        const auto& first = found.failing.front();
        out.order_verdict =
            verdict::proved(least + "; all trees of order <= " + std::to_string(found.order) + ", not " +
                            condition_text(first.tree) + ": residual " + first.residual.str());
    } else {
        if (!only_autonomous) out.order = std::max(out.order, found.order);
        out.order_verdict = verdict::proved("at least: " + least);
    }
}

/// Orders beyond this have more than 4766 trees, and a certificate is to take milliseconds.
inline constexpr int largest_principal_order = 12;

STAGECRAFT_INLINE void certify_principal_error(const exact_model& m, certificate& out) {
    const int n = out.order + 1;
    if (n > largest_principal_order) return;
    const auto terms = local_error_terms(m, n);
    if (terms.norm_squared == 0) return;  // the order is a lower bound
    rational largest(0);
    for (const auto& t : terms.terms) largest = std::max(largest, abs(t.coefficient));
    const auto digits = [](double x) {
        char buffer[32];
        std::snprintf(buffer, sizeof buffer, "%.9g", x);
        return std::string(buffer);
    };
    out.principal_error = {n, digits(std::sqrt(terms.norm_squared.to<double>())),
                           digits(largest.to<double>())};
    out.others.push_back({text(*out.principal_error),
                          verdict::proved("residuals of all " + std::to_string(terms.terms.size()) +
                                          " trees over their symmetry")});
}

STAGECRAFT_INLINE void certify_stability_function(const exact_model& m, certificate& out) {
    out.R = stability_function_of(m);
    out.r_infinity = out.R.at_infinity();
    out.error_constant = abs(exponential_error(out.R, out.order));
    out.others.push_back({"R(z) = " + out.R.text(),
                          verdict::proved("det(I - z(A - 1 b^T)) / det(I - zA), common factors cancelled")});
    out.others.push_back({"R(infinity) = " + (out.r_infinity ? out.r_infinity->str() : "infinity"),
                          verdict::proved("leading coefficients")});
    const std::string power = std::to_string(out.order + 1);
    out.others.push_back({out.error_constant == 0  // on y' = lambda y the method does better than elsewhere
                              ? "R(z) - e^z has no term in z^" + power
                              : "|R(z) - e^z| = " + out.error_constant.str() + " |z|^" + power + " + ...",
                          verdict::proved("series of Q(z) e^z - P(z)")});

    if (const auto schwarz = schwarz_form_of(m.A())) {
        const rational e = schwarz->leading_e();
        const std::string text =
            "E(y) = " + (e == 0 ? "0" : e.str() + " y^" + std::to_string(2 * schwarz->size));
        out.a_stable = schwarz->is_a_stable()
                           ? verdict::proved("Schwarz form: " + text + (e == 0 ? "" : " >= 0") +
                                             ", poles in the right half-plane")
                           : verdict::refuted(text + " < 0: |R(iy)| > 1 for every real y != 0");
    } else {
        out.a_stable = a_stable(out.R);
    }
    if (out.a_stable.is_refuted()) {
        out.l_stable = verdict::refuted("not A-stable: " + out.a_stable.reason());
    } else {
        const std::string limit = "R(infinity) = " + out.r_infinity->str();  // A-stable: it exists
        out.l_stable =
            *out.r_infinity == 0 ? verdict::proved("A-stable and " + limit) : verdict::refuted(limit);
    }
}

// A itself where it is upper Hessenberg, its transpose where that is.
STAGECRAFT_INLINE std::optional<band_matrix<rational>> hessenberg_form(const band_matrix<rational>& a) {
    const int n = a.size();
    bool upper = true, lower = true;
    for (int i = 0; i < n; ++i)
        for (int j = a.first_column(i); j < a.end_column(i); ++j) {
            upper = upper && (j >= i - 1 || a(i, j) == 0);
            lower = lower && (j <= i + 1 || a(i, j) == 0);
        }
    if (upper) return a;
    if (!lower) return {};
    band_matrix<rational> t(n, a.upper(), a.lower());
    for (int i = 0; i < n; ++i)
        for (int j = a.first_column(i); j < a.end_column(i); ++j) t.entry(j, i) = a(i, j);
    return t;
}

STAGECRAFT_INLINE void certify_spectrum(const exact_model& m, certificate& out) {
    const int s = m.stages();
    if (s > largest_spectrum) {
        out.spectra.note = beyond_largest_spectrum();
        return;
    }
    try {
        out.spectra.poles = roots_of(out.R.denominator);
        if (count(*out.spectra.poles) == s)
            out.spectra.eigenvalues = reciprocals(*out.spectra.poles);
        else if (const auto h = hessenberg_form(m.A()))
            out.spectra.eigenvalues = eigenvalues_of(unscaled(determinant_of_one_minus_z(*h, s, (*h)(0, 0))),
                                                     s, *out.spectra.poles);
        else
            out.spectra.note = "no eigenvalues: A is not of Hessenberg form in Legendre coordinates";
    } catch (const tableaux::undecided& e) {
        out.spectra.note = std::string("no eigenvalues and poles: ") + e.what();
    }
    const std::string how = "enclosed; digits correctly rounded";
    if (out.spectra.poles)
        out.others.push_back({"poles of R: " + text(*out.spectra.poles), verdict::proved(how)});
    if (out.spectra.eigenvalues)
        out.others.push_back({"eigenvalues of A: " + text(*out.spectra.eigenvalues), verdict::proved(how)});
}

// A stage vector u with u^T S u < 0 for a symmetric S in Legendre coordinates, and that value.
STAGECRAFT_INLINE std::string negative_direction(const band_matrix<rational>& matrix) {
    std::vector<int> rows;  // the others are zero
    for (int i = 0; i < matrix.size(); ++i)
        for (int j = matrix.first_column(i); j < matrix.end_column(i); ++j)
            if (!(matrix(i, j) == 0)) {
                rows.push_back(i);
                break;
            }
    const auto n = static_cast<Eigen::Index>(rows.size());
    tableaux::dense<rational> dense(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
            dense(i, j) = matrix(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]);
    const auto u = *tableaux::diagonalise<rational>(dense).negative_direction();
    rational value(0);
    std::string text;
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) value += u[i] * dense(i, j) * u[j];
        if (u[i] == 0) continue;
        text += (u[i] < 0       ? (text.empty() ? "-" : " - ")
                 : text.empty() ? ""
                                : " + ") +
                (abs(u[i]) == 1 ? "" : abs(u[i]).str() + " ") + "P_" +
                std::to_string(rows[static_cast<std::size_t>(i)]) + "(c)";
    }
    return value.str() + " for the stage vector u = " + text;
}

STAGECRAFT_INLINE std::string text(const tableaux::inertia& n) {
    return std::to_string(n.positive) + " positive, " + std::to_string(n.negative) + " negative, " +
           std::to_string(n.zero) + " zero";
}

STAGECRAFT_INLINE void certify_algebraic_stability(const exact_model& m, certificate& out) {
    const auto matrix = algebraic_stability_matrix(m);
    out.weights = inertia_of(m.gram());
    out.M = inertia_of(matrix);
    const std::string gram = "the Gram matrix of b^T(uv) has signs: " + text(out.weights);
    out.others.push_back(
        {"b > 0", is_positive_definite(out.weights) ? verdict::proved(gram) : verdict::refuted(gram)});
    out.others.push_back({"M has rank " + std::to_string(theory::rank(out.M)),
                          verdict::proved("eigenvalues of M: " + text(out.M) + " (exact congruence)")});
    if (!is_nonnegative(out.weights)) {
        out.algebraically_stable =
            verdict::refuted("a negative weight: b^T(u u) = " + negative_direction(m.gram()));
    } else if (!is_nonnegative(out.M)) {
        out.algebraically_stable = verdict::refuted("u^T M u = " + negative_direction(matrix));
    } else {
        out.algebraically_stable = verdict::proved("b >= 0 and M >= 0");
    }
    out.b_stable = out.algebraically_stable.is_proved()
                       ? verdict::proved("algebraically stable")
                       : verdict::refuted("distinct nodes and not algebraically stable: " +
                                          out.algebraically_stable.reason());
    out.symplectic = theory::rank(out.M) == 0
                         ? verdict::proved("M = 0")
                         : verdict::refuted("M has rank " + std::to_string(theory::rank(out.M)));
}

// Reversal of time is x -> 1 - x, P_k -> (-1)^k P_k: A + S A S = 1 b^T, and nodes that mirror each other.
STAGECRAFT_INLINE verdict symmetry(const exact_model& m) {
    for (int j = 0; j < m.stages(); ++j)
        if ((m.stages() - j) % 2 != 0 && !(m.w()[static_cast<std::size_t>(j)] == 0))
            return verdict::refuted("the nodes are not symmetric about 1/2");
    for (int i = 0; i < m.stages(); ++i)
        for (int j = m.A().first_column(i); j < m.A().end_column(i); ++j) {
            if ((i + j) % 2 != 0) continue;
            const rational defect = 2 * m.A()(i, j) - (i == 0 && j == 0 ? 1 : 0);
            if (!(defect == 0))
                return verdict::refuted("A + SAS - 1 b^T has entry " + defect.str() +
                                        " in Legendre coordinates (" + std::to_string(i) + ", " +
                                        std::to_string(j) + ")");
        }
    return verdict::proved("symmetric nodes and A + SAS = 1 b^T, S the reflection x -> 1 - x");
}

STAGECRAFT_INLINE verdict stiff_accuracy(const exact_model& m) {
    rational w1(0);
    for (const rational& w : m.w()) w1 += w;
    if (!(w1 == 0)) return verdict::refuted("1 is not a node: w(1) = " + w1.str());
    for (int j = 0; j < m.stages(); ++j) {
        rational sum(0);
        for (int i = m.A().first_row(j); i < m.A().end_row(j); ++i) sum += m.A()(i, j);
        if (!(sum == (j == 0 ? 1 : 0)))
            return verdict::refuted("(A v)(1) - b^T v = " + rational(sum - (j == 0 ? 1 : 0)).str() +
                                    " for v = P_" + std::to_string(j));
    }
    return verdict::proved("1 is a node and (A v)(1) = b^T v");
}

STAGECRAFT_INLINE certificate certify(const exact_model& m, std::string method, std::string about_nodes) {
    certificate out;
    out.method = std::move(method);
    out.stages = m.stages();
    out.others.push_back({"nodes real, distinct, in [0, 1]", verdict::proved(std::move(about_nodes))});
    out.simplifying = simplifying_of(m);
    const auto& k = out.simplifying;
    const auto maximal = [](char letter, int value) {
        return condition(letter, value) + (value == every ? "" : " and no more");
    };
    out.others.push_back(
        {maximal('B', k.b),
         verdict::proved("w is orthogonal to all polynomials of degree < " +
                         std::to_string(m.orthogonality()) + " and not to P_" +
                         std::to_string(m.orthogonality()) + "; " + quadrature_failure(m, k.b))});
    out.others.push_back(
        {maximal('C', k.c), verdict::proved("columns of A against integration from 0 to x")});
    out.others.push_back(
        {maximal('D', k.d), verdict::proved("rows of b^T(u A v) against integration from x to 1")});
    out.others.push_back({"stage order " + std::to_string(k.stage_order()), verdict::proved("min(B, C)")});
    certify_order(m, out);
    certify_principal_error(m, out);
    certify_stability_function(m, out);
    certify_spectrum(m, out);
    certify_algebraic_stability(m, out);
    out.symmetric = symmetry(m);
    out.stiffly_accurate = stiff_accuracy(m);
    return out;
}

}  // namespace detail

STAGECRAFT_INLINE certificate certify(tableaux::family f, int s) {
    return detail::certify(legendre_model<tableaux::rational>(f, s), std::string(name(f)),
                           "roots of orthogonal polynomials on [0, 1], and its ends");
}

STAGECRAFT_INLINE certificate certify(const tableaux::nodal_polynomial& nodes, tableaux::construction rule) {
    return detail::certify(legendre_model<tableaux::rational>(nodes.legendre(), rule),
                           nodes.name() + " (" + std::string(name(rule)) + ")", "Sturm's theorem");
}

}  // namespace stagecraft::theory
