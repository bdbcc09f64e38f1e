// SPDX-License-Identifier: BSL-1.0
// From digits to theorems: against families that are constructed exactly, a root of a polynomial, and misprints.
#define BOOST_TEST_MODULE existence
#include <stagecraft/theory/existence/existence.hpp>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/tableaux/correct_rounding.hpp>
#include <stagecraft/tableaux/decimals.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/theory/judging/certify_partitioned.hpp>
#include <string>
#include <vector>

using namespace stagecraft;
using namespace stagecraft::theory;

namespace {
const std::string folder = STAGECRAFT_SOURCE_DIR "/tableaux/";

existence_certificate of(const std::string& file, int digits = 60) {
    return certify_existence(tableaux::read_method_file(folder + file), digits);
}

tableaux::rational value(const nlohmann::ordered_json& text) {
    return tableaux::read_entry(text.get<std::string>(), tableaux::exact_decimals::all())
        .exact->rational_part();
}

/// Two numbers with the same digits, or the same fraction.
bool same(const nlohmann::ordered_json& x, const std::string& y) {
    if (x == y) return true;
    const auto fraction = tableaux::read_entry(x.get<std::string>());  // where the file has one, b_4 = 1/16
    return fraction.exact && tableaux::decimal_text(fraction.exact->rational_part(), 20) == y.substr(0, 22);
}

/// The same file with one digit of an entry of A or b another one; "" where the entry is short.
std::string with_another_digit(nlohmann::ordered_json file, const std::string& part, std::size_t row,
                               std::size_t column, std::size_t digit) {
    auto& entry = part == "A" ? file[part][row][column] : file[part][row];
    auto text = entry.get<std::string>();
    const auto point = text.find('.');
    if (point == std::string::npos || text.size() < point + 12) return "";
    char& ch = text[point + digit];
    ch = ch == '7' ? '2' : '7';
    entry = text;
    return file.dump();
}
}  // namespace

BOOST_AUTO_TEST_CASE(polished_tables_are_those_that_the_nodes_give) {
    // Gauss and Radau IIA are constructed from the roots of Legendre polynomials, to any number of digits.
    struct one {
        const char* file;
        tableaux::family family;
        int stages, order, digits;
    };
    for (const one& m : {one{"catalogue/gauss_4.json", tableaux::family::gauss, 4, 8, 60},
                         one{"catalogue/radau_iia_4.json", tableaux::family::radau_iia, 4, 7, 60},
                         one{"catalogue/radau_iia_5.json", tableaux::family::radau_iia, 5, 9, 60},
                         one{"catalogue/radau_iia_4.json", tableaux::family::radau_iia, 4, 7, 1000}}) {
        const auto c = of(m.file, m.digits);
        BOOST_TEST_REQUIRE(c.exit_code() == 0, m.file);
        BOOST_TEST(c.order == m.order);
        BOOST_TEST(c.theorem.find("order exactly " + std::to_string(m.order)) != std::string::npos);
        const auto truth = tableaux::decimals(m.family, m.stages, m.digits);
        const auto s = static_cast<std::size_t>(m.stages);
        for (std::size_t i = 0; i < s; ++i) {
            BOOST_TEST(same(c.polished["b"][i], truth.b[i]), m.file << " b " << i);
            for (std::size_t j = 0; j < s; ++j)
                BOOST_TEST(same(c.polished["A"][i][j], truth.A[i][j]), m.file << i << " " << j);
        }
    }
}

BOOST_AUTO_TEST_CASE(the_diagonal_of_alexanders_method_of_order_three_is_the_root_of_its_cubic) {
    const auto c = of(
        "catalogue/alexander_3.json");  // R. Alexander, SIAM J. Numer. Anal. 14 (1977): order and b = last row
    BOOST_TEST_REQUIRE(c.exit_code() == 0);
    const auto g = value(c.polished["A"][0][0]);
    const tableaux::rational left = 6 * g * g * g - 18 * g * g + 9 * g - 1;
    BOOST_TEST(std::abs(left.to<double>()) < 1e-58);
    BOOST_TEST((value(c.polished["A"][1][1]) == g && value(c.polished["b"][2]) == g));
}

BOOST_AUTO_TEST_CASE(pairs_of_kennedy_and_carpenter_exist_with_their_coupling_and_embedded_conditions) {
    struct one {
        const char* file;
        int order, embedded;
    };
    for (const one& m :
         {one{"pairs/ark3.json", 3, 2}, one{"pairs/ark4.json", 4, 3}, one{"pairs/ark5.json", 5, 4},
          one{"pairs/ark4_2019.json", 4, 3}, one{"catalogue/kennedy_carpenter_esdirk_5_4.json", 5, 4},
          one{"catalogue/kennedy_carpenter_esdirk_4_3_seven_stages.json", 4, 3}}) {
        const auto c = of(m.file);
        BOOST_TEST(c.exit_code() == 0, m.file);
        BOOST_TEST(c.order == m.order, m.file);
        BOOST_TEST(c.embedded_order.value_or(0) == m.embedded, m.file);
        BOOST_TEST(std::stold(c.distance) < 1e-18L, m.file);
        // What is written reads again, and there the conditions hold to as many digits.
        const auto again = certify(tableaux::read_method_text(c.polished.dump()));
        BOOST_TEST(again.exit_code() == 0, m.file);
        BOOST_TEST(std::stold(again.find("order")->judgement->residual()) < 1e-57L, m.file);
    }
}

BOOST_AUTO_TEST_CASE(explicit_pairs_of_high_order_exist) {
    for (const auto& [file, order, embedded] : {std::tuple("catalogue/verner_6_5_efficient.json", 6, 5),
                                                std::tuple("catalogue/tsitouras_5_4.json", 5, 4),
                                                std::tuple("catalogue/calvo_montijano_randez_6_5.json", 6, 5),
                                                std::tuple("catalogue/dormand_prince_8_5_3.json", 8, 5)}) {
        const auto c = of(file);
        BOOST_TEST(c.exit_code() == 0, file);
        BOOST_TEST(c.order == order, file);
        BOOST_TEST(c.embedded_order.value_or(0) == embedded, file);
        BOOST_TEST(c.theorem.find("order exactly " + std::to_string(order)) != std::string::npos, file);
    }
}

BOOST_AUTO_TEST_CASE(what_is_not_proved_is_not_said_to_be) {
    const auto c =
        of("catalogue/prince_dormand_8_7.json");  // of b_embedded three conditions are enclosed only
    BOOST_TEST(c.exit_code() == 3);
    BOOST_TEST(c.polished.is_null());
    BOOST_TEST(to_text(c).find("\n  proved: ") == std::string::npos);
    BOOST_TEST(to_json(c)["verdict"] == "inconclusive");
}

// With the weights as they are written there is no real method of order 3: b_1 < 1/4 and b_2 = b_3 ask for a negative
// square of c_3 - c_2. A fraction does not move by what the decimals beside it leave open.
BOOST_AUTO_TEST_CASE(a_fraction_moves_no_farther_than_its_own_digits) {
    for (const char* zero : {"0", "0.000000"}) {
        const auto text = std::string(R"({"A":[["0","0","0"],["0.666667","0","0"],[")") + zero +
                          R"(","0.6666670","0"]],"b":["625001/2500000","1874999/5000000","1874999/5000000"],
                          "claims":{"order":3}})";
        const auto c = certify_existence(tableaux::read_method_text(text), 60);
        BOOST_TEST(c.exit_code() == 3, c.theorem);
        BOOST_TEST(to_text(c).find("proved: ") == std::string::npos);
    }
}

BOOST_AUTO_TEST_CASE(tables_with_a_misprint_are_refused) {
    int refused = 0;
    for (const char* name : {"kvaerno_5_4", "kennedy_carpenter_ark4_explicit", "tsitouras_5_4"}) {
        const std::string path = folder + "catalogue/" + name + ".json";
        const auto json = nlohmann::ordered_json::parse(tableaux::text_of_file(path));
        const auto s = json["b"].size();
        for (std::size_t i = 0; i < s; ++i)
            for (const std::size_t digit : {3U, 10U})
                for (std::size_t j = 0; j <= i; ++j) {
                    const auto text = j == i ? with_another_digit(json, "b", i, 0, digit)
                                             : with_another_digit(json, "A", i, j, digit);
                    if (text.empty()) continue;
                    const auto c = certify_existence(tableaux::read_method_text(text));
                    BOOST_TEST(c.exit_code() == 1, name << " " << i + 1 << "," << j + 1);
                    BOOST_TEST(c.polished.is_null());
                    ++refused;
                }
    }
    BOOST_TEST(refused > 60);
}

BOOST_AUTO_TEST_CASE(exact_tables_and_surds_are_theorems_as_they_stand) {
    for (const char* file :
         {"catalogue/dormand_prince_5_4.json", "catalogue/crouzeix_3.json", "pairs/ars_2_2_2.json"}) {
        const auto c = of(file);
        BOOST_TEST(c.exit_code() == 0, file);
        BOOST_TEST(c.theorem.find(": these entries") != std::string::npos, file);
    }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_looked_at_is_refused_by_name) {
    BOOST_CHECK_THROW(of("pairs/nystrom_4.json"), tableaux::unusable_input);
    BOOST_CHECK_THROW(of("catalogue/kvaerno_3_2.json", 4), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(entries_of_too_few_digits_are_said_to_be_such) {
    // The explicit midpoint rule for c2 = 1/3 to four digits, without c.
    const auto few = certify_existence(
        tableaux::read_method_text(
            R"({"A": [["0", "0"], ["0.3333", "0"]], "b": ["-0.5", "1.5"], "claims": {"order": 2}})"),
        60);
    BOOST_TEST(few.theorem.find("too few digits") != std::string::npos);
}
