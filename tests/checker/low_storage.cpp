// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE low_storage
// Suspects of files that give a method by its registers are coefficients that stand in them.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <string>
#include <vector>
#include "../checked.hpp"
#include "../message.hpp"

using checked::certify_method;
using nlohmann::json;

namespace {

/// Williamson 1980; Carpenter and Kennedy 1994 (NASA TM 109112), to 16 decimals; Berland, Bogey and Bailly 2006
/// (RK46-NL); Spiteri and Ruuth 2002, SSP(5,4), as Shu and Osher write it; Ranocha-Dalcin-Parsani-Ketcheson 2022, RK3(2)5[3S*+].
const std::vector<std::string> published{
    R"({"form":"2N","A":["0","-5/9","-153/128"],"B":["1/3","15/16","8/15"],"claims":{"order":3}})",
    R"({"form":"2N","A":["0","-0.4178904744998519","-1.1921516946426769","-1.6977846924715279","-1.5141834442571558"],
        "B":["0.1496590219992291","0.3792103129996273","0.8229550293869817","0.6994504559491221","0.1530572479681520"],
        "claims":{"order":4}})",
    R"({"form":"2N","A":["0","-0.737101392796","-1.634740794343","-0.744739003780","-1.469897351522","-2.813971388035"],
        "B":["0.032918605146","0.823256998200","0.381530948900","0.200092213184","1.718581042715","0.270000000000"],
        "claims":{"order":4}})",
    R"({"form":"shu-osher","alpha":[["1"],["0.444370493651235","0.555629506348765"],
        ["0.620101851488403","0","0.379898148511597"],["0.178079954393132","0","0","0.821920045606868"],
        ["0","0","0.517231671970585","0.096059710526147","0.386708617503269"]],
        "beta":[["0.391752226571890"],["0","0.368410593050371"],["0","0","0.251891774271694"],
        ["0","0","0","0.544974750228521"],["0","0","0","0.063692468666290","0.226007483236906"]],
        "claims":{"order":4}})",
    stagecraft::tableaux::text_of_file(STAGECRAFT_SOURCE_DIR "/tableaux/low_storage/ranocha_3s_3_2.json")};

/// The digit after the second one, or the last of a numerator, made another.
std::string misprinted(std::string text) {
    std::size_t at = text.find_first_of("123456789");
    const auto end = std::min(text.find('/'), text.size());
    if (text.find('.') != std::string::npos) at += 2;
    at = std::min(at, end - 1);
    text[at] = text[at] == '9' ? '4' : static_cast<char>(text[at] + 1);
    return text;
}

struct slot {
    std::string name;
    json::json_pointer at;
};

std::vector<slot> slots(const json& file) {
    std::vector<slot> all;
    for (const std::string key : {"A", "B", "beta", "b_embedded"}) {
        if (!file.contains(key)) continue;
        for (std::size_t i = 0; i < file[key].size(); ++i) {
            const std::string row = std::to_string(i + 1), path = "/" + key + "/" + std::to_string(i);
            if (!file[key][i].is_array()) {
                all.push_back({key + "[" + row + "]", json::json_pointer(path)});
                continue;
            }
            for (std::size_t k = 0; k < file[key][i].size(); ++k)
                all.push_back({key + "[" + row + "][" + std::to_string(k + 1) + "]",
                               json::json_pointer(path + "/" + std::to_string(k))});
        }
    }
    return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_misprint_in_each_coefficient_is_named_by_the_name_that_it_has_in_the_file) {
    int tried = 0, first = 0;
    for (const std::string& text : published) {
        const json good = json::parse(text);
        BOOST_TEST(certify_method(text).exit_code() == 0, text);
        for (const slot& s : slots(good)) {
            const std::string written = good[s.at];
            if (written == "0") continue;
            json bad = good;
            bad[s.at] = misprinted(written);
            const auto c = certify_method(bad.dump());
            BOOST_TEST(c.exit_code() == 1, s.name << " = " << bad[s.at]);
            ++tried;
            if (!c.suspects.empty() && c.suspects.front().entry == s.name)
                ++first;
            else
                BOOST_TEST_MESSAGE(s.name << " is not the first suspect of " << bad.dump());
        }
    }
    BOOST_TEST(tried >= 30);
    BOOST_TEST(10 * first >= 9 * tried, first << " of " << tried);
}

BOOST_AUTO_TEST_CASE(stored_registers_have_the_orders_that_they_claim) {
    int files = 0;
    for (const auto& item :
         std::filesystem::directory_iterator(STAGECRAFT_SOURCE_DIR "/tableaux/low_storage"))
        BOOST_TEST_CONTEXT(item.path()) {
            const auto c = certify_method(stagecraft::tableaux::text_of_file(item.path().string()));
            BOOST_TEST(c.exit_code() == 0);
            BOOST_TEST((c.find("order") != nullptr && c.find("order")->value));
            ++files;
        }
    BOOST_TEST(files >= 7);
    // An estimate is claimed with weights alone, one a stage.
    const auto said = [](const std::string& text) {
        return message<stagecraft::tableaux::unusable_input>([&] { certify_method(text); });
    };
    BOOST_TEST(said(R"({"form":"2N","A":["0"],"B":["1"],"claims":{"order":1,"embedded_order":1}})") ==
               "line 1, claims.embedded_order: there is no b_embedded");
    BOOST_TEST(said(R"({"form":"2N","A":["0"],"B":["1"],"b_embedded":["1","0"]})") ==
               "line 1, b_embedded: has 2 entries, others have 1");
    BOOST_TEST(said(R"({"form":"3S*","gamma1":["0"],"gamma2":["1"],"delta":["1"],"beta":["1"]})") ==
               "line 1: gamma3 is missing");
}

BOOST_AUTO_TEST_CASE(exchanged_coefficients_are_named_and_rows_that_do_not_sum_to_1_refused) {
    const auto c = certify_method(
        R"({"form":"2N","A":["0","-5/9","-153/128"],"B":["1/3","8/15","15/16"],"claims":{"order":3}})");
    BOOST_TEST(c.exit_code() == 1);
    BOOST_TEST(c.suspects.empty());
    BOOST_TEST(c.suspects_note == "B[2] and B[3] are exchanged: undone, every claim is restored");
    // gamma and delta of a 2S form fix each other; beta alone can be wrong in a file that is read.
    const auto two_s = certify_method(R"({"form":"2S","gamma1":["1","1/4","2/3"],"gamma2":["0","3/4","1/3"],
        "delta":["1","0","0"],"beta":["1","1/2","2/3"],"claims":{"order":3}})");
    BOOST_REQUIRE(!two_s.suspects.empty());
    BOOST_TEST(two_s.suspects.front().entry == "beta[2]");
    BOOST_TEST(two_s.suspects.front().suggest == "1/4");
    // Nodes and embedded weights stand beside the form.
    json with_nodes = json::parse(published.front());
    with_nodes["c"] = {"0", "1/3", "3/4"};
    const auto good = certify_method(with_nodes.dump());
    BOOST_TEST(good.find("row_sums")->judgement->is_proved());
    with_nodes["c"][2] = "3/14";
    const auto wrong_node = certify_method(with_nodes.dump());
    BOOST_TEST(wrong_node.exit_code() == 1);
    BOOST_REQUIRE(wrong_node.suspects.size() == 1);
    BOOST_TEST(wrong_node.suspects.front().entry == "c[3]");
    BOOST_TEST(wrong_node.suspects.front().suggest == "3/4");
    json with_estimate = json::parse(published.back());
    std::swap(with_estimate["b_embedded"][1], with_estimate["b_embedded"][3]);
    BOOST_TEST(certify_method(with_estimate.dump()).suspects_note ==
               "b_embedded[2] and b_embedded[4] are exchanged: undone, every claim is restored");
}
