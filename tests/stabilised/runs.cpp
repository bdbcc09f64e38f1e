// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE runs
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stagecraft/checkpoint.hpp>
#include <stagecraft/observe/save_every.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/problem/with.hpp>
#include <stagecraft/stabilised.hpp>
#include <stdexcept>
#include <string>

#include "../allocations.hpp"
#include "../message.hpp"

// Stabilised methods at work: their order, a heat equation with a known solution, the spectral radius found and given, checkpoints,
// the storage that they promise.

namespace sc = stagecraft;
using Eigen::VectorXd;

namespace {

const sc::stabilised_method<double> all[] = {sc::rkc1(), sc::rkc2(), sc::rkl1(),
                                             sc::rkl2(), sc::rkg1(), sc::rkg2()};

/// u_t = u_xx + g on n interior points, with g such that sin(pi x) cos(t) solves the discrete equations.
struct heat {
    int n;
    double fastest() const { return 4.0 * (n + 1) * (n + 1); }
    void operator()(double t, const VectorXd& u, VectorXd& f) const {
        const double d = (n + 1.0) * (n + 1.0), half = std::sin(M_PI / (2 * (n + 1.0))),
                     decay = 4 * d * half * half;
        for (int i = 0; i < n; ++i) {
            const double left = i > 0 ? u[i - 1] : 0, right = i + 1 < n ? u[i + 1] : 0;
            f[i] = d * (left - 2 * u[i] + right) + start(i) * (decay * std::cos(t) - std::sin(t));
        }
    }
    double start(int i) const { return std::sin(M_PI * (i + 1) / (n + 1.0)); }
    VectorXd at(double t) const {
        VectorXd u(n);
        for (int i = 0; i < n; ++i) u[i] = start(i) * std::cos(t);
        return u;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(equal_steps_converge_with_the_order) {
    // y = 1 / (1 - sin(t)/2).
    const auto f = [](double t, const VectorXd& y, VectorXd& out) {
        out[0] = y[0] * y[0] * std::cos(t) / 2;
        out[1] = t * y[0] - 3 * y[1];
    };
    for (const auto& m : all) {
        double before = 0;
        for (const int steps : {40, 80, 160}) {
            const auto r = sc::integrate(m, f, VectorXd{{1, 1}}, 0, 1, {.fixed_step = 1.0 / steps});
            BOOST_TEST(r.ok());
            const double error = std::abs(r.y[0] - 1 / (1 - std::sin(1.0) / 2));
            if (before > 0) BOOST_TEST(std::abs(std::log2(before / error) - m.order) < 0.07);
            before = error;
        }
    }
}

BOOST_AUTO_TEST_CASE(a_heat_equation_is_solved_to_its_tolerance_whoever_knows_the_radius) {
    const heat f{200};
    for (const auto& m : all)
        for (const double tol : {1e-2, 1e-3, 1e-4, 1e-5}) {
            const sc::options<double> o{.rtol = tol, .atol = tol};
            const auto found = sc::integrate(m, f, f.at(0), 0, 1, o);
            const auto given = sc::integrate(m, sc::with_spectral_radius(f, f.fastest()), f.at(0), 0, 1, o);
            BOOST_TEST((found.ok() && given.ok()));
            for (const auto& r : {found, given})
                BOOST_TEST((r.y - f.at(1)).cwiseAbs().maxCoeff() < (m.order == 2 ? 10 : 60) * tol);
            // The power method has found about the right number (half of the steps would need a fifth more stages).
            BOOST_TEST(found.report.f < 1.25 * given.report.f);
            BOOST_TEST(given.report.f < 1.25 * found.report.f);
            BOOST_TEST(found.report.steps < (m.order == 2 ? 60 : 300));
        }
    // Twice as fine a grid: four times the radius, twice the stages, as many steps.
    const heat fine{401};
    const sc::options<double> o{.rtol = 1e-4, .atol = 1e-4};
    const auto coarse = sc::integrate(sc::rkc2(), f, f.at(0), 0, 1, o);
    const auto finer = sc::integrate(sc::rkc2(), fine, fine.at(0), 0, 1, o);
    BOOST_TEST(std::abs(finer.report.steps - coarse.report.steps) <= 2);
    BOOST_TEST(finer.report.f < 2.2 * coarse.report.f);
}

BOOST_AUTO_TEST_CASE(between_the_steps_and_across_a_checkpoint) {
    const heat f{50};
    sc::solution<VectorXd> path;
    const sc::options<double> o{.rtol = 1e-4, .atol = 1e-4};
    const auto whole = sc::integrate(sc::rkl2(), f, f.at(0), 0, 1, o, path);
    for (const double t : {0.1, 0.37, 0.8}) BOOST_TEST((path(t) - f.at(t)).cwiseAbs().maxCoeff() < 1e-3);
    sc::checkpoint<VectorXd> last;
    sc::integrate(sc::rkl2(), f, f.at(0), 0, 1, o, sc::save_every(4, [&](auto point) {
                      if (last.y.size() == 0) last = std::move(point);
                  }));
    BOOST_TEST(last.y.size() == 50);
    const auto rest = sc::integrate(sc::rkl2(), f, last, 1);
    BOOST_TEST((rest.y - whole.y).norm() == 0);
    BOOST_TEST(rest.report.f == whole.report.f);
    BOOST_CHECK_THROW(sc::integrate(sc::rkc2(), f, last, 1), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(hundreds_of_stages_take_no_more_vectors_than_ten) {
    const auto taken = [](int stages) {
        const heat f{40};
        const VectorXd y0 = f.at(0);
        const double h = 0.3 * stages * stages / f.fastest();
        const long before = allocations;
        const auto r = sc::integrate(sc::rkc2(stages), sc::with_spectral_radius(f, f.fastest()), y0, 0,
                                     10 * h, {.fixed_step = h});
        const long after = allocations;
        BOOST_TEST(r.ok());
        BOOST_TEST(r.report.f >= 10 * stages);
        return after - before;
    };
    BOOST_TEST(taken(400) == taken(10));
}

BOOST_AUTO_TEST_CASE(bad_radii_and_problems_are_named) {
    const heat f{10};
    for (const double bad :
         {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        BOOST_TEST(message([&] {
                       sc::integrate(sc::rkc2(), sc::with_spectral_radius(f, bad), f.at(0), 0, 1);
                   }).find("spectral_radius") != std::string::npos);
    const Eigen::MatrixXd M = Eigen::MatrixXd::Identity(10, 10);
    BOOST_TEST(message([&] {
                   sc::integrate(sc::rkc2(), sc::with_mass(f, M), f.at(0), 0, 1);
               }).find("mass()") != std::string::npos);
    // A run at rest, and one whose f is not finite.
    const auto rest = [](double, const VectorXd&, VectorXd& out) { out.setZero(); };
    BOOST_TEST(sc::integrate(sc::rkc2(), rest, VectorXd{{1, 2}}, 0, 1).ok());
    const auto broken = [](double t, const VectorXd& y, VectorXd& out) { out = y * std::sqrt(0.5 - t); };
    const auto r = sc::integrate(sc::rkc2(), broken, VectorXd{{1, 2}}, 0, 1);
    BOOST_TEST(!r.ok());
    BOOST_TEST(r.t <= 0.5);
}
