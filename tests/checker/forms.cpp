// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE forms
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/entry.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <string>
#include <vector>
#include "../checked.hpp"

// What a file may hold besides a plain tableau of fractions and decimals, and the schemas of input and output.

using namespace stagecraft;
using checked::certify;
using checked::certify_method;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const fs::path root = STAGECRAFT_SOURCE_DIR;

std::string A_of(const std::string& text) {
    std::string all;
    for (const auto& row : tableaux::read_tableau(text).A) {
        for (const auto& e : row) all += e.text + " ";
        all += "; ";
    }
    return all;
}

/// Where `value` breaks the schema, empty where it does not: the keywords that the schemas here use.
class validator {
  public:
    explicit validator(const fs::path& file) : schema_(json::parse(tableaux::text_of_file(file.string()))) {}
    std::string complaint(const json& value) const { return complaint(value, schema_, "value"); }

  private:
    static bool has_type(const json& v, const std::string& type) {
        return type == "object"    ? v.is_object()
               : type == "array"   ? v.is_array()
               : type == "string"  ? v.is_string()
               : type == "boolean" ? v.is_boolean()
               : type == "integer" ? v.is_number_integer()
                                   : v.is_number();
    }
    std::string complaint(const json& v, const json& s, const std::string& at) const {
        static const std::vector<std::string> known{
            "$schema",    "$defs",    "title",    "description", "$ref",
            "anyOf",      "type",     "enum",     "items",       "required",
            "properties", "minItems", "maxItems", "minimum",     "additionalProperties",
            "maximum"};
        for (const auto& [key, rule] : s.items())
            if (std::find(known.begin(), known.end(), key) == known.end()) return "keyword " + key;
        if (s.contains("$ref"))
            return complaint(v, schema_[json::json_pointer(s["$ref"].get<std::string>().substr(1))], at);
        if (s.contains("anyOf")) {
            std::string why;
            for (const json& one : s["anyOf"]) {
                const std::string c = complaint(v, one, at);
                if (c.empty()) return {};
                why += c + "; ";
            }
            return why;
        }
        if (s.contains("enum") && std::find(s["enum"].begin(), s["enum"].end(), v) == s["enum"].end())
            return at + " is none of the values";
        if (s.contains("type")) {
            const json types = s["type"].is_array() ? s["type"] : json::array({s["type"]});
            if (std::none_of(types.begin(), types.end(), [&](const json& t) { return has_type(v, t); }))
                return at + " is of another type";
        }
        if (v.is_number() &&
            ((s.contains("minimum") && v < s["minimum"]) || (s.contains("maximum") && v > s["maximum"])))
            return at + " is out of range";
        if (v.is_array()) return in_array(v, s, at);
        if (v.is_object()) return in_object(v, s, at);
        return {};
    }
    std::string in_array(const json& v, const json& s, const std::string& at) const {
        if ((s.contains("minItems") && v.size() < s["minItems"]) ||
            (s.contains("maxItems") && v.size() > s["maxItems"]))
            return at + " has another number of items";
        if (s.contains("items"))
            for (std::size_t i = 0; i < v.size(); ++i)
                if (auto c = complaint(v[i], s["items"], at + "[" + std::to_string(i) + "]"); !c.empty())
                    return c;
        return {};
    }
    std::string in_object(const json& v, const json& s, const std::string& at) const {
        if (s.contains("required"))
            for (const json& key : s["required"])
                if (!v.contains(key.get<std::string>())) return at + " lacks " + key.get<std::string>();
        for (const auto& [key, member] : v.items()) {
            if (s.contains("properties") && s["properties"].contains(key)) {
                if (auto c = complaint(member, s["properties"][key], at + "." + key); !c.empty()) return c;
            } else if (s.contains("additionalProperties") && s["additionalProperties"] == false) {
                return at + " has the unknown member " + key;
            }
        }
        return {};
    }

    json schema_;
};

/// The findings that are called consistent though what they left exceeds what the data explain.
std::string beyond_its_bound(const json& certificate) {
    std::string found;
    for (const auto& [name, f] : certificate.items())
        if (f.is_object() && f.value("verdict", "") == "consistent" && f.value("bound", "none") != "none" &&
            std::stold(f["residual"].get<std::string>()) > std::stold(f["bound"].get<std::string>()) * 1.001L)
            found += name + " ";
    for (const json& partner : certificate.value("partners", json::array()))
        found += beyond_its_bound(partner);
    return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(shu_osher_and_low_storage_forms_are_the_tableaux_that_they_mean) {
    // SSP(3,3) in three forms, against its tableau.
    const std::string tableau =
        A_of(tableaux::text_of_file((root / "tableaux/catalogue/ssp_3_3.json").string()));
    for (const std::string form :
         {R"({"form":"shu-osher","alpha":[["1"],["3/4","1/4"],["1/3","0","2/3"]],
              "beta":[["1"],["0","1/4"],["0","0","2/3"]],"claims":{"order":3}})",
          R"({"form":"2S","gamma1":["1","1/4","2/3"],"gamma2":["0","3/4","1/3"],"delta":["1","0","0"],
              "beta":["1","1/4","2/3"],"claims":{"order":3}})"}) {
        BOOST_TEST(A_of(form) == tableau);
        const auto c = certify_method(form);
        BOOST_TEST(c.exit_code() == 0);
        BOOST_TEST(c.find("order")->judgement->is_proved());
        BOOST_TEST(certify_method(theory::json_text(c)).exit_code() == 0);
    }
    // Williamson's method of order 3, exact; that of Carpenter and Kennedy of order 4 in quotients of integers.
    const auto williamson = certify_method(
        R"({"form":"2N","A":["0","-5/9","-153/128"],"B":["1/3","15/16","8/15"],"claims":{"order":3}})");
    BOOST_TEST(williamson.find("order")->judgement->is_proved());
    const auto kennedy = certify_method(R"({"form":"2N",
        "A":["0","-567301805773/1357537059087","-2404267990393/2016746695238",
             "-3550918686646/2091501179385","-1275806237668/842570457699"],
        "B":["1432997174477/9575080441755","5161836677717/13612068292357","1720146321549/2090206949498",
             "3134564353537/4481467310338","2277821191437/14882151754819"],"claims":{"order":4}})");
    BOOST_TEST((kennedy.overall() == theory::standing::consistent));
    BOOST_TEST(kennedy.find("order")->value.value() == 4);
    const auto complaint = [](const std::string& text) -> std::string {
        try {
            tableaux::read_tableau(text);
            return "accepted";
        } catch (const tableaux::unusable_input& e) {
            return e.what();
        }
    };
    BOOST_TEST(
        complaint(R"({"form":"shu-osher","alpha":[["1"],["3/4","1/2"]],"beta":[["1"],["0","1/4"]]})") ==
        "line 1: alpha[2] contains the old value 5/4 times, not once: the coefficients of a row must sum to "
        "1");
    BOOST_TEST(complaint(R"({"form":"2N","A":["0"]})") == "line 1: B is missing");
    BOOST_TEST(complaint(R"({"form":"shu-osher","alpha":[["1","1"],["1","0"]],"beta":[["1"],["1"]]})") ==
               "line 1, alpha[1][2]: must be 0: the method is explicit");
}

BOOST_AUTO_TEST_CASE(cos_sin_and_pi_are_enclosed) {
    using tableaux::rational;
    const auto value = [](const std::string& text) { return tableaux::read_entry(text).enclosure; };
    // 2 cos(pi/5) is the golden ratio, sin(pi/6) = 1/2; pi to 50 digits.
    const rational tiny = tableaux::scaled(1, -380);
    for (const auto& [function, algebraic] :
         std::vector<std::pair<std::string, std::string>>{{"2*cos(pi/5)", "(1+sqrt(5))/2"},
                                                          {"sin(pi/6)", "1/2"},
                                                          {"cos(0)", "1"},
                                                          {"sin(pi/12)", "(sqrt(6)-sqrt(2))/4"},
                                                          {"cos(2)^2+sin(2)^2", "1"}}) {
        const auto x = value(function), y = value(algebraic);
        BOOST_TEST((x.lower <= y.upper && y.lower <= x.upper), function);
        BOOST_TEST((x.width() < tiny), function);
    }
    const auto pi = value("pi");
    const auto known = value("3.14159265358979323846264338327950288419716939937511");
    BOOST_TEST((known.lower < pi.lower && pi.upper < known.upper));
    BOOST_CHECK_THROW(value("cos(10^9)"), std::invalid_argument);
    BOOST_CHECK_THROW(value("tan(1)"), std::invalid_argument);
    // Chebyshev nodes of two stages by their cosines: the collocation method on them has order 2.
    const auto c = certify(R"j({"c":["(1-cos(pi/4))/2","(1+cos(pi/4))/2"],
        "A":[["1/4-cos(pi/4)/8","1/4-3*cos(pi/4)/8"],["1/4+3*cos(pi/4)/8","1/4+cos(pi/4)/8"]],
        "b":["1/2","1/2"],"claims":{"order":2,"stage_order":2}})j");
    BOOST_TEST(c.exit_code() == 0);
}

BOOST_AUTO_TEST_CASE(a_positive_quadratic_form_leaves_no_residual) {
    // Norsett's method with its nested surd, whose M is singular; that of Crouzeix with a misprint that leaves M > 0.
    const std::string g = "(1/2+cos(pi/18)/sqrt(3))", b = "1/(6*(1-2*" + g + ")^2)";
    const auto norsett =
        certify(R"({"A":[[")" + g + R"(","0","0"],["1/2-)" + g + R"(",")" + g + R"(","0"],["2*)" + g +
                R"(","1-4*)" + g + R"(",")" + g + R"("]],"b":[")" + b + R"(","1-2*)" + b + R"(",")" + b +
                R"("],"claims":{"order":4,"algebraically_stable":true}})");
    const auto crouzeix =
        certify(R"({"A":[["0.788675134594813","0"],["-0.577350269189626","0.788675134594831"]],
        "b":["1/2","1/2"],"claims":{"algebraically_stable":true}})");
    for (const auto& c : {norsett, crouzeix}) {
        BOOST_TEST(c.exit_code() == 0);
        BOOST_TEST(c.find("algebraically_stable")->truth->is_consistent());
        BOOST_TEST(beyond_its_bound(theory::to_json(c)) == "");
    }
}

BOOST_AUTO_TEST_CASE(principal_errors_are_those_of_the_literature) {
    // Prince and Dormand 1981 for RK5(4)7M, Bogacki and Shampine 1996.
    const auto norm = [](const char* name) {
        const auto e = checked::certify_file((root / "tableaux/catalogue" / name).string()).principal_error;
        return e ? std::stod(e->norm) : 0.0;
    };
    BOOST_TEST(std::abs(norm("dormand_prince_5_4.json") - 3.99e-4) < 0.5e-6);
    BOOST_TEST(std::abs(norm("bogacki_shampine_5_4.json") - 2.2e-5) < 0.5e-6);
}

// A and D of RK5(4)7M are those of Prince and Dormand; all are those of another program (nested tuples for trees, fractions).
BOOST_AUTO_TEST_CASE(error_metrics_of_pairs_are_those_of_the_literature) {
    const auto metrics = [](const char* name) {
        const auto m = checked::certify_file((root / "tableaux/catalogue" / name).string()).error_metrics;
        return m ? m->A + " " + m->A_embedded + " " + m->B + " " + m->C + " " + m->D + " " + m->E : "none";
    };
    BOOST_TEST(metrics("dormand_prince_5_4.json") == "0.0003991 0.001183 1.542 1.665 11.6 0.3374");
    BOOST_TEST(metrics("bogacki_shampine_5_4.json") == "2.217e-05 0.000106 1.268 1.193 1.164 0.2092");
    BOOST_TEST(metrics("fehlberg_4_5.json") ==
               "0.003356 0.001839 3.156 1.364 8 1.825");  // the lower one steps
    BOOST_TEST(metrics("kennedy_carpenter_esdirk_4_3.json") == "0.003401 0.0008243 5.479 1.381 1 4.126");
    BOOST_TEST(metrics("kvaerno_3_2.json").find("not") == std::string::npos);  // thirty decimals
    BOOST_TEST(metrics("gauss_3.json") == "none");
}

BOOST_AUTO_TEST_CASE(every_file_keeps_the_schema_and_so_does_its_certificate) {
    const validator method(root / "tableaux/schema/method.schema.json");
    const validator certificate(root / "tableaux/schema/certificate.schema.json");
    int files = 0;
    for (const char* folder : {"catalogue", "pairs", "dense", "rosenbrock"})
        for (const auto& item : fs::directory_iterator(root / "tableaux" / folder))
            BOOST_TEST_CONTEXT(item.path()) {
                const std::string text = tableaux::text_of_file(item.path().string());
                BOOST_TEST(method.complaint(json::parse(text)) == "");
                if (++files % 8 != 0 && std::string(folder) != "dense") continue;  // certificates take time
                const auto c = certify_method(text, item.path().parent_path().string());
                const json printed = json::parse(theory::json_text(c));
                BOOST_TEST(certificate.complaint(printed) == "");
                BOOST_TEST(beyond_its_bound(printed) == "");
                BOOST_TEST(method.complaint(printed["tableau"]) == "");
            }
    BOOST_TEST(files >= 160);
    // The schemas refuse what the reader refuses.
    for (const char* bad : {R"({"A":[["0"]]})", R"({"A":[["0"]],"b":["1"],"claims":{"order":"4"}})",
                            R"({"A":[["0"]],"b":["1"],"B":1})", R"({"form":"other","partners":[]})",
                            R"({"form":"additive","partners":["x"]})", "[]"})
        BOOST_TEST(method.complaint(json::parse(bad)) != "", bad);
}
