// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE bvp_orbits_and_paths
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <problems/dense_once.hpp>
#include <stagecraft/bvp/continuation.hpp>
#include <stagecraft/bvp/periodic_orbit.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/last_return.hpp>
#include <string>
#include <utility>

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

// Van der Pol's oscillator, or with mu = 0 the lecture's limit cycle.
struct oscillator {
    double mu, force = 0;
    template <class T, class Y>
    void operator()(const T& t, const Y& y, Y& f) const {
        using std::sin;
        f[0] = y[1];
        f[1] = mu * (1 - y[0] * y[0]) * y[1] - y[0];
        if (force != 0) f[1] += force * sin(t);
        if (mu == 0) {
            f[0] = y[1] + y[0] * (1 - y[0] * y[0] - y[1] * y[1]);
            f[1] = -y[0] + y[1] * (1 - y[0] * y[0] - y[1] * y[1]);
        }
    }
};

// The Oregonator.
struct oregonator {
    template <class T, class Y>
    void operator()(const T&, const Y& y, Y& f) const {
        const double s = 77.27, q = 8.375e-6, w = 0.161;
        f[0] = s * (y[1] - y[1] * y[0] + y[0] - q * y[0] * y[0]);
        f[1] = (y[2] - y[1] - y[0] * y[1]) / s;
        f[2] = w * (y[0] - y[2]);
    }
};

auto orbit_of(double mu, const Vector2d& start, double end) {
    const auto guess = sc::last_return(sc::radau_iia<3>(), oscillator{mu}, start, 0.0, end);
    return sc::periodic_orbit(sc::gauss<5>(), oscillator{mu}, guess, {.rtol = 1e-10});
}

void has(const sc::orbit_result<Vector2d>& orbit, double period, double multiplier, double accuracy) {
    BOOST_TEST(orbit.ok());
    BOOST_TEST_REQUIRE(orbit.multipliers.size() == 2U);
    BOOST_TEST(std::abs(orbit.period - period) <= 1e-10 * period);
    BOOST_TEST(std::abs(orbit.period - period) <= 30 * orbit.error.parameters[0] + 1e-13);
    BOOST_TEST(std::abs(orbit.multipliers[0].value - 1.0) < 1e-8);
    BOOST_TEST(std::abs(orbit.multipliers[1].value - multiplier) < accuracy * multiplier);
    BOOST_TEST(std::abs(orbit.multipliers[1].value - multiplier) <= 10 * orbit.multipliers[1].error);
}

auto bratu_path(const sc::continuation_options<double>& o, bool one_condition_more = false) {
    const auto bratu = [](const auto&, const auto& y, const auto& p, auto& f) {
        using std::exp;
        f[0] = y[1];
        f[1] = -p[0] * exp(y[0]);
    };
    const auto zero = [=](const auto& left, const auto& right, const auto&, auto& r) {
        r[0] = left[0];
        r[1] = right[0];
        if (one_condition_more) r[2] = left[1];
    };
    return sc::continuation(sc::gauss<5>(), sc::two_point(bratu, zero), 0.0, 1.0, Vector2d(0, 0), o);
}

}  // namespace

BOOST_AUTO_TEST_CASE(periods_and_multipliers_of_van_der_pol_and_the_limit_cycle) {
    has(orbit_of(1, Vector2d(2, 0), 40), 6.663286859323130, 8.596950636038052e-4, 1e-7);
    has(orbit_of(5, Vector2d(2, 0), 60), 11.61223066771957, 7.738555086859359e-38, 1e-7);
    const double pi = 3.14159265358979323846;
    for (const Vector2d& start : {Vector2d(1, 0), Vector2d(2, 1), Vector2d(-0.1, 0)})
        has(orbit_of(0, start, 20), 2 * pi, std::exp(-4 * pi), 1e-7);
}

// Equal intervals miss where a relaxation oscillation is fast; the steps of the run that the guess comes from do not. Periods
// of runs with events at 1e-12.
BOOST_AUTO_TEST_CASE(the_first_mesh_follows_the_steps_of_the_guess) {
    const auto check = [](const auto& f, const auto& start, double end, double period) {
        const auto guess = sc::last_return(sc::radau_iia<3>(), f, start, 0.0, end);
        for (const double tolerance : {1e-4, 1e-6}) {
            const auto orbit = sc::periodic_orbit(sc::gauss<5>(), f, guess, {.rtol = tolerance});
            BOOST_TEST(sc::name(orbit.status) == std::string("success"));
            BOOST_TEST(std::abs(orbit.period - period) < tolerance * period);
            BOOST_TEST(orbit.report.intervals < 1000);
            BOOST_TEST(orbit.report.factorisations < 40);
        }
    };
    check(oregonator{}, Eigen::Vector3d(1, 2, 3), 1000.0, 302.8580440276);
    for (const auto& [mu, period] :
         {std::pair{10.0, 19.0783695669}, {50.0, 82.5083338932}, {100.0, 162.8370710924}})
        check(oscillator{mu}, Vector2d(2, 0), 4 * mu + 20, period);
}

// t0 + (t1 - t0) may be rounded to beyond t1.
BOOST_AUTO_TEST_CASE(a_last_return_is_found_whatever_its_times_are_rounded_to) {
    for (int k = 0; k < 100; ++k) {
        const double t0 = 0.37 * k, t1 = t0 + 40 + 0.137 * k;
        const auto guess = sc::last_return(sc::radau_iia<3>(), oscillator{1}, Vector2d(2, 0), t0, t1);
        BOOST_TEST(std::abs(guess.period - 6.6632868593) < 1e-3);
    }
}

BOOST_AUTO_TEST_CASE(a_period_counted_twice_and_a_point_are_not_orbits) {
    auto guess = sc::last_return(sc::radau_iia<3>(), oscillator{1}, Vector2d(2, 0), 0.0, 40.0);
    guess.begin -= guess.period;
    guess.period *= 2;
    const auto twice = sc::periodic_orbit(sc::gauss<5>(), oscillator{1}, guess, {.rtol = 1e-8});
    BOOST_TEST(sc::name(twice.status) == std::string("multiple_period"));
    BOOST_CHECK_THROW(sc::last_return(sc::radau_iia<3>(), oscillator{1}, Vector2d(2, 0), 0.0, 1.0),
                      std::invalid_argument);
    BOOST_CHECK_EXCEPTION(sc::periodic_orbit(sc::gauss<5>(), oscillator{1, 0.1}, guess),
                          std::invalid_argument, [](const auto& e) {
                              return std::string(e.what()).find("must not depend on t") != std::string::npos;
                          });
    guess.period = 0;
    BOOST_CHECK_THROW(sc::periodic_orbit(sc::gauss<5>(), oscillator{1}, guess), std::invalid_argument);
}

// Nothing but the point 0 of a focus is periodic. That y stays where it is for no time is true of all y.
BOOST_AUTO_TEST_CASE(a_period_of_zero_is_no_family_of_orbits) {
    const auto focus = [](const auto&, const auto& y, auto& f) {
        f[0] = -0.1 * y[0] - y[1];
        f[1] = y[0] - 0.1 * y[1];
    };
    sc::orbit_guess<Vector2d> guess;
    sc::integrate(sc::radau_iia<3>(), focus, Vector2d(1, 0), 0.0, 3.0, {.rtol = 1e-8, .atol = 1e-8}, guess.y);
    guess.period = 3;
    const auto found = sc::periodic_orbit(sc::gauss<5>(), focus, guess);
    BOOST_TEST(sc::name(found.status) == std::string("equilibrium"));
    BOOST_TEST(found.message.find("gone to zero") != std::string::npos);
}

// y'' + 0.2 y' + y = 0.2 sign(y'): where f jumps on the orbit Newton's iteration has no derivative to go by. The orbit of a guess
// that closes is no point, and a period is positive. By the map of a half turn, y(0) = a and y'(0) = 0 turn into -a after T/2.
BOOST_AUTO_TEST_CASE(a_guess_that_closes_is_left_for_no_point) {
    const auto relay = [](double, const Vector2d& y, Vector2d& f) {
        f = Vector2d(y[1], -y[0] - 0.2 * y[1] + (y[1] > 0 ? 0.2 : -0.2));
    };
    const auto guess = sc::last_return(sc::radau_iia<3>(), relay, Vector2d(1, 0), 0.0, 200.0,
                                       {.rtol = 1e-10, .atol = 1e-10});
    BOOST_TEST(std::abs(guess.period - 2 * 3.14159265358979 / std::sqrt(0.99)) < 1e-6);
    for (const double rtol : {1e-4, 1e-7}) {
        const auto r = sc::periodic_orbit(sc::gauss<5>(), relay, guess, {.rtol = rtol});
        BOOST_TEST(sc::name(r.status) != std::string("equilibrium"));
        BOOST_TEST((!r.ok() || std::abs(r.period - guess.period) < 10 * rtol));
    }
}

BOOST_AUTO_TEST_CASE(a_loose_tolerance_makes_no_point_and_no_multiple_of_an_orbit) {
    const auto once = sc::last_return(sc::radau_iia<3>(), oscillator{1}, Vector2d(2, 0), 0.0, 40.0);
    auto twice = once;
    twice.begin -= once.period, twice.period *= 2;
    for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-6}) {
        const auto orbit = sc::periodic_orbit(sc::gauss<5>(), oscillator{1}, once, {.rtol = tolerance});
        BOOST_TEST(sc::name(orbit.status) == std::string("success"));
        BOOST_TEST(std::abs(orbit.period - 6.663286859323130) <= 8 * tolerance);
        const auto other = sc::periodic_orbit(sc::gauss<5>(), oscillator{1}, twice, {.rtol = tolerance});
        BOOST_TEST(sc::name(other.status) == std::string("multiple_period"));
    }
}

BOOST_AUTO_TEST_CASE(the_fold_of_bratu_lies_where_it_is_known_to) {
    int folds = 0;
    double last = 0, slope = 0;
    for (const auto& point : bratu_path({.from = 1})) {
        BOOST_TEST(sc::name(point.status) == std::string("success"));
        if (point.kind == sc::point_kind::fold) {
            ++folds;
            BOOST_TEST(std::abs(point.p[0] - 3.513830719125161) < 1e-12);
        }
        last = point.p[0];
        slope = point.y(0.0)[1];
    }
    BOOST_TEST(folds == 1);
    BOOST_TEST(last < 1);      // two solutions below the fold: the path comes back
    BOOST_TEST(slope > 10.8);  // on the upper branch, u'(0) = 10.8469 at p = 1
}

BOOST_AUTO_TEST_CASE(a_path_says_why_it_ends) {
    const auto ends = [](const sc::continuation_options<double>& o) {
        const auto path = bratu_path(o);
        for (std::size_t i = 0; i + 1 < path.size(); ++i) BOOST_TEST(path[i].message == "");
        return path.back();
    };
    const auto reached = ends({.from = 1, .to = 2}), back = ends({.from = 1, .to = 4}),
               stopped = ends({.from = 1, .to = 3, .max_points = 3}),
               first = ends({.from = 1, .max_points = 1}),
               failed = ends({.from = 5});  // beyond the fold there is no solution
    BOOST_TEST(reached.p[0] > 2);
    BOOST_TEST(reached.message == "");
    BOOST_TEST(back.p[0] < 1);
    BOOST_TEST(back.message.find("come back") != std::string::npos);
    for (const auto& point : {stopped, first}) {
        BOOST_TEST(point.p[0] < 3);
        BOOST_TEST(point.message.find("max_points") != std::string::npos);
    }
    BOOST_TEST(!failed.ok());
    BOOST_TEST(failed.message != "");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    BOOST_CHECK_EXCEPTION(bratu_path({.from = 1, .to = nan}), std::invalid_argument, [](const auto& e) {
        return std::string(e.what()).find(": to must") != std::string::npos;
    });
    // The arclength takes the place of one condition more than there are.
    BOOST_CHECK_EXCEPTION(bratu_path({.from = 1}, true), std::invalid_argument, [](const auto& e) {
        return std::string(e.what()).find("conditions") != std::string::npos;
    });
}

BOOST_AUTO_TEST_CASE(with_the_integral_phase_condition_an_orbit_is_as_near_to_its_guess_as_it_can_be) {
    const auto guess = sc::last_return(sc::radau_iia<3>(), oscillator{1}, Vector2d(2, 0), 0.0, 40.0);
    const auto orbit =
        sc::periodic_orbit(sc::gauss<5>(), oscillator{1}, guess, {.rtol = 1e-10, .integral_phase = true});
    BOOST_TEST_REQUIRE(orbit.ok());
    BOOST_TEST(std::abs(orbit.period - 6.663286859323130) < 1e-9);
    // The guess comes from a trajectory within 1e-7 of the orbit, but in phase with it; moved on by a tenth of the period it
    // pulls the orbit along.
    auto moved = guess;
    moved.begin -= 0.1 * guess.period;
    const auto later =
        sc::periodic_orbit(sc::gauss<5>(), oscillator{1}, moved, {.rtol = 1e-10, .integral_phase = true});
    BOOST_TEST_REQUIRE(later.ok());
    const auto distance = [](const auto& r, const auto& g, double shift) {
        double sum = 0;
        for (int k = 0; k < 500; ++k) {
            const double s = (k + 0.5) / 500;
            sum += (r.y(s + shift - std::floor(s + shift)) - g.y(g.begin + s * g.period)).squaredNorm();
        }
        return sum / 500;
    };
    for (const double shift : {-1e-4, 1e-4}) {
        BOOST_TEST(distance(orbit, guess, 0) < distance(orbit, guess, shift));
        BOOST_TEST(distance(later, moved, 0) < distance(later, moved, shift));
    }
    BOOST_TEST((later.y(0.1) - orbit.y(0.0)).norm() < 1e-5);
    BOOST_CHECK_THROW(sc::periodic_orbit(sc::gauss<5>(), oscillator{1}, guess,
                                         {.phase_component = 0, .integral_phase = true}),
                      std::invalid_argument);
}
