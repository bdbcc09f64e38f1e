// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE certified
#include <stagecraft/theory/judging/method_table.hpp>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "../catalogue.hpp"
#include "../checked.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;
namespace fs = std::filesystem;

namespace {
const fs::path source = STAGECRAFT_SOURCE_DIR;

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// The catalogue's certificates, made once.
const std::map<std::string, file_certificate>& catalogue() {
    static const std::map<std::string, file_certificate> all = [] {
        std::map<std::string, file_certificate> made;
        for (const fs::path& file : tableau_files_in(source / "tableaux/catalogue"))
            made.emplace(file.stem().string(), checked::certify_file(file.string()));
        return made;
    }();
    return all;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const auto from = text.find(begin);
    if (from == std::string::npos) return "no " + begin;
    const auto start = from + begin.size();
    const auto to = text.find(end, start);
    return to == std::string::npos ? "no " + end : text.substr(start, to - start);
}
}  // namespace

BOOST_AUTO_TEST_CASE(nothing_a_catalogue_file_claims_is_refuted_and_exact_claims_are_proved) {
    BOOST_TEST(catalogue().size() >= 60U);
    int proved = 0;
    for (const auto& [name, c] : catalogue()) {
        BOOST_TEST(c.exit_code() == 0, name);
        const bool rounded = c.data == tableaux::name(tableaux::number_kind::rounded);
        BOOST_TEST((rounded || c.overall() == standing::proved), name);
        proved += c.overall() == standing::proved;
        for (const char* order : {"order", "embedded_order", "stage_order"})
            if (const finding* f = c.find(order); f && f->claimed)
                BOOST_TEST(std::to_string(f->value.value()) == *f->claimed, name << ": " << order);
    }
    BOOST_TEST(proved >= 60);
}

BOOST_AUTO_TEST_CASE(every_property_is_claimed_of_exact_implicit_methods) {
    for (const auto& [name, c] : catalogue()) {
        if (c.data == tableaux::name(tableaux::number_kind::rounded)) continue;
        for (const char* property :
             {"A_stable", "L_stable", "algebraically_stable", "symplectic", "symmetric", "stage_order"})
            BOOST_TEST((c.find(property) && c.find(property)->claimed), name << ": " << property);
    }
}

BOOST_AUTO_TEST_CASE(no_explicit_method_is_a_stable_or_algebraically_stable) {
    // Lecture, Satz 2.22 and HW II.IV.12: refuted with a witness for each of them.
    int explicit_methods = 0;
    for (const auto& [name, c] : catalogue()) {
        const auto file = read_once::catalogue().at(name);
        bool is_explicit = true;
        for (int i = 0; i < file.stages(); ++i)
            for (int j = i; j < file.stages(); ++j) is_explicit &= file.A[i][j].text == "0";
        if (!is_explicit) continue;
        ++explicit_methods;
        for (const char* property : {"A_stable", "algebraically_stable"}) {
            BOOST_TEST(c.find(property)->truth->is_refuted(), name << ": " << property);
            BOOST_TEST(!c.find(property)->truth->reason().empty(), name << ": " << property);
        }
    }
    BOOST_TEST(explicit_methods >= 40);
    BOOST_TEST(catalogue().at("gauss_2").find("algebraically_stable")->truth->is_proved());
}

BOOST_AUTO_TEST_CASE(every_misprint_is_refuted_and_its_wrong_entry_named_with_the_right_value) {
    const std::regex form("\"note\": \"wrong: ([^ ]+) = [^;]+; right: ([^;]+);");
    int named = 0;
    for (const fs::path& path : tableau_files_in(source / "tests/data/misprints")) {
        const std::string text = text_of(path);
        std::smatch note;
        BOOST_REQUIRE_MESSAGE(std::regex_search(text, note, form), path);
        const auto c = checked::certify(text);
        BOOST_TEST(c.exit_code() == 1, path);
        const std::string entry = note[1], right = note[2];
        if (entry.starts_with("claims.")) {
            const finding* f = c.find(entry.substr(7));
            BOOST_TEST((f && f->judgement && f->judgement->is_refuted()), path);
            if (f && f->value) BOOST_TEST(std::to_string(*f->value) == right, path);
            continue;
        }
        const auto suspect = std::find_if(c.suspects.begin(), c.suspects.end(),
                                          [&](const auto& s) { return s.entry == entry; });
        BOOST_REQUIRE_MESSAGE(suspect != c.suspects.end(), path);
        const auto expected = tableaux::read_entry(right), found = tableaux::read_entry(suspect->suggest);
        if (expected.rounded)
            BOOST_TEST(expected.enclosure.contains(found.enclosure.middle()),
                       path << ": " << suspect->suggest);
        else
            BOOST_TEST((expected.exact == found.exact), path << ": " << suspect->suggest);
        ++named;
    }
    BOOST_TEST(named >= 10);
}

BOOST_AUTO_TEST_CASE(the_method_table_is_the_one_the_certificates_give) {
    std::string table = method_table_head();
    for (const auto& [name, c] : catalogue()) table += method_row(c);
    const std::string shown =
        between(text_of(source / "tableaux/README.md"), "<!-- methods -->\n", "<!-- /methods -->");
    BOOST_TEST((shown == table),
               "tableaux/README.md: replace the lines between <!-- methods --> and <!-- /methods --> "
               "by the output of build/stagecraft table tableaux/catalogue");
}

BOOST_AUTO_TEST_CASE(rows_say_what_is_proved_refuted_or_open) {
    BOOST_TEST(method_row(catalogue().at("radau_iia_2")).find("| 2 | 3 | 2 | yes | yes | yes | no | exact") !=
               std::string::npos);
    BOOST_TEST(
        method_row(catalogue().at("dormand_prince_5_4")).find("| 7 | 5(4) | 1 | no | no | no | no |") !=
        std::string::npos);
    BOOST_TEST(method_row(catalogue().at("kvaerno_3_2")).find("| 4 | 3(2) | 2 | (yes) | (yes) | no |") !=
               std::string::npos);
    auto misprint = checked::certify_file((source / "tests/data/misprints/fehlberg_3554.json").string());
    BOOST_TEST(method_row(misprint).find("| 4(1) |") != std::string::npos);
    BOOST_CHECK_THROW(tableau_files_in(source / "README.md"), std::invalid_argument);
    misprint.name = "a|b";
    BOOST_TEST(method_row(misprint).find("| a\\|b |") != std::string::npos);
}
