// SPDX-License-Identifier: BSL-1.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <stagecraft/tableaux/correct_rounding.hpp>
#include <stagecraft/tableaux/decimals.hpp>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/tableaux/tableau_json.hpp>
#include <stdexcept>
#include <string>

#include "array_formats.hpp"
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

constexpr const char* known_formats = "text, json, latex, markdown, c, cpp, python, julia, matlab";

/// Arrays of a program or Markdown; whether the format is one of these.
bool print_arrays(const std::string& format, const tableaux::decimal_tableau& t,
                  const std::vector<std::string>& b_embedded) {
    if (format == "markdown") {
        std::cout << stagecraft::tool::as_markdown(t.A, t.b, t.c, b_embedded);
        return true;
    }
    for (const auto& f : stagecraft::tool::array_formats) {
        if (f.name != format) continue;
        std::cout << stagecraft::tool::as_arrays(f, t.A, t.b, t.c, b_embedded);
        return true;
    }
    return false;
}

/// A file's tableau in decimals; rounded entries have the digits that they are given with.
void run_file(const tableau_request& request, int digits) {
    const auto file = tableaux::read_tableau_file(request.family);
    if (request.format == "json") {
        std::cout << tableaux::to_json(file).dump(2) << "\n";
        return;
    }
    const auto written = [&](const auto& entries) {
        std::vector<std::string> all;
        for (const auto& e : entries)  // not more digits than are known
            all.push_back(tableaux::decimal_text(e.enclosure.middle(),
                                                 e.rounded ? std::min(digits, e.digits) : digits));
        return all;
    };
    tableaux::decimal_tableau t;
    for (const auto& row : file.A) t.A.push_back(written(row));
    t.b = written(file.b);
    t.c = written(file.c);
    if (t.c.empty())
        for (const auto& row : file.A) {
            tableaux::rational sum(0);
            int known = digits;
            for (const auto& e : row) {
                sum += e.enclosure.middle();
                if (e.rounded) known = std::min(known, e.digits);
            }
            t.c.push_back(tableaux::decimal_text(sum, known));
        }
    if (print_arrays(request.format, t, written(file.b_embedded))) return;
    if (request.format == "text") return stagecraft::tool::print_text(t);
    const auto s = static_cast<int>(t.b.size());
    const auto exact = [&](const tableaux::entry& e, const std::string& decimal) {
        return request.digits.empty() && e.exact ? latex(*e.exact) : latex(decimal);
    };
    print_latex(s, [&](int i, int j) {
        const auto row = static_cast<std::size_t>(i), column = static_cast<std::size_t>(j);
        if (j < 0) return file.c.empty() ? latex(t.c[row]) : exact(file.c[row], t.c[row]);
        return i == s ? exact(file.b[column], t.b[column]) : exact(file.A[row][column], t.A[row][column]);
    });
}

void run(const tableau_request& request) {
    const int digits = request.digits.empty() ? 20 : whole_number("--digits", request.digits, 1, most_digits);
    const std::string known = std::string(", ") + known_formats + ",";
    if (request.format.empty() || known.find(", " + request.format + ",") == std::string::npos)
        throw std::invalid_argument("--format: '" + request.format + "' unknown, allowed: " + known_formats);
    if (!stagecraft::tool::is_family(request.family)) {
        stagecraft::tool::require_no_stages(request.stages);
        return run_file(request, digits);
    }
    const auto member = stagecraft::tool::member_of_family(request.family, request.stages, most_stages);
    const auto family = member.family;
    const int s = member.stages;
    const bool latex_wanted = request.format == "latex";
    if (latex_wanted && request.digits.empty() && print_exact_latex(family, s)) return;
    const auto t = tableaux::decimals(family, s, digits);
    if (request.format == "text") return stagecraft::tool::print_text(t);
    if (print_arrays(request.format, t, {})) return;
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
    command->add_option("family", request->family, "A tableau file, or one of " + tableaux::family_names())
        ->required();
    command->add_option("stages", request->stages, "Number of stages, of a family");
    command->add_option("--digits", request->digits, "Significant decimal digits, 1 to 1000 (default 20)");
    command->add_option(
        "--format", request->format,
        std::string(known_formats) + " (latex in exact surds where there are, unless --digits is given)");
    command->callback([request] { run(*request); });
}};

}  // namespace
