// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <stagecraft/tableaux/nodal.hpp>
#include <stagecraft/tableaux/range.hpp>
#include <stagecraft/tableaux/roots.hpp>
#include <stagecraft/tableaux/small_solve.hpp>
#include <stagecraft/tableaux/sturm.hpp>
#include <stagecraft/theory/export/coq_squares.hpp>
#include <stagecraft/theory/export/coq_statement.hpp>
#include <string>
#include <utility>
#include <vector>

/// Algebraic stability, symplecticity, stiff accuracy, symmetry, and the nodes.
namespace stagecraft::theory::coq {

/// b^T(u v) and M on the basis of the coordinates.
struct forms {
    form weights, m;
};
inline forms forms_of(const coq_method& method) {
    const int s = method.stages();
    forms f{form(s, s), form(s, s)};
    const auto at = [](int k) { return static_cast<std::size_t>(k); };
    for (int k = 0; k < s; ++k)
        for (int l = 0; l < s; ++l) {
            const auto x = basis_vector(method, k), y = basis_vector(method, l);
            f.weights(k, l) = method.dot_b(method.multiply(x, y));
            f.m(k, l) = method.dot_b(method.multiply(x, method.alpha[at(l)])) +
                        method.dot_b(method.multiply(y, method.alpha[at(k)])) -
                        method.beta[at(k)] * method.beta[at(l)];
        }
    return f;
}

inline std::string algebraic_theorems(const coq_method& m, std::vector<std::string>& proved) {
    const auto f = forms_of(m);
    const auto of_b = squares(f.weights), of_m = squares(f.m);
    const auto define = [](const std::string& name, const std::string& type, const std::string& value) {
        return "Definition " + name + " : " + type + " :=\n" + value + ".\n";
    };
    std::string out;
    if (of_b && of_m) {
        proved.push_back("algebraically stable");
        out +=
            "(** b >= 0, and M = B A + A^T B - b b^T >= 0: a sum of D (L^T v)^2 for each pair (D, L). *)\n" +
            define("squares_of_b", "squares", text(*of_b)) + define("squares_of_m", "squares", text(*of_m)) +
            real_theorem(m, "algebraically_stable_method", "algebraically_stable", "algebraic",
                         "squares_of_b squares_of_m");
    } else {
        const auto u =
            *tableaux::diagonalise<tableaux::quadratic>(of_b ? f.m : f.weights).negative_direction();
        std::vector<tableaux::quadratic> v;
        for (int i = 0; i < u.size(); ++i) v.push_back(u[i]);
        proved.push_back("not algebraically stable");
        out += std::string("(** A vector v with v^T ") + (of_b ? "M v" : "diag(b) v") + " < 0. *)\n" +
               define("direction", "list coefficient", "  " + coefficients(v)) +
               real_theorem(m, "not_algebraically_stable_method", "not_algebraically_stable",
                            of_b ? "m_negative" : "b_negative", "direction", false);
    }
    bool zero = true;
    for (int i = 0; i < f.m.rows(); ++i)
        for (int j = 0; j < f.m.cols(); ++j) zero = zero && f.m(i, j) == 0;
    if (zero) {
        proved.push_back("symplectic");
        out += "(** M = 0. *)\n" + real_theorem(m, "symplectic_method", "symplectic", "symplectic", "");
    }
    return out;
}

/// Of tables only.
inline std::string structure_theorems(const coq_method& m, std::vector<std::string>& proved) {
    if (!m.is_table()) return {};
    const int s = m.stages();
    const auto a = m.matrix();
    const auto b = [&m](int i) -> const tableaux::quadratic& { return m.beta[static_cast<std::size_t>(i)]; };
    bool stiff = true, symmetric = true;
    for (int i = 0; i < s; ++i) {
        stiff = stiff && a(s - 1, i) == b(i);
        for (int j = 0; j < s; ++j)
            symmetric = symmetric && b(s - 1 - j) == b(j) && a(s - 1 - i, s - 1 - j) + a(i, j) == b(j);
    }
    std::string out;
    if (stiff) {
        proved.push_back("stiffly accurate");
        out += "(** The last stage is the step. *)\n" +
               theorem(m, "stiffly_accurate_method", "stiffly_accurate", "", "stiff", "");
    }
    if (symmetric) {
        proved.push_back("symmetric");
        out += "(** The method is its own adjoint. *)\n" +
               theorem(m, "symmetric_method", "symmetric", "", "symmetric", "");
    }
    return out;
}

/// Disjoint intervals around the nodes whose ends are whole numbers over a power of two, of the largest that tells them apart.
inline std::vector<std::array<tableaux::rational, 2>> brackets(const tableaux::nodal_polynomial& w) {
    using tableaux::rational;
    const auto nodes = tableaux::enclose_nodes(w, 32 + 4 * w.degree());
    for (rational grid(4);; grid *= rational(2)) {
        std::vector<std::array<rational, 2>> found;
        bool apart = true;
        for (const tableaux::ball& c : nodes) {
            const rational low = rational(tableaux::floor(c.lower() * grid)) / grid;
            const rational high = -rational(tableaux::floor(-(c.upper() * grid))) / grid;
            apart = apart && (found.empty() || found.back()[1] < low);
            found.push_back({std::max(low, rational(0)), std::min(high, rational(1))});
        }
        if (apart) return found;
    }
}

/// That x^s - N has s different zeros in [0, 1], and that a method with these nodes exists.
inline std::string nodes_theorems(const coq_method& m, const tableaux::nodal_polynomial& w) {
    std::vector<std::string> items;
    for (const auto& [low, high] : brackets(w)) items.push_back("(" + text(low) + ", " + text(high) + ")");
    const bool collocation = m.which == coq_method::kind::collocation;
    return "(** The nodes are real, distinct, and in [0, 1]: each in one of these brackets. *)\n"
           "Definition node_brackets : list (Q * Q) :=\n  " +
           list(items, "  ") + "%Q.\n" +
           proof("nodes_of_the_method", "has_nodes d_positive N",
                 "apply (nodes_are_checked d_positive N node_brackets).") +
           "(** So what is said here of every such method is said of one. *)\n"
           "Theorem there_is_such_a_method : exists (T : tableau (reals d_positive)) (c : nat -> R),\n  " +
           hypothesis(m) +
           " /\\ distinct (stages T) c /\\ forall i, i < stages T -> (0 <= c i <= 1)%R.\nProof.\n  " +
           (collocation ? "exact (collocation_exists nodes_of_the_method)."
                        : "exact (acts_exists alpha beta nodes_of_the_method eq_refl).") +
           "\nQed.\n\n";
}

}  // namespace stagecraft::theory::coq
