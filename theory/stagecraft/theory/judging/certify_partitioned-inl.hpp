// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/certify_partitioned.hpp"

#include <string>
#include <utility>
#include <variant>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/judging/coupling_suspects.hpp"
#include "stagecraft/theory/judging/in_its_time.hpp"
#include "stagecraft/theory/judging/judge_coupling.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE file_certificate certify(const tableaux::partitioned_file& file) {
    file_certificate certificate;
    certificate.name = file.name;
    certificate.source = file.source;
    certificate.data = std::string(name(file.coupling)) + ", " + std::string(tableaux::name(file.kind()));
    certificate.stages = file.stages();
    certificate.tableau = to_json(file);
    const auto examine = [&]<class K>(subject<K> (*convert)(const tableaux::tableau_file&)) {
        coupled_subject<K> s{&file, {}};
        for (const auto& p : file.partners) s.partners.push_back(convert(p));
        judge(s, certificate);
        if (detail::judged_alone(file))
            for (std::size_t k = 0; k < file.partners.size(); ++k) {
                certificate.partners.push_back(certify(detail::partner_alone(file, k)));
                if (file.claims.order && !file.partners[k].claims.order)
                    certificate.partners.back().notes.push_back(
                        "judged by itself; the orders claimed are those of the whole method");
            }
        if (certificate.overall() != standing::refuted) return;
        try {
            find_coupling_suspects(s, certificate);
        } catch (const tableaux::out_of_time&) {
            certificate.suspects_note = detail::no_time_for_suspects;
        }
    };
    if (file.kind() <= tableaux::number_kind::quadratic)
        examine(detail::exact_subject);
    else
        examine(detail::enclosed_subject);
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
