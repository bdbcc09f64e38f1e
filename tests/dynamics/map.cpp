// SPDX-License-Identifier: BSL-1.0
// theory/SOURCES.md says where each statement of the lecture is carried: every file, test and test case that it names
// exists.
#define BOOST_TEST_MODULE map
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

namespace {

const std::filesystem::path root = STAGECRAFT_SOURCE_DIR;

std::string text(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
}

struct counts {
    int files = 0, tests = 0, cases = 0, missing = 0;
};

/// Looks up what stands between backquotes in the map: paths with an ending, tests "group/name", and beginnings of the
/// names of cases of the test before.
counts look_up(const std::string& map) {
    counts n;
    std::string source;  // of the test named last
    const std::regex quoted("`([^`]+)`"), test("[a-z0-9_]+/[a-z0-9_]+"),
        name("[a-zA-Z0-9]+(_[a-zA-Z0-9]+){2,}");
    for (auto m = std::sregex_iterator(map.begin(), map.end(), quoted); m != std::sregex_iterator(); ++m) {
        const std::string what = (*m)[1];
        bool found = true;
        if (std::regex_match(what, test)) {
            ++n.tests;
            source = text(root / "tests" / (what + ".cpp"));
            found = !source.empty();
        } else if (what.find('/') != std::string::npos && what.find('.') != std::string::npos &&
                   what[0] != 'b' && what.find('<') == std::string::npos) {
            ++n.files;
            found = std::filesystem::exists(root / what);
        } else if (std::regex_match(what, name)) {
            ++n.cases;
            found = source.find("BOOST_AUTO_TEST_CASE(" + what) != std::string::npos ||
                    source.find("BOOST_AUTO_TEST_CASE(\n    " + what) != std::string::npos;
        }
        if (!found) {
            ++n.missing;
            BOOST_TEST_MESSAGE("missing: " << what);
        }
    }
    return n;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_file_test_and_case_that_the_lectures_map_names_exists) {
    const std::string readme = text(root / "theory/SOURCES.md");
    const auto begin = readme.find("# Where each statement of the lecture is carried");
    BOOST_REQUIRE((begin != std::string::npos));
    const counts n = look_up(readme.substr(begin));
    BOOST_TEST(n.missing == 0);
    BOOST_TEST(n.files >= 30);
    BOOST_TEST(n.tests >= 30);
    BOOST_TEST(n.cases >= 30);
}

BOOST_AUTO_TEST_CASE(a_map_that_names_what_is_not_there_is_found_out) {
    BOOST_TEST(look_up("`theory/stagecraft/theory/dynamics/nothing.hpp`").missing == 1);
    BOOST_TEST(look_up("`dynamics/nothing`").missing == 1);
    BOOST_TEST(look_up("`dynamics/ghosts`: `satz_9_9_never_stated`").missing == 1);
    BOOST_TEST(look_up("`dynamics/one_step`: `satz_1_24_equilibria_stay`").missing == 0);
}
