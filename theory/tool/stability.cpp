// SPDX-License-Identifier: BSL-1.0
#include <iostream>
#include <memory>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/theory/judging/family_report.hpp>
#include <string>
#include <variant>
#include <vector>

#include "clock.hpp"
#include "command.hpp"
#include "method_argument.hpp"
#include "reading_options.hpp"
#include "stability_json.hpp"

namespace {

using namespace stagecraft;

struct stability_request {
    std::string method, stages;
    tool::reading_options entries;
    bool json = false;
};

void print(const std::string& name, const std::vector<theory::report_section>& report, bool json,
           const nlohmann::ordered_json& tableau) {
    if (json)
        std::cout << tool::to_json(name, report, tableau).dump(2) << "\n";
    else
        std::cout << name << "\n" << theory::text(report);
}

void run(const stability_request& r) {
    if (tool::is_family(r.method)) {
        const auto [family, s] = tool::member_of_family(r.method, r.stages, 30);
        return print(r.method + ", s = " + std::to_string(s), theory::stability_report(family, s), r.json,
                     {});
    }
    tool::require_no_stages(r.stages);
    const auto file = tableaux::read_method_file(r.method, r.entries.reading());
    const tableaux::time_share share(tool::seconds_for_decisions());
    const auto report = tool::stability_report(file);
    std::visit([&](const auto& f) { print(f.name, report, r.json, tableaux::to_json(f)); }, file);
}

const tool::command stability{[](CLI::App& app) {
    const auto request = std::make_shared<stability_request>();
    auto* command = app.add_subcommand("stability",
                                       "Decide every notion of stability and the DAE orders of a family's "
                                       "member or an exact tableau file, a Rosenbrock "
                                       "method's too; of a rounded one what enclosures say");
    command->add_option("METHOD", request->method, "a family (see `families`) or a tableau file (JSON)")
        ->required();
    command->add_option("S", request->stages, "number of stages of the family's member, at most 30");
    request->entries.add_to(*command);
    command->add_flag("--json", request->json, "Print JSON instead of text");
    command->callback([request] { run(*request); });
}};

}  // namespace
