// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <stagecraft/tableaux/partitioned_file.hpp>
#include <stagecraft/tableaux/rough_ball.hpp>
#include <stagecraft/theory/judging/file_certificate.hpp>
#include <stagecraft/theory/judging/judge_claims.hpp>
#include <stagecraft/theory/judging/judge_coupling.hpp>
#include <stagecraft/theory/judging/judge_rosenbrock.hpp>
#include <stagecraft/theory/judging/judge_together.hpp>
#include <stagecraft/theory/judging/rosenbrock_suspects.hpp>
#include <stagecraft/theory/judging/suspects.hpp>
#include <stagecraft/theory/trees/coloured_trees.hpp>
#include <string>
#include <utility>
#include <vector>

/// Which entry of which tableau may be wrong where a method of several tableaux does not keep its claims.

namespace stagecraft::theory {

namespace detail {

/// Whether each tableau is judged for itself as well: of the others none is a method alone.
bool judged_alone(const tableaux::partitioned_file& file);

/// The k-th tableau with what is claimed of it: its own claims, and the orders of the whole.
tableaux::tableau_file partner_alone(const tableaux::partitioned_file& file, std::size_t k);

/// The entries whose change leaves the kind of each tableau alone. Both formulas of a Nystrom method share the nodes; of a Rosenbrock
/// method the one gamma of a file counts once.
std::vector<coupled_place> coupled_places(const tableaux::partitioned_file& file);

/// "implicit part: A[4][3]"; of a Nystrom method as the file calls it, "b_bar[2]".
std::string name(const coupled_place& p, const tableaux::partitioned_file& file);

template <class To, class K, class Convert>
coupled_subject<To> mapped(const coupled_subject<K>& s, Convert convert) {
    coupled_subject<To> r{s.file, {}};
    for (const auto& p : s.partners) r.partners.push_back(theory::mapped<To>(p, convert));
    return r;
}

/// The first condition that, as a function of one entry, is affine and not constant: from the weights with the entry
/// set to 0, 1 and 2.
template <class K>
std::optional<std::uint32_t> affine_coupled_condition(const coupled_subject<K>& s, const coupled_place& p,
                                                      bool embedded, const tree_view& trees) {
    std::array<std::vector<std::pair<std::uint32_t, K>>, 3> weights;
    for (int x = 0; x < 3; ++x) {
        coupled_subject<K> probe = s;
        put(probe, p, K(x));
        visit_coloured_trees(probe.coloured(embedded), trees, [&](std::uint32_t row, const K& weight) {
            weights[static_cast<std::size_t>(x)].emplace_back(row, weight);
            return true;
        });
    }
    for (std::size_t i = 0; i < weights[0].size(); ++i) {
        const K step = weights[1][i].second - weights[0][i].second;
        const K bend = weights[2][i].second - weights[1][i].second - step;
        if (certainly_nonzero(step) && !certainly_nonzero(bend)) return weights[0][i].first;
    }
    return std::nullopt;
}

/// The value of the entry with which the condition holds; empty where an enclosure cannot divide.
template <class K>
std::optional<K> coupled_value(const coupled_subject<K>& s, const coupled_place& p, bool embedded,
                               const tree_view& trees, std::uint32_t condition) {
    const auto residual = [&](int x) {
        coupled_subject<K> probe = s;
        put(probe, p, K(x));
        K left(0);
        visit_coloured_trees(probe.coloured(embedded), trees, [&](std::uint32_t row, const K& weight) {
            if (row == condition) left = weight * K(trees.rows[row].density) - K(1);
            return row != condition;
        });
        return left;
    };
    const K at_zero = residual(0), slope = residual(1) - at_zero;
    if (!certainly_nonzero(slope)) return std::nullopt;
    return -at_zero / slope;
}

/// The trees for each of the orders that are claimed of the whole.
struct coupled_trees_claimed {
    explicit coupled_trees_claimed(const tableaux::partitioned_file& f)
        : order(table(f, f.claims.order)), embedded(table(f, f.claims.embedded_order)) {}
    static tree_table table(const tableaux::partitioned_file& f, std::optional<int> claimed);
    tree_table order, embedded;
};

/// The one value that can restore every claim: from the row sum where the nodes are given, else from the first
/// condition that is affine in the entry, which the quick subject finds.
template <class K, class Quick>
std::optional<K> restoring_value(const coupled_subject<K>& s, const Quick& quick, const coupled_place& p,
                                 const coupled_trees_claimed& trees) {
    if (s.rosenbrock()) return rosenbrock_value(s, quick, p);
    const auto& partner = s.partners[p.partner];
    const bool in_row_sum = p.place.part == part::A || p.place.part == part::c;
    if (in_row_sum && partner.nodes_given && !s.nystrom()) {
        const K defect = row_sum_defects(partner)[static_cast<std::size_t>(p.place.row)];
        const K& written = value_at(partner, p.place);
        return p.place.part == part::A ? K(written - defect) : K(written + defect);
    }
    const bool embedded = p.place.part == part::b_embedded;
    const auto& view = embedded ? trees.embedded.view() : trees.order.view();
    const auto condition = affine_coupled_condition(quick, p, embedded, view);
    if (!condition) return std::nullopt;
    return coupled_value(s, p, embedded, view, *condition);
}

/// Whether something claimed of the whole, or of a tableau for itself, certainly fails.
template <class K>
bool refutes_a_coupled_claim(const coupled_subject<K>& s, const coupled_trees_claimed& trees) {
    if (s.rosenbrock()) return refutes_a_rosenbrock_claim(s);
    const auto& claims = s.file->claims;
    const auto falls_short = [&](bool embedded, int claimed) {
        const auto& table = embedded ? trees.embedded : trees.order;
        return claimed > 0 && find_coupled_order(s.coloured(embedded), table.view()).order < claimed;
    };
    if (falls_short(false, claims.order.value_or(0))) return true;
    if (claims.embedded_order && falls_short(true, *claims.embedded_order)) return true;
    if (claims.symplectic.value_or(false) && symplectic_together(s).is_refuted()) return true;
    if constexpr (std::same_as<K, tableaux::quadratic> || std::same_as<K, tableaux::ball>) {
        if (claims.symmetric.value_or(false) && symmetric_together(s, std::nullopt).is_inconclusive())
            return true;  // no repair leaves that open
        if (claims.algebraically_stable.value_or(false) && algebraically_stable_together(s).is_refuted())
            return true;
    }
    if (s.nystrom()) return false;
    for (std::size_t k = 0; k < s.partners.size(); ++k) {
        tableaux::claims alone =
            judged_alone(*s.file) ? partner_alone(*s.file, k).claims : tableaux::claims{};
        if (refutes_a_claim(s.partners[k], alone, mostly_row_sums(s.partners[k]))) return true;
    }
    return false;
}

/// "implicit part: entries A[5][4] and A[5][5] are exchanged" where undoing that restores every claim: two entries of a
/// row of A or of the weights of one tableau, of up to 16 stages.
template <class K>
std::string find_coupled_exchange(const coupled_subject<K>& s, const coupled_trees_claimed& trees) {
    const auto& file = *s.file;
    if (s.stages() > 16) return {};
    const auto all = coupled_places(file);
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const auto &p = all[i], &q = all[k];
            const bool together = p.partner == q.partner && p.place.part == q.place.part &&
                                  (p.place.part != part::A || p.place.row == q.place.row) &&
                                  p.place.part != part::c;
            if (!together) continue;
            tableaux::time_share::check_now();
            const K x = value_at(s.partners[p.partner], p.place),
                    y = value_at(s.partners[q.partner], q.place);
            if (!certainly_nonzero(K(x - y))) continue;
            coupled_subject<K> changed = s;
            put(changed, p, y);
            put(changed, q, x);
            if (!refutes_a_coupled_claim(changed, trees))
                return "entries " + name(q, file) + " and " + p.place.name() + " are exchanged" + undone;
        }
    return {};
}

/// "row 5 of A_bar ..." where it alone does not sum to c^2/2: several of its entries are wrong, as where a row of a neighbour
/// was copied.
template <class K>
std::string find_wrong_row(const coupled_subject<K>& s) {
    if (!s.nystrom()) return {};
    const auto& t = s.partners.front().t;
    const auto n = static_cast<Eigen::Index>(s.stages());
    std::vector<Eigen::Index> wrong;
    for (Eigen::Index i = 0; i < n; ++i) {
        K defect = K(t.c(i) * t.c(i));
        for (Eigen::Index j = 0; j < n; ++j) defect -= K(2) * t.A(i, j);
        if (certainly_nonzero(defect)) wrong.push_back(i);
    }
    if (n < 3 || wrong.size() != 1) return {};
    const auto i = wrong.front();
    std::string text = "row [" + std::to_string(i + 1) + "] of A_bar alone does not sum to c^2/2";
    for (Eigen::Index k = 0; k < n; ++k) {
        bool same = k != i;
        for (Eigen::Index j = 0; same && j < n; ++j) same = !certainly_nonzero(K(t.A(i, j) - t.A(k, j)));
        if (same) text += "; it repeats row [" + std::to_string(k + 1) + "]";
    }
    return text;
}

}  // namespace detail

/// Names the single entries whose change restores every claim on the tableaux together, else two that are exchanged. The
/// first condition that is affine in the entry leaves one value possible; it is looked for modulo 2^61 - 1, or in enclosures
/// of few digits.
template <class K>
void find_coupling_suspects(const coupled_subject<K>& s, file_certificate& certificate) {
    using namespace detail;
    const auto& file = *s.file;
    const coupled_trees_claimed trees(file);
    const auto search = [&](const auto& quick) {
        for (const coupled_place& p : coupled_places(file)) {
            tableaux::time_share::check_now();
            const auto value = restoring_value(s, quick, p, trees);
            if (!value || !certainly_nonzero(K(*value - value_at(s.partners[p.partner], p.place)))) continue;
            coupled_subject<K> changed = s;
            put(changed, p, *value);
            if (refutes_a_coupled_claim(changed, trees)) continue;
            std::vector<suspect> found;
            append_suspects(file.partners[p.partner], std::vector<repair<K>>{{p.place, *value}}, found);
            for (suspect& x : found)
                certificate.suspects.push_back({name(p, file), std::move(x.written), std::move(x.suggest)});
        }
    };
    if constexpr (exact_scalar<K>) {
        coupled_subject<tableaux::residue> quick{s.file, {}};
        for (const auto& p : s.partners)
            if (const auto reduced = reduced_modulo_prime(p)) quick.partners.push_back(*reduced);
        if (quick.partners.size() == s.partners.size()) search(quick);
    } else {
        search(detail::mapped<tableaux::rough_ball>(s, [](const K& x) { return tableaux::rough_ball(x); }));
    }
    rank(certificate.suspects);
    if (certificate.suspects.empty()) certificate.suspects_note = find_coupled_exchange(s, trees);
    if (certificate.suspects.empty() && certificate.suspects_note.empty())
        certificate.suspects_note = find_wrong_row(s);
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/coupling_suspects-inl.hpp"
#endif
