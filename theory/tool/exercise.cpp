// SPDX-License-Identifier: BSL-1.0
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

#include "command.hpp"
#include "exercise_json.hpp"
#include "stagecraft/theory/exercises/sheet.hpp"

namespace {

using namespace stagecraft;

struct exercise_request {
    std::string kind, seed = "1", sheet;
    bool latex = false, html = false, json = false, no_solution = false;
};

void print(const theory::exercise_sheet& sheet, const exercise_request& request) {
    std::cout << (request.html ? to_html(sheet) : request.latex ? to_latex(sheet) : to_text(sheet));
}

void run(const exercise_request& request) {
    if (request.kind.empty() && request.sheet.empty()) {
        for (const auto& k : theory::exercise_kinds())
            std::cout << k.name << std::string(20 - k.name.size(), ' ') << k.asks << "\n";
        return;
    }
    if (int{request.latex} + int{request.json} + int{request.html} > 1)
        throw std::invalid_argument("exercise: give one of --latex, --html and --json");
    const auto seed =
        static_cast<std::uint64_t>(tool::whole_number("--seed", request.seed, 0, 2'147'483'647));
    if (!request.sheet.empty()) {
        if (request.json) throw std::invalid_argument("exercise: --json prints one exercise, no --sheet");
        const int count = static_cast<int>(tool::whole_number("--sheet", request.sheet, 1, 100));
        return print(theory::make_sheet(request.kind, count, seed, !request.no_solution), request);
    }
    const auto e = theory::make_exercise(request.kind, seed);
    if (request.json)
        std::cout << tool::to_json(e).dump(2) << "\n";
    else if (request.html || request.no_solution)
        print({{e}, !request.no_solution}, request);
    else
        std::cout << (request.latex ? to_latex(e) : to_text(e));
}

const tool::command exercise{[](CLI::App& app) {
    const auto request = std::make_shared<exercise_request>();
    auto* command = app.add_subcommand(
        "exercise", "An exercise with its solution, certified by exact decisions; without KIND: the kinds");
    command->add_option("KIND", request->kind, "what to ask");
    command->add_option("--seed", request->seed, "which exercise of this kind: a whole number, by default 1");
    command->add_option(
        "--sheet", request->sheet,
        "print so many different exercises, of this seed and those that follow; without KIND of "
        "all kinds in turn. Solutions come last");
    command->add_flag("--no-solution", request->no_solution, "print what is asked alone");
    command->add_flag("--latex", request->latex, "print a LaTeX document instead of text");
    command->add_flag("--html", request->html, "print a page for a browser, which prints it on paper");
    command->add_flag("--json", request->json, "print JSON instead of text");
    command->callback([request] { run(*request); });
}};

}  // namespace
