// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE construction
#include <boost/test/unit_test.hpp>
#include <stagecraft/tableaux/embedded.hpp>
#include <stagecraft/tableaux/quadratic_roots.hpp>
#include <stagecraft/tableaux/transformations.hpp>
#include <stagecraft/tableaux/w_transform.hpp>
#include <stagecraft/theory/stability/a_stability.hpp>
#include <stagecraft/theory/stability/algebraic_stability.hpp>
#include <stagecraft/theory/stability/symmetry.hpp>

#include "methods.hpp"

using namespace stagecraft;
using namespace stagecraft::tableaux;
using methods::q;

namespace {

template <class K>
bool same(const tableau<K>& a, const tableau<K>& b) {
    return a.A == b.A && a.b == b.b && a.c == b.c;
}

std::string orders(const simplifying_orders& n) {
    return std::to_string(n.B) + " " + std::to_string(n.C) + " " + std::to_string(n.D);
}

}  // namespace

BOOST_AUTO_TEST_CASE(simplifying_orders_of_the_families_are_the_tabulated_ones) {
    const auto of = [](const auto& t) { return orders(simplifying_orders_of(t)); };
    BOOST_TEST(of(methods::gauss2()) == "4 2 2");
    BOOST_TEST(of(methods::gauss3()) == "6 3 3");
    BOOST_TEST(of(methods::radau_ia2()) == "3 1 2");
    BOOST_TEST(of(methods::radau_ia3()) == "5 2 3");
    BOOST_TEST(of(methods::radau_iia3()) == "5 3 2");
    BOOST_TEST(of(methods::lobatto_iiia3()) == "4 3 1");
    BOOST_TEST(of(methods::lobatto_iiib3()) == "4 1 3");
    BOOST_TEST(of(methods::lobatto_iiic3()) == "4 2 2");
    BOOST_TEST(of(methods::lobatto_iiic4()) == "6 3 3");
    BOOST_TEST(of(methods::rk4()) == "4 1 1");
    BOOST_TEST(simplifying_orders_of(methods::rk4()).order() == 3);  // a bound, not the order
}

BOOST_AUTO_TEST_CASE(the_order_never_exceeds_twice_the_stages_lecture_lemma_2_6) {
    BOOST_TEST(simplifying_orders_of(methods::gauss3()).B == 6);
    for (int n = 1; n <= 5; ++n) {
        std::vector<rational> nodes;
        for (int i = 0; i < n; ++i) nodes.push_back(q(2 * i + 1, 2 * n));
        BOOST_TEST(collocation<rational>(nodes).order <= 2 * n);
    }
}

BOOST_AUTO_TEST_CASE(b_and_c_imply_d_and_b_and_d_imply_c_lecture_lemma_2_10) {
    const auto check = [](const auto& t, int s) {
        using K = typename std::decay_t<decltype(t)>::scalar;
        for (int i = 0; i < s; ++i) BOOST_TEST((K(0) < t.b[i]));
        const auto n = simplifying_orders_of(t);
        if (n.C >= s) BOOST_TEST(n.D >= n.B - s);
        if (n.D >= s) BOOST_TEST(n.C >= n.B - s);
    };
    check(methods::gauss3(), 3);
    check(methods::radau_iia3(), 3);
    check(methods::radau_ia3(), 3);
    check(methods::lobatto_iiia3(), 3);
    check(methods::lobatto_iiib3(), 3);
    // IIIC has neither C(s) nor D(s), B(2s-2), and yet D(s-1): no consequence of the lemma
    BOOST_TEST(orders(simplifying_orders_of(methods::lobatto_iiic4())) == "6 3 3");
    // positive weights are not needed: b_2 < 0, B(3) and C(3), and the lemma says D(0)
    const auto negative = collocation<rational>({0, q(1, 10), q(1, 2)}).tableau;
    BOOST_TEST((negative.b[1] < 0));
    BOOST_TEST(orders(simplifying_orders_of(negative)) == "3 3 0");
}

BOOST_AUTO_TEST_CASE(collocation_at_gauss_and_radau_nodes_has_the_order_of_folgerung_2_11) {
    const auto gauss = collocation(polynomial<rational>{q(-1, 20), q(3, 5), q(-3, 2), 1});
    BOOST_TEST(gauss.order == 6);  // B(2s), C(s) => D(s), p = 2s
    BOOST_TEST(gauss.exact_order);
    BOOST_TEST(same(gauss.tableau, methods::gauss3()));
    const auto radau = collocation(polynomial<rational>{q(-1, 10), q(9, 10), q(-9, 5), 1});
    BOOST_TEST(radau.order == 5);  // B(2s-1), C(s) => D(s-1), p = 2s - 1
    BOOST_TEST(same(radau.tableau, methods::radau_iia3()));
    BOOST_TEST(radau.reason ==
               "collocation with 3 nodes, nodal polynomial orthogonal to 1, ..., x^1: C(s) and B(s + 2)");
    BOOST_TEST(orders(simplifying_orders_of(radau.tableau)) == "5 3 2");
    BOOST_TEST(collocation<rational>({0, q(1, 3), 1}).order == 3);
}

BOOST_AUTO_TEST_CASE(the_quadrature_is_exact_to_2s_minus_1_exactly_for_orthogonal_polynomials_satz_2_12) {
    BOOST_TEST(orthogonality<quadratic>(
                   {methods::surd(q(1, 2), q(-1, 6), 3), methods::surd(q(1, 2), q(1, 6), 3)}) == 2);
    BOOST_TEST(orthogonality<rational>({q(1, 3), 1}) == 1);
    BOOST_TEST(orthogonality<rational>({q(1, 3), q(9, 10)}) == 0);
    // Lemma 2.13: orthogonal to degree < s forces s distinct roots inside (0, 1)
    for (int s = 1; s <= 8; ++s) {
        const sturm_chain<rational> chain(shifted_legendre<rational>(s));
        BOOST_TEST(chain.count(0, 1) == s);
        BOOST_TEST(chain.squarefree_part()(rational(1)) != 0);
    }
    // Lemma 2.14: weights of a formula exact to 2s - 2 are positive; with less they need not be
    for (int i = 0; i < 3; ++i) BOOST_TEST((methods::radau_iia3().b[i] > quadratic(0)));
    BOOST_TEST(collocation<rational>({q(1, 10), q(1, 5), 1}).tableau.b[0] < 0);
}

BOOST_AUTO_TEST_CASE(polynomials_are_refused_where_their_roots_are_no_nodes) {
    BOOST_CHECK_THROW(collocation(polynomial<rational>{1, 0, 1}), std::invalid_argument);      // complex
    BOOST_CHECK_THROW(collocation(polynomial<rational>{1, -2, 1}), std::invalid_argument);     // double
    BOOST_CHECK_THROW(collocation(polynomial<rational>{-2, 0, 0, 1}), std::invalid_argument);  // cubic field
    BOOST_CHECK_THROW(collocation(polynomial<rational>(rational(3))), std::invalid_argument);  // constant
    BOOST_CHECK_THROW(collocation<rational>({q(1, 2), q(1, 2)}), std::invalid_argument);
    const auto roots = roots_in_quadratic_field(polynomial<rational>{0, -2, 0, 9});  // 0, +-sqrt(2)/3
    BOOST_TEST_REQUIRE(roots.has_value());
    BOOST_TEST((*roots)[2].str() == "1/3*sqrt(2)");
    BOOST_TEST((*roots)[1] == quadratic(0));
}

BOOST_AUTO_TEST_CASE(lobatto_iiib_is_discontinuous_collocation) {
    const auto three = discontinuous_collocation<rational>({q(1, 2)}, q(1, 6), q(1, 6));
    BOOST_TEST(same(three.tableau, methods::lobatto_iiib3()));
    BOOST_TEST(three.order == 4);
    const auto four = discontinuous_collocation<quadratic>(
        {methods::surd(q(1, 2), q(-1, 10), 5), methods::surd(q(1, 2), q(1, 10), 5)}, q(1, 12), q(1, 12));
    BOOST_TEST(orders(simplifying_orders_of(four.tableau)) == "6 2 4");
    BOOST_TEST(four.order == 6);
    BOOST_TEST(discontinuous_collocation<rational>({q(1, 2)}, q(1, 7), q(1, 6)).order == 1);
}

BOOST_AUTO_TEST_CASE(the_w_transformation_goes_both_ways) {
    const auto s3 = methods::radau_iia3();
    const std::vector<quadratic> nodes(s3.c.data(), s3.c.data() + 3);
    const auto x = w_transformed(s3);
    BOOST_TEST((x.leftCols(2) == legendre_integration<quadratic>(3).leftCols(2)));
    BOOST_TEST((x(2, 2) == quadratic(q(1, 10))));  // 1/(4s-2)
    BOOST_TEST(same(from_W<quadratic>(x, nodes).tableau, s3));
    BOOST_TEST((w_transformed(methods::gauss3()) == legendre_integration<quadratic>(3)));
    // the same corner on the other Radau nodes is Radau IA
    const auto ia = methods::radau_ia3();
    const std::vector<quadratic> left(ia.c.data(), ia.c.data() + 3);
    const auto built = from_W<quadratic>(x, left);
    BOOST_TEST(same(built.tableau, ia));
    BOOST_TEST(built.order == 5);
    BOOST_TEST(built.exact_order);
    // Lobatto IIIC: corner 1/(2(s-1)) on the diagonal
    BOOST_TEST((w_transformed(methods::lobatto_iiic4())(3, 3) == quadratic(q(1, 6))));
    BOOST_CHECK_THROW(from_W<quadratic>(x, {quadratic(0)}), std::invalid_argument);
    BOOST_CHECK_THROW(w_transformed(methods::rk4()), std::invalid_argument);  // equal nodes
}

BOOST_AUTO_TEST_CASE(perturbed_collocation_reaches_methods_that_collocation_does_not) {
    using poly = polynomial<rational>;
    // no perturbation: collocation
    BOOST_TEST(same(perturbed_collocation<rational>({q(1, 3), 1}, {}).tableau, methods::radau_iia2()));
    // Radau IA-2 on 0, 2/3: C(1) only, so N_1 = 0; N_2 follows from (A c)_i = c_i^2/2 + N_2(c_i):
    // A c = (-1/6, 5/18), c^2/2 = (0, 2/9), N_2 = -1/6 + x/3 through (0, -1/6), (2/3, 1/18)
    const auto ia = perturbed_collocation<rational>({0, q(2, 3)}, {poly(), poly{q(-1, 6), q(1, 3)}});
    BOOST_TEST(same(ia.tableau, methods::radau_ia2()));
    BOOST_TEST(ia.order == 3);
    BOOST_CHECK_THROW(perturbed_collocation<rational>({q(1, 2)}, {poly(), poly()}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(adjoint_reflected_and_transposed_methods) {
    BOOST_TEST(same(adjoint(methods::explicit_euler()), methods::implicit_euler()));
    BOOST_TEST(same(adjoint(methods::gauss3()), methods::gauss3()));
    BOOST_TEST(same(adjoint(adjoint(methods::rk4())), methods::rk4()));
    BOOST_TEST(!same(adjoint(methods::radau_iia2()), methods::radau_iia2()));
    const auto t = methods::radau_iia2();
    const auto r = theory::stability_function_of(t);
    const auto back = theory::stability_function_of(reflected(t));  // 1/R(-z)
    BOOST_TEST((back.numerator == reflected(r.denominator)));
    BOOST_TEST((back.denominator == reflected(r.numerator)));
    // the transposed of Radau IIA is Radau IA with the stages numbered backwards (Scherer and Turke)
    BOOST_TEST((theory::stability_function_of(transposed(t).tableau) == r));
    auto ia = transposed(t).tableau;
    ia.A = ia.A.rowwise().reverse().colwise().reverse().eval();
    ia.b = ia.b.reverse().eval();
    ia.c = ia.c.reverse().eval();
    BOOST_TEST(same(ia, methods::radau_ia2()));
    BOOST_TEST(transposed(t).order == 3);
    BOOST_CHECK_THROW(transposed(methods::make<rational>({{0, 1}, {1, 0}}, {1, 0}, {1, 1})),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(composition_with_the_adjoint_is_symmetric_of_even_order) {
    const auto t = symmetric_composition(methods::explicit_euler(), 1);
    BOOST_TEST(t.order == 2);
    BOOST_TEST(simplifying_orders_of(t.tableau).B == 2);
    BOOST_TEST(theory::symmetric(t.tableau).is_proved());
    // half a step of explicit, half a step of implicit Euler: the trapezoidal rule
    BOOST_TEST((theory::stability_function_of(
                    composition(methods::explicit_euler(), methods::implicit_euler(), q(1, 2))) ==
                theory::stability_function_of(methods::trapezoidal())));
    BOOST_TEST(theory::symmetric(composition(methods::explicit_euler(), methods::implicit_euler(), q(1, 3)))
                   .is_refuted());
    BOOST_CHECK_THROW(composition(methods::rk4(), methods::rk4(), rational(1)), std::invalid_argument);
    const auto five = symmetric_composition(methods::radau_iia3(), 5);
    BOOST_TEST(five.order == 6);
    BOOST_TEST(theory::exponential_fit_of(theory::stability_function_of(five.tableau)).order == 6);
}

BOOST_AUTO_TEST_CASE(from_butcher_takes_what_it_is_given) {
    const auto g = methods::gauss2();
    const auto t = from_butcher<quadratic>(g.A, g.b);
    BOOST_TEST(same(t.tableau, g));  // c = A 1
    BOOST_TEST(t.order == 4);
    BOOST_TEST(t.exact_order);
    BOOST_CHECK_THROW(from_butcher<quadratic>(g.A, column<quadratic>(3)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(embedded_weights_of_a_given_order) {
    // RK4's stages: order 4 leaves no freedom, order 3 none but b, order 2 a one-parameter family
    const auto t = methods::rk4();
    BOOST_TEST(weights_of_order(t, 4)->directions.empty());
    BOOST_TEST((weights_of_order(t, 4)->particular == t.b));
    BOOST_TEST(!weights_of_order(t, 5).has_value());
    const auto b = embedded_weights(t, 2);
    BOOST_TEST_REQUIRE(b.has_value());
    BOOST_TEST(!(*b == t.b));
    auto lower = t;
    lower.b = *b;
    BOOST_TEST(simplifying_orders_of(lower).B >= 2);
    BOOST_TEST(!embedded_weights(t, 4).has_value());
    // Bogacki-Shampine: the third-order stages with FSAL, and its published second-order weights are a member
    const auto bs = methods::make<rational>({{}, {q(1, 2)}, {0, q(3, 4)}, {q(2, 9), q(1, 3), q(4, 9)}},
                                            {q(2, 9), q(1, 3), q(4, 9), 0}, {0, q(1, 2), q(3, 4), 1});
    const auto family = *weights_of_order(bs, 2);
    column<rational> published(4);
    published << q(7, 24), q(1, 4), q(1, 3), q(1, 8);
    dense<rational> span(4, static_cast<Eigen::Index>(family.directions.size()) + 1);
    for (std::size_t k = 0; k < family.directions.size(); ++k) {
        span.col(static_cast<Eigen::Index>(k)) = family.directions[k];
    }
    const int dimension = static_cast<int>(family.directions.size());
    span.col(dimension) = published - family.particular;
    BOOST_TEST(rank<rational>(span) == dimension);
    published[0] += q(1, 1000);
    span.col(dimension) = published - family.particular;
    BOOST_TEST(rank<rational>(span) == dimension + 1);
    BOOST_CHECK_THROW(weights_of_order(t, 11), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(in_legendre_coordinates_gauss_radau_and_lobatto_iiic_are_decided_for_many_stages) {
    // R(z) = det(I - zX + z e_0 e_0^T)/det(I - zX): no node is ever computed (lecture, Satz 2.23 and 2.15)
    for (int s = 2; s <= 10; ++s) {
        column<rational> e(s);
        for (int i = 0; i < s; ++i) e[i] = rational(i == 0 ? 1 : 0);
        auto x = legendre_integration<rational>(s);
        BOOST_TEST((theory::stability_function_of<rational>(x, e, e) == theory::pade<rational>(s, s)));
        x(s - 1, s - 1) = rational(1, 4 * s - 2);
        const auto radau = theory::stability_function_of<rational>(x, e, e);
        BOOST_TEST((radau == theory::pade<rational>(s - 1, s)));
        BOOST_TEST(theory::l_stable(radau).is_proved());
        // Lobatto: the last Legendre polynomial has the discrete norm 1/(s-1) instead of 1/(2s-1)
        x = legendre_integration<rational>(s);
        x(s - 2, s - 1) = rational(-1, 2 * (s - 1));
        x(s - 1, s - 1) = rational(1, 2 * (s - 1));
        const auto lobatto = theory::stability_function_of<rational>(x, e, e);
        BOOST_TEST((lobatto == theory::pade<rational>(s - 2, s)));
        BOOST_TEST(theory::l_stable(lobatto).is_proved());
    }
}
