// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE certify
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/theory/judging/certificate_json.hpp>
#include <stagecraft/theory/judging/certify.hpp>
#include <stagecraft/theory/stability/a_stability.hpp>
#include <stagecraft/theory/stability/schwarz.hpp>
#include <stagecraft/theory/trees/tree_order.hpp>
#include <string>

using namespace stagecraft;
using namespace stagecraft::theory;
using tableaux::construction;
using tableaux::family;
using tableaux::nodal_polynomial;
using tableaux::rational;
using poly = tableaux::polynomial<rational>;

namespace {

constexpr int most = 8;  // stages examined where a statement is about every s

template <class Check>
void for_all_members(std::initializer_list<family> families, Check check) {
    for (const family f : families)
        for (int s = tableaux::least_stages(f); s <= most; ++s) check(certify(f, s), s);
}

int sign_power(int s) { return s % 2 == 0 ? 1 : -1; }

nodal_polynomial equidistant(int first, int last, int over) {
    std::vector<rational> c;
    for (int i = first; i <= last; ++i) c.emplace_back(i, over);
    return nodal_polynomial::from_nodes(c);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_certificate_of_nothing_claims_nothing) {
    const certificate nothing;
    for (const claim& c : nothing.claims()) {
        BOOST_TEST(!c.verdict.is_refuted());
        BOOST_TEST(!c.verdict.is_proved());
        BOOST_TEST(c.verdict.text() == "not examined");
    }
}

BOOST_AUTO_TEST_CASE(gauss_has_order_2s) {
    for_all_members({family::gauss}, [](const certificate& c, int s) {
        BOOST_TEST(c.order == 2 * s);
        BOOST_TEST(c.order_verdict.is_proved());
        BOOST_TEST((c.simplifying == simplifying{2 * s, s, s}));
        BOOST_TEST((c.R == pade<rational>(s, s)));
    });
    BOOST_TEST(certify(nodal_polynomial::from_nodes({{1, 4}, {3, 4}}), construction::collocation).order == 2);
}

BOOST_AUTO_TEST_CASE(radau_has_order_2s_minus_1) {
    for_all_members({family::radau_i, family::radau_iia}, [](const certificate& c, int s) {
        BOOST_TEST(c.order == 2 * s - 1);
        BOOST_TEST(c.order_verdict.is_proved());
        if (s > 1) BOOST_TEST((c.simplifying == simplifying{2 * s - 1, s, s - 1}));
    });
    for_all_members({family::radau_ia, family::radau_ii}, [](const certificate& c, int s) {
        BOOST_TEST(c.order == 2 * s - 1);
        BOOST_TEST(c.order_verdict.is_proved());
        if (s > 1) BOOST_TEST((c.simplifying == simplifying{2 * s - 1, s - 1, s}));
    });
    for_all_members({family::radau_ia, family::radau_iia},
                    [](const certificate& c, int s) { BOOST_TEST((c.R == pade<rational>(s - 1, s))); });
    for_all_members({family::radau_i, family::radau_ii},
                    [](const certificate& c, int s) { BOOST_TEST((c.R == pade<rational>(s, s - 1))); });
}

BOOST_AUTO_TEST_CASE(lobatto_has_order_2s_minus_2) {
    for_all_members({family::lobatto_iiia}, [](const certificate& c, int s) {
        BOOST_TEST((c.simplifying == simplifying{2 * s - 2, s, s - 2}));
        BOOST_TEST((c.R == pade<rational>(s - 1, s - 1)));
    });
    for_all_members({family::lobatto_iiib}, [](const certificate& c, int s) {
        BOOST_TEST((c.simplifying == simplifying{2 * s - 2, s - 2, s}));
        BOOST_TEST((c.R == pade<rational>(s - 1, s - 1)));
    });
    for_all_members({family::lobatto_iiic}, [](const certificate& c, int s) {
        BOOST_TEST((c.simplifying == simplifying{2 * s - 2, s - 1, s - 1}));
        BOOST_TEST((c.R == pade<rational>(s - 2, s)));
    });
    for_all_members({family::lobatto_iiia, family::lobatto_iiib, family::lobatto_iiic},
                    [](const certificate& c, int s) {
                        BOOST_TEST(c.order == 2 * s - 2);
                        BOOST_TEST(c.order_verdict.is_proved());
                    });
}

BOOST_AUTO_TEST_CASE(rooted_trees_find_the_same_orders) {
    for (const family f : tableaux::all_families)
        for (int s = tableaux::least_stages(f); s <= 4; ++s) {
            const auto found = order_of(legendre_model<rational>(f, s), 2 * s + 1);
            BOOST_TEST(found.is_exact());
            BOOST_TEST(found.order == certify(f, s).order);
        }
}

BOOST_AUTO_TEST_CASE(the_first_failing_quadrature_condition_is_the_one_printed) {
    for (const family f : tableaux::all_families)
        for (int s = tableaux::least_stages(f); s <= 5; ++s) {
            const legendre_model<rational> m(f, s);
            const int b = maximal_b(m);
            auto power = m.one();
            for (int k = 0; k < b; ++k) {
                BOOST_TEST((m.dot_b(power) == rational(1, k + 1)));
                power = m.multiply(power, m.c());
            }
            const std::string residual = rational(m.dot_b(power) - rational(1, b + 1)).str();
            BOOST_TEST(residual != "0");
            BOOST_TEST(certify(f, s).order_verdict.reason().ends_with(" = " + residual));
        }
}

BOOST_AUTO_TEST_CASE(error_constants_are_those_of_the_pade_table) {
    const std::vector<int> gauss{12, 720, 100800, 25401600}, radau{2, 72, 7200, 1411200};
    for (int s = 1; s <= 4; ++s) {
        const auto i = static_cast<std::size_t>(s) - 1;
        BOOST_TEST((certify(family::gauss, s).error_constant == rational(1, gauss[i])));
        BOOST_TEST((certify(family::radau_iia, s).error_constant == rational(1, radau[i])));
        BOOST_TEST((certify(family::radau_ia, s).error_constant == rational(1, radau[i])));
        BOOST_TEST((certify(family::lobatto_iiia, s + 1).error_constant == rational(1, gauss[i])));
    }
    BOOST_TEST((certify(family::lobatto_iiic, 2).error_constant == rational(1, 6)));  // 1/(1 - z + z^2/2)
    BOOST_TEST((certify(family::gauss, 2).error_constant != certify(family::gauss, 3).error_constant));
}

BOOST_AUTO_TEST_CASE(principal_errors_are_those_computed_from_the_tableaux) {
    // 2-norms from tableaux with 50 digits, by another program.
    const auto norm = [](family f, int s) { return certify(f, s).principal_error.value().norm; };
    BOOST_TEST(norm(family::gauss, 2) == "0.00433062198");
    BOOST_TEST(norm(family::gauss, 3) == "0.000165046691");
    BOOST_TEST(norm(family::radau_iia, 2) == "0.0244976973");
    BOOST_TEST(norm(family::radau_iia, 3) == "0.000989528507");
    BOOST_TEST(norm(family::lobatto_iiic, 4) == "0.000220062254");
    BOOST_TEST(certify(family::gauss, 5).principal_error.value().order == 11);
    BOOST_TEST(!certify(family::gauss, 6).principal_error.has_value());  // 12486 trees
}

BOOST_AUTO_TEST_CASE(r_at_infinity_is_plus_or_minus_1_or_0_or_a_pole) {
    for_all_members({family::gauss},
                    [](const certificate& c, int s) { BOOST_TEST((*c.r_infinity == sign_power(s))); });
    for_all_members({family::lobatto_iiia, family::lobatto_iiib},
                    [](const certificate& c, int s) { BOOST_TEST((*c.r_infinity == sign_power(s + 1))); });
    for_all_members({family::radau_ia, family::radau_iia, family::lobatto_iiic},
                    [](const certificate& c, int) { BOOST_TEST((*c.r_infinity == 0)); });
    for_all_members({family::radau_i, family::radau_ii}, [](const certificate& c, int) {
        BOOST_TEST(!c.r_infinity.has_value());
        BOOST_TEST(std::isnan(c.facts().r_infinity));
    });
}

BOOST_AUTO_TEST_CASE(six_families_are_A_stable_and_radau_i_and_ii_are_not) {
    for_all_members({family::gauss, family::radau_ia, family::radau_iia, family::lobatto_iiia,
                     family::lobatto_iiib, family::lobatto_iiic},
                    [](const certificate& c, int) { BOOST_TEST(c.a_stable.is_proved()); });
    for_all_members({family::radau_i, family::radau_ii},
                    [](const certificate& c, int) { BOOST_TEST(c.a_stable.is_refuted()); });
}

BOOST_AUTO_TEST_CASE(radau_ia_iia_and_lobatto_iiic_are_L_stable_and_gauss_is_not) {
    for_all_members({family::radau_ia, family::radau_iia, family::lobatto_iiic},
                    [](const certificate& c, int) { BOOST_TEST(c.l_stable.is_proved()); });
    for_all_members({family::gauss, family::lobatto_iiia, family::lobatto_iiib, family::radau_i},
                    [](const certificate& c, int) { BOOST_TEST(c.l_stable.is_refuted()); });
}

BOOST_AUTO_TEST_CASE(the_schwarz_form_agrees_with_sturm_and_routh_hurwitz) {
    for (const family f : tableaux::all_families)
        for (int s = tableaux::least_stages(f); s <= 5; ++s) {
            const legendre_model<rational> m(f, s);
            const auto form = schwarz_form_of(m.A());
            BOOST_TEST_REQUIRE(form.has_value());
            const auto r = stability_function_of(m);
            BOOST_TEST((e_polynomial(r) == poly::monomial(2 * form->size, form->leading_e())));
            BOOST_TEST(a_stable(r).is_proved() == form->is_a_stable());
        }
    const auto leading = [](family f, int s) {
        return schwarz_form_of(legendre_model<rational>(f, s).A())->leading_e();
    };
    BOOST_TEST((leading(family::radau_iia, 2) == rational(1, 36)));
    BOOST_TEST((leading(family::radau_iia, 3) == rational(1, 3600)));
    BOOST_TEST((leading(family::lobatto_iiic, 2) == rational(1, 4)));
    BOOST_TEST((leading(family::lobatto_iiic, 3) == rational(1, 576)));
    BOOST_TEST((leading(family::lobatto_iiic, 4) == rational(1, 129600)));
    BOOST_TEST((leading(family::gauss, 4) == 0));
    BOOST_TEST((leading(family::radau_i, 3) == rational(-1, 3600)));
}

BOOST_AUTO_TEST_CASE(gauss_M_is_zero) {
    for_all_members({family::gauss}, [](const certificate& c, int s) {
        BOOST_TEST((c.M == tableaux::inertia{.zero = s}));
        BOOST_TEST(c.symplectic.is_proved());
    });
    BOOST_TEST(certify(family::radau_iia, 2).symplectic.is_refuted());
}

BOOST_AUTO_TEST_CASE(radau_iia_M_has_rank_one) {
    for_all_members({family::radau_ia, family::radau_iia, family::lobatto_iiic},
                    [](const certificate& c, int s) {
                        BOOST_TEST((c.M == tableaux::inertia{.positive = 1, .zero = s - 1}));
                        BOOST_TEST(c.algebraically_stable.is_proved());
                        BOOST_TEST(c.b_stable.is_proved());
                    });
    // Radau I and II: rank one too, of the other sign.
    for_all_members({family::radau_i, family::radau_ii}, [](const certificate& c, int s) {
        BOOST_TEST((c.M == tableaux::inertia{.zero = s - 1, .negative = 1}));
        BOOST_TEST(c.algebraically_stable.is_refuted());
    });
}

BOOST_AUTO_TEST_CASE(lobatto_iiia_is_not_algebraically_stable) {
    for_all_members({family::lobatto_iiia, family::lobatto_iiib}, [](const certificate& c, int s) {
        BOOST_TEST(c.algebraically_stable.is_refuted());
        BOOST_TEST(c.b_stable.is_refuted());
        BOOST_TEST((c.M == tableaux::inertia{.positive = 1, .zero = s - 2, .negative = 1}));
        BOOST_TEST(c.weights.positive == s);  // it is M that fails, not b
    });
}

BOOST_AUTO_TEST_CASE(symmetric_and_stiffly_accurate_families) {
    for_all_members({family::gauss, family::lobatto_iiia, family::lobatto_iiib},
                    [](const certificate& c, int) { BOOST_TEST(c.symmetric.is_proved()); });
    for_all_members({family::radau_ia, family::radau_iia, family::lobatto_iiic},
                    [](const certificate& c, int) { BOOST_TEST(c.symmetric.is_refuted()); });
    for_all_members({family::radau_iia, family::lobatto_iiia, family::lobatto_iiic},
                    [](const certificate& c, int) { BOOST_TEST(c.stiffly_accurate.is_proved()); });
    for_all_members({family::gauss, family::radau_ia, family::radau_ii, family::lobatto_iiib},
                    [](const certificate& c, int) { BOOST_TEST(c.stiffly_accurate.is_refuted()); });
}

BOOST_AUTO_TEST_CASE(explicit_euler_has_every_C_and_order_one) {
    const auto c = certify(family::radau_i, 1);
    BOOST_TEST(c.simplifying.c == every);
    BOOST_TEST(c.simplifying.stage_order() == 1);
    BOOST_TEST(c.order == 1);
    BOOST_TEST(c.R.text() == "z + 1");
    BOOST_TEST(to_json(c)["C"] == "infinity");
    BOOST_TEST(certify(family::radau_ii, 1).simplifying.d == every);
    BOOST_TEST(certify(family::radau_iia, 1).simplifying.c == 1);
}

BOOST_AUTO_TEST_CASE(collocation_at_i_over_s_is_A_stable_for_two_stages_only) {
    const auto two = certify(equidistant(1, 2, 2), construction::collocation);
    BOOST_TEST(two.a_stable.is_proved());
    BOOST_TEST(two.l_stable.is_proved());
    BOOST_TEST((e_polynomial(two.R) == poly::monomial(4, rational(1, 16))));
    for (int s = 3; s <= 5; ++s)
        BOOST_TEST(certify(equidistant(1, s, s), construction::collocation).a_stable.is_refuted());
}

BOOST_AUTO_TEST_CASE(collocation_on_inner_and_on_closed_equidistant_nodes_is_A_stable) {
    for (int s = 2; s <= 5; ++s)
        BOOST_TEST(certify(equidistant(1, s, s + 1), construction::collocation).a_stable.is_proved());
    for (int s = 3; s <= 8; ++s)
        BOOST_TEST(certify(equidistant(0, s - 1, s - 1), construction::collocation).a_stable.is_proved());
    // The Newton-Cotes weights of nine closed nodes are not all positive.
    const auto nine = certify(equidistant(0, 8, 8), construction::collocation);
    BOOST_TEST(nine.weights.negative == 3);
    BOOST_TEST(nine.algebraically_stable.is_refuted());
}

BOOST_AUTO_TEST_CASE(a_user_polynomial_with_the_nodes_of_a_family_has_its_certificate) {
    const auto own =
        certify(nodal_polynomial::from_coefficients({rational(-1), rational(9), rational(-18), rational(10)}),
                construction::collocation);
    const auto family = certify(family::radau_iia, 3);
    BOOST_TEST((own.facts() == family.facts()));
    BOOST_TEST((own.R == family.R));
    BOOST_TEST((own.error_constant == family.error_constant));
    const auto other =
        certify(nodal_polynomial::from_nodes({{1, 6}, {2, 3}, {1, 1}}), construction::collocation);
    BOOST_TEST(!(other.facts() == family.facts()));
}

BOOST_AUTO_TEST_CASE(an_order_above_or_at_the_bound_is_settled_by_a_tree) {
    // Adjoint methods on general nodes have B = D = s, C = 0 or 1: the bound 2C + 2 is not B.
    const auto c = certify(equidistant(0, 3, 3), construction::adjoint);
    BOOST_TEST((c.simplifying == simplifying{4, 0, 4}));
    BOOST_TEST(c.order == 2);
    BOOST_TEST(c.order_verdict.is_proved());
    BOOST_TEST(c.order_verdict.reason().find("residual") != std::string::npos);
    const auto found =
        order_of(legendre_model<rational>(equidistant(0, 3, 3).legendre(), construction::adjoint), 5);
    BOOST_TEST(found.order == 2);
}

BOOST_AUTO_TEST_CASE(fifty_stages_of_any_family_are_certified) {
    for (const family f : tableaux::all_families) {
        const auto c = certify(f, 50);
        const bool radau = name(f).starts_with("radau"), gauss = f == family::gauss;
        BOOST_TEST(c.order == (gauss ? 100 : radau ? 99 : 98));
        BOOST_TEST((c.R.numerator.degree() + c.R.denominator.degree() == c.order));
        BOOST_TEST(c.order_verdict.is_proved());
    }
    // The error constant of the Pade approximation (n, n): (n!)^2 / ((2n)! (2n+1)!).
    const auto fact = [](int n) {
        tableaux::integer f = 1;
        for (int k = 2; k <= n; ++k) f *= k;
        return f;
    };
    BOOST_TEST(
        (certify(family::gauss, 50).error_constant == rational(fact(50) * fact(50), fact(100) * fact(101))));
}

BOOST_AUTO_TEST_CASE(facts_are_what_was_proved) {
    const facts expected{.order = 5,
                         .stage_order = 3,
                         .a_stable = true,
                         .algebraically_stable = true,
                         .symplectic = false,
                         .symmetric = false,
                         .r_infinity = 0};
    BOOST_TEST((certify(family::radau_iia, 3).facts() == expected));
    BOOST_TEST(expected.l_stable());
    BOOST_TEST(!(certify(family::radau_ia, 3).facts() == expected));  // stage order 2
}

BOOST_AUTO_TEST_CASE(the_json_certificate_has_the_documented_keys) {
    const auto j = to_json(certify(family::radau_iia, 3));
    BOOST_TEST(j["method"] == "radau_iia");
    BOOST_TEST(j["stages"] == 3);
    BOOST_TEST(j["order"]["value"] == 5);
    BOOST_TEST(j["order"]["verdict"] == "proved");
    BOOST_TEST(j["B"] == 5);
    BOOST_TEST(j["C"] == 3);
    BOOST_TEST(j["D"] == 2);
    BOOST_TEST(j["stage_order"] == 3);
    BOOST_TEST(j["R_infinity"] == "0");
    BOOST_TEST(j["A_stable"]["verdict"] == "proved");
    BOOST_TEST(j["L_stable"]["verdict"] == "proved");
    BOOST_TEST(j["algebraically_stable"]["verdict"] == "proved");
    BOOST_TEST(j["error_constant"] == "1/7200");
    BOOST_TEST(j["stability_function"]["numerator"].dump() == R"(["1","2/5","1/20"])");
    BOOST_TEST(j["stability_function"]["denominator"].dump() == R"(["1","-3/5","3/20","-1/60"])");
    const auto open = to_json(verdict::consistent("1e-17", "1e-16", "rounded data"));
    BOOST_TEST(open.dump() ==
               R"({"verdict":"consistent","residual":"1e-17","bound":"1e-16","reason":"rounded data"})");
}

BOOST_AUTO_TEST_CASE(the_text_has_one_line_for_each_claim) {
    const auto c = certify(family::lobatto_iiic, 3);
    const std::string text = c.text();
    BOOST_TEST(text.starts_with("lobatto_iiic, 3 stages\n"));
    BOOST_TEST(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) == c.claims().size() + 1);
    BOOST_TEST(text.find("E(y) = 1/576 y^6") != std::string::npos);
}
