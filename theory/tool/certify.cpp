// SPDX-License-Identifier: BSL-1.0
#include <iostream>
#include <stagecraft/theory/judging/certificate_json.hpp>
#include <stagecraft/theory/judging/certify.hpp>
#include <string>

#include "certify_file.hpp"
#include "command.hpp"

namespace {

using namespace stagecraft;

struct options {
    std::string family;
    std::string stages;
    bool json = false;
};

void run(const options& o) {
    if (o.stages.empty()) {
        if (!o.family.ends_with(".json")) {
            const auto f = tableaux::family_from_name(o.family);
            throw std::invalid_argument("stages: missing after " + o.family +
                                        "; allowed: a whole number from " +
                                        std::to_string(tableaux::least_stages(f)) + " to 1000");
        }
        const int code = tool::certify_file(o.family, o.json);
        if (code != 0) throw CLI::RuntimeError(code);
        return;
    }
    const auto f = tableaux::family_from_name(o.family);
    const int s = tool::whole_number("stages", o.stages, tableaux::least_stages(f), 1000);
    const auto certificate = theory::certify(f, s);
    if (o.json) {
        std::cout << theory::to_json(certificate).dump(2) << '\n';
    } else {
        std::cout << certificate.text();
    }
}

const tool::command certify{[](CLI::App& app) {
    static options o;
    auto* sub = app.add_subcommand(
        "certify", "Prove order, stability and more of a family's member or judge a tableau file, exactly");
    sub->add_option("FAMILY", o.family, "FILE.json, or one of: " + tableaux::family_names())->required();
    sub->add_option("S", o.stages, "number of stages, with a family");
    sub->add_flag("--json", o.json, "print JSON instead of text");
    sub->callback([] { run(o); });
}};

}  // namespace
