// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/certify_file.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/read.hpp"
#include "stagecraft/tableaux/reading.hpp"
#include "stagecraft/theory/judging/find_suspects.hpp"
#include "stagecraft/theory/judging/in_its_time.hpp"
#include "stagecraft/theory/judging/judge_claims.hpp"
#include "stagecraft/theory/judging/judge_dense.hpp"
#include "stagecraft/theory/judging/nearest_family.hpp"
#include "stagecraft/theory/judging/subject.hpp"
#include "stagecraft/theory/judging/subject_spectrum.hpp"
#include "stagecraft/theory/judging/two_faults.hpp"

namespace stagecraft::theory {

namespace detail {

template <class K>
void judge_dense_in_its_time(const dense_subject<K>& subject, const tableaux::tableau_file& file,
                             file_certificate& certificate) {
    try {
        const tableaux::time_share share(tableaux::time_share::left() / 2);
        judge_dense(subject, file, certificate);
    } catch (const tableaux::out_of_time&) {
        certificate.findings.push_back(not_found_in_time("dense_order", file.claims.dense_order));
    }
}

/// Everything but suspects of what `certify` says of a file.
STAGECRAFT_INLINE file_certificate judged(const tableaux::tableau_file& file) {
    file_certificate certificate;
    if (const int n = file.short_decimals; n > 0)
        certificate.notes.push_back(std::to_string(n) + " short decimal" + (n == 1 ? "" : "s") +
                                    " read as exact");
    certificate.name = file.name;
    certificate.source = file.source;
    certificate.data = tableaux::name(file.kind());
    certificate.stages = file.stages();
    certificate.file = file;
    certificate.tableau = tableaux::to_json(file);
    const auto examine = [&](const auto& subject, const auto& convert) {
        judge(subject, file.claims, certificate);
        if (!file.b_theta.empty())
            judge_dense_in_its_time(make_dense_subject(subject, file, convert), file, certificate);
        const tableaux::time_share share(tableaux::time_share::left() / 2);
        certificate.spectra = spectra_of(subject);
    };
    if (file.kind() <= tableaux::number_kind::quadratic)
        examine(exact_subject(file), exact_entry);
    else
        examine(enclosed_subject(file), enclosed_entry);
    try {
        const tableaux::time_share share(tableaux::time_share::left() / 2);
        certificate.nearest = nearest(file);
    } catch (const tableaux::out_of_time&) {  // a remark, of which nothing is claimed
    }
    return certificate;
}

/// Whether a row of A or the weights have sums that certainly are not what they should be: how many have.
STAGECRAFT_INLINE std::size_t certainly_failing_sums(const tableaux::tableau_file& file) {
    return failing_sums(enclosed_subject(file), file.claims).size();
}

/// What the decimals, cut off and not rounded, would make of a refuted certificate, or the suspects.
STAGECRAFT_INLINE file_certificate explained(const tableaux::tableau_file& file,
                                             file_certificate certificate) {
    if (file.kind() != tableaux::number_kind::rounded) {
        find_suspects(file, certificate);
        return certificate;
    }
    const auto cut = tableaux::cut_off(file);
    const auto subject = enclosed_subject(cut);
    if (!refutes_a_claim(subject, cut.claims, mostly_row_sums(subject))) {
        auto other = judged(cut);
        if (other.overall() != standing::refuted) {
            other.notes.insert(other.notes.begin(), "decimals cut off, not rounded: refuted otherwise");
            return other;
        }
    }
    const bool cut_fits = certainly_failing_sums(cut) < certainly_failing_sums(file);
    find_suspects(cut_fits ? cut : file, certificate);
    return certificate;
}

}  // namespace detail

STAGECRAFT_INLINE file_certificate certify(const tableaux::tableau_file& file) {
    auto certificate = detail::judged(file);
    const bool explained = !certificate.suspects.empty() || !certificate.suspects_note.empty();
    if (certificate.overall() != standing::refuted || explained) return certificate;
    try {
        return detail::explained(file, certificate);
    } catch (const tableaux::out_of_time&) {
        certificate.suspects_note = detail::no_time_for_suspects;
        return certificate;
    }
}

}  // namespace stagecraft::theory
