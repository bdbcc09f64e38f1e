// SPDX-License-Identifier: BSL-1.0
// Orbits followed from Hopf points and from period doublings, of one size of state that is known at run time.
#define BOOST_TEST_MODULE bvp_orbit_branches
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/bvp/orbit_branches.hpp>
#include <stagecraft/bvp/orbit_family.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace sc = stagecraft;
using Eigen::VectorXd;

namespace {

constexpr double pi = 3.14159265358979323846;

/// lure: the feedback control system x''' + p x'' + x' + x = x^2 of MatCont's tutorials: a Hopf point at p = 1, and period
/// doublings, the first at 0.6303020 with the period 6.364071 by MatCont. circle: r = 1 of period 2 pi, beside z' = z (p - z^2).
struct model {
    enum { lure, lorenz, brusselator, circle } which;
    template <class T, class Y, class P>
    void operator()(const T&, const Y& y, const P& p, Y& f) const {
        if (which == lure) {
            f[0] = y[1], f[1] = y[2], f[2] = -p[0] * y[2] - y[1] - y[0] + y[0] * y[0];
        } else if (which == lorenz) {
            f[0] = 10. * (y[1] - y[0]), f[1] = p[0] * y[0] - y[1] - y[0] * y[2];
            f[2] = y[0] * y[1] - 8. / 3 * y[2];
        } else if (which == circle) {
            const auto inside = 1. - y[0] * y[0] - y[1] * y[1];
            f[0] = y[0] * inside - y[1], f[1] = y[1] * inside + y[0], f[2] = y[2] * (p[0] - y[2] * y[2]);
        } else {
            f[0] = 1. + y[0] * y[0] * y[1] - (p[0] + 1.) * y[0], f[1] = p[0] * y[0] - y[0] * y[0] * y[1];
        }
    }
};

template <class Path>
auto only(const Path& path, sc::point_kind kind) {
    std::vector<typename Path::value_type> found;
    for (const auto& point : path)
        if (point.kind == kind) found.push_back(point);
    BOOST_TEST_REQUIRE(found.size() == 1U);
    BOOST_TEST(found[0].ok());
    return found[0];
}
auto follow(const model& f, const auto& from, double to, double step, int most = 60) {
    return sc::orbit_continuation(sc::gauss<5>(), f, from, {.to = to, .step = step, .max_points = most});
}

}  // namespace

BOOST_AUTO_TEST_CASE(from_rest_by_a_hopf_point_to_the_third_period_doubling) {
    const model f{model::lure};
    const auto hopf =
        only(sc::equilibrium_continuation(f, VectorXd(VectorXd::Zero(3)), {.from = 1.5, .to = 0.5}),
             sc::point_kind::hopf);
    BOOST_TEST(std::abs(hopf.p[0] - 1) < 1e-12);
    BOOST_TEST(std::abs(hopf.period - 2 * pi) < 1e-11);
    const auto orbits = follow(f, hopf, 0.55, 0.1);
    // The first orbit has the amplitude asked for; p falls with its square: the Hopf point is supercritical.
    const double size = std::abs(hopf.cosine.dot(orbits[0].y(0.) - hopf.y));
    BOOST_TEST(std::abs(size - 0.1) < 1e-9);
    BOOST_TEST((orbits[0].p[0] < 1 && orbits[0].p[0] > 0.99));
    // By shooting with Taylor series of degree 28 in 64 bits.
    const double p[] = {0.63030200615962, 0.57962984089559, 0.56922271960644},
                 T[] = {6.364071339441, 12.734365542206, 25.473738499512};
    const auto first = only(orbits, sc::point_kind::period_doubling);
    const auto second = only(follow(f, first, 0.56, 0.05), sc::point_kind::period_doubling);
    const auto third = only(follow(f, second, 0.565, 0.02, 20), sc::point_kind::period_doubling);
    BOOST_TEST(std::abs(first.p[0] - 0.6303020) < 5e-8);
    BOOST_TEST(std::abs(first.period - 6.364071) < 5e-7);
    int k = 0;
    for (const auto* point : {&first, &second, &third}) {
        BOOST_TEST(std::abs(point->p[0] - p[k]) < 1e-10);
        BOOST_TEST(std::abs(point->period - T[k]) < 1e-9);
        ++k;
    }
}

BOOST_AUTO_TEST_CASE(unstable_orbits_to_the_homoclinic_one) {
    // Lorenz: the orbits of the Hopf point at 470/19 are unstable and there for smaller r, down to 13.926557407.
    const model f{model::lorenz};
    const VectorXd side = VectorXd(Eigen::Vector3d(8, 8, 23));
    const auto hopf =
        only(sc::equilibrium_continuation(f, side, {.from = 24, .to = 26}), sc::point_kind::hopf);
    const auto orbits = follow(f, hopf, 10, 0.5, 100);
    BOOST_TEST((orbits[0].p[0] < 470. / 19 && orbits[0].p[0] > 24.6));
    BOOST_TEST(sc::name(orbits.back().kind) == std::string("homoclinic orbit"));
    BOOST_TEST(std::abs(orbits.back().p[0] - 13.926557407) < 2e-9);
}

BOOST_AUTO_TEST_CASE(orbits_on_the_other_side_end_at_once_and_other_points_are_refused) {
    const model f{model::brusselator};
    const auto path = sc::equilibrium_continuation(f, VectorXd(VectorXd::Ones(2)), {.from = 1, .to = 3});
    const auto hopf = only(path, sc::point_kind::hopf);
    BOOST_TEST(std::abs(hopf.p[0] - 2) < 1e-12);
    const auto orbits = follow(f, hopf, 2.5, 0.2);
    for (const auto& orbit : orbits) BOOST_TEST((orbit.ok() && orbit.p[0] > 2));
    BOOST_TEST(orbits.back().p[0] >= 2.5);
    const auto none = follow(f, hopf, 1, 0.2);
    BOOST_TEST(none.size() <= 2U);
    BOOST_TEST(none.back().message.find("this Hopf point lie at larger p, and `to` is on the other side") !=
               std::string::npos);
    BOOST_CHECK_THROW(follow(f, path.front(), 3, 0.1), std::invalid_argument);
    BOOST_CHECK_THROW(follow(f, orbits.front(), 3, 0.1), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(orbits_that_cross_at_a_branch_point) {
    // z = 0 is crossed by z^2 = p at p = 0.
    const model f{model::circle};
    const auto round = [](double s) -> VectorXd {
        return Eigen::Vector3d(std::cos(2 * pi * s), std::sin(2 * pi * s), 0);
    };
    const auto path = sc::detail::follow_orbits<double, 5, model, VectorXd>(
        sc::gauss<5>(), f, round, {2 * pi, -0.3}, {.from = -0.3, .to = 0.5}, {});
    const auto branch = only(path, sc::point_kind::branch_point);
    BOOST_TEST(std::abs(branch.p[0]) < 1e-8);
    BOOST_TEST_REQUIRE(branch.crossing_y.steps() > 0);
    const auto others = follow(f, branch, 1, 0.1);
    BOOST_TEST(others.back().p[0] >= 1);
    for (const auto& o : others) {
        BOOST_TEST(o.ok());
        BOOST_TEST(std::abs(o.y(0.3)[2] * o.y(0.3)[2] - o.p[0]) < 1e-9);
        BOOST_TEST(std::abs(o.period - 2 * pi) < 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(a_family_with_a_conserved_quantity) {
    // A pendulum: T = 4 K(sin(a/2)) with the amplitude a.
    const auto pendulum = [](const auto&, const auto& y, auto& f) {
        using std::sin;
        f[0] = y[1], f[1] = -sin(y[0]);
    };
    const auto gradient = [](const auto& y, auto& g) {
        using std::sin;
        g[0] = sin(y[0]), g[1] = y[1];
    };
    const auto small = [](double s) -> VectorXd {
        return 0.6 * Eigen::Vector2d(std::cos(2 * pi * s), -std::sin(2 * pi * s));
    };
    const auto family =
        sc::orbit_family(sc::gauss<5>(), pendulum, gradient, small, 6.43, {.to = 12, .step = 0.3});
    BOOST_TEST(family.size() > 4U);
    BOOST_TEST(family.back().period >= 12);
    for (const auto& o : family) {
        BOOST_TEST((o.ok() && o.kind == sc::point_kind::regular), o.message);
        const double energy = o.y(0.)[1] * o.y(0.)[1] / 2 + 1 - std::cos(o.y(0.)[0]),
                     k = std::sqrt(energy / 2);  // sin(a/2)
        BOOST_TEST(std::abs(o.period - 4 * std::comp_ellint_1(k)) < 1e-8);
    }
    const auto friction = [&](const auto& t, const auto& y, auto& f) {
        pendulum(t, y, f);
        f[1] -= 0.01 * y[1];
    };
    BOOST_CHECK_THROW(sc::orbit_family(sc::gauss<5>(), friction, gradient, small, 6.4, {.to = 12}),
                      std::invalid_argument);
}
