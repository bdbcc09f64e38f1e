// SPDX-License-Identifier: BSL-1.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <stagecraft/tableaux/decimals.hpp>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stdexcept>
#include <string>

#include "command.hpp"
#include "method_argument.hpp"
#include "tableau_json.hpp"
#include "tableau_text.hpp"

namespace {

namespace tableaux = stagecraft::tableaux;
using stagecraft::tool::whole_number;

constexpr int most_stages = 500;
constexpr int most_digits = 1000;

struct tableau_request {
    std::string family;
    std::string stages;
    std::string digits;  // default 20
    std::string format = "text";
};

std::string latex(const std::string& decimal) {
    const auto e = decimal.find('e');
    if (e == std::string::npos) return decimal;
    return decimal.substr(0, e) + "\\cdot 10^{" + decimal.substr(e + 1) + "}";
}

std::string latex(const tableaux::rational& x) {
    if (x.denominator() == 1) return x.str();
    return std::string(x < 0 ? "-" : "") + "\\frac{" + abs(x.numerator()).str() + "}{" +
           x.denominator().str() + "}";
}

/// a + b sqrt(d) + ... with fractions in front.
std::string latex(const tableaux::quadratic& x) {
    std::string text = x.rational_part() == 0 && !x.is_rational() ? "" : latex(x.rational_part());
    for (const auto& [b, d] : x.surds()) {
        if (b > 0 && !text.empty()) text += "+";
        text += b == 1 ? "" : b == -1 ? "-" : latex(b);
        text += "\\sqrt{" + std::to_string(d) + "}";
    }
    return text;
}

/// The tableau as a LaTeX array; number(i, j) is A, c and b are j = -1 and i = s.
template <class Number>
void print_latex(int s, Number number) {
    std::cout << "\\begin{array}{c|" << std::string(static_cast<std::size_t>(s), 'c') << "}\n";
    for (int i = 0; i <= s; ++i) {
        if (i < s) std::cout << number(i, -1);
        for (int j = 0; j < s; ++j) std::cout << " & " << number(i, j);
        std::cout << (i < s ? " \\\\\n" : "\n");
        if (i == s - 1) std::cout << "\\hline\n";
    }
    std::cout << "\\end{array}\n";
}

/// In exact surds where the nodes lie in a quadratic field: whether they do.
bool print_exact_latex(tableaux::family family, int s) {
    const auto t = tableaux::exact_tableau(family, s);
    if (!t) return false;
    print_latex(s, [&](int i, int j) { return latex(j < 0 ? t->c(i) : i == s ? t->b(j) : t->A(i, j)); });
    return true;
}

void run(const tableau_request& request) {
    const auto member = stagecraft::tool::member_of_family(request.family, request.stages, most_stages);
    const auto family = member.family;
    const int s = member.stages;
    const int digits = request.digits.empty() ? 20 : whole_number("--digits", request.digits, 1, most_digits);
    if (request.format != "text" && request.format != "json" && request.format != "latex")
        throw std::invalid_argument("--format: '" + request.format + "' unknown, allowed: text, json, latex");
    const bool latex_wanted = request.format == "latex";
    if (latex_wanted && request.digits.empty() && print_exact_latex(family, s)) return;
    const auto t = tableaux::decimals(family, s, digits);
    if (request.format == "text") return stagecraft::tool::print_text(t);
    if (latex_wanted)
        return print_latex(s, [&](int i, int j) {
            const auto row = static_cast<std::size_t>(i), column = static_cast<std::size_t>(j);
            return latex(j < 0 ? t.c[row] : i == s ? t.b[column] : t.A[row][column]);
        });
    std::cout << stagecraft::tool::to_json(request.family, t, digits).dump(2) << "\n";
}

const stagecraft::tool::command tableau{[](CLI::App& app) {
    const auto request = std::make_shared<tableau_request>();
    auto* command = app.add_subcommand("tableau", "Print c, A and b to any number of digits");
    command->add_option("family", request->family, "One of " + tableaux::family_names())->required();
    command->add_option("stages", request->stages, "Number of stages")->required();
    command->add_option("--digits", request->digits, "Significant decimal digits, 1 to 1000 (default 20)");
    command->add_option(
        "--format", request->format,
        "text (default), json or latex (in exact surds where there are, unless --digits is given)");
    command->callback([request] { run(*request); });
}};

}  // namespace
