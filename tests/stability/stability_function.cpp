// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE stability_function
#include <boost/test/unit_test.hpp>
#include <stagecraft/theory/stability/stability_function.hpp>

#include "methods.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;
using methods::q;
using methods::quadratic;
using methods::rational;

namespace {

template <class K>
void both_formulas_agree(const tableau<K>& t) {
    BOOST_TEST((stability_function_of(t) == stability_function_by_bordering(t)));
}

template <class K>
polynomial<K> lift(const polynomial<rational>& p) {
    std::vector<K> v;
    for (const auto& a : p.coefficients()) v.push_back(K(a));
    return polynomial<K>(std::move(v));
}

}  // namespace

BOOST_AUTO_TEST_CASE(both_determinant_formulas_agree_lecture_satz_2_18) {
    both_formulas_agree(methods::rk4());
    both_formulas_agree(methods::trapezoidal());
    both_formulas_agree(methods::ssp104());
    both_formulas_agree(methods::radau_ia3());
    both_formulas_agree(methods::lobatto_iiic4());
    both_formulas_agree(methods::gauss3());
    // both see a wrong sign
    auto wrong = methods::rk4();
    wrong.A(2, 1) = -wrong.A(2, 1);
    both_formulas_agree(wrong);
    BOOST_TEST(!(stability_function_of(wrong) == stability_function_of(methods::rk4())));
}

BOOST_AUTO_TEST_CASE(degrees_do_not_exceed_the_stages_lecture_satz_2_18) {
    const auto r = stability_function_of(methods::lobatto_iiib3());
    BOOST_TEST(r.numerator.degree() <= 3);
    BOOST_TEST(r.denominator.degree() <= 3);
    BOOST_TEST((r == pade<rational>(2, 2)));  // lowest terms: IIIB cancels a factor
}

BOOST_AUTO_TEST_CASE(explicit_methods_have_polynomials_lecture_folgerung_2_19) {
    BOOST_TEST(stability_function_of(methods::rk4()).denominator.degree() == 0);
    BOOST_TEST(stability_function_of(methods::rk4()).text() == "1/24*z^4 + 1/6*z^3 + 1/2*z^2 + z + 1");
    BOOST_TEST(stability_function_of(methods::ssp104()).denominator.degree() == 0);
    BOOST_TEST(stability_function_of(methods::implicit_euler()).denominator.degree() == 1);
}

BOOST_AUTO_TEST_CASE(examples_of_the_lecture) {
    const polynomial<rational> z = polynomial<rational>::x();
    const polynomial<rational> one(rational(1));
    const polynomial<rational> half(q(1, 2));
    BOOST_TEST((stability_function_of(methods::explicit_euler()).numerator == one + z));
    BOOST_TEST((stability_function_of(methods::implicit_euler()).denominator == one - z));
    const stability_function<rational> cayley{one + half * z, one - half * z};
    BOOST_TEST((stability_function_of(methods::midpoint()) == cayley));
    BOOST_TEST((stability_function_of(methods::trapezoidal()) == cayley));
    BOOST_TEST(stability_function_of(methods::trapezoidal()).text() == "(1/2*z + 1)/(-1/2*z + 1)");
}

BOOST_AUTO_TEST_CASE(the_families_are_pade_approximations) {
    const auto check = [](const auto& t, int j, int k) {
        using K = typename std::decay_t<decltype(t)>::scalar;
        const auto r = stability_function_of(t);
        const auto expected = pade<rational>(j, k);
        BOOST_TEST((r.numerator == lift<K>(expected.numerator)));
        BOOST_TEST((r.denominator == lift<K>(expected.denominator)));
        const auto fit = exponential_fit_of(r);
        BOOST_TEST(fit.pade);
        BOOST_TEST(fit.order == j + k);
    };
    check(methods::gauss2(), 2, 2);
    check(methods::gauss3(), 3, 3);
    check(methods::radau_iia2(), 1, 2);
    check(methods::radau_iia3(), 2, 3);
    check(methods::radau_ia2(), 1, 2);
    check(methods::radau_ia3(), 2, 3);
    check(methods::lobatto_iiia3(), 2, 2);
    check(methods::lobatto_iiib3(), 2, 2);
    check(methods::lobatto_iiic2(), 0, 2);
    check(methods::lobatto_iiic3(), 1, 3);
    check(methods::lobatto_iiic4(), 2, 4);
    BOOST_TEST(!exponential_fit_of(stability_function_of(methods::ssp104())).pade);
    BOOST_TEST(exponential_fit_of(stability_function_of(methods::ssp104())).order == 4);
}

BOOST_AUTO_TEST_CASE(error_constants_have_the_known_reciprocals) {
    const auto size = [](int j, int k) {
        return abs(exponential_fit_of(pade<rational>(j, k)).error_constant);
    };
    const long gauss[] = {12, 720, 100800, 25401600};
    const long radau[] = {2, 72, 7200, 1411200};
    for (int s = 1; s <= 4; ++s) {
        BOOST_TEST(1 / size(s, s) == rational(gauss[s - 1]));
        BOOST_TEST(1 / size(s - 1, s) == rational(radau[s - 1]));
    }
    // the signed constant of e^z - R: e^z = 1 + z + z^2/2, implicit Euler 1 + z + z^2
    BOOST_TEST(exponential_fit_of(pade<rational>(0, 1)).error_constant == q(-1, 2));
}

BOOST_AUTO_TEST_CASE(limits_at_infinity) {
    const auto limit = [](const auto& t) { return *stability_function_of(t).at_infinity(); };
    BOOST_TEST(limit(methods::gauss2()) == quadratic(1));
    BOOST_TEST(limit(methods::gauss3()) == quadratic(-1));
    BOOST_TEST(limit(methods::lobatto_iiia3()) == 1);
    BOOST_TEST(limit(methods::lobatto_iiib3()) == 1);
    BOOST_TEST(limit(methods::trapezoidal()) == -1);
    BOOST_TEST(limit(methods::radau_ia3()) == quadratic(0));
    BOOST_TEST(limit(methods::radau_iia3()) == quadratic(0));
    BOOST_TEST(limit(methods::lobatto_iiic4()) == quadratic(0));
    BOOST_TEST(!stability_function_of(methods::rk4()).at_infinity().has_value());
    // formula of the lecture after Satz 2.22: R(inf) = 1 - b^T A^-1 1
    const auto t = methods::radau_ia2();
    const auto inverse = *tableaux::inverse<rational>(t.A);
    rational value(1);
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) value -= t.b[i] * inverse(i, j);
    }
    BOOST_TEST(value == limit(t));
}

BOOST_AUTO_TEST_CASE(poles_are_the_eigenvalues_of_the_inverse) {
    // Radau IIA-2: 2 +- sqrt(2) i, that is z^2 - 4 z + 6
    const auto r = stability_function_of(methods::radau_iia2());
    BOOST_TEST((monic(r.denominator) == polynomial<rational>{6, -4, 1}));
    BOOST_TEST(r.poles().right == 2);
    // Radau IIA-3: one real at 3.637834252744496, the pair 2.681082873627752 +- 3.050430199247411 i
    const auto p = pade<rational>(2, 3).denominator;
    const auto roots = tableaux::isolate_real_roots(p);
    BOOST_TEST_REQUIRE(roots.size() == 1U);
    const auto real = refine(p, roots[0], rational(1, 1) / power(polynomial<rational>(rational(2)), 60)[0]);
    BOOST_TEST(std::abs(real.low.to<double>() - 3.637834252744496) < 2e-15);
    BOOST_TEST(std::abs((rational(9) - real.low).to<double>() / 2 - 2.681082873627752) < 2e-15);
    BOOST_TEST((monic(p) == polynomial<rational>{-60, 36, -9, 1}));
}

BOOST_AUTO_TEST_CASE(the_embedded_method_has_its_own_function) {
    auto t = methods::heun2();
    BOOST_CHECK_THROW(embedded_stability_function_of(t), std::invalid_argument);
    t.b_embedded.resize(2);
    t.b_embedded[0] = 1;
    t.b_embedded[1] = 0;
    BOOST_TEST((embedded_stability_function_of(t) == stability_function_of(methods::explicit_euler())));
}

BOOST_AUTO_TEST_CASE(bad_shapes_are_named) {
    auto t = methods::rk4();
    t.c.conservativeResize(3);
    BOOST_CHECK_EXCEPTION(stability_function_of(t), std::invalid_argument,
                          [](const auto& e) { return std::string(e.what()) == "tableau: c does not fit b"; });
    BOOST_CHECK_THROW(pade<rational>(-1, 2), std::invalid_argument);
    BOOST_CHECK_THROW(stability_function_of(methods::rk4())(rational(0)) == 1
                          ? stability_function<rational>::reduced(polynomial<rational>(rational(1)),
                                                                  polynomial<rational>::x())
                          : pade<rational>(0, 0),
                      std::invalid_argument);
    BOOST_CHECK_THROW(pade<rational>(0, 1)(rational(1)), std::domain_error);
}
