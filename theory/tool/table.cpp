// SPDX-License-Identifier: BSL-1.0
#include <memory>
#include <string>
#include <vector>

#include "certify_file.hpp"
#include "command.hpp"
#include "reading_options.hpp"

namespace {

const stagecraft::tool::command table{[](CLI::App& app) {
    auto* sub =
        app.add_subcommand("table", "Certify tableau files and print a Markdown table of what they are");
    const auto named = std::make_shared<std::vector<std::string>>();
    const auto entries = std::make_shared<stagecraft::tool::reading_options>();
    sub->add_option("FILE", *named, "tableau files, or folders of them")->required();
    entries->add_to(*sub);
    sub->callback([named, entries] { stagecraft::tool::print_method_table(*named, entries->reading()); });
}};

}  // namespace
