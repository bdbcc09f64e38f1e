// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE disc_slip
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/mechanics/regularisation/regularised.hpp>
#include <stagecraft/observe/event.hpp>

#include <problems/rolling_disc/disc.hpp>

using namespace stagecraft;
using rolling_disc::disc;
using vector5 = Eigen::Matrix<double, 5, 1>;
using vector10 = Eigen::Matrix<double, 10, 1>;

namespace {

// The thesis' disc thrown onto the plane: it slides, with Coulomb's friction mu N against the slip u = G q', until the
// point of contact rests; then it rolls. Between the two the friction is that of a regularised contact,
// -mu N u / sqrt(|u|^2 + creep^2).
constexpr double mu = 0.2, creep = 1e-7;

// The plane's force on the disc: that of the height R cos(beta), m (g + height'').
double normal_force(const disc<>& body, const vector5& q, const vector5& v, const vector5& a) {
    return body.m * (body.g - body.R * (std::cos(q[3]) * v[3] * v[3] + std::sin(q[3]) * a[3]));
}

struct sliding {
    disc<> body;
    void operator()(double, const vector10& y, vector10& f) const {
        const vector5 q = y.head<5>(), v = y.tail<5>();
        const Eigen::Vector2d u = body.G<double>(q) * v;
        // a = free + N pull, N linear in a.
        const vector5 free = body.solve_mass<double>(q, body.F<double>(q, v)),
                      pull = body.solve_mass<double>(
                          q, body.G<double>(q).transpose() * (-mu / std::hypot(u.norm(), creep) * u));
        const double N = normal_force(body, q, v, free) / (1 + body.m * body.R * std::sin(q[3]) * pull[3]);
        f << v, free + N * pull;
    }
};

struct thrown {
    double time = 0;
    vector5 q, v;
};

// Until the slip has gone.
thrown until_it_rolls(const vector5& q, const vector5& v) {
    const disc<> body;
    const auto slip = [body](double, const vector10& y) {
        const vector5 at = y.head<5>(), speed = y.tail<5>();
        return (body.G<double>(at) * speed).norm() - 100 * creep;
    };
    auto rests =
        events<vector10>(event(slip, event_options{.direction = crossing::falling, .terminal = true}));
    vector10 y0;
    y0 << q, v;
    const auto r = integrate(radau_iia<3>(), sliding{}, y0, 0.0, 10.0, {.rtol = 1e-9, .atol = 1e-9}, rests);
    BOOST_TEST((r.status == status::event));
    return {r.t, r.y.head<5>(), r.y.tail<5>()};
}

double energy(const vector5& q, const vector5& v) {
    const disc<> body;
    return v.dot(body.M<double>(q) * v) / 2 + body.m * body.g * body.R * std::cos(q[3]);
}

}  // namespace

// Friction mu m g slows the disc down and turns its rim, u' = -3 mu g: it rolls after u/(3 mu g) with 2/3 of its speed.
BOOST_AUTO_TEST_CASE(an_upright_disc_thrown_without_spin_rolls_with_two_thirds_of_its_speed) {
    vector5 q = vector5::Zero(), v = vector5::Zero();
    v[0] = 3;
    const thrown end = until_it_rolls(q, v);
    BOOST_TEST(std::abs(end.time - 3 / (3 * mu * disc<>().g)) < 1e-5);
    BOOST_TEST(std::abs(end.v[0] - 2) < 1e-4);
    BOOST_TEST(std::abs(end.v[4] - 2 / disc<>().R) < 1e-3);
}

BOOST_AUTO_TEST_CASE(a_leaning_turning_disc_slides_until_it_rolls_and_then_keeps_its_energy) {
    const disc<> body;
    vector5 q = vector5::Zero(), v = vector5::Zero();
    q[3] = 0.2;
    v << 1.5, 0.3, 1, 0, 40;  // spins faster than it moves, and slides sideways as well
    const thrown end = until_it_rolls(q, v);
    BOOST_TEST(energy(end.q, end.v) < energy(q, v) - 0.1);  // friction takes energy away
    // It changes over where it is: rolling asks for a step of the size of the slip that is left.
    const auto start = assemble(body, end.q, end.v);
    BOOST_TEST((start.v - end.v).norm() < 3e3 * creep);
    const auto rolling = index_2(body);
    const auto y0 = rolling.initial_state(start.q, start.v);
    // The constraint takes over from friction, and what it asks for is less than friction may give: it does roll on.
    double most = 0;
    const auto grip = [&](double t, const auto& y) {
        const vector5 at = y.template head<5>(), speed = y.template segment<5>(5);
        const auto lambda = rolling.multiplier(y, t);
        const vector5 a =
            body.solve_mass<double>(at, body.F<double>(at, speed) - body.G<double>(at).transpose() * lambda);
        most = std::max(most, lambda.norm() / (mu * normal_force(body, at, speed, a)));
    };
    const options<double> tight{.rtol = 1e-10, .atol = 1e-10};
    const auto r = integrate(radau_iia<3>(), rolling, y0, 0.0, 0.2, tight, grip);
    BOOST_TEST(r.ok());
    BOOST_TEST(most > 0.01);
    BOOST_TEST(most < 1);
    BOOST_TEST(std::abs(energy(r.y.head<5>(), r.y.segment<5>(5)) - energy(start.q, start.v)) < 1e-8);
    // So does the contact that gives a little, up to O(eps).
    const auto distance = [&](double eps) {
        const auto soft = regularised(body, eps, 1.0, 2.0, 2.0);
        const auto s = integrate(radau_iia<3>(), soft, soft.initial_state(start.q, start.v), 0.0, 0.2, tight);
        BOOST_TEST(s.ok());
        return (s.y.head<10>() - r.y.head<10>()).norm();
    };
    const double coarse = distance(1e-5), fine = distance(1e-6);
    BOOST_TEST(coarse < 0.1);
    BOOST_TEST(coarse / fine > 9);
    BOOST_TEST(coarse / fine < 11);
}
