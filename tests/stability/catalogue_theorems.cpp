// SPDX-License-Identifier: BSL-1.0
// The theorems of the lecture, chapter 2, and the implications between the notions of stability, decided for
// every catalogue tableau whose entries are rational or lie in one quadratic field.
#define BOOST_TEST_MODULE catalogue_theorems
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <stagecraft/tableaux/transformations.hpp>
#include <stagecraft/theory/dae/dae_order.hpp>
#include <stagecraft/theory/stability/ssp.hpp>
#include <stagecraft/theory/stability/symmetry.hpp>

#include "../catalogue.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;

namespace {

using K = tableaux::quadratic;  // the rational ones among them
using method = tableau<K>;
using read_once::exact_methods;

/// Calls f(name, tableau) for each of them; returns how many there are.
template <class F>
int for_each_exact(F f) {
    for (const auto& [name, t] : exact_methods()) f(name, t);
    return static_cast<int>(exact_methods().size());
}

bool is_explicit(const method& t) {
    for (Eigen::Index i = 0; i < t.b.size(); ++i) {
        for (Eigen::Index j = i; j < t.b.size(); ++j) {
            if (!(t.A(i, j) == K(0))) return false;
        }
    }
    return true;
}

bool has_distinct_nodes(const method& t) {
    for (Eigen::Index i = 0; i < t.c.size(); ++i) {
        for (Eigen::Index j = 0; j < i; ++j) {
            if (t.c[i] == t.c[j]) return false;
        }
    }
    return true;
}

}  // namespace

BOOST_AUTO_TEST_CASE(both_determinant_formulas_agree_and_degrees_stay_below_s_satz_2_18_folgerung_2_19) {
    const int count = for_each_exact([](const std::string& name, const method& t) {
        const auto r = stability_function_of(t);
        BOOST_TEST((r == stability_function_by_bordering(t)), name);
        BOOST_TEST(r.numerator.degree() <= t.stages(), name);
        BOOST_TEST(r.denominator.degree() <= t.stages(), name);
        if (is_explicit(t)) BOOST_TEST(r.denominator.degree() == 0, name);
    });
    BOOST_TEST(count >= 60);
}

BOOST_AUTO_TEST_CASE(no_consistent_explicit_method_is_algebraically_or_a_stable_satz_2_16_and_2_22) {
    int explicit_ones = 0;
    for_each_exact([&](const std::string& name, const method& t) {
        if (!is_explicit(t) || tableaux::simplifying_orders_of(t).B < 1) return;
        ++explicit_ones;
        const auto a = a_stable(stability_function_of(t));
        BOOST_TEST(a.is_refuted(), name);
        BOOST_TEST(!a.reason().empty(), name);
        const auto m = algebraically_stable(t);
        BOOST_TEST(m.is_refuted(), name);
        BOOST_TEST(!m.reason().empty(), name);
    });
    BOOST_TEST(explicit_ones >= 30);
}

BOOST_AUTO_TEST_CASE(b_p_is_necessary_the_order_is_at_most_2s_and_butchers_bound_holds_lemma_2_6_satz_2_9) {
    for_each_exact([](const std::string& name, const method& t) {
        const auto n = tableaux::simplifying_orders_of(t);
        const int p = classical_order(t);
        BOOST_TEST(p <= n.B, name);
        BOOST_TEST(p <= 2 * t.stages(), name);
        BOOST_TEST(n.order() <= p, name);
        // R approximates the exponential to the order at least
        if (n.C >= 1) BOOST_TEST(exponential_fit_of(stability_function_of(t)).order >= p, name);
    });
}

BOOST_AUTO_TEST_CASE(positive_weights_and_distinct_nodes_make_c_and_d_each_others_consequence_lemma_2_10) {
    int hypotheses_met = 0;
    for_each_exact([&](const std::string& name, const method& t) {
        bool positive = true;
        for (Eigen::Index i = 0; i < t.b.size(); ++i) positive = positive && K(0) < t.b[i];
        if (!positive || !has_distinct_nodes(t)) return;
        const auto n = tableaux::simplifying_orders_of(t);
        const int s = t.stages();
        if (n.C < s && n.D < s) return;
        ++hypotheses_met;
        if (n.C >= s) BOOST_TEST(n.D >= n.B - s, name);
        if (n.D >= s) BOOST_TEST(n.C >= n.B - s, name);
    });
    BOOST_TEST(hypotheses_met >= 8);
}

BOOST_AUTO_TEST_CASE(quadrature_exact_to_2s_minus_2_has_positive_weights_lemma_2_14) {
    int hypotheses_met = 0;
    for_each_exact([&](const std::string& name, const method& t) {
        if (!has_distinct_nodes(t) || tableaux::simplifying_orders_of(t).B < 2 * t.stages() - 1) return;
        ++hypotheses_met;
        for (Eigen::Index i = 0; i < t.b.size(); ++i) BOOST_TEST((K(0) < t.b[i]), name);
    });
    BOOST_TEST(hypotheses_met >= 8);
}

BOOST_AUTO_TEST_CASE(every_notion_of_stability_implies_the_weaker_ones) {
    int algebraic = 0, a_only = 0;
    for_each_exact([&](const std::string& name, const method& t) {
        const auto r = stability_function_of(t);
        const bool m = algebraically_stable(t).is_proved();
        const bool b = b_stable(t).is_proved();
        const bool an = an_stable(t).is_proved();
        const bool a = a_stable(r).is_proved();
        if (m) BOOST_TEST(b, name);
        if (b) BOOST_TEST(an, name);
        if (an) BOOST_TEST(a, name);
        if (l_stable(r).is_proved()) BOOST_TEST(strongly_a_stable(r).is_proved(), name);
        if (strongly_a_stable(r).is_proved()) BOOST_TEST(a, name);
        if (a) {
            BOOST_TEST(a0_stable(r).is_proved(), name);
            BOOST_TEST(i_stable(r).is_proved(), name);
            BOOST_TEST(real_stability_interval(r).infinite, name);
            BOOST_TEST(imaginary_stability_interval(r).infinite, name);
        }
        algebraic += m ? 1 : 0;
        a_only += a && !m ? 1 : 0;
    });
    BOOST_TEST(algebraic >= 10);
    BOOST_TEST(a_only >= 5);
}

BOOST_AUTO_TEST_CASE(symmetric_methods_have_even_order_and_r_of_z_times_r_of_minus_z_equal_to_one) {
    int symmetric_ones = 0;
    for_each_exact([&](const std::string& name, const method& t) {
        const auto r = stability_function_of(t);
        const auto product_is_one = reflected(r.numerator) == r.denominator;
        if (symmetric(t).is_refuted()) return;
        ++symmetric_ones;
        BOOST_TEST(product_is_one, name);
        BOOST_TEST(classical_order(t) % 2 == 0, name);
        BOOST_TEST((stability_function_of(tableaux::adjoint(t)) == r), name);
    });
    BOOST_TEST(symmetric_ones >= 5);
}

BOOST_AUTO_TEST_CASE(stiffly_accurate_methods_with_regular_matrix_vanish_at_infinity_satz_2_23) {
    int hypotheses_met = 0;
    for_each_exact([&](const std::string& name, const method& t) {
        if (stiffly_accurate(t).is_refuted() || regular_matrix(t).is_refuted()) return;
        ++hypotheses_met;
        BOOST_TEST((*stability_function_of(t).at_infinity() == K(0)), name);
    });
    BOOST_TEST(hypotheses_met >= 8);
}

BOOST_AUTO_TEST_CASE(optimal_ssp_methods_have_their_published_radii) {
    int found = 0;
    const auto radius_is = [&](const std::string& wanted, int value) {
        for_each_exact([&](const std::string& name, const method& t) {
            if (name != wanted) return;
            ++found;
            const auto r = ssp_radius(t);
            BOOST_TEST((!r.infinite && r.low <= K(value) && K(value) <= r.high), name);
        });
    };
    radius_is("ssp_3_2", 2);
    radius_is("ssp_3_3", 1);
    radius_is("ssp_4_3", 2);
    radius_is("ssp_9_3", 6);
    radius_is("ssp_10_4", 6);
    BOOST_TEST(found == 5);
}
