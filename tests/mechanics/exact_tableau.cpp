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

BOOST_AUTO_TEST_CASE(implicit_euler_and_radau_iia_2_are_the_printed_tableaux) {
    const auto one = stagecraft::tableaux::exact_tableau(family::radau_iia, 1).value();
    for (const quadratic& entry : {one.A(0, 0), one.b(0), one.c(0)}) BOOST_TEST(entry == quadratic(1));
    const auto two = stagecraft::tableaux::exact_tableau(family::radau_iia, 2).value();
    const auto is = [](const quadratic& x, int p, int q) { return x == quadratic(rational(p, q)); };
    BOOST_TEST(is(two.c(0), 1, 3));
    BOOST_TEST(is(two.c(1), 1, 1));
    BOOST_TEST(is(two.A(0, 0), 5, 12));
    BOOST_TEST(is(two.A(0, 1), -1, 12));
    for (int i : {0, 1}) {
        BOOST_TEST(is(two.A(1, i), i == 0 ? 3 : 1, 4));
        BOOST_TEST(two.b(i) == two.A(1, i));
    }
    // The real part of the eigenvalues that the thesis gives, 1/3, is half the trace: their product is 1/6 > 1/9.
    BOOST_TEST(is(two.A(0, 0) + two.A(1, 1), 2, 3));
    BOOST_TEST(is(two.A(0, 0) * two.A(1, 1) - two.A(0, 1) * two.A(1, 0), 1, 6));
}

BOOST_AUTO_TEST_CASE(radau_iia_satisfies_b_to_2s_minus_1_and_c_to_s_and_no_more) {
    for (int s = 1; s <= 3; ++s) {
        const auto t = stagecraft::tableaux::exact_tableau(family::radau_iia, s).value();
        const auto power = [&](int j, int k) {
            quadratic x(1);
            for (int i = 0; i < k; ++i) x = x * t.c(j);
            return x;
        };
        const auto b = [&](int k) {
            quadratic sum(0);
            for (int j = 0; j < s; ++j) sum = sum + t.b(j) * power(j, k - 1);
            return sum == quadratic(rational(1, k));
        };
        const auto c = [&](int k) {
            bool all = true;
            for (int i = 0; i < s; ++i) {
                quadratic sum(0);
                for (int j = 0; j < s; ++j) sum = sum + t.A(i, j) * power(j, k - 1);
                all = all && sum == power(i, k) * quadratic(rational(1, k));
            }
            return all;
        };
        for (int k = 1; k <= 2 * s - 1; ++k) BOOST_TEST(b(k));
        BOOST_TEST(!b(2 * s));
        for (int k = 1; k <= s; ++k) BOOST_TEST(c(k));
        BOOST_TEST(!c(s + 1));
    }
    // The example for C(4): sum a_1j c_j^3 = 0.0069 > c_1^4/4 = 0.00014. It prints c_1^3, which gives c_1^4.
    const auto t = stagecraft::tableaux::exact_tableau(family::radau_iia, 3).value();
    const auto cube = [](const quadratic& x) { return x * x * x; };
    quadratic sum(0), as_printed(0);
    for (int j = 0; j < 3; ++j) {
        sum = sum + t.A(0, j) * cube(t.c(j));
        as_printed = as_printed + t.A(0, j) * cube(t.c(0));
    }
    const quadratic right = cube(t.c(0)) * t.c(0) * quadratic(rational(1, 4));
    BOOST_TEST(as_printed == right * quadratic(4));
    const auto between = [](const quadratic& x, int low, int high) {  // in millionths
        return quadratic(rational(low, 1000000)) < x && x < quadratic(rational(high, 1000000));
    };
    BOOST_TEST(between(sum, 6850, 6950));
    BOOST_TEST(between(right, 135, 145));
}

BOOST_AUTO_TEST_CASE(methods_outside_one_quadratic_field_have_no_such_tableau) {
    BOOST_TEST(stagecraft::tableaux::exact_tableau(family::gauss, 3)->c(1) == quadratic(rational(1, 2)));
    BOOST_TEST(!stagecraft::tableaux::exact_tableau(family::radau_iia, 4).has_value());
    BOOST_TEST(!stagecraft::tableaux::exact_tableau(family::gauss, 4).has_value());
}
