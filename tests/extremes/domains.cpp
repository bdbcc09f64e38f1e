// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE domains
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

// f is not finite outside its domain: what decays towards the border does not end the run and hardly costs steps, a
// solution that leaves it does, and no state that f refuses is ever accepted.

namespace sc = stagecraft;
using V = Eigen::VectorXd;

namespace {

using right_hand_side = std::function<void(double, const V&, V&)>;
using predicate = std::function<bool(const V&)>;

// NaN outside, where it is guarded.
struct guarded {
    right_hand_side inside;
    predicate holds;
    bool on = true;
    void operator()(double t, const V& y, V& f) const {
        inside(t, y, f);
        if (on && !holds(y)) f.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
};

const predicate nonnegative = [](const V& y) { return (y.array() >= 0).all(); };
const predicate positive = [](const V& y) { return (y.array() > 0).all(); };
const predicate fraction = [](const V& y) { return (y.array() >= 0).all() && (y.array() <= 1).all(); };

void costs_little(const char* what, const right_hand_side& f, const predicate& domain, const V& y0, double t1,
                  const V& exact) {
    for (const double tol : {1e-3, 1e-5, 1e-7, 1e-9}) {
        const sc::options<double> o{.rtol = tol, .atol = tol};
        const guarded with{f, domain}, without{f, domain, false};
        bool outside = false;
        const auto watch = [&](double, const V& y) { outside = outside || !domain(y); };
        const auto free = sc::integrate(sc::radau_iia<3>(), without, y0, 0, t1, o),
                   r = sc::integrate(sc::radau_iia<3>(), with, y0, 0, t1, o, watch);
        BOOST_TEST_CONTEXT(what << ", tol " << tol) {
            BOOST_TEST(free.ok());
            BOOST_TEST(name(r.status) == "success");
            BOOST_TEST((!outside && domain(r.y)));
            BOOST_TEST(r.report.steps <= 2 * free.report.steps);
            BOOST_TEST((r.y - exact).lpNorm<Eigen::Infinity>() < 30 * tol);
        }
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_decays_towards_the_border_takes_at_most_twice_the_steps) {
    const right_hand_side decay = [](double, const V& y, V& f) { f = -y; };
    costs_little("decay", decay, nonnegative, V{{1.0}}, 1000, V{{0.0}});
    costs_little("decay, open domain", decay, positive, V{{1.0}}, 100, V{{0.0}});
    costs_little(
        "A + B -> C",
        [](double, const V& y, V& f) {
            const double rate = 1e3 * y[0] * y[1];
            f << -rate, -rate, rate;
        },
        nonnegative, V{{1, 2, 0}}, 100, V{{0, 1, 1}});
    costs_little(
        "beside a wave", [](double t, const V& y, V& f) { f << -5 * y[0], std::cos(t); }, nonnegative,
        V{{1, 3}}, 50, V{{0, 3 + std::sin(50.0)}});
    costs_little(
        "saturation", [](double, const V& y, V& f) { f[0] = 3 * (1 - y[0]); }, fraction, V{{0.1}}, 100,
        V{{1.0}});
    costs_little(
        "power", [](double, const V& y, V& f) { f[0] = -1e3 * y[0] * std::sqrt(std::abs(y[0])); },
        nonnegative, V{{1.0}}, 1e4, V{{std::pow(1 + 1e7 / 2, -2)}});
}

BOOST_AUTO_TEST_CASE(a_solution_that_leaves_the_domain_ends_where_it_does) {
    for (const double tol : {1e-3, 1e-6, 1e-9}) {
        const sc::options<double> o{.rtol = tol, .atol = tol};
        const guarded falls{[](double, const V&, V& f) { f[0] = -1; }, nonnegative};
        auto r = sc::integrate(sc::radau_iia<3>(), falls, V{{1.0}}, 0, 2, o);
        BOOST_TEST(name(r.status) == "non_finite");
        BOOST_TEST(std::abs(r.t - 1) < 1e-12);
        BOOST_TEST(nonnegative(r.y));
        // y' = -|log y| from 1/2 reaches 0 at t = integral of 1/|log y| = -li(1/2)
        const guarded logs{[](double, const V& y, V& f) { f[0] = -std::abs(std::log(y[0])); }, positive};
        r = sc::integrate(sc::radau_iia<3>(), logs, V{{0.5}}, 0, 2, o);
        BOOST_TEST(name(r.status) == "non_finite");
        BOOST_TEST(std::abs(r.t - 0.378671043061088) < 10 * tol);
        BOOST_TEST(positive(r.y));
    }
}

// f is left by the last iterate only, too small to be seen by f: the run goes on beside the border.
BOOST_AUTO_TEST_CASE(an_end_that_f_refuses_is_never_told_to_an_observer) {
    const guarded decay{[](double, const V& y, V& f) { f = -y; }, nonnegative};
    double least = 1;
    const auto watch = [&](double, const V& y) { least = std::min(least, y.minCoeff()); };
    const auto r = sc::integrate(sc::radau_iia<3>(), decay, V{{1.0, 1e-300}}, 0, 3000,
                                 {.rtol = 1e-4, .atol = 1e-4}, watch);
    BOOST_TEST(r.ok());
    BOOST_TEST(least >= 0);
}
