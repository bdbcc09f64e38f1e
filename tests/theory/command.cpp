// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE command
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/family.hpp>
#include <string>

// Runs build/stagecraft as a user would.

namespace {

struct result {
    int status;
    std::string output;
};

// Standard output only, or standard error only.
result run(const std::string& arguments, bool errors = false) {
    const std::string command = std::string(STAGECRAFT_BINARY_DIR) + "/stagecraft " + arguments +
                                (errors ? " 2>&1 >/dev/null" : " 2>/dev/null");
    FILE* pipe = popen(command.c_str(), "r");
    BOOST_REQUIRE(pipe != nullptr);
    std::string output;
    std::array<char, 4096> buffer{};
    for (std::size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
        output.append(buffer.data(), n);
    const int status = pclose(pipe);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
}

void refused(const std::string& arguments, const std::string& line) {
    const result r = run(arguments, true);
    BOOST_TEST(r.status == 2);
    BOOST_TEST(r.output == line + "\n");
    BOOST_TEST(run(arguments).output == "");
}

/// What a command prints under `key`, and what `certify` says of that file.
struct judged {
    nlohmann::json tableau, certificate;
};
judged certified(const std::string& arguments, const std::string& key = "tableau") {
    const result r = run(arguments);
    BOOST_TEST(r.status == 0, arguments);
    const auto tableau = nlohmann::json::parse(r.output).at(key);
    const auto file = std::filesystem::temp_directory_path() /
                      ("stagecraft_command_" + std::to_string(::getpid()) + ".json");
    std::ofstream(file) << tableau;
    const result certificate = run("certify --json '" + file.string() + "'");
    std::filesystem::remove(file);
    BOOST_TEST(certificate.status == 0, arguments);
    return {tableau, nlohmann::json::parse(certificate.output)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(families_lists_every_family) {
    const result r = run("families");
    BOOST_TEST(r.status == 0);
    for (const auto f : stagecraft::tableaux::all_families)
        BOOST_TEST(("\n" + r.output).find("\n" + std::string(name(f)) + " ") != std::string::npos);
    BOOST_TEST(std::count(r.output.begin(), r.output.end(), '\n') == 8);
}

BOOST_AUTO_TEST_CASE(certify_radau_iia_3_proves_order_5) {
    const result r = run("certify radau_iia 3 --json");
    BOOST_TEST(r.status == 0);
    const auto j = nlohmann::json::parse(r.output);
    BOOST_TEST(j["order"]["value"] == 5);
    BOOST_TEST(j["order"]["verdict"] == "proved");
    BOOST_TEST(j["B"] == 5);
    BOOST_TEST(j["C"] == 3);
    BOOST_TEST(j["D"] == 2);
    BOOST_TEST(j["R_infinity"] == "0");
    BOOST_TEST(j["error_constant"] == "1/7200");
    BOOST_TEST(nlohmann::json::parse(run("certify radau_ia 3 --json").output)["C"] == 2);
    BOOST_TEST(run("certify radau_iia 3").output.starts_with("radau_iia, 3 stages\n"));
}

BOOST_AUTO_TEST_CASE(bad_input_is_one_line_on_stderr_and_exit_2) {
    refused(
        "certify radau 3",
        "stagecraft: family: unknown name 'radau', allowed: gauss, radau_i, radau_ia, radau_ii, radau_iia, "
        "lobatto_iiia, lobatto_iiib, lobatto_iiic");
    refused("certify gauss 0", "stagecraft: stages: '0' is not a whole number from 1 to 1000");
    refused("certify gauss 3x", "stagecraft: stages: '3x' is not a whole number from 1 to 1000");
    refused("certify gauss 99999999999999999999",
            "stagecraft: stages: '99999999999999999999' is not a whole number from 1 to 1000");
    refused("certify gauss",
            "stagecraft: stages: missing after gauss; allowed: a whole number from 1 to 1000");
    refused("certify lobatto_iiic 1", "stagecraft: stages: '1' is not a whole number from 2 to 1000");
    for (const char* arguments : {"", "no_such_thing", "families x", "certify gauss 3 --yaml"}) {
        const result r = run(arguments, true);
        BOOST_TEST(r.status == 2);
        BOOST_TEST(std::count(r.output.begin(), r.output.end(), '\n') == 1);
        BOOST_TEST(r.output.find("allowed: ") != std::string::npos);
    }
    BOOST_TEST(run("--help").status == 0);
}

BOOST_AUTO_TEST_CASE(collocate_names_its_option_reads_short_decimals_and_nodes_near_the_ends) {
    refused("collocate --nodes -1,2", "stagecraft: --nodes: must lie in [0, 1], one of them is -1");
    refused("collocate --nodes 0,0,1", "stagecraft: --nodes: must be distinct, 0 is repeated");
    BOOST_TEST(run("collocate --nodes 0.5,1.0").output == run("collocate --nodes 1/2,1").output);
    BOOST_TEST(run("collocate --nodes 0.5,1.0").status == 0);
    BOOST_TEST(run("collocate --nodes 0.2113248654,1").status == 2);
    for (const char* node : {"1/10^48", "1/10^60", "1/10^80", "1-1/10^80"}) {
        const result near = run(std::string("collocate --nodes ") + node + ",1/2", true);
        BOOST_TEST(near.status == 0, node << ": " << near.output);
    }
}

// Radau IIA: b + (f(t_0, y_0) - its extrapolation)/4 has order 3 (Hairer-Wanner II, formula IV.8.19, with another factor). Nodes 1/2, 1:
// the method has order 2, and the formula on 0, 1/2, 1 is Simpson's. Trapezoidal rule: explicit Euler.
BOOST_AUTO_TEST_CASE(collocate_embeds_the_formula_of_the_highest_order) {
    const auto radau =
        certified("collocate --polynomial '10*x^3-18*x^2+9*x-1' --embedded highest --format json");
    BOOST_TEST(radau.tableau["b_embedded"][0] == "1/4");
    BOOST_TEST(radau.certificate["embedded_order"]["verdict"] == "proved");
    BOOST_TEST(radau.certificate["embedded_order"]["value"] == 3);
    BOOST_TEST(radau.certificate["order"]["value"] == 5);
    const auto simpson = certified("collocate --nodes 1/2,1 --embedded highest --json");
    BOOST_TEST(simpson.tableau["b_embedded"] == nlohmann::json({"1/6", "2/3", "1/6"}));
    BOOST_TEST(simpson.certificate["embedded_order"]["value"] == 3);
    const auto euler = certified("collocate --nodes 0,1 --embedded highest --json");
    BOOST_TEST(euler.tableau["b_embedded"] == nlohmann::json({"1", "0"}));
    const result none = run("collocate --nodes 0 --embedded highest");
    BOOST_TEST(none.status == 1);
    BOOST_TEST(none.output.find("embedded: there is no embedded formula of order 1 or more") !=
               std::string::npos);
}

BOOST_AUTO_TEST_CASE(collocate_embeds_an_l_stable_formula_or_says_that_there_is_none) {
    for (const auto& [nodes, order] : {std::pair{"1/6,2/3,1", 1}, {"1/3,2/3,1", 1}, {"1/4,1/2,3/4,1", 2}}) {
        const std::string call = std::string("collocate --embedded l-stable --json --nodes ") + nodes;
        BOOST_TEST(certified(call).certificate["embedded_order"]["value"] == order);
        const auto alone = certified(call, "embedded_tableau").certificate;
        BOOST_TEST(alone["L_stable"]["claim"] == "proved");
        BOOST_TEST(alone["order"]["value"] == order);
    }
    // Gauss 2: R = (1 + z/2)/(1 - z/2 + z^2/12) is the only one of order 1 with a numerator of degree 1, and E(y) = y^4/144 - y^2/6.
    // Gauss 3: E at small y excludes one side, at large y the other.
    for (const char* polynomial : {"6*x^2-6*x+1", "20*x^3-30*x^2+12*x-1"}) {
        const result none =
            run(std::string("collocate --embedded l-stable --polynomial '") + polynomial + "'");
        BOOST_TEST(none.status == 1);
        BOOST_TEST(none.output.find("embedded: there is no L-stable embedded formula of order 1 or more: ") !=
                   std::string::npos);
    }
    BOOST_TEST(
        nlohmann::json::parse(run("collocate --nodes 1/2 --embedded l-stable --json").output)["embedded_note"]
            .get<std::string>()
            .starts_with("there is no"));
    refused("collocate --nodes 1 --embedded best",
            "stagecraft: --embedded: unknown 'best', allowed: highest, l-stable");
    refused("collocate --nodes 1 --format xml", "stagecraft: --format: unknown 'xml', allowed: text, json");
}

BOOST_AUTO_TEST_CASE(exercise_lists_twelve_kinds_and_prints_text_latex_and_json) {
    const result list = run("exercise");
    BOOST_TEST(list.status == 0);
    BOOST_TEST(std::count(list.output.begin(), list.output.end(), '\n') == 12);
    const result text = run("exercise ghosts --seed 5");
    BOOST_TEST(text.status == 0);
    BOOST_TEST(text.output.starts_with("Exercise ghosts, seed 5\n\nFind all fixed points"));
    BOOST_TEST(text.output == run("exercise ghosts --seed 5").output);
    BOOST_TEST(run("exercise ghosts --seed 5 --latex").output.starts_with("\\documentclass"));
    const auto j = nlohmann::json::parse(run("exercise ghosts --seed 5 --json").output);
    BOOST_TEST(j["kind"] == "ghosts");
    BOOST_TEST(j["seed"] == 5);
    BOOST_TEST(j["certificate"][0]["verdict"] == "proved");
    BOOST_TEST(text.output.find(j["solution"].get<std::string>()) != std::string::npos);
    refused("exercise ghosts --seed -1",
            "stagecraft: --seed: '-1' is not a whole number from 0 to 2147483647");
    refused("exercise ghosts --json --latex", "stagecraft: exercise: give one of --latex, --html and --json");
    BOOST_TEST(run("exercise quiz").status == 2);
}

BOOST_AUTO_TEST_CASE(exercise_prints_sheets_for_a_class_with_and_without_solutions) {
    const result sheet = run("exercise --sheet 13 --seed 5");
    BOOST_TEST(sheet.status == 0);
    BOOST_TEST(sheet.output.starts_with("1. missing-entry, seed 5\n"));
    BOOST_TEST(sheet.output.find("\n13. missing-entry, seed ") !=
               std::string::npos);  // all twelve, and again
    BOOST_TEST(sheet.output.find("\nSolutions\n\n1. missing-entry") != std::string::npos);
    const result asked = run("exercise collocation --sheet 3 --no-solution --html");
    BOOST_TEST(asked.output.starts_with("<!DOCTYPE html>"));
    BOOST_TEST(asked.output.find("3. collocation") != std::string::npos);
    BOOST_TEST(asked.output.find("Solutions") == std::string::npos);
    BOOST_TEST(run("exercise order --no-solution").output.find("Certified") == std::string::npos);
    refused("exercise order --sheet 0", "stagecraft: --sheet: '0' is not a whole number from 1 to 100");
    refused("exercise order --sheet 2 --json",
            "stagecraft: exercise: --json prints one exercise, no --sheet");
    BOOST_TEST(run("exercise quiz --sheet 2").status == 2);
}
