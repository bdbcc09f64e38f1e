// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE fuzz_certify
// Mutated tableau files through the function behind `stagecraft certify FILE.json`. Arguments after "--":
// number of files (default 300) and seed: `test_fuzz_certify -- 100000 1`, best built with the preset
// `sanitize`.
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <sstream>
#include <stagecraft/method/order_conditions.hpp>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <string>
#include <variant>
#include <vector>

#include "../checked.hpp"

namespace {

using nlohmann::json;

std::vector<std::string> seeds() {
    std::vector<std::filesystem::path> paths;
    const std::filesystem::path root = STAGECRAFT_SOURCE_DIR;
    for (const auto* folder :
         {"tableaux/catalogue", "tableaux/pairs", "tableaux/dense", "tests/data/misprints"})
        for (const auto& f : std::filesystem::directory_iterator(root / folder)) paths.push_back(f.path());
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> texts;
    for (const auto& p : paths) {
        std::ifstream in(p);
        std::ostringstream text;
        text << in.rdbuf();
        texts.push_back(text.str());
    }
    return texts;
}

class mutator {
  public:
    explicit mutator(std::uint64_t seed) : random_(seed), seeds_(seeds()) {}

    std::string next() {
        std::string text = pick(seeds_);
        const auto kind = below(10);
        if (kind < 2) text = restructured(text);
        if (kind == 2 && below(2) == 0) return coarse(text);
        if (kind == 1 || kind > 2)
            for (auto n = 1 + below(4); n > 0; --n) edit(text);
        return text;
    }

  private:
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
    template <class T>
    const T& pick(const std::vector<T>& all) {
        return all[below(all.size())];
    }
    std::string nasty() {
        static const std::vector<std::string> all{
            "1/0",
            "sqrt(-1)",
            "2^(10^9)",
            "1e999",
            "1e-999",
            "nan",
            "inf",
            "0.0",
            "-0",
            "1e5",
            "sqrt(2)",
            "sqrt(sqrt(3))",
            "sqrt(2)+sqrt(3)",
            "9^9^9",
            "0^0",
            "0^-1",
            "(((1)))",
            "",
            " ",
            "1 2",
            "x",
            "-",
            "1/3.0",
            "1e99999999999",
            "123456789012345678901234567890/987654321098765432109876543211",
            "(1+sqrt(5))/2",
            "1/(1-1)",
            "0.3333333333333333",
            "1/(sqrt(2)-sqrt(2))",
            "--1",
            "1/-2",
            "2^-0.5",
            "sqrt(1e-300)",
            "10^290",
            "10^310",
            "1/10^400"};
        switch (below(12)) {
            case 0:
                return std::string(below(6000), '(');
            case 1:
                return std::string(below(6000), '9');
            case 2:
                return "1" + std::string(below(300), '0') + "/" + std::string(1 + below(300), '7');
            default:
                return pick(all);
        }
    }
    json value() {
        switch (below(9)) {
            case 0:
                return nullptr;
            case 1:
                return json::array();
            case 2:
                return json::object();
            case 3:
                return static_cast<double>(random_()) / 1e19;
            case 4:
                return static_cast<std::int64_t>(random_());
            case 5:
                return below(2) == 0;
            case 6:
                return static_cast<int>(below(16));
            default:
                return nasty();
        }
    }
    // A change that leaves JSON: entries, rows, keys, claims.
    std::string restructured(const std::string& text) {
        json j = json::parse(text);
        for (auto n = 1 + below(3); n > 0; --n) {
            static const std::vector<std::string> keys{"A", "b", "c", "b_embedded", "claims", "name"};
            static const std::vector<std::string> claims{
                "order",      "embedded_order", "stage_order",
                "A_stable",   "L_stable",       "algebraically_stable",
                "symplectic", "symmetric",      "stiffly_accurate"};
            switch (below(8)) {
                case 0:
                    j.erase(pick(keys));
                    break;
                case 1:
                    j[pick(keys)] = value();
                    break;
                case 2:
                    if (j["claims"].is_object()) j["claims"][pick(claims)] = value();
                    break;
                case 3:
                    if (j["claims"].is_object()) j["claims"]["order"] = below(15);
                    break;
                case 4:
                    if (j["claims"].is_object()) j["claims"][pick(claims)] = below(2) == 0;
                    break;
                case 5:
                    if (j["b"].is_array() && !j["b"].empty()) j["b"][below(j["b"].size())] = value();
                    break;
                default:
                    if (j["A"].is_array() && !j["A"].empty()) {
                        auto& row = j["A"][below(j["A"].size())];
                        if (row.is_array() && !row.empty()) row[below(row.size())] = value();
                    }
            }
        }
        return j.dump();
    }
    // Every number as a decimal of one to eight digits, which may be too few to test anything.
    std::string coarse(const std::string& text) {
        json j = json::parse(text);
        const int digits = 1 + static_cast<int>(below(8));
        const auto round = [&](const auto& self, json& x) -> void {
            if (x.is_array())
                for (json& y : x) self(self, y);
            if (!x.is_string()) return;
            char number[64];
            const auto value = stagecraft::tableaux::read_entry(x.get<std::string>()).enclosure.middle();
            std::snprintf(number, sizeof number, "%.*g", digits, value.to<double>());
            x = number;
        };
        for (const char* key : {"A", "b", "c", "b_embedded"})
            if (j.contains(key)) round(round, j[key]);
        return j.dump();
    }
    // A change of bytes.
    void edit(std::string& text) {
        if (text.empty()) return;
        const std::size_t at = below(text.size());
        static const std::string symbols = "0123456789+-*/^().,:\"[]{}esqrt \n\\\xff";
        switch (below(8)) {
            case 0:
                text[at] = static_cast<char>(random_());
                break;
            case 1:
                text.erase(at, 1 + below(4));
                break;
            case 2:
                text.insert(at, 1, symbols[below(symbols.size())]);
                break;
            case 3:
                text[at] = symbols[below(symbols.size())];
                break;
            case 4:
                text.insert(at, text.substr(below(text.size()), below(60)));
                break;
            case 5:
                text.insert(at, nasty());
                break;
            case 6: {  // a digit, so that the file stays a tableau
                const auto digit = text.find_first_of("0123456789", at);
                if (digit != std::string::npos) text[digit] = static_cast<char>('0' + below(10));
                break;
            }
            default:
                if (below(4) == 0)
                    text.resize(at);
                else
                    std::swap(text[at], text[below(text.size())]);
        }
    }

    std::mt19937_64 random_;
    std::vector<std::string> seeds_;
};

/// Whether an order is called consistent without a bound for each condition of at most a tenth of its 1/gamma.
bool has_vacuous_order(const json& certificate) {
    for (const char* which : {"order", "embedded_order", "stage_order", "dense_order"}) {
        if (!certificate.contains(which) || certificate[which].value("verdict", "") != "consistent") continue;
        if (!certificate[which].contains("relative_bound")) return true;
        if (!(std::stod(certificate[which]["relative_bound"].get<std::string>()) <= 0.1)) return true;
    }
    if (certificate.contains("partners"))
        for (const json& partner : certificate["partners"])
            if (has_vacuous_order(partner)) return true;
    return false;
}

/// A number with a bound of its error, apart from the checker's own enclosures: middle and radius in long
/// double, whose own rounding is far below what decimals of a table leave open.
struct uncertain {
    long double middle = 0, radius = 0;
    uncertain() = default;
    uncertain(long double m, long double r = 0)
        : middle(m), radius(r) {}  // NOLINT: numbers are uncertain by 0
    friend uncertain operator+(const uncertain& x, const uncertain& y) {
        return {x.middle + y.middle, x.radius + y.radius};
    }
    friend uncertain operator*(const uncertain& x, const uncertain& y) {
        return {x.middle * y.middle,
                std::abs(x.middle) * y.radius + x.radius * std::abs(y.middle) + x.radius * y.radius};
    }
};

/// The largest bound of the order conditions up to `most`, in parts of the 1/gamma that each asks for.
long double largest_relative_bound(const stagecraft::tableau<uncertain>& t,
                                   const stagecraft::tableau<uncertain>::vector& weights, int most) {
    long double largest = 0;
    const auto always = [](const uncertain&, const uncertain&) { return true; };
    stagecraft::visit_trees(t, most, always, [&](const auto& phi, const uncertain& gamma, int) {
        uncertain sum;
        for (int i = 0; i < t.stages(); ++i) sum = sum + weights[i] * phi[i];
        largest = std::max(largest, sum.radius * gamma.middle);
        return true;
    });
    return largest;
}

/// Whether the orders that an accepted file of rounded numbers claims could have failed: each condition, looked
/// at once more by other means, has a bound below its 1/gamma.
bool could_have_failed(const std::string& text) {
    const auto method = stagecraft::tableaux::read_method_text(text);
    const auto* file = std::get_if<stagecraft::tableaux::tableau_file>(&method);
    if (!file || file->kind() <= stagecraft::tableaux::number_kind::quadratic) return true;
    const auto t =
        stagecraft::tableaux::to_tableau<uncertain>(*file, [](const stagecraft::tableaux::entry& e) {
            return uncertain(e.enclosure.middle().to<long double>(),
                             e.enclosure.width().to<long double>() / 2);
        });
    const auto sound = [&](const auto& weights, std::optional<int> order) {
        return largest_relative_bound(t, weights, std::min(order.value_or(0), 10)) < 1;
    };
    return sound(t.b, file->claims.order) && sound(t.b_embedded, file->claims.embedded_order);
}

}  // namespace

BOOST_AUTO_TEST_CASE(mutated_files_end_with_0_1_2_or_3_in_time) {
    const auto& suite = boost::unit_test::framework::master_test_suite();
    const long files = suite.argc > 1 ? std::stol(suite.argv[1]) : 300;
    mutator source(suite.argc > 2 ? std::stoull(suite.argv[2]) : 20240229);
    std::array<long, 4> ends{};
    double slowest = 0;
    for (long i = 0; i < files; ++i) {
        if (i > 0 && i % 1000 == 0)  // a long run says where it is
            std::cerr << i << " of " << files << " files, slowest " << slowest << " s\n";
        const std::string text = source.next();
        std::string out, err;
        const std::clock_t start = std::clock();
        int code = -1;
        try {
            code = checked::exit_code(text, i % 2 == 0, out, err);
        } catch (const std::exception& e) {
            BOOST_ERROR("file " << i << " ends with an exception: " << e.what() << "\n" << text);
            continue;
        }
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        slowest = std::max(slowest, seconds);
        if (seconds > 1)
            std::ofstream(STAGECRAFT_BINARY_DIR "/fuzz_slow_" + std::to_string(i) + ".json") << text;
        if (code < 0 || code > 3) {
            BOOST_ERROR("file " << i << " ends with " << code << "\n" << text);
            continue;
        }
        ++ends[static_cast<std::size_t>(code)];
        // Unusable input is explained in one line; a judgement is printed.
        const bool one_line = std::count(err.begin(), err.end(), '\n') == 1 && out.empty();
        if (code == 2 ? !one_line : out.empty() || !err.empty())
            BOOST_ERROR("file " << i << ": " << err << "\n" << text);
        if (code != 2 && i % 2 == 0 && !json::accept(out)) BOOST_ERROR("file " << i << ": not JSON: " << out);
        if (code == 0 && i % 2 == 0 && has_vacuous_order(json::parse(out)))
            BOOST_ERROR("file " << i << " is accepted though nothing could refute its order: " << out);
        if (code == 0 && !could_have_failed(text))
            BOOST_ERROR("file " << i << " is accepted with a bound above 1/gamma\n" << text);
    }
    std::cout << files << " files: " << ends[0] << " accepted, " << ends[1] << " refuted, " << ends[2]
              << " unusable, " << ends[3] << " inconclusive; slowest " << slowest << " s of processor time\n";
    BOOST_TEST(ends[2] > 0);
    BOOST_TEST(ends[0] + ends[1] > 0);
    BOOST_TEST(slowest < 10,
               "a file took " << slowest << " s");  // a hang; the bar of 1 s is for idle machines
}
