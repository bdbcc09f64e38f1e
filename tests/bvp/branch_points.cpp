// SPDX-License-Identifier: BSL-1.0
// Paths of boundary value problems and where they cross, against closed forms.
#define BOOST_TEST_MODULE bvp_branch_points
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/bvp/continuation.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <string>

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

constexpr double pi = 3.14159265358979323846;

/// u'' + p sin u = 0, u'' + p u + u^2 = 0, u'' + p e^u = 0, with u(0) = u(1) = 0; y = u + p bend x (1 - x) / 2.
struct beam {
    enum { sine, square, exponential } which = sine;
    double bend = 0, load = 0;
    template <class T, class Y, class P>
    void operator()(const T& x, const Y& y, const P& p, Y& f) const {
        using std::exp;
        using std::sin;
        const auto u = y[0] - bend * p[0] * x * (1 - x) / 2;
        f[0] = y[1];
        if (which == sine) f[1] = -p[0] * sin(u) - bend * p[0] - load;
        if (which == square) f[1] = -p[0] * u - u * u - bend * p[0];
        if (which == exponential) f[1] = -p[0] * exp(u) - bend * p[0];
    }
};

struct zero_ends {
    template <class Y, class P, class R>
    void operator()(const Y& left, const Y& right, const P&, R& r) const {
        r[0] = left[0];
        r[1] = right[0];
    }
};

template <class Guess>
auto path(const beam& f, const Guess& guess, const sc::continuation_options<double>& o) {
    return sc::continuation(sc::gauss<5>(), sc::two_point(f, zero_ends{}), 0.0, 1.0, guess, o);
}

template <class Path>
auto of_kind(const Path& all, sc::point_kind kind) {
    Path found;
    for (const auto& point : all) {
        BOOST_TEST(sc::name(point.status) == std::string("success"));
        if (point.kind == kind) found.push_back(point);
    }
    return found;
}

/// K(k) by the arithmetic-geometric mean.
double quarter_period(double k) {
    double a = 1, b = std::sqrt(1 - k * k);
    while (std::abs(a - b) > 1e-15 * a) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b), a = mean;
    }
    return pi / (2 * a);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_beam_buckles_at_the_squares_of_k_pi_and_its_branches_are_followed) {
    for (const double bend : {0.0, 0.5}) {  // with 0.5 the solution that loses its stability is not 0
        const auto all = path({.bend = bend}, Vector2d(0, 0), {.from = 1, .to = 100, .largest_step = 4});
        const auto crossings = of_kind(all, sc::point_kind::branch_point);
        BOOST_TEST(of_kind(all, sc::point_kind::fold).empty());
        BOOST_TEST_REQUIRE(crossings.size() == 3U);
        for (int k = 1; k < 4; ++k) {
            const auto& at = crossings[static_cast<std::size_t>(k - 1)];
            const double load = k * k * pi * pi;
            BOOST_TEST(std::abs(at.p[0] - load) < 1e-9 * load);
            const auto buckled =
                path({.bend = bend}, at.crossing_y, {.from = at.crossing_p[0], .to = load + 5 * k});
            for (const auto& point : of_kind(buckled, sc::point_kind::regular)) {
                // The pendulum: k quarter periods twice, u'(0) = 2 sqrt(p) sin(u_max / 2).
                const double p = point.p[0], slope = point.y(0.0)[1] - bend * p / 2,
                             modulus = std::abs(slope) / (2 * std::sqrt(p));
                BOOST_TEST(modulus > 0.001);  // not the straight beam
                BOOST_TEST(std::abs(std::sqrt(p) - 2 * k * quarter_period(modulus)) < 1e-8 * p);
            }
            BOOST_TEST(buckled.back().p[0] > load + 5 * k);
        }
    }
}

BOOST_AUTO_TEST_CASE(an_imperfect_beam_has_no_branch_point_and_a_fold_is_none) {
    const auto bent = path({.load = 0.1}, Vector2d(0, 0), {.from = 1, .to = 30});
    BOOST_TEST(of_kind(bent, sc::point_kind::branch_point).empty());
    const auto bratu = path({.which = beam::exponential}, Vector2d(0, 0), {.from = 1, .to = 0.5});
    BOOST_TEST(of_kind(bratu, sc::point_kind::branch_point).empty());
    const auto turned = path({.which = beam::exponential}, Vector2d(0, 0), {.from = 1});
    BOOST_TEST(of_kind(turned, sc::point_kind::branch_point).empty());
    const auto folds = of_kind(turned, sc::point_kind::fold);
    BOOST_TEST_REQUIRE(folds.size() == 1U);
    BOOST_TEST(std::abs(folds[0].p[0] - 3.513830719125161) < 1e-11);
}

BOOST_AUTO_TEST_CASE(two_paths_that_cross_at_an_angle) {
    // u'' + p u + u^2 = 0 crosses u = 0 at pi^2 with dp/da = -8 / (3 pi), a the amplitude of sin(pi x).
    const auto all = path({.which = beam::square}, Vector2d(0, 0), {.from = 5, .to = 15});
    const auto crossings = of_kind(all, sc::point_kind::branch_point);
    BOOST_TEST_REQUIRE(crossings.size() == 1U);
    BOOST_TEST(std::abs(crossings[0].p[0] - pi * pi) < 1e-9);
    const double amplitude = crossings[0].crossing_y(0.5)[0],
                 slope = (crossings[0].crossing_p[0] - crossings[0].p[0]) / amplitude;
    BOOST_TEST(std::abs(slope + 8 / (3 * pi)) < 0.05);
    // Through the crossing from one side to the other, now along the path that is not 0.
    const auto across =
        path({.which = beam::square}, crossings[0].crossing_y,
             {.from = crossings[0].crossing_p[0],
              .to = crossings[0].p[0] + 3 * (crossings[0].p[0] - crossings[0].crossing_p[0])});
    const auto back = of_kind(across, sc::point_kind::branch_point);
    BOOST_TEST_REQUIRE(back.size() == 1U);
    BOOST_TEST(std::abs(back[0].p[0] - pi * pi) < 1e-9);
    BOOST_TEST(across.back().y(0.5)[0] * amplitude < 0);
}
