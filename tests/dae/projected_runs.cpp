// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE projected_runs
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/dae/projection.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/observe/observers.hpp>

#include <problems/rolling_disc/disc.hpp>

namespace sc = stagecraft;
using disc_state = Eigen::Matrix<double, 10, 1>;
using Eigen::Vector2d;

namespace {

// The rolling disc, multiplier eliminated, in numbers only.
struct reduced_disc {
    rolling_disc::disc<> body;
    void operator()(double t, const disc_state& y, disc_state& f) const { sc::index_reduced(body)(t, y, f); }
};
// 0 = G(q) v
struct rolling {
    rolling_disc::disc<> body;
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 10, 1>& y, Eigen::Matrix<S, 2, 1>& g) const {
        const Eigen::Matrix<S, 5, 1> q = y.template head<5>(), v = y.template tail<5>();
        g = body.G(q) * v;
    }
};

// Bogacki and Shampine's pair, whose last stage is the first of the next step.
sc::tableau<double> bogacki_shampine() {
    sc::tableau<double> m;
    m.A = Eigen::MatrixXd::Zero(4, 4);
    m.A(1, 0) = 1.0 / 2;
    m.A(2, 1) = 3.0 / 4;
    m.A.row(3) << 2.0 / 9, 1.0 / 3, 4.0 / 9, 0;
    m.b = m.A.row(3);
    m.c = Eigen::Vector4d(0, 1.0 / 2, 3.0 / 4, 1);
    m.b_embedded = Eigen::Vector4d(7.0 / 24, 1.0 / 4, 1.0 / 3, 1.0 / 8);
    return m;
}

const auto oscillator = [](double, const Vector2d& y, Vector2d& f) { f << y[1], -y[0]; };
const auto circle = [](const auto&, const auto& y, auto& g) {
    g[0] = (y[0] * y[0] + y[1] * y[1] - 1.0) / 2.0;
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_index_reduced_disc_slips_without_and_rolls_with_projection) {
    disc_state start;
    start << rolling_disc::initial_position(), rolling_disc::initial_velocity();
    const auto slip = [&](auto&& projection) {
        double worst = 0;
        const auto watch = [&](double, const disc_state& y) {
            Vector2d g;
            rolling{}(0.0, y, g);
            worst = std::max(worst, g.norm());
        };
        const auto r = sc::integrate(sc::radau_iia<3>(), reduced_disc{}, start, 0, 1,
                                     {.rtol = 1e-6, .atol = 1e-6}, sc::observers(projection, watch));
        BOOST_TEST(r.ok());
        return worst;
    };
    const double drifting = slip([](double, const disc_state&) {}),
                 kept = slip(sc::projection_onto<2>(rolling{}));
    BOOST_TEST(drifting > 1e-8);
    BOOST_TEST(kept < 1e-14);  // rounding of G v
    BOOST_TEST_MESSAGE("slip " << drifting << ", projected " << kept);
}

// A method that carries its last slope to the next step must not carry it over a correction: two steps with
// projection are two runs of one step, each projected.
BOOST_AUTO_TEST_CASE(the_next_step_starts_from_the_corrected_state_in_every_respect) {
    const auto steps = [](const auto& method, const Vector2d& y0, double t0, int count) {
        return sc::integrate(method, oscillator, y0, t0, t0 + 0.5 * count,
                             {.rtol = 1e-12, .atol = 1e-12, .fixed_step = 0.5},
                             sc::projection_onto<1>(circle))
            .y;
    };
    const auto check = [&](const auto& method) {
        const Vector2d once = steps(method, Vector2d(1, 0), 0, 1);
        BOOST_TEST(std::abs(once.norm() - 1) < 1e-15);
        BOOST_TEST((steps(method, Vector2d(1, 0), 0, 2) - steps(method, once, 0.5, 1)).norm() < 1e-14);
    };
    check(bogacki_shampine());
    check(sc::radau_iia<2>());
    // The carried slope would show: without the correction the second step differs by what was corrected.
    const auto plain =
        sc::integrate(bogacki_shampine(), oscillator, Vector2d(1, 0), 0, 0.5, {.fixed_step = 0.5});
    BOOST_TEST(std::abs(plain.y.norm() - 1) > 1e-4);
}

// Energy of the oscillator over 1000 periods: kept by projection, lost by the method.
BOOST_AUTO_TEST_CASE(an_invariant_is_kept_over_long_times) {
    const auto run = [](auto&& projection) {
        return sc::integrate(bogacki_shampine(), oscillator, Vector2d(1, 0), 0, 2000,
                             {.rtol = 1e-4, .atol = 1e-4}, projection);
    };
    const auto lost = run(sc::no_observer{}), kept = run(sc::projection_onto<1>(circle));
    BOOST_TEST(std::abs(lost.y.norm() - 1) > 1e-2);
    BOOST_TEST(std::abs(kept.y.norm() - 1) < 1e-15);
}
