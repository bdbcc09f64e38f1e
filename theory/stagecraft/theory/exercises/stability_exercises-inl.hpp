// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/exercises/stability_exercises.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/exercises/methods.hpp"
#include "stagecraft/theory/stability/a_stability.hpp"
#include "stagecraft/theory/stability/algebraic_stability.hpp"

namespace stagecraft::theory {

namespace detail {

/// Two stages, seldom three: singly diagonally implicit, collocation, explicit, or any implicit one.
STAGECRAFT_INLINE tableau<rational> some_method(dice& d) {
    using namespace exercise_methods;
    switch (d.between(0, 4)) {
        case 0: {
            const int whole = d.between(4, 9);
            return sdirk_2(rational(d.between(1, 9), whole));
        }
        case 1: {
            auto nodes = collocation_nodes(d);
            nodes.resize(2);
            return collocation(nodes);
        }
        case 2:
            return d.coin() ? explicit_2(d) : explicit_3(d);
        default: {
            const rational u = d.between(0, 2) * rational(1, 3), v = u + rational(d.between(1, 4), 4);
            method t = with_nodes({u, v});
            set_interpolatory_weights(t);
            set_row(t, 0, {rational(d.between(-2, 2), 4)});
            set_row(t, 1, {rational(d.between(1, 4), 4)});
            return t;
        }
    }
}

STAGECRAFT_INLINE std::string fraction_latex(const stability_function<rational>& r) {
    if (r.denominator.degree() == 0) return theory::latex(r.numerator, "z");
    return "\\frac{" + theory::latex(r.numerator, "z") + "}{" + theory::latex(r.denominator, "z") + "}";
}

/// det(I - zA + z 1 b^T)/det(I - zA) for two stages, from the traces and determinants alone.
STAGECRAFT_INLINE stability_function<rational> by_hand(const tableau<rational>& t) {
    const auto of = [&](int with_b) {
        tableaux::dense<rational> M = t.A;
        for (Eigen::Index i = 0; i < 2; ++i)
            for (Eigen::Index j = 0; j < 2; ++j) M(i, j) -= with_b * t.b[j];
        return polynomial<rational>{1, -(M(0, 0) + M(1, 1)), M(0, 0) * M(1, 1) - M(0, 1) * M(1, 0)};
    };
    return stability_function<rational>::reduced(of(1), of(0));
}

}  // namespace detail

STAGECRAFT_INLINE exercise find_stability_function(dice& d) {
    tableau<rational> t = detail::some_method(d);
    while (t.b.size() != 2) t = detail::some_method(d);
    const auto r = detail::by_hand(t);
    const auto limit = r.at_infinity();
    exercise e;
    e.question = {
        paragraph(
            "Compute the stability function $R(z)$ of this method, its limit at infinity, and the order "
            "to which it approximates the exponential."),
        detail::tableau_block(t)};
    const auto fit = exponential_fit_of(r);
    e.solution = {
        paragraph("$R(z) = \\frac{\\det(I - z A + z \\mathbf{1} b^{T})}{\\det(I - z A)} = " +
                  detail::fraction_latex(r) + "$."),
        paragraph(limit ? "$R(\\infty) = " + latex(*limit) + "$." : "$R$ is unbounded at infinity."),
        paragraph("$e^{z} - R(z) = " + latex(fit.error_constant) + " z^{" + std::to_string(fit.order + 1) +
                  "} + \\dots$: order " + std::to_string(fit.order) + ".")};
    const auto same = [&](const stability_function<rational>& found, const char* how) {
        return certified_statement{"R(z) = " + r.text(), found == r
                                                             ? verdict::proved(how)
                                                             : verdict::refuted("it is " + found.text())};
    };
    e.certificate = {same(stability_function_of(t), "by the series of b^T A^k 1"),
                     same(stability_function_by_bordering(t), "by bordered determinants")};
    return e;
}

STAGECRAFT_INLINE exercise is_it_a_stable(dice& d) {
    const auto t = detail::some_method(d);
    const auto r = stability_function_of(t);
    const auto E = in_square(e_polynomial(r));
    const auto decided = a_stable(r);
    exercise e;
    e.question = {paragraph("Is this method A-stable? Is it L-stable? Give the reason."),
                  detail::tableau_block(t)};
    e.solution = {paragraph("$R(z) = " + detail::fraction_latex(r) +
                            "$. With $R = \\frac{P}{Q}$ and $x = y^{2}$, $E(y) = |Q(iy)|^{2} - "
                            "|P(iy)|^{2} = " +
                            latex(E, "x") + "$; $|R(iy)| \\le 1$ where this is not negative.")};
    e.certificate.push_back({"A-stable", decided, decided.is_proved()});
    if (decided.is_proved()) {
        const auto limit = *r.at_infinity();
        e.solution.push_back(
            paragraph("$E \\ge 0$ for all $x \\ge 0$, and all poles of $R$ lie in the right half-plane: "
                      "by the maximum principle the method is A-stable."));
        e.solution.push_back(paragraph("$R(\\infty) = " + latex(limit) + "$, so it is " +
                                       (limit == 0 ? "L-stable." : "not L-stable.")));
        e.certificate.push_back({"L-stable", l_stable(r), limit == 0});
    } else if (const auto x = tableaux::negative_point_from_zero(E)) {
        e.solution.push_back(paragraph("At $x = " + latex(*x) + "$ it is $" + latex(E(*x)) +
                                       " < 0$: not A-stable, and so not L-stable."));
        e.certificate.push_back(
            {"E = " + E(*x).str() + " at y^2 = " + x->str(),
             E(*x) < 0 ? verdict::proved("|R(iy)| > 1") : verdict::refuted("not negative")});
    } else {
        e.solution.push_back(
            paragraph("$E \\ge 0$, but " + std::to_string(r.poles().left) +
                      " of the poles lie in the left half-plane: not A-stable, and so not L-stable."));
    }
    return e;
}

STAGECRAFT_INLINE exercise is_it_b_stable(dice& d) {
    tableau<rational> t = detail::some_method(d);
    while (t.b.size() != 2 || t.c[0] == t.c[1]) t = detail::some_method(d);
    const auto decided = algebraically_stable(t);
    exercise e;
    e.question = {paragraph("Is this method algebraically stable? If not, give a contractive linear problem "
                            "$x' = \\lambda(t) x$ and a step in which solutions move apart."),
                  detail::tableau_block(t)};
    e.solution = {detail::matrix_block("M = B A + A^{T} B - b b^{T} = ", stability_matrix(t))};
    e.certificate.push_back({"algebraically stable", decided, decided.is_proved()});
    if (const auto w = expansion_witness(t)) {
        const auto z = [&](std::size_t i) {
            const auto& im = w->imaginary[i];
            return latex(w->real[i]) + (im == 0 ? "" : (im < 0 ? " - " : " + ") + latex(abs(im)) + " i");
        };
        const rational square = w->squared_factor;
        e.solution.push_back(paragraph(
            "With $h \\lambda(t_{0} + c_{1} h) = " + z(0) + "$, $h \\lambda(t_{0} + c_{2} h) = " + z(1) +
            "$ one step multiplies $x$ by a number $K$ with $|K|^{2} = " + latex(square) +
            " > 1$. The method is not B-stable, and so not algebraically "
            "stable."));
        const auto again = squared_amplification(t, w->real, w->imaginary);
        e.certificate.push_back(
            {"|K|^2 = " + square.str() + " > 1", again && *again == square && square > 1
                                                     ? verdict::proved("one step, solved exactly")
                                                     : verdict::refuted("it is not")});
    } else {
        const rational m11 = stability_matrix(t)(0, 0),
                       det = tableaux::determinant<rational>(stability_matrix(t));
        e.solution.push_back(
            paragraph("$b \\ge 0$, $m_{11} = " + latex(m11) + "$ and the determinant is $" + latex(det) +
                      "$: $M$ is positive semidefinite. The method is algebraically stable, and so "
                      "B-stable: there is no such problem."));
        e.certificate.push_back(
            {"m_11 >= 0, m_22 >= 0, det M >= 0", m11 >= 0 && stability_matrix(t)(1, 1) >= 0 && det >= 0
                                                     ? verdict::proved("exact")
                                                     : verdict::refuted("not so")});
    }
    return e;
}

}  // namespace stagecraft::theory
