// SPDX-License-Identifier: BSL-1.0
// The examples and pictures of R. Maerz, "Numerik gewoehnlicher Differentialgleichungen" (lecture notes),
// chapters 1 to 3, computed: build/lecture --all --svg DIRECTORY.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>

#include "lecture.hpp"

int main(int argc, char** argv) {
    using namespace lecture;
    const std::vector<std::pair<std::string, std::function<chapter()>>> chapters{
        {"1", chapter_1}, {"2", chapter_2}, {"3", chapter_3}};
    CLI::App app{
        "Chapters 1 to 3 of the lecture: its pictures, and a table of what it prints, what comes out here "
        "and "
        "what theory says."};
    bool all = false;
    std::string directory;
    std::vector<std::string> chosen;
    app.add_flag("--all", all, "every chapter");
    app.add_option("--svg", directory, "directory for the pictures");
    app.add_option("chapter", chosen, "which chapters")->check(CLI::IsMember({"1", "2", "3"}));
    CLI11_PARSE(app, argc, argv);
    if (!all && chosen.empty()) {
        std::cout << app.help();
        return 2;
    }
    try {
        std::vector<thesis::finding> findings;
        for (const auto& [name, run] : chapters) {
            if (!all && std::find(chosen.begin(), chosen.end(), name) == chosen.end()) continue;
            const chapter c = run();
            findings.insert(findings.end(), c.findings.begin(), c.findings.end());
            if (directory.empty()) continue;
            std::filesystem::create_directories(directory);
            for (const auto& p : c.pictures) {
                plot::draw(p.script, std::filesystem::path(directory) / (p.name + ".svg"));
                std::cout << "wrote " << directory << "/" << p.name << ".svg\n";
            }
        }
        std::cout << thesis::table(findings);
        return std::all_of(findings.begin(), findings.end(), [](const auto& f) { return f.agrees; }) ? 0 : 1;
    } catch (const std::exception& e) {
        std::cerr << "lecture: " << e.what() << '\n';
        return 2;
    }
}
