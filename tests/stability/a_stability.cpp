// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE a_stability
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/theory/stability/di_stability.hpp>

#include "methods.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;
using methods::q;
using methods::quadratic;
using methods::rational;
using poly = polynomial<rational>;

namespace {

/// The stability function of an s-stage SDIRK method of order s with diagonal gamma (Hairer-Wanner II.IV.6):
/// Q = (1 - gamma z)^s, P = the terms of Q e^z up to z^degree.
stability_function<rational> sdirk(int s, const rational& gamma, int degree) {
    const poly bottom = power(poly{1, -gamma}, s);
    std::vector<rational> top;
    for (int n = 0; n <= degree; ++n) {
        rational sum(0);
        for (int k = 0; k <= n; ++k) {
            rational factorial(1);
            for (int i = 2; i <= n - k; ++i) factorial *= i;
            sum += bottom[k] / factorial;
        }
        top.push_back(sum);
    }
    return stability_function<rational>::reduced(poly(top), bottom);
}

/// d.ddd...e-k without a detour through double.
rational decimal(long digits, int places) {
    rational scale(1);
    for (int k = 0; k < places; ++k) scale *= 10;
    return rational(digits) / scale;
}

std::vector<rational> equidistant(int s, int first, int parts) {
    std::vector<rational> nodes;
    for (int i = 0; i < s; ++i) nodes.push_back(q(first + i, parts));
    return nodes;
}

stability_function<rational> collocated(const std::vector<rational>& nodes) {
    return stability_function_of(tableaux::collocation<rational>(nodes).tableau);
}

bool a(const stability_function<rational>& r) { return a_stable(r).is_proved(); }

}  // namespace

BOOST_AUTO_TEST_CASE(leading_terms_of_the_e_polynomial) {
    const auto e = [](int j, int k) { return e_polynomial(pade<rational>(j, k)); };
    BOOST_TEST((e(1, 2) == poly::monomial(4, q(1, 36))));      // Radau IIA-2
    BOOST_TEST((e(2, 3) == poly::monomial(6, q(1, 3600))));    // Radau IIA-3
    BOOST_TEST((e(0, 2) == poly::monomial(4, q(1, 4))));       // Lobatto IIIC-2
    BOOST_TEST((e(1, 3) == poly::monomial(6, q(1, 576))));     // IIIC-3
    BOOST_TEST((e(2, 4) == poly::monomial(8, q(1, 129600))));  // IIIC-4
    BOOST_TEST(e(3, 3).is_zero());                             // Gauss-3
    BOOST_TEST((e_polynomial(stability_function_of(methods::lobatto_iiic3())) == e(1, 3)));
    BOOST_TEST((e_polynomial(collocated({q(1, 2), 1})) == poly::monomial(4, q(1, 16))));
}

BOOST_AUTO_TEST_CASE(radau_iia_and_lobatto_iiic_are_l_stable_lecture_satz_2_23) {
    BOOST_TEST(l_stable(stability_function_of(methods::implicit_euler())).is_proved());
    BOOST_TEST(l_stable(stability_function_of(methods::radau_iia2())).is_proved());
    BOOST_TEST(l_stable(stability_function_of(methods::radau_iia3())).is_proved());
    BOOST_TEST(l_stable(stability_function_of(methods::lobatto_iiic2())).is_proved());
    BOOST_TEST(l_stable(stability_function_of(methods::lobatto_iiic3())).is_proved());
    BOOST_TEST(l_stable(stability_function_of(methods::lobatto_iiic4())).is_proved());
    for (int s = 1; s <= 8; ++s) {  // as Pade functions for more stages
        BOOST_TEST(l_stable(pade<rational>(s - 1, s)).is_proved());
        if (s > 1) BOOST_TEST(l_stable(pade<rational>(s - 2, s)).is_proved());
        BOOST_TEST(l_stable(pade<rational>(s, s)).is_refuted());
    }
}

BOOST_AUTO_TEST_CASE(gauss_is_a_stable_but_not_strongly_lecture_satz_2_23) {
    for (const auto& t : {methods::gauss2(), methods::gauss3()}) {
        const auto r = stability_function_of(t);
        BOOST_TEST(a_stable(r).is_proved());
        BOOST_TEST(strongly_a_stable(r).is_refuted());
        BOOST_TEST(l_stable(r).is_refuted());
    }
    const auto r = stability_function_of(methods::trapezoidal());
    BOOST_TEST(a_stable(r).is_proved());
    BOOST_TEST(strongly_a_stable(r).is_refuted());
    BOOST_TEST(l_stable(r).reason() == "R(inf) = -1");
    BOOST_TEST(strongly_a_stable(stability_function_of(methods::radau_iia2())).is_proved());
}

BOOST_AUTO_TEST_CASE(the_ehle_conjecture_holds_where_it_is_decided) {
    // A-stable exactly for k - 2 <= j <= k (Wanner, Hairer, Norsett 1978)
    for (int j = 0; j <= 7; ++j) {
        for (int k = 0; k <= 7; ++k) BOOST_TEST(a(pade<rational>(j, k)) == (k - 2 <= j && j <= k));
    }
}

BOOST_AUTO_TEST_CASE(stable_on_the_whole_axis_with_poles_in_the_left_half_plane_is_not_a_stable) {
    const auto r = pade<rational>(0, 6);
    BOOST_TEST(i_stable(r).is_proved());
    BOOST_TEST(r.poles().left == 2);
    BOOST_TEST(r.poles().right == 4);
    BOOST_TEST(a_stable(r).is_refuted());
    BOOST_TEST(a_stable(r).reason().starts_with("2 pole(s) in the left half-plane"));
    // 0/4: poles in the right half-plane, not I-stable: the other half of the criterion
    BOOST_TEST(pade<rational>(0, 4).poles().left == 0);
    BOOST_TEST(i_stable(pade<rational>(0, 4)).is_refuted());
}

BOOST_AUTO_TEST_CASE(a_refuted_i_stability_shows_its_point) {
    const auto r = pade<rational>(0, 3);
    const auto v = i_stable(r);
    BOOST_TEST_REQUIRE(v.is_refuted());
    const std::string start = "|R(iy)| > 1 at y^2 = ";
    BOOST_TEST_REQUIRE(v.reason().starts_with(start));
    const auto x = in_square(e_polynomial(r));
    const auto slash = v.reason().find('/');
    const tableaux::integer n(v.reason().substr(start.size(), slash - start.size()));
    const tableaux::integer d(slash == std::string::npos ? "1" : v.reason().substr(slash + 1));
    BOOST_TEST(x(rational(n, d)) < 0);
}

BOOST_AUTO_TEST_CASE(no_explicit_method_is_a_stable_lecture_satz_2_22) {
    for (const auto& t : {methods::explicit_euler(), methods::heun2(), methods::kutta3(), methods::rk4(),
                          methods::ssp33(), methods::ssp104()}) {
        const auto r = stability_function_of(t);
        BOOST_TEST(a_stable(r).is_refuted());
        BOOST_TEST(a0_stable(r).is_refuted());
        BOOST_TEST(!a_stable(r).reason().empty());
    }
    BOOST_TEST(a_stable(stability_function_of(methods::implicit_euler())).is_proved());
}

BOOST_AUTO_TEST_CASE(intervals_of_stability_on_both_axes) {
    const auto mid = [](const auto& i) { return ((i.low + i.high) / rational(2)).template to<double>(); };
    const auto r = stability_function_of(methods::rk4());
    const auto real = real_stability_interval(r);
    BOOST_TEST(!real.infinite);
    BOOST_TEST(std::abs(mid(real) - 2.78529356340528) < 1e-14);
    BOOST_TEST((real.high - real.low).to<double>() < 1e-18);
    const auto square = imaginary_stability_square(r);
    BOOST_TEST((square.low <= 8 && 8 <= square.high));
    BOOST_TEST(square.high - square.low < decimal(1, 17));
    BOOST_TEST(std::abs(mid(imaginary_stability_interval(r)) - 2 * std::sqrt(2.0)) < 1e-15);
    const auto kutta = imaginary_stability_square(stability_function_of(methods::kutta3()));
    BOOST_TEST((kutta.low <= 3 && 3 <= kutta.high));
    // none at all for Euler and Heun, all of it for the midpoint rule
    BOOST_TEST(imaginary_stability_interval(stability_function_of(methods::explicit_euler())).high == 0);
    BOOST_TEST(imaginary_stability_interval(stability_function_of(methods::heun2())).high == 0);
    BOOST_TEST(imaginary_stability_interval(stability_function_of(methods::midpoint())).infinite);
    BOOST_TEST(real_stability_interval(stability_function_of(methods::midpoint())).infinite);
    const auto euler = real_stability_interval(stability_function_of(methods::explicit_euler()));
    BOOST_TEST((euler.low <= 2 && 2 <= euler.high));
}

BOOST_AUTO_TEST_CASE(radau_iia3_leaves_the_unit_disc_on_the_positive_axis_only) {
    const auto r = pade<rational>(2, 3);
    // |R(x)| = 1 for x > 0: Q^2 = P^2
    const auto p = reflected(real_axis_polynomial(r));
    double largest = 0;
    for (const auto& root : tableaux::isolate_real_roots(p)) {
        largest = std::max(largest, refine(squarefree(p), root, decimal(1, 17)).high.to<double>());
    }
    BOOST_TEST(std::abs(largest - 11.8423556133048) < 1e-13);
    BOOST_TEST(a0_stable(r).is_proved());
}

BOOST_AUTO_TEST_CASE(sdirk_of_order_s_is_a_stable_in_the_published_ranges) {
    BOOST_TEST(a(sdirk(2, q(1, 4), 2)));
    BOOST_TEST(!a(sdirk(2, q(1, 4) - decimal(1, 15), 2)));
    BOOST_TEST(a(sdirk(2, rational(1000), 2)));
    BOOST_TEST(a(sdirk(3, q(1, 3), 3)));
    BOOST_TEST(!a(sdirk(3, q(1, 3) - decimal(1, 15), 3)));
    BOOST_TEST(a(sdirk(3, decimal(1068579021301628, 15), 3)));
    BOOST_TEST(!a(sdirk(3, decimal(1068579021301630, 15), 3)));
    BOOST_TEST(!a(sdirk(4, decimal(3943375672974063, 16), 4)));
    BOOST_TEST(a(sdirk(4, decimal(3943375672974065, 16), 4)));
    BOOST_TEST(a(sdirk(4, decimal(1280579761275304, 15), 4)));
    BOOST_TEST(!a(sdirk(4, decimal(1280579761275306, 15), 4)));
}

BOOST_AUTO_TEST_CASE(sdirk_with_smaller_numerator_is_l_stable_in_the_published_ranges) {
    const auto l = [](int s, const rational& gamma) { return l_stable(sdirk(s, gamma, s - 1)).is_proved(); };
    BOOST_TEST(!l(2, decimal(2928932188, 10)));  // 1 - 1/sqrt 2 = 0.29289321881...
    BOOST_TEST(l(2, decimal(2928932189, 10)));
    BOOST_TEST(l(2, decimal(17071067811, 10)));
    BOOST_TEST(!l(2, decimal(17071067812, 10)));
    // p = s = 3 and L-stable: gamma is a root of R(inf) = 0, g^3 - 3 g^2 + 3/2 g - 1/6 = 0
    const poly cubic{q(-1, 6), q(3, 2), -3, 1};
    const auto roots = tableaux::isolate_real_roots(cubic);
    int stable = 0;
    for (const auto& root : roots) {
        const auto fine = refine(cubic, root, decimal(1, 17));
        if (!a(sdirk(3, fine.high, 3))) continue;
        ++stable;
        BOOST_TEST(std::abs(fine.high.to<double>() - 0.435866521508459) < 1e-15);
        const auto below = *sdirk(3, fine.low, 3).at_infinity();
        const auto above = *sdirk(3, fine.high, 3).at_infinity();
        BOOST_TEST(below * above < 0);  // R(inf) changes its sign inside the enclosure
    }
    BOOST_TEST(stable == 1);
}

BOOST_AUTO_TEST_CASE(collocation_at_equidistant_nodes) {
    BOOST_TEST(l_stable(collocated(equidistant(2, 1, 2))).is_proved());
    for (int s = 3; s <= 5; ++s) BOOST_TEST(!a(collocated(equidistant(s, 1, s))));
    for (int s = 2; s <= 5; ++s) BOOST_TEST(a(collocated(equidistant(s, 1, s + 1))));
    for (int s = 3; s <= 8; ++s) BOOST_TEST(a(collocated(equidistant(s, 0, s - 1))));
}

BOOST_AUTO_TEST_CASE(the_embedded_method_is_judged_by_its_own_weights) {
    auto t = methods::trapezoidal();
    t.b_embedded.resize(2);
    t.b_embedded[0] = 0;
    t.b_embedded[1] = 1;  // stages of the trapezoidal rule, y1 = y0 + h f(Y_2)
    BOOST_TEST(a_stable(stability_function_of(t)).is_proved());
    const auto r = embedded_stability_function_of(t);
    BOOST_TEST(a_stable(r).is_refuted());
}

BOOST_AUTO_TEST_CASE(gauss_and_lobatto_iiia_are_di_stable_and_radau_iia_is_not) {
    for (int s = 1; s <= 8; ++s) BOOST_TEST(di_stable(pade<rational>(s, s)).is_proved());
    BOOST_TEST(di_stable(stability_function_of(methods::trapezoidal())).is_proved());
    BOOST_TEST(di_stable(collocated({0, q(1, 2), 1})).is_proved());  // Lobatto IIIA-3
    const auto radau = stability_function_of(methods::radau_iia3());
    BOOST_TEST(di_stable(radau).is_refuted());
    const auto x = growth_interval(radau);
    BOOST_TEST(std::abs(x.high.to<double>() - 11.8423556133048) < 1e-12);
    BOOST_TEST(radau(quadratic(x.high + q(1, 1000))) < quadratic(1));
    BOOST_TEST(radau(quadratic(x.low - q(1, 1000))) * radau(quadratic(x.low - q(1, 1000))) > quadratic(1));
}

BOOST_AUTO_TEST_CASE(symmetric_and_a_stable_is_di_stable_and_either_alone_is_not_enough) {
    for (int s = 3; s <= 8; ++s) BOOST_TEST(di_stable(collocated(equidistant(s, 0, s - 1))).is_proved());
    const auto narrow = collocated(equidistant(5, 48, 100));  // symmetric, not A-stable
    BOOST_TEST(e_polynomial(narrow).is_zero());
    BOOST_TEST(di_stable(narrow).is_refuted());
    BOOST_TEST(a_stable(pade<rational>(0, 1)).is_proved());  // implicit Euler: |R| < 1 from x = 2 on
    BOOST_TEST(di_stable(pade<rational>(0, 1)).is_refuted());
    BOOST_TEST((growth_interval(pade<rational>(0, 1)).high == rational(2)));
    BOOST_TEST(di_stable(stability_function<rational>{poly{1}, poly{1}}).is_refuted());
}
