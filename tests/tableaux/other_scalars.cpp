// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE other_scalars
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stagecraft/tableaux/rounded.hpp>
#include <vector>

#include "../message.hpp"

using namespace stagecraft::tableaux;
using boost::multiprecision::cpp_bin_float_50;
using boost::multiprecision::cpp_dec_float_50;

namespace {

/// Largest entry of T^-1 A^-1 T minus its blocks, and of A A^-1 - I.
template <class Real>
Real residual(const stagecraft::transformed_tableau<Real>& t) {
    using std::abs;
    const auto s = t.b.size();
    const auto product = [&](const auto& a, const auto& b) {
        auto c = t.A;
        for (Eigen::Index i = 0; i < s; ++i)
            for (Eigen::Index j = 0; j < s; ++j) {
                c(i, j) = 0;
                for (Eigen::Index k = 0; k < s; ++k) c(i, j) += a(i, k) * b(k, j);
            }
        return c;
    };
    auto block = product(product(t.T_inverse, t.A_inverse), t.T);
    const auto unit = product(t.A, t.A_inverse);
    const auto real = t.gamma.size();
    for (Eigen::Index k = 0; k < real; ++k) block(k, k) -= t.gamma(k);
    for (Eigen::Index k = 0; k < t.beta.size(); ++k) {
        const auto at = real + 2 * k;
        block(at, at) -= t.alpha(k);
        block(at + 1, at + 1) -= t.alpha(k);
        block(at, at + 1) -= t.beta(k);
        block(at + 1, at) += t.beta(k);
    }
    Real largest = 0;
    for (Eigen::Index i = 0; i < s; ++i)
        for (Eigen::Index j = 0; j < s; ++j) {
            const Real x = abs(block(i, j)), y = abs(Real(unit(i, j) - (i == j ? 1 : 0)));
            largest = std::max({largest, x, y});
        }
    return largest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(fifty_digits_are_fifty_digits) {
    const auto t = transformed<cpp_bin_float_50>(family::radau_iia, 5);
    BOOST_TEST(residual(t) < 1e-46);
    const auto u = transformed<cpp_dec_float_50>(family::radau_iia, 5);
    BOOST_TEST(residual(u) < 1e-46);
    BOOST_TEST(t.T(0, 1).str(45) == u.T(0, 1).str(45));
    const cpp_bin_float_50 c1 = (4 - sqrt(cpp_bin_float_50(6))) / 10;
    BOOST_TEST(abs(rounded<cpp_bin_float_50>(family::radau_iia, 3).c(0) - c1) < 1e-49);
    BOOST_TEST(abs(rounded<cpp_bin_float_50>(family::radau_iia, 3).c(0) - 0.15505102572168219) > 1e-18);
}

BOOST_AUTO_TEST_CASE(long_double_entries_are_the_nearest_ones) {
    const auto t = transformed<long double>(family::gauss, 6);
    BOOST_TEST(residual(t) < 1e-14L);
    const auto wide = transformed<cpp_bin_float_50>(family::gauss, 6);
    int entries = 0;
    const auto expect_nearest = [&](const auto& near, const auto& exact) {
        for (Eigen::Index i = 0; i < near.rows(); ++i)
            for (Eigen::Index j = 0; j < near.cols(); ++j) {
                ++entries;
                BOOST_TEST(near(i, j) == static_cast<long double>(exact(i, j)));
            }
    };
    expect_nearest(t.A, wide.A);
    expect_nearest(t.A_inverse, wide.A_inverse);
    expect_nearest(t.T, wide.T);
    expect_nearest(t.T_inverse, wide.T_inverse);
    BOOST_TEST(entries == 4 * 36);
}

BOOST_AUTO_TEST_CASE(nodes_of_a_user_give_a_transformed_tableau_with_any_eigenvalues) {
    const auto own = [](const std::vector<rational>& nodes) {
        return transformed<double>(nodal_polynomial::from_nodes(nodes), construction::collocation);
    };
    const auto two = own({rational(1, 10), rational(1)});  // two real eigenvalues
    BOOST_REQUIRE_EQUAL(two.gamma.size(), 2);
    BOOST_TEST(two.beta.size() == 0);
    BOOST_TEST(two.gamma(0) < two.gamma(1));
    BOOST_TEST(two.gamma(0) * two.gamma(1) == 20.0, boost::test_tools::tolerance(1e-15));  // 2 / (c_1 c_2)
    BOOST_TEST(residual(two) < 1e-13);
    const auto dyadic = own({rational(1, 8), rational(1, 4), rational(3, 8), rational(1)});
    BOOST_TEST(dyadic.gamma.size() + 2 * dyadic.beta.size() == 4);
    BOOST_TEST(residual(dyadic) < 1e-11);
    const auto third = own({rational(1, 3), rational(2, 3), rational(1)});
    BOOST_TEST(third.b(1) == 0.0);  // exactly: 3/4, 0, 1/4
    BOOST_TEST(third.b(0) == 0.75);
    BOOST_TEST(residual(third) < 1e-14);
}

BOOST_AUTO_TEST_CASE(facts_are_passed_on_and_singular_methods_refused) {
    stagecraft::facts known;
    known.order = 5;
    BOOST_TEST(transformed<double>(family::radau_iia, 3, known).facts.order == 5);
    BOOST_TEST(rounded<double>(family::lobatto_iiia, 3, known).facts.order == 5);
    for (const family f : {family::lobatto_iiia, family::lobatto_iiib})  // and what to take in their place
        BOOST_TEST(message([&] { transformed<double>(f, 3); }).find("rounded(), the plain tableau") !=
                   std::string::npos);
    const auto from_zero = nodal_polynomial::from_nodes({0, rational(1, 3), 1});
    BOOST_TEST(message([&] {
                   transformed<double>(from_zero, construction::collocation);
               }).find("node 0 is singular") != std::string::npos);
    BOOST_CHECK_THROW(rounded<double>(family::lobatto_iiia, 1), std::invalid_argument);
    BOOST_CHECK_THROW(rounded<double>(family::gauss, 0), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(widening_stops_with_the_reason) {
    int attempts = 0;
    BOOST_CHECK_THROW(widening(64,
                               [&](int) -> int {
                                   ++attempts;
                                   throw undecided("never");
                               }),
                      undecided);
    BOOST_TEST(attempts == 7);
    BOOST_TEST(widening(64, [](int bits) { return bits < 200 ? throw undecided("wider") : bits; }) == 256);
}
