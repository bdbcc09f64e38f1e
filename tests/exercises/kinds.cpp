// SPDX-License-Identifier: BSL-1.0
// Exercises: every solution is certified, the same seed gives the same exercise, and a wrong solution is found out.
#define BOOST_TEST_MODULE exercises
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <set>
#include <stagecraft/theory/exercises/html.hpp>
#include <stagecraft/theory/exercises/kinds.hpp>
#include <stagecraft/theory/exercises/methods.hpp>
#include <stagecraft/theory/exercises/sheet.hpp>
#include <string>
#include <vector>

#include "../message.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;

namespace {

/// Braces, brackets of displays and dollars come in pairs, environments are closed.
bool is_balanced(const std::string& latex) {
    int depth = 0;
    for (std::size_t i = 0; i < latex.size(); ++i) {
        depth += latex[i] == '{' ? 1 : latex[i] == '}' ? -1 : 0;
        if (depth < 0) return false;
    }
    const auto count = [&](const std::string& what) {
        std::size_t n = 0;
        for (auto at = latex.find(what); at != std::string::npos; at = latex.find(what, at + 1)) ++n;
        return n;
    };
    return depth == 0 && count("$") % 2 == 0 && count("\\begin{") == count("\\end{") &&
           count("\\[") == count("\\]");
}

/// Every tag is closed, in order, and no LaTeX is left outside of tags.
bool is_well_formed(const std::string& html) {
    std::vector<std::string> open;
    for (auto at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
        const auto end = html.find('>', at);
        if (end == std::string::npos) return false;
        const bool closes = html[at + 1] == '/';
        const auto begin = at + (closes ? 2 : 1);
        const auto name = html.substr(begin, html.find_first_of(" >", begin) - begin);
        if (!closes)
            open.push_back(name);
        else if (open.empty() || open.back() != name)
            return false;
        else
            open.pop_back();
    }
    return open.empty() && html.find_first_of("\\$^{}") == std::string::npos;
}

tableau<rational> euler() {
    auto t = exercise_methods::with_nodes({0});
    t.b[0] = 1;
    return t;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_thousand_seeds_of_each_of_twelve_kinds_give_certified_exercises) {
    BOOST_TEST(exercise_kinds().size() == 12u);
    for (const auto& kind : exercise_kinds()) {
        std::set<std::string> questions;
        int certified = 0, refuted_ones = 0, well_formed = 0;
        for (std::uint64_t seed = 0; seed < 1000; ++seed) {
            const exercise e = make_exercise(kind.name, seed);
            certified += e.certified() ? 1 : 0;
            refuted_ones += e.certificate.front().verdict.is_refuted() ? 1 : 0;
            const std::string text = to_text(e), latex = to_latex(e);
            const std::string html = to_html(e.question) + to_html(e.solution);
            well_formed +=
                text.find_first_of("\\${}") == std::string::npos && is_balanced(latex) && is_well_formed(html)
                    ? 1
                    : 0;
            questions.insert(to_text(e.question));
        }
        BOOST_TEST(certified == 1000, kind.name);
        BOOST_TEST(well_formed == 1000, kind.name);
        BOOST_TEST(questions.size() > 100u, kind.name << ": " << questions.size() << " different ones");
        // both answers occur where the question is whether
        if (kind.name == "a-stability" || kind.name == "b-stability" || kind.name == "root-condition") {
            BOOST_TEST(refuted_ones > 100, kind.name);
            BOOST_TEST(refuted_ones < 950, kind.name);
        }
    }
}

BOOST_AUTO_TEST_CASE(what_a_seed_gives_is_fixed) {
    dice d(
        1);  // 10000 draws of std::mt19937_64 from its default seed end in a number that the standard states
    std::mt19937_64 engine;
    engine.discard(9999);
    BOOST_TEST(engine() == 9981545732273789042ULL);
    const std::vector<int> first{d.between(0, 99), d.between(0, 99), d.between(0, 99), d.between(0, 99)};
    BOOST_TEST((first == std::vector<int>{28, 62, 30, 46}));
    BOOST_TEST(to_text(make_exercise("ghosts", 7)) == to_text(make_exercise("ghosts", 7)));
    BOOST_TEST(to_text(make_exercise("ghosts", 7)) != to_text(make_exercise("ghosts", 8)));
    BOOST_TEST(
        to_text(make_exercise("collocation", 2).question) ==
        "Construct the collocation method with the nodes 1/3, 1. What are its order and its stage order?\n");
}

BOOST_AUTO_TEST_CASE(wrong_solutions_are_found_out) {
    BOOST_TEST(order_is(euler(), 1).agrees());
    BOOST_TEST(!order_is(euler(), 2).agrees());
    BOOST_TEST(!order_is(euler(), 0).agrees());
    auto shifted = euler();
    shifted.c[0] = 1;
    BOOST_TEST(!order_is(shifted, 1).agrees());
    BOOST_TEST(failing_are(euler(), 2, {"[tau]"}).agrees());
    BOOST_TEST(!failing_are(euler(), 2, {}).agrees());
    BOOST_TEST(!failing_are(euler(), 3, {"[tau]"}).agrees());
    BOOST_TEST(!one_solution(tableaux::dense<rational>::Constant(2, 2, rational(1))).agrees());
    // x' = x - x^2, explicit midpoint rule, h = 1: 0, 1 and the ghosts 2, 3
    auto midpoint = exercise_methods::with_nodes({0, {1, 2}});
    exercise_methods::set_row(midpoint, 1, {0});
    midpoint.b[1] = 1;
    const auto found = ghosts(
        midpoint, [](const auto&, const auto& x, auto& f) { f[0] = x[0] - x[0] * x[0]; }, 1);
    const std::vector<claimed_point> right{
        {0, {5, 2}, true}, {1, {1, 2}, true}, {2, {3, 2}, false}, {3, {-1, 2}, false}};
    BOOST_TEST(fixed_points_are(found, right).agrees());
    for (int wrong = 0; wrong < 4; ++wrong) {
        auto claimed = right;
        if (wrong == 0) claimed.pop_back();
        if (wrong == 1) claimed[2].x = rational(21, 10);
        if (wrong == 2) claimed[3].multiplier = 2;
        if (wrong == 3) claimed[2].equilibrium = true;
        BOOST_TEST(!fixed_points_are(found, claimed).agrees());
    }
    exercise e = make_exercise("order", 3);
    e.certificate.push_back(order_is(euler(), 2));
    BOOST_TEST(!e.certified());
    e.certificate.clear();
    BOOST_TEST(!e.certified());  // nothing confirmed
}

BOOST_AUTO_TEST_CASE(formulas_are_readable_without_latex) {
    BOOST_TEST(plain("$\\frac{1}{2} h^{2} \\lambda \\le -\\frac{3}{4}$") == "1/2 h^2 lambda <= -3/4");
    BOOST_TEST(plain("$x_{n+1} \\ne \\sqrt{\\frac{a}{b + c}}$") == "x_(n+1) != sqrt(a/(b + c))");
    BOOST_TEST(plain("$\\left( \\frac{d}{dt} |x|^{2} \\right)$") == "( d/dt |x|^2 )");
    BOOST_TEST(latex(rational(-3, 4)) == "-\\frac{3}{4}");
    BOOST_TEST(latex(polynomial<rational>{0, -1, rational(1, 2), 1}, "z") ==
               "-z + \\frac{1}{2} z^{2} + z^{3}");
    BOOST_TEST(latex(polynomial<rational>{}, "z") == "0");
}

BOOST_AUTO_TEST_CASE(an_unknown_kind_is_named_with_those_that_exist) {
    const auto text = message([] { make_exercise("quiz", 1); });
    BOOST_TEST(text.starts_with("kind: unknown name 'quiz', allowed: missing-entry, order, "));
    BOOST_TEST(text.ends_with("root-condition"));
}

BOOST_AUTO_TEST_CASE(formulas_are_written_as_mathml) {
    BOOST_TEST(html("a < b~c") == "a &lt; b&nbsp;c");
    BOOST_TEST(html("$x_1^{2}$") ==
               "<math><mrow><msubsup><mi>x</mi><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></msubsup></"
               "mrow></math>");
    BOOST_TEST(html("$-\\frac{1}{3} \\lambda$") ==
               "<math><mrow><mo>&minus;</mo><mfrac><mrow><mn>1</mn></mrow><mrow><mn>3</mn></mrow></mfrac>"
               "<mi>&lambda;</mi></mrow></math>");
}

BOOST_AUTO_TEST_CASE(a_sheet_has_different_exercises_and_its_solutions_last) {
    const auto sheet = make_sheet("order", 10, 3);
    std::set<std::string> questions;
    for (const auto& e : sheet.exercises) {
        BOOST_TEST(e.kind == "order");
        BOOST_TEST(e.certified());
        questions.insert(to_text(e.question));
    }
    BOOST_TEST(questions.size() == 10u);
    BOOST_TEST(sheet.exercises.front().seed == 3u);
    const std::string latex = to_latex(sheet);
    BOOST_TEST(is_balanced(latex));
    const auto solutions = latex.find("Solutions");
    BOOST_TEST(latex.find("subsection*{10. order") < solutions);
    BOOST_TEST(latex.find("paragraph*{1. order") > solutions);
    BOOST_TEST(to_html(make_sheet("", 12, 1, false)).find("Solutions") == std::string::npos);
    BOOST_TEST(message([] { make_sheet("quiz", 1, 1); }).find("quiz") != std::string::npos);
}
