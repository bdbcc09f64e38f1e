// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/transformed.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/collocation.hpp"
#include "stagecraft/tableaux/complex_roots.hpp"
#include "stagecraft/tableaux/legendre.hpp"
#include "stagecraft/tableaux/roots.hpp"
#include "stagecraft/tableaux/small_solve.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE inverse_form inverse_form_of(const nodal_polynomial& w, construction rule) {
    const bool left = w.monomial()(rational(0)) == 0;
    if (rule == construction::collocation && !left) return inverse_form::collocation;
    if (rule == construction::collocation)
        throw std::invalid_argument(
            "method: A of collocation with the node 0 is singular (its first row "
            "is 0); use rounded(), the plain tableau, in place of transformed()");
    if (rule == construction::lobatto_iiic || w.family() == family::radau_ia)
        return inverse_form::first_column;
    throw std::invalid_argument(
        "method: " + w.name() + " has no A^-1 here (D(s) with the node 1 makes A " +
        "singular; other adjoint methods have no closed form); use rounded(), the plain "
        "tableau, in place of transformed()");
}

STAGECRAFT_INLINE rational first_weight(const nodal_polynomial& w) {
    const polynomial<rational> quotient = w.monomial() / polynomial<rational>::x();
    return integral(quotient)(rational(1)) / quotient(rational(0));
}

STAGECRAFT_INLINE polynomial<rational> characteristic_polynomial(const nodal_polynomial& w,
                                                                 inverse_form form) {
    const int s = w.degree();
    std::vector<rational> q(static_cast<std::size_t>(s) + 1, rational(0));
    rational factorial = 1;
    const bool collocation = form == inverse_form::collocation;
    for (int k = 0; k <= (collocation ? s : s - 1); ++k) {
        if (k > 0) factorial *= rational(k);
        if (collocation)
            q[static_cast<std::size_t>(s - k)] = factorial * w.monomial()[k];
        else
            q[static_cast<std::size_t>(s - 1 - k)] = -factorial * w.monomial()[k + 1];
    }
    if (!collocation) q[static_cast<std::size_t>(s)] = first_weight(w) * w.monomial()[1];
    return polynomial<rational>(std::move(q));
}

STAGECRAFT_INLINE bool curvature_vanishes_inside(const nodal_polynomial& w) {
    if (w.degree() < 3) return false;
    const auto [quotient, rest] = divmod(w.monomial(), polynomial<rational>{0, -1, 1});
    return rest.is_zero() && monic(quotient) == monic(derivative(derivative(w.monomial())));
}

STAGECRAFT_INLINE tableau<ball>::matrix enclose_inverse(const nodal_polynomial& w, inverse_form form,
                                                        const tableau<ball>& t, int bits) {
    const int s = w.degree();
    const auto derivatives = [&](const polynomial<rational>& p) { return enclosed(to_legendre(p), bits); };
    const auto first = derivatives(derivative(w.monomial()));
    const auto second = derivatives(derivative(derivative(w.monomial())));
    const bool inside_flat = curvature_vanishes_inside(w);
    std::vector<ball> slope, curvature;
    for (int i = 0; i < s; ++i) {
        const auto p = legendre_values(t.c(i), s).value;
        slope.push_back(legendre_sum(first, p));
        const bool flat = inside_flat && i > 0 && i < s - 1;
        curvature.push_back(flat ? ball(0) : legendre_sum(second, p));
    }
    tableau<ball>::matrix inverse(s, s);
    for (int i = 0; i < s; ++i)
        for (int j = 0; j < s; ++j) {
            const ball& wi = slope[static_cast<std::size_t>(i)];
            const ball& wj = slope[static_cast<std::size_t>(j)];
            ball d =
                i == j ? curvature[static_cast<std::size_t>(i)] / (wi + wi) : wi / (wj * (t.c(i) - t.c(j)));
            if (form == inverse_form::collocation) {
                if (i != j) d *= t.c(i) / t.c(j);
                if (i == j) d += ball(1) / t.c(i);
            } else if (i == 0 && j == 0) {
                d += ball(rational(1) / first_weight(w), bits);
            }
            inverse(i, j) = std::move(d);
        }
    return inverse;
}

STAGECRAFT_INLINE std::vector<complex_ball> enclose_eigenvector(const std::vector<ball>& g,
                                                                const std::vector<std::vector<ball>>& p,
                                                                const complex_ball& lambda) {
    const int s = static_cast<int>(g.size());
    const complex_ball mu = complex_ball{1, 0} / lambda;
    std::vector<complex_ball> V(g.size()), q(g.size() + 2);
    for (int k = s - 1; k >= 0; --k) {
        const auto at = static_cast<std::size_t>(k);
        V[at] = complex_ball{g[at], 0} + mu * q[at];
        if (k == 0) break;
        const complex_ball& above = q[at + 1];
        const complex_ball sum{V[at].re + above.re.over(2 * (2 * k + 3)),
                               V[at].im + above.im.over(2 * (2 * k + 3))};
        q[at - 1] = {sum.re.times(2 * (2 * k - 1)), sum.im.times(2 * (2 * k - 1))};
    }
    std::vector<complex_ball> v;
    for (const auto& row : p) {
        complex_ball sum{0, 0};
        for (std::size_t k = 0; k < V.size(); ++k) sum = sum + V[k] * row[k];
        v.push_back(sum);
    }
    const complex_ball last = v.back();
    for (complex_ball& x : v) x = x / last;
    v.back() = {1, 0};
    return v;
}

STAGECRAFT_INLINE tableau<ball>::matrix enclose_inverse(tableau<ball>::matrix m) {
    const auto n = m.rows();
    tableau<ball>::matrix x(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) x(i, j) = i == j ? 1 : 0;
    for (Eigen::Index k = 0; k < n; ++k) {
        Eigen::Index pivot = k;
        for (Eigen::Index i = k + 1; i < n; ++i)
            if (m(i, k).lower_magnitude() > m(pivot, k).lower_magnitude()) pivot = i;
        for (Eigen::Index j = 0; j < n && pivot != k; ++j) {
            std::swap(m(k, j), m(pivot, j));
            std::swap(x(k, j), x(pivot, j));
        }
        for (Eigen::Index i = k + 1; i < n; ++i) {
            if (m(i, k).exactly_zero()) continue;
            const ball f = m(i, k) / m(k, k);
            for (Eigen::Index j = k + 1; j < n; ++j) m(i, j) -= f * m(k, j);
            for (Eigen::Index j = 0; j < n; ++j) x(i, j) -= f * x(k, j);
        }
    }
    for (Eigen::Index k = n; k-- > 0;)
        for (Eigen::Index j = 0; j < n; ++j) {
            for (Eigen::Index i = k + 1; i < n; ++i) x(k, j) -= m(k, i) * x(i, j);
            x(k, j) /= m(k, k);
        }
    return x;
}

STAGECRAFT_INLINE bool first_component_is_imaginary(const nodal_polynomial& w, inverse_form form) {
    if (w.degree() != 2) return false;
    const polynomial<rational> m = monic(w.monomial());
    if (form == inverse_form::collocation) return 6 * m[0] == m[1] * m[1];
    return 1 / first_weight(w) == rational(-2) / m[1];  // c_2 = -m_1, diag(D) = (-1/c_2, 1/c_2)
}

STAGECRAFT_INLINE transformed_tableau<ball> enclose_transformed(const nodal_polynomial& w, construction rule,
                                                                int bits) {
    const inverse_form form = inverse_form_of(w, rule);
    const int s = w.degree();
    transformed_tableau<ball> t;
    static_cast<tableau<ball>&>(t) = enclose(w, rule, bits);
    t.A_inverse = enclose_inverse(w, form, t, bits);
    const root_enclosures lambda = enclose_roots(characteristic_polynomial(w, form), bits);
    const polynomial<rational> g = form == inverse_form::collocation
                                       ? derivative(w.monomial())
                                       : w.monomial() / polynomial<rational>::x();
    const std::vector<ball> coordinates = enclosed(to_legendre(g), bits);
    std::vector<std::vector<ball>> p;
    for (int i = 0; i < s; ++i) p.push_back(legendre_values(t.c(i), s - 1).value);

    t.gamma.resize(static_cast<Eigen::Index>(lambda.real.size()));
    t.alpha.resize(static_cast<Eigen::Index>(lambda.upper.size()));
    t.beta.resize(static_cast<Eigen::Index>(lambda.upper.size()));
    t.T.resize(s, s);
    Eigen::Index column = 0;
    for (const ball& x : lambda.real) {
        const auto v = enclose_eigenvector(coordinates, p, {x, 0});
        for (int i = 0; i < s; ++i) t.T(i, column) = v[static_cast<std::size_t>(i)].re;
        t.gamma(column++) = x;
    }
    for (std::size_t k = 0; k < lambda.upper.size(); ++k, column += 2) {
        auto v = enclose_eigenvector(coordinates, p, lambda.upper[k]);
        if (first_component_is_imaginary(w, form)) v[0].re = 0;
        for (int i = 0; i < s; ++i) {
            t.T(i, column) = v[static_cast<std::size_t>(i)].re;
            t.T(i, column + 1) = v[static_cast<std::size_t>(i)].im;
        }
        t.alpha(static_cast<Eigen::Index>(k)) = lambda.upper[k].re;
        t.beta(static_cast<Eigen::Index>(k)) = lambda.upper[k].im;
    }
    t.T_inverse = enclose_inverse(t.T);
    return t;
}

}  // namespace stagecraft::tableaux
