// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE rational
#include <boost/test/unit_test.hpp>
#include <random>
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

namespace {

using stagecraft::tableaux::integer;

integer number_of(int limbs, std::mt19937_64& random) {
    integer x = 0;
    for (int i = 0; i < limbs; ++i) x = (x << 64) + integer(random() >> random() % 64);
    return random() % 2 == 0 ? x : integer(-x);
}

}  // namespace

BOOST_AUTO_TEST_CASE(greatest_common_divisors_are_those_of_the_binary_method) {
    std::mt19937_64 random(1);
    int shared = 0;
    for (int k = 0; k < 20000; ++k) {
        const integer common = number_of(static_cast<int>(random() % 4), random);
        const integer a = common * number_of(static_cast<int>(random() % 9), random);
        const integer b = common * number_of(static_cast<int>(random() % 9), random);
        const integer g = gcd(a, b);
        if (g != boost::multiprecision::gcd(a, b)) BOOST_ERROR("gcd(" << a << ", " << b << ") is not " << g);
        if (g > 1) ++shared;
    }
    BOOST_TEST(shared > 1000);
}

BOOST_AUTO_TEST_CASE(successive_fibonacci_numbers_are_coprime) {  // every quotient of Euclid's algorithm is 1
    integer a = 0, b = 1;
    for (int k = 0; k < 2000; ++k) {
        a += b;
        std::swap(a, b);
        if (gcd(a, b) != 1 || gcd(integer(a * 6), integer(b * 6)) != 6) BOOST_ERROR("at " << k);
    }
    BOOST_TEST(b.backend().size() > 20U);
    BOOST_TEST(lcm(integer(-4), integer(6)) == 12);
    BOOST_TEST(lcm(integer(0), integer(6)) == 0);
}

BOOST_AUTO_TEST_CASE(arithmetic_of_long_fractions_obeys_the_field_laws) {
    std::mt19937_64 random(2);
    const auto fraction = [&] {
        integer d = number_of(static_cast<int>(1 + random() % 3), random);
        return rational(number_of(static_cast<int>(random() % 3), random), d == 0 ? integer(1) : d);
    };
    for (int k = 0; k < 5000; ++k) {
        const rational a = fraction(), b = fraction(), c = fraction();
        BOOST_REQUIRE(a + b - b == a);
        BOOST_REQUIRE((a + b) * c == a * c + b * c);
        if (b != 0) BOOST_REQUIRE(a / b * b == a);
        BOOST_REQUIRE((a < b) == (a - b < 0));
        const rational d = a * b + c;
        BOOST_REQUIRE(boost::multiprecision::gcd(d.numerator(), d.denominator()) == 1);
        BOOST_REQUIRE(d.denominator() > 0);
    }
    rational a(2, 3);
    const rational& itself = a;
    a -= itself;
    BOOST_TEST(a.str() == "0");
}
