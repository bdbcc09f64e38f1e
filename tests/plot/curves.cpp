// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE curves
#include <stagecraft/theory/plot/gnuplot.hpp>
#include <stagecraft/theory/plot/tree_sheet.hpp>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

using namespace stagecraft;
using namespace stagecraft::theory::plot;
using tableaux::rational;

namespace {
rational_function pade(int j, int k) { return in_doubles(theory::pade<rational>(j, k)); }

double length(const curve& c) {
    double sum = 0;
    for (std::size_t k = 1; k < c.points.size(); ++k) sum += std::abs(c.points[k] - c.points[k - 1]);
    return sum;
}

double worst_modulus(const rational_function& r, const std::vector<curve>& all) {
    double worst = 0;
    for (const curve& c : all)
        for (const complex z : c.points) worst = std::max(worst, std::abs(std::abs(r(z)) - 1));
    return worst;
}

/// Where the boundary meets the real axis near `guess`.
double on_real_axis(const rational_function& r, double guess) {
    const auto f = [&r](complex z) { return r.log(z); };
    const level_tracer tracer(f, region_window(r), 0.1, 1);
    return tracer.onto_curve(guess).value().real();
}
}  // namespace

BOOST_AUTO_TEST_CASE(the_boundaries_of_both_euler_methods_are_circles) {
    for (const auto& [r, centre] : {std::pair{pade(1, 0), -1.0}, std::pair{pade(0, 1), 1.0}}) {
        const auto all = region_boundary(r, region_window(r));
        BOOST_REQUIRE(all.size() == 1U);
        BOOST_TEST(all[0].closed);
        for (const complex z : all[0].points) BOOST_REQUIRE(std::abs(std::abs(z - centre) - 1) < 1e-13);
        BOOST_TEST(std::abs(length(all[0]) - 2 * std::acos(-1.0)) < 1e-4);  // chords of a circle
    }
}

BOOST_AUTO_TEST_CASE(the_boundary_of_a_symmetric_method_is_the_imaginary_axis) {
    const auto r = pade(3, 3);
    const auto all = region_boundary(r, region_window(r));
    BOOST_REQUIRE(all.size() == 1U);
    BOOST_TEST(!all[0].closed);
    for (const complex z : all[0].points) BOOST_REQUIRE(std::abs(z.real()) < 1e-9);
    BOOST_TEST(length(all[0]) > 16);  // it leaves the window on both sides
}

BOOST_AUTO_TEST_CASE(known_ends_of_stability_intervals_lie_on_the_boundary) {
    BOOST_TEST(on_real_axis(pade(2, 3), 11.5) == 11.8423556133048, boost::test_tools::tolerance(1e-13));
    BOOST_TEST(on_real_axis(pade(4, 0), -2.7) == -2.78529356340528, boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(no_component_is_missed) {
    // |R| < 1 has a component round every zero that the others do not contain: 8/0 has two small islands.
    const auto taylor = region_boundary(pade(8, 0), region_window(pade(8, 0)));
    BOOST_TEST(taylor.size() == 3U);
    BOOST_TEST(worst_modulus(pade(8, 0), taylor) < 1e-12);
    // 0/6: |R| > 1 has one round the poles in the left half-plane, although the axis is stable.
    const auto padded = region_boundary(pade(0, 6), region_window(pade(0, 6)));
    BOOST_TEST(padded.size() == 3U);
    for (const auto* all : {&taylor, &padded})
        for (const curve& c : *all) BOOST_TEST(c.closed);
    // and a window without any of it shows none of it
    BOOST_TEST(shades([r = pade(8, 0)](complex z) { return std::abs(r(z)) <= 1 ? 0.0 : 1.0; },
                      {20, 30, 20, 30}, 50, 50, 1)
                   .empty());
}

BOOST_AUTO_TEST_CASE(p_plus_1_curves_of_the_order_star_cross_at_0) {
    for (const auto& [j, k] : {std::pair{1, 0}, {4, 0}, {2, 3}, {3, 3}, {0, 6}}) {
        const auto s = star_of(theory::pade<rational>(j, k));
        BOOST_TEST(s.order == j + k);
        int ends = 0;
        for (const curve& c : order_star_boundary(s, s.natural_window()))
            ends += (c.points.front() == complex(0)) + (c.points.back() == complex(0));
        BOOST_TEST(ends == 2 * (j + k + 1), j << "/" << k);
    }
}

BOOST_AUTO_TEST_CASE(noise_of_rounded_coefficients_does_not_hide_the_order) {
    auto r = theory::pade<rational>(2, 3);
    const rational noise(1, 1'000'000'000'000);
    r.numerator += theory::polynomial<rational>{0, noise};
    BOOST_TEST(star_of(r).order == 0);
    BOOST_TEST(star_of(r, rational(10) * noise).order == 5);
    BOOST_CHECK_THROW(star_of(r, rational(1)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(zeros_of_polynomials_with_complex_coefficients) {
    const auto z = zeros({complex(0, 2), complex(-2, -1), complex(1), complex(0)});  // (x - 2)(x - i)
    BOOST_REQUIRE(z.size() == 2U);
    BOOST_TEST(std::min(std::abs(z[0] - 2.0), std::abs(z[1] - 2.0)) < 1e-14);
    BOOST_TEST(std::min(std::abs(z[0] - complex(0, 1)), std::abs(z[1] - complex(0, 1))) < 1e-14);
    BOOST_TEST(zeros({complex(3)}).empty());
}

// All 200 trees to order 8: nodes of one height are apart, so no two meet and no edges cross.
BOOST_AUTO_TEST_CASE(nodes_of_a_drawn_tree_are_apart) {
    for (int n = 1; n <= 8; ++n)
        for (const rooted_tree& t : trees_of_order(n)) {
            const placed_tree p = placed(t);
            BOOST_REQUIRE(p.nodes.size() == static_cast<std::size_t>(n));
            for (std::size_t i = 0; i < p.nodes.size(); ++i) {
                const auto& a = p.nodes[i];
                BOOST_REQUIRE((a.x >= 0 && a.x <= p.width && a.height <= p.height));
                BOOST_REQUIRE((a.parent < 0) == (i == 0));
                if (i > 0) BOOST_REQUIRE(p.nodes[static_cast<std::size_t>(a.parent)].height == a.height - 1);
                for (std::size_t j = 0; j < i; ++j)
                    if (p.nodes[j].height == a.height) BOOST_REQUIRE(a.x - p.nodes[j].x >= 1);
            }
        }
    BOOST_CHECK_THROW(tree_sheet(0), std::invalid_argument);
    BOOST_CHECK_THROW(tree_sheet(11), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(windows_steps_and_output_names_are_checked) {
    const auto f = [](complex z) { return log_value{std::log(std::abs(z)), 1.0 / z}; };
    using tracer = level_tracer<decltype(f)>;
    BOOST_CHECK_THROW(tracer(f, {1, 1, 0, 1}, 0.1, 1), std::invalid_argument);
    BOOST_CHECK_THROW(tracer(f, {0, 1, 0, std::nan("")}, 0.1, 1), std::invalid_argument);
    BOOST_CHECK_THROW(tracer(f, {0, 1, 0, 1}, 0, 1), std::invalid_argument);
    script p;
    BOOST_CHECK_NO_THROW(p.text("a.svg"));
    BOOST_CHECK_THROW(p.text("a.gif"), std::invalid_argument);
    BOOST_TEST(p.text("|rm.svg").find("'|") == std::string::npos);  // no pipe to a command
    BOOST_TEST(gnuplot_string("a'b`c`\nd") == "'a''b`c` d'");
}
