// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <stagecraft/method/simplifying_assumptions.hpp>
#include <stagecraft/tableaux/claims.hpp>
#include <stagecraft/theory/judging/file_certificate.hpp>
#include <stagecraft/theory/judging/finding_in_its_time.hpp>
#include <stagecraft/theory/judging/judge_numbers.hpp>
#include <stagecraft/theory/judging/jumps_seen.hpp>
#include <stagecraft/theory/judging/level_findings.hpp>
#include <stagecraft/theory/judging/order_finding.hpp>
#include <stagecraft/theory/judging/properties.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <stagecraft/theory/trees/tree_text.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stagecraft::theory {

/// Orders searched for: up to one beyond the barrier, which settles the order, or 14 over exact fields;
/// enclosures stop at 10 (1205 conditions), or at the order claimed.
template <class K>
int search_limit(const subject<K>& s, std::optional<int> claimed) {
    const int reach = exact_scalar<K> ? tableaux::largest_order
                                      : std::min(tableaux::largest_order, std::max(10, claimed.value_or(0)));
    return std::min(order_barrier(s) + 1, reach);
}

/// A file that gives c claims c = A*1, unless it states stage order 0.
template <class K>
bool claims_row_sums(const subject<K>& s, const tableaux::claims& claims) {
    return s.nodes_given && claims.stage_order.value_or(1) > 0;
}

namespace detail {

/// Decimal digits to which quantities of size one agree.
int matching_digits(tableaux::bound residual);

/// What is known of the order of some weights besides the search.
struct order_facts {
    int value = 0;         ///< to be reported
    int refuted_from = 0;  ///< the first order that certainly fails
    bool by_time = false;  ///< for non-autonomous problems only, which see that c is not A*1
    std::string barrier;   ///< why that order fails where no condition was looked at
};

/// An order that nobody claims and that holds but for rounding of the digits.
template <class Failure>
finding found_numerically(finding f, const search_for_order<Failure>& found) {
    const auto left = found.up_to(found.numerical).residual;
    f.value = found.numerical;
    f.numerical = numerical_order{found.numerical, brief(left), matching_digits(left)};
    f.truth =
        verdict::consistent(brief(left), "1e-" + std::to_string(f.numerical->digits), in_words(*f.numerical));
    return f;
}

/// The verdict on an order, from a search whose failures begin at `first`. Exact: the residuals decide.
template <class Failure>
finding order_verdict(std::string name, std::optional<int> claimed, const search_for_order<Failure>& found,
                      const order_facts& facts, bool exact, const failure* first) {
    finding f;
    f.name = std::move(name);
    f.value = facts.value;
    if (claimed) f.claimed = std::to_string(*claimed);
    auto& judged = claimed ? f.judgement : f.truth;
    const int order = claimed.value_or(facts.value);
    if (!claimed && !facts.by_time && facts.refuted_from <= found.numerical)
        return found_numerically(std::move(f), found);
    if (!claimed && facts.refuted_from == 1) {  // no method at all, whatever is claimed of it
        f.truth = f.judgement = verdict::refuted(
            "no order: " + (first ? first->condition + " leaves " + first->in_words : facts.barrier));
        return f;
    }
    const auto& size = found.up_to(order);
    if (facts.refuted_from <= order) {
        std::string why = "order " + std::to_string(facts.refuted_from - 1);
        if (facts.by_time)
            why += ": c is not A*1, and a non-autonomous problem sees it";
        else if (!first)
            why += facts.barrier;
        else
            why += ": " + first->condition + " leaves " + first->in_words;
        const auto left = found.up_to(found.numerical).residual;
        if (found.numerical > facts.value && left > 0) {
            f.numerical = numerical_order{found.numerical, brief(left), matching_digits(left)};
            why += "; " + in_words(*f.numerical);
            if (found.numerical >= order) why += std::string("; ") + larger_errors;
        }
        judged = verdict::refuted(std::move(why));
    } else if (exact) {
        std::string why = "every condition up to order " + std::to_string(order) + " holds";
        if (facts.value > order) why += ", and the order is " + std::to_string(facts.value);
        judged = verdict::proved(std::move(why));
    } else if (f.relative_bound = brief(size.relative_bound); order > found.tested) {
        judged = verdict::inconclusive(brief(size.residual), brief(size.bound),
                                       "too few digits to refute order " + std::to_string(found.tested + 1));
    } else {
        judged = verdict::consistent(
            brief(size.residual), brief(size.bound),
            data_reason + (", no bound above " + f.relative_bound) + " of the 1/gamma of its condition");
    }
    return f;
}

/// What the conditions of the first failing order that may hold can add to the principal error, at most.
template <class K>
tableaux::bound principal_error_left_open(const order_finding<K>& found) {
    const int n = order(found.failing.front().tree);
    return found.up_to(n).bound * static_cast<tableaux::bound>(number_of_trees(n));
}

/// From the conditions of the first order that has failing ones; nothing where the digits do not give three digits of it.
template <class K>
std::optional<principal_error> principal_error_of(const order_finding<K>& found) {
    if (found.failing.empty()) return std::nullopt;
    tableaux::bound squares = 0, largest = 0, unknown = 0;
    for (const auto& [tree, residual] : found.failing) {
        const auto sigma = static_cast<tableaux::bound>(symmetry(tree));
        const auto tau = size_of(residual) / sigma;
        squares += tau * tau;
        largest = std::max(largest, tau);
        unknown += uncertainty_of(residual) / sigma;
    }
    // Conditions that may hold count with their bound: three digits are printed where all of it is below them.
    if constexpr (!exact_scalar<K>) unknown += principal_error_left_open(found);
    if (unknown > 1e-4L * largest) return std::nullopt;
    return principal_error{order(found.failing.front().tree), brief(std::sqrt(squares)), brief(largest)};
}

/// Orders beyond the trees: proved by B(p), C(q) and D(r) where p <= q + r + 1 and p <= 2 q + 2 (Butcher 1964;
/// Hairer-Wanner II, Theorem IV.5.1), refuted by B alone, which is necessary.
template <class K, class Weights>
finding judge_high_order(const subject<K>& s, const Weights& weights, const std::string& name, int claimed) {
    tableau<K> t = s.t;
    t.b = weights;
    condition_sizes size;
    const auto orders = simplifying_orders_of(t, [&](const K& left, const K& right) {
        const K defect = left - right;
        if (certainly_nonzero(defect)) return false;
        size.take(defect, 1);
        return true;
    });
    finding f;
    f.name = name;
    f.claimed = std::to_string(claimed);
    f.value = std::min(orders.order(), order_barrier(s));
    const std::string assumptions = "B(" + std::to_string(orders.B) + "), C(" + std::to_string(orders.C) +
                                    "), D(" + std::to_string(orders.D) + ")";
    if (orders.B < claimed || order_barrier(s) < claimed)
        f.judgement = verdict::refuted("B(" + std::to_string(orders.B + 1) + ") does not hold");
    else if (*f.value < claimed)
        f.judgement = verdict::inconclusive("not computed", "none", assumptions + " alone do not prove it");
    else if constexpr (exact_scalar<K>)
        f.judgement = verdict::proved(assumptions + " hold");
    else {
        f.relative_bound = brief(size.bound);  // k B(k) is 1, and so on
        f.judgement = open_case(size.residual, size.bound, 1, data_reason);
    }
    return f;
}

/// The finding on one set of weights, and its failures.
template <class K, class Weights>
finding judge_order(const subject<K>& s, const Weights& weights, const std::string& which,
                    std::optional<int> claimed, bool row_sums_fail, file_certificate& certificate) {
    const std::string name = which == "b" ? "order" : "embedded_order";
    if (claimed.value_or(0) > tableaux::largest_order) return judge_high_order(s, weights, name, *claimed);
    auto& failures = certificate.failures;
    auto found = find_order(s, weights, search_limit(s, claimed));
    if (which == "b") certificate.principal_error = principal_error_of(found);
    order_facts facts;
    facts.value = exact_scalar<K> ? found.order : std::min(found.order, found.tested);
    facts.refuted_from = found.order + 1;
    facts.barrier = ", the most that " + std::to_string(s.stages()) + " stages can have";
    if (row_sums_fail && found.order > 1) {
        const int searched = std::min(found.order, 8);
        const int order = non_autonomous_order(s, weights, searched);
        if (order < searched) facts.refuted_from = order + 1;
        facts.by_time = facts.refuted_from <= found.order;
        facts.value = std::min(facts.value, order);
    }
    const std::size_t first = failures.size();
    for (const auto& [tree, residual] : found.failing) {
        std::string condition = condition_text(tree);
        if (which != "b") condition.replace(condition.find("dot(b,"), 6, "dot(" + which + ",");
        if (row_sums_fail) condition += " with A*1 for c";  // which the file's c might satisfy
        failures.push_back({std::move(condition), bracket(tree), shown(residual), in_words(residual)});
    }
    return order_verdict(name, claimed, found, facts, exact_scalar<K>,
                         found.failing.empty() ? nullptr : &failures[first]);
}

template <class K>
finding judge_row_sums(const subject<K>& s, const tableaux::claims& claims, std::vector<failure>& failures) {
    const auto defects = row_sum_defects(s);
    verdict v = verdict::proved("A*1 = c");
    tableaux::bound largest = 0;  // of the rows that may hold
    for (int i = 0; i < s.stages(); ++i) {
        const K& defect = defects[static_cast<std::size_t>(i)];
        const std::string row = std::to_string(i + 1);
        tableaux::bound scale = size_of(K(s.t.c(i)));
        for (int j = 0; j < s.stages(); ++j) scale = std::max(scale, size_of(K(s.t.A(i, j))));
        const verdict one = vanishes(defect, scale, "row " + row + " of A*1 = c", data_reason);
        if (certainly_nonzero(defect)) {
            v = both(v, one);
            failures.push_back(
                {"sum(A[" + row + "]) == c[" + row + "]", "", shown(defect), in_words(defect)});
        } else {
            v = size_of(defect) > largest ? both(one, v) : both(v, one);
            largest = std::max(largest, size_of(defect));
        }
    }
    if (v.is_proved()) v = verdict::proved("A*1 = c");
    finding f{"row_sums", std::nullopt, std::nullopt, v, std::nullopt, {}, {}};
    if (claims_row_sums(s, claims)) {
        f.claimed = "true";
        f.judgement = v;
    }
    return f;
}

}  // namespace detail

/// Whether the author takes c = A*1: at most a third of the rows fail. Others mean the stages' times to differ.
template <class K>
bool mostly_row_sums(const subject<K>& s) {
    int failing = 0;
    for (const K& defect : row_sum_defects(s)) failing += certainly_nonzero(defect) ? 1 : 0;
    return 3 * failing <= std::max(s.stages(), 3);
}

namespace detail {

/// The stages that y_1 depends on, and where it is claimed the embedded solution.
template <class K>
std::vector<bool> stages_used(const subject<K>& s, bool embedded) {
    const int n = s.stages();
    std::vector<bool> used(static_cast<std::size_t>(n));
    std::vector<int> next;
    const auto use = [&](int i) {
        if (used[static_cast<std::size_t>(i)]) return;
        used[static_cast<std::size_t>(i)] = true;
        next.push_back(i);
    };
    for (int i = 0; i < n; ++i)
        if (certainly_nonzero(s.t.b(i)) || (embedded && certainly_nonzero(s.t.b_embedded(i)))) use(i);
    while (!next.empty()) {
        const int i = next.back();
        next.pop_back();
        for (int j = 0; j < n; ++j)
            if (certainly_nonzero(K(s.t.A(i, j)))) use(j);
    }
    return used;
}

/// Whether c is meant as A*1 though some rows fail and the orders claimed do not: few rows fail, and either the
/// entries are rounded (the conditions bound c less sharply than the sum of a row does) or nothing claimed depends on
/// such a stage. A misprint shows nowhere else then.
template <class K>
bool only_row_sums_tell(const subject<K>& s, bool embedded) {
    if (!mostly_row_sums(s)) return false;
    if constexpr (exact_scalar<K>) {
        const auto used = stages_used(s, embedded);
        const auto defects = row_sum_defects(s);
        for (std::size_t i = 0; i < defects.size(); ++i)
            if (!used[i] && certainly_nonzero(defects[i])) return true;
        return false;
    }
    return true;
}

}  // namespace detail

/// Judges every claim, each within its share of the time; properties that are not claimed are reported too while they are
/// cheap (s <= 16).
template <class K>
void judge(const subject<K>& s, const tableaux::claims& claims, file_certificate& certificate) {
    auto& failures = certificate.failures;
    bool row_sums_fail = false;
    if (s.nodes_given) {
        certificate.findings.push_back(detail::judge_row_sums(s, claims, failures));
        row_sums_fail = certificate.findings.back().truth->is_refuted();
    }
    certificate.findings.push_back(detail::found_in_its_time("order", claims.order, 0.4, [&] {
        return detail::judge_order(s, s.t.b, "b", claims.order, row_sums_fail, certificate);
    }));
    const auto& order = certificate.findings.back();
    if (row_sums_fail && !claims.stage_order && order.judgement && !order.judgement->is_refuted() &&
        !detail::only_row_sums_tell(s, claims.embedded_order.has_value())) {
        finding& row_sums = certificate.findings.front();  // no claim of its own: the order holds without it
        row_sums.claimed.reset();
        row_sums.judgement.reset();
        certificate.notes.push_back(
            "c is not A*1, and the order claimed holds for y' = f(t, y) all the same");
    }
    if (s.t.b_embedded.size() > 0) {
        certificate.findings.push_back(
            detail::found_in_its_time("embedded_order", claims.embedded_order, 0.4, [&] {
                return detail::judge_order(s, s.t.b_embedded, "b_embedded", claims.embedded_order,
                                           row_sums_fail, certificate);
            }));
        certificate.findings.push_back({"jumps_seen", {}, {}, jumps_seen(s.t), {}, {}, {}});
    }
    certificate.findings.push_back(detail::found_in_its_time("stage_order", claims.stage_order, 0.4, [&] {
        return detail::judge_stage_order(s, claims.stage_order, failures);
    }));
    detail::judge_levels(s, claims, certificate);
    auto properties_left = static_cast<double>(tableaux::yes_no_claims.size());
    for (const auto& [property, member] : tableaux::yes_no_claims) {
        const std::optional<bool> claimed = claims.*member;
        if (!claimed && s.stages() > 16) continue;
        finding f;
        f.name = property;
        f.truth = detail::in_its_time(1 / (1 + properties_left--),
                                      [&, name = property] { return property_of(s, name); });
        if (claimed) {
            f.claimed = *claimed ? "true" : "false";
            f.judgement = *claimed ? *f.truth : negation(*f.truth);
        }
        certificate.findings.push_back(std::move(f));
    }
    for (const auto& [number, member] : tableaux::number_claims)
        if (const auto& claimed = claims.*member)
            certificate.findings.push_back(number_finding(
                number, *claimed, detail::claimed_in_its_time(std::string(number), 0.3, [&, name = number] {
                    return number_of(s, name);
                })));
    certificate.error_metrics = detail::metrics_in_their_time(s, certificate);
}

/// Whether a claim that is a polynomial identity in the entries (row sums where needed, orders, stage order)
/// certainly fails.
template <class K>
bool refutes_a_condition(const subject<K>& s, const tableaux::claims& claims, bool row_sums_needed) {
    bool row_sums_fail = false;
    if (s.nodes_given)
        for (const K& defect : row_sum_defects(s)) row_sums_fail = row_sums_fail || certainly_nonzero(defect);
    if (row_sums_fail && row_sums_needed && claims_row_sums(s, claims)) return true;
    const auto falls_short = [&](const auto& weights, int claimed) {
        if (claimed < 1) return false;
        if (claimed > tableaux::largest_order)
            return detail::judge_high_order(s, weights, "order", claimed).judgement->is_refuted();
        if (find_order(s, weights, claimed).order < claimed) return true;
        return row_sums_fail && non_autonomous_order(s, weights, std::min(claimed, 8)) < std::min(claimed, 8);
    };
    if (falls_short(s.t.b, claims.order.value_or(0))) return true;
    if (claims.embedded_order && falls_short(s.t.b_embedded, *claims.embedded_order)) return true;
    if (claims.stage_order && find_stage_order(s, *claims.stage_order).stage_order < *claims.stage_order)
        return true;
    for (const auto name : level_names)
        if (const auto claimed = detail::claimed_level(claims, name))
            if (*claimed <= most_looked_at(name))
                if (find_levels(s, name, *claimed).value < *claimed) return true;
    return false;
}

/// Whether some claim certainly fails: what judge() would refute, found with less work.
template <class K>
bool refutes_a_claim(const subject<K>& s, const tableaux::claims& claims, bool row_sums_needed) {
    if (refutes_a_condition(s, claims, row_sums_needed)) return true;
    for (const auto& [property, member] : tableaux::yes_no_claims) {
        if (!(claims.*member)) continue;
        const verdict v = property_of(s, property);
        if (*(claims.*member) ? v.is_refuted() : v.is_proved()) return true;
    }
    for (const auto& [number, member] : tableaux::number_claims)
        if (const auto& claimed = claims.*member)
            if (judge_number(*claimed, number_of(s, number)).is_refuted()) return true;
    return false;
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/judge_claims-inl.hpp"
#endif
