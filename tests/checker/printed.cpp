// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE printed
// Tables as they are printed: catalogue methods in 8, 16 and 40 digits with trailing zeros left out, as
// fractions, and with a misprint in one of six entries. A good table is not refuted, a misprint is, and its
// entry is named first. Argument after "--": a file to print misses to.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/entry.hpp>
#include <string>
#include <vector>

#include "../checked.hpp"

namespace {

using nlohmann::json;
using namespace stagecraft::tableaux;

/// x to so many significant digits, zeros at the end left out: "0.5", "-0.33333333".
std::string printed(const entry& e, int digits) {
    const rational x = e.enclosure.middle();
    if (x == 0 || (e.exact && e.exact->is_rational() && x.denominator() == 1)) return x.str();
    rational unit = 1;
    const rational size = x < 0 ? -x : x;
    int places = 0;
    for (; size < rational(pow(integer(10), static_cast<unsigned>(digits - 1))) * unit; ++places)
        unit = unit / rational(10);
    std::string n = floor(size / unit + rational(1, 2)).str();
    if (static_cast<int>(n.size()) <= places)
        n.insert(0, static_cast<std::size_t>(places) + 1 - n.size(), '0');
    n.insert(n.size() - static_cast<std::size_t>(places), ".");
    while (n.back() == '0') n.pop_back();
    return (x < 0 ? "-" : "") + n;
}

struct slot {
    std::string name;
    json::json_pointer at;
};

/// The entries that are not zero and no whole numbers.
std::vector<slot> slots(const json& table) {
    std::vector<slot> all;
    const auto add = [&](const std::string& name, const std::string& at) {
        const json::json_pointer p(at);
        const auto value = read_entry(table[p].get<std::string>()).enclosure.middle();
        if (value.denominator() != 1) all.push_back({name, p});
    };
    const auto index = [](std::size_t i) { return "[" + std::to_string(i + 1) + "]"; };
    for (std::size_t i = 0; i < table["b"].size(); ++i)
        for (std::size_t j = 0; j < table["b"].size(); ++j)
            add("A" + index(i) + index(j), "/A/" + std::to_string(i) + "/" + std::to_string(j));
    for (const char* key : {"b", "c", "b_embedded"})
        if (table.contains(key))
            for (std::size_t i = 0; i < table[key].size(); ++i)
                add(key + index(i), std::string("/") + key + "/" + std::to_string(i));
    return all;
}

json as_printed(const json& table, int digits) {
    json out = table;
    for (const slot& s : slots(table))
        out[s.at] = printed(read_entry(table[s.at].get<std::string>()), digits);
    return out;
}

/// The decimal with its third significant digit, or the last before it, changed; a fraction gets 1/1000 more.
std::string misprinted(const std::string& text) {
    if (text.find('.') == std::string::npos) return "(" + text + ")*1001/1000";
    std::string out = text;
    int significant = 0;
    std::size_t changed = 0;
    for (std::size_t i = 0; i < out.size() && significant < 3; ++i) {
        if (out[i] < '0' || out[i] > '9' || (significant == 0 && out[i] == '0')) continue;
        ++significant;
        changed = i;
    }
    out[changed] = out[changed] == '9' ? '4' : static_cast<char>(out[changed] + 1);
    return out;
}

const std::vector<std::string> methods{"classical_rk4",
                                       "kutta_3_8",
                                       "dormand_prince_5_4",
                                       "bogacki_shampine_3_2",
                                       "cash_karp_5_4",
                                       "fehlberg_4_5",
                                       "gauss_2",
                                       "gauss_3",
                                       "radau_iia_2",
                                       "radau_iia_3",
                                       "lobatto_iiic_3",
                                       "sdirk_4_3",
                                       "bogacki_shampine_5_4",
                                       "verner_6_5",
                                       "butcher_6_seven_stages_a",
                                       "england_4_5"};

json method(const std::string& name) {
    std::ifstream in(std::filesystem::path(STAGECRAFT_SOURCE_DIR) / "tableaux/catalogue" / (name + ".json"));
    return json::parse(in);
}

}  // namespace

BOOST_AUTO_TEST_CASE(printed_tables_are_not_refuted_and_misprints_are_with_the_culprit_first) {
    const auto& suite = boost::unit_test::framework::master_test_suite();
    std::ofstream misses(suite.argc > 1 ? suite.argv[1] : "/dev/null");
    int good = 0, wrong = 0, tried = 0, refuted = 0, first = 0, turn = 0;
    for (const auto& name : methods) {
        const json exact = method(name);
        std::vector<json> forms{exact};
        for (const int digits : {8, 16, 40}) forms.push_back(as_printed(exact, digits));
        for (const json& form : forms) {
            const auto c = checked::certify(form.dump());
            ++good;
            wrong += c.exit_code() != 0;
            if (c.exit_code() != 0) misses << name << ": exit " << c.exit_code() << "\n" << to_text(c);
        }
        const auto places = slots(exact);
        for (std::size_t k = 0; k < 6; ++k) {
            const slot& s = places[k * (places.size() - 1) / 5];
            json table = forms[static_cast<std::size_t>(turn++) % forms.size()];
            table[s.at] = misprinted(table[s.at].get<std::string>());
            const auto c = checked::certify(table.dump());
            const bool named = !c.suspects.empty() && c.suspects.front().entry == s.name;
            ++tried;
            refuted += c.exit_code() == 1;
            first += named;
            if (c.exit_code() != 1 || !named)
                misses << name << " " << s.name << " = " << table[s.at] << ": exit " << c.exit_code() << "\n"
                       << to_text(c);
        }
    }
    std::cout << good << " good tables, " << wrong << " with a wrong exit; " << tried << " misprints, "
              << refuted << " refuted, " << first << " with the culprit first\n";
    BOOST_TEST(good + tried >= 60);
    BOOST_TEST(wrong == 0);
    BOOST_TEST(refuted == tried);
    BOOST_TEST(10 * first >= 9 * tried);
}

BOOST_AUTO_TEST_CASE(a_short_decimal_among_long_ones_is_exact_and_said_so) {
    const json table = as_printed(method("classical_rk4"), 40);
    const auto c = checked::certify(table.dump());
    BOOST_TEST((c.overall() == stagecraft::theory::standing::consistent));
    BOOST_REQUIRE(!c.notes.empty());
    BOOST_TEST(c.notes[0] == "4 short decimals read as exact");
    json wrong = table;
    wrong["/A/2/1"_json_pointer] = "0.6";
    const auto w = checked::certify(wrong.dump());
    BOOST_TEST(w.exit_code() == 1);
    BOOST_REQUIRE(!w.suspects.empty());
    BOOST_TEST(w.suspects[0].entry == "A[3][2]");
    BOOST_TEST(w.suspects[0].suggest == "0.5");
}

BOOST_AUTO_TEST_CASE(too_few_digits_are_inconclusive_with_an_exit_code_of_their_own) {
    // Two digits: 0.17 and 0.33 are 1/6 and 1/3, but what order 4 asks of them is 1/24.
    const std::string text = R"({"A":[["0","0","0","0"],["0.5","0","0","0"],["0","0.5","0","0"],
        ["0","0","1","0"]],"b":["0.17","0.33","0.33","0.17"],"claims":{"order":4}})";
    reading how;
    how.decimals = decimals_are::rounded;
    std::string out, err;
    BOOST_TEST(checked::exit_code(text, true, out, err, how) == 3);
    const auto j = json::parse(out);
    BOOST_TEST(j["verdict"] == "inconclusive");
    BOOST_TEST(j["order"]["verdict"] == "inconclusive");
    how.decimals = decimals_are::exact;
    BOOST_TEST(checked::exit_code(text, true, out, err, how) == 1);
}

BOOST_AUTO_TEST_CASE(bounds_are_compared_with_the_1_over_gamma_of_their_condition) {
    // b^T c = 0.500 +- 0.0005 is to be 1/2: a thousandth of it. The first row has nothing to round.
    const auto c = checked::certify(
        R"({"A":[["0","0"],["0.500","0"]],"b":["0","1"],"c":["0","0.500"],"claims":{"order":2}})");
    BOOST_TEST(c.find("order")->relative_bound == "0.001");
    BOOST_TEST(c.find("order")->judgement->bound() == "0.0005");
    BOOST_TEST(c.find("row_sums")->truth->bound() == "0.001");
    const auto exact = checked::certify(
        R"({"A":[["0","0"],["1/2","0"]],"b":["0.0","1.00"],"c":["0","1/2"],"claims":{"order":1}})");
    BOOST_TEST(exact.find("row_sums")->truth->is_proved());
    // Of several rows the one with the largest residual is reported.
    const auto rows = checked::certify(
        R"({"A":[["0.3333","0"],["0.5000","0.1667"]],"b":["0.5000","0.5000"],"c":["0.3333","0.6666"]})");
    BOOST_TEST(rows.find("row_sums")->truth->residual() == "0.0001");
}

BOOST_AUTO_TEST_CASE(tables_computed_in_floating_point_have_a_numerical_order_and_no_suspects) {
    // Doubles with errors of several units in the last place, as a program's output has.
    json table = as_printed(method("dormand_prince_5_4"), 16);
    int k = 0;
    for (const slot& s : slots(table)) {
        const double x = std::stod(table[s.at].get<std::string>());
        table[s.at] = x * (1 + (k++ % 5 - 2) * 4e-16);
    }
    const std::string text = table.dump();
    const auto c = checked::certify(text);
    BOOST_TEST(c.exit_code() == 1);
    BOOST_REQUIRE(c.find("order")->numerical.has_value());
    BOOST_TEST(c.find("order")->numerical->order == 5);
    BOOST_TEST(c.find("order")->numerical->digits >= 14);
    BOOST_TEST(c.find("embedded_order")->numerical->order == 4);
    BOOST_TEST(c.suspects.empty());
    const auto names_the_options = [](const std::string& why) {
        return why.find("--ulps or --tolerance") != std::string::npos;
    };
    BOOST_TEST(names_the_options(c.find("order")->judgement->text()));
    // Collocation at the Gauss points in doubles of a program, one of them off by two units: taken as that.
    json gauss = {{"A", {{0.25, -0.038675134594812866}, {0.5386751345948129, 0.25}}}, {"b", {0.5, 0.5}}};
    gauss["claims"]["order"] = 4;
    const auto computed = checked::certify(gauss.dump());
    BOOST_TEST(computed.exit_code() == 0);
    BOOST_TEST(computed.taken_as.value().what.starts_with("doubles computed to"));
    gauss["claims"]["order"] = 5;  // which rounding does not explain
    BOOST_TEST(!names_the_options(checked::certify(gauss.dump()).find("order")->judgement->text()));
    std::string out, err;
    reading how;
    how.ulps = 8;
    BOOST_TEST(checked::exit_code(text, true, out, err, how) == 0);
    how = {};
    how.tolerance = rational(1, 100000000000000);
    BOOST_TEST(checked::exit_code(text, true, out, err, how) == 0);
    how.tolerance = rational(1, 10);  // explains anything, so it proves nothing
    BOOST_TEST(checked::exit_code(text, true, out, err, how) == 3);
}

BOOST_AUTO_TEST_CASE(decimals_cut_off_are_not_refuted_and_hide_no_misprint) {
    // Sixteen digits without rounding up: the row sums of A, or those of b, are off by more than halves explain.
    for (const char* name : {"huta_6", "verner_6_5", "cooper_verner_8", "butcher_6_seven_stages_b"}) {
        json table = as_printed(method(name), 19);
        for (const slot& s : slots(table)) {
            auto text = table[s.at].get<std::string>();
            if (text.size() > 17) table[s.at] = text.substr(0, text.size() - 3);
        }
        const auto c = checked::certify(table.dump());
        BOOST_TEST(c.exit_code() == 0, name << ": " << to_text(c));
        table["/A/4/3"_json_pointer] = misprinted(table["/A/4/3"_json_pointer]);
        const auto wrong = checked::certify(table.dump());
        BOOST_TEST(wrong.exit_code() == 1);
        BOOST_REQUIRE(!wrong.suspects.empty());
        BOOST_TEST(wrong.suspects.front().entry == "A[5][4]");
    }
    json cut = as_printed(method("huta_6"), 19);
    for (const slot& s : slots(cut)) {
        auto text = cut[s.at].get<std::string>();
        if (text.size() > 17) cut[s.at] = text.substr(0, text.size() - 11);
    }
    BOOST_TEST(checked::certify(cut.dump()).notes.front() ==
               "taken as decimals cut off, not rounded: refuted otherwise (row_sums)");
}

BOOST_AUTO_TEST_CASE(a_fault_in_a_and_one_in_the_embedded_weights_do_not_silence_each_other) {
    for (const int digits : {0, 16}) {
        json table = method("dormand_prince_5_4");
        if (digits > 0) table = as_printed(table, digits);
        for (const char* at : {"/A/3/1", "/b_embedded/2"}) {
            const json::json_pointer p(at);
            table[p] = misprinted(table[p].get<std::string>());
        }
        const auto c = checked::certify(table.dump());
        BOOST_TEST(c.exit_code() == 1);
        BOOST_REQUIRE(c.suspects.size() >= 2u);
        BOOST_TEST(c.suspects[0].entry == "A[4][2]");
        BOOST_TEST(c.suspects[1].entry == "b_embedded[3]");
        BOOST_TEST(c.suspects_note.starts_with("two faults"));
    }
}

BOOST_AUTO_TEST_CASE(a_row_sum_tells_what_the_order_conditions_do_not) {
    // Stage 8 of Bogacki-Shampine 5(4) has no weight in b and b_embedded: only the sum of its row is claimed.
    json idle = method("bogacki_shampine_5_4");
    idle["A"][7][2] = misprinted(idle["A"][7][2]);
    idle["claims"] = {{"order", 5}, {"embedded_order", 4}};
    const auto c = checked::certify(idle.dump());
    BOOST_TEST(c.exit_code() == 1);
    BOOST_TEST(!c.find("order")->judgement->is_refuted());
    BOOST_TEST(std::any_of(c.suspects.begin(), c.suspects.end(),
                           [](const auto& s) { return s.entry == "A[8][3]"; }));
    // Sixteen digits, 20 units of the last one: below what the conditions of order 5 can tell.
    json node = as_printed(method("bogacki_shampine_5_4"), 16);
    BOOST_REQUIRE(node["c"][2] == "0.2222222222222222");
    node["c"][2] = "0.2222222222222242";
    BOOST_TEST(checked::certify(node.dump()).exit_code() == 1);
}

BOOST_AUTO_TEST_CASE(a_repair_keeps_the_structure_and_leaves_it_only_where_nothing_else_restores_the_claims) {
    // With a row sum each entry of the row could be to blame, those above the diagonal among them.
    for (const char* name : {"classical_rk4", "dormand_prince_5_4", "kvaerno_5_4", "sdirk_4_3"}) {
        json table = method(name);
        const std::size_t s = table["b"].size();
        const bool is_explicit = std::all_of(table["A"].begin(), table["A"].end(),
                                             [i = 0U](const auto& row) mutable { return row[i++] == "0"; });
        table["A"][s - 1][0] = "1/7";
        const auto c = checked::certify(table.dump());
        BOOST_TEST_CONTEXT(name) {
            BOOST_TEST(c.exit_code() == 1);
            BOOST_REQUIRE(!c.suspects.empty());
            for (const auto& x : c.suspects) {
                if (x.entry.front() != 'A') continue;
                const auto row = std::stoul(x.entry.substr(2)),
                           column = std::stoul(x.entry.substr(x.entry.find("][") + 2));
                BOOST_TEST((is_explicit ? column < row : column <= row));
            }
        }
    }
    const auto midpoint = checked::certify(R"({"A":[["0"]],"b":["1"],"c":["1/2"],"claims":{"order":2}})");
    BOOST_REQUIRE(midpoint.suspects.size() == 1U);
    BOOST_TEST(midpoint.suspects.front().entry == "A[1][1]");
    BOOST_TEST(midpoint.suspects.front().suggest == "1/2");
    BOOST_TEST(midpoint.suspects_note ==
               "no change within its structure restores every claim; a change of this zero does");
    json radau = method("radau_iia_2");
    radau["A"][0][1] = "0";
    BOOST_TEST(checked::certify(radau.dump()).suspects_note ==
               "entry [2] of row [1] of A is lost: undone, every claim is restored");
}

BOOST_AUTO_TEST_CASE(exchanged_and_transposed_parts_are_recognised) {
    const auto note = [](const json& table) { return checked::certify(table.dump()).suspects_note; };
    json transposed = method("gauss_2");
    std::swap(transposed["/A/0/1"_json_pointer], transposed["/A/1/0"_json_pointer]);
    BOOST_TEST(note(transposed) == "A is transposed: undone, every claim is restored");
    for (const int digits : {0, 16}) {
        const auto form = [&](const std::string& name) {
            return digits > 0 ? as_printed(method(name), digits) : method(name);
        };
        json weights = form("bogacki_shampine_3_2");
        std::swap(weights["b"], weights["b_embedded"]);
        BOOST_TEST(note(weights) == "b and b_embedded are exchanged: undone, every claim is restored");
        json rows = form("cash_karp_5_4");
        std::swap(rows["A"][3], rows["A"][4]);
        BOOST_TEST(note(rows) == "rows [4] and [5] of A are exchanged: undone, every claim is restored");
        for (const char* name :
             {"sdirk_4_3", "cash_karp_5_4"}) {  // an explicit method's gets onto the diagonal
            json shifted = form(name);
            json& row = shifted["A"][3];
            row.insert(row.begin(), "0");
            row.erase(row.end() - 1);
            BOOST_TEST(note(shifted) ==
                       "row [4] of A is shifted by one entry: undone, every claim is restored");
        }
        json nodes = form("radau_iia_3");
        std::swap(nodes["c"][0], nodes["c"][1]);
        BOOST_TEST(note(nodes) == "entries [1] and [2] of c are exchanged: undone, every claim is restored");
    }
}

BOOST_AUTO_TEST_CASE(two_faults_in_a_exchanged_entries_and_lost_columns_are_recognised) {
    for (const int digits : {0, 16}) {
        const auto form = [&](const std::string& name) {
            return digits > 0 ? as_printed(method(name), digits) : method(name);
        };
        json two = form("dormand_prince_5_4");
        for (const char* at : {"/A/3/1", "/A/5/2"}) {
            const json::json_pointer p(at);
            two[p] = misprinted(two[p].get<std::string>());
        }
        const auto c = checked::certify(two.dump());
        BOOST_TEST(c.exit_code() == 1);
        BOOST_REQUIRE(c.suspects.size() >= 2u);
        BOOST_TEST(c.suspects[0].entry == "A[4][2]");
        BOOST_TEST(c.suspects[1].entry == "A[6][3]");

        const auto pair = [&](const char* first, const char* second) {
            json table = form("dormand_prince_5_4");
            for (const char* at : {first, second}) {
                const json::json_pointer p(at);
                table[p] = misprinted(table[p].get<std::string>());
            }
            const auto found = checked::certify(table.dump());
            BOOST_REQUIRE(found.suspects.size() >= 2u);
            return found.suspects[0].entry + " " + found.suspects[1].entry;
        };
        BOOST_TEST(pair("/A/5/1", "/A/5/3") == "A[6][2] A[6][4]");  // in one row
        BOOST_TEST(pair("/A/4/0", "/c/2") == "c[3] A[5][1]");
        BOOST_TEST(pair("/b/2", "/A/3/0") == "A[4][1] b[3]");
        BOOST_TEST(pair("/b/0", "/b/4") == "b[1] b[5]");

        json exchanged = form("cash_karp_5_4");
        std::swap(exchanged["A"][4][1], exchanged["A"][4][2]);
        BOOST_TEST(checked::certify(exchanged.dump()).suspects_note ==
                   "entries A[5][2] and A[5][3] are exchanged: undone, every claim is restored");

        json lost = form("bogacki_shampine_3_2");
        lost["A"][2] = {lost["A"][2][1], "0", "0", "0"};
        lost["A"][3] = {lost["A"][3][1], lost["A"][3][2], "0", "0"};
        lost["A"][1] = {"0", "0", "0", "0"};
        BOOST_TEST(checked::certify(lost.dump()).suspects_note ==
                   "column [1] of A is lost: undone, every claim is restored");
        json row = form("england_4_5");
        row["A"][4] = {row["A"][4][1], row["A"][4][2], row["A"][4][3], "0", "0", "0"};
        BOOST_TEST(checked::certify(row.dump()).suspects_note ==
                   "entry [1] of row [5] of A is lost: undone, every claim is restored");
    }
}
