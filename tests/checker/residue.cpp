// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE residue
#include <boost/test/unit_test.hpp>
#include <random>
#include <stagecraft/tableaux/residue.hpp>

using stagecraft::tableaux::quadratic;
using stagecraft::tableaux::rational;
using stagecraft::tableaux::residue;
using stagecraft::tableaux::residue_of;

BOOST_AUTO_TEST_CASE(reduction_respects_the_field_operations) {
    std::mt19937_64 random(3);
    const auto number = [&] {
        const auto part = [&] { return rational(std::int64_t(random()), std::int64_t(random() >> 20) + 1); };
        return quadratic(part(), part(), 21);
    };
    for (int i = 0; i < 200; ++i) {
        const quadratic x = number(), y = number();
        BOOST_TEST((residue_of(x + y).value() == *residue_of(x) + *residue_of(y)));
        BOOST_TEST((residue_of(x - y).value() == *residue_of(x) - *residue_of(y)));
        BOOST_TEST((residue_of(x * y).value() == *residue_of(x) * *residue_of(y)));
        BOOST_TEST((residue_of(x / y).value() == *residue_of(x) / *residue_of(y)));
        BOOST_TEST((residue_of(x).value() == *residue_of(x * rational(3)) / residue(3)));
    }
    BOOST_TEST((residue(-1) + residue(1) == residue(0)));
    BOOST_TEST((residue(std::int64_t(residue::modulus)) == residue(0)));
}

BOOST_AUTO_TEST_CASE(reduction_respects_two_surds_that_meet) {
    std::mt19937_64 random(5);
    const auto part = [&] { return rational(std::int64_t(random()), std::int64_t(random() >> 20) + 1); };
    for (int i = 0; i < 100; ++i) {
        const quadratic x = quadratic(part(), part(), 3) + quadratic(0, part(), 7), y(part(), part(), 21);
        BOOST_TEST((residue_of(x * y).value() == *residue_of(x) * *residue_of(y)));
        BOOST_TEST((residue_of(x + y).value() == *residue_of(x) + *residue_of(y)));
        BOOST_TEST((residue_of(y / x).value() == *residue_of(y) / *residue_of(x)));
    }
    const auto root = residue_of(quadratic(0, 1, 2 * 3 * 5 * 7)).value();
    BOOST_TEST((root * root == residue(210)));
    BOOST_TEST(!residue_of(quadratic(0, 1, 281474976710597ull)).has_value());  // not factored
}

BOOST_AUTO_TEST_CASE(a_nonzero_residue_refutes_and_a_zero_one_does_not_prove) {
    BOOST_TEST(!(residue_of(rational(1, 3)).value() == residue_of(rational(333333333, 1000000000)).value()));
    BOOST_TEST((residue_of(rational(std::int64_t(residue::modulus))).value() == residue(0)));
    BOOST_TEST(!residue_of(rational(1, std::int64_t(residue::modulus))).has_value());
    BOOST_CHECK_THROW(residue(1) / residue(0), std::domain_error);
}
