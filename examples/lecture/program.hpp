// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "../thesis/language_option.hpp"
#include "lecture.hpp"

namespace lecture {

/// A program whose parts are chosen by name, or all with --all: draws the pictures into the directory given by --svg and
/// prints the table. Returns 0 where every line agrees, 1 where one does not, 2 for bad use.
inline int program(int argc, char** argv, const std::string& description,
                   const std::vector<std::pair<std::string, std::function<chapter()>>>& parts) {
    CLI::App app{description};
    bool all = false;
    std::string directory;
    thesis::language of_pictures = thesis::language::english;
    std::vector<std::string> chosen, names;
    for (const auto& part : parts) names.push_back(part.first);
    app.add_flag("--all", all, "every part");
    app.add_option("--svg", directory, "directory for the pictures");
    thesis::add_language(app, of_pictures);
    app.add_option("part", chosen, "which parts")->check(CLI::IsMember(names));
    CLI11_PARSE(app, argc, argv);
    if (!all && chosen.empty()) {
        std::cout << app.help();
        return 2;
    }
    try {
        std::vector<thesis::finding> findings;
        for (const auto& [name, run] : parts) {
            if (!all && std::find(chosen.begin(), chosen.end(), name) == chosen.end()) continue;
            const chapter c = run();
            findings.insert(findings.end(), c.findings.begin(), c.findings.end());
            if (directory.empty()) continue;
            std::filesystem::create_directories(directory);
            for (const auto& p : c.pictures) {
                const auto file = std::filesystem::path(directory) / (p.name + ".svg");
                plot::draw(thesis::translated_commands(p.script.text(file), of_pictures), file);
                std::cout << "wrote " << directory << "/" << p.name << ".svg\n";
            }
        }
        std::cout << thesis::table(findings);
        return std::all_of(findings.begin(), findings.end(), [](const auto& f) { return f.agrees; }) ? 0 : 1;
    } catch (const std::exception& e) {
        std::cerr << std::filesystem::path(argv[0]).filename().string() << ": " << e.what() << '\n';
        return 2;
    }
}

}  // namespace lecture
