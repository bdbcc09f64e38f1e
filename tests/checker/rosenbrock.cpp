// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE rosenbrock
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/theory/judging/rosenbrock_report.hpp>
#include <stagecraft/theory/plot/method_data.hpp>
#include <stagecraft/theory/trees/rosenbrock_trees.hpp>
#include <string>
#include <vector>
#include "../checked.hpp"
#include "../message.hpp"

// Rosenbrock and W methods: their trees, the published tables, and what is wrong with one.

using stagecraft::theory::rosenbrock_conditions;
using stagecraft::theory::rosenbrock_trees;

namespace {

namespace theory = stagecraft::theory;
namespace tableaux = stagecraft::tableaux;
const std::string folder = STAGECRAFT_SOURCE_DIR "/tableaux/rosenbrock/";

std::string text_of(const std::string& name) { return tableaux::text_of_file(folder + name + ".json"); }

std::string changed(std::string text, const std::string& what, const std::string& instead) {
    const auto at = text.find(what);
    BOOST_REQUIRE_MESSAGE(at != std::string::npos, what);
    return text.replace(at, what.size(), instead);
}

std::vector<std::size_t> conditions_by_level(rosenbrock_conditions which, int most) {
    const rosenbrock_trees trees(which, most);
    std::vector<std::size_t> count;
    for (int n = 1; n <= most; ++n) count.push_back(trees.of_level(n).size());
    return count;
}

std::vector<std::string> conditions_of_level(rosenbrock_conditions which, int level) {
    const rosenbrock_trees trees(which, level);
    std::vector<std::string> all;
    for (const auto row : trees.of_level(level)) all.push_back(trees.condition(row));
    std::sort(all.begin(), all.end());
    return all;
}

int value_of(const theory::file_certificate& c, const char* name) { return c.find(name)->value.value_or(-1); }

}  // namespace

BOOST_AUTO_TEST_CASE(conditions_are_those_of_the_book) {
    // Hairer-Wanner II, section IV.7: 1, 1, 2, 4, 9, 20 conditions of a Rosenbrock method; of a W-method 1, 3, 8, 21 together.
    BOOST_TEST(conditions_by_level(rosenbrock_conditions::jacobian, 8) ==
               (std::vector<std::size_t>{1, 1, 2, 4, 9, 20, 48, 115}));
    BOOST_TEST(conditions_by_level(rosenbrock_conditions::any_matrix, 4) ==
               (std::vector<std::size_t>{1, 2, 5, 13}));
    BOOST_TEST(
        conditions_of_level(rosenbrock_conditions::jacobian, 4) ==
        (std::vector<std::string>{"dot(b, beta*(beta*(beta*one))) == 1/24", "dot(b, beta*(c*c)) == 1/12",
                                  "dot(b, c*(A*(beta*one))) == 1/8", "dot(b, c*c*c) == 1/4"}));
    BOOST_TEST(conditions_of_level(rosenbrock_conditions::any_matrix, 2) ==
               (std::vector<std::string>{"dot(b, Gamma*one) == 0", "dot(b, c) == 1/2"}));
    // There, section VI.4: what index 1 asks for besides, one condition of order 3 and four of order 4.
    const auto besides = [](int level) {
        auto all = conditions_of_level(rosenbrock_conditions::index_1, level);
        for (const std::string& known : conditions_of_level(rosenbrock_conditions::jacobian, level))
            all.erase(std::find(all.begin(), all.end(), known));
        return all;
    };
    BOOST_TEST(besides(2).empty());
    BOOST_TEST(besides(3) == (std::vector<std::string>{"dot(b, omega*(c*c)) == 1"}));
    BOOST_TEST(besides(4) ==
               (std::vector<std::string>{
                   "dot(b, c*(A*(omega*(c*c)))) == 1/4", "dot(b, omega*(c*(A*(beta*one)))) == 1/2",
                   "dot(b, omega*(c*(A*(omega*(c*c))))) == 1", "dot(b, omega*(c*c*c)) == 1"}));
}

BOOST_AUTO_TEST_CASE(every_published_method_has_the_orders_that_are_claimed) {
    int files = 0;
    for (const auto& item : std::filesystem::directory_iterator(folder)) BOOST_TEST_CONTEXT(item.path()) {
            const auto text = tableaux::text_of_file(item.path().string());
            const auto c = checked::certify_method(text);
            BOOST_TEST(c.exit_code() == 0);
            const auto claims = nlohmann::json::parse(text)["claims"];
            for (const char* name : {"order", "embedded_order", "w_order", "index_1_order"})
                if (claims.contains(name)) BOOST_TEST(value_of(c, name) == claims[name].get<int>(), name);
            const auto again = theory::json_text(c);
            BOOST_TEST(checked::certify_method(again).exit_code() == 0);
            ++files;
        }
    BOOST_TEST(files >= 10);
}

BOOST_AUTO_TEST_CASE(exact_methods_are_decided) {
    const auto ros2 = checked::certify_method(text_of("ros2"));
    for (const char* name : {"order", "w_order", "A_stable", "L_stable"})
        BOOST_TEST(ros2.find(name)->judgement->is_proved(), name);
    const auto ros3p = checked::certify_method(text_of("ros3p"));
    for (const char* name : {"order", "embedded_order", "index_1_order", "A_stable"})
        BOOST_TEST(ros3p.find(name)->judgement->is_proved(), name);
    // As published: A-stable with |R(infinity)| about 0.73.
    BOOST_TEST(
        (std::find(ros3p.notes.begin(), ros3p.notes.end(), "R(infinity) = 1-sqrt(3)") != ros3p.notes.end()));
    // The linearly implicit midpoint rule: |R(infinity)| = 1, of index 1 nothing is known.
    const auto midpoint = checked::certify_method(
        R"({"form":"rosenbrock","A":[["0"]],"Gamma":[["1/2"]],"b":["1"],"claims":{"order":2,"index_1_order":2}})");
    BOOST_TEST(midpoint.find("order")->judgement->is_proved());
    BOOST_TEST(value_of(midpoint, "w_order") == 1);
    BOOST_TEST(midpoint.find("index_1_order")->judgement->is_refuted());
}

BOOST_AUTO_TEST_CASE(both_forms_are_one_method) {
    // RODAS3 as codes have it: Gamma^{-1} by hand.
    const auto c = checked::certify_method(R"({"form":"rosenbrock","gamma":"1/2",
        "a":[["0","0","0","0"],["0","0","0","0"],["2","0","0","0"],["2","0","1","0"]],
        "C":[["0","0","0","0"],["4","0","0","0"],["1","-1","0","0"],["1","-1","-8/3","0"]],
        "m":["2","0","1","1"],"e":["0","0","0","1"],"c":["0","0","1","1"],"d":["1/2","3/2","0","0"],
        "claims":{"order":3,"embedded_order":2,"index_1_order":3,"L_stable":true,"stiffly_accurate":true}})");
    const auto plain = checked::certify_method(text_of("rodas3"));
    BOOST_TEST((c.overall() == theory::standing::proved));
    for (const char* name : {"order", "embedded_order", "w_order", "index_1_order"})
        BOOST_TEST(value_of(c, name) == value_of(plain, name), name);
    BOOST_REQUIRE(c.failures.size() == plain.failures.size());
    for (std::size_t k = 0; k < c.failures.size(); ++k)
        BOOST_TEST(c.failures[k].residual == plain.failures[k].residual);
}

BOOST_AUTO_TEST_CASE(a_misprint_is_refuted_and_named) {
    struct misprint {
        const char *file, *right, *wrong, *entry;
    };
    for (const auto& [file, right, wrong, entry] :
         {misprint{"rodas3", "-2/3", "-3/2", "Gamma[4][3]"}, misprint{"ros3p", "\"2/3\"", "\"3/2\"", "b[1]"},
          misprint{"shampine_4_3", "372/25", "327/25", "C[3][1]"},
          misprint{"rodas_4_3", "-20.47028614809616", "-20.47028614890616", "C[4][3]"},
          misprint{"ros34pw2", "0.054180672388095326", "0.054180672388905326", "Gamma[3][2]"}})
        BOOST_TEST_CONTEXT(file) {
            const auto c = checked::certify_method(changed(text_of(file), right, wrong));
            BOOST_TEST(c.exit_code() == 1);
            const auto named = std::find_if(c.suspects.begin(), c.suspects.end(),
                                            [&](const auto& s) { return s.entry == entry; });
            BOOST_TEST((named != c.suspects.end()));
        }
    // Only f_t sees the factor of the second stage.
    const auto time = checked::certify_method(changed(text_of("shampine_4_3"), "-3/2", "-1/2"));
    BOOST_TEST(time.exit_code() == 1);
    BOOST_TEST(time.failures.front().condition == "sum(Gamma[2]) == d[2]");
}

BOOST_AUTO_TEST_CASE(claims_beyond_the_truth_are_refuted) {
    const auto refuted = [](const char* file, const std::string& claim, const char* name) {
        const auto text =
            changed(text_of(file), "\"claims\": {\"order\"", "\"claims\": {" + claim + ", \"order\"");
        return checked::certify_method(text).find(name)->judgement->is_refuted();
    };
    BOOST_TEST(refuted("rodas3", "\"w_order\": 2", "w_order"));
    BOOST_TEST(refuted("ros2", "\"index_1_order\": 3", "index_1_order"));
    BOOST_TEST(refuted("ros3p", "\"stiffly_accurate\": true", "stiffly_accurate"));
}

BOOST_AUTO_TEST_CASE(what_is_wrong_with_a_file_is_said_with_line_and_entry) {
    const auto complaint = [](const std::string& text) {
        return message<tableaux::unusable_input>([&] { tableaux::read_method_text(text); });
    };
    BOOST_TEST(complaint(R"({"form":"rosenbrock","A":[["0"]],"b":["1"]})") == "line 1: Gamma is missing");
    BOOST_TEST(complaint(R"({"form":"rosenbrock","A":[["1"]],"Gamma":[["1"]],"b":["1"]})") ==
               "line 1, A[1][1]: must be 0: one stage follows another");
    BOOST_TEST(complaint(R"({"form":"rosenbrock","a":[["0"]],"C":[["2"]],"gamma":"1","m":["1"]})") ==
               "line 1, C[1][1]: must be 0: one stage follows another");
    BOOST_TEST(
        complaint(
            R"({"form":"rosenbrock","A":[["0"]],"Gamma":[["1"]],"b":["1"],"claims":{"symplectic":true}})") ==
        "line 1, claims.symplectic: is not judged of a Rosenbrock method");
    BOOST_TEST(complaint(R"({"A":[["0"]],"b":["1"],"claims":{"w_order":1}})") ==
               "line 1, claims.w_order: only a method of the form \"rosenbrock\" has one");
}

BOOST_AUTO_TEST_CASE(stability_and_pictures_are_those_of_beta_and_b) {
    const auto file_of = [](const std::string& name) {
        return std::get<tableaux::partitioned_file>(tableaux::read_method_file(folder + name + ".json"));
    };
    // Hairer-Wanner II, table IV.7.2 has 89.3 and 89.5 degrees for the first two.
    const auto sector = [&](const char* name) {
        const auto claims = theory::stability_report(file_of(name)).front().claims;
        return std::find_if(claims.begin(), claims.end(),
                            [](const theory::claim& c) { return c.statement.starts_with("A(alpha)"); })
            ->statement;
    };
    BOOST_TEST(sector("grk4t").starts_with("A(alpha)-stable up to 89.3541"));
    BOOST_TEST(sector("veldhuizen_4_3_d_stable").starts_with("A(alpha)-stable up to 89.49"));
    BOOST_TEST(sector("ros3p") == "A(alpha)-stable up to 90 degrees");
    BOOST_TEST(theory::text(theory::stability_report(file_of("ros2")))
                   .find("embedded method: stability function\n  R(z) = (-1/2*sqrt(2)*z + 1)/") !=
               std::string::npos);

    // RODAS3 at z = -1 by its stages, in doubles, as its file gives them transformed: (1/gamma - z) u = ... (there, IV.7).
    const auto drawn = theory::plot::subject_of_file(file_of("rodas3"));
    const double gamma = 0.5, z = -1;
    const double a[4][4] = {{}, {}, {2}, {2, 0, 1}}, C[4][4] = {{}, {4}, {1, -1}, {1, -1, -8. / 3}},
                 m[4] = {2, 0, 1, 1};
    double u[4], end = 1;
    for (int i = 0; i < 4; ++i) {
        double stage = 1, sum = 0;
        for (int j = 0; j < i; ++j) stage += a[i][j] * u[j], sum += C[i][j] * u[j];
        u[i] = (z * stage + sum) / (1 / gamma - z);
        end += m[i] * u[i];
    }
    BOOST_TEST(drawn.r(z).real() == end, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(message([&] { theory::plot::subject_of_file(file_of("../pairs/ark3")); }) ==
               "form: 'additive', of several tableaux only a Rosenbrock method has one stability function");
}
