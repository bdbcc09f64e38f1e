// SPDX-License-Identifier: BSL-1.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/decimals.hpp>
#include <stdexcept>
#include <string>

#include "command.hpp"
#include "tableau_text.hpp"

namespace {

namespace tableaux = stagecraft::tableaux;
using stagecraft::tool::whole_number;

constexpr int most_stages = 500;
constexpr int most_digits = 1000;

struct tableau_request {
    std::string family;
    std::string stages;
    std::string digits = "20";
    std::string format = "text";
};

/// The tableau as a LaTeX array.
void print_latex(const tableaux::decimal_tableau& t) {
    const auto print = [](const auto& row) {
        for (const std::string& x : row) {
            const auto e = x.find('e');
            std::cout << " & "
                      << (e == std::string::npos ? x
                                                 : x.substr(0, e) + "\\cdot 10^{" + x.substr(e + 1) + "}");
        }
    };
    std::cout << "\\begin{array}{c|" << std::string(t.b.size(), 'c') << "}\n";
    for (std::size_t i = 0; i < t.c.size(); ++i) {
        std::cout << t.c[i];
        print(t.A[i]);
        std::cout << " \\\\\n";
    }
    std::cout << "\\hline\n";
    print(t.b);
    std::cout << "\n\\end{array}\n";
}

void run(const tableau_request& request) {
    const auto family = tableaux::family_from_name(request.family);
    const int s = whole_number("stages of " + request.family, request.stages, tableaux::least_stages(family),
                               most_stages);
    const int digits = whole_number("--digits", request.digits, 1, most_digits);
    if (request.format != "text" && request.format != "json" && request.format != "latex")
        throw std::invalid_argument("--format: '" + request.format + "' unknown, allowed: text, json, latex");
    const auto t = tableaux::decimals(family, s, digits);
    if (request.format == "text") return stagecraft::tool::print_text(t);
    if (request.format == "latex") return print_latex(t);
    nlohmann::ordered_json out;
    out["family"] = request.family;
    out["stages"] = s;
    out["digits"] = digits;
    out["c"] = t.c;
    out["A"] = t.A;
    out["b"] = t.b;
    std::cout << out.dump(2) << "\n";
}

const stagecraft::tool::command tableau{[](CLI::App& app) {
    const auto request = std::make_shared<tableau_request>();
    auto* command = app.add_subcommand("tableau", "Print c, A and b to any number of digits");
    command->add_option("family", request->family, "One of " + tableaux::family_names())->required();
    command->add_option("stages", request->stages, "Number of stages")->required();
    command->add_option("--digits", request->digits, "Significant decimal digits, 1 to 1000 (default 20)");
    command->add_option("--format", request->format, "text (default), json or latex");
    command->callback([request] { run(*request); });
}};

}  // namespace
