// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/certify_partitioned.hpp"

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/judging/certify_file.hpp"
#include "stagecraft/theory/judging/coupling_suspects.hpp"
#include "stagecraft/theory/judging/in_its_time.hpp"
#include "stagecraft/theory/judging/judge_coupling.hpp"
#include "stagecraft/theory/judging/judge_rosenbrock.hpp"
#include "stagecraft/theory/judging/judge_together.hpp"
#include "stagecraft/theory/judging/other_readings.hpp"

namespace stagecraft::theory {

namespace detail {

/// Calls `examine` with the subject of the file: exact, or enclosed where it is not or `by_enclosures`.
template <class Examine>
void with_subject(const tableaux::partitioned_file& file, bool by_enclosures, Examine examine) {
    const auto make = [&]<class K>(subject<K> (*convert)(const tableaux::tableau_file&)) {
        coupled_subject<K> s{&file, {}};
        for (const auto& p : file.partners) s.partners.push_back(convert(p));
        examine(s);
    };
    if (!by_enclosures && file.kind() <= tableaux::number_kind::quadratic)
        make(exact_subject);
    else
        make(enclosed_subject);
}

template <class K>
void judge_both(const coupled_subject<K>& s, file_certificate& certificate) {
    judge(s, certificate);
    judge_together(s, certificate);
}

/// Everything but suspects of what `certify` says of a file.
STAGECRAFT_INLINE file_certificate judged(const tableaux::partitioned_file& file, bool by_enclosures) {
    file_certificate certificate;
    certificate.name = file.name;
    certificate.source = file.source;
    certificate.data = std::string(name(file.coupling)) + ", " + std::string(tableaux::name(file.kind()));
    certificate.stages = file.stages();
    certificate.tableau = to_json(file);
    with_subject(file, by_enclosures, [&](const auto& s) {
        if (file.coupling == tableaux::coupling::rosenbrock)
            judge_rosenbrock(s, certificate);
        else
            judge_both(s, certificate);
    });
    if (!judged_alone(file)) return certificate;
    for (std::size_t k = 0; k < file.partners.size(); ++k) {
        certificate.partners.push_back(theory::certify(partner_alone(file, k)));
        if (file.claims.order && !file.partners[k].claims.order)
            certificate.partners.back().notes.push_back(
                "judged by itself; the orders claimed are those of the whole method");
    }
    return certificate;
}

/// The reading as which nothing is refuted, or nothing.
STAGECRAFT_INLINE std::optional<file_certificate> judged_otherwise(
    const std::vector<other_coupled_reading>& readings, const file_certificate& written) {
    for (const auto& [file, what, rule] : readings) {
        auto other = judged(file, true);
        if (fails_as_written(other)) continue;
        describe(what, rule, resolution_of(file), written, other);
        return other;
    }
    return std::nullopt;
}

}  // namespace detail

STAGECRAFT_INLINE file_certificate certify(const tableaux::partitioned_file& file) {
    const auto readings = other_readings(file);
    // Where quotients have many digits, enclosures of them tell in no time what exact arithmetic would have to refute.
    const bool many_digits = !readings.empty() && file.kind() <= tableaux::number_kind::quadratic;
    auto certificate = detail::judged(file, many_digits);
    try {
        if (detail::fails_as_written(certificate)) {
            if (auto other = detail::judged_otherwise(readings, certificate)) return *std::move(other);
        } else if (many_digits) {
            certificate = detail::judged(file, false);
        }
        if (certificate.overall() != standing::refuted) return certificate;
        const auto search = [&](const tableaux::partitioned_file& f) {
            detail::with_subject(f, many_digits,
                                 [&](const auto& s) { find_coupling_suspects(s, certificate); });
            return !certificate.suspects.empty() || !certificate.suspects_note.empty();
        };
        if (!many_digits && search(file)) return certificate;
        for (const auto& r : readings)
            if (search(r.file)) break;
    } catch (const tableaux::out_of_time&) {
        if (certificate.overall() == standing::refuted)
            certificate.suspects_note = detail::no_time_for_suspects;
    }
    return certificate;
}

STAGECRAFT_INLINE file_certificate certify(const tableaux::method_file& file) {
    return std::visit([](const auto& f) { return certify(f); }, file);
}

STAGECRAFT_INLINE int certify_text(std::string_view text, bool as_json, std::ostream& out, std::ostream& err,
                                   const tableaux::reading& how) {
    try {
        const auto certificate = certify(tableaux::read_method_text(text, how));
        out << (as_json ? json_text(certificate) : to_text(certificate));
        return certificate.exit_code();
    } catch (const tableaux::unusable_input& e) {
        err << e.what() << '\n';
        return 2;
    }
}

}  // namespace stagecraft::theory
