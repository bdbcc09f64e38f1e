// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/exercises/dynamics_exercises.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/dynamics/dissipativity.hpp"
#include "stagecraft/theory/dynamics/linear_stability.hpp"
#include "stagecraft/theory/exercises/methods.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE certified_statement fixed_points_are(const periodic_points& found,
                                                       const std::vector<claimed_point>& claimed) {
    std::string list;
    for (const auto& p : claimed) list += (list.empty() ? "" : ", ") + p.x.str();
    const std::string what = "fixed points: " + list;
    if (!found.verdict.is_proved()) return {what, found.verdict};
    bool same = found.points.size() == claimed.size();
    for (std::size_t k = 0; same && k < claimed.size(); ++k) {
        const auto& f = found.points[k];
        const auto& c = claimed[k];
        const auto m = interval(c.multiplier);
        same = f.low <= c.x && c.x <= f.high && f.equilibrium == c.equilibrium &&
               !disjoint(f.multiplier, m) && f.multiplier.width() < 1e-6;
    }
    return {what, same ? found.verdict : verdict::refuted("others were found")};
}

STAGECRAFT_INLINE exercise find_ghosts(dice& d) {
    const rational c = d.node();
    const int parts = d.between(1, 3);
    const rational h(d.between(1, 8), parts);
    const int p = d.between(-3, 2), q = p + d.between(1, 4);
    const int top = d.between(1, 4);
    int bottom = d.between(1, 2);
    if (c * h * rational(top, bottom) * (q - p) == 1) bottom *= 3;  // a ghost would meet the equilibrium q
    const rational a(top, bottom);
    const rational r = 1 / (c * h * a);
    tableau<rational> t = exercise_methods::with_nodes({0, c});
    exercise_methods::set_row(t, 1, {0});
    t.b[1] = 1;
    const auto f = [&](const auto&, const auto& x, auto& out) {
        out[0] = top * (x[0] - p) * (q - x[0]) / bottom;
    };
    const auto slope = [&](const rational& x) { return a * (p + q - 2 * x); };
    const auto value = [&](const rational& x) { return a * (x - p) * (q - x); };
    const auto multiplier = [&](const rational& x) {
        const rational x2 = x + c * h * value(x);
        return 1 + h * slope(x2) * (1 + c * h * slope(x));
    };
    std::vector<claimed_point> points;
    for (const rational& x : {rational(p), rational(q), p + r, q + r})
        points.push_back({x, multiplier(x), x == p || x == q});
    std::sort(points.begin(), points.end(), [](const auto& u, const auto& v) { return u.x < v.x; });

    exercise e;
    const std::string factor = a == 1 ? "" : latex(a) + " ";
    const auto minus = [](const rational& x) {
        return x == 0 ? std::string("x") : "(x " + std::string(x < 0 ? "+ " : "- ") + latex(abs(x)) + ")";
    };
    const std::string right = q == 0 ? "(-x)" : "(" + latex(rational(q)) + " - x)";
    e.question = {
        paragraph("Find all fixed points of this method with $h = " + latex(h) + "$ for $x' = " + factor +
                  minus(p) + " " + right +
                  "$. Which are ghosts (no equilibria of the differential equation), and which attract?"),
        detail::tableau_block(t)};
    e.solution = {
        paragraph(
            "$x_{1} = x_{0} + h f(X_{2})$, so $X_{2} = x + c_{2} h f(x)$ must be an equilibrium, " +
            std::to_string(p) + " or " + std::to_string(q) +
            ". Each of the two quadratic equations has the equilibrium itself as one root; the others are $" +
            latex(q + r) + "$ and $" + latex(p + r) +
            "$, the equilibria moved by $\\frac{1}{c_{2} h a} = " + latex(r) + "$."),
        paragraph("The multiplier is $1 + h f'(X_{2}) (1 + c_{2} h f'(x))$:")};
    for (const auto& point : points)
        e.solution.push_back(paragraph("$x = " + latex(point.x) +
                                       "$: " + (point.equilibrium ? "an equilibrium" : "a ghost") +
                                       ", multiplier $" + latex(point.multiplier) + "$, " +
                                       (abs(point.multiplier) < 1   ? "attracting."
                                        : abs(point.multiplier) > 1 ? "repelling."
                                                                    : "of modulus 1.")));
    e.certificate = {fixed_points_are(ghosts(t, f, h), points)};
    return e;
}

namespace detail {

inline const std::string ask_one_sided_constant =
    "Find the least $\\gamma$ with $\\langle f(x) - f(y), x - y \\rangle \\le \\gamma |x - y|^{2}$ for all "
    "$x$, $y$, or "
    "show that there is none: $f(x) = ";

STAGECRAFT_INLINE certified_statement gamma_is(const rational& gamma, const one_sided_constant& found) {
    return {"gamma = " + gamma.str(), found.low == gamma && found.high == gamma
                                          ? found.verdict
                                          : verdict::refuted(found.verdict.text())};
}

/// f = a x + c x^2 - b x^3, with b = 0 at times.
STAGECRAFT_INLINE exercise scalar_one_sided_constant(dice& d) {
    const int a = d.between(-5, 5), c = d.not_zero(4), b = d.coin() ? d.between(1, 4) : 0;
    const polynomial<rational> p{0, a, c, -b};
    const auto slope = derivative(p);
    const auto found = one_sided_lipschitz<1>([&](const auto&, const auto& x, auto& out) {
        out[0] = a * x[0] + c * x[0] * x[0] - b * x[0] * x[0] * x[0];
    });
    exercise e;
    e.question = {paragraph(ask_one_sided_constant + latex(p, "x") + "$.")};
    const std::string least = "The least $\\gamma$ is the supremum of $f'(x) = " + latex(slope, "x") + "$";
    if (b > 0) {
        const rational gamma = a + rational(c * c, 3 * b), at(c, 3 * b);
        e.solution = {
            paragraph(least + ", attained at $x = " + latex(at) + "$: $\\gamma = " + latex(gamma) + "$.")};
        e.certificate = {equal("f'(" + at.str() + ")", slope(at), gamma), gamma_is(gamma, found)};
    } else {
        const rational gamma = d.between(0, 20), x = (gamma - a + 1) / (2 * c);
        e.solution = {
            paragraph(least + ", which is infinite: there is none. For example $\\gamma = " + latex(gamma) +
                      "$ fails near $x = " + latex(x) + "$, where $f'(x) = " + latex(gamma + 1) + "$.")};
        e.certificate = {{"a one-sided Lipschitz constant exists", found.verdict, false},
                         equal("f'(" + x.str() + ")", slope(x), gamma + 1)};
    }
    return e;
}

/// f = B x - b (x_1^3, 0), the symmetric part of B with rational eigenvalues.
STAGECRAFT_INLINE exercise planar_one_sided_constant(dice& d) {
    static const std::vector<std::array<int, 3>> triples{
        {0, 2, 2}, {6, 8, 10}, {8, 6, 10}, {4, 0, 4}, {10, 24, 26}};
    const auto [difference, sum, root] = d.pick(triples);
    const int b = d.between(1, 4), left = d.between(-4, 4), right = left - difference,
              upper = d.between(-6, 6), lower = sum - upper;
    const rational gamma(left + right + root, 2);
    tableaux::dense<rational> B(2, 2), S(2, 2), rest(2, 2);
    B << rational(left), rational(upper), rational(lower), rational(right);
    S << rational(left), rational(sum, 2), rational(sum, 2), rational(right);
    rest << left - gamma, rational(sum, 2), rational(sum, 2), right - gamma;
    const auto found = one_sided_lipschitz<2>([&](const auto&, const auto& x, auto& out) {
        out[0] = left * x[0] + upper * x[1] - b * x[0] * x[0] * x[0];
        out[1] = lower * x[0] + right * x[1];
    });
    exercise e;
    e.question = {paragraph(ask_one_sided_constant + "B x - " + (b == 1 ? "" : std::to_string(b) + " ") +
                            "(x_{1}^{3}, 0)^{T}$ in the plane, with"),
                  matrix_block("B = ", B)};
    e.solution = {matrix_block("\\frac{1}{2} (B + B^{T}) = ", S),
                  paragraph("Its largest eigenvalue is $" + latex(gamma) +
                            "$. The derivative of the cubic term, $-" + std::to_string(3 * b) +
                            " x_{1}^{2}$ in the corner, only lowers it, and vanishes at "
                            "$x = 0$: $\\gamma = " +
                            latex(gamma) + "$.")};
    e.certificate = {equal("det((B + B^T)/2 - gamma)", tableaux::determinant<rational>(rest), 0),
                     gamma_is(gamma, found)};
    return e;
}

/// The exercise of a field in words, whose least alpha for beta is `alpha` because of `how`; the certificate asks what
/// dissipativity() has found.
template <int N>
exercise absorbing_ball(const std::string& field, const rational& beta, const rational& alpha,
                        const std::string& how, const dissipativity_constants<N>& found) {
    exercise e;
    e.question = {paragraph("For $x' = f(x)$ with " + field +
                            " find the least $\\alpha$ with $\\langle f(x), x \\rangle "
                            "\\le \\alpha - \\beta |x|^{2}$ for $\\beta = " +
                            latex(beta) + "$. Which balls around 0 are absorbing?")};
    e.solution = {
        paragraph(how + " $\\alpha = " + latex(alpha) + "$."),
        paragraph("From $\\frac{d}{dt} |x|^{2} \\le 2 \\alpha - 2 \\beta |x|^{2}$: "
                  "every ball of a radius above $\\sqrt{\\alpha / \\beta} = \\sqrt{" +
                  latex(alpha / beta) +
                  "}$ is positively invariant and absorbing. The same holds for the implicit Euler method "
                  "with any steps $h_{n}$ of infinite sum.")};
    e.certificate = {
        {"alpha = " + alpha.str() + " for beta = " + beta.str(),
         found.exact && found.alpha == alpha ? found.verdict : verdict::refuted(found.verdict.text())}};
    return e;
}

}  // namespace detail

STAGECRAFT_INLINE exercise find_one_sided_constant(dice& d) {
    return d.coin() ? detail::scalar_one_sided_constant(d) : detail::planar_one_sided_constant(d);
}

STAGECRAFT_INLINE exercise find_absorbing_ball(dice& d) {
    const int b = d.between(1, 4);
    if (d.coin()) {
        const int a = d.between(-2, 6);
        const rational beta(d.between(1, 4));
        const auto f = [&](const auto&, const auto& x, auto& out) {
            out[0] = a * x[0] - b * x[0] * x[0] * x[0];
        };
        const auto found = dissipativity<1>(f, beta);
        const rational sum = a + beta, alpha = sum > 0 ? sum * sum / (4 * b) : rational(0);
        return detail::absorbing_ball(
            "$f(x) = " + latex(polynomial<rational>{0, a, 0, -b}, "x") + "$", beta, alpha,
            "$f(x) x + \\beta x^{2} = " + latex(polynomial<rational>{0, 0, sum, 0, -b}, "x") +
                "$ has its maximum where $x^{2} = " + latex(sum > 0 ? sum / (2 * b) : rational(0)) + "$:",
            found);
    } else {
        const int p = d.between(2, 6), q = d.between(2, 6), u = d.between(0, 5), v = d.between(1, 5),
                  s = d.not_zero(9);
        const rational beta(d.between(1, 2 * std::min(p, q) - 1), 2);
        const auto f = [&](const auto&, const auto& x, auto& out) {
            out[0] = -p * x[0] + s * x[1] + u - x[0] * x[1];
            out[1] = -s * x[0] - q * x[1] + v + x[0] * x[0];
        };
        const auto found = dissipativity<2>(f, beta);
        const rational alpha = rational(u * u) / (4 * (p - beta)) + rational(v * v) / (4 * (q - beta));
        const auto term = [](int k, const std::string& what) {
            return (k < 0 ? " - " : " + ") +
                   std::string(std::abs(k) == 1 ? "" : std::to_string(std::abs(k)) + " ") + what;
        };
        return detail::absorbing_ball(
            "$f(x) = (-" + std::to_string(p) + " x_{1}" + term(s, "x_{2}") +
                (u == 0 ? "" : " + " + std::to_string(u)) + " - x_{1} x_{2}, -" + std::to_string(q) +
                " x_{2}" + term(-s, "x_{1}") + " + " + std::to_string(v) + " + x_{1}^{2})^{T}$",
            beta, alpha,
            "The cubic terms and those with $x_{1} x_{2}$ cancel in $\\langle f(x), x \\rangle$; what "
            "remains is a sum "
            "of $-" +
                latex(p - beta) + " x_{1}^{2}" + (u == 0 ? "" : " + " + std::to_string(u) + " x_{1}") +
                "$ and $-" + latex(q - beta) + " x_{2}^{2} + " + std::to_string(v) +
                " x_{2}$ (with $\\beta |x|^{2}$), each largest at "
                "its vertex:",
            found);
    }
}

STAGECRAFT_INLINE exercise solve_lyapunov_equation(dice& d) {
    tableaux::dense<rational> B(2, 2);
    const int which = d.between(0, 5), p = d.between(1, 4), q = d.between(1, 4), a = d.between(-3, 3);
    if (which == 0) {
        B << rational(a), rational(-p), rational(a * a + q, p), rational(-a);  // eigenvalues +-i sqrt q
    } else if (which == 1) {
        B << rational(p * q), rational(p * p), rational(-q * q), rational(-p * q);  // nilpotent
    } else if (which == 2) {
        B << rational(a), rational(d.between(-5, 5)), rational(d.between(-5, 5)), rational(d.between(-3, 3));
    } else {  // trace < 0 < determinant
        B << rational(-p), rational(d.between(0, 5)), rational(-d.between(0, 5)), rational(-q);
    }
    const rational trace = B(0, 0) + B(1, 1), det = tableaux::determinant<rational>(B);
    using enum lyapunov_stability;
    const bool zero = B(0, 0) == 0 && B(0, 1) == 0 && B(1, 0) == 0 && B(1, 1) == 0;
    const auto kind = trace < 0 && det > 0                                         ? asymptotically_stable
                      : (trace == 0 && det > 0) || (trace < 0 && det == 0) || zero ? stable
                                                                                   : unstable;
    exercise e;
    e.question = {
        paragraph("Is the zero solution of $x' = B x$ asymptotically stable, stable or unstable? Where it is "
                  "asymptotically stable, find the $G$ with $G B + B^{T} G = -I$."),
        detail::matrix_block("B = ", B)};
    const std::string name = kind == asymptotically_stable ? "asymptotically stable"
                             : kind == stable              ? "stable"
                                                           : "unstable";
    e.solution = {paragraph("The eigenvalues are the zeros of $" +
                            latex(polynomial<rational>{det, -trace, 1}, "\\lambda") +
                            "$: the zero solution is " + name +
                            (kind == stable ? ", as the eigenvalues on the imaginary axis are semisimple."
                             : kind == unstable && trace == 0 && det == 0
                                 ? ": 0 is a double eigenvalue with one eigenvector, solutions grow like $t$."
                                 : "."))};
    const auto decided = linear_stability(B);
    e.certificate = {
        {name, decided.kind == kind ? verdict::proved(decided.reason) : verdict::refuted(decided.reason)}};
    if (kind == asymptotically_stable) {
        const auto G = solve_lyapunov(B, tableaux::identity<rational>(2));
        e.solution.push_back(detail::matrix_block("G = ", G));
        e.solution.push_back(
            paragraph("$g_{11} > 0$ and $\\det G = " + latex(tableaux::determinant<rational>(G)) +
                      " > 0$: $V(x) = x^{T} G x$ decreases along every solution, $V' = -|x|^{2}$."));
        const auto S = symmetric_part<rational>(G, B);
        e.certificate.push_back(detail::equal("(G B + B^T G)_11", 2 * S(0, 0), -1));
        e.certificate.push_back(detail::equal("(G B + B^T G)_12", 2 * S(0, 1), 0));
        e.certificate.push_back(detail::equal("(G B + B^T G)_22", 2 * S(1, 1), -1));
        e.certificate.push_back({"G > 0", tableaux::diagonalise<rational>(G).inertia().positive == 2
                                              ? verdict::proved("L D L^T")
                                              : verdict::refuted("L D L^T")});
    }
    return e;
}

namespace detail {

/// sigma of degree `degree` that gives rho the highest order: rho(1 + u)/log(1 + u), cut off (Hairer-Norsett-Wanner
/// I.III.2).
STAGECRAFT_INLINE polynomial<rational> best_sigma(const polynomial<rational>& rho, int degree) {
    const auto shifted = compose(rho, polynomial<rational>{1, 1});
    std::vector<rational> s;
    for (int k = 0; k <= degree; ++k) {  // s (1 - u/2 + u^2/3 - ...) = shifted/u
        rational next = shifted[k + 1];
        for (int j = 0; j < k; ++j)
            next -= s[static_cast<std::size_t>(j)] * rational((k - j) % 2 == 0 ? 1 : -1, k - j + 1);
        s.push_back(next);
    }
    return compose(polynomial<rational>(s), polynomial<rational>{-1, 1});
}

}  // namespace detail

STAGECRAFT_INLINE exercise check_root_condition(dice& d) {
    const int k = d.between(2, 3);
    std::vector<rational> roots{1};
    bool holds = true;
    for (int j = 1; j < k; ++j) {
        const int whole = d.between(1, 3);
        roots.emplace_back(d.between(-3, 3), whole);
        holds = holds && abs(roots.back()) <= 1;
    }
    for (std::size_t i = 0; i < roots.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) holds = holds && !(roots[i] == roots[j] && abs(roots[i]) == 1);
    multistep m{polynomial<rational>(rational(1)), {}};
    for (const auto& r : roots) m.rho *= polynomial<rational>{-r, 1};
    const bool implicit = d.coin();
    m.sigma = detail::best_sigma(m.rho, implicit ? k : k - 1);
    const auto v = root_condition(m);
    std::string list;
    for (const auto& r : roots) list += (list.empty() ? "" : ", ") + latex(r);
    exercise e;
    e.question = {paragraph("A linear multistep method $\\sum_{j} \\alpha_{j} x_{n+j} = h \\sum_{j} "
                            "\\beta_{j} f_{n+j}$ has the "
                            "polynomials"),
                  paragraph("$\\rho(\\zeta) = " + latex(m.rho, "\\zeta") + "$,"),
                  paragraph("$\\sigma(\\zeta) = " + latex(m.sigma, "\\zeta") + "$."),
                  paragraph("What is its order? Does it satisfy the root condition, and does it converge?")};
    const int p = order(m);
    std::string text = "The roots of $\\rho$ are $" + list + "$. ";
    text += holds ? "None lies outside of the unit circle, and those on it are simple: the root condition "
                    "holds. With "
                    "order at least 1 the method converges"
                  : "The root condition fails, and the method does not converge, whatever its order";
    e.solution = {
        paragraph(
            "$\\sum_{j} \\alpha_{j} j^{q} = q \\sum_{j} \\beta_{j} j^{q-1}$ holds for $q = 0, \\dots, " +
            std::to_string(p) + "$ and fails for $q = " + std::to_string(p + 1) + "$: the order is " +
            std::to_string(p) + "."),
        paragraph(text + ".")};
    const auto consistent = consistent_method(m);
    e.certificate = {{"root condition", v, holds},
                     {"consistent", consistent},
                     {"order at least " + std::to_string(implicit ? k + 1 : k),
                      p >= (implicit ? k + 1 : k) ? verdict::proved("it is " + std::to_string(p))
                                                  : verdict::refuted("it is " + std::to_string(p))}};
    return e;
}

}  // namespace stagecraft::theory
