// SPDX-License-Identifier: BSL-1.0
// The command's `tableau` and `coefficients`, run as a user runs them.
#define BOOST_TEST_MODULE command
#include <sys/wait.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

namespace {

struct outcome {
    int status;
    std::string text;  ///< standard output and standard error
};

outcome run(const std::string& arguments) {
    const std::string line = STAGECRAFT_BINARY_DIR "/stagecraft " + arguments + " 2>&1";
    FILE* pipe = popen(line.c_str(), "r");
    BOOST_REQUIRE(pipe);
    outcome result{0, ""};
    for (int ch = std::fgetc(pipe); ch != EOF; ch = std::fgetc(pipe)) result.text += static_cast<char>(ch);
    result.status = WEXITSTATUS(pclose(pipe));
    return result;
}

void expect_refusal(const std::string& arguments, const std::string& allowed) {
    const outcome result = run(arguments);
    BOOST_TEST_CONTEXT(arguments << ": " << result.text) {
        BOOST_TEST(result.status == 2);
        BOOST_TEST(std::count(result.text.begin(), result.text.end(), '\n') == 1);
        BOOST_TEST(result.text.find(allowed) != std::string::npos);
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(json_holds_the_tableau_in_decimal_strings) {
    const outcome result = run("tableau radau_iia 3 --format json");
    BOOST_REQUIRE(result.status == 0);
    const auto t = nlohmann::json::parse(result.text);
    BOOST_TEST(t.at("family") == "radau_iia");
    BOOST_TEST(t.at("stages") == 3);
    BOOST_TEST(t.at("digits") == 20);
    BOOST_TEST(t.at("c").at(0) == "0.15505102572168219018");  // (4 - sqrt(6)) / 10
    BOOST_TEST(t.at("c").at(2) == "1.0000000000000000000");
    BOOST_TEST(t.at("A").size() == 3u);
    BOOST_TEST(t.at("A").at(2).at(1) == t.at("b").at(1));
    BOOST_TEST(t.at("b").at(0) == "0.37640306270046727505");  // (16 - sqrt(6)) / 36
}

BOOST_AUTO_TEST_CASE(digits_are_significant_and_correctly_rounded) {
    const auto t = nlohmann::json::parse(run("tableau gauss 2 --digits 3 --format json").text);
    BOOST_TEST(t.at("c").at(0) == "0.211");
    BOOST_TEST(t.at("A").at(0).at(0) == "0.250");
    BOOST_TEST(t.at("A").at(0).at(1) == "-0.0387");  // 1/4 - sqrt(3)/6 = -0.03867...
    const auto one = nlohmann::json::parse(run("tableau gauss 2 --digits 1 --format json").text);
    BOOST_TEST(one.at("A").at(0).at(0) == "0.2");  // 1/4, a tie, to even
    const auto long_one = nlohmann::json::parse(run("tableau gauss 4 --digits 1000 --format json").text);
    BOOST_TEST(long_one.at("b").at(0).get<std::string>().size() == 1002u);
}

BOOST_AUTO_TEST_CASE(text_and_latex_hold_every_number) {
    const outcome text = run("tableau lobatto_iiia 2 --digits 4");
    BOOST_TEST(text.status == 0);
    BOOST_TEST(text.text ==
               "      0 |      0      0\n  1.000 | 0.5000 0.5000\n--------+--------------\n"
               "        | 0.5000 0.5000\n");
    const outcome latex = run("tableau lobatto_iiia 2 --digits 2 --format latex");
    BOOST_TEST(latex.text ==
               "\\begin{array}{c|cc}\n0 & 0 & 0 \\\\\n1.0 & 0.50 & 0.50 \\\\\n\\hline\n & 0.50 & 0.50\n"
               "\\end{array}\n");
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused_in_one_line_that_says_what_is_allowed) {
    expect_refusal("tableau runge 3", "radau_iia");
    expect_refusal("tableau gauss three", "from 1 to 500");
    expect_refusal("tableau lobatto_iiia 1", "from 2 to 500");
    expect_refusal("tableau gauss 501", "from 1 to 500");
    expect_refusal("tableau gauss -1", "'-1' is not a whole number from 1 to 500");
    expect_refusal("tableau gauss 3 --digits 0", "from 1 to 1000");
    expect_refusal("tableau gauss 3 --digits 1001", "from 1 to 1000");
    expect_refusal("tableau gauss 3 --format xml", "text, json, latex");
    expect_refusal("tableau gauss", "stages");
    expect_refusal("tableau gauss 3 4", "--digits");
    expect_refusal("coefficients radau 3", "lobatto_iiic");
    expect_refusal("coefficients gauss 0", "from 1");
    expect_refusal("coefficients gauss", "a family needs its largest number of stages");
    expect_refusal("coefficients " STAGECRAFT_SOURCE_DIR
                   "/tableaux/catalogue/dormand_prince_5_4.json " STAGECRAFT_SOURCE_DIR
                   "/tableaux/pairs/nystrom_4.json",
                   "a header holds methods of one tableau, or of several");
}
