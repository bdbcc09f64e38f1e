// SPDX-License-Identifier: BSL-1.0
#include <filesystem>
#include <iostream>
#include <memory>
#include <stagecraft/theory/judging/method_table.hpp>
#include <string>
#include <vector>

#include "command.hpp"

namespace {

namespace fs = std::filesystem;

const stagecraft::tool::command table{[](CLI::App& app) {
    auto* sub =
        app.add_subcommand("table", "Certify tableau files and print a Markdown table of what they are");
    const auto named = std::make_shared<std::vector<std::string>>();
    sub->add_option("FILE", *named, "tableau files, or folders of them")->required();
    sub->callback([named] {
        std::vector<fs::path> files;
        for (const fs::path path : *named) {
            const auto found = fs::is_directory(path) ? stagecraft::theory::tableau_files_in(path)
                                                      : std::vector<fs::path>{path};
            files.insert(files.end(), found.begin(), found.end());
        }
        std::cout << stagecraft::theory::method_table(files);
    });
}};

}  // namespace
