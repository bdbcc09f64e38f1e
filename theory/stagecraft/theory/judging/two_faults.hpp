// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <stagecraft/tableaux/rough_ball.hpp>
#include <stagecraft/theory/judging/file_certificate.hpp>
#include <stagecraft/theory/judging/judge_claims.hpp>
#include <stagecraft/theory/judging/suspects.hpp>
#include <string>
#include <utility>
#include <vector>

namespace stagecraft::theory::detail {

/// A sum that the claims fix (a row of A, of which c is the sum; b; b_embedded) and that is off by `defect`. A
/// wrong entry shows here first, and only an entry of the sum can be to blame.
template <class K>
struct failing_sum {
    K defect;
    std::vector<place> places;
};

template <class K>
std::vector<failing_sum<K>> failing_sums(const subject<K>& s, const tableaux::claims& claims) {
    std::vector<failing_sum<K>> all;
    const int n = s.stages();
    if (s.nodes_given) {
        const auto defects = row_sum_defects(s);
        for (int i = 0; i < n; ++i) {
            const K& defect = defects[static_cast<std::size_t>(i)];
            if (!certainly_nonzero(defect)) continue;
            all.push_back({defect, {}});
            const int end = s.strictly_lower ? i : s.lower ? i + 1 : n;
            for (int j = 0; j < end; ++j)  // of two faults none is a lone zero
                if (certainly_nonzero(K(s.t.A(i, j)))) all.back().places.push_back({part::A, i, j});
            all.back().places.push_back({part::c, i, 0});
        }
    }
    const auto weights = [&](const auto& b, part which) {
        const K defect = b.sum() - K(1);
        if (!certainly_nonzero(defect)) return;
        all.push_back({defect, {}});
        for (int i = 0; i < n; ++i)
            if (certainly_nonzero(K(b(i)))) all.back().places.push_back({which, i, 0});
    };
    if (claims.order.value_or(0) > 0) weights(s.t.b, part::b);
    if (claims.embedded_order.value_or(0) > 0) weights(s.t.b_embedded, part::b_embedded);
    return all;
}

/// Changes the entry so that its sum minus what it should be grows by `amount`.
template <class K>
void shift(subject<K>& s, const place& p, const K& amount) {
    const K& old = value_at(s, p);
    put(s, p, p.part == part::c ? K(old - amount) : K(old + amount));
}

/// The same tableau in numbers that say no quickly: residues of exact ones, enclosures of few digits.
template <class K>
auto quick(const subject<K>& s) {
    if constexpr (exact_scalar<K>)
        return reduced_modulo_prime(s);
    else
        return std::optional(
            mapped<tableaux::rough_ball>(s, [](const K& x) { return tableaux::rough_ball(x); }));
}

/// Two faults in one sum: what to take from the first entry for the second, over what makes the sum right.
/// The first condition that is affine in it leaves one value.
template <class K, class Quick>
std::optional<K> exchanged_amount(const subject<K>& s, const Quick& rough, const place& p, const place& q,
                                  const tableaux::claims& claims, const tree_view& trees) {
    const auto moved = [&](const auto& from, int x) {
        auto t = from;
        using scalar = std::decay_t<decltype(t.t.b(0))>;
        shift(t, p, scalar(x));
        shift(t, q, scalar(-x));
        return t;
    };
    using kind = determination::kind;
    for (const auto& [by, claimed] : {std::pair(kind::order_condition, claims.order),
                                      std::pair(kind::embedded_condition, claims.embedded_order)}) {
        if (claimed.value_or(0) < 2) continue;
        const std::array probes{moved(rough, 0), moved(rough, 1), moved(rough, 2)};
        const auto weights = [by = by](const auto& x) -> const auto& { return weights_of(x, by); };
        const auto row = affine_condition(probes, weights, trees, *claimed);
        if (!row) continue;
        const auto residual = [&, by = by](int x) {
            const auto t = moved(s, x);
            return residual_of_row(t, weights_of(t, by), trees, *row);
        };
        const K at_zero = residual(0), slope = residual(1) - at_zero;
        if (certainly_nonzero(slope)) return K(-at_zero / slope);
    }
    return std::nullopt;
}

/// Two entries and the values that together restore every claim.
template <class K>
struct repaired_pair {
    repair<K> first, second;
};

/// The rows of A and b where none of these sums fails: two entries of one may be off by opposite amounts, zeros
/// within the structure among them.
template <class K>
std::vector<failing_sum<K>> intact_sums(const subject<K>& s) {
    std::vector<failing_sum<K>> all;
    const int n = s.stages();
    for (int i = 0; i < n; ++i) {
        all.push_back({K(0), {}});
        const int end = s.strictly_lower ? i : s.lower ? i + 1 : n;
        for (int j = 0; j < end; ++j) all.back().places.push_back({part::A, i, j});
    }
    all.push_back({K(0), {}});
    for (int i = 0; i < n; ++i) all.back().places.push_back({part::b, i, 0});
    return all;
}

/// Beyond this the pairs within sums that do not fail are too many.
inline constexpr int most_stages_of_opposite_faults = 8;

/// All pairs of entries, one of each failing sum where two fail and both of it where one does, or of any where none does,
/// whose change restores every claim.
template <class K>
std::vector<repaired_pair<K>> find_repaired_pairs(const subject<K>& s, const tableaux::claims& claims) {
    std::vector<repaired_pair<K>> found;
    auto sums = failing_sums(s, claims);
    const auto rough = quick(s);
    const int highest = std::max(claims.order.value_or(0), claims.embedded_order.value_or(0));
    const bool intact = sums.empty() && s.nodes_given && s.stages() <= most_stages_of_opposite_faults &&
                        highest > 2;  // or the one condition of order 2 would be met by any pair
    if (intact) sums = intact_sums(s);
    if (sums.empty() || (sums.size() > 2 && !intact) || !rough) return found;
    const bool row_sums = !s.nodes_given || mostly_row_sums(s);
    const auto attempt = [&](const place& p, const K& at_p, const place& q, const K& at_q) {
        tableaux::time_share::check_now();
        subject<K> changed = s;
        shift(changed, p, at_p);
        shift(changed, q, at_q);
        const auto fast = quick(changed);
        if (!fast || refutes_a_condition(*fast, claims, row_sums)) return;
        if (refutes_a_claim(changed, claims, row_sums)) return;
        found.push_back({{p, value_at(changed, p)}, {q, value_at(changed, q)}});
    };
    if (sums.size() == 2 && !intact) {
        for (const place& p : sums[0].places)
            for (const place& q : sums[1].places) attempt(p, -sums[0].defect, q, -sums[1].defect);
        return found;
    }
    const tree_table table(std::max({claims.order.value_or(1), claims.embedded_order.value_or(1), 1}));
    for (const auto& [defect, places] : sums)
        for (std::size_t k = 0; k < places.size(); ++k)
            for (std::size_t i = 0; i < k; ++i) {
                tableaux::time_share::check_now();
                subject<K> right = s;
                if (!intact) shift(right, places[i], K(-defect));
                const auto fast = quick(right);
                if (!fast) continue;
                const auto amount =
                    exchanged_amount(right, *fast, places[i], places[k], claims, table.view());
                if (amount) attempt(places[i], K(*amount - defect), places[k], K(-*amount));
            }
    return found;
}

/// Names two entries that are wrong together, but none at the level of rounding; the likeliest misprints first.
template <class K>
bool find_two_in_sums(const subject<K>& s, const tableaux::tableau_file& file,
                      file_certificate& certificate) {
    struct named {
        suspect first, second;
        int distance;
    };
    std::vector<named> all;
    const auto suspect_of = [&](const repair<K>& r) {
        const auto& old = entry_at(file, r.place);
        return suspect{r.place.name(), old.text, suggestion(r.value, old)};
    };
    const bool fractions = tableaux::has_rounded_fractions(file);
    const auto rounding = [&](const repair<K>& r) {
        return only_rounding(file, r.place, range_of(r.value), fractions);
    };
    for (const auto& [first, second] : find_repaired_pairs(s, file.claims)) {
        if (rounding(first) || rounding(second)) continue;
        named pair{suspect_of(first), suspect_of(second), 0};
        for (const suspect* x : {&pair.first, &pair.second})
            pair.distance += misprint_distance(without_notation(x->written), without_notation(x->suggest));
        all.push_back(std::move(pair));
    }
    if (all.empty()) return false;
    std::stable_sort(all.begin(), all.end(),
                     [](const named& x, const named& y) { return x.distance < y.distance; });
    certificate.suspects_note = "two faults: the change of " + all.front().first.entry + " and that of " +
                                all.front().second.entry + " together restore every claim" +
                                (all.size() > 1 ? ", and so do other pairs" : "");
    for (auto& [first, second, distance] : all) {
        certificate.suspects.push_back(std::move(first));
        certificate.suspects.push_back(std::move(second));
    }
    return true;
}

}  // namespace stagecraft::theory::detail
