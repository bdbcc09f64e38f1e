// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <optional>
#include <stagecraft/tableaux/partitioned_file.hpp>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/theory/judging/file_certificate.hpp>
#include <stagecraft/theory/judging/judge_claims.hpp>
#include <stagecraft/theory/judging/order_finding.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <stagecraft/theory/trees/coloured_trees.hpp>
#include <string>
#include <utility>
#include <vector>

/// The conditions on several tableaux together: order by coloured trees, stage order, symplecticity.

namespace stagecraft::theory {

/// The tableaux of a partitioned file on trial.
template <class K>
struct coupled_subject {
    const tableaux::partitioned_file* file = nullptr;
    std::vector<subject<K>> partners;

    bool nystrom() const { return file->coupling == tableaux::coupling::nystrom; }
    bool rosenbrock() const { return file->coupling == tableaux::coupling::rosenbrock; }
    int stages() const { return partners.front().stages(); }

    /// As the coloured trees want it, with the weights or the embedded ones.
    coloured_method<K> coloured(bool embedded) const {
        coloured_method<K> m;
        m.nystrom = nystrom();
        for (const auto& p : partners) {
            m.A.push_back(p.t.A);
            m.b.push_back(embedded ? p.t.b_embedded : p.t.b);
        }
        m.c = partners.front().t.c;
        return m;
    }
};

/// A condition on a coloured tree that fails.
template <class K>
struct coloured_residual {
    std::uint32_t row;
    K residual;
};

namespace detail {

/// The first order with a condition that fails, or `most`; `table` is that of the subject's coupling.
template <class K>
search_for_order<coloured_residual<K>> find_coupled_order(const coloured_method<K>& m,
                                                          const tree_view& trees) {
    search_for_order<coloured_residual<K>> found;
    condition_sizes size;
    int n = 1;
    bool go_on = true;
    visit_coloured_trees(m, trees, [&](std::uint32_t row, const K& weight) {
        const tree_row& t = trees.rows[row];
        if (t.order > n) {
            go_on = found.conclude(n, size);
            n = t.order;
        }
        if (!go_on) return false;
        const K gamma(t.density);
        const K defect = gamma * weight - K(1);
        const bool earlier = !found.failing.empty() && trees.rows[found.failing.front().row].order < n;
        if (certainly_nonzero(defect) && !earlier) found.failing.push_back({row, defect / gamma});
        size.take(defect, static_cast<tableaux::bound>(t.density));
        return true;
    });
    if (go_on) found.conclude(n, size);
    return found;
}

/// Who is to blame: a tableau where a tree of its colour alone fails, else the coupling of those whose colours
/// the failing trees have; of a Nystrom method, the formula for y or that for y'.
template <class K>
std::string blame(const coupled_subject<K>& s, const std::vector<coloured_residual<K>>& failing,
                  const tree_view& trees) {
    unsigned alone = 0, together = 0;
    for (const auto& f : failing) {
        const unsigned colours =
            s.nystrom() ? 1U << static_cast<unsigned>(trees.rows[f.row].colour) : colours_of(trees, f.row);
        together |= colours;
        if ((colours & (colours - 1)) == 0) alone |= colours;
    }
    const unsigned guilty = alone != 0 ? alone : together;
    std::string names;
    for (std::size_t k = 0; k < s.partners.size(); ++k)
        if ((guilty >> k & 1U) != 0) names += (names.empty() ? "" : " and ") + partner_name(*s.file, k);
    if (alone == 0) return "only the coupling of " + names + " fails";
    return names + ((alone & (alone - 1)) != 0 ? " fail by themselves" : " fails by itself");
}

template <class K>
finding judge_coupled_order(const coupled_subject<K>& s, bool embedded, std::optional<int> claimed,
                            file_certificate& certificate) {
    const auto& file = *s.file;
    const int largest = tableaux::largest_order_of(file);
    const int most = std::min(largest, s.nystrom() ? std::max(claimed.value_or(5) + 1, 6) : largest);
    const tree_table table(most, static_cast<int>(s.partners.size()),
                           admits_coupling{file.coupling, file.uses_velocity});
    const tree_view& trees = table.view();
    const auto found = find_coupled_order(s.coloured(embedded), trees);
    const std::string name = embedded ? "embedded_order" : "order";
    const coloured_text text(trees, s.nystrom(), s.partners.size());
    const std::size_t first = certificate.failures.size();
    for (const auto& f : found.failing) {
        std::string condition = text.condition(f.row);
        if (embedded) condition.insert(condition.find(','), "_embedded");
        certificate.failures.push_back(
            {std::move(condition), text.bracket(f.row), shown(f.residual), in_words(f.residual)});
    }
    if (!found.failing.empty() && found.order < claimed.value_or(found.order + 1))
        certificate.notes.push_back((embedded ? "embedded, order " : "order ") +
                                    std::to_string(found.order + 1) + ": " + blame(s, found.failing, trees));
    order_facts facts;
    facts.value = exact_scalar<K> ? found.order : std::min(found.order, found.tested);
    facts.refuted_from = found.order + 1;
    if (found.failing.empty()) facts.refuted_from = most + 1;
    return order_verdict(name, claimed, found, facts, exact_scalar<K>,
                         found.failing.empty() ? nullptr : &certificate.failures[first]);
}

/// c = A*1 in each tableau of a separable method that gives nodes; of other methods each is judged by itself.
template <class K>
void judge_coupled_row_sums(const coupled_subject<K>& s, file_certificate& certificate) {
    if (s.file->coupling != tableaux::coupling::separable) return;
    std::optional<finding> all;
    for (std::size_t k = 0; k < s.partners.size(); ++k) {
        if (!s.partners[k].nodes_given) continue;
        const std::size_t first = certificate.failures.size();
        finding f = judge_row_sums(s.partners[k], s.file->partners[k].claims, certificate.failures);
        for (std::size_t i = first; i < certificate.failures.size(); ++i)
            certificate.failures[i].condition.insert(0, partner_name(*s.file, k) + ": ");
        if (all && all->judgement && f.judgement) f.truth = f.judgement = both(*all->judgement, *f.judgement);
        if (!all || f.judgement) all = std::move(f);
    }
    if (all) certificate.findings.push_back(std::move(*all));
}

/// Whether all have the same nodes; not refuted where enclosures overlap.
template <class K>
bool same_nodes(const coupled_subject<K>& s) {
    for (const auto& p : s.partners)
        for (int i = 0; i < s.stages(); ++i)
            if (certainly_nonzero(K(p.t.c(i) - s.partners.front().t.c(i)))) return false;
    return true;
}

/// The least stage order of the tableaux, where their nodes are the same; a stage is no value at one time
/// otherwise.
template <class K>
finding judge_coupled_stage_order(const coupled_subject<K>& s, std::optional<int> claimed) {
    finding f;
    f.name = "stage_order";
    int least = 2 * s.stages();
    tableaux::bound residual = 0, most = 0, relative_bound = 0;
    std::string who;
    const bool same = same_nodes(s);
    for (std::size_t k = 0; k < s.partners.size(); ++k) {
        const auto found = find_stage_order(s.partners[k], 2 * s.stages());
        const int q = found.stage_order;
        residual = std::max(residual, found.residual);
        most = std::max(most, found.bound);
        relative_bound = std::max(relative_bound, found.relative_bound);
        if (q < least) who = partner_name(*s.file, k);
        least = std::min(least, q);
    }
    f.value = same ? least : 0;
    if (!claimed) return f;
    f.claimed = std::to_string(*claimed);
    if (*claimed > *f.value)
        f.judgement =
            verdict::refuted(same ? who + " has stage order " + std::to_string(least) : "the nodes differ");
    else if constexpr (exact_scalar<K>)
        f.judgement = verdict::proved("B(" + *f.claimed + ") and C(" + *f.claimed + ") hold for each");
    else
        set_open_stage_order(f, residual, most, relative_bound);
    return f;
}

}  // namespace detail

/// Preserves the symplectic form. Partitioned: b_i A_hat_ij + b_hat_j A_ji = b_i b_hat_j, and b = b_hat unless
/// the system is separable (Hairer-Lubich-Wanner, section VI.4, Theorem 4.6). Nystrom: b_bar_i = b_i (1 - c_i)
/// and b_i (b_bar_j - A_bar_ij) = b_j (b_bar_i - A_bar_ji) (there, Theorem 4.8). Sufficient, and necessary
/// for irreducible methods. Decided over exact fields. For separable, partitioned and Nystrom methods only.
template <class K>
verdict symplectic_together(const coupled_subject<K>& s) {
    const auto& t = s.partners[0].t;
    const auto& u = s.partners[1].t;
    verdict v = verdict::proved("the conditions hold");
    const auto equal = [&](const K& left, const K& right, const std::string& what) {
        v = both(v,
                 vanishes(K(left - right), std::max({size_of(left), size_of(right), tableaux::bound(1e-3L)}),
                          what, data_reason));
    };
    const auto at = [](const char* name, int i, int j = -1) {
        return name + ("[" + std::to_string(i + 1) + "]") + (j < 0 ? "" : "[" + std::to_string(j + 1) + "]");
    };
    for (int i = 0; i < s.stages(); ++i) {
        if (s.nystrom())
            equal(t.b(i), u.b(i) * (K(1) - u.c(i)),
                  at("b_bar", i) + " = " + at("b", i) + "*(1-" + at("c", i) + ")");
        else if (s.file->coupling == tableaux::coupling::partitioned)
            equal(t.b(i), u.b(i), at("b", i) + " = " + at("b_hat", i));
        for (int j = 0; j < s.stages(); ++j) {
            if (s.nystrom())
                equal(u.b(i) * (t.b(j) - t.A(i, j)), u.b(j) * (t.b(i) - t.A(j, i)),
                      "symmetry of b[i]*(b_bar[j]-A_bar[i][j]) at " + at("", i, j));
            else
                equal(t.b(i) * u.A(i, j) + u.b(j) * t.A(j, i), t.b(i) * u.b(j),
                      "b[i]*A_hat[i][j] + b_hat[j]*A[j][i] = b[i]*b_hat[j] at " + at("", i, j));
        }
    }
    return v.is_proved() ? verdict::proved("all " + std::to_string(s.stages()) + " x " +
                                           std::to_string(s.stages()) + " conditions hold")
                         : v;
}

/// Judges what is claimed of the tableaux together.
template <class K>
void judge(const coupled_subject<K>& s, file_certificate& certificate) {
    const auto& file = *s.file;
    const auto& claims = file.claims;
    const bool additive = file.coupling == tableaux::coupling::additive;
    certificate.findings.push_back(detail::found_in_its_time("order", claims.order, 0.4, [&] {
        return detail::judge_coupled_order(s, false, claims.order, certificate);
    }));
    if (std::all_of(s.partners.begin(), s.partners.end(),
                    [](const auto& p) { return p.t.b_embedded.size() > 0; }))
        certificate.findings.push_back(detail::found_in_its_time(
            "embedded_order", claims.embedded_order, 0.4,
            [&] { return detail::judge_coupled_order(s, true, claims.embedded_order, certificate); }));
    detail::judge_coupled_row_sums(s, certificate);
    if (!s.nystrom()) {
        certificate.notes.push_back(detail::same_nodes(s) ? "the nodes are the same" : "the nodes differ");
        certificate.findings.push_back(detail::judge_coupled_stage_order(s, claims.stage_order));
    }
    if (additive) return;
    finding f;
    f.name = "symplectic";
    f.truth = symplectic_together(s);
    if (claims.symplectic) {
        f.claimed = *claims.symplectic ? "true" : "false";
        f.judgement = *claims.symplectic ? *f.truth : negation(*f.truth);
    }
    certificate.findings.push_back(std::move(f));
}

}  // namespace stagecraft::theory
