// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/export/coq_method.hpp>
#include <stagecraft/theory/export/coq_text.hpp>
#include <string>

/// The shape that all statements on one method have in an exported file.
namespace stagecraft::theory::coq {

/// "table" or "acts": the generic part's theorems begin so. (Collocation is a way to act.)
inline std::string prefix(const coq_method& m) { return m.is_table() ? "table" : "acts"; }
/// What is known of the tableau T and its nodes c there.
inline std::string hypothesis(const coq_method& m) {
    return m.which == coq_method::kind::collocation ? "collocation T c N" : "acts T c N alpha beta";
}
/// What such a theorem is applied to: the numbers, and what is known.
inline std::string numbers(const coq_method& m) {
    if (m.is_table()) return "A b";
    return m.which == coq_method::kind::collocation ? "N (integrals d N) (inverses (length N))"
                                                    : "N alpha beta";
}
inline std::string known(const coq_method& m) {
    return m.which == coq_method::kind::collocation ? "(collocation_acts H)" : "H";
}

/// "predicate arguments" of the tableau, which is `T` or the table over the field named.
inline std::string statement(const coq_method& m, const std::string& predicate, const std::string& field,
                             const std::string& arguments) {
    return predicate + (m.is_table() ? " (table " + field + " A b)" : " T") +
           (arguments.empty() ? "" : " " + arguments);
}
/// That over every field, and for every tableau of the kind.
inline std::string about(const coq_method& m, const std::string& predicate, const std::string& arguments) {
    const std::string of = statement(m, predicate, "F", arguments);
    if (m.is_table()) return "forall F : field d,\n  " + of;
    return "forall (F : field d) (T : tableau F) (c : nat -> F), " + hypothesis(m) + " ->\n  " + of;
}
inline std::string introduced(const coq_method& m) { return m.is_table() ? "intro F." : "intros F T c H."; }
/// A theorem of this shape, of the method at hand.
inline std::string applied(const coq_method& m, const std::string& theorem) {
    return "(" + theorem + (m.is_table() ? " F)" : " F T c H)");
}

inline std::string proof(const std::string& name, const std::string& statement, const std::string& steps) {
    return "Theorem " + name + " : " + statement + ".\nProof.\n  " + steps +
           "\n  vm_cast_no_check (eq_refl true).\nQed.\n\n";
}
inline std::string spaced(const std::string& premise) { return premise.empty() ? "" : " " + premise; }

/// A theorem over every field, by the generic one `prefix_rule_is`, of whose `premise` Coq computes that it is true.
inline std::string theorem(const coq_method& m, const std::string& name, const std::string& predicate,
                           const std::string& arguments, const std::string& rule,
                           const std::string& premise) {
    return proof(name, about(m, predicate, arguments),
                 introduced(m) + "\n  apply (@" + prefix(m) + "_" + rule + "_is d F " +
                     (m.is_table() ? "" : "T c ") + numbers(m) + spaced(premise) +
                     (m.is_table() ? "" : " " + known(m)) + ").");
}

/// The same over the real numbers; `distinct` where it is of stage vectors that are polynomials in distinct nodes.
inline std::string real_theorem(const coq_method& m, const std::string& name, const std::string& predicate,
                                const std::string& rule, const std::string& premise, bool distinct = true) {
    if (m.is_table())
        return proof(name, statement(m, predicate, "(reals d_positive)", ""),
                     "apply (table_" + rule + "_is d_positive A b" + spaced(premise) + ").");
    return proof(name,
                 "forall (T : tableau (reals d_positive)) (c : nat -> R), " + hypothesis(m) + " ->\n  " +
                     (distinct ? "distinct (stages T) c -> " : "") + statement(m, predicate, "", ""),
                 std::string("intros T c H") + (distinct ? " D" : "") + ". apply (acts_" + rule + "_is " +
                     known(m) + (distinct ? " D" : "") + spaced(premise) + ").");
}

/// The definitions of d and of the numbers.
inline std::string definitions(const coq_method& m) {
    std::string out = "Definition d : Q := " + std::to_string(m.radicand) +
                      ".\nLemma d_positive : (0 <= d)%Q.\nProof. discriminate. Qed.\n";
    const auto define = [&out](const std::string& name, const std::string& type, const std::string& value) {
        out += "Definition " + name + " : " + type + " :=\n" + value + ".\n";
    };
    const auto row = "list coefficient", matrix = "list (list coefficient)";
    if (m.is_table()) {
        std::vector<coq_method::element> rows(m.beta.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (const auto& column : m.alpha) rows[i].push_back(column[i]);
        define("A", matrix, coefficients(rows));
        define("b", row, "  " + coefficients(m.beta));
        return out + "\n";
    }
    define("N", row, "  " + coefficients(m.nodal));
    if (m.which == coq_method::kind::acts) {
        define("alpha", matrix, coefficients(m.alpha));
        define("beta", row, "  " + coefficients(m.beta));
    }
    return out + "\n";
}

}  // namespace stagecraft::theory::coq
