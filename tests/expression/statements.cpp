// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE statements
#include <array>
#include <boost/test/unit_test.hpp>
#include <set>
#include <stagecraft/tableaux/fixed_rational.hpp>
#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/theory/models/legendre_model.hpp>
#include <stagecraft/theory/models/matrix_model.hpp>
#include <stagecraft/theory/statements/expression_tree.hpp>
#include <stagecraft/theory/statements/order_conditions.hpp>
#include <stagecraft/theory/statements/simplifying.hpp>
#include <stagecraft/theory/statements/structure.hpp>
#include <stdexcept>
#include <string>

using namespace stagecraft;
using namespace stagecraft::theory;
using namespace stagecraft::theory::statements;
using tableaux::fixed_rational;
using tableaux::quadratic;
using tableaux::rational;

namespace {

// Hairer-Wanner II.IV.5: Radau IIA of order 3, over rationals at compile time.
using Q = fixed_rational;
constexpr matrix_model radau_iia_2(std::array<std::array<Q, 2>, 2>{{{Q(5, 12), Q(-1, 12)},
                                                                    {Q(3, 4), Q(1, 4)}}},
                                   std::array<Q, 2>{Q(3, 4), Q(1, 4)}, std::array<Q, 2>{Q(1, 3), Q(1)});
constexpr matrix_model lobatto_iiia_3(std::array<std::array<Q, 3>, 3>{{{Q(0), Q(0), Q(0)},
                                                                       {Q(5, 24), Q(1, 3), Q(-1, 24)},
                                                                       {Q(1, 6), Q(2, 3), Q(1, 6)}}},
                                      std::array<Q, 3>{Q(1, 6), Q(2, 3), Q(1, 6)},
                                      std::array<Q, 3>{Q(0), Q(1, 2), Q(1)});
constexpr matrix_model lobatto_iiib_3(std::array<std::array<Q, 3>, 3>{{{Q(1, 6), Q(-1, 6), Q(0)},
                                                                       {Q(1, 6), Q(1, 3), Q(0)},
                                                                       {Q(1, 6), Q(5, 6), Q(0)}}},
                                      std::array<Q, 3>{Q(1, 6), Q(2, 3), Q(1, 6)},
                                      std::array<Q, 3>{Q(0), Q(1, 2), Q(1)});

matrix_model<quadratic> gauss_2() {
    tableau<quadratic> t;
    const quadratic r(rational(0), rational(1, 6), 3), quarter(rational(1, 4)), half(rational(1, 2));
    t.A.resize(2, 2);
    t.A << quarter, quarter - r, quarter + r, quarter;
    t.b.resize(2);
    t.b << half, half;
    t.c.resize(2);
    t.c << half - r, half + r;
    return matrix_model(t);
}

}  // namespace

BOOST_AUTO_TEST_CASE(simplifying_conditions_decide_at_compile_time) {
    static_assert(holds(B<3>, radau_iia_2) && !holds(B<4>, radau_iia_2));
    static_assert(holds(C<2>, radau_iia_2) && !holds(C<3>, radau_iia_2));
    static_assert(holds(D<1>, radau_iia_2) && !holds(D<2>, radau_iia_2));
    static_assert(holds(B<4>, lobatto_iiia_3) && !holds(B<5>, lobatto_iiia_3));
    static_assert(holds(C<3>, lobatto_iiia_3) && !holds(C<4>, lobatto_iiia_3));
    static_assert(holds(D<1>, lobatto_iiia_3) && !holds(D<2>, lobatto_iiia_3));
    static_assert(holds(C<1>, lobatto_iiib_3) && !holds(C<2>, lobatto_iiib_3));
    static_assert(holds(D<3>, lobatto_iiib_3) && !holds(D<4>, lobatto_iiib_3));
    static_assert(holds(B<0>, radau_iia_2));
}

BOOST_AUTO_TEST_CASE(structure_decides_at_compile_time) {
    static_assert(holds(row_sums, radau_iia_2) && holds(row_sums, lobatto_iiib_3));
    static_assert(holds(stiff_accuracy, radau_iia_2) && holds(stiff_accuracy, lobatto_iiia_3));
    static_assert(!holds(stiff_accuracy, lobatto_iiib_3));
    static_assert(!holds(symplecticity, radau_iia_2) && !holds(symplecticity, lobatto_iiia_3));
    static_assert(holds(symmetry_of_stages, lobatto_iiia_3) && holds(symmetry_of_stages, lobatto_iiib_3));
    static_assert(!holds(symmetry_of_stages, radau_iia_2));
}

BOOST_AUTO_TEST_CASE(structure_of_the_families_in_the_legendre_ring) {
    using tableaux::family;
    using ring = legendre_model<Q>;
    static_assert(holds(symplecticity, ring(family::gauss, 3)) &&
                  holds(symplecticity, ring(family::gauss, 4)));
    static_assert(!holds(symplecticity, ring(family::radau_ia, 3)));
    static_assert(!holds(symplecticity, ring(family::lobatto_iiic, 3)));
    static_assert(holds(symmetry_of_stages, ring(family::gauss, 4)));
    static_assert(holds(symmetry_of_stages, ring(family::lobatto_iiia, 4)));
    static_assert(holds(symmetry_of_stages, ring(family::lobatto_iiib, 4)));
    static_assert(!holds(symmetry_of_stages, ring(family::lobatto_iiic, 4)));
    static_assert(holds(stiff_accuracy, ring(family::radau_iia, 3)));
    static_assert(holds(stiff_accuracy, ring(family::lobatto_iiia, 4)));
    static_assert(holds(stiff_accuracy, ring(family::lobatto_iiic, 4)));
    static_assert(!holds(stiff_accuracy, ring(family::lobatto_iiib, 4)));
    // Where the last node or the reflection is not in the ring, it says so.
    BOOST_CHECK_THROW(holds(stiff_accuracy, ring(family::gauss, 2)), std::invalid_argument);
    BOOST_CHECK_THROW(holds(symmetry_of_stages, ring(family::radau_iia, 2)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(gauss_2_is_symplectic_symmetric_and_not_stiffly_accurate) {
    const auto m = gauss_2();
    BOOST_TEST(holds(symplecticity, m));
    BOOST_TEST(holds(symmetry_of_stages, m));
    BOOST_TEST(!holds(stiff_accuracy, m));
    BOOST_TEST((holds(B<4>, m) && !holds(B<5>, m)));
    BOOST_TEST((holds(C<2>, m) && !holds(C<3>, m)));
    BOOST_TEST((holds(D<2>, m) && !holds(D<3>, m)));
    BOOST_TEST((holds(order_conditions<4>, m) && !holds(order_conditions<5>, m)));
}

BOOST_AUTO_TEST_CASE(row_sums_fail_where_c_is_wrong) {
    constexpr matrix_model wrong_c(std::array<std::array<Q, 1>, 1>{{{Q(1)}}}, std::array<Q, 1>{Q(1)},
                                   std::array<Q, 1>{Q(1, 2)});
    static_assert(!holds(row_sums, wrong_c));
    const auto all = failures(row_sums, wrong_c);
    BOOST_REQUIRE(all.size() == 1U);
    BOOST_TEST(all[0].equation == "A*one == c");
    BOOST_TEST((all[0].residual == Q(1, 2)));
}

BOOST_AUTO_TEST_CASE(named_order_conditions_are_the_seventeen_trees_to_order_five) {
    static_assert(is_order_condition(std::get<0>(conditions::t53.equations)));
    std::set<rooted_tree> trees;
    std::apply(
        [&](const auto&... s) {
            const auto check = [&](const auto& e) {
                BOOST_TEST(is_order_condition(e));
                const rooted_tree t = tree_of(e.left);
                trees.insert(t);
                BOOST_TEST(text(e) == condition_text(t));
                BOOST_TEST(latex(e) == condition_latex(t));
            };
            (check(std::get<0>(s.equations)), ...);
        },
        conditions::all);
    std::set<rooted_tree> all;
    for (int n = 1; n <= 5; ++n)
        for (const rooted_tree& t : trees_of_order(n)) all.insert(t);
    BOOST_TEST((trees == all));
}

BOOST_AUTO_TEST_CASE(named_conditions_agree_with_generated_ones) {
    static_assert(holds(order_conditions<3>, radau_iia_2) && !holds(order_conditions<4>, radau_iia_2));
    static_assert(has_order<3>(radau_iia_2) && !has_order<4>(radau_iia_2));
    static_assert(holds(order_conditions<4>, lobatto_iiia_3) && !holds(order_conditions<5>, lobatto_iiia_3));
    static_assert(has_order<4>(lobatto_iiib_3) && !has_order<5>(lobatto_iiib_3));
    // residual by residual: the failing equations at order five are the failing trees at order five
    const auto by_statement = failures(order_conditions<5>, lobatto_iiia_3);
    const auto by_tree = failing_conditions(lobatto_iiia_3, 5);
    BOOST_TEST(by_statement.size() == by_tree.size());
    for (const auto& f : by_tree) {
        bool found = false;
        for (const auto& e : by_statement)
            found = found || (e.equation == condition_text(f.tree) && e.residual == f.residual);
        BOOST_TEST(found);
    }
}

BOOST_AUTO_TEST_CASE(statements_print_their_formula_and_citation) {
    BOOST_TEST(text(B<2>) ==
               "B(2): dot(b, one) == 1; dot(b, c) == 1/2  "
               "[Butcher 1964; Hairer-Wanner II.IV.5]");
    BOOST_TEST(text(C<2>).find("C(2): A*one == c; A*c == pow<2>(c)/2  [Butcher 1964") == 0U);
    BOOST_TEST(text(D<2>).find("D(2): transposed(A)*b == b*(one - c); transposed(A)*(b*c) == b*(one - "
                               "pow<2>(c))/2  [Butcher 1964") == 0U);
    BOOST_TEST(latex(C<2>) ==
               "% C(2) [Butcher 1964; Hairer-Wanner II.IV.5]\n"
               "\\begin{aligned}\n"
               "  &\\sum_{j} a_{ij} = c_{i} \\quad (i = 1, \\dots, s) \\\\\n"
               "  &\\sum_{j} a_{ij} c_{j} = \\frac{1}{2} c_{i}^{2} \\quad (i = 1, \\dots, s)\n"
               "\\end{aligned}");
    BOOST_TEST(text(stiff_accuracy).find("stiff accuracy: dot(last, A*v) == dot(b, v), for all v  [") == 0U);
}

BOOST_AUTO_TEST_CASE(verdicts_carry_their_witness) {
    BOOST_TEST(prove(B<3>, radau_iia_2).is_proved());
    const verdict v = prove(B<4>, radau_iia_2);
    BOOST_TEST(v.is_refuted());
    BOOST_TEST(v.reason() == "dot(b, pow<3>(c)) == 1/4 leaves 1/36");
}
