// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE dae_order
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <stagecraft/theory/dae/dae_order.hpp>

#include "../catalogue.hpp"
#include "../stability/methods.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;
using methods::q;
using methods::quadratic;
using methods::rational;

namespace {

std::string text(const order_prediction& p) {
    if (!p.applies()) return "none";
    std::string out = std::to_string(*p.y) + " " + std::to_string(*p.z);
    if (p.u) out += " " + std::to_string(*p.u);
    return out;
}

template <class K>
std::string index2(const tableau<K>& t) {
    return text(predict_index2(t));
}

/// Alexander's two-stage SDIRK method, gamma = 1 - sqrt(1/2): stiffly accurate, L-stable, order 2.
tableau<quadratic> sdirk2() {
    const quadratic g(1, q(-1, 2), 2);
    return methods::make<quadratic>({{g}, {quadratic(1) - g, g}}, {quadratic(1) - g, g}, {g, 1});
}

std::string refused(const order_prediction& p, const std::string& name) {
    for (const auto& h : p.hypotheses) {
        if (h.name == name && h.verdict.is_refuted()) return h.verdict.reason();
    }
    return "";
}

}  // namespace

BOOST_AUTO_TEST_CASE(index_2_orders_of_the_families_are_those_of_hlr89) {
    // Gauss (s+1, s-1) for odd s, (s, s-2) for even s; Radau IA (s, s-1); IIA (2s-1, s); IIIC (2s-2, s-1)
    BOOST_TEST(index2(methods::gauss2()) == "2 0");
    BOOST_TEST(index2(methods::gauss3()) == "4 2");
    BOOST_TEST(index2(methods::midpoint()) == "2 0");
    BOOST_TEST(index2(methods::radau_ia2()) == "2 1");
    BOOST_TEST(index2(methods::radau_ia3()) == "3 2");
    BOOST_TEST(index2(methods::radau_iia2()) == "3 2");
    BOOST_TEST(index2(methods::radau_iia3()) == "5 3");
    BOOST_TEST(index2(methods::lobatto_iiic2()) == "2 1");
    BOOST_TEST(index2(methods::lobatto_iiic3()) == "4 2");
    BOOST_TEST(index2(methods::lobatto_iiic4()) == "6 3");
}

BOOST_AUTO_TEST_CASE(the_prediction_names_its_theorem_and_hypotheses) {
    const auto p = predict_index2(methods::radau_iia3());
    BOOST_TEST(p.theorem == "Hairer-Wanner II, Theorem VII.4.9");
    BOOST_TEST(p.hypotheses.size() == 6U);
    for (const auto& h : p.hypotheses) BOOST_TEST(h.verdict.is_proved());
    BOOST_TEST(predict_index2(methods::radau_ia3()).theorem ==
               "Hairer-Lubich-Roche 1989, Theorems 4.3, 4.4 and 4.6");
    BOOST_TEST(predict_index2(methods::gauss3()).theorem ==
               "Hairer-Lubich-Roche 1989, section 4, |R(inf)| = 1");
    BOOST_TEST(
        predict_index2(methods::lobatto_iiic4()).theorem.starts_with("Hairer-Lubich-Roche 1989, section 5"));
    // Corollary 1 is weaker and says so on its own
    const auto all = index2_theorems(methods::radau_iia3());
    BOOST_TEST(text(all[0]) == "4 3");
    BOOST_TEST(text(all[1]) == "3 3");
    BOOST_TEST(refused(index2_theorems(methods::gauss2())[1], "|R(inf)| < 1") == "R(inf) = 1");
    BOOST_TEST(refused(index2_theorems(methods::lobatto_iiic3())[2], "c_i != 0") == "c_1 = 0");
    BOOST_TEST(refused(index2_theorems(methods::gauss3())[2], "c_s = 1") == "c_s = 1/2+1/10*sqrt(15)");
}

BOOST_AUTO_TEST_CASE(where_no_theorem_applies_the_prediction_says_so) {
    for (const auto& t : {methods::lobatto_iiib3(), methods::rk4()}) {
        const auto p = predict_index2(t);
        BOOST_TEST(!p.applies());
        BOOST_TEST(p.theorem == "none");
        BOOST_TEST(p.note == "no theorem applies");
        BOOST_TEST(!p.hypotheses.empty());
        BOOST_TEST(!predict_index1(t).applies());
        BOOST_TEST(!predict_index3(t).applies());
        BOOST_TEST(!predict_singular_perturbation(t).applies());
    }
    // implicit Euler: p = 1 = q, so neither Theorem 2 nor Corollary 2 speaks; the order conditions do
    BOOST_TEST(index2(methods::implicit_euler()) == "1 1");
    BOOST_TEST(!index2_theorems(methods::implicit_euler())[0].applies());
    BOOST_TEST(!index2_theorems(methods::implicit_euler())[2].applies());
}

BOOST_AUTO_TEST_CASE(exact_order_conditions_of_index_2_agree_with_the_theorems) {
    const auto conditions = [](const auto& t, int reach) {
        for (const auto& p : index2_theorems(t, reach)) {
            if (p.theorem.starts_with("order conditions")) return text(p);
        }
        return std::string("missing");
    };
    BOOST_TEST(conditions(methods::implicit_euler(), 3) == "1 1");
    BOOST_TEST(conditions(methods::radau_iia2(), 5) == "3 2");
    BOOST_TEST(conditions(methods::radau_iia3(), 7) == "5 3");
    BOOST_TEST(conditions(methods::lobatto_iiic2(), 5) == "2 1");
    BOOST_TEST(conditions(methods::lobatto_iiic3(), 6) == "4 2");
    BOOST_TEST(conditions(methods::lobatto_iiic4(), 8) == "6 3");
    BOOST_TEST(conditions(methods::radau_ia2(), 5) == "2 1");
    BOOST_TEST(conditions(methods::radau_ia3(), 6) == "3 2");
    BOOST_TEST(conditions(sdirk2(), 4) == "2 1");
    BOOST_TEST(conditions(methods::gauss3(), 5) == "none");  // |R(inf)| = 1
    BOOST_TEST(!index2_local_orders_of(methods::lobatto_iiia3(), 3).has_value());
    BOOST_CHECK_THROW(index2_local_orders_of(methods::radau_ia2(), 0), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_first_index_2_conditions_are_the_published_ones) {
    // b^T A^-1 c^2 = 1, removed by the projection; b^T (c . A^-1 c^2) = 2/3; b^T A^-2 c^2 = 2
    const auto local = [](const auto& t) { return *index2_local_orders_of(t, 3); };
    const auto t = methods::radau_ia2();
    const auto inverse = *tableaux::inverse<rational>(t.A);
    rational first(0);
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) first += t.b[i] * inverse(i, j) * t.c[j] * t.c[j];
    }
    BOOST_TEST(first != 1);
    BOOST_TEST(local(t).y == 1);
    BOOST_TEST(local(t).projected == 2);
    BOOST_TEST(local(methods::radau_iia2()).y == 3);
    BOOST_TEST(local(methods::radau_iia2()).z == 1);
    BOOST_TEST(local(methods::gauss2()).y == 2);
    BOOST_TEST(local(methods::gauss2()).projected == 3);
}

BOOST_AUTO_TEST_CASE(index_1_orders) {
    BOOST_TEST(text(predict_index1(methods::radau_iia3())) == "5 5");
    BOOST_TEST(text(predict_index1(methods::lobatto_iiic4())) == "6 6");
    BOOST_TEST(text(predict_index1(methods::gauss2())) == "4 2");     // R(inf) = 1: min(p-1, q)
    BOOST_TEST(text(predict_index1(methods::gauss3())) == "6 4");     // R(inf) = -1: min(p, q+1)
    BOOST_TEST(text(predict_index1(methods::radau_ia3())) == "5 3");  // R(inf) = 0
    const auto p = predict_index1(methods::rk4());
    BOOST_TEST(!p.applies());
    BOOST_TEST(refused(p, "A is regular") == "det A = 0");
}

BOOST_AUTO_TEST_CASE(stiffly_accurate_methods_with_a_left_stage_have_orders_of_index_1_and_2) {
    // Lobatto IIIA: (2s-2, s) for even s, where R(inf) = -1, (2s-2, s-1) for odd s
    BOOST_TEST(text(predict_index1(methods::trapezoidal())) == "2 2");
    BOOST_TEST(text(predict_index1(methods::lobatto_iiia3())) == "4 4");
    BOOST_TEST(text(predict_index2(methods::trapezoidal())) == "2 2");
    BOOST_TEST(text(predict_index2(methods::lobatto_iiia3())) == "4 2");
    BOOST_TEST(!predict_index2(methods::lobatto_iiib3()).applies());
    BOOST_TEST(refused(predict_index1(methods::rk4()), "A is regular") == "det A = 0");
    // collocation at 0 and 2/3 (Radau I): not stiffly accurate
    const auto radau_i = tableaux::collocation<rational>({0, q(2, 3)}).tableau;
    BOOST_TEST(refused(predict_index1(radau_i), "stiffly accurate") != "");
    // collocation at 0, 1/4, 1: R(inf) = 3
    const auto growing = tableaux::collocation<rational>({0, q(1, 4), 1}).tableau;
    BOOST_TEST(predict_index1(growing).applies());
    BOOST_TEST(refused(predict_index2(growing), "|R(inf)| <= 1") != "");
    // at 0, 3/4, 1: R(inf) = 1/3, and the conditions say what Jay's theorem does
    const auto damped = tableaux::collocation<rational>({0, q(3, 4), 1}).tableau;
    const auto both = index2_theorems(damped);
    BOOST_TEST(both.size() == 2U);
    for (const auto& theorem : both) BOOST_TEST(text(theorem) == "3 3", theorem.theorem);
}

// The orders of index 2 are those that runs show (mpmath, 45 digits, y1 = e^t, y2 = e^-2t, z = e^2t; halved steps: 2.01 2.00,
// 2.95 1.95 and 2.93 1.90).
BOOST_AUTO_TEST_CASE(methods_with_an_explicit_first_stage_have_orders_of_index_1_and_2) {
    const auto& all = read_once::exact_methods();
    const auto orders = [&](const std::string& name) {
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const auto& entry) { return entry.first == name; });
        BOOST_REQUIRE(found != all.end());
        const auto m = dae_traits_of(found->second);
        return text(predict_index1(m)) + ", " + text(predict_index2(m));
    };
    BOOST_TEST(orders("tr_bdf2") == "2 2, 2 2");
    BOOST_TEST(orders("kennedy_carpenter_esdirk_3_2") == "3 3, 3 2");
    BOOST_TEST(orders("kennedy_carpenter_esdirk_4") == "4 4, 3 2");
}

BOOST_AUTO_TEST_CASE(index_3_orders_are_promised_for_stiffly_accurate_collocation_only) {
    BOOST_TEST(text(predict_index3(methods::radau_iia2())) == "2 2 1");
    BOOST_TEST(text(predict_index3(methods::radau_iia3())) == "3 3 2");
    BOOST_TEST(predict_index3(methods::radau_iia3()).note ==
               "y: lower bound; up to 5 is observed, not promised");
    BOOST_TEST(refused(predict_index3(methods::lobatto_iiic3()), "collocation method") != "");
    BOOST_TEST(refused(predict_index3(methods::implicit_euler()), "s >= 2") == "s = 1");
    BOOST_TEST(refused(predict_index3(methods::gauss3()), "stiffly accurate") != "");
}

BOOST_AUTO_TEST_CASE(epsilon_orders_of_theorem_7) {
    using terms = std::vector<epsilon_term>;
    const auto radau = predict_singular_perturbation(methods::radau_iia3());
    BOOST_TEST((radau.y == terms{{0, 5}, {1, 4}}));
    BOOST_TEST((radau.lambda == terms{{0, 5}, {1, 3}}));
    const auto ia = predict_singular_perturbation(methods::radau_ia3());
    BOOST_TEST((ia.y == terms{{0, 5}, {1, 3}}));
    BOOST_TEST((ia.lambda == terms{{0, 3}}));
    const auto gauss = predict_singular_perturbation(methods::gauss2());
    BOOST_TEST(!gauss.applies());
    BOOST_TEST(gauss.hypotheses[2].name == "|R(inf)| < 1");
    BOOST_TEST(gauss.hypotheses[2].verdict.is_refuted());
    // implicit Euler: q = p, which the theorem excludes
    const auto euler = predict_singular_perturbation(methods::implicit_euler());
    BOOST_TEST(!euler.applies());
    BOOST_TEST(euler.hypotheses[3].verdict.reason() == "p = 1, q = 1");
}

BOOST_AUTO_TEST_CASE(the_classical_order_comes_from_the_trees_where_the_bound_is_too_low) {
    BOOST_TEST(classical_order(methods::rk4()) == 4);
    BOOST_TEST(classical_order(methods::kutta3()) == 3);
    BOOST_TEST(classical_order(methods::ssp104()) == 4);
    BOOST_TEST(classical_order(methods::gauss3()) == 6);
    BOOST_TEST(classical_order(sdirk2()) == 2);
    auto wrong = methods::rk4();
    wrong.A(2, 1) -= q(1, 100);
    BOOST_TEST(classical_order(wrong) == 1);  // c no longer the row sums
    BOOST_TEST(dae_traits_of(wrong).stage_order == 0);
    // Lobatto IIIB-2: c is not A 1, and yet order 2 for y' = f(x, y), by b^T c = b^T A 1 = 1/2
    const auto iiib = methods::make<rational>({{q(1, 2)}, {q(1, 2)}}, {q(1, 2), q(1, 2)}, {0, 1});
    BOOST_TEST(classical_order(iiib) == 2);
    auto shifted = iiib;
    shifted.c[0] = q(1, 10);
    BOOST_TEST(classical_order(shifted) == 1);
}
