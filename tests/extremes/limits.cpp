// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE limits
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <stagecraft/integrate.hpp>
#include <stagecraft/tableaux/rounded.hpp>

// Step bounds, one to twenty stages, times and spans at the ends of what double resolves.

namespace sc = stagecraft;
using sc::tableaux::family;
using enum sc::tableaux::family;
using V1 = Eigen::Matrix<double, 1, 1>;
using V2 = Eigen::Vector2d;

namespace {

const double eps = std::numeric_limits<double>::epsilon();

sc::transformed_tableau<double> radau(int s) { return sc::tableaux::transformed<double>(radau_iia, s); }

// Right-hand sides of one type for each number of components: an integrator is compiled for a type.
template <class V>
using function_of = std::function<void(double, const V&, V&)>;

// y' = y cos t, y(0) = 1: exp(sin t).
const function_of<V1> wave = [](double t, const V1& y, V1& f) { f[0] = y[0] * std::cos(t); };

// y' = f(t, y) with df/dy = -rate: many problems, one type.
struct decay {
    double rate;
    std::function<double(double, double)> right;
    void operator()(double t, const V1& y, V1& f) const { f[0] = right(t, y[0]); }
    void jacobian(double, const V1&, Eigen::Matrix<double, 1, 1>& J) const { J(0, 0) = -rate; }
};

}  // namespace

BOOST_AUTO_TEST_CASE(no_step_is_longer_than_max_step_nor_shorter_than_min_step) {
    const auto m = radau(3);
    double longest = 0, shortest = 1e300;
    const auto look = [&](double, const V1&, double h) {
        longest = std::max(longest, h);
        shortest = std::min(shortest, h);
    };
    const auto r = sc::integrate(m, wave, V1(1.0), 0, 10, {.max_step = 0.03}, look);
    BOOST_TEST(r.ok());
    BOOST_TEST(longest <= 0.03 * (1 + 1e-10));
    BOOST_TEST(r.report.steps >= 334);
    BOOST_TEST(r.report.largest_step == longest);

    longest = 0, shortest = 1e300;
    const auto both = sc::integrate(m, wave, V1(1.0), 0, 10,
                                    {.rtol = 1e-4, .atol = 1e-4, .min_step = 0.01, .max_step = 0.5}, look);
    BOOST_TEST(both.ok());
    BOOST_TEST(shortest >= 0.01 / 2);  // the last two steps share the rest of the way
    BOOST_TEST(longest <= 0.5 * (1 + 1e-10));

    // An error bound that asks for less than min_step is a status, not a step.
    const auto refused =
        sc::integrate(m, wave, V1(1.0), 0, 10, {.rtol = 1e-13, .atol = 1e-13, .min_step = 0.4}, look);
    BOOST_TEST(sc::name(refused.status) == "step_underflow");
    BOOST_TEST(std::abs(refused.y[0] - std::exp(std::sin(refused.t))) < 1e-11);

    // Backwards as well.
    longest = 0;
    const auto back = sc::integrate(m, wave, V1(1.0), 0, -10, {.max_step = 0.03},
                                    [&](double, const V1&, double h) { longest = std::max(longest, -h); });
    BOOST_TEST(back.ok());
    BOOST_TEST(longest <= 0.03 * (1 + 1e-10));
    BOOST_TEST(longest > 0);
}

BOOST_AUTO_TEST_CASE(an_initial_step_beyond_the_span_or_far_too_long_is_cut) {
    const auto m = radau(3);
    for (const double first : {1e-14, 1e-3, 10.0, 1e10, 1e300}) {
        const auto r =
            sc::integrate(m, wave, V1(1.0), 0, 10, {.rtol = 1e-8, .atol = 1e-8, .initial_step = first});
        BOOST_TEST_CONTEXT("first step " << first) {
            BOOST_TEST(r.ok());
            BOOST_TEST(std::abs(r.y[0] - std::exp(std::sin(10.0))) < 1e-7);
        }
    }
}

BOOST_AUTO_TEST_CASE(one_to_twenty_stages_of_every_family_solve_to_tolerance) {
    const auto check = [](family f, int s) {
        const auto m = sc::tableaux::transformed<double>(f, s);
        for (const double tol : {1e-3, 1e-6, 1e-9, 1e-12}) {
            if (s == 1 && tol < 1e-5) continue;
            if (s == 2 && tol < 1e-8) continue;
            const auto r = sc::integrate(m, wave, V1(1.0), 0, 3, {.rtol = tol, .atol = tol});
            const auto stiff = sc::integrate(m, function_of<V2>([](double t, const V2& y, V2& out) {
                                                 out[0] = -y[1];
                                                 out[1] = y[0] - 1e5 * (y[1] - std::sin(t));
                                             }),
                                             V2(1, 0), 0, 1, {.rtol = tol, .atol = tol});
            BOOST_TEST_CONTEXT(name(f) << " s = " << s << " tol = " << tol) {
                BOOST_TEST(sc::name(r.status) == "success");
                BOOST_TEST(std::abs(r.y[0] - std::exp(std::sin(3.0))) < 50 * tol);
                BOOST_TEST(sc::name(stiff.status) == "success");
                // y2 = sin t + O(1e-5): y1 = cos t up to that.
                BOOST_TEST(std::abs(stiff.y[0] - std::cos(1.0)) < 2e-5 + 50 * tol);
            }
        }
    };
    for (int s = 1; s <= 20; ++s) check(radau_iia, s);
    for (const int s : {3, 4, 8, 13, 20}) check(lobatto_iiic, s);
}

BOOST_AUTO_TEST_CASE(gauss_and_radau_ia_to_twenty_stages_where_nothing_is_stiff) {
    for (const family f : {gauss, radau_ia})
        for (const int s : {1, 2, 3, 5, 8, 13, 20}) {
            const auto m = sc::tableaux::transformed<double>(f, s);
            for (const double tol : {1e-3, 1e-6, 1e-9}) {
                if (s == 1 && tol < 1e-5) continue;
                if (s == 2 && tol < 1e-8) continue;
                const auto r = sc::integrate(m, wave, V1(1.0), 0, 3, {.rtol = tol, .atol = tol});
                BOOST_TEST_CONTEXT(name(f) << " s = " << s << " tol = " << tol) {
                    BOOST_TEST(sc::name(r.status) == "success");
                    BOOST_TEST(std::abs(r.y[0] - std::exp(std::sin(3.0))) < 50 * tol);
                }
            }
        }
}

// At t = 1e15 neighbouring doubles are 1/8 apart: what needs no finer steps is solved, all else is refused.
BOOST_AUTO_TEST_CASE(at_times_of_1e15_steps_are_those_that_t_resolves) {
    const auto m = radau(3);
    const function_of<V1> slow = [](double, const V1& y, V1& f) { f[0] = -y[0] / 1e6; };
    const auto r = sc::integrate(m, slow, V1(1.0), 1e15, 1e15 + 1e6, {.rtol = 1e-6, .atol = 1e-9});
    BOOST_TEST(sc::name(r.status) == "success");
    BOOST_TEST(r.t == 1e15 + 1e6);
    BOOST_TEST(r.y[0] == std::exp(-1.0), boost::test_tools::tolerance(1e-5));

    const function_of<V1> fast = [](double, const V1& y, V1& f) { f[0] = -1e3 * y[0] + 1e3; };
    const auto q = sc::integrate(m, fast, V1(0.0), 1e15, 1e15 + 1, {.rtol = 1e-8, .atol = 1e-8});
    BOOST_TEST(std::isfinite(q.y[0]));
    if (q.ok()) BOOST_TEST(std::abs(q.y[0] - 1) < 1e-6);

    const function_of<V2> oscillation = [](double, const V2& y, V2& f) { f = V2(30 * y[1], -30 * y[0]); };
    const auto o = sc::integrate(m, oscillation, V2(1, 0), 1e15, 1e15 + 10, {.rtol = 1e-10, .atol = 1e-10});
    BOOST_TEST(sc::name(o.status) == "step_underflow");
    BOOST_TEST(o.t == 1e15);
    BOOST_TEST((o.y == V2(1, 0)));

    // Equal steps land on t1 exactly, however t is rounded.
    const auto equal = sc::integrate(m, slow, V1(1.0), 1e15, 1e15 + 1e6, {.fixed_step = 1e4});
    BOOST_TEST(equal.report.steps == 100);
    BOOST_TEST(equal.t == 1e15 + 1e6);
    BOOST_TEST(equal.y[0] == std::exp(-1.0), boost::test_tools::tolerance(1e-7));
    // A hundred steps in a span of eight doubles are none.
    BOOST_CHECK_THROW(sc::integrate(m, slow, V1(1.0), 1e15, 1e15 + 1, {.fixed_step = 0.01}),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(spans_of_1e_15_and_smaller_are_integrated) {
    const auto m = radau(3);
    for (const double span : {1e-15, 1e-30, 1e-200, 1e-300}) {
        const function_of<V1> f = [span](double, const V1& y, V1& out) { out[0] = -y[0] / span; };
        const auto r = sc::integrate(m, f, V1(1.0), 0, span, {.rtol = 1e-8, .atol = 1e-8});
        const auto nothing = sc::integrate(m, wave, V1(1.0), 0, span);
        const auto equal = sc::integrate(m, f, V1(1.0), 0, span, {.fixed_step = span / 10});
        BOOST_TEST_CONTEXT("span " << span) {
            BOOST_TEST(sc::name(r.status) == "success");
            BOOST_TEST(r.t == span);
            BOOST_TEST(r.y[0] == std::exp(-1.0), boost::test_tools::tolerance(1e-7));
            BOOST_TEST(nothing.ok());
            BOOST_TEST(nothing.y[0] == 1, boost::test_tools::tolerance(1e-14));
            BOOST_TEST(equal.ok());
            BOOST_TEST(equal.y[0] == std::exp(-1.0), boost::test_tools::tolerance(1e-7));
        }
    }
    // One unit in the last place of t: one step, or the statement that there is no room.
    const auto ulp = sc::integrate(m, wave, V1(1.0), 1.0, 1.0 + eps);
    BOOST_TEST(ulp.y[0] == 1, boost::test_tools::tolerance(1e-14));
    BOOST_TEST((ulp.ok() ? ulp.t == 1 + eps : ulp.t == 1));
}

BOOST_AUTO_TEST_CASE(spans_of_1e300_are_integrated) {
    const function_of<V1> decay = [](double, const V1& y, V1& f) { f[0] = -y[0]; };
    const auto r = sc::integrate(radau(3), decay, V1(1.0), 0, 1e300);
    BOOST_TEST(sc::name(r.status) == "success");
    BOOST_TEST(std::abs(r.y[0]) < 1e-5);
}

// The h of a step is the difference of the rounded times: what rounds is t, not the length of the way.
BOOST_AUTO_TEST_CASE(runs_from_large_t_keep_to_the_tolerance_and_to_their_clock) {
    for (const int s : {3, 7})
        for (const double t0 : {1e9, 1e11})
            for (const double tol : {1e-10, 1e-12}) {
                // At 1e11 neighbouring doubles are 1.5e-5 apart: of the fast one a step is 1/100.
                for (const double rate : {1.0, t0 < 1e10 ? 1e4 : 655.0}) {
                    const decay p{rate, [rate](double, double y) { return -rate * y; }};
                    const auto r =
                        sc::integrate(radau(s), p, V1(1.0), t0, t0 + 1, {.rtol = tol, .atol = tol});
                    BOOST_TEST_CONTEXT("s = " << s << ", t0 = " << t0 << ", tol = " << tol
                                              << ", rate = " << rate) {
                        BOOST_TEST(sc::name(r.status) == "success");
                        BOOST_TEST(std::abs(r.y[0] - std::exp(-rate)) < 10 * tol);
                    }
                }
            }
}

// Within the smallest step that t resolves the place of the jump is not known: h |jump of f| is 20 tolerances.
BOOST_AUTO_TEST_CASE(a_jump_found_to_the_resolution_of_t_is_passed) {
    for (const int s : {3, 7})
        for (const double rate : {2.5e5, 6e6})
            for (const double jump : {0.523, 0.7652008075363, 1.1}) {
                const decay p{rate, [=](double t, double y) { return -rate * (y - (t < jump ? 1 : -1)); }};
                const auto r = sc::integrate(radau(s), p, V1(2.0), 0, 1.3, {.rtol = 1e-11, .atol = 1e-11});
                BOOST_TEST(sc::name(r.status) == "success",
                           "s = " << s << ", rate " << rate << ", jump at " << jump << ", ended at " << r.t);
                BOOST_TEST(std::abs(r.y[0] + 1) < 1e-9);
            }
    // A pole is none: the run ends in front of it.
    const decay pole{0, [](double t, double) { return 1 / ((1 - t) * (1 - t)); }};
    const auto r = sc::integrate(radau(3), pole, V1(1.0), 0, 2, {.rtol = 1e-9, .atol = 1e-9});
    BOOST_TEST(!r.ok());
    BOOST_TEST(r.t < 1);
}

// The estimate of a stiff component falls as 1/z^2 across a jump, z = h lambda, once it is filtered twice; the error
// as 1/z only.
BOOST_AUTO_TEST_CASE(a_stiff_component_is_right_at_the_end_of_a_step_across_a_jump) {
    for (const int s : {3, 5, 7})
        for (const double rate : {1e4, 7e4, 1e6, 6e6})
            for (const double tol : {1e-8, 1e-10})
                for (double jump = 0.05; jump < 0.9; jump += 0.1) {
                    const decay p{rate,
                                  [=](double t, double y) { return -rate * (y - (t < jump ? 1 : -1)); }};
                    double worst = 0;
                    const auto watch = [&](double t, const V1& y) {
                        const double exact = t < jump ? 1 : 2 * std::exp(-rate * (t - jump)) - 1;
                        worst = std::max(worst, std::abs(y[0] - exact) / tol);
                    };
                    const auto r =
                        sc::integrate(radau(s), p, V1(1.0), 0, 1, {.rtol = tol, .atol = tol}, watch);
                    BOOST_TEST(r.ok());
                    BOOST_TEST(worst < 2000,
                               "s = " << s << ", rate " << rate << ", jump at " << jump << ", tol " << tol);
                }
}

// The same value of f at all nodes of a step that spans whole periods: what has been seen bounds the steps, those
// before the first jump too.
BOOST_AUTO_TEST_CASE(a_right_hand_side_that_is_switched_periodically_is_not_stepped_over) {
    const decay wave{0, [](double t, double) { return std::fmod(t, 2) < 1 ? 1.0 : -1.0; }};
    for (const int s : {3, 5, 7})
        for (const double tol : {1e-3, 1e-4, 1e-6})
            for (const double end : {11.0, 1001.0}) {
                const auto r = sc::integrate(radau(s), wave, V1(0.0), 0, end, {.rtol = tol, .atol = tol});
                BOOST_TEST(r.ok());
                BOOST_TEST(std::abs(r.y[0] - 1) < std::min(20 * end * tol, 0.5),
                           "s = " << s << ", tol " << tol << ", end " << end << ": " << r.y[0]);
            }
}
