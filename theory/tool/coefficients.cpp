// SPDX-License-Identifier: BSL-1.0
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <stagecraft/tableaux/emit.hpp>
#include <stagecraft/theory/judging/certify.hpp>
#include <string>

#include "command.hpp"

namespace {

namespace tableaux = stagecraft::tableaux;

constexpr int most_stages = 30;

const stagecraft::tool::command coefficients{[](CLI::App& app) {
    struct request {
        std::string family, most;
    };
    const auto asked = std::make_shared<request>();
    auto* command = app.add_subcommand(
        "coefficients", "Write the header stagecraft/coefficients/FAMILY.hpp: the nearest doubles");
    command->add_option("family", asked->family, "One of " + tableaux::family_names())->required();
    command->add_option("most", asked->most, "Largest number of stages")->required();
    command->callback([asked] {
        const auto f = tableaux::family_from_name(asked->family);
        const int most =
            stagecraft::tool::whole_number("most", asked->most, tableaux::least_stages(f), most_stages);
        std::cout << tableaux::coefficient_header(
            f, most, [f](int s) { return stagecraft::theory::certify(f, s).facts(); });
    });
}};

}  // namespace
