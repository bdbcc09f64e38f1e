// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE read
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/tableaux/reading.hpp>
#include <stagecraft/theory/judging/resolution.hpp>
#include <string>
#include <utility>

#include "../checked.hpp"

using namespace stagecraft::tableaux;

namespace {
std::string complaint(std::string_view text) {
    try {
        read_tableau(text);
    } catch (const unusable_input& e) {
        BOOST_TEST(std::string_view(e.what()).find('\n') == std::string_view::npos);
        return e.what();
    }
    return "none";
}

std::string begins(const std::string& message, std::size_t length) { return message.substr(0, length); }
}  // namespace

BOOST_AUTO_TEST_CASE(a_file_becomes_an_exact_tableau) {
    const auto file = read_tableau(R"({"name": "Gauss 2", "source": "Kuntzmann",
        "A": [["1/4", "1/4-sqrt(3)/6"], ["1/4+sqrt(3)/6", "1/4"]], "b": ["1/2", "1/2"],
        "claims": {"order": 4, "A_stable": true}})");
    BOOST_TEST(file.name == "Gauss 2");
    BOOST_TEST((file.kind() == number_kind::quadratic));
    BOOST_TEST(file.claims.order.value() == 4);
    BOOST_TEST(file.claims.a_stable.value());
    BOOST_TEST(!file.claims.l_stable.has_value());
    const auto t = to_quadratic(file);
    BOOST_TEST(t.c(0).str() == "1/2-1/6*sqrt(3)");  // row sums stand in for c
    BOOST_CHECK_THROW(to_rational(file), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_kind_is_that_of_the_least_exact_entry) {
    const auto kind = [](const std::string& a, const std::string& b) {
        return read_tableau(R"({"A":[[")" + a + R"("]],"b":[)" + b + "]}").kind();
    };
    BOOST_TEST((kind("1/2", "1") == number_kind::rational));
    BOOST_TEST((kind("sqrt(2)", "\"sqrt(8)\"") == number_kind::quadratic));
    BOOST_TEST((kind("sqrt(2)", "\"sqrt(3)\"") == number_kind::quadratic));
    BOOST_TEST((kind("sqrt(2)+sqrt(3)", "\"sqrt(6)\"") == number_kind::quadratic));
    BOOST_TEST((kind("sqrt(2)+sqrt(3)", "\"sqrt(5)\"") == number_kind::enclosed));
    // Two radicands whose product is too large for arithmetic in their field.
    BOOST_TEST((kind("sqrt(281474976710597)", "\"sqrt(3)\"") == number_kind::enclosed));
    BOOST_TEST((kind("sqrt(2)", "0.707106781186548") == number_kind::rounded));
    BOOST_TEST((kind("sqrt(2)+sqrt(3)", "\"1.00000000001\"") == number_kind::rounded));
    BOOST_TEST((kind("sqrt(2)", "0.5") == number_kind::quadratic));  // alone, so short a decimal is exact
}

BOOST_AUTO_TEST_CASE(json_numbers_are_integers_or_doubles) {
    const auto file = read_tableau(R"({"A":[[0.3333333333333333]],"b":[1],"c":[-0.5]})");
    BOOST_TEST(file.A[0][0].rounded);
    BOOST_TEST(file.b[0].exact.value() == 1);
    BOOST_TEST(file.c[0].enclosure.middle() == rational(-1, 2));
}

BOOST_AUTO_TEST_CASE(unusable_input_names_line_and_entry) {
    const std::string head =
        "{\n \"A\": [\n  [\"0\", \"0\"],\n  [\"1/2\", \"x\"]\n ],\n \"b\": [\"0\",\n  \"1\"]}";
    BOOST_TEST(complaint(head) == "line 4, A[2][2]: 'x' unknown symbol 'x'");
    const auto with = [](const std::string& a, const std::string& rest) {
        return complaint("{\"A\":[[" + a + "]],\n\"b\":[\"1\"]" + rest + "}");
    };
    BOOST_TEST(with("\"1/0\"", "") == "line 1, A[1][1]: '1/0' division by zero");
    BOOST_TEST(with("\"sqrt(-1)\"", "") == "line 1, A[1][1]: 'sqrt(-1)' square root of a negative number");
    BOOST_TEST(with("\"1\"", ",\n\"c\":[\"1\",\"2\"]") == "line 3, c: has 2 entries, b has 1");
    BOOST_TEST(with("\"1\"", ",\n\n\"c\":[\"nan\"]") == "line 4, c[1]: 'nan' unknown symbol 'nan'");
    BOOST_TEST(with("\"1\",\"2\"", "") == "line 1, A[1]: has 2 entries, b has 1");
    BOOST_TEST(with("true", "") == "line 1, A[1][1]: must be a number written as a string");
    BOOST_TEST(with("1e999", "") == "line 1: non-finite number");
    BOOST_TEST(with("1", ",\"claims\":{\"ordre\":1}") ==
               "line 2, claims.'ordre': unknown claim; known are order, embedded_order, stage_order, "
               "dense_order, dense_smoothness, w_order, index_1_order, B, C, D, linear_order, "
               "weak_stage_order, effective_order, energy_order, A_stable, L_stable, algebraically_stable, "
               "symplectic, symmetric, stiffly_accurate, ssp_coefficient, alpha, real_interval, "
               "imaginary_interval");
    BOOST_TEST(with("1", ",\n\"claims\":{\"order\":1000}") ==
               "line 3, claims.'order': must be an integer from 0 to 128");
    BOOST_TEST(with("1", ",\"claims\":{\"order\":\"2\"}") ==
               "line 2, claims.'order': must be an integer from 0 to 128");
    BOOST_TEST(with("1", ",\"claims\":{\"A_stable\":1}") ==
               "line 2, claims.'A_stable': must be true or false");
    BOOST_TEST(with("1", ",\"claims\":{\"embedded_order\":1}") ==
               "line 2, claims.embedded_order: there is no b_embedded");
    BOOST_TEST(with("1", ",\"b\":[\"2\"]") == "line 2: key 'b' appears twice");
    BOOST_TEST(with("1", ",\"b_embeded\":[\"2\"]") == "line 2, 'b_embeded': unknown key");
    BOOST_TEST(complaint("{\"b\":[\"1\"]}") == "line 1: A is missing");
    BOOST_TEST(complaint("{\"A\":[],\n\"b\":[]}") == "line 2, b: is empty");
    BOOST_TEST(complaint("[1]") == "line 1: a tableau must be a JSON object");
    BOOST_TEST(begins(complaint("{\n\n\"A\": oops}"), 16) == "line 3: not JSON");
    BOOST_TEST(complaint("{\n\"A\": [") == "line 2: not JSON: the text ends too early");
    BOOST_TEST(complaint("") == "line 1: the text is empty");
    BOOST_TEST(complaint("{} trailing\n\n") == "line 1: not JSON: unexpected 'trailing'");
    BOOST_TEST(begins(complaint("{\"A\":\"\xff\"}"), 16) == "line 1: not JSON");
    BOOST_TEST(begins(complaint(std::string(1000000, '[')), 16) == "line 1: not JSON");
    BOOST_CHECK_THROW(read_tableau_file("/no/such/file.json"), unusable_input);
}

BOOST_AUTO_TEST_CASE(quotients_are_judged_as_what_they_round_and_every_change_beyond_the_resolution_shows) {
    // gamma = 1 - 1/sqrt(2), L-stable of order 2, as Kennedy and Carpenter print such numbers.
    const std::string gamma = "1513744654945/5168247530883", other = "3654502875938/5168247530883";
    const std::string text = R"({"A":[[")" + gamma + R"(","0"],[")" + other + R"(",")" + gamma +
                             R"("]],"b":[")" + other + R"(",")" + gamma + R"("],"c":[")" + gamma +
                             R"(","1"],"claims":{"order":2,"L_stable":true}})";
    const auto c = checked::certify(text);
    BOOST_TEST(c.exit_code() == 0);
    BOOST_TEST(c.verdict_in_words() == "consistent up to 1.87e-26 (quotients of 13 digits)");
    const auto file = rounded_quotients(read_tableau(text));
    const auto r = stagecraft::theory::resolution_of(file);
    BOOST_REQUIRE(c.taken_as);
    BOOST_TEST(c.taken_as->resolution == r.size);
    BOOST_TEST(r.unseen.empty());
    const rational size = read_entry(r.size).enclosure.upper;
    BOOST_TEST((size < rational(1) / rational(pow(integer(10), 24))));  // a change of 1 in p makes 2e-13
    int hidden = 0;
    for (const auto& [part, change] : {std::pair('A', size), std::pair('A', -size), std::pair('b', size),
                                       std::pair('b', -size), std::pair('c', size)}) {
        auto moved = file;
        const auto shift = [&, part = part](const rational& x) {
            auto& e = part == 'A' ? moved.A[1][1] : part == 'b' ? moved.b[0] : moved.c[0];
            e.enclosure = {e.enclosure.lower + x, e.enclosure.upper + x};
        };
        shift(change);
        BOOST_TEST(stagecraft::theory::certify(moved).exit_code() == 1);
        shift(change * rational(-15, 16));
        hidden += stagecraft::theory::certify(moved).exit_code() == 0 ? 1 : 0;
    }
    BOOST_TEST(hidden > 0);
    // Where the estimate alone is in quotients, what is exact stays proved.
    const auto surds = checked::certify(R"({"A":[["1-sqrt(2)/2","0"],["sqrt(2)/2","1-sqrt(2)/2"]],
        "b":["sqrt(2)/2","1-sqrt(2)/2"],"b_embedded":[")" +
                                        other + R"(",")" + gamma +
                                        R"("],"claims":{"order":2,"embedded_order":2,"L_stable":true}})");
    BOOST_TEST(surds.exit_code() == 0);
    BOOST_TEST(surds.find("order")->judgement->is_proved());
    BOOST_TEST(surds.find("L_stable")->judgement->is_proved());
    const auto estimate = surds.find("embedded_order")->judgement->standing();
    BOOST_TEST((estimate == stagecraft::theory::standing::consistent));
    // Short fractions beside them say nothing of how the others are meant: Gauss 2 has four of eight, and with a digit lost in q it
    // is refuted and that entry named.
    std::string gauss = R"({"c":["1104728155436/5227629760075","4122901604639/5227629760075"],"A":[["1/4",
        "-266267549736/6884721993229"],["1923359782890/3570537526921","1/4"]],"b":["1/2","1/2"],"claims":{"order":4}})";
    BOOST_TEST(checked::certify(gauss).verdict_in_words() ==
               "consistent up to 1.44e-26 (quotients of 13 digits)");
    const auto misprinted = checked::certify(gauss.erase(gauss.find("3570537526921") + 3, 1));
    BOOST_TEST(misprinted.exit_code() == 1);
    BOOST_REQUIRE(!misprinted.suspects.empty());
    BOOST_TEST(misprinted.suspects.front().entry == "A[2][1]");
    auto misprint = nlohmann::json::parse(text);
    misprint["A"][1][0] = "3654502875983/5168247530883";
    const auto found = checked::certify(misprint.dump());
    BOOST_TEST(found.exit_code() == 1);
    BOOST_REQUIRE(!found.suspects.empty());
    BOOST_TEST(found.suspects.front().entry == "A[2][1]");
    BOOST_TEST(found.suspects.front().suggest == other);
}

BOOST_AUTO_TEST_CASE(digits_that_a_table_has_too_many_of_for_doubles_are_held_to_half_a_unit) {
    // 30 digits are no computed doubles: the sum of a row that is off by two of its last digit is refuted as before.
    auto t =
        nlohmann::json::parse(text_of_file(STAGECRAFT_SOURCE_DIR "/tableaux/catalogue/kvaerno_3_2.json"));
    BOOST_TEST(checked::certify(t.dump()).exit_code() == 0);
    BOOST_REQUIRE(t["c"][1] == "0.871733043016917998832038902387");
    t["c"][1] = "0.871733043016917998832038902386";
    BOOST_TEST(checked::certify(t.dump()).exit_code() == 1);
    BOOST_TEST(!checked::certify(t.dump()).taken_as.has_value());
}
