// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/tableau.hpp"
#include "stagecraft/tableaux/coprime.hpp"
#include "stagecraft/tableaux/polynomial.hpp"
#include "stagecraft/tableaux/routh_hurwitz.hpp"
#include "stagecraft/tableaux/simplifying.hpp"

namespace stagecraft::theory {

using tableaux::polynomial;
using tableaux::require_shape;

/// The rational function R = P/Q over an exact ordered field, in lowest terms with Q(0) = 1: y_1 = R(h
/// lambda) y_0 for y' = lambda y (Hairer-Wanner II.IV.3; lecture, Definition 2.17).
template <class K>
struct stability_function {
    polynomial<K> numerator;
    polynomial<K> denominator;

    /// R = P/Q with common factors cancelled. Throws std::invalid_argument where Q(0) = 0.
    static stability_function reduced(const polynomial<K>& p, const polynomial<K>& q) {
        if (q[0] == K(0)) throw std::invalid_argument("stability_function: the denominator vanishes at 0");
        if constexpr (requires { tableaux::coprime_by_residues(q, p); }) {
            if (tableaux::coprime_by_residues(q, p)) {
                const polynomial<K> scale(K(1) / q[0]);
                return {p * scale, q * scale};
            }
        }
        const auto common = gcd(p, q);
        const auto bottom = q / common;
        const polynomial<K> scale(K(1) / bottom[0]);
        return {p / common * scale, bottom * scale};
    }

    /// R(infinity); nothing where it is infinite.
    std::optional<K> at_infinity() const {
        if (numerator.degree() > denominator.degree()) return {};
        return numerator[denominator.degree()] / denominator.leading();
    }
    /// R(x) for real x. Throws std::domain_error at a pole.
    K operator()(const K& x) const {
        const K bottom = denominator(x);
        if (bottom == K(0)) throw std::domain_error("stability_function: a pole");
        return numerator(x) / bottom;
    }
    /// Poles (with multiplicity) left of, on and right of the imaginary axis, exactly.
    tableaux::half_plane_count poles() const { return count_half_planes(denominator); }
    std::string text() const {
        const auto top = to_string(numerator, "z");
        if (denominator.degree() == 0) return top;
        return "(" + top + ")/(" + to_string(denominator, "z") + ")";
    }
    friend bool operator==(const stability_function&, const stability_function&) = default;
};

/// R(z) = 1 + z b^T (I - z A)^-1 e, where e is the image of the constant 1 (the vector of ones in stage
/// coordinates, the first unit vector in a Legendre basis). With Q = det(I - z A) the numerator Q R is a
/// polynomial of degree <= s, hence the product of Q and the series 1 + sum_k b^T A^k e z^(k+1) up to z^s.
/// Exact; O(s^3) operations besides the determinant.
template <class K>
stability_function<K> stability_function_of(const tableaux::dense<K>& A, const tableaux::column<K>& b,
                                            const tableaux::column<K>& e) {
    const auto s = A.rows();
    const auto q = tableaux::determinant_of_one_minus_z<K>(A);
    std::vector<K> series{K(1)};
    tableaux::column<K> power = e;  // A^k e
    for (Eigen::Index k = 0; k < s; ++k) {
        K sum(0);
        for (Eigen::Index i = 0; i < s; ++i) {
            if (!(b[i] == K(0))) sum = sum + b[i] * power[i];
        }
        series.push_back(sum);
        tableaux::column<K> next(s);
        for (Eigen::Index i = 0; i < s; ++i) {
            next[i] = K(0);
            for (Eigen::Index j = 0; j < s; ++j) {
                if (!(A(i, j) == K(0))) next[i] = next[i] + A(i, j) * power[j];
            }
        }
        power = next;
    }
    std::vector<K> p;
    for (Eigen::Index n = 0; n <= s; ++n) {
        K sum(0);
        for (int k = 0; k <= n && k <= q.degree(); ++k)
            sum = sum + q[k] * series[static_cast<std::size_t>(n - k)];
        p.push_back(sum);
    }
    return stability_function<K>::reduced(polynomial<K>(std::move(p)), q);
}

template <class K>
tableaux::column<K> ones(Eigen::Index n) {
    tableaux::column<K> e(n);
    for (Eigen::Index i = 0; i < n; ++i) e[i] = K(1);
    return e;
}

/// The stability function of the method (Hairer-Wanner II, Proposition IV.3.2; lecture, Satz 2.18).
template <class K>
stability_function<K> stability_function_of(const tableau<K>& t) {
    require_shape(t);
    return stability_function_of<K>(t.A, t.b, ones<K>(t.b.size()));
}

/// The stability function of the embedded method. Throws std::invalid_argument where there is none.
template <class K>
stability_function<K> embedded_stability_function_of(const tableau<K>& t) {
    require_shape(t);
    if (t.b_embedded.size() == 0) throw std::invalid_argument("tableau: no embedded weights");
    return stability_function_of<K>(t.A, t.b_embedded, ones<K>(t.b.size()));
}

/// The other determinant formula of Satz 2.18, det [I - zA, 1; -z b^T, 1] / det(I - zA), from the values of
/// both determinants at z = 0, ..., s and Newton interpolation: shares no step with the first formula.
template <class K>
stability_function<K> stability_function_by_bordering(const tableau<K>& t) {
    require_shape(t);
    const auto s = t.b.size();
    const auto interpolated = [&](auto value) {
        std::vector<K> d;  // divided differences at 0, 1, ..., s
        for (int z = 0; z <= s; ++z) {
            d.push_back(value(K(z)));
        }
        for (int level = 1; level <= s; ++level) {
            for (int k = static_cast<int>(s); k >= level; --k) {
                auto& entry = d[static_cast<std::size_t>(k)];
                entry = (entry - d[static_cast<std::size_t>(k) - 1]) / K(level);
            }
        }
        polynomial<K> p;
        for (int k = static_cast<int>(s); k >= 0; --k) {
            p = p * polynomial<K>{K(0) - K(k), K(1)} + polynomial<K>(d[static_cast<std::size_t>(k)]);
        }
        return p;
    };
    const auto matrix = [&](const K& z, bool bordered) {
        tableaux::dense<K> m(s + (bordered ? 1 : 0), s + (bordered ? 1 : 0));
        for (Eigen::Index i = 0; i < s; ++i) {
            for (Eigen::Index j = 0; j < s; ++j) m(i, j) = K(i == j ? 1 : 0) - z * t.A(i, j);
            if (!bordered) continue;
            m(i, s) = K(1);
            m(s, i) = K(0) - z * t.b[i];
        }
        if (bordered) m(s, s) = K(1);
        return m;
    };
    return stability_function<K>::reduced(
        interpolated([&](const K& z) { return tableaux::determinant<K>(matrix(z, true)); }),
        interpolated([&](const K& z) { return tableaux::determinant<K>(matrix(z, false)); }));
}

/// The Pade approximation of e^z with numerator degree j and denominator degree k
/// (Hairer-Wanner II, Theorem IV.3.11).
template <class K>
stability_function<K> pade(int j, int k) {
    if (j < 0 || k < 0) throw std::invalid_argument("pade: degrees must not be negative");
    const auto part = [](int n, int m, int sign) {
        std::vector<K> v{K(1)};
        for (int i = 0; i < n; ++i) v.push_back(v.back() * K(sign * (n - i)) / K((n + m - i) * (i + 1)));
        return polynomial<K>(std::move(v));
    };
    return stability_function<K>::reduced(part(j, k, 1), part(k, j, -1));
}

/// How well R approximates the exponential; `pade` where the order equals the sum of the degrees.
template <class K>
struct exponential_fit {
    int order = 0;
    K error_constant;  ///< C of e^z - R(z) = C z^(p+1) + ...
    int numerator_degree = 0;
    int denominator_degree = 0;
    bool pade = false;
};

/// Exact. It ends: no rational function equals the exponential.
template <class K>
exponential_fit<K> exponential_fit_of(const stability_function<K>& r) {
    exponential_fit<K> fit;
    fit.numerator_degree = r.numerator.degree();
    fit.denominator_degree = r.denominator.degree();
    std::vector<K> inverse_factorial{K(1)};
    for (int n = 0;; ++n) {
        if (n > 0) inverse_factorial.push_back(inverse_factorial.back() / K(n));
        K coefficient(0);  // of z^n in Q e^z - P
        for (int k = 0; k <= n && k <= r.denominator.degree(); ++k) {
            coefficient = coefficient + r.denominator[k] * inverse_factorial[static_cast<std::size_t>(n - k)];
        }
        coefficient = coefficient - r.numerator[n];
        if (coefficient == K(0)) continue;
        fit.order = n - 1;
        fit.error_constant = coefficient;  // Q(0) = 1
        fit.pade = fit.order == fit.numerator_degree + fit.denominator_degree;
        return fit;
    }
}

}  // namespace stagecraft::theory
