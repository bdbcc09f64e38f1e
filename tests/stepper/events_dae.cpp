// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE events_dae
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/observe/event.hpp>

#include <problems/rolling_disc/measure.hpp>

namespace sc = stagecraft;
using namespace rolling_disc;

namespace {

const disc<> body;
const auto dae = sc::index_2(body);

double cos_beta(double, const state& y) { return body.singularity(Eigen::Matrix<double, 5, 1>(y.head<5>())); }
double leaning_speed(double, const state& y) { return y[8]; }

auto lean(const state& y0, double t1, double tolerance, sc::event_watch<state>& watch) {
    return sc::integrate(sc::radau_iia<3>(), dae, y0, 0, t1, {.rtol = tolerance, .atol = tolerance}, watch);
}

}  // namespace

// The disc of the thesis leans to 60 degrees, turns at about 65 and comes back.
BOOST_AUTO_TEST_CASE(the_rolling_disc_leans_and_comes_back) {
    const state y0 = dae.initial_state(initial_position(), initial_velocity(body));
    const auto watch = [] {
        return sc::events<state>(sc::event([](double t, const state& y) { return cos_beta(t, y) - 0.5; }),
                                 sc::event(leaning_speed));
    };
    auto coarse = watch(), fine = watch();
    BOOST_TEST(lean(y0, 1, 1e-8, coarse).ok());
    BOOST_TEST(lean(y0, 1, 1e-12, fine).ok());
    for (const auto* w : {&coarse, &fine}) {
        BOOST_REQUIRE(w->found().size() == 4u);  // down, lowest, up, and upright again
        const int order[] = {0, 1, 0, 1};
        for (int k = 0; k < 4; ++k) BOOST_TEST(w->found()[k].event == order[k]);
        BOOST_TEST((w->found()[0].direction == sc::crossing::falling));
        BOOST_TEST((w->found()[2].direction == sc::crossing::rising));
    }
    for (std::size_t k = 0; k < 4; ++k) {
        const auto& o = fine.found()[k];
        BOOST_TEST(std::abs(o.t - coarse.found()[k].t) < 1e-6);
        // The state at the event, multiplier included, is the one that a run to that time ends with.
        sc::event_watch<state> idle = sc::events<state>(sc::event([](double, const state&) { return 1.0; }));
        const auto there = lean(y0, o.t, 1e-12, idle);
        BOOST_TEST((there.y - o.y).head<10>().cwiseAbs().maxCoeff() < 1e-7);
        BOOST_TEST((there.y - o.y).tail<2>().cwiseAbs().maxCoeff() < 1e-4);
    }
}

// Without rolling it falls flat like a pendulum about its edge, beta'' = (4 g / 5 R) sin(beta): an event on
// the way to cos(beta) = 0, where M is singular, ends the run at the time that an elliptic integral gives.
BOOST_AUTO_TEST_CASE(a_falling_disc_is_stopped_before_it_lies_flat) {
    Eigen::Matrix<double, 5, 1> q = initial_position(), v = Eigen::Matrix<double, 5, 1>::Zero();
    auto flat = sc::events<state>(
        sc::event([](double t, const state& y) { return cos_beta(t, y) - 0.02; }, {.terminal = true}));
    const auto r = lean(dae.initial_state(q, v), 5, 1e-11, flat);
    BOOST_TEST(sc::name(r.status) == "event");
    const double k = std::cos(q[3] / 2), omega = std::sqrt(4 * body.g / (5 * body.R));
    const double angle = std::asin(std::cos(std::acos(0.02) / 2) / k);
    const double exact = (std::comp_ellint_1(k) - std::ellint_1(k, angle)) / omega;
    BOOST_TEST(r.t == exact, boost::test_tools::tolerance(1e-7));
    BOOST_TEST(cos_beta(r.t, r.y) == 0.02, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(r.y[8] == omega * std::sqrt(2 * (std::cos(q[3]) - 0.02)), boost::test_tools::tolerance(1e-7));
}
