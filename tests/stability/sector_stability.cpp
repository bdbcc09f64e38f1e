// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE sector_stability
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <random>
#include <stagecraft/theory/stability/sector_stability.hpp>

#include "methods.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;
using methods::q;
using methods::quadratic;
using methods::rational;
using poly = polynomial<rational>;

namespace {

void angle_is(const stability_function<rational>& r, double degrees) {
    const auto s = largest_sector(r);
    BOOST_TEST(s.exists);
    BOOST_TEST(s.degrees_low <= degrees + 1e-12);
    BOOST_TEST(s.degrees_high >= degrees - 1e-12);
    BOOST_TEST(s.degrees_high - s.degrees_low < 1e-12 * degrees);
    // the enclosure is what it says: proved on one side, refuted on the other
    BOOST_TEST(a_alpha_stable(r, s.cosine_high).is_proved());
    BOOST_TEST(a_alpha_stable(r, s.cosine_low).is_refuted());
}

stability_function<rational> collocated_at_i_over(int s) {
    std::vector<rational> nodes;
    for (int i = 1; i <= s; ++i) nodes.push_back(q(i, s));
    return stability_function_of(tableaux::collocation<rational>(nodes).tableau);
}

}  // namespace

BOOST_AUTO_TEST_CASE(angles_of_pade_functions_without_numerator) {
    angle_is(pade<rational>(0, 3), 88.230152007182);
    angle_is(pade<rational>(0, 4), 83.984108926677);
    angle_is(pade<rational>(0, 5), 79.113864573196);
}

BOOST_AUTO_TEST_CASE(the_angle_of_pade_0_6_ends_at_a_pole_although_the_axis_is_stable) {
    const auto r = pade<rational>(0, 6);
    angle_is(r, 74.308592674656);
    // a ray beyond the poles is stable itself; the sector inside it is not
    const rational wide(1, 1000);
    BOOST_TEST(!tableaux::negative_point_from_zero(theory::detail::ray_polynomial(r, wide)).has_value());
    const auto v = a_alpha_stable(r, wide);
    BOOST_TEST(v.is_refuted());
    BOOST_TEST(v.reason().starts_with("a pole in the sector"));
}

BOOST_AUTO_TEST_CASE(angles_of_collocation_at_equidistant_nodes) {
    BOOST_TEST(largest_sector(collocated_at_i_over(2)).degrees_low == 90);
    angle_is(collocated_at_i_over(3), 89.318752841163);
    angle_is(collocated_at_i_over(4), 87.732178890001);
    angle_is(collocated_at_i_over(5), 85.648789120587);
}

BOOST_AUTO_TEST_CASE(a_stable_functions_have_exactly_the_right_angle_and_explicit_ones_no_sector) {
    const auto radau = largest_sector(pade<rational>(2, 3));
    BOOST_TEST(radau.exists);
    BOOST_TEST(radau.degrees_low == 90);
    BOOST_TEST(a_alpha_stable(pade<rational>(2, 3), rational(0)).is_proved());
    const auto rk4 = stability_function_of(methods::rk4());
    BOOST_TEST(!largest_sector(rk4).exists);
    BOOST_TEST(a_alpha_stable(rk4, q(1, 2)).is_refuted());
    BOOST_CHECK_THROW(a_alpha_stable(rk4, rational(2)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(roots_in_a_sector_match_products_of_known_factors) {
    std::mt19937 random(3);
    const auto number = [&](int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(random);
    };
    for (int trial = 0; trial < 300; ++trial) {
        const rational u(number(1, 15), 16);
        poly p(rational(1));
        int inside = 0;
        const int linear = number(0, 3);
        for (int k = 0; k < linear; ++k) {
            const int root = number(-4, 4);
            if (root == 0) continue;
            p *= poly{-root, 1};
            inside += root < 0 ? 1 : 0;
        }
        const int pairs = number(0, 3);
        for (int k = 0; k < pairs; ++k) {
            const int re = number(-5, 5);
            const int im = number(1, 5);
            const rational modulus_squared(re * re + im * im);
            // |arg(-z)| < alpha: -re > u |z|
            const rational gap = rational(re) * re - u * u * modulus_squared;
            if (re < 0 && gap == 0) continue;  // on the ray
            p *= poly{modulus_squared, -2 * re, 1};
            inside += re < 0 && gap > 0 ? 2 : 0;
        }
        BOOST_TEST(theory::detail::roots_in_sector(p, u) == inside, to_string(p) + ", cosine " + u.str());
    }
}

BOOST_AUTO_TEST_CASE(an_angle_with_vanishing_chebyshev_polynomial_is_counted_right) {
    // cos 30 degrees = sqrt(3)/2: cos(3 alpha) = 0 for a cubic
    using K = quadratic;
    const K u(0, q(1, 2), 3);
    const polynomial<K> x = polynomial<K>::x();
    const auto shift = [&](int a) { return x + polynomial<K>(K(a)); };
    BOOST_TEST(theory::detail::roots_in_sector(shift(1) * shift(2) * shift(3), u) == 3);
    BOOST_TEST(theory::detail::roots_in_sector(shift(-1) * shift(2) * shift(3), u) == 2);
    BOOST_TEST(theory::detail::roots_in_sector(shift(-1) * shift(-2) * shift(3), u) == 1);
    BOOST_TEST(theory::detail::roots_in_sector(shift(-1) * shift(-2) * shift(-3), u) == 0);
}

BOOST_AUTO_TEST_CASE(verdicts_on_random_functions_agree_with_samples_of_the_left_half_plane) {
    // A proof that a sample contradicts, or a sector larger than a sampled one, would show here.
    std::mt19937 random(11);
    const auto number = [&](int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(random);
    };
    int stable = 0, sectors = 0, unstable = 0;
    for (int trial = 0; trial < 150; ++trial) {
        const int degree = number(2, 4);
        poly bottom(rational(1));
        for (int k = 0; k < degree; ++k) bottom *= poly{1, -q(number(1, 8), 8)};
        std::vector<rational> top{1};
        const int top_degree = number(1, degree);
        for (int k = 0; k < top_degree; ++k) top.push_back(q(number(-6, 6), 8 << k));
        const auto r = stability_function<rational>::reduced(poly(top), bottom);
        const auto modulus = [&](double size, double angle) {  // |R| at arg(-z) = angle
            const std::complex<double> z = -std::polar(size, angle);
            const auto value = [&](const poly& p) {
                std::complex<double> sum = 0;
                for (int k = p.degree(); k >= 0; --k) sum = sum * z + p[k].to<double>();
                return std::abs(sum);
            };
            return value(r.numerator) / value(r.denominator);
        };
        const auto largest = [&](double angle) {
            double found = 0;
            for (int k = -200; k <= 200; ++k) found = std::max(found, modulus(std::exp(0.05 * k), angle));
            return found;
        };
        const auto s = largest_sector(r);
        const double right = std::acos(0.0);
        if (a_stable(r).is_proved()) {
            ++stable;
            for (int k = 0; k <= 8; ++k) BOOST_TEST(largest(right * k / 8) <= 1 + 1e-12, r.text());
        } else if (s.exists) {
            ++sectors;
            const double inside = s.degrees_low / 90 * right;
            for (int k = 0; k <= 8; ++k) BOOST_TEST(largest(inside * k / 8) <= 1 + 1e-12, r.text());
        } else if (a0_stable(r).is_refuted()) {
            ++unstable;
            const auto interval = real_stability_interval(r);
            const double end = interval.low.to<double>();
            for (int k = 1; k <= 50; ++k) BOOST_TEST(modulus(end * k / 50, 0) <= 1 + 1e-12, r.text());
            BOOST_TEST(!interval.infinite, r.text());
        }
    }
    BOOST_TEST(stable > 15);
    BOOST_TEST(sectors > 5);
    BOOST_TEST(unstable > 15);
}
