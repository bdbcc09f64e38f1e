// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/find_suspects.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/rough_ball.hpp"
#include "stagecraft/theory/judging/form_suspects.hpp"
#include "stagecraft/theory/judging/judge_claims.hpp"
#include "stagecraft/theory/judging/suspects.hpp"
#include "stagecraft/theory/judging/two_faults.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE subject<tableaux::quadratic> exact_subject(const tableaux::tableau_file& file) {
    return make_subject<tableaux::quadratic>(file, exact_entry);
}

STAGECRAFT_INLINE subject<tableaux::ball> enclosed_subject(const tableaux::tableau_file& file) {
    return make_subject<tableaux::ball>(file, enclosed_entry);
}

/// Whether some repair was at the level of rounding.
template <class K>
bool add_suspects(const subject<K>& s, const tableaux::tableau_file& file,
                  const std::vector<place>& candidates, file_certificate& certificate) {
    return append_suspects(file, find_repairs(s, file.claims, candidates), certificate.suspects);
}

/// Where a single entry keeps the file from being exact (a decimal among fractions, a second surd), that
/// entry may be solved for exactly in the field of the others.
STAGECRAFT_INLINE std::optional<place> lone_inexact_entry(const tableaux::tableau_file& file,
                                                          const std::vector<place>& all) {
    int outside = 0;
    file.for_each_entry([&](const tableaux::entry& e) { outside += e.exact ? 0 : 1; });
    if (outside > 1) return std::nullopt;
    std::optional<place> lone;
    for (const place& p : all) {
        tableaux::tableau_file without = file;
        auto& e = const_cast<tableaux::entry&>(entry_at(without, p));
        if (e.exact && e.exact->is_rational()) continue;
        e = tableaux::read_entry("0");
        if (without.kind() > tableaux::number_kind::quadratic) continue;
        if (lone) return std::nullopt;
        lone = p;
    }
    return lone;
}

/// Single entries whose change restores every claim; whether what fails is at the level of rounding.
STAGECRAFT_INLINE bool find_single_faults(const tableaux::tableau_file& file, const std::vector<place>& all,
                                          file_certificate& certificate) {
    if (file.kind() <= tableaux::number_kind::quadratic)
        return add_suspects(exact_subject(file), file, all, certificate);
    auto others = all;
    if (const auto lone = lone_inexact_entry(file, all)) {
        tableaux::tableau_file without = file;
        const_cast<tableaux::entry&>(entry_at(without, *lone)) = tableaux::read_entry("0");
        append_suspects(file, find_repairs(exact_subject(without), file.claims, {*lone}),
                        certificate.suspects);
        std::erase(others, *lone);
    }
    return add_suspects(enclosed_subject(file), file, others, certificate);
}

/// A fault in A, b or c and another in b_embedded: whether the former, repaired, leaves only claims on
/// b_embedded open, and if so the latter.
template <class K>
bool find_two_faults(const subject<K>& s, const tableaux::tableau_file& file, const std::vector<place>& all,
                     file_certificate& certificate) {
    if (!file.claims.embedded_order) return false;
    tableaux::claims main = file.claims;
    main.embedded_order.reset();
    std::vector<place> embedded, others;
    for (const place& p : all) (p.part == part::b_embedded ? embedded : others).push_back(p);
    const auto first = find_repairs(s, main, others);
    if (first.empty() || append_suspects(file, first, certificate.suspects)) return false;
    rank(certificate.suspects);
    const auto likeliest = std::find_if(first.begin(), first.end(), [&](const auto& r) {
        return r.place.name() == certificate.suspects.front().entry;
    });
    subject<K> repaired = s;
    put(repaired, likeliest->place, likeliest->value);
    std::vector<suspect> second;
    append_suspects(file, find_repairs(repaired, file.claims, embedded), second);
    rank(second);
    certificate.suspects_note =
        second.empty() ? "a change of one of these restores every claim but those on b_embedded"
                       : "two faults: the change of " + certificate.suspects.front().entry + " and that of " +
                             second.front().entry + " together restore every claim";
    certificate.suspects.insert(certificate.suspects.begin() + 1, second.begin(), second.end());
    return true;
}

/// 0 beyond doubt.
template <class K>
bool vanishes_exactly(const K& x) {
    if constexpr (exact_scalar<K>)
        return x == K(0);
    else
        return x.exactly_zero();
}

/// Something done to a whole table, and its words.
template <class K>
struct mix_up {
    std::string what;
    subject<K> undone;
};

/// A column of A lost, so that those after it have moved to the left, in all rows or in one: put back, with
/// what the row sums leave for it.
template <class K, class Add>
void lost_columns(const subject<K>& s, Add add) {
    if (!s.nodes_given) return;
    const int n = s.stages();
    const auto put_back = [n, lower = s.strictly_lower](auto& t, int row, int column) {
        const int last = lower ? row - 1 : n - 1;
        if (column > last) return;
        K sum(0);
        for (int k = last; k > column; --k) t.A(row, k) = t.A(row, k - 1);
        t.A(row, column) = K(0);
        for (int k = 0; k < n; ++k) sum = sum + t.A(row, k);
        t.A(row, column) = t.c(row) - sum;
    };
    const auto ends_with_zero = [&](int row) {
        const int last = s.strictly_lower ? row - 1 : n - 1;
        return last < 0 || !certainly_nonzero(K(s.t.A(row, last)));
    };
    bool every_row = true;
    for (int i = 0; i < n; ++i) every_row = every_row && ends_with_zero(i);
    for (int j = 0; j < n; ++j) {
        const std::string column = "[" + std::to_string(j + 1) + "]";
        if (every_row)
            add("column " + column + " of A is lost", [=](auto& t) {
                for (int i = 0; i < n; ++i) put_back(t, i, j);
            });
        for (int i = 0; i < n; ++i)
            if (ends_with_zero(i) && (!s.strictly_lower || j < i))
                add("entry " + column + " of row [" + std::to_string(i + 1) + "] of A is lost",
                    [=](auto& t) { put_back(t, i, j); });
    }
}

/// A transposed, b and b_embedded exchanged, two rows of A, two entries of a row, of b or of c exchanged, the rows of
/// A, one row, or weights shifted, a column lost: `visit` sees each undone, until it returns true.
template <class K, class Visit>
void visit_mix_ups(const subject<K>& s, Visit visit) {
    bool found = false;
    const auto add = [&](std::string what, auto change) {
        if (found) return;
        tableaux::time_share::check_now();
        mix_up<K> m{std::move(what), s};
        change(m.undone.t);
        if (!s.nodes_given)
            for (int i = 0; i < s.stages(); ++i) m.undone.t.c(i) = m.undone.t.A.row(i).sum();
        found = visit(m);
    };
    add("A is transposed", [](auto& t) { t.A = t.A.transpose().eval(); });
    if (s.t.b_embedded.size() > 0)
        add("b and b_embedded are exchanged", [](auto& t) { t.b.swap(t.b_embedded); });
    const int n = s.stages();
    add("the rows of A are shifted by one", [n](auto& t) {
        const auto old = t.A;
        for (int i = 0; i < n; ++i) t.A.row(i) = old.row((i + n - 1) % n);
    });
    const auto turned = [n](auto&& row, int by) {
        const auto old = row.eval();
        for (int k = 0; k < n; ++k) row(k) = old((k + by + n) % n);
    };
    for (const int by : {1, -1}) {
        for (int i = 0; i < n; ++i)
            add("row [" + std::to_string(i + 1) + "] of A is shifted by one entry",
                [=](auto& t) { turned(t.A.row(i), by); });
        add("b is shifted by one entry", [=](auto& t) { turned(t.b, by); });
        if (s.t.b_embedded.size() > 0)
            add("b_embedded is shifted by one entry", [=](auto& t) { turned(t.b_embedded, by); });
    }
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < i; ++j) {
            const std::string pair = "[" + std::to_string(j + 1) + "] and [" + std::to_string(i + 1) + "]";
            add("rows " + pair + " of A are exchanged", [i, j](auto& t) { t.A.row(i).swap(t.A.row(j)); });
            add("entries " + pair + " of b are exchanged", [i, j](auto& t) { std::swap(t.b(i), t.b(j)); });
            if (s.nodes_given)
                add("entries " + pair + " of c are exchanged",
                    [i, j](auto& t) { std::swap(t.c(i), t.c(j)); });
            if (s.t.b_embedded.size() > 0)
                add("entries " + pair + " of b_embedded are exchanged",
                    [i, j](auto& t) { std::swap(t.b_embedded(i), t.b_embedded(j)); });
        }
    if (n <= 16)
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < (s.strictly_lower ? i : n); ++j)
                for (int k = 0; k < j; ++k)
                    add("entries " + place{part::A, i, k}.name() + " and " + place{part::A, i, j}.name() +
                            " are exchanged",
                        [=](auto& t) { std::swap(t.A(i, j), t.A(i, k)); });
    lost_columns(s, add);
}

/// Whether undoing it leaves an explicit method explicit, and a diagonally implicit one that.
template <class K>
bool keeps_structure(const mix_up<K>& m) {
    const auto& A = m.undone.t.A;
    for (int i = 0; i < A.rows(); ++i)
        for (int j = i; j < A.rows(); ++j)
            if ((m.undone.strictly_lower || (m.undone.lower && j > i)) && !vanishes_exactly(K(A(i, j))))
                return false;
    return true;
}

/// What is mixed up if undoing it restores every claim. Of those that do or do not respect its
/// structure.
template <class K>
std::string find_mix_up(const subject<K>& s, const tableaux::claims& claims, bool structured) {
    std::string what;
    visit_mix_ups(s, [&](const mix_up<K>& m) {
        if (keeps_structure(m) != structured || !keeps_claims(m.undone, claims)) return false;
        what = m.what;
        return true;
    });
    return what;
}

/// Whether a change of a zero that makes the method what it is, explicit or diagonally implicit, restores every claim.
template <class K>
bool find_beyond_structure(subject<K> s, const tableaux::tableau_file& file, const std::vector<place>& within,
                           file_certificate& certificate) {
    std::vector<place> beyond;
    for (const place& p : places_of(file))
        if (std::find(within.begin(), within.end(), p) == within.end()) beyond.push_back(p);
    s.strictly_lower = s.lower = false;
    append_suspects(file, find_repairs(s, file.claims, beyond), certificate.suspects);
    rank(certificate.suspects);
    return !certificate.suspects.empty();
}

STAGECRAFT_INLINE void find_suspects(tableaux::tableau_file file, file_certificate& certificate) {
    // Weights that do not sum to 1 are refuted without a claim: a repair has to mend them as well.
    if (!file.claims.order) file.claims.order = 1;
    if (!file.b_embedded.empty() && !file.claims.embedded_order) file.claims.embedded_order = 1;
    const int highest = std::max(file.claims.order.value_or(0), file.claims.embedded_order.value_or(0));
    if (highest > tableaux::largest_order) {
        certificate.suspects_note = "no entry is suspected: beyond order 14 the trees are not looked at";
        return;
    }
    if (file.form) {
        if (file.kind() <= tableaux::number_kind::quadratic)
            find_form_suspects(file, exact_entry, certificate);
        else
            find_form_suspects(file, enclosed_entry, certificate);
        return;
    }
    const auto all = places_of_kind(file);
    const bool rounding = find_single_faults(file, all, certificate);
    rank(certificate.suspects);
    auto& note = certificate.suspects_note;
    if (certificate.suspects.size() == 1) return;
    if (!certificate.suspects.empty()) {
        note = several_repairs;
        return;
    }
    if (rounding) {
        note = only_rounding_fails;
        return;
    }
    const auto several = [&](const auto& s) {
        for (const bool structured : {true, false}) {
            note = find_mix_up(s, file.claims, structured);
            if (!note.empty()) {
                note += undone;
                return;
            }
            if (structured &&
                (find_two_in_sums(s, file, certificate) || find_two_faults(s, file, all, certificate)))
                return;
        }
        note = find_beyond_structure(s, file, all, certificate)
                   ? "no change within its structure restores every claim; a change of this zero does"
                   : "no change of a single entry restores every claim";
    };
    if (file.kind() <= tableaux::number_kind::quadratic)
        several(exact_subject(file));
    else
        several(enclosed_subject(file));
}

}  // namespace detail

}  // namespace stagecraft::theory
