// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE tree_weights
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/tableaux/family.hpp>
#include <stagecraft/tableaux/fixed_rational.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/theory/models/legendre_model.hpp>
#include <stagecraft/theory/models/matrix_model.hpp>
#include <stagecraft/theory/trees/tree_order.hpp>
#include <stdexcept>
#include <vector>

using namespace stagecraft;
using namespace stagecraft::theory;
using tableaux::family;
using tableaux::fixed_rational;
using tableaux::rational;

namespace {

// No structure at all: A, b with pairwise different entries, in any scalar.
template <class K>
tableau<K, 3> some_tableau() {
    tableau<K, 3> t;
    for (int i = 0; i < 3; ++i) {
        t.b(i) = ratio<K>(2 * i + 1, 7);
        t.c(i) = K(0);
        for (int j = 0; j < 3; ++j) {
            t.A(i, j) = ratio<K>(i - 2 * j + 1, i + j + 2);
            t.c(i) += t.A(i, j);
        }
    }
    return t;
}

// The definition (Hairer-Norsett-Wanner I.II.2, Definition 2.9), by recursion over children and without
// memory: g(t) = product over the children u of A g(u).
template <class M>
typename M::element stage_vector(const M& m, const rooted_tree& t) {
    typename M::element g = m.one();
    for (const rooted_tree& child : children(t)) g = m.multiply(g, m.apply(stage_vector(m, child)));
    return g;
}

template <class M>
void compare_with_definition(const M& m, int max_order) {
    using K = typename M::scalar;
    int compared = 0;
    for (const auto& [tree, residual] : order_residuals(m, max_order)) {
        const K defined = m.dot_b(stage_vector(m, tree)) - ratio<K>(1, density(tree));
        BOOST_REQUIRE(residual == defined);
        ++compared;
    }
    std::int64_t expected = 0;
    for (int n = 1; n <= max_order; ++n) expected += number_of_trees(n);
    BOOST_TEST(compared == expected);
}

}  // namespace

BOOST_AUTO_TEST_CASE(memoised_weights_are_those_of_the_definition) {
    compare_with_definition(matrix_model(some_tableau<rational>()), 8);
    compare_with_definition(legendre_model<rational>(family::lobatto_iiib, 4), 8);
    compare_with_definition(legendre_model<rational>(family::radau_ia, 3), 8);
}

BOOST_AUTO_TEST_CASE(floating_scalars_agree_with_exact_ones) {
    using real_100 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                                   boost::multiprecision::et_off>;
    const auto exact = order_residuals(matrix_model(some_tableau<rational>()), 9);
    const auto narrow = order_residuals(matrix_model(some_tableau<double>()), 9);
    const auto wide = order_residuals(matrix_model(some_tableau<real_100>()), 9);
    const auto enclosed = order_residuals(matrix_model(some_tableau<tableaux::ball>()), 9);
    BOOST_REQUIRE(narrow.size() == exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
        BOOST_REQUIRE(narrow[i].tree == exact[i].tree);
        const real_100 value = exact[i].residual.to<real_100>();
        BOOST_REQUIRE(abs(wide[i].residual - value) < real_100(1e-97) * (1 + abs(value)));
        BOOST_REQUIRE(std::abs(narrow[i].residual - static_cast<double>(value)) <
                      1e-13 * (1 + std::abs(static_cast<double>(value))));
        const auto off = enclosed[i].residual - tableaux::ball(exact[i].residual, 128);
        BOOST_REQUIRE(!certainly_nonzero(off));
        BOOST_REQUIRE(off.radius() < 1e-14);
    }
}

BOOST_AUTO_TEST_CASE(the_six_families_have_their_orders_by_trees) {
    // Hairer-Wanner II.IV.5, table 5.13: Gauss 2s, Radau 2s-1, Lobatto 2s-2; all trees, exactly.
    const std::map<family, int> short_of_2s{{family::gauss, 0},        {family::radau_ia, 1},
                                            {family::radau_iia, 1},    {family::lobatto_iiia, 2},
                                            {family::lobatto_iiib, 2}, {family::lobatto_iiic, 2}};
    for (const auto& [f, k] : short_of_2s)
        for (int s = 2; s <= 5; ++s) {
            const auto result = order_of(legendre_model<rational>(f, s), 2 * s + 1);
            BOOST_TEST(result.order == 2 * s - k, name(f) << " s = " << s);
            BOOST_TEST(result.is_exact());
        }
}

BOOST_AUTO_TEST_CASE(all_trees_to_order_ten_hold_for_gauss_5_at_compile_time) {
    static_assert(has_order<10>(legendre_model<fixed_rational>(family::gauss, 5)));
    static_assert(!has_order<9>(legendre_model<fixed_rational>(family::gauss, 4)));
    static_assert(!has_order<10>(legendre_model<fixed_rational>(family::radau_iia, 5)));
}

BOOST_AUTO_TEST_CASE(enclosures_refute_and_never_prove) {
    // Gauss of order 2 with its node off by 2^-40: refuted at order 2; as an enclosure of both, not refuted.
    using tableaux::ball;
    tableau<ball, 1> t;
    const rational off(tableaux::integer(1), tableaux::integer(1) << 40);
    t.b(0) = ball(1);
    t.A(0, 0) = t.c(0) = ball(rational(1, 2) + off, 128);
    const auto refuted = order_of(matrix_model(t), 3);
    BOOST_TEST(refuted.order == 1);
    BOOST_TEST(refuted.is_exact());
    t.A(0, 0) = t.c(0) = t.c(0).widened(0x1p-39);
    const auto open = order_of(matrix_model(t), 3);
    BOOST_TEST(open.order == 2);
    BOOST_TEST(open.failing.size() == 2U);  // b^T c^2 and b^T A c are near 1/4, certainly not 1/3 and 1/6
}

BOOST_AUTO_TEST_CASE(floating_scalars_need_a_criterion) {
    const matrix_model m(some_tableau<double>());
    const auto failing = failing_conditions(m, 3, [](double r) { return std::abs(r) > 1e-12; });
    const auto exact = failing_conditions(matrix_model(some_tableau<rational>()), 3);
    BOOST_REQUIRE(failing.size() == exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) BOOST_TEST((failing[i].tree == exact[i].tree));
}

BOOST_AUTO_TEST_CASE(shapes_that_do_not_fit_are_refused) {
    tableau<double> t;
    t.A.setZero(2, 2);
    t.b.setZero(2);
    t.c.setZero(3);
    BOOST_CHECK_THROW(matrix_model<double>{t}, std::invalid_argument);
    t.c.setZero(2);
    BOOST_CHECK_NO_THROW(matrix_model<double>{t});
    BOOST_CHECK_THROW(matrix_model(t, Eigen::VectorXd::Zero(3)), std::invalid_argument);
    t.A.setZero(2, 3);
    BOOST_CHECK_THROW(matrix_model<double>{t}, std::invalid_argument);
    t.b.resize(0);
    BOOST_CHECK_THROW(matrix_model<double>{t}, std::invalid_argument);

    const tree_table table(4);
    const matrix_model m(some_tableau<double>());
    BOOST_CHECK_THROW((tree_weights(m, table.view(), 5)), std::invalid_argument);
    BOOST_CHECK_THROW((tree_weights(m, table.view(), 0)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(embedded_weights_make_a_model_of_their_own) {
    // Heun-Euler: b of order 2, b_embedded of order 1.
    tableau<rational> t;
    t.A.resize(2, 2);
    t.A << 0, 0, 1, 0;
    t.b.resize(2);
    t.b << rational(1, 2), rational(1, 2);
    t.c.resize(2);
    t.c << 0, 1;
    t.b_embedded.resize(2);
    t.b_embedded << 1, 0;
    BOOST_TEST(order_of(matrix_model(t), 5).order == 2);
    BOOST_TEST(order_of(matrix_model(t, t.b_embedded), 5).order == 1);
}
