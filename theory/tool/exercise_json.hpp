// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>
#include <stagecraft/theory/exercises/html.hpp>
#include <stagecraft/theory/exercises/kinds.hpp>
#include <string>

namespace stagecraft::tool {

/// What `exercise --json` prints.
inline nlohmann::ordered_json to_json(const theory::exercise& e) {
    nlohmann::ordered_json out{{"kind", e.kind},
                               {"seed", e.seed},
                               {"question", to_text(e.question)},
                               {"solution", to_text(e.solution)},
                               {"question_latex", to_latex(e.question)},
                               {"solution_latex", to_latex(e.solution)},
                               {"question_html", to_html(e.question)},
                               {"solution_html", to_html(e.solution)},
                               {"certificate", nlohmann::ordered_json::array()}};
    for (const auto& c : e.certificate)
        out["certificate"].push_back({{"statement", c.statement},
                                      {"verdict", std::string(theory::name(c.verdict.standing()))},
                                      {"reason", c.verdict.reason()}});
    return out;
}

}  // namespace stagecraft::tool
