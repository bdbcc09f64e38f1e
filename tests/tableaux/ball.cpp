// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE ball
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <compare>
#include <limits>
#include <random>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/tableaux/complex_ball.hpp>
#include <stagecraft/tableaux/correct_rounding.hpp>
#include <stagecraft/tableaux/range.hpp>
#include <stagecraft/tableaux/rough_ball.hpp>
#include <vector>

using namespace stagecraft::tableaux;

namespace {

/// A random rational: numerator and denominator of up to `bits` bits, times a power of two.
class rationals {
  public:
    rational operator()(int bits) {
        integer n = 0, d = 0;
        for (int k = 0; k < bits; k += 32) {
            n = (n << 32) + integer(word());
            d = (d << 32) + integer(word());
        }
        n >>= static_cast<unsigned>(word() % static_cast<unsigned>(bits));
        d >>= static_cast<unsigned>(word() % static_cast<unsigned>(bits));
        const rational q(word() % 2 == 0 ? n : integer(-n), integer(d + 1));
        const integer power = integer(1) << (word() % 90);
        return word() % 2 == 0 ? q * rational(power) : q / rational(power);
    }
    unsigned word() { return static_cast<unsigned>(engine_()); }

  private:
    std::mt19937 engine_{20241121};
};

/// A number and a ball around it whose midpoint is off by up to its radius.
struct sample {
    rational value;
    ball enclosure;
};

/// A finite double, exactly.
rational exact(double x) {
    int e = 0;
    const auto m = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &e), 53));
    return ball::to_rational(ball::mantissa(m), e - 53);
}

/// A finite bound, exactly.
rational bound_of(bound r) {
    BOOST_REQUIRE(r <= std::numeric_limits<bound>::max());
    return ball::bound_to_rational(r);
}

sample draw(rationals& random, int bits) {
    sample x{random(64), ball()};
    switch (random.word() % 12) {
        case 0:  // a power of two, and its neighbours in the last of the bits
            x.value = rational(integer(1) << (random.word() % 200));
            if (random.word() % 2 == 0)
                x.value += rational(integer(1), integer(1) << static_cast<unsigned>(bits));
            break;
        case 1: {  // far from 1
            const integer power = integer(1) << (random.word() % 7000);
            x.value = random.word() % 2 == 0 ? x.value * rational(power) : x.value / rational(power);
            break;
        }
        case 2:
            x.value = rational(static_cast<int>(random.word() % 3) - 1);
            break;
        default:
            break;
    }
    x.enclosure = ball(x.value, bits);
    if (random.word() % 3 == 0) {  // a wide ball with the value near its edge
        const bound r = std::ldexp(bound(1 + random.word() % 1000), -static_cast<int>(random.word() % 200));
        const rational shift = ball::bound_to_rational(r) * rational(integer(random.word() % 1000), 1000);
        x.enclosure = (ball(x.value + shift, bits)).widened(r);
    }
    return x;
}

}  // namespace

BOOST_AUTO_TEST_CASE(operations_enclose_the_exact_results_of_1e5_operands) {
    rationals random;
    int divided = 0, rooted = 0;
    for (int trial = 0; trial < 10'000; ++trial) {
        const int bits = 64 + static_cast<int>(random.word() % 300);
        const sample x = draw(random, bits), y = draw(random, bits);
        BOOST_REQUIRE(x.enclosure.contains(x.value));
        BOOST_REQUIRE((x.enclosure + y.enclosure).contains(x.value + y.value));
        BOOST_REQUIRE((x.enclosure - y.enclosure).contains(x.value - y.value));
        BOOST_REQUIRE((x.enclosure * y.enclosure).contains(x.value * y.value));
        BOOST_REQUIRE((-x.enclosure).contains(-x.value));
        BOOST_REQUIRE(abs(x.enclosure).contains(abs(x.value)) || !certainly_nonzero(x.enclosure));
        const int n = static_cast<int>(random.word() % 2000) - 1000;
        BOOST_REQUIRE(x.enclosure.times(n).contains(x.value * rational(n)));
        if (n != 0) BOOST_REQUIRE(x.enclosure.over(n).contains(x.value / rational(n)));
        BOOST_REQUIRE(x.enclosure.scaled(n).contains(n < 0 ? x.value / rational(integer(1) << -n)
                                                           : x.value * rational(integer(1) << n)));
        BOOST_REQUIRE(x.enclosure.with_bits(64).contains(x.value));
        if (const auto order = compare(x.enclosure, y.enclosure); order != std::partial_ordering::unordered)
            BOOST_REQUIRE((order == (x.value <=> y.value)));
        BOOST_REQUIRE(bound_of(x.enclosure.lower_magnitude()) <= abs(x.value));
        BOOST_REQUIRE(bound_of(x.enclosure.upper_magnitude()) >= abs(x.value));
        if (certainly_nonzero(y.enclosure)) {
            ++divided;
            BOOST_REQUIRE((x.enclosure / y.enclosure).contains(x.value / y.value));
        }
        if (certainly_positive(x.enclosure)) {
            ++rooted;
            const ball root = sqrt(x.enclosure);
            BOOST_REQUIRE(root.lower() * root.lower() <= x.value || root.lower() < 0);
            BOOST_REQUIRE(root.upper() * root.upper() >= x.value);
        }
    }
    BOOST_TEST(divided > 7000);
    BOOST_TEST(rooted > 3000);
}

BOOST_AUTO_TEST_CASE(ranges_contain_the_exact_results_whatever_the_lengths_of_their_ends) {
    rationals random;
    const auto around = [&](const rational& q) {
        if (random.word() % 2 == 0) return range{q, q};
        const rational off = abs(random(40));
        return range{q - off, q + off / rational(1 + static_cast<int>(random.word() % 9))};
    };
    int rounded = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const int bits = trial % 2 == 0 ? 60 : 900;
        const rational p = random(bits), q = random(bits);
        const range x = around(p), y = around(q);
        BOOST_REQUIRE((x + y).contains(p + q));
        BOOST_REQUIRE((x - y).contains(p - q));
        BOOST_REQUIRE((x * y).contains(p * q));
        if (!y.contains(0)) BOOST_REQUIRE((x / y).contains(p / q));
        BOOST_REQUIRE((rounded_down(p) <= p && p <= rounded_up(p)));
        rounded += rounded_down(p) < rounded_up(p) ? 1 : 0;
        if (p < 0) continue;
        const range root = sqrt(x);
        BOOST_REQUIRE((root.lower >= 0 && root.lower * root.lower <= p && p <= root.upper * root.upper));
    }
    BOOST_TEST(rounded > 500);
}

BOOST_AUTO_TEST_CASE(rounding_keeps_the_sign_whatever_the_low_limbs_are) {
    // Boost 1.74's >> turns a negative number with lowest limb 1 into a positive one
    for (const integer& low : {integer(0), integer(1), integer(2), (integer(1) << 64) - 1, integer(1) << 64})
        for (const int sign : {-1, 1})
            for (const int shift : {64, 192, 448}) {
                const integer n = (integer(5) << static_cast<unsigned>(shift + 70)) + low;
                const rational q = rational(n) * rational(sign);
                const ball x(ball::mantissa(integer(n * sign)), 0, 0, 400);
                BOOST_TEST(x.contains(q));
                BOOST_TEST(x.with_bits(64).contains(q));
                BOOST_TEST((x.with_bits(64) + ball(sign)).contains(q + rational(sign)));
            }
}

BOOST_AUTO_TEST_CASE(chains_of_operations_and_products_of_vectors_enclose) {
    rationals random;
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<ball> a, b;
        rational exact_dot = 0, exact_chain = 1;
        ball chain = 1;
        for (int k = 0; k < 12; ++k) {
            const sample x = draw(random, 192), y = draw(random, 192);
            a.push_back(x.enclosure);
            b.push_back(y.enclosure);
            exact_dot += x.value * y.value;
            exact_chain = exact_chain * x.value + y.value;
            chain = chain * x.enclosure + y.enclosure;
        }
        BOOST_REQUIRE(dot(ball::row(a), ball::row(b)).contains(exact_dot));
        BOOST_REQUIRE(chain.contains(exact_chain));
    }
}

BOOST_AUTO_TEST_CASE(radii_are_as_small_as_the_precision_says) {
    rationals random;
    for (const int bits : {64, 128, 640, 3400}) {
        for (int trial = 0; trial < 50; ++trial) {
            const ball x(random(64), bits), y(random(64), bits);
            if (!certainly_nonzero(x) || !certainly_nonzero(y)) continue;
            for (const ball& z : {x * y, x / y, sqrt(abs(x))})
                BOOST_REQUIRE(z.radius() <= z.magnitude_below() * std::ldexp(bound(16), -bits));
        }
    }
}

BOOST_AUTO_TEST_CASE(integers_and_structural_zeros_stay_exact) {
    const ball third(rational(1, 3), 200), zero = 0;
    BOOST_TEST((zero * third).exactly_zero());
    BOOST_TEST((zero / third).exactly_zero());
    BOOST_TEST((third.midpoint() - third.midpoint()).exactly_zero());
    BOOST_TEST(ball(6).over(3).exact());
    BOOST_TEST((ball(1 << 20).with_bits(500) / ball(1 << 10)).exact());
    BOOST_TEST(sqrt(ball(144).with_bits(300)).contains(12));
    BOOST_TEST(!(third - third).exactly_zero());  // two unknown numbers: nothing says that they are equal
    BOOST_TEST((third - third).contains(0));
}

BOOST_AUTO_TEST_CASE(comparisons_are_certain_or_unordered) {
    const ball a(rational(1, 3), 100), b = a.widened(1e-20L),
                                       c(rational(integer(1), integer(3)) + rational(1, 1000), 100);
    BOOST_TEST((compare(a, b) == std::partial_ordering::unordered));
    BOOST_TEST((compare(a, a) == std::partial_ordering::unordered));
    BOOST_TEST((compare(ball(2), ball(2)) == std::partial_ordering::equivalent));
    BOOST_TEST(certainly_less(b, c));
    BOOST_TEST(!certainly_less(c, b));
    BOOST_TEST(certainly_negative(a - c));
    BOOST_TEST(!certainly_positive(ball(1).widened(1)));
    BOOST_TEST(!certainly_nonzero(ball(1).widened(1)));
    BOOST_TEST(certainly_positive(ball(1).widened(0.999L)));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_enclosed_is_undecided) {
    BOOST_CHECK_THROW(ball(1) / ball(1).widened(1), undecided);
    BOOST_CHECK_THROW(ball(1) / ball(0), undecided);
    BOOST_CHECK_THROW(sqrt(ball(1).widened(2)), undecided);
    BOOST_CHECK_THROW(sqrt(ball(-1)), undecided);
    const ball unknown = ball(1).widened(std::numeric_limits<bound>::infinity());
    BOOST_TEST(!certainly_nonzero(unknown * ball(3) + ball(1)));
    BOOST_TEST(!nearest<double>(unknown).has_value());
}

BOOST_AUTO_TEST_CASE(complex_operations_enclose_the_exact_results) {
    rationals random;
    int divided = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const sample a = draw(random, 128), b = draw(random, 128), c = draw(random, 128),
                     d = draw(random, 128);
        const complex_ball x{a.enclosure, b.enclosure}, y{c.enclosure, d.enclosure};
        const complex_ball product = x * y;
        BOOST_REQUIRE(product.re.contains(a.value * c.value - b.value * d.value));
        BOOST_REQUIRE(product.im.contains(a.value * d.value + b.value * c.value));
        BOOST_REQUIRE((x + y).re.contains(a.value + c.value));
        BOOST_REQUIRE((x - y).im.contains(b.value - d.value));
        BOOST_REQUIRE((x * y.re).im.contains(b.value * c.value));
        const rational size = a.value * a.value + b.value * b.value;
        const rational least = bound_of(x.lower_magnitude()), most = bound_of(x.upper_magnitude());
        BOOST_REQUIRE((least * least <= size && size <= most * most));
        if (!certainly_nonzero(c.enclosure) || !certainly_nonzero(c.enclosure * c.enclosure)) continue;
        try {
            const complex_ball q = x / y;
            ++divided;
            const rational n = c.value * c.value + d.value * d.value;
            BOOST_REQUIRE(q.re.contains((a.value * c.value + b.value * d.value) / n));
            BOOST_REQUIRE(q.im.contains((b.value * c.value - a.value * d.value) / n));
        } catch (const undecided&) {
            BOOST_REQUIRE(!certainly_nonzero(y.re * y.re + y.im * y.im));
        }
    }
    BOOST_TEST(divided > 2000);
}

BOOST_AUTO_TEST_CASE(doubles_are_the_nearest_ones) {
    rationals random;
    for (int trial = 0; trial < 2000; ++trial) {
        const rational q = random(64);
        if (q == 0) continue;
        const auto rounded = nearest<double>(ball(q, 200));
        BOOST_REQUIRE(rounded.has_value());
        const rational error = abs(q - exact(*rounded));
        for (const double towards : {-HUGE_VAL, HUGE_VAL})
            BOOST_REQUIRE(error <= abs(q - exact(std::nextafter(*rounded, towards))));
    }
}

BOOST_AUTO_TEST_CASE(roundings_that_are_not_decided_are_refused) {
    const rational half_way = rational(1) + rational(integer(1), integer(1) << 53);
    BOOST_TEST(!nearest<double>(ball(half_way, 300).widened(1e-40L)).has_value());
    BOOST_TEST(*nearest<double>(ball(half_way, 300).midpoint()) == 1.0);  // an exact tie goes to even
    BOOST_TEST(!nearest<double>(ball(0).widened(1e-400L)).has_value());   // 0 or the least positive number?
    BOOST_TEST(*nearest<double>(ball(0)) == 0.0);
    BOOST_TEST(*nearest<double>(ball(rational(1, 4), 64).widened(1e-30L)) == 0.25);
    BOOST_TEST(*nearest<long double>(ball(rational(-1, 3), 200)) == -1.0L / 3.0L);
    BOOST_CHECK_THROW(nearest<double>(ball(1).scaled(-1050)), std::range_error);
    BOOST_CHECK_THROW(nearest<double>(ball(1).scaled(1024)), std::range_error);
    BOOST_TEST(*nearest<double>(ball(1).scaled(1023)) == 0x1p1023);
    const rational below_two = rational(2) - rational(integer(1), integer(1) << 60);
    BOOST_TEST(*nearest<double>(ball(below_two, 100)) == 2.0);  // the carry into the next binade
}

BOOST_AUTO_TEST_CASE(decimals_are_correctly_rounded) {
    BOOST_TEST(decimal_text(rational(1, 3), 5) == "0.33333");
    BOOST_TEST(decimal_text(rational(-2, 3), 5) == "-0.66667");
    BOOST_TEST(decimal_text(rational(1, 4), 1) == "0.2");  // ties to even
    BOOST_TEST(decimal_text(rational(3, 4), 1) == "0.8");
    BOOST_TEST(decimal_text(rational(1), 3) == "1.00");
    BOOST_TEST(decimal_text(rational(0), 3) == "0");
    BOOST_TEST(decimal_text(rational(99996, 100000), 4) == "1.000");
    BOOST_TEST(decimal_text(rational(999949, 10000), 4) == "99.99");
    BOOST_TEST(decimal_text(rational(12345), 2) == "1.2e4");
    BOOST_TEST(decimal_text(rational(1, 1000000000), 3) == "1.00e-9");
    BOOST_TEST(decimal_text(rational(10), 2) == "10");
    BOOST_TEST(*decimal_text(ball(rational(1, 7), 200), 40) == "0.1428571428571428571428571428571428571429");
    BOOST_TEST(!decimal_text(ball(rational(1, 4), 200).widened(1e-50L), 1).has_value());
    BOOST_TEST(*decimal_text(ball(rational(1, 4), 200).widened(1e-50L), 2) == "0.25");
    BOOST_TEST(!decimal_text(ball(rational(1, 7), 64), 40).has_value());
}

namespace {

rational exactly(long double v) {
    int e = 0;
    const long double m = std::frexp(v, &e);
    const rational n(integer(std::ldexp(m, 64)));
    return e >= 64 ? n * rational(integer(1) << (e - 64)) : n / rational(integer(1) << (64 - e));
}

}  // namespace

BOOST_AUTO_TEST_CASE(rough_balls_contain_the_results_and_decide_what_is_far_from_zero) {
    rationals random;
    const auto rough = [](const rational& q) { return rough_ball(ball(q, 128)); };
    int decided = 0;
    for (int k = 0; k < 2000; ++k) {
        const rational a = random(100), b = random(100), c = random(60);
        if (b == 0) continue;
        const rational value = (a + c) * a / b - c * rational(k);
        const rough_ball x = (rough(a) + rough(c)) * rough(a) / rough(b) - rough(c) * rough_ball(k);
        BOOST_REQUIRE(abs(value - exactly(x.middle())) <= exactly(x.radius()));
        BOOST_REQUIRE(abs(value) <= exactly(x.magnitude()));
        if (value == 0) BOOST_REQUIRE(!certainly_nonzero(x));
        if (certainly_nonzero(x)) ++decided;
    }
    BOOST_TEST(decided > 1900);
    const rough_ball third = rough(rational(1, 3));
    BOOST_TEST(!certainly_nonzero(third * rough_ball(3) - rough_ball(1)));
    BOOST_TEST(!certainly_nonzero(rough_ball(1) / (third * rough_ball(3) - rough_ball(1))));
    // A number is not taken for zero because its square underflows, nor an infinite one for known.
    rough_ball tiny = rough_ball(1), huge = rough_ball(10);
    for (int k = 0; k < 20; ++k) tiny /= rough_ball(1000000000), huge *= huge;
    BOOST_TEST(certainly_nonzero(tiny));
    BOOST_TEST(!certainly_nonzero(huge));
}
