// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE fixed_rational
#include <boost/test/unit_test.hpp>
#include <random>
#include <stagecraft/tableaux/fixed_rational.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <type_traits>

using stagecraft::tableaux::fixed_rational;
using stagecraft::tableaux::int128;
using stagecraft::tableaux::rational;
using namespace stagecraft::tableaux::literals;

static_assert(fixed_rational(6, -4) == fixed_rational(-3, 2));
static_assert(1 / 3_q + 1 / 6_q == 1 / 2_q);

// Whether F{}() is a constant expression.
template <class F, int = (static_cast<void>(F{}()), 0)>
constexpr bool is_constant(F) {
    return true;
}
constexpr bool is_constant(...) { return false; }
static_assert(is_constant([] { return fixed_rational(int128{1} << 125) * 2; }));
static_assert(!is_constant([] { return fixed_rational(int128{1} << 125) * 4; }), "overflow must not compile");
static_assert(!is_constant([] { return 1 / 0_q; }));

static_assert(1 / 3_q < 1 / 2_q && !(1 / 2_q < 1 / 3_q) && -1 / 2_q < -1 / 3_q);

BOOST_AUTO_TEST_CASE(agrees_with_the_unbounded_rational) {
    std::mt19937 random(20240601);
    std::uniform_int_distribution<int> digit(-40, 40);
    for (int i = 0; i < 2000; ++i) {
        const int n = digit(random), d = digit(random), m = digit(random), e = digit(random);
        if (d == 0 || e == 0) continue;
        const fixed_rational a(n, d), b(m, e);
        const rational x(n, d), y(m, e);
        BOOST_REQUIRE_EQUAL((a + b).str(), (x + y).str());
        BOOST_REQUIRE_EQUAL((a - b).str(), (x - y).str());
        BOOST_REQUIRE_EQUAL((a * b).str(), (x * y).str());
        if (m != 0) BOOST_REQUIRE_EQUAL((a / b).str(), (x / y).str());
        BOOST_REQUIRE((a < b) == (x < y));
        BOOST_REQUIRE((a == b) == (x == y));
        BOOST_REQUIRE_EQUAL(sign(a), sign(x));
    }
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_is_an_error_and_never_wraps) {
    const fixed_rational big = fixed_rational(int128{1} << 126);
    BOOST_TEST((big + (big - 1)).str() == "170141183460469231731687303715884105727");  // 2^127 - 1
    BOOST_CHECK_THROW(big + big, std::overflow_error);
    BOOST_CHECK_THROW(big * 3, std::overflow_error);
    BOOST_CHECK_THROW(1 / big / 3, std::overflow_error);
    BOOST_CHECK_THROW(-fixed_rational(-big - big), std::overflow_error);
    BOOST_TEST((-big - big).str() == "-170141183460469231731687303715884105728");
    BOOST_TEST((big * fixed_rational(3, int128{1} << 126)).str() == "3");  // cancels before it multiplies
}

BOOST_AUTO_TEST_CASE(division_by_zero_is_an_error) {
    BOOST_CHECK_THROW(fixed_rational(1) / fixed_rational(0), std::domain_error);
    BOOST_CHECK_THROW(fixed_rational(1, 0), std::domain_error);
}

BOOST_AUTO_TEST_CASE(no_floating_point_number_becomes_a_fixed_rational) {
    static_assert(!std::is_constructible_v<fixed_rational, double>);
    static_assert(!std::is_convertible_v<float, fixed_rational>);
    static_assert(std::is_convertible_v<int, fixed_rational>);
}
