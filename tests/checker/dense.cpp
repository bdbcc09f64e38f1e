// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE dense
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/program_text.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <string>
#include <vector>
#include "../checked.hpp"

// Dense output b(theta): the published ones, their order at every theta and their smoothness, and defects.

using namespace stagecraft;
using checked::certify;
namespace fs = std::filesystem;

namespace {

const std::string folder = STAGECRAFT_SOURCE_DIR "/tableaux/dense/";

double number(const tableaux::entry& e) { return e.enclosure.middle().to<double>(); }

/// Error at t = theta h of the dense output of one explicit step for y' = y - y^2, y(0) = 1/4.
double error_at(const tableaux::tableau_file& m, double h, double theta) {
    const auto exact = [](double t) { return std::exp(t) / (3 + std::exp(t)); };
    std::vector<double> k;
    double y = 0.25;
    for (std::size_t i = 0; i < m.b.size(); ++i) {
        double stage = 0.25;
        for (std::size_t j = 0; j < i; ++j) stage += h * number(m.A[i][j]) * k[j];
        k.push_back(stage - stage * stage);
        double weight = 0;
        for (std::size_t n = m.b_theta[i].size(); n-- > 0;)
            weight = theta * (weight + number(m.b_theta[i][n]));
        y += h * weight * k[i];
    }
    return std::abs(y - exact(theta * h));
}

bool is_explicit(const tableaux::tableau_file& m) {
    for (std::size_t i = 0; i < m.b.size(); ++i)
        if (number(m.A[i][i]) != 0) return false;
    return true;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_published_dense_outputs_have_the_order_that_is_claimed) {
    int files = 0;
    for (const auto& item : fs::directory_iterator(folder)) BOOST_TEST_CONTEXT(item.path()) {
            const auto file = tableaux::read_tableau_file(item.path().string());
            const auto c = certify(tableaux::text_of_file(item.path().string()));
            BOOST_TEST(c.exit_code() == 0);
            BOOST_REQUIRE(file.claims.dense_order);
            BOOST_TEST(*c.find("dense_order")->value == *file.claims.dense_order);
            if (file.kind() <= tableaux::number_kind::quadratic)
                BOOST_TEST(c.find("dense_order")->judgement->is_proved());
            BOOST_TEST(certify(theory::json_text(c)).exit_code() == 0);
            ++files;
            if (!is_explicit(file)) continue;
            // Local errors, measured.
            const double h = *file.claims.dense_order > 5 ? 1 : 0.125;
            for (const double theta : {0.3, 0.75}) {
                const double seen = std::log2(error_at(file, h, theta) / error_at(file, h / 2, theta));
                BOOST_TEST(seen > *file.claims.dense_order + 1 - 0.4);
            }
        }
    BOOST_TEST(files >= 9);
}

BOOST_AUTO_TEST_CASE(a_defect_of_the_polynomials_is_found) {
    const std::string good = tableaux::text_of_file(folder + "dormand_prince_5_4_quartic.json");
    const auto with = [&](const std::string& what, const std::string& instead) {
        std::string text = good;
        text.replace(text.find(what), what.size(), instead);
        return certify(text);
    };
    const auto sign = with("\"-110615467/29380423\"", "\"110615467/29380423\"");
    BOOST_TEST(sign.exit_code() == 1);
    BOOST_TEST(*sign.find("dense_order")->value == 0);
    BOOST_TEST(sign.find("dense_smoothness")->judgement->is_refuted());
    const auto of_dense = std::find_if(sign.failures.begin(), sign.failures.end(),
                                       [](const auto& f) { return f.condition.starts_with("dot(b(theta)"); });
    BOOST_REQUIRE(of_dense != sign.failures.end());
    BOOST_TEST(of_dense->condition == "dot(b(theta), one) == theta, coefficient of theta^3");
    BOOST_REQUIRE(!sign.suspects.empty());
    BOOST_TEST(sign.suspects.front().entry == "b_theta[7][3]");
    BOOST_TEST(sign.suspects.front().suggest == "-110615467/29380423");
    const auto digit = with("\"87487479700/32700410799\"", "\"87487479070/32700410799\"");
    BOOST_TEST(digit.exit_code() == 1);
    BOOST_REQUIRE(!digit.suspects.empty());
    BOOST_TEST(digit.suspects.front().entry == "b_theta[3][4]");
    BOOST_TEST(digit.suspects.front().suggest == "87487479700/32700410799");

    // An order too high, and a derivative that jumps.
    BOOST_TEST(with("\"dense_order\": 4", "\"dense_order\": 5").exit_code() == 1);
    std::string rk4 = tableaux::text_of_file(folder + "classical_rk4.json");
    rk4.replace(rk4.find("\"dense_smoothness\": 0"), 21, "\"dense_smoothness\": 1");
    const auto jumps = certify(rk4);
    BOOST_TEST(jumps.exit_code() == 1);
    BOOST_TEST(*jumps.find("dense_smoothness")->value == 0);

    // Decimals: the 15th digit of DOP853's d_4,1.
    std::string dop = tableaux::text_of_file(folder + "dormand_prince_8_5_3.json");
    for (std::size_t at = 0; (at = dop.find("8.4289382761090128", at)) != std::string::npos; at += 10)
        dop.replace(at, 18, "8.4289382761090218");
    const auto rounded = certify(dop);
    BOOST_TEST(rounded.exit_code() == 1);
    BOOST_TEST(rounded.find("dense_order")->judgement->is_refuted());
}

BOOST_AUTO_TEST_CASE(published_defects_of_dense_output_are_found) {
    const auto method = [](const std::string& name) {
        return nlohmann::json::parse(tableaux::text_of_file(folder + name + ".json"));
    };
    // A Julia package of 2026 moved f(t + h, y1) to the first slope before it used the dense output of Dormand and
    // Prince: b_1(theta) k_7 for b_1(theta) k_1. Steps were right, output between them was not.
    auto taken_late = method("dormand_prince_5_4_quartic");
    auto& b = taken_late["b_theta"];
    for (std::size_t k = 0; k < 4; ++k) {
        const std::string last = k < b[6].size() ? b[6][k].get<std::string>() : "0";
        b[6][k] = last + "+(" + b[0][k].get<std::string>() + ")";
    }
    b[0] = {"0"};
    const auto late = certify(taken_late.dump());
    BOOST_TEST(late.exit_code() == 1);
    BOOST_TEST(!late.find("order")->judgement->is_refuted());
    BOOST_TEST(*late.find("dense_order")->value == 1);
    BOOST_TEST(late.find("dense_smoothness")->judgement->is_refuted());

    // The dense output that Dormand and Prince published first (1986; Hairer-Norsett-Wanner I.II.6 in its first
    // edition): of order 4, but with a derivative that jumps between steps.
    auto first = method("dormand_prince_5_4_quartic");
    first["b_theta"] = {{"1", "-1337/480", "1039/360", "-1163/1152"},
                        {"0"},
                        {"0", "100/3*1054/9275", "-100/3*4682/27825", "100/3*379/5565"},
                        {"0", "-5/2*27/40", "5/2*9/5", "-5/2*83/96"},
                        {"0", "-18225/848*3/250", "18225/848*22/375", "-18225/848*37/600"},
                        {"0", "22/7*3/10", "-22/7*29/30", "22/7*17/24"},
                        {"0"}};
    const auto jumps = certify(first.dump());
    BOOST_TEST(jumps.find("dense_order")->judgement->is_proved());
    BOOST_TEST(*jumps.find("dense_smoothness")->value == 0);
    BOOST_TEST(jumps.exit_code() == 1);
    first["claims"]["dense_smoothness"] = 0;
    BOOST_TEST(certify(first.dump()).exit_code() == 0);

    // The embedded weights as Tsitouras's table 1 has them: differences to b, the last with the wrong sign.
    auto sign = method("tsitouras_5_4");
    sign["b_embedded"][6] = "-1/66";
    const auto wrong = certify(sign.dump());
    BOOST_TEST(wrong.exit_code() == 1);
    BOOST_REQUIRE(wrong.suspects.size() == 1u);
    BOOST_TEST(wrong.suspects.front().entry == "b_embedded[7]");
    BOOST_TEST(wrong.suspects.front().suggest == "1/66");
}

BOOST_AUTO_TEST_CASE(what_is_wrong_with_the_polynomials_is_said) {
    const auto complaint = [](const std::string& rest) -> std::string {
        try {
            certify(R"({"A":[["0"]],"b":["1"],)" + rest + "}");
            return "accepted";
        } catch (const tableaux::unusable_input& e) {
            return e.what();
        }
    };
    BOOST_TEST(complaint(R"("b_theta":[["1"]])") == "accepted");
    BOOST_TEST(complaint(R"("b_theta":[["1"],["0"]])") ==
               "line 1, b_theta: must be a list of 1 lists of coefficients");
    BOOST_TEST(complaint(R"("b_theta":[["1","x"]])") == "line 1, b_theta[1][2]: 'x' unknown symbol 'x'");
    BOOST_TEST(complaint(R"("claims":{"dense_order":1})") ==
               "line 1, claims.dense_order: there is no b_theta");
    BOOST_TEST(complaint(R"("b_theta":[["1"]],"claims":{"dense_order":11})") ==
               "line 1, claims.dense_order: must be at most 10");
}

BOOST_AUTO_TEST_CASE(dense_output_of_programs_is_read_whatever_its_form) {
    // Bogacki-Shampine 3(2) with SciPy's P, which diffrax would write from the highest power and PETSc hands to a call; without the
    // latter's last stage. Its cubic is that of Hermite, so the value at 1/2 makes it too.
    const std::string A = "[0, 0, 0], [1/2, 0, 0], [0, 3/4, 0]", b = "2/9, 1/3, 4/9";
    const std::string python = "A = [" + A + "]\nb = [" + b + "]\nE = [5/72, -1/12, -1/9, 1/8]\n";
    const std::vector<std::string> sources{
        python + "P = [[1, -4/3, 5/9], [0, 1, -2/3], [0, 4/3, -8/9], [0, -1, 1]]\n",
        python +
            "class Local:\n    eval_coeffs = [[5/9, -4/3, 1], [-2/3, 1, 0], [-8/9, 4/3, 0], [1, -1, 0]]\n",
        python + "MID = [17/72, 1/6, 2/9, -1/8]\nclass Solver:\n    mid = MID\n",
        "{ double A[4][4] = {{0, 0, 0, 0}, {1./2, 0, 0, 0}, {0, 3./4, 0, 0}, {2./9, 1./3, 4./9, 0}}, "
        "b[4] = {2./9, 1./3, 4./9, 0}, B[4][3] = {{1, -4./3, 5./9}, {0, 1, -2./3}, {0, 4./3, -8./9}, {0, -1, "
        "1}};\n"
        "TSRKRegister(\"3bs\", 3, 4, &A[0][0], b, NULL, NULL, 3, B[0]); }\n"};
    for (const auto& source : sources) {
        const auto p = tableaux::read_program_text(source);
        BOOST_TEST(p.unused.empty(), source);
        BOOST_REQUIRE(p.tableaux.size() == 1);
        const auto certificate = theory::certify(p.tableaux.front());
        BOOST_TEST(*certificate.find("dense_order")->value == 3, source);
        BOOST_TEST(*certificate.find("dense_smoothness")->value == 1, source);
    }
    // No order at all is no dense output, claimed or not.
    std::string wrong = sources[0];
    const auto sum =
        theory::certify(tableaux::read_program_text(wrong.replace(wrong.find("[0, -1, 1]"), 10, "[0, 1, 1]"))
                            .tableaux.front());
    BOOST_TEST(sum.exit_code() == 1);
    BOOST_TEST(sum.suspects.size() == 4);  // b_theta[1][2] to b_theta[4][2]: any of them
}
