// SPDX-License-Identifier: BSL-1.0
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

#include "command.hpp"
#include "exercise_json.hpp"

namespace {

using namespace stagecraft;

struct exercise_request {
    std::string kind, seed = "1";
    bool latex = false, json = false;
};

void run(const exercise_request& request) {
    if (request.kind.empty()) {
        for (const auto& k : theory::exercise_kinds())
            std::cout << k.name << std::string(20 - k.name.size(), ' ') << k.asks << "\n";
        return;
    }
    if (request.latex && request.json)
        throw std::invalid_argument("exercise: give --latex or --json, not both");
    const auto seed = tool::whole_number("--seed", request.seed, 0, 2'147'483'647);
    const auto e = theory::make_exercise(request.kind, static_cast<std::uint64_t>(seed));
    if (request.json)
        std::cout << tool::to_json(e).dump(2) << "\n";
    else
        std::cout << (request.latex ? to_latex(e) : to_text(e));
}

const tool::command exercise{[](CLI::App& app) {
    const auto request = std::make_shared<exercise_request>();
    auto* command = app.add_subcommand(
        "exercise", "An exercise with its solution, certified by exact decisions; without KIND: the kinds");
    command->add_option("KIND", request->kind, "what to ask");
    command->add_option("--seed", request->seed, "which exercise of this kind: a whole number, by default 1");
    command->add_flag("--latex", request->latex, "print a LaTeX document instead of text");
    command->add_flag("--json", request->json, "print JSON instead of text");
    command->callback([request] { run(*request); });
}};

}  // namespace
