// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE tree_text
#include <boost/test/unit_test.hpp>
#include <set>
#include <stagecraft/theory/trees/tree_text.hpp>
#include <stdexcept>
#include <string>

using namespace stagecraft;
using namespace stagecraft::theory;

BOOST_AUTO_TEST_CASE(brackets_are_butchers_and_read_back) {
    BOOST_TEST(bracket(rooted_tree{}) == "tau");
    BOOST_TEST(bracket(rooted_tree{1, 2, 3, 2, 2}) == "[tau,tau,[tau]]");
    BOOST_TEST(bracket(tall_tree(4)) == "[[[tau]]]");
    BOOST_TEST(bracket_latex(rooted_tree{1, 2, 3, 2, 2}) == "[\\tau^{2},[\\tau]]");
    std::set<std::string> seen;
    for (int n = 1; n <= 8; ++n)
        for (const rooted_tree& t : trees_of_order(n)) {
            BOOST_REQUIRE(tree_from_bracket(bracket(t)) == t);
            seen.insert(bracket(t));
            seen.insert(condition_text(t));
            seen.insert(condition_latex(t));
        }
    BOOST_TEST(seen.size() == 3U * 200U);  // no two trees are written alike
    BOOST_TEST((tree_from_bracket("[[tau],tau]") == tree_from_bracket("[tau,[tau]]")));
}

BOOST_AUTO_TEST_CASE(other_text_is_no_tree) {
    for (const char* text : {"", "[", "[]", "tau,tau", "[tau", "tau]", "[tau,]", "[,tau]", "[tau]]",
                             "[tau][tau]", "t", "[tau tau]", "tautau", "[[]]", "]", "[tau],tau"})
        BOOST_CHECK_THROW(tree_from_bracket(text), std::invalid_argument);
    BOOST_CHECK_THROW(tree_from_bracket(std::string(100, '[')), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(conditions_are_written_in_the_expression_language) {
    BOOST_TEST(condition_text(rooted_tree{}) == "dot(b, one) == 1");
    BOOST_TEST(condition_text(tall_tree(2)) == "dot(b, c) == 1/2");
    BOOST_TEST(condition_text(tall_tree(4)) == "dot(b, A*(A*c)) == 1/24");
    BOOST_TEST(condition_text(tree_from_bracket("[tau,[tau,tau]]")) == "dot(b, c*(A*(c*c))) == 1/15");
    BOOST_TEST(condition_text(tree_from_bracket("[tau,tau,[tau]]")) == "dot(b, c*c*(A*c)) == 1/10");
    BOOST_TEST(condition_text(tree_from_bracket("[[tau],[tau]]")) == "dot(b, pow<2>(A*c)) == 1/20");
    BOOST_TEST(condition_text(tree_from_bracket("[tau,tau,tau]")) == "dot(b, pow<3>(c)) == 1/4");
    BOOST_TEST(condition_text(tree_from_bracket("[[tau],[[tau]],[tau,tau]]")) ==
               "dot(b, (A*c)*(A*(c*c))*(A*(A*c))) == 1/324");
}

BOOST_AUTO_TEST_CASE(conditions_in_latex_use_indices) {
    BOOST_TEST(condition_latex(rooted_tree{}) == "\\sum_{i} b_{i} = 1");
    BOOST_TEST(condition_latex(tree_from_bracket("[tau,tau,[tau]]")) ==
               "\\sum_{i} b_{i} c_{i}^{2} \\sum_{j} a_{ij} c_{j} = \\frac{1}{10}");
    BOOST_TEST(condition_latex(tree_from_bracket("[[tau],[tau]]")) ==
               "\\sum_{i} b_{i} \\bigl(\\sum_{j} a_{ij} c_{j}\\bigr)^{2} = \\frac{1}{20}");
    BOOST_TEST(condition_latex(tall_tree(4)) ==
               "\\sum_{i} b_{i} \\sum_{j} a_{ij} \\sum_{k} a_{jk} c_{k} = \\frac{1}{24}");
}
