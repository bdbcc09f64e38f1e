// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/exercises/order_exercises.hpp"

#include <algorithm>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/exact_tableau.hpp"
#include "stagecraft/tableaux/simplifying.hpp"
#include "stagecraft/theory/exercises/document.hpp"
#include "stagecraft/theory/exercises/methods.hpp"
#include "stagecraft/theory/models/matrix_model.hpp"
#include "stagecraft/theory/trees/tree_order.hpp"
#include "stagecraft/theory/trees/tree_text.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE certified_statement order_is(const tableau<rational>& t, int p) {
    for (Eigen::Index i = 0; i < t.b.size(); ++i)
        if (t.A.row(i).sum() != t.c[i])
            return {"order " + std::to_string(p), verdict::refuted("c_" + std::to_string(i + 1) + " != A 1")};
    const auto found = order_of(matrix_model<rational>(t), p + 1);
    if (found.order == p && found.is_exact())
        return {
            "order " + std::to_string(p),
            verdict::proved("all conditions up to it; " + bracket(found.failing.front().tree) + " fails")};
    return {"order " + std::to_string(p), verdict::refuted("the order is " + std::to_string(found.order) +
                                                           (found.is_exact() ? "" : " at least"))};
}

STAGECRAFT_INLINE certified_statement failing_are(const tableau<rational>& t, int p,
                                                  std::vector<std::string> expected) {
    std::vector<std::string> found;
    for (const auto& r : failing_conditions(matrix_model<rational>(t), p)) found.push_back(bracket(r.tree));
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    const auto list = [](const std::vector<std::string>& trees) {
        std::string out;
        for (const auto& b : trees) out += (out.empty() ? "" : " ") + b;
        return out.empty() ? "none" : out;
    };
    return {"failing up to order " + std::to_string(p) + ": " + list(expected),
            found == expected ? verdict::proved("all trees were looked at")
                              : verdict::refuted("failing: " + list(found))};
}

STAGECRAFT_INLINE certified_statement one_solution(const tableaux::dense<rational>& M) {
    const rational d = tableaux::determinant<rational>(M);
    return {"no other entries do",
            d == 0 ? verdict::refuted("the determinant of their linear system is 0")
                   : verdict::proved("the determinant of their linear system is " + d.str())};
}

namespace detail {

/// "sum_i b_i c_i = 1/2: here 1/3, it fails." for all conditions of orders first, ..., last.
STAGECRAFT_INLINE document conditions(const tableau<rational>& t, int first, int last) {
    document lines;
    for (const auto& r : order_residuals(matrix_model<rational>(t), last)) {
        if (order(r.tree) < first) continue;
        const rational weight =
            r.residual + rational(tableaux::integer(1), tableaux::integer(density(r.tree)));
        lines.push_back(paragraph("Order " + std::to_string(order(r.tree)) + ": $" + condition_latex(r.tree) +
                                  "$; the left-hand side is $" + latex(weight) +
                                  (r.residual == 0 ? "$." : "$: it fails.")));
    }
    return lines;
}

inline void append(document& to, const document& more) { to.insert(to.end(), more.begin(), more.end()); }

/// Order of collocation at these nodes: s + the number of k with int x^k w = 0, k = 0, 1, ...
STAGECRAFT_INLINE int collocation_order(const std::vector<rational>& nodes) {
    polynomial<rational> w(rational(1));
    for (const auto& c : nodes) w *= polynomial<rational>{-c, 1};
    int p = static_cast<int>(nodes.size());
    while (integral(w)(rational(1)) == 0) {
        w *= polynomial<rational>::x();
        ++p;
    }
    return p;
}

}  // namespace detail

STAGECRAFT_INLINE exercise missing_entry(dice& d) {
    using namespace exercise_methods;
    exercise e;
    const int which = d.between(0, 3);
    method t = which == 0   ? explicit_2(d)
               : which == 3 ? collocation({d.node() / 2, 1 - d.between(0, 3) * rational(1, 10)})
                            : explicit_3(d);
    const int p = which == 0 ? 2 : which == 3 ? detail::collocation_order({t.c[0], t.c[1]}) : 3;
    const std::vector<std::vector<std::pair<int, int>>> hidden{
        {{1, 0}}, {{2, 0}, {2, 1}}, {{3, 0}, {3, 1}, {3, 2}}, {{1, 0}, {1, 1}}};
    text_block shown = detail::tableau_block(t, hidden[static_cast<std::size_t>(which)]);
    tableaux::dense<rational> M(1, 1);
    std::string how;
    if (which == 0) {
        shown.rows[1][0] = "?";  // c_2 as well
        how = "With $c_{2} = a_{21}$ the condition $\\sum_{i} b_{i} c_{i} = \\frac{1}{2}$ reads $" +
              latex(t.b[1]) + " c_{2} = \\frac{1}{2}$, so $c_{2} = a_{21} = " + latex(t.c[1]) + "$.";
        M(0, 0) = t.b[1];
    } else if (which == 1) {
        how =
            "Of the conditions up to order 3 only $b_{3} a_{32} c_{2} = \\frac{1}{6}$ contains $A$: $a_{32} "
            "= " +
            latex(t.A(2, 1)) +
            "$. The row sum $a_{31} + a_{32} = c_{3}$ gives $a_{31} = " + latex(t.A(2, 0)) + "$.";
        M(0, 0) = t.b[2] * t.c[1];
    } else if (which == 2) {
        how =
            "The conditions $\\sum_{i} b_{i} c_{i}^{k} = \\frac{1}{k+1}$, $k = 0, 1, 2$, are a linear system "
            "with Vandermonde's matrix; its solution is below. The fourth condition $b_{3} a_{32} c_{2} = "
            "\\frac{1}{6}$ holds as well.";
        M.resize(3, 3);
        for (Eigen::Index i = 0; i < 3; ++i)
            for (Eigen::Index k = 0; k < 3; ++k) M(k, i) = k == 0 ? rational(1) : M(k - 1, i) * t.c[i];
    } else {
        how =
            "Stage order 2 means $a_{21} + a_{22} = c_{2}$ and $a_{21} c_{1} + a_{22} c_{2} = "
            "\\frac{1}{2} c_{2}^{2}$, two linear equations: $a_{21} = " +
            latex(t.A(1, 0)) + "$, $a_{22} = " + latex(t.A(1, 1)) + "$.";
        M.resize(2, 2);
        M << rational(1), rational(1), t.c[0], t.c[1];
        const auto c = tableaux::simplifying_orders_of(t).C;
        e.certificate.push_back(detail::equal("stage order", c, 2));
    }
    e.question = {
        paragraph(which == 3 ? "Fill in the missing entries so that the method has stage order 2, C(2)."
                             : "Fill in the missing entries so that the method has order " +
                                   std::to_string(p) + " and $c = A \\mathbf{1}$."),
        shown};
    e.solution = {paragraph(how), detail::tableau_block(t)};
    e.certificate.push_back(order_is(t, p));
    e.certificate.push_back(one_solution(M));
    return e;
}

STAGECRAFT_INLINE exercise true_order(dice& d) {
    using namespace exercise_methods;
    method t;
    int p = 0;
    const rational change(d.not_zero(3), 12);
    switch (d.between(0, 6)) {
        case 0:
            t = explicit_2(d), p = 2;
            break;
        case 1:
            t = explicit_2(d), p = 1;
            t.b[1] += change;
            t.b[0] -= change;
            break;
        case 2:
            t = explicit_3(d), p = 3;
            break;
        case 3:
            t = explicit_3(d), p = 2;
            t.A(2, 1) += change;
            t.A(2, 0) -= change;
            break;
        case 4:
            t = explicit_4(d), p = 4;
            break;
        case 5: {  // b^T A c stays, b^T (c A c) does not
            t = explicit_4(d), p = 3;
            const rational a = change / t.b[2], b = change / t.b[3];
            t.A(2, 1) += a;
            t.A(2, 0) -= a;
            t.A(3, 1) -= b;
            t.A(3, 0) += b;
            break;
        }
        default: {
            const auto nodes = collocation_nodes(d);
            t = collocation(nodes), p = detail::collocation_order(nodes);
        }
    }
    exercise e;
    e.question = {paragraph("What is the order of this method? Name a condition that stops it."),
                  detail::tableau_block(t)};
    e.solution = {
        paragraph("The row sums are $c = A \\mathbf{1}$, so the conditions for autonomous systems suffice. "
                  "All conditions up to order " +
                  std::to_string(p) + " hold:")};
    detail::append(e.solution, detail::conditions(t, 1, std::min(p, 4)));
    const auto failing = order_of(matrix_model<rational>(t), p + 1).failing;
    if (!failing.empty()) {
        const auto& r = failing.front();
        const rational weight =
            r.residual + rational(tableaux::integer(1), tableaux::integer(density(r.tree)));
        e.solution.push_back(paragraph("The condition $" + condition_latex(r.tree) + "$ of order " +
                                       std::to_string(p + 1) + " fails: the left-hand side is $" +
                                       latex(weight) + "$. The order is " + std::to_string(p) + "."));
    }
    e.certificate = {order_is(t, p)};
    return e;
}

namespace detail {

/// A method of order 3 or 4 with a mistake; `failing`: which conditions up to that order fail, in brackets.
struct misprinted {
    tableau<rational> method;
    int order;
    std::vector<std::string> failing;
};

STAGECRAFT_INLINE misprinted with_wrong_entry(dice& d) {
    using namespace exercise_methods;
    const bool four = d.coin();
    misprinted m{four ? explicit_4(d) : explicit_3(d), four ? 4 : 3, {}};
    auto& t = m.method;
    const rational change(d.not_zero(3), 12);
    const auto add = [&](Eigen::Index i, Eigen::Index j, const rational& x) {  // the row sum stays
        t.A(i, j) += x;
        t.A(i, 0) -= x;
    };
    const bool one_entry = d.coin();
    const rational b3 = t.b[2] - change * t.c[1];
    if (four && !one_entry) {  // b^T A c and b^T A c^2 stay
        add(2, 1, change / t.b[2]);
        add(3, 1, -change / t.b[3]);
        m.failing = {"[tau,[tau]]", "[[[tau]]]"};
    } else if (!four && !one_entry && b3 != 0) {  // the weights keep order 2, and a_32 follows
        t.b[1] += change * t.c[2];
        t.b[0] -= change * (t.c[2] - t.c[1]);
        t.b[2] = b3;
        set_row(t, 2, {1 / (6 * b3 * t.c[1]), 0});
        m.failing = {"[tau,tau]"};
    } else if (four) {
        add(3, 1, change);
        m.failing = {"[[tau]]", "[tau,[tau]]", "[[tau,tau]]"};
    } else {
        add(2, 1, change);
        m.failing = {"[[tau]]"};
    }
    return m;
}

}  // namespace detail

STAGECRAFT_INLINE exercise failing_condition(dice& d) {
    const auto [t, p, failing] = detail::with_wrong_entry(d);
    exercise e;
    e.question = {paragraph("A book prints this table as a method of order " + std::to_string(p) +
                            ". Which of the order conditions fail, and what is the order really?"),
                  detail::tableau_block(t)};
    e.solution = detail::conditions(t, 1, p);
    const auto lower = [](const std::string& a, const std::string& b) {
        return order(tree_from_bracket(a)) < order(tree_from_bracket(b));
    };
    const int p_true = order(tree_from_bracket(*std::min_element(failing.begin(), failing.end(), lower))) - 1;
    e.solution.push_back(paragraph("The order is " + std::to_string(p_true) + "."));
    e.certificate = {failing_are(t, p, failing), order_is(t, p_true)};
    return e;
}

STAGECRAFT_INLINE exercise build_collocation(dice& d) {
    const auto nodes = exercise_methods::collocation_nodes(d);
    const auto t = exercise_methods::collocation(nodes);
    const int s = static_cast<int>(nodes.size()), p = detail::collocation_order(nodes);
    std::string list;
    for (const auto& c : nodes) list += (list.empty() ? "" : ", ") + latex(c);
    polynomial<rational> w(rational(1));
    for (const auto& c : nodes) w *= polynomial<rational>{-c, 1};
    exercise e;
    e.question = {paragraph("Construct the collocation method with the nodes $" + list +
                            "$. What are its order and its stage order?")};
    e.solution = {
        paragraph(
            "C(" + std::to_string(s) + ") and B(" + std::to_string(s) +
            "), $\\sum_{j} a_{ij} c_{j}^{k-1} = \\frac{1}{k} c_{i}^{k}$ and $\\sum_{j} b_{j} c_{j}^{k-1} = "
            "\\frac{1}{k}$ for $k = 1, \\dots, " +
            std::to_string(s) + "$, are linear systems:"),
        detail::tableau_block(t),
        paragraph(
            "The stage order is " + std::to_string(s) + ". With $w(x) = " + latex(w, "x") +
            "$ the order is $s$ plus the number of $k = 0, 1, \\dots$ in a row for which the integral of "
            "$x^{k} w(x)$ over $[0, 1]$ vanishes: " +
            std::to_string(p) + ".")};
    bool same = true;
    const auto built = tableaux::exact_tableau(tableaux::nodal_polynomial::from_nodes(nodes),
                                               tableaux::construction::collocation);
    for (Eigen::Index i = 0; i < t.A.size(); ++i)
        same = same && built && built->A.data()[i] == tableaux::quadratic(t.A.data()[i]);
    for (Eigen::Index i = 0; i < t.b.size(); ++i)
        same = same && built && built->b[i] == tableaux::quadratic(t.b[i]);
    e.certificate = {
        {"A and b", same ? verdict::proved("the integrals of Lagrange's polynomials")
                         : verdict::refuted("other than the integrals of Lagrange's polynomials")},
        detail::equal("stage order", tableaux::simplifying_orders_of(t).C, s),
        order_is(t, p)};
    return e;
}

}  // namespace stagecraft::theory
