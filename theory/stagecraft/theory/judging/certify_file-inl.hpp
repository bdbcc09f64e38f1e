// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/certify_file.hpp"

#include <algorithm>
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
#include "stagecraft/theory/judging/other_readings.hpp"
#include "stagecraft/theory/judging/resolution.hpp"
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

/// Whether something is refuted, or an order that nobody claims holds up to small residuals only.
STAGECRAFT_INLINE bool fails_as_written(const file_certificate& c) {
    return c.overall() == standing::refuted ||
           std::any_of(c.findings.begin(), c.findings.end(),
                       [](const finding& f) { return f.numerical && !f.claimed; });
}

/// The file with the orders claimed that a certificate found.
STAGECRAFT_INLINE tableaux::tableau_file with_orders_of(tableaux::tableau_file file,
                                                        const file_certificate& c) {
    if (const auto* f = c.find("order"); f && f->value && !file.claims.order) file.claims.order = f->value;
    if (const auto* f = c.find("embedded_order"); f && f->value && !file.claims.embedded_order)
        file.claims.embedded_order = f->value;
    return file;
}

/// Whether a reading takes nothing but embedded weights otherwise than they are written, beside exact A, b and c.
STAGECRAFT_INLINE bool only_embedded_weights_differ(tableaux::tableau_file written,
                                                    tableaux::tableau_file taken) {
    for (auto* f : {&written, &taken}) f->b_embedded.clear();
    std::vector<tableaux::range> entries;
    written.for_each_entry([&](const tableaux::entry& e) { entries.push_back(e.enclosure); });
    std::size_t k = 0;
    bool same = written.kind() <= tableaux::number_kind::quadratic;
    taken.for_each_entry([&](const tableaux::entry& e) { same = same && e.enclosure == entries[k++]; });
    return same;
}

/// The certificate of the first reading as which nothing fails, or nothing. What is exact stays proved where another reading takes
/// embedded weights alone.
STAGECRAFT_INLINE std::optional<file_certificate> judged_otherwise(const tableaux::tableau_file& given,
                                                                   const std::vector<other_reading>& readings,
                                                                   const file_certificate& written) {
    for (const auto& [file, what, rule] : readings) {
        const auto subject = enclosed_subject(file);
        if (refutes_a_claim(subject, file.claims, mostly_row_sums(subject))) continue;
        auto certificate = judged(file);
        if (fails_as_written(certificate)) continue;
        for (finding& f : certificate.findings) {
            const finding* exact = written.find(f.name);
            const bool of_weights = f.name.starts_with("embedded") || f.name == "jumps_seen";
            if (exact && !of_weights && only_embedded_weights_differ(given, file)) f = *exact;
        }
        describe(what, rule, resolution_of(with_orders_of(file, certificate)), written, certificate);
        return certificate;
    }
    return std::nullopt;
}

/// What the data can be meant as, or suspects, of a certificate that fails. A misprint stands out of the noise of
/// rounding: the readings with the fewest failing sums are searched, the narrowest first.
STAGECRAFT_INLINE file_certificate explained(const tableaux::tableau_file& file,
                                             file_certificate certificate) {
    const auto readings = other_readings(file);
    if (auto other = judged_otherwise(file, readings, certificate)) return *std::move(other);
    if (certificate.overall() != standing::refuted) return certificate;
    std::vector<const tableaux::tableau_file*> ranked;
    for (const auto& r : readings) ranked.push_back(&r.file);
    // As written first, but not where its quotients are rounded: what restores the claims exactly is not what is meant.
    ranked.insert(tableaux::has_rounded_fractions(file) ? ranked.end() : ranked.begin(), &file);
    std::vector<std::size_t> failing;
    for (const auto* f : ranked) failing.push_back(certainly_failing_sums(*f));
    const auto least = *std::min_element(failing.begin(), failing.end());
    std::string first_note;
    for (std::size_t k = 0; k < ranked.size(); ++k) {
        if (failing[k] != least) continue;
        certificate.suspects_note.clear();
        find_suspects(*ranked[k], certificate);
        if (first_note.empty()) first_note = certificate.suspects_note;
        const bool mixed_up = certificate.suspects_note.find(undone) != std::string::npos;
        if (!certificate.suspects.empty() || mixed_up) return certificate;
    }
    certificate.suspects_note = first_note;
    return certificate;
}

}  // namespace detail

STAGECRAFT_INLINE file_certificate certify(const tableaux::tableau_file& file) {
    auto certificate = detail::judged(file);
    const bool explained = !certificate.suspects.empty() || !certificate.suspects_note.empty();
    if (explained || !detail::fails_as_written(certificate)) return certificate;
    try {
        return detail::explained(file, certificate);
    } catch (const tableaux::out_of_time&) {
        if (certificate.overall() == standing::refuted)
            certificate.suspects_note = detail::no_time_for_suspects;
        return certificate;
    }
}

}  // namespace stagecraft::theory
