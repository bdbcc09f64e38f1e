// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE mutation
// Does the checker notice a change of one entry, and does it find it? Every catalogue file, every nonzero
// entry; by default each n-th of the changes only. Arguments after "--": n (1 for all, default 40), and a
// file to print misses to: `test_checker_mutation -- 1 misses.txt`.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "../checked.hpp"

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

bool is_decimal(const std::string& text) { return text.find('.') != std::string::npos; }
bool is_zero(const std::string& text) { return text.find_first_of("123456789") == std::string::npos; }

/// The entry times 1 + 1e-3; a decimal keeps its digits and gets 1e-3 of its leading digits added.
std::optional<std::string> grown(const std::string& text) {
    if (!is_decimal(text)) return "(" + text + ")*1001/1000";
    const auto first = text.find_first_of("123456789");
    std::string digits = text;
    // Three significant places below the leading digit: one unit there.
    std::size_t at = first;
    for (int left = 3; left > 0; ++at) {
        if (at + 1 >= digits.size()) return std::nullopt;
        if (digits[at + 1] != '.') --left;
    }
    if (digits[at] == '.') ++at;
    digits[at] = digits[at] == '9' ? '8' : static_cast<char>(digits[at] + 1);
    return digits;
}

/// The entry with two neighbouring digits swapped, the first pair that differs.
std::optional<std::string> swapped(const std::string& text) {
    for (std::size_t i = 0; i + 1 < text.size(); ++i)
        if (std::isdigit(static_cast<unsigned char>(text[i])) &&
            std::isdigit(static_cast<unsigned char>(text[i + 1])) && text[i] != text[i + 1]) {
            std::string other = text;
            std::swap(other[i], other[i + 1]);
            return other;
        }
    return std::nullopt;
}

struct slot {
    std::string name;
    json::json_pointer at;
};

std::vector<slot> slots(const json& file) {
    std::vector<slot> all;
    const auto index = [](std::size_t i) { return "[" + std::to_string(i + 1) + "]"; };
    for (const auto* key : {"b", "c", "b_embedded"})
        if (file.contains(key))
            for (std::size_t i = 0; i < file[key].size(); ++i)
                all.push_back(
                    {key + index(i), json::json_pointer("/" + std::string(key) + "/" + std::to_string(i))});
    for (std::size_t i = 0; i < file["A"].size(); ++i)
        for (std::size_t j = 0; j < file["A"].size(); ++j)
            all.push_back({"A" + index(i) + index(j),
                           json::json_pointer("/A/" + std::to_string(i) + "/" + std::to_string(j))});
    return all;
}

struct tally {
    long tried = 0;
    long refuted = 0;
    long found = 0;
    long suspects = 0;  ///< how many were named altogether
};

}  // namespace

BOOST_AUTO_TEST_CASE(changes_of_one_entry_are_refuted_and_found) {
    const auto& suite = boost::unit_test::framework::master_test_suite();
    const long every = suite.argc > 1 ? std::stol(suite.argv[1]) : 40;
    std::ofstream misses(suite.argc > 2 ? suite.argv[2] : "/dev/null");
    std::vector<fs::path> files;
    for (const auto& f : fs::directory_iterator(fs::path(STAGECRAFT_SOURCE_DIR) / "tableaux/catalogue"))
        files.push_back(f.path());
    std::sort(files.begin(), files.end());
    tally tiny, large, swaps;
    long counter = 0;
    for (const auto& path : files) {
        std::ifstream in(path);
        const json original = json::parse(in);
        bool exact = true;
        for (const auto& s : slots(original)) exact = exact && !is_decimal(original[s.at].get<std::string>());
        for (const auto& s : slots(original)) {
            const std::string text = original[s.at];
            if (is_zero(text)) continue;
            const auto attempt = [&](tally& t, const std::optional<std::string>& changed) {
                if (!changed || counter++ % every != 0) return;
                json file = original;
                file[s.at] = *changed;
                const auto c = checked::certify(file.dump());
                const bool found = std::any_of(c.suspects.begin(), c.suspects.end(),
                                               [&](const auto& x) { return x.entry == s.name; });
                ++t.tried;
                t.refuted += c.exit_code();
                t.found += found ? 1 : 0;
                t.suspects += static_cast<long>(c.suspects.size());
                if (c.exit_code() == 0 || !found)
                    misses << path.filename().string() << " " << s.name << " " << text << " -> " << *changed
                           << (c.exit_code() == 0 ? " not refuted" : " not found") << std::endl;
            };
            if (exact) attempt(tiny, "(" + text + ")*(1+10^-12)");
            attempt(large, grown(text));
            attempt(swaps, swapped(text));
        }
    }
    const auto report = [](const char* what, const tally& t) {
        std::cout << what << ": " << t.tried << " changes, " << t.refuted << " refuted, the entry found in "
                  << t.found << " (" << 100.0 * static_cast<double>(t.found) / static_cast<double>(t.tried)
                  << " %), " << static_cast<double>(t.suspects) / static_cast<double>(t.tried)
                  << " suspects each\n";
    };
    report("relative 1e-12, exact data", tiny);
    report("relative 1e-3", large);
    report("two digits swapped", swaps);
    BOOST_TEST(tiny.tried > 0);
    BOOST_TEST(tiny.refuted == tiny.tried);
    BOOST_TEST(100 * (large.found + swaps.found) >= 95 * (large.tried + swaps.tried));
}
