// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE rational
#include <boost/test/unit_test.hpp>
#include <stagecraft/tableaux/rational.hpp>

using stagecraft::tableaux::rational;

BOOST_AUTO_TEST_CASE(fractions_are_kept_in_lowest_terms) {
    BOOST_TEST(rational(6, -4).str() == "-3/2");
    BOOST_TEST((rational(1, 3) + rational(2, 3)).str() == "1");
}

BOOST_AUTO_TEST_CASE(no_floating_point_number_becomes_a_rational) {
    static_assert(!std::is_constructible_v<rational, double>);
    static_assert(!std::is_convertible_v<float, rational>);
}

BOOST_AUTO_TEST_CASE(division_by_zero_is_an_error) {
    BOOST_CHECK_THROW(rational(1) / rational(0), std::domain_error);
    BOOST_CHECK_THROW(rational(1, 0), std::domain_error);
}

BOOST_AUTO_TEST_CASE(long_fractions_become_doubles_without_overflow) {
    using stagecraft::tableaux::integer;
    const integer huge = integer(1) << 5000;
    BOOST_TEST(rational(3 * huge + 1, 4 * huge).to<double>() == 0.75);
    BOOST_TEST(rational(-3 * huge, 4 * huge + 1).to<double>() == -0.75);
    BOOST_TEST(rational(1, huge).to<double>() == 0.0);
    BOOST_TEST(rational(huge, 1).to<double>() == std::numeric_limits<double>::infinity());
    BOOST_TEST(rational(-1, 3).to<double>() == -1.0 / 3);
    BOOST_TEST(rational(0).to<double>() == 0.0);
}
