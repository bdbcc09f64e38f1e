// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE enclosures
#include <boost/test/unit_test.hpp>
#include <random>
#include <set>
#include <stagecraft/tableaux/complex_roots.hpp>
#include <stagecraft/tableaux/decimals.hpp>
#include <stagecraft/tableaux/legendre.hpp>
#include <stagecraft/tableaux/roots.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <stagecraft/tableaux/transformed.hpp>
#include <string>
#include <vector>

using namespace stagecraft::tableaux;

namespace {

using matrix = stagecraft::tableau<ball>::matrix;

/// Whether q lies in the ball and the ball is narrower than 2^-bits.
bool tight(const ball& x, const rational& q, int bits) {
    return x.contains(q) && x.radius() < std::ldexp(bound(1), -bits);
}

matrix product(const matrix& a, const matrix& b) {
    matrix c(a.rows(), b.cols());
    for (Eigen::Index i = 0; i < c.rows(); ++i)
        for (Eigen::Index j = 0; j < c.cols(); ++j) {
            c(i, j) = 0;
            for (Eigen::Index k = 0; k < b.rows(); ++k) c(i, j) += a(i, k) * b(k, j);
        }
    return c;
}

ball power(const ball& x, int k) {
    ball p = 1;
    for (int j = 0; j < k; ++j) p *= x;
    return p;
}

}  // namespace

BOOST_AUTO_TEST_CASE(smallest_gauss_node_of_one_hundred_is_the_published_one) {
    const auto nodes = enclose_nodes(nodal_polynomial(family::gauss, 100), 600);
    const ball mapped = nodes[0].times(2) - ball(1);
    // 60 digits, from REFERENCE
    BOOST_TEST(*decimal_text(mapped, 60) ==
               "-0.999713726773441233678228469342300676718349527308403226734198");
}

BOOST_AUTO_TEST_CASE(nodes_are_separate_sign_changes_of_the_exact_polynomial) {
    for (const family f : all_families)
        for (const int s : {2, 5, 8}) {
            const nodal_polynomial w(f, s);
            const auto nodes = enclose_nodes(w, 160);
            BOOST_REQUIRE_EQUAL(nodes.size(), static_cast<std::size_t>(s));
            for (std::size_t i = 0; i < nodes.size(); ++i) {
                const rational below = w.monomial()(nodes[i].lower()), above = w.monomial()(nodes[i].upper());
                BOOST_TEST((nodes[i].exact() ? below == 0 : below * above < 0));
                if (i > 0) BOOST_TEST((nodes[i - 1].upper() < nodes[i].lower()));
            }
        }
}

BOOST_AUTO_TEST_CASE(legendre_values_enclose_the_exact_ones_and_lose_a_few_bits_only) {
    const int n = 60;
    for (const rational& x :
         {rational(0), rational(1), rational(1, 2), rational(1, 3), rational(999, 1000)}) {
        const auto table = legendre_values(ball(x, 192), n, true);
        for (const int k : {1, 2, 7, n}) {
            std::vector<rational> coordinates(static_cast<std::size_t>(k) + 1, rational(0));
            coordinates.back() = 1;
            const polynomial<rational> p = from_legendre(coordinates);
            BOOST_TEST(tight(table.value[static_cast<std::size_t>(k)], p(x), 170), k << " at " << x.str());
            BOOST_TEST(tight(table.slope[static_cast<std::size_t>(k)], derivative(p)(x), 155));
        }
    }
    BOOST_CHECK_THROW(legendre_values(ball(rational(3, 2), 192), 3), undecided);
}

BOOST_AUTO_TEST_CASE(structural_zeros_stay_zeros_where_symmetry_gives_half_of_the_rows) {
    for (const family f : {family::gauss, family::lobatto_iiia, family::lobatto_iiib})
        for (const int s : {6, 7}) {
            const auto t = enclose(nodal_polynomial(f, s), construction_of(f), 256);
            for (int i = 0; i < s; ++i)
                for (int j = 0; j < s; ++j) {
                    const bool zero =
                        (f == family::lobatto_iiia && i == 0) || (f == family::lobatto_iiib && j == s - 1);
                    BOOST_TEST(t.A(i, j).exactly_zero() == zero);
                }
        }
}

BOOST_AUTO_TEST_CASE(digits_agree_with_those_at_higher_precision) {
    for (const int digits : {20, 50, 100, 1000}) {
        const auto narrow = decimals(family::radau_iia, 7, digits);
        const auto t = enclose(nodal_polynomial(family::radau_iia, 7), construction::collocation,
                               2 * bits_for_digits(digits) + 200);
        for (Eigen::Index i = 0; i < 7; ++i) {
            const auto at = static_cast<std::size_t>(i);
            BOOST_TEST(narrow.b[at] == *decimal_text(t.b(i), digits));
            BOOST_TEST(narrow.c[at] == *decimal_text(t.c(i), digits));
            for (Eigen::Index j = 0; j < 7; ++j)
                BOOST_TEST(narrow.A[at][static_cast<std::size_t>(j)] == *decimal_text(t.A(i, j), digits));
        }
    }
}

BOOST_AUTO_TEST_CASE(hundred_stages_satisfy_the_quadrature_and_collocation_conditions) {
    const int s = 100;
    const auto t = enclose(nodal_polynomial(family::gauss, s), construction::collocation, 540);
    for (const int k : {1, 2, 50, 100, 199, 200}) {
        ball sum = 0;
        for (int j = 0; j < s; ++j) sum += t.b(j) * power(t.c(j), k - 1);
        BOOST_TEST(tight(sum, rational(1, k), 340));
    }
    ball beyond = 0;  // B(2s+1) fails by an error of about 16^-s
    for (int j = 0; j < s; ++j) beyond += t.b(j) * power(t.c(j), 2 * s);
    BOOST_TEST(!beyond.contains(rational(1, 2 * s + 1)));
    for (const int i : {0, 37, 99})
        for (const int k : {1, 60, 100}) {
            ball residual = -power(t.c(i), k).over(k);
            for (int j = 0; j < s; ++j) residual += t.A(i, j) * power(t.c(j), k - 1);
            BOOST_TEST(tight(residual, 0, 340));
        }
}

BOOST_AUTO_TEST_CASE(enclosures_contain_the_exact_surds) {
    int compared = 0;
    for (const family f : all_families)
        for (int s = least_stages(f); s <= 5; ++s) {
            const auto exact = exact_tableau(f, s);
            const bool lobatto = least_stages(f) == 2;
            BOOST_TEST(exact.has_value() == (lobatto || s <= 3), name(f) << " " << s);
            if (!exact) continue;
            const auto t = enclose(nodal_polynomial(f, s), construction_of(f), 256);
            const auto same = [&](const ball& x, const quadratic& q) {
                ++compared;
                const ball difference = x - to_ball(q, 400);
                BOOST_TEST(tight(difference, 0, 230), name(f) << " " << s << ": " << q.str());
            };
            for (Eigen::Index i = 0; i < s; ++i) {
                same(t.c(i), exact->c(i));
                same(t.b(i), exact->b(i));
                for (Eigen::Index j = 0; j < s; ++j) same(t.A(i, j), exact->A(i, j));
            }
        }
    BOOST_TEST(compared == 5 * (14 + 2 * 6) + 3 * (54 + 2 * 14));
}

BOOST_AUTO_TEST_CASE(radau_iia_3_is_hairer_and_wanners) {
    const auto t = *exact_tableau(family::radau_iia, 3);
    BOOST_TEST(t.c(0) == quadratic(rational(2, 5), rational(-1, 10), 6));
    BOOST_TEST(t.A(0, 0) == quadratic(rational(11, 45), rational(-7, 360), 6));
    BOOST_TEST(t.A(1, 2) == quadratic(rational(-2, 225), rational(-1, 75), 6));
    BOOST_TEST(t.b(2) == quadratic(rational(1, 9)));
}

BOOST_AUTO_TEST_CASE(the_transformation_diagonalises_the_inverse) {
    for (const family f : {family::gauss, family::radau_ia, family::radau_iia, family::lobatto_iiic})
        for (const int s : {1, 2, 3, 6, 11}) {
            if (s < least_stages(f)) continue;
            const auto t = enclose_transformed(nodal_polynomial(f, s), construction_of(f), 320);
            const matrix unit = product(t.A, t.A_inverse);
            const matrix block = product(product(t.T_inverse, t.A_inverse), t.T);
            matrix expected(s, s);
            for (int i = 0; i < s; ++i)
                for (int j = 0; j < s; ++j) expected(i, j) = 0;
            const auto real = t.gamma.size();
            BOOST_TEST(real == s % 2);
            for (Eigen::Index k = 0; k < real; ++k) expected(k, k) = t.gamma(k);
            for (Eigen::Index k = 0; k < t.beta.size(); ++k) {
                const auto at = real + 2 * k;
                expected(at, at) = expected(at + 1, at + 1) = t.alpha(k);
                expected(at, at + 1) = t.beta(k);
                expected(at + 1, at) = -t.beta(k);
                BOOST_TEST(t.T(s - 1, at).contains(1));
                BOOST_TEST(t.T(s - 1, at + 1).exactly_zero());
                if (k > 0) BOOST_TEST(certainly_less(t.beta(k - 1), t.beta(k)));
            }
            for (int i = 0; i < s; ++i)
                for (int j = 0; j < s; ++j) {
                    BOOST_TEST(tight(unit(i, j), i == j ? 1 : 0, 200));
                    BOOST_TEST(tight(block(i, j) - expected(i, j), 0, 200));
                }
        }
}

BOOST_AUTO_TEST_CASE(characteristic_polynomial_is_the_denominator_of_pade) {
    // Q_{kj}(z) = sum over m of (j+k-m)! j! / ((j+k)! m! (j-m)!) (-z)^m; (k, j) = (s, s), (s-1, s), (s-2, s)
    const auto pade = [](int k, int j) {
        polynomial<rational> q;
        rational a = 1;
        for (int m = 0; m <= j; ++m) {
            q += polynomial<rational>::monomial(m, a);
            if (m < j) a *= rational(m - j, (j + k - m) * (m + 1));
        }
        return monic(q);
    };
    for (int s = 2; s <= 12; ++s) {
        const auto of = [s](family f) {
            const nodal_polynomial w(f, s);
            return monic(characteristic_polynomial(w, inverse_form_of(w, construction_of(f))));
        };
        BOOST_TEST((of(family::gauss) == pade(s, s)));
        BOOST_TEST((of(family::radau_ia) == pade(s - 1, s)));
        BOOST_TEST((of(family::radau_iia) == pade(s - 1, s)));
        BOOST_TEST((of(family::lobatto_iiic) == pade(s - 2, s)));
        BOOST_TEST((of(family::gauss) != of(family::radau_iia)));
    }
}

BOOST_AUTO_TEST_CASE(singular_matrices_have_no_inverse) {
    for (const family f : {family::radau_i, family::radau_ii, family::lobatto_iiia, family::lobatto_iiib})
        BOOST_CHECK_THROW(inverse_form_of(nodal_polynomial(f, 4), construction_of(f)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(nodes_of_a_user_give_the_same_method_by_the_general_formula) {
    for (const int s : {3, 8}) {
        const nodal_polynomial w(family::radau_iia, s);
        const auto own = nodal_polynomial::from_coefficients(w.monomial().coefficients());
        const auto t = enclose(w, construction::collocation, 256);
        const auto u = enclose(own, construction::collocation, 256);
        const auto v = enclose(own, construction::adjoint, 256);
        const auto adjoint = enclose(nodal_polynomial(family::radau_ii, s), construction::adjoint, 256);
        for (int i = 0; i < s; ++i)
            for (int j = 0; j < s; ++j) {
                BOOST_TEST(tight(t.A(i, j) - u.A(i, j), 0, 200));
                BOOST_TEST(tight(adjoint.A(i, j) - v.A(i, j), 0, 200));
            }
    }
}

BOOST_AUTO_TEST_CASE(equidistant_nodes_have_real_and_complex_eigenvalues) {
    const auto w = nodal_polynomial::from_nodes({rational(1, 3), rational(2, 3), rational(1)});
    const auto t = enclose_transformed(w, construction::collocation, 200);
    BOOST_TEST(t.gamma.size() == 1);
    BOOST_TEST(t.c(0).contains(rational(1, 3)));
    // C(1) ... C(3) determine A: a_11 = 23/36, a_12 = -4/9, a_13 = 5/36 (Simpson-like weights)
    BOOST_TEST(tight(t.A(0, 0), rational(23, 36), 150));
    BOOST_TEST(tight(t.A(0, 1), rational(-4, 9), 150));
    BOOST_TEST(tight(t.A(0, 2), rational(5, 36), 150));
    BOOST_CHECK_THROW(
        enclose_transformed(nodal_polynomial::from_nodes({0, 1}), construction::collocation, 200),
        std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(nodes_next_to_the_ends_and_to_one_another_are_enclosed) {
    const auto tiny = [](int digits) {
        return rational(integer(1), pow(integer(10), static_cast<unsigned>(digits)));
    };
    for (const int digits : {20, 48, 60, 80, 200}) {
        const rational e = tiny(digits), third(1, 3), half(1, 2);
        for (const auto& given : std::vector<std::vector<rational>>{{e, 1},
                                                                    {0, rational(1) - e},
                                                                    {third - e, third + e},
                                                                    {half - e, half, half + e},
                                                                    {e, 2 * e, half}}) {
            const auto w = nodal_polynomial::from_nodes(given);
            const auto nodes = enclose_nodes(w, 64);
            BOOST_REQUIRE(nodes.size() == given.size());
            for (std::size_t i = 0; i < nodes.size(); ++i)
                BOOST_TEST(tight(nodes[i], given[i], 50 + 3 * digits), digits << ", node " << i + 1);
            // one entry of the tableau in closed form: b of two nodes u, v is (1/2 - v)/(u - v)
            if (given.size() != 2 || digits > 80) continue;
            const auto t = rounded<double>(w, construction::collocation);
            const rational b = (half - given[1]) / (given[0] - given[1]);
            BOOST_REQUIRE(t.b.size() == 2);
            BOOST_TEST(t.b(0) == b.to<double>(), digits);
        }
    }
}

BOOST_AUTO_TEST_CASE(random_rational_nodes_are_the_nodes_of_the_exact_tableau) {
    std::mt19937 random(6);
    for (int k = 0; k < 300; ++k) {
        std::set<rational> given;
        if (k % 3 != 0) given.insert(k % 2);  // often an end
        const int s = 1 + static_cast<int>(random() % 5), most = 2 + static_cast<int>(random() % 30);
        while (static_cast<int>(given.size()) < s && static_cast<int>(given.size()) < most) {
            const int d = 1 + static_cast<int>(random() % static_cast<unsigned>(most));
            given.insert(rational(static_cast<int>(random() % static_cast<unsigned>(d + 1)), d));
        }
        const auto w = nodal_polynomial::from_nodes({given.begin(), given.end()});
        const auto t = exact_tableau(w, construction::collocation);
        BOOST_REQUIRE((t && t->c.size() == static_cast<Eigen::Index>(given.size())));
        Eigen::Index i = 0;
        for (const rational& c : given) BOOST_TEST((t->c[i++] == quadratic(c)), k);
    }
}

BOOST_AUTO_TEST_CASE(too_few_bits_are_refused_not_guessed) {
    const auto t = enclose(nodal_polynomial(family::gauss, 30), construction::collocation, 64);
    BOOST_TEST(!decimal_text(t.A(0, 0), 30).has_value());
}

BOOST_AUTO_TEST_CASE(complex_roots_are_proved_and_multiple_ones_refused) {
    const polynomial<rational> x = polynomial<rational>::x();
    const auto roots = enclose_roots((x * x + polynomial<rational>(1)) * (x - polynomial<rational>(3)) *
                                         (x + polynomial<rational>(rational(1, 2))),
                                     256);
    BOOST_REQUIRE_EQUAL(roots.real.size(), 2u);
    BOOST_REQUIRE_EQUAL(roots.upper.size(), 1u);
    BOOST_TEST(tight(roots.real[0], rational(-1, 2), 200));
    BOOST_TEST(tight(roots.real[1], 3, 200));
    BOOST_TEST(tight(roots.upper[0].re, 0, 200));
    BOOST_TEST(tight(roots.upper[0].im, 1, 200));
    BOOST_CHECK_THROW(enclose_roots(power(x - polynomial<rational>(2), 2), 256), undecided);
}
