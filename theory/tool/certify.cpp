// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <stagecraft/tableaux/decimals.hpp>
#include <stagecraft/theory/judging/certificate_json.hpp>
#include <stagecraft/theory/judging/certify.hpp>
#include <stagecraft/theory/stability/symplectic_pair.hpp>
#include <string>
#include <vector>

#include "certify_file.hpp"
#include "command.hpp"
#include "existence_file.hpp"
#include "export_coq.hpp"
#include "method_argument.hpp"
#include "reading_options.hpp"

namespace {

using namespace stagecraft;

struct options {
    std::vector<std::string> methods;
    std::string from = "json";
    tool::reading_options entries;
    std::optional<bool> strict;
    tool::certify_options files;
    tool::coq_options coq;
    bool exists = false;
    std::string digits;
    tool::existence_options existence;
};

void certify_family(const options& o) {
    if (o.methods.size() > 2) throw std::invalid_argument("stages: more than one number after a family");
    const auto [f, s] =
        tool::member_of_family(o.methods.front(), o.methods.size() == 2 ? o.methods[1] : "", 1000);
    const auto certificate = theory::certify(f, s);
    if (!o.coq.path.empty()) tool::export_coq(f, s, certificate, o.coq);
    if (!o.files.json) {
        std::cout << certificate.text();
        return;
    }
    auto out = theory::to_json(certificate);
    if (s <= tableaux::most_stages) {  // so that what is printed is a tableau file as well
        const auto t = tableaux::decimals(f, s, 40);
        out["tableau"] = {{"name", certificate.method}, {"c", t.c}, {"A", t.A}, {"b", t.b}};
        out["tableau"]["claims"]["order"] = certificate.order;
    }
    std::cout << out.dump(2) << '\n';
}

/// Two families on the same nodes, "lobatto_iiia+lobatto_iiib": whether they are a symplectic pair.
void certify_family_pair(const options& o, std::size_t plus) {
    const std::string& names = o.methods.front();
    const auto first = tableaux::family_from_name(names.substr(0, plus));
    const auto second = tableaux::family_from_name(names.substr(plus + 1));
    const int least = std::max(tableaux::least_stages(first), tableaux::least_stages(second));
    if (o.methods.size() != 2) throw std::invalid_argument("stages: missing after " + names);
    const int s = tool::whole_number("stages", o.methods[1], least, 1000);
    using model = theory::legendre_model<tableaux::rational>;
    const auto verdict = theory::symplectic_pair(model(first, s), model(second, s));
    if (o.files.json)
        std::cout << nlohmann::ordered_json{{"method", names},
                                            {"stages", s},
                                            {"symplectic", theory::to_json(verdict)}}
                         .dump(2)
                  << '\n';
    else
        std::cout << names << ", " << s << " stages\n  symplectic pair  " << verdict.text() << '\n';
}

/// Where nobody reads what is printed, as the common services tell.
bool in_continuous_integration() {
    const char* ci = std::getenv("CI");
    const std::string value = ci ? ci : "";
    return !value.empty() && value != "0" && value != "false";
}

/// --exists, --digits and --polished: a method near the entries of a file.
int search_for_method(options& o) {
    if (o.methods.size() != 1 || tool::is_family(o.methods.front()) || o.from != "json" ||
        !o.coq.path.empty() || !o.files.junit.empty())
        throw std::invalid_argument("exists: goes with one file in JSON; not with --from, --coq, --junit");
    o.existence.how = o.entries.reading();
    o.existence.json = o.files.json;
    o.existence.digits = tool::whole_number("digits", o.digits, 5, 4000);
    return tool::certify_existence_of(o.methods.front(), o.existence);
}

void run(options o) {
    if (!o.exists && (!o.existence.polished.empty() || !o.digits.empty()))
        throw std::invalid_argument("digits, polished: go with --exists");
    if (o.exists) {
        if (o.digits.empty()) o.digits = "60";
        const int code = search_for_method(o);
        if (code != 0) throw CLI::RuntimeError(code);
        return;
    }
    if (o.coq.split && o.coq.path.empty()) throw std::invalid_argument("coq-split: goes with --coq FILE.v");
    if (const auto plus = o.methods.front().find('+');
        plus != std::string::npos && tool::is_family(o.methods.front())) {
        if (!o.coq.path.empty()) throw std::invalid_argument("coq: a pair of families is not exported");
        return certify_family_pair(o, plus);
    }
    if (tool::is_family(o.methods.front())) return certify_family(o);
    if (o.from != "json" && o.from != "text")
        throw std::invalid_argument("from: '" + o.from + "', allowed: json, text");
    o.files.from_text = o.from == "text";
    o.files.strict = o.strict.value_or(!o.files.junit.empty() || in_continuous_integration());
    o.files.how = o.entries.reading();
    if (!o.coq.path.empty()) {
        if (o.methods.size() != 1 || o.methods.front() == "-")
            throw std::invalid_argument(
                "coq: one tableau file or one member of a family is exported at a time");
        tool::export_coq(o.methods.front(), o.files.how, o.coq);
    }
    const int code = tool::certify_files(o.methods, o.files);
    if (code != 0) throw CLI::RuntimeError(code);
}

const tool::command certify{[](CLI::App& app) {
    static options o;
    auto* sub = app.add_subcommand(
        "certify", "Prove order, stability and more of a family's member, or judge tableau files, exactly");
    sub->add_option("METHOD", o.methods,
                    "tableau files (- for standard input) or folders of them; or a family and its number of "
                    "stages, one of: " +
                        tableaux::family_names())
        ->required();
    sub->add_flag("--json", o.files.json, "print JSON instead of text; of several files a line each");
    sub->add_option("--from", o.from,
                    "json (default), or text: every tableau of a program, as arrays A, b, c and claims");
    sub->add_flag_callback(
        "--strict", [] { o.strict = true; },
        "with --from text: exit code 2 where something looks like coefficients or a claim and is not used "
        "(default with --junit, and where CI is set)");
    sub->add_flag_callback(
        "--no-strict", [] { o.strict = false; }, "with --from text: what is not used is told, no error");
    o.entries.add_to(*sub);
    sub->add_option("--junit", o.files.junit, "write a JUnit report to this file");
    sub->add_option("--coq", o.coq.path,
                    "write what is proved as theorems to this file, which `coqc FILE.v` checks");
    sub->add_flag("--coq-split", o.coq.split,
                  "the part that all such files share beside it, as stagecraft.v");
    sub->add_flag(
        "--exists", o.exists,
        "of a rounded table: prove that there is a method of exactly its orders near these entries, with "
        "these zeros");
    sub->add_option("--digits", o.digits, "with --exists: digits of the polished table (default 60)");
    sub->add_option("--polished", o.existence.polished,
                    "with --exists: write the table of the method that is proved to exist to this file");
    sub->footer(
        "Files may hold several tableaux: additive, partitioned, separable and Nystrom methods. A pair of\n"
        "families, lobatto_iiia+lobatto_iiib 4, is certified as symplectic.\n"
        "With --exists: 0 there is such a method; 1 a claim of the table is refuted; 3 not proved.\n"
        "Exit code: 0 nothing claimed is refuted; 1 something is; 2 unusable input; 3 a claim is beyond "
        "what\n"
        "the digits given can test. Of several files the first of 1, 2, 3, 0 that occurs.");
    sub->callback([] {
        try {
            run(o);
        } catch (const std::invalid_argument& e) {
            if (o.files.json) tool::print_unusable(e.what());
            throw;
        }
    });
}};

}  // namespace
