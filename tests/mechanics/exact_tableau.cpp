// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE exact_tableau
#include <boost/test/unit_test.hpp>
#include <stagecraft/tableaux/exact_tableau.hpp>

#include <problems/rolling_disc/surd_tableau.hpp>

using namespace rolling_disc;
using stagecraft::tableaux::family;
using stagecraft::tableaux::quadratic;
using stagecraft::tableaux::rational;

namespace {
quadratic surd(int a, int b, int denominator) {
    return {rational(a, denominator), rational(b, denominator), 6};
}
}  // namespace

BOOST_AUTO_TEST_CASE(radau_iia_3_is_the_printed_tableau) {
    const auto t = stagecraft::tableaux::exact_tableau(family::radau_iia, 3).value();
    BOOST_TEST(t.c(0) == surd(4, -1, 10));
    BOOST_TEST(t.c(1) == surd(4, 1, 10));
    BOOST_TEST(t.c(2) == quadratic(1));
    BOOST_TEST(t.A(0, 0) == surd(88, -7, 360));
    BOOST_TEST(t.A(0, 1) == surd(296, -169, 1800));
    BOOST_TEST(t.A(0, 2) == surd(-2, 3, 225));
    BOOST_TEST(t.A(1, 0) == surd(296, 169, 1800));
    BOOST_TEST(t.A(1, 1) == surd(88, 7, 360));
    BOOST_TEST(t.A(1, 2) == surd(-2, -3, 225));
    BOOST_TEST(t.A(2, 0) == surd(16, -1, 36));
    BOOST_TEST(t.A(2, 1) == surd(16, 1, 36));
    BOOST_TEST(t.A(2, 2) == quadratic(rational(1, 9)));
    for (int j = 0; j < 3; ++j) BOOST_TEST(t.b(j) == t.A(2, j));
    BOOST_TEST(print(t).find("2/5-1/10*sqrt(6) |") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(methods_outside_one_quadratic_field_have_no_such_tableau) {
    BOOST_TEST(stagecraft::tableaux::exact_tableau(family::gauss, 3)->c(1) == quadratic(rational(1, 2)));
    BOOST_TEST(!stagecraft::tableaux::exact_tableau(family::radau_iia, 4).has_value());
    BOOST_TEST(!stagecraft::tableaux::exact_tableau(family::gauss, 4).has_value());
}
