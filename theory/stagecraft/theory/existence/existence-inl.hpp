// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/existence/existence.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/correct_rounding.hpp"
#include "stagecraft/tableaux/reading.hpp"
#include "stagecraft/tableaux/tableau_json.hpp"
#include "stagecraft/tableaux/time_share.hpp"
#include "stagecraft/theory/existence/existence_attempt.hpp"
#include "stagecraft/theory/judging/certify_partitioned.hpp"
#include "stagecraft/theory/statements/certainty.hpp"
#include "stagecraft/theory/trees/coloured_trees.hpp"

namespace stagecraft::theory {

namespace detail {

/// The tableau of one partner in enclosures.
STAGECRAFT_INLINE tableau<tableaux::ball> enclosed_tableau(const existence_attempt& a, std::size_t n) {
    const auto s = static_cast<Eigen::Index>(a.method.stages);
    const auto value = [&](std::size_t number) { return a.found.numbers[number]; };
    tableau<tableaux::ball> t;
    t.A.resize(s, s);
    t.b.resize(s);
    t.c.resize(s);
    const bool embedded = a.method.weights.size() > a.method.partners();
    if (embedded) t.b_embedded.resize(s);
    for (Eigen::Index i = 0; i < s; ++i) {
        const auto k = static_cast<std::size_t>(i);
        for (Eigen::Index j = 0; j < s; ++j) t.A(i, j) = value(a.method.A[n][k][static_cast<std::size_t>(j)]);
        t.b(i) = value(a.method.weights[n][k]);
        t.c(i) = value(a.method.nodes[a.method.node_of[n]][k]);
        if (embedded) t.b_embedded(i) = value(a.method.weights[a.method.partners() + n][k]);
    }
    return t;
}

/// Whether a condition of order p + 1 certainly fails: of b, or of b_embedded.
STAGECRAFT_INLINE bool next_order_fails(const existence_subject& s, const existence_attempt& a, bool embedded,
                                        int p) {
    coloured_method<tableaux::ball> m;
    for (std::size_t n = 0; n < s.partners.size(); ++n) {
        const auto t = enclosed_tableau(a, n);
        m.A.push_back(t.A);
        m.b.push_back(embedded ? t.b_embedded : t.b);
    }
    if (p + 1 > tableaux::largest_order) return false;
    const tree_table trees = coupled_trees(s.coupling, false, static_cast<int>(s.partners.size()), p + 1);
    bool fails = false;
    visit_coloured_trees(m, trees.view(), [&](std::uint32_t row, const tableaux::ball& weight) {
        const tree_row& t = trees.view().rows[row];
        fails = t.order == p + 1 && certainly_nonzero(weight * tableaux::ball(t.density) - tableaux::ball(1));
        return !fails;
    });
    return fails;
}

/// "explicit", "diagonally implicit" or "implicit", by the zeros.
STAGECRAFT_INLINE std::string kind_of(const sought_method& m, std::size_t n) {
    bool is_explicit = true, diagonal = true;
    for (std::size_t i = 0; i < m.A[n].size(); ++i)
        for (std::size_t j = i; j < m.A[n].size(); ++j)
            if (!m.is_zero(m.A[n][i][j])) {
                is_explicit = false;
                diagonal = diagonal && j == i;
            }
    return is_explicit ? "explicit" : diagonal ? "diagonally implicit" : "implicit";
}

STAGECRAFT_INLINE bool last_row_is_b(const sought_method& m, std::size_t n) {
    return m.A[n].back() == m.weights[n];
}

STAGECRAFT_INLINE std::string structure_of(const sought_method& m) {
    std::string text;
    for (std::size_t n = 0; n < m.partners(); ++n)
        text += (n == 0 ? "" : " + ") + kind_of(m, n) + (last_row_is_b(m, n) ? " (b its last row)" : "");
    return text;
}

STAGECRAFT_INLINE std::string counted(std::size_t n, const std::string& what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

/// What `certify` refutes, and whom it suspects.
STAGECRAFT_INLINE std::string refusal(const file_certificate& c) {
    std::string text;
    const auto add = [&](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
    for (const finding& f : c.findings)
        if (f.judgement && f.judgement->is_refuted()) add(f.name + ": " + f.judgement->reason());
    for (const auto& p : c.partners)
        if (p.overall() == standing::refuted) add(p.name + ": " + refusal(p));
    for (const suspect& s : c.suspects) add(s.entry + " = " + s.written + " should read " + s.suggest);
    if (!c.suspects_note.empty()) add(c.suspects_note);
    return text.empty() ? "see certify" : text;
}

/// How it is proved, or how far it goes.
STAGECRAFT_INLINE void describe_search(const existence_attempt& a, existence_certificate& out) {
    const nearby_method& f = a.found;
    const std::string conditions = "all " + counted(a.conditions, "condition") + " follow";
    if (f.equations == 0) {
        out.notes.push_back(conditions + " exactly");
        return;
    }
    std::string text = conditions + ", by linear algebra over Q, from identities and " +
                       counted(f.equations, "equation") + " in " + counted(f.unknowns, "unknown");
    if (f.exists)
        text += "; " + std::to_string(f.solved) + " are solved by Krawczyk's operator (contraction " +
                brief(f.contraction) + ")";
    if (f.all_equations && f.solved < f.equations) text += ", the others follow as polynomials";
    out.notes.push_back(text);
    out.notes.push_back("identities such as C(q), D(1) and zeros of b^T A are those that hold up to " +
                        brief(a.gap.holds) + "; the next one fails by " + brief(a.gap.fails));
    if (f.solved > 0)
        out.notes.push_back("rank: the least of " + counted(f.solved, "pivot") + " is " +
                            brief(f.least_pivot) +
                            (f.next_pivot > 0 ? ", the next would be " + brief(f.next_pivot) : ""));
}

STAGECRAFT_INLINE void name_what_is_left(const existence_attempt& a, existence_certificate& out) {
    const auto& names = a.found.not_solved;
    std::string text = "not proved, and enclosed to " + brief(a.found.left) + " only: ";
    for (std::size_t i = 0; i < names.size() && i < 4; ++i) text += (i == 0 ? "" : "; ") + names[i];
    if (names.size() > 4) text += " and " + std::to_string(names.size() - 4) + " more";
    out.notes.push_back(text);
}

/// "order exactly 5", or "order at least 5" where no condition of order 6 is seen to fail.
STAGECRAFT_INLINE std::string order_words(const existence_subject& s, const existence_attempt& a,
                                          bool embedded) {
    const int p = a.orders[embedded ? 1 : 0];
    return std::string(embedded ? "embedded order " : "order ") +
           (next_order_fails(s, a, embedded, p) ? "exactly " : "at least ") + std::to_string(p);
}

/// Claims that are about something else than orders.
STAGECRAFT_INLINE void name_other_claims(const tableaux::claims& claims, existence_certificate& out) {
    std::string others;
    const auto add = [&](std::string_view name) {
        others += (others.empty() ? "" : ", ") + std::string(name);
    };
    for (const auto& [name, value] : tableaux::yes_no_claims)
        if (claims.*value && name != "stiffly_accurate") add(name);
    if (claims.dense_order) add("dense_order");
    if (claims.stage_order) add("stage_order");
    if (!others.empty()) out.notes.push_back("not part of it: " + others);
}

/// The theorem that an attempt proves.
STAGECRAFT_INLINE void state_theorem(const tableaux::method_file& file, const existence_subject& s,
                                     const existence_attempt& a, int digits, existence_certificate& out) {
    const auto far = moved(a);
    out.distance = brief(far.most);
    out.farthest = far.farthest;
    out.box = brief(a.found.enclosed_to);
    const bool near = far.is_near();
    std::string method = structure_of(a.method) + " method of " + order_words(s, a, false);
    out.order = a.orders[0];
    if (a.orders.size() > 1) {
        method += ", " + order_words(s, a, true);
        out.embedded_order = a.orders[1];
    }
    out.theorem = "there is a" + std::string(kind_of(a.method, 0) == "diagonally implicit" ? " " : "n ") +
                  method +
                  (far.most > 0 ? " within " + out.distance + " of these entries (" + out.farthest +
                                      " is the farthest), with the zeros and exact entries written"
                                : ": these entries");
    if (!near)
        out.theorem += ", but " + far.worst + " is off by " + brief(far.in_roundings) +
                       " times what its digits round: the table is not rounded from it";
    if (far.quotients > 0)
        out.notes.push_back(counted(far.quotients, "quotient") +
                            " taken as rounded, within 64/q^2 of what is meant");
    out.standing = near ? standing::proved : standing::inconclusive;
    describe_search(a, out);
    if (a.found.solved > 0)
        out.notes.push_back("no other one within " + out.box +
                            " of the polished entries has the same entries where none is solved for");
    if (near) out.polished = polished_json(file, a, digits);
}

}  // namespace detail

STAGECRAFT_INLINE int existence_certificate::exit_code() const {
    return standing == standing::proved ? 0 : standing == standing::refuted ? 1 : 3;
}

STAGECRAFT_INLINE existence_certificate certify_existence(const tableaux::method_file& file, int digits) {
    if (digits < 5 || digits > 4000)
        throw std::invalid_argument("digits: " + std::to_string(digits) + ", allowed: 5 to 4000");
    const auto subject = detail::subject_of(file);
    existence_certificate out;
    const file_certificate judged = [&] {
        const tableaux::time_share share(tableaux::time_share::left() / 3);
        return certify(file);
    }();
    out.name = judged.name;
    out.source = judged.source;
    if (judged.overall() == standing::refuted) {
        out.standing = standing::refuted;
        out.theorem = "refused: " + detail::refusal(judged);
        return out;
    }
    const auto order_of = [&](const char* name, const std::optional<int>& claimed) {
        const finding* f = judged.find(name);
        return claimed ? *claimed : f && f->value ? *f->value : 0;
    };
    std::vector<int> orders{order_of("order", subject.claims.order)};
    const bool embedded = std::none_of(subject.partners.begin(), subject.partners.end(),
                                       [](const auto& p) { return p.b_embedded.empty(); });
    if (embedded) orders.push_back(order_of("embedded_order", subject.claims.embedded_order));
    const int most = subject.alone ? tableaux::largest_order : tableaux::largest_coupled_order;
    if (orders[0] < 1 || *std::max_element(orders.begin(), orders.end()) > most) {
        out.theorem = "not decided: an order from 1 to " + std::to_string(most) + " is needed";
        return out;
    }
    std::string trouble;
    auto best = detail::best_attempt(subject, orders, digits, trouble);
    if (best.found.all_equations) {
        detail::state_theorem(file, subject, best, digits, out);
    } else if (embedded && best.found.exists) {
        auto only_b = subject;
        for (auto& p : only_b.partners) p.b_embedded.clear();
        const auto main = detail::best_attempt(only_b, {orders[0]}, digits, trouble);
        if (main.found.all_equations) {
            detail::state_theorem(file, only_b, main, digits, out);
            out.standing = standing::inconclusive;
            out.notes.push_back("of b_embedded nothing is proved: order " + std::to_string(orders[1]) +
                                " is consistent");
            out.polished = nullptr;
        } else {
            best = best.rank() < main.rank() ? main : best;
        }
    }
    if (out.order == 0) {
        out.theorem = best.found.exists
                          ? "not proved: entries within " + brief(detail::moved(best).most) +
                                " of these satisfy " + std::to_string(best.found.solved) + " of " +
                                std::to_string(best.found.equations) +
                                " equations exactly; the rest is consistent to " + brief(best.found.left)
                          : "not decided: " + trouble;
        if (best.found.exists) detail::describe_search(best, out);
    }
    if (best.found.exists && !best.found.all_equations) detail::name_what_is_left(best, out);
    detail::name_other_claims(subject.claims, out);
    return out;
}

STAGECRAFT_INLINE nlohmann::ordered_json to_json(const existence_certificate& c) {
    nlohmann::ordered_json j{{"name", c.name},
                             {"source", c.source},
                             {"verdict", name(c.standing)},
                             {"exit_code", c.exit_code()},
                             {"theorem", c.theorem}};
    if (c.order > 0) j["order"] = c.order;
    if (c.embedded_order) j["embedded_order"] = *c.embedded_order;
    if (!c.distance.empty()) j["within"] = {{"distance", c.distance}, {"entry", c.farthest}};
    j["notes"] = c.notes;
    if (!c.polished.is_null()) j["tableau"] = c.polished;
    return j;
}

STAGECRAFT_INLINE std::string to_text(const existence_certificate& c) {
    std::string text = (c.name.empty() ? "unnamed" : c.name) + "\n  " +
                       (c.standing == standing::proved ? "proved: " : "") + c.theorem + "\n";
    for (const auto& note : c.notes) text += "    " + note + "\n";
    return text;
}

}  // namespace stagecraft::theory
