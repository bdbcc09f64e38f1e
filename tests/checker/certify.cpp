// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE certify
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/method/tree_table.hpp>
#include <stagecraft/tableaux/entry.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/tableaux/small_solve.hpp>
#include <stagecraft/theory/models/matrix_model.hpp>
#include <stagecraft/theory/trees/tree_text.hpp>

#include "../checked.hpp"

using namespace stagecraft;
using theory::file_certificate;
using theory::standing;

namespace {

const std::filesystem::path source = STAGECRAFT_SOURCE_DIR;

file_certificate misprint(const std::string& name) {
    return checked::certify_file(source / "tests/data/misprints" / (name + ".json"));
}

bool suspected(const file_certificate& c, const std::string& entry, const std::string& suggest) {
    return std::any_of(c.suspects.begin(), c.suspects.end(),
                       [&](const auto& s) { return s.entry == entry && s.suggest == suggest; });
}

bool fails(const file_certificate& c, const std::string& condition, const std::string& residual) {
    return std::any_of(c.failures.begin(), c.failures.end(),
                       [&](const auto& f) { return f.condition == condition && f.residual == residual; });
}

file_certificate judged(const std::string& json) { return checked::certify(json); }

// Kutta's method of order 4 with the entry A[3][2] and the claims left open.
file_certificate rk4(const std::string& entry, const std::string& claims, const std::string& nodes = "") {
    return judged(R"({"A":[["0","0","0","0"],["1/2","0","0","0"],["0",")" + entry +
                  R"(","0","0"],["0","0","1","0"]],"b":["1/6","1/3","1/3","1/6"],)" + nodes + R"("claims":)" +
                  claims + "}");
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_catalogue_file_is_free_of_refuted_claims) {
    int files = 0;
    for (const auto& f : std::filesystem::directory_iterator(source / "tableaux/catalogue")) {
        if (f.path().extension() != ".json") continue;
        ++files;
        const auto c = checked::certify_file(f.path());
        BOOST_TEST(c.exit_code() == 0, f.path().filename() << ": " << to_text(c));
    }
    BOOST_TEST(files >= 60);
}

BOOST_AUTO_TEST_CASE(a_sign_in_dormand_and_princes_embedded_weights_is_found) {
    const auto c = misprint("dormand_prince_embedded_sign");
    BOOST_TEST(c.exit_code() == 1);
    BOOST_TEST(c.find("order")->value.value() == 5);
    BOOST_TEST(c.find("embedded_order")->value.value() == 0);
    BOOST_TEST(c.suspects.size() == 1u);
    BOOST_TEST(suspected(c, "b_embedded[7]", "1/40"));
}

BOOST_AUTO_TEST_CASE(fehlbergs_3554_is_found) {
    const auto c = misprint("fehlberg_3554");
    BOOST_TEST(c.exit_code() == 1);
    BOOST_TEST(c.suspects.size() == 1u);
    BOOST_TEST(suspected(c, "A[6][3]", "-3544/2565"));
    BOOST_TEST(fails(c, "sum(A[6]) == c[6]", "-2/513"));
}

BOOST_AUTO_TEST_CASE(a_misprint_of_1e_8_in_decimals_is_refuted) {
    const auto c = misprint("tsitouras_off_by_1e_8");
    BOOST_TEST(c.exit_code() == 1);
    BOOST_TEST(c.suspects.size() == 1u);
    BOOST_TEST(suspected(c, "A[5][2]", "-11.7488835640628278777471703398"));
}

BOOST_AUTO_TEST_CASE(every_misprint_is_refuted_and_the_wrong_entry_is_named_with_the_right_value) {
    const std::regex form("wrong: (\\S+) = ([^;]*); right: ([^;]*).*");
    int entries = 0, claims = 0;
    for (const auto& f : std::filesystem::directory_iterator(source / "tests/data/misprints")) {
        std::ifstream in(f.path());
        const std::string note = nlohmann::json::parse(in)["note"];
        std::smatch parts;
        BOOST_REQUIRE(std::regex_match(note, parts, form));
        const std::string entry = parts[1];
        const auto c = checked::certify_file(f.path());
        BOOST_TEST(c.exit_code() == 1, f.path());
        if (entry.starts_with("claims.")) {
            ++claims;
            BOOST_TEST(c.find(entry.substr(7))->judgement->is_refuted(), note);
            continue;
        }
        ++entries;
        const auto named = std::find_if(c.suspects.begin(), c.suspects.end(),
                                        [&](const auto& s) { return s.entry == entry; });
        BOOST_REQUIRE_MESSAGE(named != c.suspects.end(), note);
        const auto right = tableaux::read_entry(parts[3].str());
        const auto suggested = tableaux::read_entry(named->suggest);
        BOOST_TEST((right.exact ? suggested.exact == right.exact
                                : right.enclosure.contains(suggested.enclosure.middle())),
                   note << " but suggested " << named->suggest);
    }
    BOOST_TEST(entries >= 14);
    BOOST_TEST(claims >= 5);
}

BOOST_AUTO_TEST_CASE(order_1_labelled_2_is_refuted_and_no_single_entry_repairs_it) {
    const auto c = misprint("kraaijevanger_spijker_labelled_2");
    BOOST_TEST(c.exit_code() == 1);
    BOOST_TEST(c.find("order")->value.value() == 1);
    BOOST_TEST(fails(c, "dot(b, c) == 1/2", "3/2"));
    BOOST_TEST(c.suspects.empty());
    BOOST_TEST(!c.suspects_note.empty());
}

BOOST_AUTO_TEST_CASE(a_zero_of_the_structure_is_suspected_only_where_nothing_else_restores_the_claim) {
    // Explicit Euler labelled 2: only the implicit midpoint rule is near.
    const auto euler = judged(R"({"A":[["0"]],"b":["1"],"claims":{"order":2}})");
    BOOST_TEST(euler.suspects.size() == 1u);
    BOOST_TEST(suspected(euler, "A[1][1]", "1/2"));
    const auto c = judged(R"({"A":[["0","0"],["1/3","0"]],"b":["0","1"],"claims":{"order":2}})");
    BOOST_TEST(c.suspects.size() == 1u);
    BOOST_TEST(suspected(c, "A[2][1]", "1/2"));
    // Two weights, both nodes free: either stage may be moved.
    const auto d = judged(R"({"A":[["1/4","0"],["1/2","1/4"]],"b":["1/2","1/2"],"claims":{"order":2}})");
    BOOST_TEST(d.find("order")->value.value() == 2);
    const auto e = judged(R"({"A":[["1/4","0"],["1/2","1/8"]],"b":["1/2","1/2"],"claims":{"order":2}})");
    BOOST_TEST(e.suspects.size() == 3u);
    BOOST_TEST(suspected(e, "A[1][1]", "3/8"));
}

// Butcher's sixth-order condition that a checker once forgot: all nineteen others hold.
BOOST_AUTO_TEST_CASE(one_failing_condition_of_order_6_is_enough) {
    // 37 stages with independent elementary weight vectors for the 37 trees up to order 6: b can be solved
    // for so that exactly one condition fails, by 1e-9.
    using tableaux::rational;
    constexpr int s = 37;
    tableau<rational> t;
    t.A.resize(s, s);
    t.b.resize(s);
    t.c.resize(s);
    for (int i = 0; i < s; ++i) {
        t.c(i) = 0;
        for (int j = 0; j < s; ++j) {
            t.A(i, j) = j < i ? rational((7 * i * i + 3 * i * j + 11 * j * j + 5) % 13 - 6, 7) : rational(0);
            t.c(i) = t.c(i) + t.A(i, j);
        }
        t.b(i) = 1;
    }
    const theory::matrix_model<rational> model(t);
    const tree_table trees(6);
    std::vector<std::vector<rational>> g;
    tableaux::dense<rational> rows(s, s), right(s, 1);
    for (std::uint32_t k = 0; k < s; ++k) {
        const auto& row = trees.view().rows[k];
        g.push_back(row.order == 1 ? model.one() : model.multiply(g[row.left], model.apply(g[row.right])));
        for (int i = 0; i < s; ++i) rows(static_cast<int>(k), i) = g.back()[static_cast<std::size_t>(i)];
        right(static_cast<int>(k), 0) = rational(1, row.density);
    }
    for (const int broken : {17, 25, 36}) {  // the first, a middle and the last tree of order 6
        auto wrong = right;
        wrong(broken, 0) = right(broken, 0) + rational(1, 1000000007);
        const auto b = tableaux::solve<rational>(rows, wrong);
        BOOST_REQUIRE(b.has_value());
        std::ostringstream json;
        json << "{\"A\":[";
        for (int i = 0; i < s; ++i) {
            json << (i ? ",[" : "[");
            for (int j = 0; j < s; ++j) json << (j ? ",\"" : "\"") << t.A(i, j) << '"';
            json << ']';
        }
        json << "],\"b\":[";
        for (int i = 0; i < s; ++i) json << (i ? ",\"" : "\"") << (*b)(i, 0) << '"';
        json << "],\"claims\":{\"order\":6}}";
        const auto c = judged(json.str());
        BOOST_TEST(c.exit_code() == 1);
        BOOST_TEST(c.find("order")->value.value() == 5);
        BOOST_TEST(c.failures.size() == 1u);
        BOOST_TEST(c.failures[0].tree ==
                   theory::bracket(trees.view().tree(static_cast<std::uint32_t>(broken))));
        BOOST_TEST(c.failures[0].residual == "1/1000000007");
    }
}

BOOST_AUTO_TEST_CASE(quotients_and_decimals_that_are_rounded_are_consistent) {
    const auto quotients = checked::certify_file(source / "tests/data/prince_dormand_quotients.json");
    BOOST_TEST((quotients.overall() == standing::consistent));  // sum b - 1 = -3.7e-18
    BOOST_TEST(quotients.find("order")->value.value() == 8);
    const auto decimal = judged(R"({"A":[["0.2113248654","0.0"],["0.5773502692","0.2113248654"]],
        "b":["0.5","0.5"],"claims":{"order":2}})");
    BOOST_TEST((decimal.overall() == standing::consistent));
    BOOST_TEST(decimal.find("order")->value.value() >= 2);
}

BOOST_AUTO_TEST_CASE(rounded_data_have_the_largest_order_not_refuted) {
    // Gauss-2 to ten digits: order 4 is consistent, 5 is out of reach of two stages.
    const std::string A = R"("A":[["0.2500000000","-0.0386751346"],["0.5386751346","0.2500000000"]],)";
    const std::string b = R"("b":["0.5000000000","0.5000000000"])";
    const auto c = judged("{" + A + b + R"(,"claims":{"order":4}})");
    BOOST_TEST((c.overall() == standing::consistent));
    BOOST_TEST(c.find("order")->value.value() == 4);
    BOOST_TEST(!c.find("order")->judgement->bound().empty());
    // One digit off in the tenth place is more than rounding explains.
    const auto d = judged(R"({"A":[["0.2500000000","-0.0386751356"],["0.5386751346","0.2500000000"]],)" + b +
                          R"(,"claims":{"order":4}})");
    BOOST_TEST((d.overall() == standing::refuted));
    BOOST_TEST(suspected(d, "A[1][2]", "-0.0386751346"));
}

BOOST_AUTO_TEST_CASE(row_sums_count_as_claimed_where_nodes_are_given) {
    BOOST_TEST(rk4("1/2", R"({"order":4})").exit_code() == 0);
    BOOST_TEST(rk4("1/2", R"({"order":4})", R"("c":["0","1/2","1/2","1"],)").exit_code() == 0);
    const auto wrong = rk4("1/2", R"({"order":4})", R"("c":["0","1/2","1/3","1"],)");
    BOOST_TEST(wrong.exit_code() == 1);
    BOOST_TEST(wrong.find("order")->value.value() == 1);  // y' = t^2 sees it
    BOOST_TEST(!wrong.find("order")->numerical);          // exact entries are not rounded
    const auto nodes_alone = judged(R"({"A":[["0","0"],["1/3","0"]],"b":["0","1"],"c":["0","1/2"],
        "claims":{"order":2}})");
    BOOST_TEST(fails(nodes_alone, "dot(b, c) == 1/2 with A*1 for c", "-1/6"));
    BOOST_TEST(wrong.suspects.size() == 1u);
    BOOST_TEST(suspected(wrong, "c[3]", "1/2"));
    // Lobatto IIIB with two stages: C(1) does not hold, and the file says so.
    const auto iiib = [](const std::string& c2, const std::string& claims) {
        return judged(R"({"A":[["1/2","0"],["1/2","0"]],"b":["1/2","1/2"],"c":["0",")" + c2 +
                      R"("],"claims":{)" + claims + "}}");
    };
    BOOST_TEST(iiib("1", R"("order":2,"stage_order":0)").exit_code() == 0);
    // Nor does it refute anything where the file says nothing of it: the order is 2 with these nodes.
    const auto other_nodes = iiib("1", R"("order":2)");
    BOOST_TEST(other_nodes.exit_code() == 0);
    BOOST_TEST(other_nodes.find("row_sums")->truth->is_refuted());
    BOOST_REQUIRE(other_nodes.notes.size() == 1u);
    BOOST_TEST(other_nodes.notes[0].starts_with("c is not A*1"));
    const auto moved = iiib("1001/1000", R"("order":2,"stage_order":0)");
    BOOST_TEST(moved.exit_code() == 1);
    BOOST_TEST(suspected(moved, "c[2]", "1"));
}

BOOST_AUTO_TEST_CASE(claims_of_properties_are_judged_both_ways) {
    const std::string midpoint = R"({"A":[["1/2"]],"b":["1"],"claims":)";
    for (const auto* yes : {"A_stable", "algebraically_stable", "symplectic", "symmetric"}) {
        BOOST_TEST((judged(midpoint + "{\"" + yes + "\":true}}").overall() == standing::proved));
        BOOST_TEST((judged(midpoint + "{\"" + yes + "\":false}}").overall() == standing::refuted));
    }
    for (const auto* no : {"L_stable", "stiffly_accurate"}) {
        BOOST_TEST((judged(midpoint + "{\"" + no + "\":true}}").overall() == standing::refuted));
        BOOST_TEST((judged(midpoint + "{\"" + no + "\":false}}").overall() == standing::proved));
    }
    BOOST_TEST(judged(midpoint + R"({"stage_order":1}})").exit_code() == 0);
    BOOST_TEST(judged(midpoint + R"({"stage_order":2}})").exit_code() == 1);
}

BOOST_AUTO_TEST_CASE(weights_that_are_all_zero_are_judged_too) {
    const auto c = judged(R"({"A":[["1/2"]],"b":["0"],"claims":{"order":1,"symmetric":true}})");
    BOOST_TEST(c.find("order")->value.value() == 0);
    BOOST_TEST(c.find("symmetric")->judgement->is_proved());  // y_1 = y_0
    BOOST_TEST(suspected(c, "b[1]", "1"));
}

// Nobody claims an order here, so that a row of zeros, turned, would leave everything as it should be.
BOOST_AUTO_TEST_CASE(weights_that_do_not_sum_to_1_are_mended_without_a_claim) {
    const auto merson = [](const std::string& last, const std::string& embedded) {
        return judged(R"({"A":[["0","0","0"],["1/3","0","0"],["1/6","1/6","0"]],"c":["0","1/3","1/3"],
            "b":["1/6","2/3",")" +
                      last + R"("],"b_embedded":["1/2",")" + embedded + R"(","0"]})");
    };
    const auto c = merson("1/5", "1/2");
    BOOST_TEST(c.exit_code() == 1);
    BOOST_TEST(suspected(c, "b[3]", "1/6"));
    BOOST_TEST(c.suspects_note.find("undone") == std::string::npos);
    const auto e = merson("1/6", "1/3");
    BOOST_TEST(e.exit_code() == 1);
    BOOST_TEST(suspected(e, "b_embedded[2]", "1/2"));
}

BOOST_AUTO_TEST_CASE(two_surds_are_proved_and_three_are_enclosed_refuted_or_consistent) {
    // SDIRK with gamma = 1 - sqrt(2)/2 and idle stages with other surds.
    const auto file = [](const std::string& weight, const std::string& third) {
        return judged(R"x({"A":[["1-sqrt(2)/2","0","0"],["sqrt(2)/2","1-sqrt(2)/2","0"],["sqrt(7)",")x" +
                      third + R"x(","0"]],"b":[")x" + weight +
                      R"x(","1-sqrt(2)/2","0"],"claims":{"order":2,"L_stable":true}})x");
    };
    BOOST_TEST((file("sqrt(2)/2", "0").overall() == standing::proved));
    const auto wrong = file("sqrt(2)/2+10^-60", "0");
    BOOST_TEST((wrong.overall() == standing::refuted));
    BOOST_TEST(wrong.data == "exact, quadratic surds");
    BOOST_TEST(suspected(wrong, "b[1]", "1/2*sqrt(2)"));
    BOOST_TEST((file("sqrt(2)/2", "sqrt(3)").overall() == standing::consistent));
    const auto enclosed = file("sqrt(2)/2+10^-60", "sqrt(3)");
    BOOST_TEST((enclosed.overall() == standing::refuted));
    BOOST_TEST(enclosed.data == "exact, enclosed");
}

BOOST_AUTO_TEST_CASE(a_method_over_two_surds_that_meet_is_decided) {
    // Half a step of Gauss-2 (sqrt 3) and half a step of Kutta's family of order 4 with w = sqrt(7)/6
    // (Hairer-Norsett-Wanner I.II.1): order 4, and Q(sqrt 3, sqrt 7) is needed to see it.
    const auto composed = [](const std::string& entry, int order) {
        return judged(
            R"x({"A":[["1/8","1/8-sqrt(3)/12","0","0","0","0"],[")x" + entry +
            R"x(","1/8","0","0","0","0"],["1/4","1/4","0","0","0","0"],["1/4","1/4","1/4","0","0","0"],
            ["1/4","1/4","1/4-1/(2*sqrt(7))","1/(2*sqrt(7))","0","0"],
            ["1/4","1/4","0","1/2-sqrt(7)/4","sqrt(7)/4","0"]],
            "b":["1/4","1/4","1/12","1/3-sqrt(7)/12","sqrt(7)/12","1/12"],"claims":{"order":)x" +
            std::to_string(order) + "}}");
    };
    const auto good = composed("1/8+sqrt(3)/12", 4);
    BOOST_TEST(good.find("order")->judgement->is_proved());
    BOOST_TEST(
        good.find("A_stable")->truth->is_refuted());  // R(z) is that of Gauss-2 times a polynomial, at z/2
    BOOST_TEST(composed("1/8+sqrt(3)/12", 5).exit_code() == 1);
    BOOST_TEST(composed("1/8+sqrt(3)/12+10^-200", 4).exit_code() == 1);
    BOOST_TEST(suspected(composed("1/8-sqrt(3)/12", 4), "A[2][1]", "1/8+1/12*sqrt(3)"));
}

BOOST_AUTO_TEST_CASE(a_lone_wrong_surd_or_decimal_is_repaired_exactly) {
    const auto gauss = [](const std::string& entry) {
        return judged(
            R"({"A":[["1/4","1/4-sqrt(3)/6"],[")" + entry +
            R"(","1/4"]],"b":["1/2","1/2"],"c":["1/2-sqrt(3)/6","1/2+sqrt(3)/6"],"claims":{"order":4}})");
    };
    BOOST_TEST(gauss("1/4+sqrt(3)/6").exit_code() == 0);
    for (const auto* wrong : {"1/4+sqrt(2)/6", "0.5397", "1/4-sqrt(3)/6"})
        BOOST_TEST(suspected(gauss(wrong), "A[2][1]", "1/4+1/6*sqrt(3)"));
    const auto rational = rk4("0.51", R"({"order":4})", R"("c":["0","1/2","1/2","1"],)");
    BOOST_TEST(suspected(rational, "A[3][2]", "1/2"));
}

BOOST_AUTO_TEST_CASE(enormous_fractions_are_judged_by_enclosures_where_exact_stability_would_take_seconds) {
    const auto c = judged(
        R"({"A":[["1/2+10^-400"]],"b":["1"],"claims":{"order":1,"A_stable":true,"symplectic":false}})");
    BOOST_TEST(c.find("order")->judgement->is_proved());
    BOOST_TEST(c.find("symplectic")->truth->is_refuted());  // still exact: M = 2e-400
    BOOST_TEST(c.find("A_stable")->truth->is_consistent());
    BOOST_TEST(judged(R"({"A":[["1/2"]],"b":["1"],"claims":{"A_stable":true}})")
                   .find("A_stable")
                   ->truth->is_proved());
}

BOOST_AUTO_TEST_CASE(rounded_data_name_the_family_they_come_from) {
    const auto radau = radau_iia<3>();
    nlohmann::json file{{"claims", {{"order", 5}, {"stage_order", 3}, {"L_stable", true}}}};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) file["A"][i][j] = radau.A(i, j);
        file["b"][i] = radau.b(i);
        file["c"][i] = radau.c(i);
    }
    file["c"][2] = 1;
    const auto c = judged(file.dump());
    BOOST_TEST((c.overall() == standing::consistent));
    BOOST_REQUIRE(c.nearest.has_value());
    BOOST_TEST(c.nearest->family == "radau_iia");
    BOOST_TEST(c.nearest->stages == 3);
    BOOST_TEST(std::stod(c.nearest->error) <= 0.5);
    file["A"][0][1] = radau.A(0, 1) * (1 + 8 * std::numeric_limits<double>::epsilon());
    const auto wrong = judged(file.dump());
    BOOST_TEST(wrong.nearest->entry == "A[1][2]");
    BOOST_TEST(std::stod(wrong.nearest->error) > 7);
    BOOST_TEST(std::stod(wrong.nearest->error) < 17);
    BOOST_TEST(!misprint("tsitouras_off_by_1e_8").nearest.has_value());  // explicit: in no family
    BOOST_TEST(!rk4("1/2", "{}").nearest.has_value());                   // exact data need no neighbour
}

BOOST_AUTO_TEST_CASE(levels_are_found_and_claims_on_them_judged) {
    const auto value = [](const file_certificate& c, const char* name) {
        const auto* f = c.find(name);
        BOOST_REQUIRE(f);
        return f->value.value();
    };
    const auto radau = checked::certify_file(source / "tableaux/catalogue/radau_iia_3.json");
    BOOST_TEST(value(radau, "B") == 5);
    BOOST_TEST(value(radau, "C") == 3);
    BOOST_TEST(value(radau, "D") == 2);
    BOOST_TEST(value(radau, "linear_order") == 5);
    BOOST_TEST(value(radau, "weak_stage_order") == 3);
    // Butcher 1969: five explicit stages have the effective order 5, though 4 is the order.
    const std::string effective =
        R"({"A":[[0,0,0,0,0],["1/5",0,0,0,0],[0,"2/5",0,0,0],["3/16",0,"5/16",0,0],["1/4",0,"-5/4",2,0]],
            "b":["1/6",0,0,"2/3","1/6"],"claims":{"order":4,"effective_order":)";
    const auto five = judged(effective + "5}}");
    BOOST_TEST((five.overall() == standing::proved), to_text(five));
    BOOST_TEST(judged(effective + "6}}").exit_code() == 1);
    BOOST_TEST(value(rk4("1/2", "{}"), "effective_order") == 4);
    // HBVM(k, 1), A = c b^T with the nodes and weights of Gauss: order 2, energy of order 2k (Brugnano-Iavernaro-Trigiante 2010).
    const auto hbvm =
        judged(R"x({"A":[["(3-sqrt(3))/12","(3-sqrt(3))/12"],["(3+sqrt(3))/12","(3+sqrt(3))/12"]],
                                   "b":["1/2","1/2"],"claims":{"order":2,"energy_order":4}})x");
    BOOST_TEST((hbvm.overall() == standing::proved), to_text(hbvm));
    BOOST_TEST(value(hbvm, "order") == 2);
    BOOST_TEST(value(hbvm, "energy_order") == 4);
    BOOST_TEST(value(rk4("1/2", "{}"), "energy_order") == 4);
    // Ketcheson, Seibold, Shirokoff and Zhou 2020: order 3 and weak stage order 3 of stages of order 1, to 11 digits.
    const std::string weak =
        R"({"A":[["0.13756543551",0,0,0],["0.56695122794","0.23483888782",0,0],["-1.08354072813","2.96618223864",
            "0.44915521951",0],["0.59761291500","-0.43420997584","-0.05305815322","0.88965521406"]],"b":["0.59761291500",
            "-0.43420997584","-0.05305815322","0.88965521406"],"claims":{"order":3,"stage_order":1,"weak_stage_order":)";
    BOOST_TEST((judged(weak + "3}}").overall() == standing::consistent), to_text(judged(weak + "3}}")));
    BOOST_TEST(judged(weak + "4}}").exit_code() == 1);
    // A misprint that the order does not see.
    const auto linear = judged(R"({"A":[[0,0],["1/2",0]],"b":[0,1],"claims":{"linear_order":3}})");
    BOOST_TEST(linear.find("linear_order")->judgement->text() == "refuted: 3! b^T A^2 1 = 1 leaves -1");
}

BOOST_AUTO_TEST_CASE(claimed_numbers_are_compared_to_their_digits) {
    const auto verdict = [](const std::string& claims) {
        const auto c = rk4("1/2", claims);
        return std::string(name(c.overall()));
    };
    BOOST_TEST(verdict(R"({"imaginary_interval":"2.828"})") == "proved");
    BOOST_TEST(verdict(R"({"imaginary_interval":"2.83"})") == "proved");  // 2.8284 rounded up
    BOOST_TEST(verdict(R"x({"imaginary_interval":"2*sqrt(2)"})x") == "consistent");
    BOOST_TEST(verdict(R"({"imaginary_interval":"2.85"})") == "refuted");
    BOOST_TEST(verdict(R"({"real_interval":"2.785","ssp_coefficient":1,"alpha":0})") == "refuted");  // SSP: 0
    BOOST_TEST(verdict(R"({"real_interval":2.785,"ssp_coefficient":0,"alpha":0})") == "proved");
    BOOST_TEST(verdict(R"({"real_interval":"infinite"})") == "refuted");
    const auto all = [](const std::string& claims) {
        return judged(R"({"A":[["0.2928932188134524756"]],"b":[1],"claims":)" + claims + "}");
    };
    // y_1 = y_0 + h f(y_0 + gamma h f_1): R(infinity) = 1 - 1/gamma, of 19 digits
    BOOST_TEST((all(R"({"alpha":0})").overall() == standing::proved));
    BOOST_TEST(judged(R"({"A":[["1/2"]],"b":[1],"claims":{"alpha":90,"real_interval":"infinite",
                          "imaginary_interval":"infinite","ssp_coefficient":2}})")
                   .exit_code() == 0);
}

BOOST_AUTO_TEST_CASE(the_command_gives_0_1_or_2) {
    std::string out, err;
    const std::string good = R"({"A":[["1/2"]],"b":["1"],"claims":{"order":2}})";
    const std::string bad = R"({"A":[["1/2"]],"b":["1"],"claims":{"order":3}})";
    BOOST_TEST(checked::exit_code(good, true, out, err) == 0);
    const auto json = nlohmann::json::parse(out);
    BOOST_TEST(json["order"]["value"] == 2);
    BOOST_TEST(json["order"]["claim"] == "proved");
    BOOST_TEST(json["suspects"].empty());
    BOOST_TEST(checked::exit_code(bad, true, out, err) == 1);
    const auto refuted = nlohmann::json::parse(out);
    BOOST_TEST(refuted["failures"][0]["tree"] == "[[tau]]");
    BOOST_TEST(refuted["failures"][0]["condition"] == "dot(b, A*c) == 1/6");
    BOOST_TEST(refuted["failures"][0]["residual"] == "1/12");
    BOOST_TEST(err.empty());
    BOOST_TEST(checked::exit_code("{", false, out, err) == 2);
    BOOST_TEST(err == "line 1: not JSON: the text ends too early\n");
}
