// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE polynomial
#include <boost/test/unit_test.hpp>
#include <random>
#include <stagecraft/tableaux/polynomial.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/tableaux/routh_hurwitz.hpp>
#include <stagecraft/tableaux/sturm.hpp>

using namespace stagecraft::tableaux;
using poly = polynomial<rational>;

namespace {

const poly x = poly::x();

/// The smallest class type with exact arithmetic: enough to see that everything runs at compile time.
struct small_rational {
    long n = 0;
    long d = 1;
    constexpr small_rational() = default;
    constexpr small_rational(long num, long den = 1) : n(num), d(den) {
        long a = n < 0 ? -n : n;
        for (long b = d < 0 ? -d : d; b != 0;) {
            const long r = a % b;
            a = b;
            b = r;
        }
        if (d < 0) a = -a;
        n /= a;
        d /= a;
    }
    friend constexpr small_rational operator+(small_rational a, small_rational b) {
        return {a.n * b.d + b.n * a.d, a.d * b.d};
    }
    friend constexpr small_rational operator-(small_rational a, small_rational b) {
        return {a.n * b.d - b.n * a.d, a.d * b.d};
    }
    friend constexpr small_rational operator*(small_rational a, small_rational b) {
        return {a.n * b.n, a.d * b.d};
    }
    friend constexpr small_rational operator/(small_rational a, small_rational b) {
        return {a.n * b.d, a.d * b.n};
    }
    friend constexpr bool operator==(small_rational a, small_rational b) = default;
    friend constexpr bool operator<(small_rational a, small_rational b) { return a.n * b.d < b.n * a.d; }
};

poly from_roots(const std::vector<rational>& roots) {
    poly p(rational(1));
    for (const auto& r : roots) p *= x - poly(r);
    return p;
}

}  // namespace

BOOST_AUTO_TEST_CASE(division_with_remainder_reproduces_the_dividend) {
    const poly a{3, 0, rational(1, 2), -7, 5};
    const poly b{1, rational(2, 3), 4};
    const auto [q, r] = divmod(a, b);
    BOOST_TEST((q * b + r == a));
    BOOST_TEST(r.degree() < b.degree());
    BOOST_CHECK_THROW(divmod(a, poly()), std::domain_error);
    BOOST_TEST(poly().degree() == -1);
    BOOST_TEST((a - a).is_zero());
}

BOOST_AUTO_TEST_CASE(calculus_and_composition) {
    const poly p{1, 2, 3};
    BOOST_TEST((derivative(integral(p)) == p));
    BOOST_TEST((compose(p, x + poly(1)) == poly{6, 8, 3}));
    BOOST_TEST((reflected(p) == poly{1, -2, 3}));
    BOOST_TEST(to_string(poly{rational(-1, 10), rational(9, 10), rational(-9, 5), 1}) ==
               "x^3 - 9/5*x^2 + 9/10*x - 1/10");
}

BOOST_AUTO_TEST_CASE(gcd_and_squarefree_split_find_multiplicities) {
    const poly p = poly(rational(5)) * power(x - poly(1), 3) * power(x * x + poly(2), 2) * (x + poly(4));
    const auto split = squarefree_split(p);
    BOOST_TEST_REQUIRE(split.size() == 3U);
    BOOST_TEST(split[0].multiplicity == 1);
    BOOST_TEST((split[0].factor == x + poly(4)));
    BOOST_TEST(split[1].multiplicity == 2);
    BOOST_TEST((split[1].factor == x * x + poly(2)));
    BOOST_TEST(split[2].multiplicity == 3);
    BOOST_TEST((split[2].factor == x - poly(1)));
    BOOST_TEST((squarefree(p) == (x - poly(1)) * (x * x + poly(2)) * (x + poly(4))));
    BOOST_TEST((gcd(p, power(x - poly(1), 2)) == power(x - poly(1), 2)));
    BOOST_TEST((gcd(x + poly(1), x + poly(2)) == poly(1)));
}

BOOST_AUTO_TEST_CASE(sturm_counts_the_distinct_real_roots_of_every_interval) {
    const poly p = power(x - poly(1), 2) * (x - poly(2)) * (x + poly(3)) * (x * x + poly(1));
    const sturm_chain<rational> chain(p);
    BOOST_TEST(chain.count() == 3);
    BOOST_TEST(chain.count(rational(0), rational(1)) == 1);  // (a, b]: the end counts
    BOOST_TEST(chain.count(rational(1), rational(2)) == 1);  // the beginning does not
    BOOST_TEST(chain.count_above(rational(1)) == 1);
    BOOST_TEST(chain.count_up_to(rational(1)) == 2);
    BOOST_TEST(sturm_chain<rational>(x * x + poly(1)).count() == 0);
    BOOST_TEST(sturm_chain<rational>(poly(rational(3))).count() == 0);
    BOOST_CHECK_THROW(sturm_chain<rational>{poly{}}, std::domain_error);
}

BOOST_AUTO_TEST_CASE(every_real_root_is_isolated_with_its_multiplicity) {
    // Wilkinson's ten, a pair 1e-12 apart, a double irrational pair.
    std::vector<rational> roots;
    for (int k = 1; k <= 10; ++k) roots.push_back(rational(k));
    roots.push_back(rational(3) + rational(1, 1000000) * rational(1, 1000000));
    const poly p = from_roots(roots) * power(x * x - poly(2), 2);
    const auto found = isolate_real_roots(p);
    BOOST_TEST_REQUIRE(found.size() == 13U);
    int multiple = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
        if (k > 0) BOOST_TEST((found[k - 1].high <= found[k].low || found[k].exact()));
        const auto fine = refine(squarefree(p), found[k], rational(1, 1000000));
        BOOST_TEST((fine.exact() || fine.high - fine.low <= rational(1, 1000000)));
        if (found[k].multiplicity == 2) {
            ++multiple;
            BOOST_TEST((fine.low * fine.low - 2) * (fine.high * fine.high - 2) < 0);
        }
    }
    BOOST_TEST(multiple == 2);
}

BOOST_AUTO_TEST_CASE(nonnegativity_is_decided_where_a_polynomial_touches_zero) {
    const poly touching = power(x * x - poly(2), 2) * (x * x + poly(1));
    BOOST_TEST(!negative_point(touching));
    // pushed below zero by 1e-30 it is negative, near sqrt(2) only: sampling would not see it
    rational tiny(1);
    for (int k = 0; k < 30; ++k) tiny /= 10;
    const auto witness = negative_point(touching - poly(tiny));
    BOOST_TEST_REQUIRE(witness.has_value());
    BOOST_TEST((touching - poly(tiny))(*witness) < 0);
    BOOST_TEST(negative_point(x).has_value());
    BOOST_TEST(!negative_point_from_zero(x));
    BOOST_TEST(!negative_point_from_zero(power(x - poly(2), 2) * (x + poly(1))));
    const poly dips = power(x - poly(1), 2) * (x * x - poly(2)) * (x - poly(rational(3, 2)));
    const auto dip = negative_point_from_zero(dips);  // between sqrt 2 and 3/2 only up to there, then from 0
    BOOST_TEST_REQUIRE(dip.has_value() == negative_point_from_zero(-dips).has_value());
    BOOST_TEST(dips(*dip) < 0);
    BOOST_TEST(*dip >= 0);
}

BOOST_AUTO_TEST_CASE(the_first_sign_loss_is_enclosed_and_touching_zero_is_none) {
    const rational width(1, 1000000);
    const auto loss = first_sign_loss(power(x - poly(1), 2) * (poly(2) - x * x), width);
    BOOST_TEST_REQUIRE(loss.has_value());
    BOOST_TEST(loss->low * loss->low < 2);
    BOOST_TEST(loss->high * loss->high > 2);
    BOOST_TEST(loss->high - loss->low <= width);
    BOOST_TEST(first_sign_loss(-x, width)->high == 0);
    BOOST_TEST(!first_sign_loss(power(x - poly(1), 2), width).has_value());
    // a root left of zero whose isolating interval reaches across zero does not count
    BOOST_TEST(!first_sign_loss(x + poly(rational(1, 3)), width).has_value());
    BOOST_TEST(first_sign_loss(poly(rational(1, 3)) - x, width)->low > 0);
}

BOOST_AUTO_TEST_CASE(half_plane_counts_match_products_of_known_factors) {
    std::mt19937 random(7);
    const auto number = [&](int low, int high) {
        return rational(std::uniform_int_distribution<int>(low, high)(random), 3);
    };
    for (int trial = 0; trial < 200; ++trial) {
        poly p(number(1, 9));
        half_plane_count expected;
        const int linear = std::uniform_int_distribution<int>(0, 3)(random);
        for (int k = 0; k < linear; ++k) {
            const auto root = number(-3, 3);
            p *= x - poly(root);
            (root < 0 ? expected.left : root == 0 ? expected.axis : expected.right) += 1;
        }
        const int pairs = std::uniform_int_distribution<int>(0, 3)(random);
        for (int k = 0; k < pairs; ++k) {  // (z - a)^2 + b^2
            const auto a = number(-3, 3);
            const auto b = number(1, 6);
            p *= power(x - poly(a), 2) + poly(b * b);
            (a < 0 ? expected.left : a == 0 ? expected.axis : expected.right) += 2;
        }
        BOOST_TEST((count_half_planes(p) == expected), to_string(p));
    }
    BOOST_CHECK_THROW(count_half_planes(poly()), std::domain_error);
}

BOOST_AUTO_TEST_CASE(the_same_algorithms_run_at_compile_time) {
    using small = polynomial<small_rational>;
    static constexpr auto count = [](long constant) {
        const small p{small_rational(constant), small_rational(0), small_rational(1)};
        return sturm_chain<small_rational>(p).count();
    };
    static_assert(count(-2) == 2);
    static_assert(count(2) == 0);
    static_assert(count_half_planes(small{small_rational(1), small_rational(2), small_rational(1)}).left ==
                  2);
    BOOST_TEST(count(0) == 1);
}
