// SPDX-License-Identifier: BSL-1.0
#include <memory>
#include <string>
#include <vector>

#include "certify_file.hpp"
#include "command.hpp"

namespace {

const stagecraft::tool::command table{[](CLI::App& app) {
    auto* sub =
        app.add_subcommand("table", "Certify tableau files and print a Markdown table of what they are");
    const auto named = std::make_shared<std::vector<std::string>>();
    sub->add_option("FILE", *named, "tableau files, or folders of them")->required();
    sub->callback([named] { stagecraft::tool::print_method_table(*named); });
}};

}  // namespace
