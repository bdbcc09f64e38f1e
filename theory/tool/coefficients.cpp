// SPDX-License-Identifier: BSL-1.0
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stagecraft/tableaux/emit.hpp>
#include <stagecraft/tableaux/emit_pairs.hpp>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/theory/judging/certify.hpp>
#include <stagecraft/theory/judging/certify_partitioned.hpp>
#include <string>
#include <vector>

#include "command.hpp"

namespace {

namespace tableaux = stagecraft::tableaux;

constexpr int most_stages = 30;

void write_family(const std::string& name, const std::string& stages) {
    const auto f = tableaux::family_from_name(name);
    const int most = stagecraft::tool::whole_number("most", stages, tableaux::least_stages(f), most_stages);
    std::cout << tableaux::coefficient_header(
        f, most, [f](int s) { return stagecraft::theory::certify(f, s).facts(); });
}

/// Nothing that a file claims may be refuted, or beyond what can be tested.
void write_pairs(const std::vector<std::string>& files) {
    std::vector<tableaux::named_pair> methods;
    std::string command = "stagecraft coefficients";
    for (const std::string& path : files) {
        const auto read = tableaux::read_method_file(path);
        const auto* file = std::get_if<tableaux::partitioned_file>(&read);
        if (file == nullptr)
            throw tableaux::unusable_input(path + ": holds one tableau, not a method of several");
        if (stagecraft::theory::certify(*file).exit_code() != 0)
            throw tableaux::unusable_input(path + ": a claim is not proved; see stagecraft certify");
        methods.emplace_back(std::filesystem::path(path).stem().string(), *file);
        command += " " + path;
    }
    std::cout << tableaux::pairs_header(methods, command);
}

const stagecraft::tool::command coefficients{[](CLI::App& app) {
    const auto asked = std::make_shared<std::vector<std::string>>();
    auto* command =
        app.add_subcommand("coefficients",
                           "Write a header of stagecraft/coefficients/: the nearest doubles of a "
                           "family, FAMILY MOST, or of files "
                           "with additive, partitioned, separable and Nystrom methods, FILE.json ...");
    command
        ->add_option("what", *asked,
                     "One of " + tableaux::family_names() + " and the largest number of stages, or files")
        ->required();
    command->callback([asked] {
        const std::vector<std::string>& words = *asked;
        if (words.front().ends_with(".json"))
            write_pairs(words);
        else if (words.size() == 2)
            write_family(words[0], words[1]);
        else
            throw std::invalid_argument(
                "coefficients: a family needs its largest number of stages, most, "
                "behind it, and nothing else");
    });
}};

}  // namespace
