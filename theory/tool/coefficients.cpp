// SPDX-License-Identifier: BSL-1.0
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stagecraft/tableaux/emit.hpp>
#include <stagecraft/tableaux/emit_pairs.hpp>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/theory/judging/certify.hpp>
#include <stagecraft/theory/judging/certify_file.hpp>
#include <stagecraft/theory/judging/certify_partitioned.hpp>
#include <string>
#include <variant>
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

/// Nothing that a file claims may be refuted, or beyond what can be tested. All files hold one tableau, or several, as the
/// first does.
void write_files(const std::vector<std::string>& files) {
    std::vector<tableaux::named_pair> pairs;
    std::vector<tableaux::named_tableau> methods;
    std::string command = "stagecraft coefficients";
    for (const std::string& path : files) {
        const std::string id = std::filesystem::path(path).stem().string();
        const auto read = tableaux::read_method_file(path);
        const int exit_code =
            std::visit([](const auto& file) { return stagecraft::theory::certify(file).exit_code(); }, read);
        if (exit_code != 0)
            throw tableaux::unusable_input(path + ": a claim is not proved; see stagecraft certify");
        const auto* several = std::get_if<tableaux::partitioned_file>(&read);
        if (several && several->coupling == tableaux::coupling::rosenbrock)
            throw tableaux::unusable_input(path + ": no run takes a Rosenbrock method");
        if (several)
            pairs.emplace_back(id, *several);
        else
            methods.emplace_back(id, std::get<tableaux::tableau_file>(read));
        if (!pairs.empty() && !methods.empty())
            throw tableaux::unusable_input(path + ": a header holds methods of one tableau, or of several");
        command += " " + path;
    }
    std::cout << (pairs.empty() ? tableaux::methods_header(methods, command)
                                : tableaux::pairs_header(pairs, command));
}

const stagecraft::tool::command coefficients{[](CLI::App& app) {
    const auto asked = std::make_shared<std::vector<std::string>>();
    auto* command = app.add_subcommand("coefficients",
                                       "Write a header of stagecraft/coefficients/: the nearest doubles of a "
                                       "family, FAMILY MOST, or of files, FILE.json ...: tableaux, or "
                                       "additive, partitioned, separable and Nystrom methods");
    command
        ->add_option("what", *asked,
                     "One of " + tableaux::family_names() + " and the largest number of stages, or files")
        ->required();
    command->callback([asked] {
        const std::vector<std::string>& words = *asked;
        if (words.front().ends_with(".json"))
            write_files(words);
        else if (words.size() == 2)
            write_family(words[0], words[1]);
        else
            throw std::invalid_argument(
                "coefficients: a family needs its largest number of stages, most, "
                "behind it, and nothing else");
    });
}};

}  // namespace
