// SPDX-License-Identifier: BSL-1.0
// What the command `stagecraft` says, as functions that JavaScript calls: each takes text and returns JSON, for input that
// cannot be used {"error": one line, "exit_code": what the command would return}. The verdicts come from the functions
// that the command calls.
#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/decimals.hpp>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/tableaux/program_text.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/theory/exercises/kinds.hpp>
#include <stagecraft/theory/exercises/sheet.hpp>
#include <stagecraft/theory/judging/certify.hpp>
#include <stagecraft/theory/judging/certify_partitioned.hpp>
#include <stagecraft/theory/stability/stability_function.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "answer.hpp"
#include "exercise_json.hpp"
#include "given_nodes.hpp"
#include "method_argument.hpp"
#include "stability_json.hpp"
#include "tableau_json.hpp"

namespace {

using namespace stagecraft;
using namespace playground;

/// What is said of the tableaux of a program: the certificate of the only one, or of several {"methods": [...]}, with those
/// that cannot be used; and in both cases what was not used.
json certify_program(const tableaux::program_tableaux& program) {
    json methods = json::array();
    for (const auto& t : program.tableaux) methods.push_back(theory::to_json(theory::certify(t)));
    for (const auto& u : program.unusable) {
        if (program.tableaux.empty() && program.unusable.size() == 1) throw tableaux::unusable_input(u.what);
        methods.push_back({{"name", u.name}});
        methods.back().update(refusal(2, u.what));
    }
    json answer = methods.size() == 1 ? methods.front() : json{{"methods", methods}};
    if (!program.unused.empty()) answer["not_used"] = program.unused;
    return answer;
}

json certify(std::string_view text, std::string_view from, std::string_view decimals) {
    const tableaux::reading how{tableaux::decimals_from_name(decimals)};
    if (is_program_text(text, from)) return certify_program(tableaux::read_program_text(text, how));
    return theory::to_json(theory::certify(tableaux::read_method_text(text, how)));
}

/// Numerator and denominator of R, constant terms first, in doubles: what a picture needs.
template <class K>
json coefficients(const theory::stability_function<K>& r) {
    const auto list = [](const auto& p) {
        json a = json::array();
        for (const auto& x : p.coefficients()) a.push_back(x.template to<double>());
        return a;
    };
    return {{"numerator", list(r.numerator)}, {"denominator", list(r.denominator)}};
}

/// A family's member as a tableau file: in surds where its nodes lie in a quadratic field, else to 40 digits.
json tableau_of(tableaux::family f, int s, const theory::certificate& certificate) {
    const auto exact = tableaux::exact_tableau(f, s);
    const auto t =
        exact ? tableaux::rounding::texts(*exact, [](const tableaux::quadratic& x) { return x.str(); })
              : tableaux::decimals(f, s, 40);
    return {{"name", certificate.method + ", s = " + std::to_string(s)},
            {"c", t.c},
            {"A", t.A},
            {"b", t.b},
            {"claims", {{"order", std::min(certificate.order, 14)}}}};
}

}  // namespace

extern "C" {

/// `certify --json` of a file with this text.
const char* stagecraft_certify(const char* text, const char* from, const char* decimals) {
    return answered([&] { return certify(text, from, decimals); });
}

/// `tableau --format json`.
const char* stagecraft_tableau(const char* family, const char* stages, const char* digits) {
    return answered([&] {
        const auto [f, s] = tool::member_of_family(family, stages, 500);
        const int n = tool::whole_number("digits", digits, 1, 1000);
        return tool::to_json(family, tableaux::decimals(f, s, n), n);
    });
}

/// `stability --json` of a file with this text.
const char* stagecraft_stability(const char* text, const char* from, const char* decimals) {
    return answered([&] {
        const auto file = only_tableau(text, from, decimals);
        return tool::to_json(file.name, tool::stability_report(file), tableaux::to_json(file));
    });
}

/// `exercise KIND --seed N --json`.
const char* stagecraft_exercise(const char* kind, const char* seed) {
    return answered([&] {
        const auto n = static_cast<std::uint64_t>(tool::whole_number("seed", seed, 0, 2'147'483'647));
        return tool::to_json(theory::make_exercise(kind, n));
    });
}

/// `exercise KIND --sheet 10 --seed N --html`, with `--no-solution` where solutions is "no".
const char* stagecraft_sheet(const char* kind, const char* seed, const char* solutions) {
    return answered([&] {
        const auto n = static_cast<std::uint64_t>(tool::whole_number("seed", seed, 0, 2'147'483'647));
        const bool wanted = std::string_view(solutions) != "no";
        return json{{"html", to_html(theory::make_sheet(kind, 10, n, wanted))}};
    });
}

/// `collocate --nodes ... --json`, and what a picture of its stability function needs.
const char* stagecraft_collocate(const char* nodes) {
    return answered([&] {
        const auto w = tool::nodes_from_list(nodes);
        return tool::to_json(w, tool::written(w), theory::certify(w, tableaux::construction::collocation));
    });
}

/// What `certify FAMILY S --json` decides, and the tableau.
const char* stagecraft_family(const char* family, const char* stages) {
    return answered([&] {
        const auto [f, s] = tool::member_of_family(family, stages, 30);
        const auto certificate = theory::certify(f, s);
        return json{{"tableau", tableau_of(f, s, certificate)},
                    {"certificate", theory::to_json(certificate)}};
    });
}

/// R of a file with this text; of rounded entries, of the numbers as written.
const char* stagecraft_function(const char* text, const char* from, const char* decimals) {
    return answered([&] {
        const auto file = only_tableau(text, from, decimals);
        const auto middle = [](const tableaux::entry& e) { return e.enclosure.middle(); };
        if (file.kind() == tableaux::number_kind::quadratic)
            return coefficients(theory::stability_function_of(tableaux::to_quadratic(file)));
        return coefficients(
            theory::stability_function_of(tableaux::to_tableau<tableaux::rational>(file, middle)));
    });
}

/// What there is to choose from: families with their least number of stages, and kinds of exercises.
const char* stagecraft_choices() {
    return answered([] {
        json families = json::array(), exercises = json::array();
        for (const auto f : tableaux::all_families)
            families.push_back({{"name", name(f)}, {"least", tableaux::least_stages(f)}});
        for (const auto& k : theory::exercise_kinds())
            exercises.push_back({{"name", k.name}, {"asks", k.asks}});
        return json{{"families", families}, {"exercises", exercises}};
    });
}
}
