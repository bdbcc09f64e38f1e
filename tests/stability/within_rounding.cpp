// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE within_rounding
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <random>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/theory/judging/enclosed_report.hpp>
#include <stagecraft/theory/judging/enclosed_ssp.hpp>
#include <stagecraft/theory/judging/enclosed_stability.hpp>
#include <stagecraft/theory/judging/find_suspects.hpp>
#include <stagecraft/theory/stability/enclosed_signs.hpp>
#include <stagecraft/theory/stability/sector_stability.hpp>
#include <stagecraft/theory/stability/ssp.hpp>

#include "methods.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;
using methods::rational;
using tableaux::ball;

namespace {

/// A tableau printed to `digits` decimals, zeros as they are: its enclosures, and others that print alike.
struct printed {
    tableau<rational> middle;
    rational half_unit;
    subject<ball> enclosed;

    printed(const tableau<rational>& exact, int digits) : middle(exact), half_unit(1, 2) {
        for (int k = 0; k < digits; ++k) half_unit = half_unit / rational(10);
        const rational unit = half_unit + half_unit;
        each(middle, [&](rational& x) { x = rational(floor(x / unit + rational(1, 2))) * unit; });
        enclosed = {{}, true, true, true};
        auto& t = enclosed.t;
        const int s = exact.stages();
        t.A.resize(s, s);
        t.b.resize(s);
        t.c.resize(s);
        const auto around = [&](const rational& x) {
            return x == 0 ? ball(0) : to_ball(tableaux::range{x - half_unit, x + half_unit});
        };
        for (int i = 0; i < s; ++i) {
            t.b(i) = around(middle.b(i));
            t.c(i) = around(middle.c(i));
            for (int j = 0; j < s; ++j) {
                t.A(i, j) = around(middle.A(i, j));
                const bool zero = middle.A(i, j) == 0;
                enclosed.strictly_lower = enclosed.strictly_lower && (j < i || zero);
                enclosed.lower = enclosed.lower && (j <= i || zero);
            }
        }
    }
    template <class Change>
    static void each(tableau<rational>& t, Change change) {
        for (auto* part : {&t.b, &t.c})
            for (Eigen::Index i = 0; i < part->size(); ++i) change((*part)(i));
        for (Eigen::Index i = 0; i < t.A.size(); ++i) change(t.A.data()[i]);
    }
    tableau<rational> another(std::mt19937& random) const {
        tableau<rational> t = middle;
        each(t, [&](rational& x) {
            if (x != 0) x = x + half_unit * rational(static_cast<int>(random() % 2001) - 1000, 1000);
        });
        return t;
    }
};

struct ends {
    rational low, high;
};

/// The numbers in "between 79.69485067 and 79.69485110"; fails where there are none.
ends ends_in(const claim& c) {
    const auto& reason = c.verdict.reason();
    const auto at = reason.find("between "), then = reason.find(" and ", at);
    BOOST_REQUIRE_MESSAGE(at != std::string::npos, c.statement + ": " + c.verdict.text());
    const auto number = [&](std::size_t from) {
        return tableaux::read_entry(reason.substr(from, reason.find(' ', from) - from),
                                    tableaux::exact_decimals::all())
            .exact->rational_part();
    };
    return {number(at + 8), number(then + 5)};
}

tableau<rational> collocation(const std::vector<rational>& nodes) {
    const auto t = tableaux::exact_tableau(tableaux::nodal_polynomial::from_nodes(nodes),
                                           tableaux::construction::collocation);
    tableau<rational> r;
    r.A = t->A.unaryExpr([](const tableaux::quadratic& x) { return x.rational_part(); });
    r.b = t->b.unaryExpr([](const tableaux::quadratic& x) { return x.rational_part(); });
    r.c = t->c.unaryExpr([](const tableaux::quadratic& x) { return x.rational_part(); });
    return r;
}

/// A cosine as a rational, moved by a little to be on the safe side.
rational cosine(const rational& degrees, double sign) {
    return rational(
        static_cast<long long>(std::cos(degrees.to<double>() * std::acos(-1.0) / 180) * 1e15 + sign * 2),
        1000000000000000LL);
}

subject<ball> read(const std::string& name) {
    return theory::detail::enclosed_subject(tableaux::read_tableau_file(
        std::string(STAGECRAFT_SOURCE_DIR) + "/tableaux/catalogue/" + name + ".json"));
}

std::string standing_of(const verdict& v) { return std::string(name(v.standing())); }

}  // namespace

BOOST_AUTO_TEST_CASE(signs_on_the_half_line_are_those_of_every_polynomial) {
    const auto signs = [](std::vector<ball> p) {
        std::string text;
        for (const auto& piece : signs_on_half_line(std::move(p)))
            text += piece.sign > 0 ? "+" : piece.sign < 0 ? "-" : "0";
        return text;
    };
    const ball noise = ball(0).widened(1e-12L);
    BOOST_TEST(signs({-6, 11, -6, 1}) == "-0+0-0+");  // (x - 1)(x - 2)(x - 3)
    BOOST_TEST(signs({1, 0, 1}) == "+");
    BOOST_TEST(signs({1, -2, 1}) == "+0+");  // touches 0
    BOOST_TEST(signs({1, -2, ball(1) + noise}) == "+0+");
    BOOST_TEST(signs({noise, 0, 1}) == "0+");  // open next to 0
    BOOST_TEST(signs({1, 0, noise}) == "+0");  // and at infinity
    BOOST_TEST(signs({0, 0, -1}) == "-");
    const auto pieces = signs_on_half_line({-2, 0, 1});
    BOOST_TEST(std::abs(pieces[1].from - std::sqrt(2.0L)) < 1e-12L);
    BOOST_TEST(std::abs(pieces[1].to - std::sqrt(2.0L)) < 1e-12L);
}

BOOST_AUTO_TEST_CASE(sectors_hold_for_every_table_within_the_rounding) {
    using nodes_of = std::vector<rational>;
    for (const auto& nodes : {nodes_of{{1, 4}, {1, 2}, 1}, nodes_of{{1, 5}, {2, 5}, {3, 5}, 1}})
        for (const int digits : {6, 11}) {
            const printed table(collocation(nodes), digits);
            const auto f = stability_function_of(table.enclosed);
            const auto [low, high] = ends_in(enclosed_sector(table.enclosed, f));
            BOOST_TEST((high - low).to<double>() < 1e5 * std::pow(10.0, -digits));
            const auto at_infinity = *value_at_infinity(table.enclosed, f);
            std::mt19937 random(7);
            for (int k = 0; k < 50; ++k) {
                const auto r = theory::stability_function_of(table.another(random));
                BOOST_TEST(stable_in_sector(r, cosine(low, 1)));
                BOOST_TEST(!stable_in_sector(r, cosine(high, -1)));
                BOOST_TEST(at_infinity.contains(*r.at_infinity()));
            }
        }
}

BOOST_AUTO_TEST_CASE(intervals_hold_for_every_table_within_the_rounding) {
    for (const auto& [exact, digits] :
         {std::pair(methods::rk4(), 5), std::pair(methods::rk4(), 12), std::pair(methods::kutta3(), 8)}) {
        const printed table(exact, digits);
        const auto f = stability_function_of(table.enclosed);
        const auto [low, high] = ends_in(enclosed_real_interval(f));
        const auto on_axis = ends_in(enclosed_imaginary_interval(f));
        BOOST_TEST(standing_of(enclosed_imaginary_interval(f).verdict) == "consistent");  // by the order of R
        std::mt19937 random(11);
        for (int k = 0; k < 50; ++k) {
            const auto r = theory::stability_function_of(table.another(random));
            const auto real = real_stability_interval(r, 80);
            BOOST_TEST((low <= real.low && real.high <= high));
            const auto e = e_polynomial(r);  // what rounding does next to 0 is not looked at
            BOOST_TEST((tableaux::sturm_chain<rational>(e).count(rational(1, 2), on_axis.low) == 0));
            BOOST_TEST((e(on_axis.low) > 0 && e(on_axis.high) < 0));
        }
    }
}

BOOST_AUTO_TEST_CASE(the_ssp_radius_holds_for_every_table_within_the_rounding) {
    for (const auto& [exact, digits] : {std::pair(methods::ssp33(), 9), std::pair(methods::ssp104(), 12)}) {
        const printed table(exact, digits);
        const auto c = enclosed_ssp_radius(table.enclosed);
        const auto [low, high] = ends_in(c);
        BOOST_TEST(standing_of(c.verdict) == "proved");
        std::mt19937 random(13);
        for (int k = 0; k < (exact.stages() < 5 ? 50 : 2); ++k) {
            const auto radius = ssp_radius(table.another(random), 70);
            BOOST_TEST((low <= radius.low && radius.high <= high));
        }
    }
}

// Imaginary intervals to six digits by roots of |R(iy)|^2 - 1 in multiple precision, of the digits as they are printed.
BOOST_AUTO_TEST_CASE(published_tables_have_the_intervals_of_their_digits) {
    for (const auto& [name, end] :
         {std::pair("dormand_prince_8_5_3", 5.96036), std::pair("verner_6_5_efficient", 2.58420),
          std::pair("tsitouras_5_4", 0.47798)}) {
        const auto c = enclosed_imaginary_interval(stability_function_of(read(name)));
        const auto [low, high] = ends_in(c);
        BOOST_TEST(std::abs(low.to<double>() - end) < 5e-6);
        BOOST_TEST(std::abs(high.to<double>() - end) < 5e-6);
        BOOST_TEST(standing_of(c.verdict) == "consistent");
    }
    const auto gauss = read("gauss_4");
    BOOST_TEST(enclosed_limit(gauss, stability_function_of(gauss)).statement == "R(infinity) = 1");
    BOOST_TEST(standing_of(rounded_a_stable(gauss)) == "consistent");
    BOOST_TEST(standing_of(rounded_l_stable(read("kvaerno_5_4"))) == "consistent");
    BOOST_TEST(standing_of(rounded_a_stable(read("tsitouras_5_4"))) == "refuted");
    // Order 5: the first term that is left shrinks, the next one turns.
    const auto claims = enclosed_stability_report(read("tsitouras_5_4")).front().claims;
    for (const char* order : {"dispersion order 6", "dissipation order 5"}) {
        const auto c =
            std::find_if(claims.begin(), claims.end(), [&](const claim& x) { return x.statement == order; });
        BOOST_REQUIRE(c != claims.end());
        BOOST_TEST(standing_of(c->verdict) == "consistent");
    }
}

BOOST_AUTO_TEST_CASE(what_few_digits_leave_open_is_not_decided) {
    // The theta method: R(infinity) = 1 - 1/theta.
    const auto theta = [](int hundredths, int digits) {
        auto t = methods::make<rational>({{rational(hundredths, 100)}}, {1}, {rational(hundredths, 100)});
        printed table(t, digits);
        table.enclosed.t.b(0) = ball(1);
        return table.enclosed;
    };
    const auto index_1 = [](const subject<ball>& s) {
        return enclosed_stability_report(s).back().claims.front();
    };
    BOOST_TEST(index_1(theta(52, 6)).statement == "index 1: y O(h^1), z O(h^1)");
    BOOST_TEST(standing_of(index_1(theta(50, 2)).verdict) == "inconclusive");  // |R(inf)| = 1 is among them
    BOOST_TEST(index_1(theta(50, 9)).statement == "index 1: y O(h^2), z O(h^2)");
    // With an explicit first stage R(infinity) = -1/2 and the inverse of the rest of A are enclosed.
    const auto left = methods::make<rational>({{0, 0}, {rational(1, 3), rational(2, 3)}},
                                              {rational(1, 3), rational(2, 3)}, {0, 1});
    const auto exact = stability_report(left)[2].claims;
    const auto digits = enclosed_stability_report(printed(left, 12).enclosed).back().claims;
    for (const std::size_t index : {0U, 1U}) {
        BOOST_TEST(digits[index].statement == exact[index].statement);
        BOOST_TEST(standing_of(digits[index].verdict) == "consistent");
    }
    BOOST_TEST(standing_of(rounded_a_stable(theta(50, 2))) == "inconclusive");
    BOOST_TEST(standing_of(rounded_a_stable(theta(52, 6))) == "proved");
    BOOST_TEST(standing_of(rounded_a_stable(theta(48, 6))) == "refuted");
    // One stage to two digits: alpha may be 90 degrees or none.
    const auto c = enclosed_sector(theta(50, 2), stability_function_of(theta(50, 2)));
    BOOST_TEST(standing_of(c.verdict) == "inconclusive");
    BOOST_TEST(c.verdict.text().starts_with("inconclusive: not decided: "));
}
