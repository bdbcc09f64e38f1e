// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE quadratic
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/quadratic.hpp>
#include <utility>

using stagecraft::tableaux::exact_sqrt;
using stagecraft::tableaux::mixed_surds;
using stagecraft::tableaux::quadratic;
using stagecraft::tableaux::rational;
using stagecraft::tableaux::split_square;

BOOST_AUTO_TEST_CASE(square_factors_leave_the_root) {
    BOOST_TEST(quadratic(0, 1, 12).str() == "2*sqrt(3)");
    BOOST_TEST(quadratic(1, 1, 49).str() == "8");
    BOOST_TEST(quadratic(0, 1, 1000003ull * 1000003ull * 5).str() == "1000003*sqrt(5)");
    BOOST_CHECK_THROW(quadratic(0, 1, (1ull << 48) + 1), std::overflow_error);
    for (std::uint64_t n = 1; n < 3000; ++n) {
        const auto [root, core] = split_square(n);
        BOOST_TEST(root * root * core == n);
        for (std::uint64_t p = 2; p * p <= core; ++p) BOOST_TEST(core % (p * p) != 0u);
    }
}

BOOST_AUTO_TEST_CASE(prints_what_the_reader_reads) {
    const rational half(1, 2);
    BOOST_TEST(quadratic(half, rational(-1, 6), 3).str() == "1/2-1/6*sqrt(3)");
    BOOST_TEST(quadratic(0, -1, 5).str() == "-sqrt(5)");
    BOOST_TEST(quadratic(-1, 1, 5).str() == "-1+sqrt(5)");
    BOOST_TEST(quadratic(half).str() == "1/2");
}

BOOST_AUTO_TEST_CASE(two_surds_make_a_field_and_a_third_has_no_place_in_it) {
    const quadratic r2(0, 1, 2), r3(0, 1, 3), r5(0, 1, 5);
    BOOST_TEST((r2 + r3).str() == "sqrt(2)+sqrt(3)");
    BOOST_TEST((r2 * r3) == quadratic(0, 1, 6));
    BOOST_TEST((quadratic(0, 1, 6) * quadratic(0, 1, 10)).str() == "2*sqrt(15)");
    BOOST_TEST((r2 < r3));
    BOOST_TEST((r2 == r3) == false);
    BOOST_TEST((r2 - r2 + r3) == r3);                // a difference that vanished is rational again
    const quadratic square = (r2 + r3) * (r2 + r3);  // 5 + 2 sqrt(6), a zero of x^2 - 10 x + 1
    BOOST_TEST(square * square - quadratic(10) * square + quadratic(1) == quadratic(0));
    BOOST_CHECK_THROW(r2 + r3 + r5, mixed_surds);
    BOOST_TEST(((r2 + r3) * r5).str() == "sqrt(10)+sqrt(15)");
    BOOST_CHECK_THROW((r2 + r3) * r5 + r2, mixed_surds);
    BOOST_CHECK_THROW((void)(r2 + r3 < r5), mixed_surds);
    const quadratic large(0, 1, 281474976710597ull), other(0, 1, 281474976710591ull);  // primes below 2^48
    BOOST_CHECK_THROW(large * other, mixed_surds);
}

BOOST_AUTO_TEST_CASE(field_axioms_and_order_with_two_surds_agree_with_fifty_digits) {
    using wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>,
                                               boost::multiprecision::et_off>;
    std::mt19937 random(11);
    const auto number = [&] {
        return random() % 4 == 0 ? rational(0) : rational(int(random() % 41) - 20, int(random() % 12) + 1);
    };
    for (const auto& [first, second] : {std::pair(3u, 7u), std::pair(6u, 10u), std::pair(2u, 6u)}) {
        const std::uint64_t d = first, e = second;
        const auto element = [&] {
            return quadratic(number(), number(), d) + quadratic(0, number(), e) +
                   quadratic(0, number(), d * e);
        };
        for (int i = 0; i < 200; ++i) {
            const quadratic x = element(), y = element(), z = element();
            BOOST_TEST(x * (y + z) == x * y + x * z);
            BOOST_TEST((x * y) * z == x * (y * z));
            BOOST_TEST((x - y) + y == x);
            if (y != 0) BOOST_TEST(x / y * y == x);
            BOOST_TEST((x < y) == (x != y && x.to<wide>() < y.to<wide>()));
            BOOST_TEST(abs((x * y).to<wide>() - x.to<wide>() * y.to<wide>()) < wide("1e-45"));
        }
    }
}

BOOST_AUTO_TEST_CASE(field_axioms_and_order_agree_with_fifty_digits) {
    using wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                               boost::multiprecision::et_off>;
    std::mt19937 random(7);
    const auto number = [&] { return rational(int(random() % 41) - 20, int(random() % 12) + 1); };
    for (int i = 0; i < 300; ++i) {
        const quadratic x(number(), number(), 7), y(number(), number(), 7), z(number(), number(), 7);
        BOOST_TEST(x * (y + z) == x * y + x * z);
        BOOST_TEST((x - y) + y == x);
        if (y != 0) BOOST_TEST(x / y * y == x);
        BOOST_TEST((x < y) == (x != y && x.to<wide>() < y.to<wide>()));
        BOOST_TEST(abs((x * y).to<wide>() - x.to<wide>() * y.to<wide>()) < wide("1e-45"));
        BOOST_TEST(exact_sqrt(x * x).value() == abs(x));
    }
    BOOST_CHECK_THROW(quadratic(0, 1, 2) / quadratic(0), std::domain_error);
}

BOOST_AUTO_TEST_CASE(sign_sees_what_a_double_does_not) {
    // Convergents of sqrt(2): p^2 - 2 q^2 = 1, so p - q sqrt(2) is positive and about 1/(2p).
    rational p = 3, q = 2;
    for (int i = 0; i < 40; ++i) {
        const rational next = rational(3) * p + rational(4) * q;
        q = rational(2) * p + rational(3) * q;
        p = next;
    }
    BOOST_TEST(sign(quadratic(p, -q, 2)) == 1);
    BOOST_TEST(sign(quadratic(-p, q, 2)) == -1);
    BOOST_TEST(quadratic(p, -q, 2).to<double>() == 1 / (2 * p.to<double>()),
               boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(nested_roots_denest_where_the_norm_is_a_square) {
    BOOST_TEST(exact_sqrt(quadratic(5, 2, 6)).value() == quadratic(0, 1, 2) + quadratic(0, 1, 3));
    BOOST_TEST(exact_sqrt(quadratic(5, -2, 6)).value() == quadratic(0, 1, 3) - quadratic(0, 1, 2));
    BOOST_TEST(exact_sqrt(quadratic(3, 2, 2)).value() == quadratic(1, 1, 2));
    BOOST_TEST(exact_sqrt(quadratic(3, -2, 2)).value() == quadratic(-1, 1, 2));
    BOOST_TEST(!exact_sqrt(quadratic(1, 1, 2)).has_value());
    BOOST_TEST(!exact_sqrt(rational(-1)).has_value());
    BOOST_TEST(exact_sqrt(rational(3, 4)).value() == quadratic(0, rational(1, 2), 3));
}

BOOST_AUTO_TEST_CASE(a_tableau_stores_quadratics_and_no_double_converts) {
    static_assert(!std::is_constructible_v<quadratic, double>);
    stagecraft::tableau<quadratic> gauss2;
    gauss2.A.resize(2, 2);
    const rational q(1, 4);
    gauss2.A << quadratic(q), quadratic(q, rational(-1, 6), 3), quadratic(q, rational(1, 6), 3), quadratic(q);
    const quadratic sum = gauss2.A(0, 0) + gauss2.A(0, 1);
    BOOST_TEST(sum * sum - sum + quadratic(rational(1, 6)) == quadratic(0));  // a zero of the Legendre P_2
}
