// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE partitioned
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/theory/trees/coloured_trees.hpp>
#include <string>
#include <vector>
#include "../checked.hpp"

// Methods of several tableaux: coloured trees, the published pairs, and what is wrong with a pair.

using namespace stagecraft;
using checked::certify_method;
using tableaux::coupling;
namespace fs = std::filesystem;

namespace {

const std::string folder = STAGECRAFT_SOURCE_DIR "/tableaux/pairs";

std::vector<std::string> published() {
    std::vector<std::string> all;
    for (const auto& item : fs::directory_iterator(folder)) all.push_back(item.path().string());
    std::sort(all.begin(), all.end());
    return all;
}

tableaux::partitioned_file read(const std::string& path) {
    return std::get<tableaux::partitioned_file>(tableaux::read_method_file(path));
}

std::vector<int> trees_by_order(coupling c, bool uses_velocity, int partners, int root, int most) {
    const tree_table table(most, partners, theory::admits_coupling{c, uses_velocity});
    std::vector<int> count(static_cast<std::size_t>(most), 0);
    for (const tree_row& t : table.view().rows)
        if (root < 0 || t.colour == root) ++count[static_cast<std::size_t>(t.order - 1)];
    return count;
}

double number(const tableaux::entry& e) { return e.enclosure.middle().to<double>(); }

/// Sum of coefficients times slopes.
double combined(const std::vector<tableaux::entry>& row, const std::vector<double>& slopes) {
    double sum = 0;
    for (std::size_t j = 0; j < slopes.size(); ++j) sum += number(row[j]) * slopes[j];
    return sum;
}

/// Error at t = 1 of n steps for y' = y^2/2 - y, y(0) = 1, with y^2/2 by the first tableau and -y by the second.
double additive_error(const tableaux::partitioned_file& m, int n) {
    const double h = 1.0 / n;
    const auto &e = m.partners[0], &im = m.partners[1];
    double y = 1;
    for (int step = 0; step < n; ++step) {
        std::vector<double> f, g;
        for (std::size_t i = 0; i < im.b.size(); ++i) {
            const double known = y + h * combined(e.A[i], f) + h * combined(im.A[i], g);
            const double stage = known / (1 + h * number(im.A[i][i]));
            f.push_back(stage * stage / 2);
            g.push_back(-stage);
        }
        y += h * combined(e.b, f) + h * combined(im.b, g);
    }
    return std::abs(y - 2 / (1 + std::exp(1.0)));
}

/// Error at t = 1 of n steps for q'' = -q with q(0) = 0, p(0) = 1 by an explicit Nystrom method, or for
/// q'' = -sin q compared with twice the steps.
double nystrom_position(const tableaux::partitioned_file& m, int n) {
    const double h = 1.0 / n;
    const auto &bar = m.partners[0], &v = m.partners[1];
    double q = 0.3, p = 1;
    for (int step = 0; step < n; ++step) {
        std::vector<double> f;
        for (std::size_t i = 0; i < v.b.size(); ++i) {
            const double at = q + number(v.c[i]) * h * p + h * h * combined(bar.A[i], f);
            f.push_back(-std::sin(at));
        }
        q += h * p + h * h * combined(bar.b, f);
        p += h * combined(v.b, f);
    }
    return q;
}

/// The same for a separable pair whose stages follow one another.
double separable_position(const tableaux::partitioned_file& m, int n) {
    const double h = 1.0 / n;
    const auto &position = m.partners[0], &momentum = m.partners[1];
    double q = 0.3, p = 1;
    for (int step = 0; step < n; ++step) {
        std::vector<double> velocity, force;
        for (std::size_t i = 0; i < position.b.size(); ++i) {
            force.push_back(-std::sin(q + h * combined(position.A[i], velocity)));
            velocity.push_back(p + h * combined(momentum.A[i], force));
        }
        q += h * combined(position.b, velocity);
        p += h * combined(momentum.b, force);
    }
    return q;
}

/// "/partners/1/A/3/2" as suspects call it: "implicit part: A[4][3]".
std::string entry_name(const std::string& at, const nlohmann::ordered_json& method) {
    std::vector<std::string> parts;
    for (std::size_t i = 1; i <= at.size();) {
        const auto end = std::min(at.find('/', i), at.size());
        parts.push_back(at.substr(i, end - i));
        i = end + 1;
    }
    std::string text;
    if (parts.front() == "partners") {
        const auto& partner = method["partners"][std::stoul(parts[1])];
        text = partner.value("name", "tableau " + std::to_string(std::stoi(parts[1]) + 1)) + ": ";
        parts.erase(parts.begin(), parts.begin() + 2);
    }
    text += parts.front();
    for (std::size_t k = 1; k < parts.size(); ++k)
        text += "[" + std::to_string(std::stoi(parts[k]) + 1) + "]";
    return text;
}

double order_seen(const std::function<double(int)>& error, int n) {
    return std::log2(error(n) / error(2 * n));
}

}  // namespace

BOOST_AUTO_TEST_CASE(coloured_trees_are_as_many_as_published) {
    // OEIS A000151; Hairer-Norsett-Wanner I, table II.14.1 (SN-trees) and II.14 (N-trees).
    BOOST_TEST(trees_by_order(coupling::additive, false, 2, -1, 6) ==
               (std::vector<int>{2, 4, 14, 52, 214, 916}));
    BOOST_TEST(trees_by_order(coupling::nystrom, false, 2, 1, 10) ==
               (std::vector<int>{1, 1, 2, 3, 6, 10, 20, 36, 72, 137}));
    BOOST_TEST(trees_by_order(coupling::nystrom, true, 2, 1, 4) == (std::vector<int>{1, 2, 6, 18}));
    // Rooted trees have one alternating colouring for each colour of the root.
    BOOST_TEST(trees_by_order(coupling::separable, false, 2, 0, 8) ==
               (std::vector<int>{1, 1, 2, 4, 9, 20, 48, 115}));
}

BOOST_AUTO_TEST_CASE(every_published_pair_has_the_order_that_is_claimed) {
    int pairs = 0;
    for (const std::string& path : published()) BOOST_TEST_CONTEXT(path) {
            const auto file = read(path);
            const auto c = certify_method(tableaux::text_of_file(path), folder);
            BOOST_TEST(c.exit_code() == 0);
            BOOST_REQUIRE(file.claims.order);
            BOOST_TEST(*c.find("order")->value == *file.claims.order);
            if (file.kind() <= tableaux::number_kind::quadratic)
                BOOST_TEST(c.find("order")->judgement->is_proved());
            // What is printed is read again, with the same outcome.
            BOOST_TEST(certify_method(theory::json_text(c)).exit_code() == 0);
            ++pairs;
        }
    BOOST_TEST(pairs == 35);
}

BOOST_AUTO_TEST_CASE(steps_converge_with_the_order_that_the_coloured_trees_give) {
    for (const std::string& path : published()) BOOST_TEST_CONTEXT(path) {
            const auto m = read(path);
            const int p = *m.claims.order;
            double seen = 0;
            if (m.coupling == coupling::additive) {
                seen = order_seen([&](int n) { return additive_error(m, n); }, p > 3 ? 8 : p > 2 ? 32 : 256);
            } else if (m.coupling == coupling::separable) {
                seen = order_seen(
                    [&](int n) { return std::abs(separable_position(m, n) - separable_position(m, 512)); },
                    16);
            } else if (m.coupling == coupling::nystrom && !m.uses_velocity) {
                seen = order_seen(
                    [&](int n) { return std::abs(nystrom_position(m, n) - nystrom_position(m, 256)); },
                    p > 4 ? 4 : 8);
            } else {
                continue;
            }
            BOOST_TEST(seen > p - 0.35);
            BOOST_TEST(seen < p + 1.35);
        }
}

BOOST_AUTO_TEST_CASE(who_fails_is_named) {
    // The entry 3/4 of BPR(3,5,3) as some codes have it. It stands in a stage that the explicit part does not
    // use, so each part is right by itself.
    std::string text = tableaux::text_of_file(folder + "/bpr_3_5_3.json");
    const std::string right = R"(["1/4", "0", "3/4", "0", "0"])";
    text.replace(text.find(right), right.size(), R"(["1/4", "0", "3/5", "0", "0"])");
    const auto wrong = certify_method(text);
    BOOST_TEST(wrong.exit_code() == 1);
    BOOST_TEST(*wrong.find("order")->value == 1);
    BOOST_TEST(wrong.notes.front() == "order 2: only the coupling of explicit part and implicit part fails");
    for (const auto& p : wrong.partners) BOOST_TEST(!p.find("order")->judgement->is_refuted());
    BOOST_REQUIRE(!wrong.suspects.empty());
    BOOST_TEST(wrong.suspects.front().entry == "explicit part: A[4][3]");
    BOOST_TEST(wrong.suspects.front().written == "3/5");
    BOOST_TEST(wrong.suspects.front().suggest == "3/4");

    // Explicit midpoint rule and trapezoidal rule: each has order 2, together 1.
    const auto coupled = certify_method(R"({"form": "additive", "partners": [
        {"name": "midpoint", "A": [["0","0"],["1/2","0"]], "b": ["0","1"]},
        {"name": "trapezoidal", "A": [["0","0"],["1/2","1/2"]], "b": ["1/2","1/2"]}],
        "claims": {"order": 2}})");
    BOOST_TEST(coupled.exit_code() == 1);
    BOOST_TEST(*coupled.find("order")->value == 1);
    BOOST_TEST(coupled.notes.front() == "order 2: only the coupling of midpoint and trapezoidal fails");
    BOOST_TEST(coupled.failures.front().condition == "dot(b, c_hat) == 1/2");
    BOOST_TEST(coupled.failures.front().tree == "[tau_hat]");
    BOOST_TEST(coupled.failures.front().residual == "1/2");
    for (const auto& p : coupled.partners) BOOST_TEST((p.overall() == theory::standing::proved));

    // Where no order is claimed there is no condition to solve for an entry, and something else is wrong.
    const auto unstable = certify_method(R"({"form": "additive", "partners": [
        {"A": [["0","0"],["1","0"]], "b": ["1/2","1/2"]},
        {"A": [["0","0"],["1/2","1/2"]], "b": ["1/2","1/2"], "claims": {"L_stable": true}}],
        "claims": {"order": 0}})");
    BOOST_TEST(unstable.exit_code() == 1);
    BOOST_TEST(unstable.suspects.empty());

    // A Nystrom method wrong in the position only.
    text = tableaux::text_of_file(folder + "/nystrom_5.json");
    text.replace(text.find("25/84"), 5, "25/48");
    const auto nystrom = certify_method(text);
    BOOST_TEST(nystrom.exit_code() == 1);
    BOOST_TEST(nystrom.notes.front() == "order 2: the formula for y fails by itself");
    BOOST_REQUIRE(!nystrom.suspects.empty());
    BOOST_TEST(nystrom.suspects.front().entry == "b_bar[2]");
    BOOST_TEST(nystrom.suspects.front().suggest == "25/84");

    // The row of a neighbour: several entries are wrong, and the row is named.
    text = tableaux::text_of_file(folder + "/nystrom_5.json");
    const std::string row = R"("3/10", "-2/35", "9/35")";
    text.replace(text.find(row), row.size(), R"("-1/27", "7/27", "0")");
    const auto repeated = certify_method(text);
    BOOST_TEST(repeated.exit_code() == 1);
    BOOST_TEST(repeated.suspects.empty());
    BOOST_TEST(repeated.suspects_note == "row [4] of A_bar alone does not sum to c^2/2; it repeats row [3]");
}

BOOST_AUTO_TEST_CASE(a_nystrom_method_may_claim_order_13_unless_f_depends_on_the_velocity) {
    std::string text = tableaux::text_of_file(folder + "/nystrom_5.json");
    const auto claim = [&](const char* order) {
        std::string other = text;
        return other.replace(other.find("\"order\": 5"), 10, std::string("\"order\": ") + order);
    };
    const auto file = std::get<tableaux::partitioned_file>(tableaux::read_method_text(claim("13")));
    BOOST_TEST(*file.claims.order == 13);
    BOOST_CHECK_EXCEPTION(
        tableaux::read_method_text(claim("14")), tableaux::unusable_input, [](const auto& e) {
            return std::string(e.what()).find("claims.order: must be at most 13") != std::string::npos;
        });
    text = tableaux::text_of_file(folder + "/nystrom_4.json");
    BOOST_REQUIRE(text.find("\"A\"") != std::string::npos);
    text.replace(text.find("\"order\": 4"), 10, "\"order\": 5");
    BOOST_CHECK_EXCEPTION(
        tableaux::read_method_text(claim("11")), tableaux::unusable_input, [](const auto& e) {
            return std::string(e.what()).find("claims.order: must be at most 10") != std::string::npos;
        });
}

BOOST_AUTO_TEST_CASE(a_misprint_in_one_tableau_of_a_pair_is_refuted_and_named) {
    // Every 21st entry of the published pairs, a thousandth more.
    int tried = 0, refuted = 0, named = 0, turn = 0;
    for (const std::string& path : published()) {
        const auto good = certify_method(tableaux::text_of_file(path), folder).tableau;
        const auto entries = good.flatten();
        for (const auto& [at, entry] : entries.items()) {
            const bool counts = at.find("/A") != std::string::npos || at.find("/b") != std::string::npos;
            if (!counts || !entry.is_string() || entry == "0" || turn++ % 21 != 0) continue;
            auto table = good;
            table[nlohmann::ordered_json::json_pointer(at)] = "(" + entry.get<std::string>() + ")*1001/1000";
            const auto c = certify_method(table.dump());
            const auto names_it = [&](const theory::suspect& x) { return x.entry == entry_name(at, good); };
            ++tried;
            refuted += c.exit_code() == 1;
            named += std::any_of(c.suspects.begin(), c.suspects.end(), names_it);
        }
    }
    BOOST_TEST(tried >= 30);
    BOOST_TEST(refuted == tried);
    BOOST_TEST(10 * named >= 9 * tried);
}

BOOST_AUTO_TEST_CASE(a_node_that_is_no_row_sum_of_its_tableau_is_named) {
    // Midpoint rules on common nodes; the conditions to order 2 do not look at c.
    const auto pair = [](const std::string& node) {
        return certify_method(R"({"form":"additive","partners":[
            {"name":"explicit","c":["0",")" +
                              node + R"("],"A":[["0","0"],["1/2","0"]],"b":["0","1"]},
            {"name":"implicit","c":["0","1/2"],"A":[["0","0"],["0","1/2"]],"b":["0","1"]}],
            "claims":{"order":2}})");
    };
    BOOST_TEST(pair("1/2").exit_code() == 0);
    const auto c = pair("1/7");
    BOOST_TEST(c.exit_code() == 1);
    BOOST_REQUIRE(!c.suspects.empty());
    BOOST_TEST(c.suspects[0].entry == "explicit: c[2]");
    BOOST_TEST(c.suspects[0].suggest == "1/2");
}

BOOST_AUTO_TEST_CASE(the_symplectic_pairs_are_those_of_the_books) {
    const auto verdict_of = [](const char* name) {
        return certify_method(tableaux::text_of_file(folder + "/" + name + ".json"), folder)
            .find("symplectic")
            ->truth->standing();
    };
    for (const char* name : {"symplectic_euler", "stoermer_verlet", "lobatto_iiia_iiib_3",
                             "lobatto_iiia_iiib_4", "ruth_3", "mclachlan_4", "stoermer_verlet_nystrom"})
        BOOST_TEST((verdict_of(name) == theory::standing::proved), name);
    for (const char* name : {"nystrom_4", "nystrom_5", "dormand_prince_rkn_6_4"})
        BOOST_TEST((verdict_of(name) == theory::standing::refuted), name);
    // The same method twice, not symplectic by itself.
    const std::string kutta = R"({"A":[["0","0"],["1","0"]],"b":["1/2","1/2"]})";
    const auto twice = certify_method(R"({"form":"partitioned","partners":[)" + kutta + "," + kutta +
                                      R"(],"claims":{"order":2,"symplectic":true}})");
    BOOST_TEST(twice.exit_code() == 1);
}

BOOST_AUTO_TEST_CASE(pairs_are_symmetric_or_not) {
    const auto verdict_of = [](const char* name) {
        return certify_method(tableaux::text_of_file(folder + "/" + name + ".json"), folder)
            .find("symmetric")
            ->truth->standing();
    };
    for (const char* name : {"stoermer_verlet", "lobatto_iiia_iiib_3", "lobatto_iiia_iiib_4", "mclachlan_4",
                             "stoermer_verlet_nystrom"})
        BOOST_TEST((verdict_of(name) == theory::standing::proved), name);
    for (const char* name : {"ruth_3", "symplectic_euler", "nystrom_5"})  // odd orders
        BOOST_TEST((verdict_of(name) == theory::standing::refuted), name);
    BOOST_TEST((verdict_of("nystrom_4") == theory::standing::inconclusive));
    // Claims: a kick of the middle changed.
    const auto claimed = [](const std::string& kick) {
        return certify_method(
                   R"({"form":"nystrom","c":["0","1"],"A_bar":[["0","0"],["1/2","0"]],"b_bar":[")" + kick +
                   R"(","0"],"b":["1/2","1/2"],"claims":{"order":2,"symmetric":true}})")
            .overall();
    };
    BOOST_TEST((claimed("1/2") == theory::standing::proved));
    BOOST_TEST((claimed("1/3") == theory::standing::refuted));  // of order 1
}

// Those of Nystrom methods are what eigenvalues say at 40 digits (mpmath); Verlet's is (h omega)^2 < 4.
BOOST_AUTO_TEST_CASE(intervals_on_oscillations_and_of_monotonicity_are_those_of_closed_forms) {
    const auto said = [](const char* file, const char* name) {
        const auto c = certify_method(tableaux::text_of_file(folder + "/" + file + ".json"), folder);
        const auto* f = c.find(name);
        return f ? f->truth->text() : "";
    };
    BOOST_TEST(said("stoermer_verlet_nystrom", "periodicity_interval") ==
               "proved: (h omega)^2 up to 4, exact");
    BOOST_TEST(
        said("nystrom_4", "stability_interval").starts_with("proved: (h omega)^2 up to 6.690079991706"));
    BOOST_TEST(said("dormand_prince_rkn_4_3", "stability_interval")
                   .starts_with("proved: (h omega)^2 up to 14.196473021826"));
    BOOST_TEST(
        said("dormand_prince_rkn_5_4", "stability_interval").starts_with("refuted: oscillations grow"));
    const auto pair = [](const std::string& one) {
        return certify_method(R"({"form":"additive","partners":[)" + one + "," + one + "]}");
    };
    // Twice the same method is that method with f = f_1 + f_2: half of its SSP coefficient for each, and M in blocks.
    const auto ssp = pair(R"({"A":[[0,0,0],[1,0,0],["1/4","1/4",0]],"b":["1/6","1/6","2/3"]})");
    BOOST_TEST(
        ssp.find("ssp_coefficient")->truth->text().starts_with("proved: common to all parts: 1/2, exact"));
    BOOST_TEST((ssp.find("algebraically_stable")->truth->is_refuted()));
    const auto midpoint = pair(R"({"A":[["1/2"]],"b":[1]})");
    BOOST_TEST(midpoint.find("algebraically_stable")->truth->text() ==
               "proved: b >= 0, M of all together has 0 positive and 2 zero pivots");
}

BOOST_AUTO_TEST_CASE(what_is_wrong_with_a_file_is_said_with_line_and_entry) {
    const auto complaint = [](const std::string& text) -> std::string {
        try {
            tableaux::read_method_text(text);
            return "accepted";
        } catch (const tableaux::unusable_input& e) {
            return e.what();
        }
    };
    const std::string one = R"({"A":[["1"]],"b":["1"]})";
    BOOST_TEST(complaint("{\"form\":\"additive\",\n\"partners\":[" + one +
                         ",\n{\"A\":[[\"1/0\"]],\"b\":[\"1\"]}]}") ==
               "line 3, partners[2].A[1][1]: '1/0' division by zero");
    BOOST_TEST(complaint("{\"form\":\"other\",\"partners\":[]}") ==
               "line 1, form: 'other', allowed: additive, partitioned, separable, nystrom, rosenbrock, "
               "shu-osher, 2N, 2S, "
               "3S*");
    BOOST_TEST(complaint("{\"form\":\"additive\",\"partners\":[" + one + "]}") ==
               "line 1, partners: must be a list of 2 to 4 tableaux or names of files");
    BOOST_TEST(complaint("{\"form\":\"additive\",\"partners\":[" + one +
                         ",{\"A\":[[\"0\",\"0\"],[\"0\",\"0\"]],\"b\":[\"1\",\"0\"]}]}") ==
               "line 1, partners[2]: has another number of stages than the first");
    BOOST_TEST(complaint("{\"form\":\"nystrom\",\"b\":[\"1\"]}") == "line 1: c is missing");
    BOOST_TEST(complaint("{\"form\":\"additive\",\"partners\":[" + one + "," + one +
                         "],\"claims\":{\"A_stable\":true}}")
                   .find("belongs to one of the tableaux") != std::string::npos);
    BOOST_TEST(complaint("{\"form\":\"additive\",\"partners\":[" + one + ",\"no_such_file.json\"]}")
                   .find("line 1, partners[2]: cannot read") == 0U);
}
