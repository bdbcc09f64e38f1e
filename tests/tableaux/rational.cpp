// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE rational
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <concepts>
#include <cstdlib>
#include <limits>
#include <random>
#include <stagecraft/tableaux/rational.hpp>
#include <stdexcept>

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

rational power_of_two(int k) {
    const integer p = integer(1) << std::abs(k);
    return k < 0 ? rational(integer(1), p) : rational(p);
}

/// A finite number of a binary type as an integer times its unit in the last place.
template <class Real>
struct places {
    integer digits;
    int exponent;
    explicit places(const Real& x) {
        using std::frexp, std::ldexp;
        Real m = frexp(x, &exponent);
        exponent -= std::numeric_limits<Real>::digits;
        if (std::floating_point<Real> && exponent < least()) m = ldexp(m, exponent - least());
        exponent = std::max(exponent, least());
        digits = static_cast<integer>(ldexp(m, std::numeric_limits<Real>::digits));
    }
    static constexpr int least() {
        using limits = std::numeric_limits<Real>;
        return std::floating_point<Real> ? limits::min_exponent - limits::digits : limits::min_exponent;
    }
};

/// Whether x is the number of its type nearest to q, the even one of two.
template <class Real>
bool is_nearest(const rational& q, const Real& x) {
    using limits = std::numeric_limits<Real>;
    if (abs(x) > limits::max())
        return (q > 0) == (x > 0) && abs(q) >= power_of_two(limits::max_exponent) -
                                                   power_of_two(limits::max_exponent - limits::digits - 1);
    const places<Real> v(x);
    if (v.exponent > limits::max_exponent - limits::digits) return false;
    const rational off = q / power_of_two(v.exponent) - rational(v.digits);
    if (abs(off) > rational(1, 2) || (abs(off) == rational(1, 2) && v.digits % 2 != 0)) return false;
    // below a power of two the numbers lie twice as close
    const bool power = abs(v.digits) == integer(1) << (limits::digits - 1) && v.exponent > v.least();
    return !power || (v.digits > 0) == (off > 0) || abs(off) <= rational(1, 4);
}

/// Quotients of numbers of 1 to 1200 bits; numbers of the type, halves between two and their neighbourhoods.
template <class Real>
int not_nearest(int tries) {
    std::mt19937_64 random(7);
    const auto number = [&](unsigned most) {
        integer n = 1;
        for (unsigned bits = 1 + static_cast<unsigned>(random() % most); n == 1 || msb(n) < bits;)
            n = (n << 32) + static_cast<unsigned>(random() >> 32);
        return n;
    };
    using limits = std::numeric_limits<Real>;
    int wrong = 0;
    for (int k = 0; k < tries; ++k) {
        rational q(number(1200), number(1200));
        if (k % 2 == 0) {  // half of a unit of the last place, and next to it
            const int least = std::max(limits::min_exponent - limits::digits - 2, -1200);
            const int most = std::min(limits::max_exponent, 1200) - limits::digits;
            const int exponent = least + static_cast<int>(random() % static_cast<unsigned>(most - least));
            integer digits = number(static_cast<unsigned>(limits::digits));
            q = (rational(digits) + rational(1, 2)) * power_of_two(exponent);
            if (k % 4 == 0) q *= 1 + rational(k % 8 == 0 ? 1 : -1) / rational(number(300));
        }
        if (random() % 2 == 0) q = -q;
        if (!is_nearest(q, q.to<Real>())) ++wrong;
    }
    return wrong;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_rational_becomes_the_nearest_number_of_each_binary_type_ties_to_even) {
    BOOST_TEST(not_nearest<double>(20'000) == 0);
    BOOST_TEST(not_nearest<float>(10'000) == 0);
    BOOST_TEST(not_nearest<long double>(5000) == 0);
    BOOST_TEST(not_nearest<boost::multiprecision::cpp_bin_float_50>(2000) == 0);
}

BOOST_AUTO_TEST_CASE(numbers_beyond_the_range_become_infinite_from_half_a_unit_on_and_below_it_zero) {
    const rational largest = power_of_two(1024) - power_of_two(971), tie = largest + power_of_two(970);
    const double infinity = std::numeric_limits<double>::infinity();
    BOOST_TEST(tie.to<double>() == infinity);
    BOOST_TEST((-tie).to<double>() == -infinity);
    BOOST_TEST((tie - power_of_two(-900)).to<double>() == std::numeric_limits<double>::max());
    BOOST_TEST(power_of_two(-1075).to<double>() == 0.0);  // half of the least number, a tie
    BOOST_TEST((power_of_two(-1075) + power_of_two(-3000)).to<double>() == 0x1p-1074);
    BOOST_TEST((3 * power_of_two(-1075)).to<double>() == 0x1p-1073);  // ties to even among subnormal numbers
    BOOST_TEST(power_of_two(-100'000).to<double>() == 0.0);
    BOOST_TEST(power_of_two(100'000).to<double>() == infinity);
    integer ten = 1;
    for (int k = 0; k < 290; ++k) ten *= 10;
    BOOST_TEST(rational(ten).to<double>() == 1e290);
    BOOST_TEST(rational(integer(1), ten).to<double>() == 1e-290);
}

namespace {

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
