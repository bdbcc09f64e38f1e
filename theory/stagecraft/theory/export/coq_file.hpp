// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <stagecraft/theory/export/coq_order.hpp>
#include <stagecraft/theory/export/coq_stability.hpp>
#include <stagecraft/theory/export/coq_structure.hpp>
#include <string>
#include <vector>

namespace stagecraft::theory {

/// What an exported file says of a method besides its numbers.
struct coq_words {
    std::string name;
    std::string source;
    tableaux::claims claims;
    std::optional<simplifying> known;                 ///< of a family: B, C, D,
    std::optional<tableaux::nodal_polynomial> nodes;  ///< and the nodes
};

/// The part of an exported file that is about this method: plain words, numbers, theorems. Coq reads it behind
/// theory/coq/stagecraft.v. Throws std::invalid_argument, in one sentence, where nothing can be exported.
inline std::string coq_theorems(const coq_method& m, const coq_words& words) {
    const auto order = words.known ? coq::order_by(*words.known, m.stages()) : coq::order_by_trees(m);
    std::string head = "(** * " + coq::comment(words.name.empty() ? "A tableau" : words.name) + "\n\n";
    if (!words.source.empty()) head += "    Source: " + coq::comment(words.source) + "\n";
    head += "    Proved here of its " + std::to_string(m.stages()) + " stage" + (m.stages() == 1 ? "" : "s") +
            ": ";
    std::vector<std::string> proved{"order " + std::to_string(order.order)};
    std::string body = coq::order_theorem(m, order, words.claims.order);
    body += coq::stability_theorems(m, proved);
    body += coq::algebraic_theorems(m, proved);
    body += coq::structure_theorems(m, proved);
    if (words.nodes) {
        proved.push_back("nodes real, distinct and in [0, 1]");
        body += coq::nodes_theorems(m, *words.nodes);
    }
    for (const auto& word : proved) head += (&word == &proved.front() ? "" : ", ") + word;
    return head + ". *)\n\nModule Method.\n\n" + coq::definitions(m) + body +
           "Print Assumptions order_of_the_method.\nEnd Method.\n";
}

/// The same of a tableau file. Rounded entries have nothing to prove.
inline std::string coq_theorems(const tableaux::tableau_file& file) {
    const auto kind = file.kind();
    if (kind == tableaux::number_kind::rounded)
        throw std::invalid_argument(
            "coq: rounded entries are not the method, so nothing is proved of them; the rational numbers "
            "that they are "
            "as written are exported by --decimals exact");
    if (kind == tableaux::number_kind::enclosed)
        throw std::invalid_argument("coq: entries that do not lie in a field Q(sqrt(d)) are not exported");
    const auto t = tableaux::to_quadratic(file);
    return coq_theorems(coq_method_of(t, t.b), {file.name, file.source, file.claims, {}, {}});
}

/// An exported file that needs no other: its own part's words first, then the generic part.
inline std::string coq_whole(const std::string& theorems, const std::string& generic) {
    const auto words = theorems.find("*)\n\n") + 4;
    return theorems.substr(0, words) + generic + theorems.substr(words);
}

/// An exported file beside stagecraft.v.
inline std::string coq_beside(const std::string& theorems) {
    const auto words = theorems.find("*)\n\n") + 4;
    return theorems.substr(0, words) +
           "From Coq Require Import List Arith ZArith QArith Reals.\nRequire Import stagecraft.\nImport "
           "ListNotations.\nOpen Scope nat_scope.\n\n" +
           theorems.substr(words);
}

}  // namespace stagecraft::theory
