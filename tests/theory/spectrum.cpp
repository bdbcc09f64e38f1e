// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE spectrum
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/tableaux/family.hpp>
#include <stagecraft/theory/judging/certificate_json.hpp>
#include <stagecraft/theory/judging/certify.hpp>
#include <stagecraft/theory/judging/subject_spectrum.hpp>
#include <string>
#include <vector>

using namespace stagecraft;
using namespace stagecraft::theory;
using tableaux::construction;
using tableaux::family;
using tableaux::nodal_polynomial;
using tableaux::quadratic;
using tableaux::rational;
using tableaux::undecided;
using poly = tableaux::polynomial<rational>;

namespace {

const poly x = poly::x();
poly number(const rational& q) { return poly(q); }

std::string poles(const certificate& c) { return text(c.spectra.poles.value()); }
std::string eigenvalues(const certificate& c) { return text(c.spectra.eigenvalues.value()); }

using matrix = Eigen::Matrix<quadratic, -1, -1>;
using column = Eigen::Matrix<quadratic, -1, 1>;

matrix square(const std::vector<quadratic>& rows) {
    const int n = rows.size() == 4 ? 2 : 3;
    matrix m(n, n);
    for (int i = 0; i < n * n; ++i) m(i / n, i % n) = rows[static_cast<std::size_t>(i)];
    return m;
}

subject<quadratic> on_trial(const matrix& A, const column& b) {
    subject<quadratic> s;
    s.t.A = A;
    s.t.b = b;
    s.t.c = A * column::Constant(b.size(), quadratic(1));
    s.strictly_lower = s.lower = true;
    for (Eigen::Index i = 0; i < A.rows(); ++i)
        for (Eigen::Index j = i; j < A.cols(); ++j) {
            const bool zero = A(i, j) == quadratic(0);
            s.strictly_lower = s.strictly_lower && zero;
            s.lower = s.lower && (zero || i == j);
        }
    return s;
}

/// n digits after the point are known.
tableaux::ball rounded(const rational& q, int n) {
    return tableaux::ball(q, checker_bits).widened(0.5L * std::pow(10.0L, -n));
}

}  // namespace

// RADAU5's constants (Hairer-Wanner II, IV.8) are the eigenvalues of A^-1, the poles of R.
BOOST_AUTO_TEST_CASE(poles_of_radau_iia_3_are_the_constants_of_radau5) {
    const auto c = certify(family::radau_iia, 3);
    BOOST_TEST(poles(c) == "3.63783425274, 2.68108287363 +- 3.05043019925 i");
    BOOST_TEST(eigenvalues(c) == "0.274888829596, 0.162555585202 +- 0.184949324407 i");
    const double cube = std::cbrt(9.0), gamma = 3 + cube - std::cbrt(3.0);  // in closed form
    BOOST_TEST(std::stod(poles(c)) == gamma, boost::test_tools::tolerance(1e-11));
    BOOST_TEST(c.text().find("poles of R: 3.63783425274") != std::string::npos);
    const auto j = to_json(c);
    BOOST_TEST(j["poles"].size() == 3U);
    BOOST_TEST(j["poles"][2]["re"] == "2.68108287363");
    BOOST_TEST(j["poles"][2]["im"] == "-3.05043019925");
    BOOST_TEST(j["eigenvalues"][0]["re"] == "0.274888829596");
    BOOST_TEST(poles(certify(family::gauss, 3)) != poles(c));
}

BOOST_AUTO_TEST_CASE(poles_of_gauss_2_are_3_plus_minus_i_sqrt_3) {
    const auto c = certify(family::gauss, 2);
    BOOST_TEST(poles(c) == "3.00000000000 +- 1.73205080757 i");
    BOOST_TEST(poles(certify(family::gauss, 1)) == "2");  // midpoint rule: exact
    BOOST_TEST(to_json(certify(family::gauss, 1))["poles"][0]["exact"] == "2");
}

BOOST_AUTO_TEST_CASE(every_family_has_s_eigenvalues_whose_sum_is_the_trace) {
    for (const auto f : tableaux::all_families)
        for (int s = tableaux::least_stages(f); s <= 8; ++s) {
            const auto c = certify(f, s);
            BOOST_REQUIRE(c.spectra.eigenvalues);
            BOOST_TEST(count(*c.spectra.eigenvalues) == s);
            BOOST_TEST(count(*c.spectra.poles) == c.R.denominator.degree());
            tableaux::ball trace(0);
            for (const auto& v : *c.spectra.eigenvalues)
                trace += v.value.re.times(v.multiplicity * (v.is_real() ? 1 : 2));
            // det(I - zA) = 1 - trace z + ..., its reciprocal roots the eigenvalues
            BOOST_TEST(trace.contains(-c.R.denominator[1]));
            BOOST_TEST(!trace.contains(-c.R.denominator[1] + rational(1, 1000000000)));
        }
}

BOOST_AUTO_TEST_CASE(beyond_twenty_stages_the_certificate_says_that_it_is_silent) {
    const auto c = certify(family::gauss, largest_spectrum + 1);
    BOOST_TEST(!c.spectra.poles.has_value());
    BOOST_TEST(c.text().find("up to 20 stages") != std::string::npos);
    BOOST_TEST(to_json(c).contains("spectrum_note"));
    BOOST_TEST(count(certify(family::gauss, largest_spectrum).spectra.poles.value()) == largest_spectrum);
    BOOST_TEST(certify(family::gauss, 3).spectra.note.empty());
}

BOOST_AUTO_TEST_CASE(roots_are_exact_where_rational_and_come_with_their_multiplicity) {
    const auto p = power(x - number({2, 3}), 3) * (x * x + number(1)) * x * x;
    BOOST_TEST(text(roots_of(p)) == "0 (multiplicity 2), 2/3 (multiplicity 3), 0 +- 1.00000000000 i");
    BOOST_TEST(count(roots_of(p)) == p.degree());
    const auto mirrored = roots_of((x * x - number(2)) * (x * x + x + number(1)) * (x * x - x + number(1)));
    BOOST_TEST(text(mirrored) ==
               "-1.41421356237, 1.41421356237, -0.500000000000 +- 0.866025403784 i, "
               "0.500000000000 +- 0.866025403784 i");
    BOOST_TEST(!mirrored[0].exact.has_value());
    BOOST_TEST(text(roots_of(number(7))) == "none");
}

BOOST_AUTO_TEST_CASE(sdirk_2_has_a_double_pole_in_its_field) {
    const quadratic gamma = quadratic(1) - quadratic(rational(0), rational(1, 2), 2);  // 1 - sqrt(2)/2
    const auto one = quadratic(1), zero = quadratic(0);
    const auto s =
        spectra_of(on_trial(square({gamma, zero, one - gamma, gamma}), column{{one - gamma, gamma}}));
    BOOST_REQUIRE_EQUAL(s.poles.value().size(), 1U);
    BOOST_TEST(s.poles->front().multiplicity == 2);
    BOOST_TEST(*s.poles->front().exact == quadratic(1) / gamma);
    BOOST_TEST(s.eigenvalues->front().multiplicity == 2);
    BOOST_TEST(*s.eigenvalues->front().exact == gamma);
    const auto two =
        spectra_of(on_trial(square({2, zero, one - gamma, gamma}), column{{one - gamma, gamma}}));
    BOOST_TEST(two.poles.value().size() == 2U);
    BOOST_TEST(two.poles->front().multiplicity == 1);
}

BOOST_AUTO_TEST_CASE(explicit_methods_have_no_poles_and_nilpotent_A) {
    const quadratic half = rational(1, 2);
    const auto heun = spectra_of(on_trial(square({0, 0, 1, 0}), column{{half, half}}));
    BOOST_TEST(text(heun.poles.value()) == "none");
    BOOST_TEST(text(heun.eigenvalues.value()) == "0 (multiplicity 2)");
    const auto trapezoidal = spectra_of(on_trial(square({0, 0, half, half}), column{{half, half}}));
    BOOST_TEST(text(trapezoidal.poles.value()) == "2");
    BOOST_TEST(text(trapezoidal.eigenvalues.value()) == "0, 1/2");
}

BOOST_AUTO_TEST_CASE(a_pole_that_cancels_remains_an_eigenvalue) {
    const quadratic half = rational(1, 2);
    const auto idle = spectra_of(on_trial(square({1, 0, 0, 3}), column{{1, 0}}));  // stage 2 has no weight
    BOOST_TEST(text(idle.poles.value()) == "1");
    BOOST_TEST(text(idle.eigenvalues.value()) == "1, 3");
    // full; b and the ones are orthogonal to the eigenvector (1, -1) of 3
    const auto hidden = spectra_of(on_trial(square({2, -1, -1, 2}), column{{half, half}}));
    BOOST_TEST(text(hidden.poles.value()) == "1");
    BOOST_TEST(text(hidden.eigenvalues.value()) == "1, 3");
    const auto seen = spectra_of(on_trial(square({2, -1, -1, 2}), column{{1, 0}}));
    BOOST_TEST(count(*seen.eigenvalues) == 2);
}

BOOST_AUTO_TEST_CASE(rounded_data_give_enclosures_as_wide_as_the_rounding) {
    using tableaux::ball;
    // Radau IIA-2 to 9 digits: eigenvalues 1/3 +- i sqrt(2)/6
    Eigen::Matrix<ball, -1, -1> A(2, 2);
    A << rounded({5, 12}, 9), rounded({-1, 12}, 9), rounded({3, 4}, 9), rounded({1, 4}, 9);
    const auto all = theory::detail::enclosed_eigenvalues(A);
    BOOST_REQUIRE_EQUAL(all.size(), 1U);
    BOOST_TEST(all[0].value.re.contains({1, 3}));
    BOOST_TEST(all[0].value.re.radius() < 1e-7L);
    BOOST_TEST(all[0].value.re.radius() > 1e-10L);
    BOOST_TEST(text(all).find(" within ") != std::string::npos);
    BOOST_TEST(to_json(all)[0].contains("radius"));
    A << rounded({1, 2}, 9), rounded({0}, 9), rounded({0}, 9), rounded({1, 2}, 9);  // double, or is it?
    BOOST_CHECK_THROW(theory::detail::enclosed_eigenvalues(A), undecided);
}
