// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE files
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/theory/models/matrix_model.hpp>
#include <stagecraft/theory/trees/tree_order.hpp>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

using namespace stagecraft;
using tableaux::number_kind;
using tableaux::tableau_file;
namespace fs = std::filesystem;

namespace {
const fs::path catalogue = fs::path(STAGECRAFT_SOURCE_DIR) / "tableaux/catalogue";
const fs::path misprints = fs::path(STAGECRAFT_SOURCE_DIR) / "tests/data/misprints";

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> all;
    for (const auto& item : fs::directory_iterator(folder)) all.push_back(item.path());
    std::sort(all.begin(), all.end());
    return all;
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// All numbers as written, without what is said of them.
std::string entries_of(const tableau_file& file) {
    std::string all;
    file.for_each_entry([&](const tableaux::entry& e) { all += e.text + " "; });
    return all;
}

/// What a catalogue file lacks of the catalogue's form; empty where nothing is missing.
std::string defect_of_form(const std::string& file_name, const std::string& text) {
    if (!std::regex_match(file_name, std::regex("[a-z][a-z0-9]*(_[a-z0-9]+)*\\.json")))
        return "the file's name is not in snake case";
    const auto file = tableaux::read_tableau(text);
    if (file.name.empty()) return "no name";
    if (!std::regex_search(file.source, std::regex("1[789][0-9][0-9]|20[0-9][0-9]")))
        return "no year in the source";
    if (!file.claims.order) return "no order claimed";
    if (!file.b_embedded.empty() && !file.claims.embedded_order) return "no embedded order claimed";
    if (file.c.empty()) return "no c";
    std::istringstream lines(text);
    int rows = 0;
    for (std::string line; std::getline(lines, line);)
        rows += std::regex_match(line, std::regex("    \\[\"[^\\[\\]]*\"\\],?"));
    if (rows != file.stages()) return "not one row of A on each line";
    return {};
}

/// Order conditions of b or of b_embedded, looked at one order beyond the claim.
template <class K>
theory::order_result<K> order_by_trees(const tableau<K>& t, bool embedded, int claimed) {
    return embedded ? theory::order_of(theory::matrix_model<K>(t, t.b_embedded), claimed + 1)
                    : theory::order_of(theory::matrix_model<K>(t), claimed + 1);
}

template <class K>
bool has_claimed_orders(const tableau_file& file, const tableau<K>& t) {
    const auto settles = [&](bool embedded, int claimed) {
        const auto found = order_by_trees(t, embedded, claimed);
        return found.order == claimed && found.is_exact();
    };
    return settles(false, *file.claims.order) &&
           (file.b_embedded.empty() || settles(true, *file.claims.embedded_order));
}

bool has_claimed_orders(const tableau_file& file) {
    return file.kind() == number_kind::rational ? has_claimed_orders(file, tableaux::to_rational(file))
                                                : has_claimed_orders(file, tableaux::to_quadratic(file));
}

bool is_exact(const tableau_file& file) { return file.kind() <= number_kind::quadratic; }
}  // namespace

BOOST_AUTO_TEST_CASE(every_file_has_the_catalogues_form) {
    const auto all = files_in(catalogue);
    BOOST_TEST(all.size() >= 60U);
    for (const auto& path : all)
        BOOST_TEST(defect_of_form(path.filename().string(), text_of(path)) == "", path.filename());
}

BOOST_AUTO_TEST_CASE(a_defect_of_form_is_seen) {
    const std::string good = text_of(catalogue / "heun_2.json");
    const auto with = [&](const char* what, const char* instead) {
        return defect_of_form("heun_2.json", std::regex_replace(good, std::regex(what), instead));
    };
    BOOST_TEST(defect_of_form("heun_2.json", good) == "");
    BOOST_TEST(defect_of_form("Heun-2.json", good) == "the file's name is not in snake case");
    BOOST_TEST(with("\"name\": \"[^\"]*\"", "\"name\": \"\"") == "no name");
    BOOST_TEST(with("\"source\": \"[^\"]*\"", "\"source\": \"a book\"") == "no year in the source");
    BOOST_TEST(with("\"order\": 2,", "") == "no order claimed");
    BOOST_TEST(with("\\],\n    \\[", "], [") == "not one row of A on each line");
}

BOOST_AUTO_TEST_CASE(no_tableau_appears_twice) {
    std::map<std::string, fs::path> seen;
    for (const auto& path : files_in(catalogue)) {
        const auto [earlier, is_new] = seen.emplace(entries_of(tableaux::read_tableau_file(path)), path);
        BOOST_TEST(is_new, path.filename() << " repeats " << earlier->second.filename());
    }
}

BOOST_AUTO_TEST_CASE(exact_files_have_exactly_the_orders_they_claim) {
    int exact = 0, rounded = 0;
    for (const auto& path : files_in(catalogue)) {
        const auto file = tableaux::read_tableau_file(path);
        if (is_exact(file)) {
            ++exact;
            BOOST_TEST(has_claimed_orders(file), path.filename());
        } else {
            ++rounded;
            BOOST_TEST((file.kind() == number_kind::rounded), path.filename());
        }
    }
    BOOST_TEST(exact >= 60);
    BOOST_TEST(rounded > 0);
}

BOOST_AUTO_TEST_CASE(a_wrong_order_is_not_confirmed) {
    auto file = tableaux::read_tableau_file(catalogue / "dormand_prince_5_4.json");
    BOOST_TEST(has_claimed_orders(file));
    file.claims.embedded_order = 5;
    BOOST_TEST(!has_claimed_orders(file));
    file.claims.embedded_order = 3;
    BOOST_TEST(!has_claimed_orders(file));
}

BOOST_AUTO_TEST_CASE(every_misprint_names_the_entry_that_is_wrong_and_the_right_one) {
    const auto all = files_in(misprints);
    BOOST_TEST(all.size() >= 15U);
    const std::regex form("\"note\": \"wrong: ([^ ]+) = ([^;]+); right: ([^;]+); .+\"");
    for (const auto& path : all) {
        const std::string text = text_of(path);
        std::smatch found;
        BOOST_REQUIRE_MESSAGE(std::regex_search(text, found, form), path);
        BOOST_TEST(found[2].str() != found[3].str(), path.filename());
        const auto file = tableaux::read_tableau(text);
        const std::string entry = found[1], wrong = found[2];
        if (entry.starts_with("claims.")) {
            BOOST_TEST(text.find('"' + entry.substr(7) + "\": " + wrong) != std::string::npos,
                       path.filename());
            continue;
        }
        std::smatch place;
        BOOST_REQUIRE_MESSAGE(
            std::regex_match(entry, place, std::regex("(A|b|c|b_embedded)\\[(\\d+)\\](?:\\[(\\d+)\\])?")),
            path);
        const std::size_t i = std::stoul(place[2]) - 1;
        const auto& vector = place[1] == "A"            ? file.A[i]
                             : place[1] == "b"          ? file.b
                             : place[1] == "b_embedded" ? file.b_embedded
                                                        : file.c;
        const std::size_t j = place[3].matched ? std::stoul(place[3]) - 1 : i;
        BOOST_TEST(vector.at(j).text == wrong, path.filename());
    }
}

BOOST_AUTO_TEST_CASE(exact_misprints_lose_an_order) {
    int entries = 0, kept = 0;
    for (const auto& path : files_in(misprints)) {
        const std::string text = text_of(path);
        const auto file = tableaux::read_tableau(text);
        if (!is_exact(file)) continue;
        const bool is_entry = text.find("wrong: claims.") == std::string::npos;
        const bool is_order = text.find("wrong: claims.order") != std::string::npos;
        entries += is_entry;
        kept += has_claimed_orders(file);
        BOOST_TEST(has_claimed_orders(file) == !(is_entry || is_order), path.filename());
    }
    BOOST_TEST(entries >= 10);
    BOOST_TEST(kept >= 3);  // those that only claim a stability they do not have
}
