// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/rosenbrock_report.hpp"

#include <optional>
#include <string>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/time_share.hpp"
#include "stagecraft/theory/judging/enclosed_report.hpp"
#include "stagecraft/theory/judging/find_suspects.hpp"
#include "stagecraft/theory/judging/in_its_time.hpp"
#include "stagecraft/theory/judging/judge_rosenbrock.hpp"

namespace stagecraft::theory {

namespace detail {

template <class K>
rosenbrock_method<K> rosenbrock_in(const tableaux::partitioned_file& file,
                                   subject<K> (*in)(const tableaux::tableau_file&)) {
    return theory::rosenbrock_of(file, in(file.partners[0]).t, in(file.partners[1]).t);
}

STAGECRAFT_INLINE std::vector<report_section> exact_rosenbrock_report(
    const rosenbrock_method<tableaux::quadratic>& m) {
    const auto t = linear_part(m);
    std::vector<report_section> all{
        {"stability function", function_claims(stability_function_of(t))},
        {"method", {{"stiffly accurate", rosenbrock_property(m, "stiffly_accurate")}}}};
    if (t.b_embedded.size() != 0)
        all.push_back(
            {"embedded method: stability function", function_claims(embedded_stability_function_of(t))});
    return all;
}

STAGECRAFT_INLINE std::vector<report_section> enclosed_rosenbrock_report(
    const rosenbrock_method<tableaux::ball>& m) {
    std::optional<enclosed_stability_function> f;
    std::vector<report_section> all{enclosed_function_section(linear_subject(m), f)};
    report_section method{"method, by enclosures", {}};
    for (const auto property : rosenbrock_properties)
        method.claims.push_back(
            {std::string(property), in_its_time(0.3, [&] { return rosenbrock_property(m, property); })});
    all.push_back(std::move(method));
    return all;
}

}  // namespace detail

STAGECRAFT_INLINE std::vector<report_section> stability_report(const tableaux::partitioned_file& file) {
    require_rosenbrock(file);
    if (file.kind() <= tableaux::number_kind::quadratic) try {
            const tableaux::time_share share(tableaux::time_share::left() / 2);
            return detail::exact_rosenbrock_report(detail::rosenbrock_in(file, detail::exact_subject));
        } catch (const tableaux::out_of_time&) {
        }
    return detail::enclosed_rosenbrock_report(detail::rosenbrock_in(file, detail::enclosed_subject));
}

}  // namespace stagecraft::theory
