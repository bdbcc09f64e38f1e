// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE tree_order
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdint>
#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/theory/models/matrix_model.hpp>
#include <stagecraft/theory/trees/tree_order.hpp>
#include <stdexcept>
#include <vector>

using namespace stagecraft;
using namespace stagecraft::theory;
using tableaux::quadratic;
using tableaux::rational;

namespace {

template <class K>
tableau<K> make(const std::vector<std::vector<K>>& A, const std::vector<K>& b) {
    const int s = static_cast<int>(b.size());
    tableau<K> t;
    t.A.resize(s, s);
    t.b.resize(s);
    t.c.resize(s);
    for (int i = 0; i < s; ++i) {
        t.b(i) = b[i];
        t.c(i) = K(0);
        for (int j = 0; j < s; ++j) {
            t.A(i, j) = A[i][j];
            t.c(i) += A[i][j];
        }
    }
    return t;
}

template <class K>
K q(int n, int d = 1) {
    return ratio<K>(n, d);
}

template <class K>
tableau<K> rk4() {
    return make<K>({{q<K>(0), q<K>(0), q<K>(0), q<K>(0)},
                    {q<K>(1, 2), q<K>(0), q<K>(0), q<K>(0)},
                    {q<K>(0), q<K>(1, 2), q<K>(0), q<K>(0)},
                    {q<K>(0), q<K>(0), q<K>(1), q<K>(0)}},
                   {q<K>(1, 6), q<K>(1, 3), q<K>(1, 3), q<K>(1, 6)});
}

quadratic surd(int n, int m, int d, int radicand) {
    return {rational(n, d), rational(m, d), static_cast<std::uint64_t>(radicand)};
}

// Hairer-Wanner II.IV.5: Gauss of order 4 and 6, Radau IIA of order 3 and 5.
tableau<quadratic> gauss_2() {
    return make<quadratic>(
        {{quadratic(rational(1, 4)), surd(3, -2, 12, 3)}, {surd(3, 2, 12, 3), quadratic(rational(1, 4))}},
        {quadratic(rational(1, 2)), quadratic(rational(1, 2))});
}
tableau<quadratic> gauss_3() {
    using Q = quadratic;
    return make<Q>({{Q(rational(5, 36)), surd(10, -3, 45, 15), surd(25, -6, 180, 15)},
                    {surd(10, 3, 72, 15), Q(rational(2, 9)), surd(10, -3, 72, 15)},
                    {surd(25, 6, 180, 15), surd(10, 3, 45, 15), Q(rational(5, 36))}},
                   {Q(rational(5, 18)), Q(rational(4, 9)), Q(rational(5, 18))});
}
tableau<quadratic> radau_iia_3() {
    return make<quadratic>({{surd(88, -7, 360, 6), surd(296, -169, 1800, 6), surd(-2, 3, 225, 6)},
                            {surd(296, 169, 1800, 6), surd(88, 7, 360, 6), surd(-2, -3, 225, 6)},
                            {surd(16, -1, 36, 6), surd(16, 1, 36, 6), quadratic(rational(1, 9))}},
                           {surd(16, -1, 36, 6), surd(16, 1, 36, 6), quadratic(rational(1, 9))});
}
tableau<rational> radau_iia_2() {
    return make<rational>({{{5, 12}, {-1, 12}}, {{3, 4}, {1, 4}}}, {{3, 4}, {1, 4}});
}
// Hairer-Wanner II.IV.5, table 5.12: Lobatto IIIC of order 6.
tableau<quadratic> lobatto_iiic_4() {
    using Q = quadratic;
    const Q twelfth(rational(1, 12));
    return make<Q>({{twelfth, surd(0, -1, 12, 5), surd(0, 1, 12, 5), Q(rational(-1, 12))},
                    {twelfth, Q(rational(1, 4)), surd(10, -7, 60, 5), surd(0, 1, 60, 5)},
                    {twelfth, surd(10, 7, 60, 5), Q(rational(1, 4)), surd(0, -1, 60, 5)},
                    {twelfth, Q(rational(5, 12)), Q(rational(5, 12)), twelfth}},
                   {twelfth, Q(rational(5, 12)), Q(rational(5, 12)), twelfth});
}

template <class K>
int exact_order(const tableau<K>& t) {
    const auto result = order_of(matrix_model(t), 2 * t.stages() + 1);
    BOOST_TEST(result.is_exact());
    for (const auto& f : result.failing) BOOST_TEST(order(f.tree) == result.order + 1);
    return result.order;
}

}  // namespace

BOOST_AUTO_TEST_CASE(methods_over_q_and_quadratic_fields_have_their_orders) {
    BOOST_TEST(exact_order(rk4<rational>()) == 4);
    BOOST_TEST(exact_order(radau_iia_2()) == 3);
    BOOST_TEST(exact_order(gauss_2()) == 4);
    BOOST_TEST(exact_order(gauss_3()) == 6);
    BOOST_TEST(exact_order(radau_iia_3()) == 5);
    BOOST_TEST(exact_order(lobatto_iiic_4()) == 6);
}

BOOST_AUTO_TEST_CASE(a_search_that_ends_first_gives_a_lower_bound_only) {
    const auto result = order_of(matrix_model(gauss_3()), 4);
    BOOST_TEST(result.order == 4);
    BOOST_TEST(!result.is_exact());
    BOOST_CHECK_THROW(order_of(matrix_model(gauss_2()), 0), std::invalid_argument);
    BOOST_CHECK_THROW(order_of(matrix_model(gauss_2()), 21), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_wrong_entry_fails_the_conditions_it_enters) {
    auto t = rk4<rational>();
    t.b(3) = {1, 7};
    const auto wrong_b = order_of(matrix_model(t), 9);
    BOOST_TEST(wrong_b.order == 0);
    BOOST_REQUIRE(wrong_b.failing.size() == 1U);
    BOOST_TEST((wrong_b.failing[0].tree == rooted_tree{}));
    BOOST_TEST((wrong_b.failing[0].residual == rational(-1, 42)));

    t = rk4<rational>();
    t.A(2, 1) = {1, 3};  // c_3 changes with it: b^T A 1 = 1/3*1/2 + 1/3*1/3 + 1/6
    const auto wrong_a = order_of(matrix_model(t), 9);
    BOOST_TEST(wrong_a.order == 1);
    BOOST_REQUIRE(wrong_a.failing.size() == 1U);
    BOOST_TEST((wrong_a.failing[0].tree == rooted_tree{1, 2}));
    BOOST_TEST((wrong_a.failing[0].residual == rational(-1, 18)));
}

BOOST_AUTO_TEST_CASE(rk4_fails_order_five_with_known_residuals) {
    const auto failing = failing_conditions(matrix_model(rk4<rational>()), 5);
    for (const auto& f : failing) BOOST_TEST(order(f.tree) == 5);
    // b^T c^4 = 5/24 and b^T A A A c = 0
    bool bushy = false, tall = false;
    for (const auto& f : failing) {
        if (f.tree == rooted_tree{1, 2, 2, 2, 2}) bushy = f.residual == rational(5, 24) - rational(1, 5);
        if (f.tree == rooted_tree{1, 2, 3, 4, 5}) tall = f.residual == rational(-1, 120);
    }
    BOOST_TEST(bushy);
    BOOST_TEST(tall);
}

BOOST_AUTO_TEST_CASE(principal_error_norms_are_those_of_the_reference) {
    // sqrt(1745)/2880, exactly
    BOOST_TEST(
        (local_error_terms(matrix_model(rk4<rational>()), 5).norm_squared == rational(1745, 2880 * 2880)));
    // Decimals as printed, to half a unit of their last digit.
    const auto norm = [](const auto& t, int p) {
        return std::sqrt(local_error_terms(matrix_model(t), p + 1).norm_squared.template to<double>());
    };
    BOOST_TEST(std::abs(norm(rk4<rational>(), 4) - 0.0145045823) < 0.5e-10);
    BOOST_TEST(std::abs(norm(gauss_2(), 4) - 0.00433062198) < 0.5e-11);
    BOOST_TEST(std::abs(norm(gauss_3(), 6) - 1.65046691e-4) < 0.5e-12);
    BOOST_TEST(std::abs(norm(radau_iia_2(), 3) - 0.0244976973) < 0.5e-10);
    BOOST_TEST(std::abs(norm(radau_iia_3(), 5) - 9.89528507e-4) < 0.5e-12);
    BOOST_TEST(std::abs(norm(lobatto_iiic_4(), 6) - 2.20062254e-4) < 0.5e-12);
    // and where all conditions hold there is nothing
    BOOST_TEST((local_error_terms(matrix_model(gauss_3()), 6).norm_squared == quadratic(0)));
}
