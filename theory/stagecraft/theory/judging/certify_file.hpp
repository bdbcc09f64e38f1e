// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <ostream>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/theory/judging/file_certificate.hpp>
#include <stagecraft/theory/judging/judge_claims.hpp>
#include <stagecraft/theory/judging/nearest_family.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <stagecraft/theory/judging/subject_spectrum.hpp>
#include <stagecraft/theory/judging/suspects.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stagecraft::theory {

namespace detail {

/// One instantiation serves Q and Q(sqrt d): a rational number in tableaux::quadratic costs what it costs
/// alone.
inline subject<tableaux::quadratic> exact_subject(const tableaux::tableau_file& file) {
    return make_subject<tableaux::quadratic>(file, [](const tableaux::entry& e) { return *e.exact; });
}

inline subject<tableaux::ball> enclosed_subject(const tableaux::tableau_file& file) {
    return make_subject<tableaux::ball>(file, [](const tableaux::entry& e) { return to_ball(e.enclosure); });
}

template <class K>
void add_suspects(const subject<K>& s, const tableaux::tableau_file& file,
                  const std::vector<place>& candidates, file_certificate& certificate) {
    append_suspects(file, find_repairs(s, file.claims, candidates), certificate.suspects);
}

/// Where a single entry keeps the file from being exact (a decimal among fractions, a second surd), that
/// entry may be solved for exactly in the field of the others.
inline std::optional<place> lone_inexact_entry(const tableaux::tableau_file& file,
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

inline void find_suspects(const tableaux::tableau_file& file, file_certificate& certificate) {
    const auto shape = make_subject<int>(file, [](const tableaux::entry&) { return 0; });
    const auto all = places_of(file, shape.strictly_lower, shape.lower);
    const auto kind = file.kind();
    if (kind <= tableaux::number_kind::quadratic) {
        add_suspects(exact_subject(file), file, all, certificate);
    } else {
        auto others = all;
        if (const auto lone = lone_inexact_entry(file, all)) {
            tableaux::tableau_file without = file;
            const_cast<tableaux::entry&>(entry_at(without, *lone)) = tableaux::read_entry("0");
            append_suspects(file, find_repairs(exact_subject(without), file.claims, {*lone}),
                            certificate.suspects);
            std::erase(others, *lone);
        }
        add_suspects(enclosed_subject(file), file, others, certificate);
    }
    rank(certificate.suspects);
    if (certificate.suspects.empty())
        certificate.suspects_note = "no change of a single entry restores every claim";
    else if (certificate.suspects.size() > 1)
        certificate.suspects_note =
            "any one of these changes restores every claim; the claims do not tell which is meant";
}

}  // namespace detail

/// Judges a tableau file: order, stage order, row sums, every property claimed; where something claimed is
/// refuted, the failing conditions and the suspects; eigenvalues of A and poles of R; for rounded data the
/// nearest family. Exact data are decided; rounded and enclosed data are refuted or found consistent.
inline file_certificate certify(const tableaux::tableau_file& file) {
    file_certificate certificate;
    certificate.name = file.name;
    certificate.source = file.source;
    certificate.data = tableaux::name(file.kind());
    certificate.stages = file.stages();
    const auto examine = [&](const auto& subject) {
        judge(subject, file.claims, certificate);
        certificate.spectra = spectra_of(subject);
    };
    if (file.kind() <= tableaux::number_kind::quadratic)
        examine(detail::exact_subject(file));
    else
        examine(detail::enclosed_subject(file));
    certificate.nearest = nearest(file);
    if (certificate.overall() == standing::refuted) detail::find_suspects(file, certificate);
    return certificate;
}

/// What the command does with the text of a file: the certificate to `out`, or one line to `err`.
/// Returns the exit code: 0 nothing claimed is refuted, 1 something is, 2 unusable input.
inline int certify_text(std::string_view text, bool as_json, std::ostream& out, std::ostream& err) {
    try {
        const auto certificate = certify(tableaux::read_tableau(text));
        out << (as_json ? json_text(certificate) : to_text(certificate));
        return certificate.exit_code();
    } catch (const tableaux::unusable_input& e) {
        err << e.what() << '\n';
        return 2;
    }
}

}  // namespace stagecraft::theory
