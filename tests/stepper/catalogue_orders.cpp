// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE catalogue_orders
#include "catalogue.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/integrate.hpp>
#include <string>

// Every method of the catalogue through the stepper.

namespace sc = stagecraft;
using namespace catalogue_runs;

namespace {

fifty error(const sc::tableau<fifty>& m, int steps) {
    const fifty tiny("1e-40");
    const auto r = sc::integrate(m, hyperbola{}, vector(fifty(1), fifty(1)), 0, fifty(1) / 2,
                                 {.rtol = tiny, .atol = tiny, .fixed_step = fifty(1) / (2 * steps)});
    BOOST_TEST(r.ok());
    return (r.y - vector(fifty(2) / 3, fifty(4) / 9)).norm();
}

double order(const sc::tableau<fifty>& m, int steps) {
    return std::log2(static_cast<double>(error(m, steps) / error(m, 2 * steps)));
}

}  // namespace

BOOST_AUTO_TEST_CASE(order_conditions_in_doubles_give_the_claimed_orders) {
    int embedded = 0;
    for (const auto& [name, file] : catalogue()) BOOST_TEST_CONTEXT(name) {
            auto m = sc::tableaux::rounded<double>(file);
            m.facts = {};
            // In doubles trees are looked at up to order 8; collocation tells of more.
            const int claimed = file.claims.order.value(), found = sc::classical_order(m);
            BOOST_TEST((found == claimed || (found == sc::largest_tree_order && found < claimed)));
            if (!file.claims.embedded_order) continue;
            ++embedded;
            BOOST_TEST(sc::order_by_trees(m, m.b_embedded, sc::largest_tree_order) ==
                       *file.claims.embedded_order);
        }
    BOOST_TEST(catalogue().size() > 100U);
    BOOST_TEST(embedded > 40);
    // a weight that is wrong in the ninth digit is no rounding
    auto m = sc::tableaux::rounded<double>(catalogue().at("dormand_prince_5_4"));
    m.facts = {};
    m.A(3, 1) += 1e-6;
    m.A(3, 0) -= 1e-6;
    BOOST_TEST(sc::classical_order(m) < 5);
}

BOOST_AUTO_TEST_CASE(equal_steps_show_the_claimed_order_of_every_method_at_50_digits) {
    int short_decimals = 0;
    for (const auto& [name, file] : catalogue()) BOOST_TEST_CONTEXT(name) {
            const auto m = sc::tableaux::rounded<fifty>(file);
            double seen = 0;
            const auto there = [&] { return std::abs(seen - m.facts.order) < 0.05; };
            for (int steps = 32; !there() && steps <= 256; steps *= 8) seen = order(m, steps);
            if (!there() && file.kind() == sc::tableaux::number_kind::rounded) {
                // seventeen decimals end where the asymptotic behaviour begins: no less than the order before
                ++short_decimals;
                BOOST_TEST(order(m, 4) > m.facts.order - 0.25);
                continue;
            }
            if (!there()) seen = order(m, 2048);
            BOOST_TEST(there(), "order " << seen);
        }
    BOOST_TEST(short_decimals <= 4);  // of all, so that no more hide behind them
}

BOOST_AUTO_TEST_CASE(entries_are_rounded_once) {
    const auto& file = catalogue().at("alexander_2");
    const auto m = sc::tableaux::rounded<double>(file);
    BOOST_TEST(m.b[0] == std::sqrt(0.5));  // correctly rounded, as IEEE's square root is
    BOOST_TEST(m.facts.order == 2);
    BOOST_TEST(m.stiffly_accurate());
    BOOST_TEST(m.facts.l_stable());
    const auto wide = sc::tableaux::rounded<fifty>(file);
    BOOST_TEST(abs(wide.b[0] * wide.b[0] * 2 - 1) < fifty("1e-49"));
    BOOST_TEST(!sc::tableaux::rounded<double>(catalogue().at("classical_rk4")).stiffly_accurate());
    // an exact tableau is rounded as its file is
    const auto& fractions = catalogue().at("dormand_prince_5_4");
    const auto a = sc::tableaux::rounded<double>(sc::tableaux::to_rational(fractions));
    const auto b = sc::tableaux::rounded<double>(fractions);
    BOOST_TEST((a.A == b.A && a.b == b.b && a.c == b.c && a.b_embedded == b.b_embedded));
    BOOST_TEST(a.A(6, 2) == 500.0 / 1113);
    BOOST_TEST(a.A(6, 2) != std::nextafter(500.0 / 1113, 1.0));
}
