// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE partitioned_runs
// What long runs keep, what steps cost, and that observers, events, checkpoints and refusals are those of any run.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/lobatto_iiia.hpp>
#include <stagecraft/coefficients/lobatto_iiib.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/partitioned.hpp>

#include "../message.hpp"
#include "../stepper/interrupt.hpp"

using namespace stagecraft;
using Eigen::Vector2d, Eigen::Vector4d, Eigen::VectorXd;

namespace {

const double pi = 4 * std::atan(1.0), eccentricity = 0.6;
const Vector4d perihelion(1 - eccentricity, 0, 0, std::sqrt((1 + eccentricity) / (1 - eccentricity)));
const auto kepler = hamiltonian<2>([](const auto& p) { return p.squaredNorm() / 2; },
                                   [](const auto& q) { return -1 / q.norm(); });
// No sum of T(p) and V(q), and the same in all directions: q x p is kept.
const auto curved = hamiltonian<2>([](const auto& q, const auto& p) {
    return p.squaredNorm() / (2 * (1 + q.squaredNorm() / 4)) - 1 / q.norm() + q.dot(p) * q.dot(p) / 8;
});
const auto verlet = partitioned(lobatto_iiia<2>(), lobatto_iiib<2>());

double momentum(const Vector4d& y) { return y[0] * y[3] - y[1] * y[2]; }

// The largest errors of the energy in parts of a run.
struct energy_errors {
    double part, first = 0, last = 0, end;
    bool operator()(double t, const Vector4d& y) {
        const double error = std::abs(kepler.energy(t, y) - kepler.energy(0, perihelion));
        if (t < part) first = std::max(first, error);
        if (t > end - part) last = std::max(last, error);
        return true;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_energy_of_stoermer_verlet_stays_over_two_hundred_thousand_steps) {
    const double h = 2 * pi / 200, end = 1000 * 2 * pi;
    energy_errors seen{end / 10, 0, 0, end};
    const auto r = integrate(verlet, kepler, perihelion, 0, end, {.fixed_step = h}, seen);
    BOOST_TEST(name(r.status) == "success");
    BOOST_TEST(r.report.steps >= 200000);
    BOOST_TEST(r.report.f ==
               r.report.steps + 1);  // one force a step: that at its end is the next one's first
    BOOST_TEST(r.report.jacobians == 0);
    BOOST_TEST(seen.first < 0.02);
    BOOST_TEST(seen.last < 1.01 * seen.first);
    BOOST_TEST(std::abs(momentum(r.y) - momentum(perihelion)) < 1e-10);
}

BOOST_AUTO_TEST_CASE(stoermer_verlet_runs_back_to_its_start) {
    const double end = 100 * 2 * pi;
    const auto there = integrate(verlet, kepler, perihelion, 0, end, {.fixed_step = end / 20000});
    const auto back = integrate(verlet, kepler, there.y, end, 0, {.fixed_step = end / 20000});
    BOOST_TEST((there.y - perihelion).norm() > 1e-2);
    BOOST_TEST((back.y - perihelion).norm() < 1e-9);
}

BOOST_AUTO_TEST_CASE(implicit_pairs_keep_quadratic_invariants_to_rounding_at_any_tolerance) {
    const Vector4d y0(1, 0.1, 0.2, 0.9);
    const auto keeps = [&](const auto& m) {
        const auto r = integrate(m, curved, y0, 0, 200, {.fixed_step = 0.1});
        BOOST_TEST(name(r.status) == "success");
        BOOST_TEST(r.report.steps == 2000);
        BOOST_TEST(std::abs(momentum(r.y) - momentum(y0)) < 1e-12);
        BOOST_TEST(std::abs(curved.energy(0, r.y) - curved.energy(0, y0)) < 1e-3);
        BOOST_TEST(r.report.jacobians > 0);
    };
    keeps(partitioned(lobatto_iiia<3>(), lobatto_iiib<3>()));
    keeps(verlet);
}

BOOST_AUTO_TEST_CASE(pairs_of_one_tableau_are_that_tableau) {
    const Vector4d y0(1, 0.1, 0.2, 0.9);
    const options<> o{.rtol = 1e-13, .atol = 1e-13, .fixed_step = 0.1};
    const Vector4d as_pair = integrate(partitioned(gauss<2>(), gauss<2>()), curved, y0, 0, 2, o).y;
    BOOST_TEST((as_pair - integrate(gauss<2>(), curved, y0, 0, 2, o).y).norm() < 1e-12);
}

BOOST_AUTO_TEST_CASE(events_and_the_solution_between_steps) {
    solution<Vector4d> y;
    const double h = 2 * pi / 400;
    const auto r = integrate(verlet, kepler, perihelion, 0, 4 * pi, {.fixed_step = h}, y);
    const auto fine = integrate(verlet, kepler, perihelion, 0, 1.0, {.fixed_step = h / 64});
    BOOST_TEST((y(1.0) - fine.y).norm() < 5e-3);
    // q' of the polynomial is f at the ends.
    const auto crossing = event([](double, const Vector4d& x) { return x[1]; },
                                {.direction = crossing::falling, .terminal = true});
    const auto half =
        integrate(verlet, kepler, perihelion, 0, 4 * pi, {.fixed_step = h}, events<Vector4d>(crossing));
    BOOST_TEST(name(half.status) == "event");
    BOOST_TEST(std::abs(half.t - pi) < 2e-2);
    BOOST_TEST(std::abs(half.y[1]) < 1e-12);
    BOOST_TEST(name(r.status) == "success");
}

BOOST_AUTO_TEST_CASE(a_run_that_is_cut_goes_on_with_the_same_bits) {
    interrupted::at_five_places(verlet, kepler, perihelion, 2, {.fixed_step = 0.01});
    interrupted::at_five_places(partitioned(lobatto_iiia<3>(), lobatto_iiib<3>()), curved, perihelion, 2,
                                {.fixed_step = 0.01});
}

BOOST_AUTO_TEST_CASE(states_of_run_time_size_and_what_f_returns) {
    const auto spring = partition([](double, const VectorXd& p) -> VectorXd { return p; },
                                  [](double, const VectorXd& q) -> VectorXd { return -q; });
    const VectorXd q = VectorXd::Ones(3), p = VectorXd::Zero(3);
    const auto r = integrate(verlet, spring, stacked(q, p), 0, 2 * pi, {.fixed_step = 1e-3});
    BOOST_TEST((r.y - stacked(q, p)).norm() < 1e-5);
    const options<> o{.fixed_step = 0.1};
    const auto run = [&](const VectorXd& y0) {
        return message([&] { integrate(verlet, spring, y0, 0, 1, o); });
    };
    BOOST_TEST(run(VectorXd::Ones(5)) ==
               "integrate: y0 = (q, p) must have an even number of components, as many q as p");
    const auto short_force = partition([](double, const VectorXd& v) -> VectorXd { return v; },
                                       [](double, const VectorXd& x) -> VectorXd { return x.head(1); });
    BOOST_TEST(message([&] { integrate(verlet, short_force, VectorXd::Ones(6), 0, 1, o); }) ==
               "partition: g returns 1 numbers, and the state has 3 components of its kind");
    BOOST_TEST(message([&] { stacked(q, VectorXd::Ones(2)); }) ==
               "stacked: q has 3 components and p 2; both must have the same number");
    const auto plane = hamiltonian<2>([](const auto& x) { return x.squaredNorm(); },
                                      [](const auto& x) { return x.squaredNorm(); });
    BOOST_TEST(message([&] { integrate(verlet, plane, VectorXd::Ones(6), 0, 1, o); }) ==
               "hamiltonian<2>: the state (q, p) must have 4 components, and there are 6");
}

BOOST_AUTO_TEST_CASE(what_a_pair_cannot_do_is_said) {
    const tableau<double> two = lobatto_iiia<2>().stages() == 2
                                    ? detail::with_stages<double, dynamic>(lobatto_iiia<2>())
                                    : tableau<double>();
    BOOST_TEST(
        message([&] { partitioned(two, detail::with_stages<double, dynamic>(lobatto_iiib<3>())); }) ==
        "partitioned: the first tableau has 2 stages and the second 3; both must have the same number");
    BOOST_TEST(message([&] { partitioned(lobatto_iiia<3>(), two); }) ==
               "partitioned: both tableaux must have 3 stages, not 2");
    BOOST_TEST(message([&] { integrate(verlet, kepler, perihelion, 0, 1); }) ==
               "integrate: a pair of tableaux has no error estimate: give options.fixed_step");
    auto split_alone = verlet;
    split_alone.separable = true;
    BOOST_TEST(
        message([&] { integrate(split_alone, curved, perihelion, 0, 1, {.fixed_step = 0.1}); }) ==
        "integrate: the order of this pair holds for separable problems alone: partition(f, g) of f(t, p) "
        "and g(t, q), or hamiltonian<n>(T, V)");
}
