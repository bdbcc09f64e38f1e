// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE nodal
#include <boost/test/unit_test.hpp>
#include <functional>
#include <stagecraft/tableaux/legendre.hpp>
#include <stagecraft/tableaux/nodal.hpp>
#include <stagecraft/tableaux/sturm.hpp>

using namespace stagecraft::tableaux;
using poly = polynomial<rational>;

namespace {

// w up to its scaling, by Rodrigues' formula: the (s-a-b)-fold derivative of (x^(s-a-b) (x-1)^(s-a-b)) with
// the factors x^a (x-1)^b of fixed ends moved outside (Hairer-Wanner II.IV.5).
poly rodrigues(int s, int left, int right) {
    const poly x = poly::x();
    poly p = power(x, s - right) * power(x - poly(1), s - left);
    for (int k = 0; k < s - left - right; ++k) p = derivative(p);
    return monic(p);
}

std::string complaint(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "none";
}

int roots_in_unit_interval(const poly& w) {
    return sturm_chain<rational>(w).count(0, 1) + (w[0] == 0 ? 1 : 0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(nodes_of_the_families_are_the_roots_of_rodrigues_formulas) {
    for (int s = 2; s <= 12; ++s) {
        BOOST_TEST((monic(nodal_polynomial(family::gauss, s).monomial()) == rodrigues(s, 0, 0)));
        for (const auto f : {family::radau_i, family::radau_ia})
            BOOST_TEST((monic(nodal_polynomial(f, s).monomial()) == rodrigues(s, 1, 0)));
        for (const auto f : {family::radau_ii, family::radau_iia})
            BOOST_TEST((monic(nodal_polynomial(f, s).monomial()) == rodrigues(s, 0, 1)));
        for (const auto f : {family::lobatto_iiia, family::lobatto_iiib, family::lobatto_iiic})
            BOOST_TEST((monic(nodal_polynomial(f, s).monomial()) == rodrigues(s, 1, 1)));
    }
}

BOOST_AUTO_TEST_CASE(nodes_of_the_families_are_real_distinct_and_in_the_unit_interval) {
    for (const auto f : all_families)
        for (int s = least_stages(f); s <= 12; ++s)
            BOOST_TEST(roots_in_unit_interval(nodal_polynomial(f, s).monomial()) == s);
    BOOST_TEST(roots_in_unit_interval(poly{1, -4, 4}) == 1);  // (2x-1)^2: one node only
}

BOOST_AUTO_TEST_CASE(both_bases_hold_the_same_polynomial) {
    const std::vector<rational> nodes{0, rational(1, 3), rational(2, 7), 1};
    const auto w = nodal_polynomial::from_nodes(nodes, "mine");
    BOOST_TEST(w.degree() == 4);
    BOOST_TEST(w.name() == "mine");
    BOOST_TEST(!w.family().has_value());
    BOOST_TEST((w.legendre().back() == 1));
    BOOST_TEST((w.monomial().leading() == 70));  // binom(8, 4)
    BOOST_TEST((from_legendre(w.legendre()) == w.monomial()));
    for (const auto& c : nodes) BOOST_TEST((w.monomial()(c) == 0));
    BOOST_TEST((w.monomial()(rational(1, 2)) != 0));
}

BOOST_AUTO_TEST_CASE(a_user_polynomial_may_have_irrational_nodes_and_any_scaling) {
    const auto w = nodal_polynomial::from_coefficients({rational(5), rational(-30), rational(30)});
    BOOST_TEST((w.monomial() == nodal_polynomial(family::gauss, 2).monomial()));
    const auto radau = nodal_polynomial::from_coefficients({rational(1), rational(-4), rational(3)});
    BOOST_TEST((radau.legendre() == nodal_polynomial(family::radau_iia, 2).legendre()));
}

BOOST_AUTO_TEST_CASE(repeated_complex_and_outside_nodes_are_refused_by_name) {
    BOOST_TEST(complaint([] {
                   nodal_polynomial::from_coefficients({1, -4, 4});
               }) == "coefficients: 2 distinct real roots in [0, 1] needed, this polynomial has 1");
    BOOST_TEST(complaint([] {
                   nodal_polynomial::from_coefficients({1, 0, 1});
               }) == "coefficients: 2 distinct real roots in [0, 1] needed, this polynomial has 0");
    BOOST_TEST(complaint([] {
                   nodal_polynomial::from_coefficients({0, -2, 1});
               }) == "coefficients: 2 distinct real roots in [0, 1] needed, this polynomial has 1");
    BOOST_TEST(complaint([] {
                   nodal_polynomial::from_coefficients({3, 0});
               }) == "coefficients: a nodal polynomial has degree at least 1");
    // The nodes of the classical Runge-Kutta method: confluent, no nodal polynomial.
    BOOST_TEST(complaint([] {
                   nodal_polynomial::from_nodes({0, rational(1, 2), rational(1, 2), 1});
               }) == "nodes: must be distinct, 1/2 is repeated");
    BOOST_TEST(complaint([] { nodal_polynomial::from_nodes({rational(-1, 2)}); }) ==
               "nodes: must lie in [0, 1], one of them is -1/2");
    BOOST_TEST(complaint([] { nodal_polynomial::from_nodes({}); }) == "nodes: at least one node needed");
    BOOST_TEST(complaint([] { nodal_polynomial(family::lobatto_iiia, 1); }) ==
               "stages: lobatto_iiia needs at least 2, got 1");
    BOOST_TEST(complaint([] { nodal_polynomial(family::gauss, 0); }) ==
               "stages: gauss needs at least 1, got 0");
}

BOOST_AUTO_TEST_CASE(families_are_known_by_name) {
    for (const auto f : all_families) BOOST_TEST((family_from_name(name(f)) == f));
    BOOST_TEST(complaint([] { family_from_name("radau"); }) ==
               "family: unknown name 'radau', allowed: gauss, radau_i, radau_ia, radau_ii, radau_iia, "
               "lobatto_iiia, lobatto_iiib, lobatto_iiic");
}
