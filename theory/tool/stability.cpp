// SPDX-License-Identifier: BSL-1.0
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/tableaux/tableau_json.hpp>
#include <stagecraft/theory/judging/enclosed_report.hpp>
#include <string>

#include "command.hpp"

namespace {

using namespace stagecraft;

struct stability_request {
    std::string file;
    bool json = false;
};

void run(const stability_request& request) {
    const auto file = tableaux::read_tableau_file(request.file);
    const auto report =
        file.kind() <= tableaux::number_kind::quadratic
            ? theory::stability_report(tableaux::to_quadratic(file))
            : theory::enclosed_stability_report(theory::make_subject<tableaux::ball>(
                  file, [](const tableaux::entry& e) { return theory::to_ball(e.enclosure); }));
    if (!request.json) {
        std::cout << file.name << "\n" << theory::text(report);
        return;
    }
    nlohmann::ordered_json out;
    out["name"] = file.name;
    for (const auto& section : report) {
        auto& list = out[section.title] = nlohmann::ordered_json::array();
        for (const auto& c : section.claims) {
            list.push_back({{"statement", c.statement},
                            {"verdict", std::string(theory::name(c.verdict.standing()))},
                            {"reason", c.verdict.reason()}});
        }
    }
    out["tableau"] = tableaux::to_json(file);
    std::cout << out.dump(2) << "\n";
}

const tool::command stability{[](CLI::App& app) {
    const auto request = std::make_shared<stability_request>();
    auto* command = app.add_subcommand(
        "stability",
        "Decide every notion of stability and the DAE orders of an exact tableau file; of a rounded one what "
        "enclosures say");
    command->add_option("file", request->file, "Tableau file (JSON)")->required();
    command->add_flag("--json", request->json, "Print JSON instead of text");
    command->callback([request] { run(*request); });
}};

}  // namespace
