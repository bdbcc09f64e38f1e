// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/tableaux/tableau_json.hpp>
#include <stagecraft/tableaux/time_share.hpp>
#include <stagecraft/theory/judging/enclosed_report.hpp>
#include <stagecraft/theory/judging/family_report.hpp>
#include <stagecraft/theory/judging/rosenbrock_report.hpp>
#include <string>
#include <variant>
#include <vector>

namespace stagecraft::tool {

/// What `stability` says of a tableau file: decisions on exact data, enclosures of others, and of exact data whose
/// decisions would take more than half of the time that is left.
inline std::vector<theory::report_section> stability_report(const tableaux::tableau_file& file) {
    const auto enclosed = theory::make_subject<tableaux::ball>(
        file, [](const tableaux::entry& e) { return theory::to_ball(e.enclosure); });
    if (file.kind() <= tableaux::number_kind::quadratic) try {
            const tableaux::time_share share(tableaux::time_share::left() / 2);
            return theory::stability_report(tableaux::to_quadratic(file));
        } catch (const tableaux::out_of_time&) {
        }
    return theory::enclosed_stability_report(enclosed);
}

inline std::vector<theory::report_section> stability_report(const tableaux::method_file& file) {
    if (const auto* one = std::get_if<tableaux::tableau_file>(&file)) return stability_report(*one);
    return theory::stability_report(std::get<tableaux::partitioned_file>(file));
}

/// What `stability --json` prints; the tableau of a file, or null.
inline nlohmann::ordered_json to_json(const std::string& name,
                                      const std::vector<theory::report_section>& report,
                                      const nlohmann::ordered_json& tableau) {
    nlohmann::ordered_json out;
    out["name"] = name;
    for (const auto& section : report) {
        auto& list = out[section.title] = nlohmann::ordered_json::array();
        for (const auto& c : section.claims) {
            list.push_back({{"statement", c.statement},
                            {"verdict", std::string(theory::name(c.verdict.standing()))},
                            {"reason", c.verdict.reason()}});
        }
    }
    if (!tableau.is_null()) out["tableau"] = tableau;
    return out;
}

}  // namespace stagecraft::tool
