// SPDX-License-Identifier: BSL-1.0
#include <memory>
#include <string>
#include <utility>

#include "certify_file.hpp"
#include "command.hpp"
#include "reading_options.hpp"

namespace {

const stagecraft::tool::command diff{[](CLI::App& app) {
    auto* sub =
        app.add_subcommand("diff", "Which entries, orders and properties of two tableau files differ");
    const auto files = std::make_shared<std::pair<std::string, std::string>>();
    const auto entries = std::make_shared<stagecraft::tool::reading_options>();
    sub->add_option("FIRST", files->first, "tableau file")->required();
    sub->add_option("SECOND", files->second, "tableau file")->required();
    entries->add_to(*sub);
    sub->footer("Exit code: 0 they agree; 1 they differ; 2 unusable input.");
    sub->callback([files, entries] {
        if (const int code = stagecraft::tool::diff_files(files->first, files->second, entries->reading());
            code != 0)
            throw CLI::RuntimeError(code);
    });
}};

}  // namespace
