// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <stagecraft/tableaux/stage_form.hpp>
#include <stagecraft/theory/judging/file_certificate.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <stagecraft/theory/judging/suspects.hpp>
#include <string>
#include <utility>
#include <vector>

/// Which coefficient of a Shu-Osher or low-storage form may be wrong: the file has no other entries.

namespace stagecraft::theory::detail {

/// The coefficients of a form as numbers, row by row.
template <class K>
using form_values = std::vector<std::vector<K>>;

/// The tableau that they mean. Each of its entries is affine in each single coefficient.
template <class K>
subject<K> subject_of_form(tableaux::stage_form::kind kind, const form_values<K>& values) {
    const auto registers = tableaux::registers_of(kind, values);
    const int n = static_cast<int>(registers.size()) - 1;
    subject<K> s{{}, false, true, true};
    s.t.A.resize(n, n);
    s.t.b.resize(n);
    s.t.c.resize(n);
    for (int i = 0; i <= n; ++i) {
        K sum(0);
        for (int j = 0; j < n; ++j) {
            const K& weight = registers[static_cast<std::size_t>(i)].f[static_cast<std::size_t>(j)];
            (i < n ? s.t.A(i, j) : s.t.b(j)) = weight;
            sum = sum + weight;
        }
        if (i < n) s.t.c(i) = sum;
    }
    return s;
}

/// The coefficients that may be wrong. Those of alpha, gamma and delta are not among them where the file is read at
/// all: they are fixed by each other. A zero may be wrong as well, in forms of moderate size.
std::vector<place> form_places(const tableaux::stage_form& form);

/// The coefficients whose change alone restores every claim. The first order condition that is affine in a
/// coefficient and not constant leaves one value for it.
template <class K>
std::vector<repair<K>> find_form_repairs(tableaux::stage_form::kind kind, const form_values<K>& values,
                                         const tableaux::claims& claims,
                                         const std::vector<place>& candidates) {
    std::vector<repair<K>> repairs;
    if (claims.order.value_or(0) < 1) return repairs;
    const tree_table table(*claims.order);
    for (const place& p : candidates) {
        tableaux::time_share::check_now();
        const auto with = [&](const K& x) {
            auto changed = values;
            changed[static_cast<std::size_t>(p.row)][static_cast<std::size_t>(p.column)] = x;
            return subject_of_form(kind, changed);
        };
        const std::array probes{with(K(0)), with(K(1)), with(K(2))};
        const auto weights = [](const subject<K>& x) -> const auto& { return x.t.b; };
        const auto row = affine_condition(probes, weights, table.view(), *claims.order);
        if (!row) continue;
        const K at_zero = residual_of_row(probes[0], probes[0].t.b, table.view(), *row);
        const K slope = residual_of_row(probes[1], probes[1].t.b, table.view(), *row) - at_zero;
        if (!certainly_nonzero(slope)) continue;
        const K value = -at_zero / slope;
        const K& old = values[static_cast<std::size_t>(p.row)][static_cast<std::size_t>(p.column)];
        if (certainly_nonzero(K(value - old)) && keeps_claims(with(value), claims))
            repairs.push_back({p, value});
    }
    return repairs;
}

/// Two coefficients of one list that are exchanged.
template <class K>
std::string find_exchanged(const tableaux::stage_form& form, form_values<K> values,
                           const tableaux::claims& claims, const std::vector<place>& candidates) {
    for (const place& p : candidates)
        for (const place& q : candidates) {
            if (p.row != q.row || q.column >= p.column) continue;
            auto& row = values[static_cast<std::size_t>(p.row)];
            const auto i = static_cast<std::size_t>(p.column), k = static_cast<std::size_t>(q.column);
            std::swap(row[i], row[k]);
            const bool restored = keeps_claims(subject_of_form(form.which, values), claims);
            std::swap(row[i], row[k]);
            const auto at = static_cast<std::size_t>(p.row);
            if (restored) return form.name(at, k) + " and " + form.name(at, i) + " are exchanged";
        }
    return {};
}

/// The embedded weights and nodes whose change alone restores every claim, or two of them that are exchanged: they stand beside the
/// form. Whether what fails is at the level of rounding.
template <class K>
bool find_suspects_beside(const tableaux::tableau_file& file, subject<K> s, file_certificate& certificate) {
    std::vector<place> beside;
    for (const auto part : {part::b_embedded, part::c})
        for (std::size_t i = 0; i < (part == part::c ? file.c : file.b_embedded).size(); ++i)
            beside.push_back({part, static_cast<int>(i), 0});
    const bool rounding = append_suspects(file, find_repairs(s, file.claims, beside), certificate.suspects);
    if (!certificate.suspects.empty()) return rounding;
    for (const place& p : beside)
        for (const place& q : beside) {
            if (q.part != p.part || q.row >= p.row) continue;
            subject<K> changed = s;
            put(changed, p, value_at(s, q));
            put(changed, q, value_at(s, p));
            if (!keeps_claims(changed, file.claims)) continue;
            certificate.suspects_note = q.name() + " and " + p.name() + " are exchanged" + undone;
            return rounding;
        }
    return rounding;
}

/// Names what may be wrong in a file that gives a form; `convert` takes an entry to K.
template <class K>
void find_form_suspects(const tableaux::tableau_file& file, K (*convert)(const tableaux::entry&),
                        file_certificate& certificate) {
    const auto& form = *file.form;
    tableaux::claims claims = file.claims;  // b_embedded is no coefficient of the form
    claims.embedded_order.reset();
    form_values<K> values;
    for (const auto& row : form.rows) {
        values.emplace_back();
        for (const auto& e : row) values.back().push_back(convert(e));
    }
    tableaux::tableau_file given;  // the coefficients in the place of A
    given.A = form.rows;
    const bool form_holds = keeps_claims(subject_of_form(form.which, values), claims);
    bool rounding = form_holds && find_suspects_beside(file, make_subject<K>(file, convert), certificate);
    const auto candidates = form_holds ? std::vector<place>{} : form_places(form);
    for (const auto& r : find_form_repairs(form.which, values, claims, candidates)) {
        std::vector<suspect> found;
        rounding = append_suspects(given, std::vector{r}, found) || rounding;
        for (suspect& x : found) {
            x.entry =
                form.name(static_cast<std::size_t>(r.place.row), static_cast<std::size_t>(r.place.column));
            certificate.suspects.push_back(std::move(x));
        }
    }
    rank(certificate.suspects);
    auto& note = certificate.suspects_note;
    if (certificate.suspects.size() > 1)
        note = several_repairs;
    else if (certificate.suspects.empty() && rounding)
        note = only_rounding_fails;
    else if (certificate.suspects.empty() && note.empty()) {
        note = find_exchanged(form, values, claims, candidates);
        note = note.empty() ? "no change of a single coefficient restores every claim" : note + undone;
    }
}

}  // namespace stagecraft::theory::detail

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/form_suspects-inl.hpp"
#endif
