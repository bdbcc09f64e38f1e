// SPDX-License-Identifier: BSL-1.0
// The numerical experiments of B. Braun, "Numerische Behandlung nichtholonomer mechanischer Systeme" (2013),
// chapter 4.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iostream>

#include "experiments.hpp"
#include "language_option.hpp"

int main(int argc, char** argv) {
    using namespace thesis;
    const std::vector<std::pair<std::string, std::function<outcome()>>> experiments{
        {"assumptions", assumptions},
        {"solution", solution},
        {"orders", orders_of_convergence},
        {"epsilon", regularisation_error},
        {"expansion", root_expansion},
        {"transformation", transformation},
        {"layers", boundary_layers},
        {"regularised", regularised_runs},
        {"times", run_times},
        {"methods", other_methods},
        {"bodies", nonholonomic_bodies}};
    CLI::App app{"The rolling disc as index-2 system and regularised: the experiments, one page each."};
    bool all = false;
    std::string directory;
    language of_pictures = language::english;
    std::vector<std::string> chosen;
    std::vector<std::string> names;
    for (const auto& e : experiments) names.push_back(e.first);
    app.add_flag("--all", all, "every experiment");
    app.add_option("--svg", directory, "directory for figures and index.html");
    add_language(app, of_pictures);
    app.add_option("experiment", chosen, "which experiments")->check(CLI::IsMember(names));
    CLI11_PARSE(app, argc, argv);
    if (!all && chosen.empty()) {
        std::cout << app.help();
        return 2;
    }
    try {
        std::vector<outcome> outcomes;
        std::vector<finding> findings;
        for (const auto& [name, run] : experiments) {
            if (!all && std::find(chosen.begin(), chosen.end(), name) == chosen.end()) continue;
            outcomes.push_back(run());
            const outcome& o = outcomes.back();
            std::cout << "=== " << o.title << "\n\n" << o.text << '\n' << std::flush;
            findings.insert(findings.end(), o.findings.begin(), o.findings.end());
        }
        std::cout << "=== Summary\n\n" << table(findings);
        if (!directory.empty()) {
            write_pages(directory, outcomes, of_pictures);
            std::cout << "\nFigures: " << directory << "/index.html\n";
        }
    } catch (const std::exception& e) {
        std::cerr << "thesis: " << e.what() << '\n';
        return 1;
    }
}
