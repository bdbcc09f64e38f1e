// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE domain
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/at.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/observe/steady_state.hpp>
#include <stagecraft/problem/with_domain.hpp>
#include <stdexcept>

#include "../message.hpp"

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

using right_hand_side = std::function<void(double, const Vector2d&, Vector2d&)>;
const auto radau = sc::radau_iia<3>();

struct least {
    double y = 1e300;
    void operator()(double, const Vector2d& state) { y = std::min(y, state.minCoeff()); }
};
// Two species, of which the second goes to zero within 0.01 at some times, to what rounding and Newton leave.
const right_hand_side fading = [](double t, const Vector2d& y, Vector2d& f) {
    f << -y[0], (200 * std::cos(20 * t) - 300) * y[1];
};
const right_hand_side falling = [](double, const Vector2d& y, Vector2d& f) { f << -1, -y[1]; };

}  // namespace

BOOST_AUTO_TEST_CASE(no_accepted_state_lies_outside) {
    least free, bounded;
    const Vector2d y0(1, 1);
    const auto without = sc::integrate(radau, fading, y0, 0, 20, {.rtol = 1e-4, .atol = 1e-4}, free);
    const auto with =
        sc::integrate(radau, sc::nonnegative(fading), y0, 0, 20, {.rtol = 1e-4, .atol = 1e-4}, bounded);
    BOOST_TEST((without.ok() && free.y < 0));  // or there is nothing to show
    BOOST_TEST((with.ok() && bounded.y >= 0));
    BOOST_TEST(std::abs(with.y[0] - std::exp(-20.0)) < 1e-4);
    BOOST_TEST(with.report.steps < 3 * without.report.steps);
    BOOST_TEST(
        (with.report.found.has(sc::capability::domain) && !without.report.found.has(sc::capability::domain)));
    // Only the components named.
    BOOST_TEST(sc::integrate(radau, sc::nonnegative(falling, {1}), y0, 0, 3).y[0] < -1);
}

BOOST_AUTO_TEST_CASE(components_within_their_atol_are_clipped_if_asked) {
    least bounded;
    const auto r = sc::integrate(radau, sc::nonnegative(fading, {.clip = true}), Vector2d(1, 1), 0, 20,
                                 {.rtol = 1e-4, .atol = 1e-4}, bounded);
    BOOST_TEST((r.ok() && bounded.y == 0 && r.report.clipped > 0));
    const auto s =
        sc::integrate(radau, sc::nonnegative(fading), Vector2d(1, 1), 0, 20, {.rtol = 1e-4, .atol = 1e-4});
    BOOST_TEST(s.report.clipped == 0);
}

BOOST_AUTO_TEST_CASE(where_the_solution_leaves_the_run_ends_inside) {
    for (const double t1 : {3.0, 1.5}) {
        const auto r = sc::integrate(radau, sc::nonnegative(falling), Vector2d(1, 1), 0, t1);
        BOOST_TEST((r.status == sc::status::outside_domain));
        BOOST_TEST((r.t <= 1 && r.t > 1 - 1e-12 && r.y[0] >= 0));
    }
    const auto box =
        sc::with_domain(falling, [](double t, const Vector2d& y) { return y[0] > 0.25 && t < 10; });
    const auto r = sc::integrate(radau, box, Vector2d(1, 1), 0, 3);
    BOOST_TEST((r.status == sc::status::outside_domain && std::abs(r.t - 0.75) < 1e-12 && r.y[0] > 0.25));
    const auto both = sc::integrate(radau, sc::nonnegative(box), Vector2d(1, 1), 0, 3);
    BOOST_TEST((both.status == sc::status::outside_domain && both.y[0] > 0.25));
    const auto fixed = sc::integrate(radau, box, Vector2d(1, 1), 0, 3, {.fixed_step = 0.1});
    BOOST_TEST((fixed.status == sc::status::outside_domain && fixed.y[0] > 0.25 && fixed.y[0] < 0.36));
}

BOOST_AUTO_TEST_CASE(starts_and_changes_outside_are_refused) {
    BOOST_TEST(message([] { sc::integrate(radau, sc::nonnegative(falling), Vector2d(-1, 1), 0, 1); }) ==
               "integrate: y0 must lie in problem.domain()");
    const auto r = sc::integrate(radau, sc::nonnegative(fading), Vector2d(1, 1), 0, 1, {},
                                 sc::at({0.5}, [](double, Vector2d& y) { y[0] = -1; }));
    BOOST_TEST((r.status == sc::status::function_threw && r.t == 0.5));
    BOOST_TEST(std::abs(r.y[0] - std::exp(-0.5)) < 1e-5);
    BOOST_TEST(message([] { sc::nonnegative(falling, {-1}); }) ==
               "nonnegative: components must not be negative");
}

BOOST_AUTO_TEST_CASE(a_run_ends_where_nothing_moves) {
    const right_hand_side rest = [](double, const Vector2d& y, Vector2d& f) {
        f << 1 - y[0], 100 * (y[0] - y[1]);
    };
    auto watch = sc::steady_state(1e-4);
    const auto r = sc::integrate(radau, rest, Vector2d(0, 0), 0, 1e6, {}, watch);
    BOOST_TEST((r.status == sc::status::steady_state && watch.reached()));
    BOOST_TEST((r.t > -std::log(1e-4) - 1e-3 && r.t < 40));
    BOOST_TEST((r.y - Vector2d(1, 1)).norm() < 2e-4);
    const auto plain = sc::integrate(radau, rest, Vector2d(0, 0), 0, r.t);
    BOOST_TEST(plain.report.f >= r.report.f);  // no call of its own
    // Nothing is at rest in a circle.
    const right_hand_side circle = [](double, const Vector2d& y, Vector2d& f) { f << y[1], -y[0]; };
    BOOST_TEST(sc::integrate(radau, circle, Vector2d(0, 1), 0, 10, {}, watch).ok());
    BOOST_TEST(!watch.reached());
    BOOST_TEST(message([] { sc::steady_state(0); }) == "steady_state: tolerance must be positive and finite");
}
