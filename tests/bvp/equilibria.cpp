// SPDX-License-Identifier: BSL-1.0
// Paths of equilibria: folds, branch points and Hopf points that are known in closed form, and none where there is none.
#define BOOST_TEST_MODULE bvp_equilibria
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <stagecraft/bvp/equilibrium_continuation.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace sc = stagecraft;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

constexpr double pi = 3.14159265358979323846;
using points = std::vector<sc::equilibrium_point<VectorXd>>;

/// What is special on a path that ends as it should.
template <class F>
points specials_of(const F& f, const VectorXd& y, const sc::continuation_options<double>& o,
                   const std::string& end = "") {
    points found;
    const auto all = sc::equilibrium_continuation(f, y, o);
    BOOST_TEST(all.back().message == end);
    double arclength = -1;
    for (const auto& point : all) {
        BOOST_TEST(point.arclength > arclength);
        arclength = point.arclength;
        if (point.kind != sc::point_kind::regular) found.push_back(point);
    }
    return found;
}

const auto lorenz = [](const auto&, const auto& y, const auto& p, auto& f) {
    f[0] = 10. * (y[1] - y[0]), f[1] = p[0] * y[0] - y[1] - y[0] * y[2];
    f[2] = y[0] * y[1] - 8. / 3 * y[2];
};
VectorXd zero(int n) { return VectorXd::Zero(n); }

}  // namespace

BOOST_AUTO_TEST_CASE(folds_of_a_cubic) {
    const auto cubic = [](const auto&, const auto& y, const auto& p, auto& f) {
        f[0] = p[0] + y[0] - y[0] * y[0] * y[0];
    };
    const auto found = specials_of(cubic, VectorXd::Constant(1, -1.3), {.from = -1, .to = 1});
    BOOST_TEST_REQUIRE(found.size() == 2U);
    for (const int k : {0, 1}) {
        const auto& point = found[static_cast<std::size_t>(k)];
        const double side = k == 0 ? 1 : -1, fold = 2 / (3 * std::sqrt(3.));
        BOOST_TEST((point.ok() && point.kind == sc::point_kind::fold));
        BOOST_TEST(std::abs(point.p[0] - side * fold) < 1e-13);
        BOOST_TEST(std::abs(point.y[0] + side / std::sqrt(3.)) < 1e-7);
        BOOST_TEST(std::abs(point.eigenvalues[0]) < 1e-6);
    }
}

BOOST_AUTO_TEST_CASE(paths_that_cross_and_one_that_does_not) {
    const auto pitchfork = [](const auto&, const auto& y, const auto& p, auto& f) {
        f[0] = p[0] * y[0] - y[0] * y[0] * y[0], f[1] = y[0] - y[1];
    };
    const auto found = specials_of(pitchfork, zero(2), {.from = -0.7, .to = 1});
    BOOST_TEST_REQUIRE(found.size() == 1U);
    BOOST_TEST((found[0].ok() && found[0].kind == sc::point_kind::branch_point));
    BOOST_TEST(std::abs(found[0].p[0]) < 1e-9);
    const auto& side = found[0].crossing_y;
    BOOST_TEST_REQUIRE(side.size() == 2);
    BOOST_TEST(std::abs(side[0]) > 0.01);
    BOOST_TEST(std::abs(side[0] * side[0] - found[0].crossing_p[0]) < 1e-12);
    const auto transcritical = [](const auto&, const auto& y, const auto& p, auto& f) {
        f[0] = (p[0] - 0.3) * y[0] - y[0] * y[0];
    };
    const auto other = specials_of(transcritical, zero(1), {.from = -1, .to = 1});
    BOOST_TEST_REQUIRE(other.size() == 1U);
    BOOST_TEST(std::abs(other[0].p[0] - 0.3) < 1e-9);
    BOOST_TEST(std::abs(other[0].crossing_y[0] - (other[0].crossing_p[0] - 0.3)) < 1e-12);
    for (const double load : {1e-4, 1e-7}) {
        const auto imperfect = [load](const auto&, const auto& y, const auto& p, auto& f) {
            f[0] = p[0] * y[0] - y[0] * y[0] * y[0] + load;
        };
        const auto all =
            sc::equilibrium_continuation(imperfect, zero(1), {.from = -1, .to = 1, .max_points = 200});
        for (const auto& point : all) BOOST_TEST(sc::name(point.kind) == std::string("regular"));
        BOOST_TEST(all.back().y[0] > 1);
    }
}

BOOST_AUTO_TEST_CASE(hopf_points_in_closed_form) {
    // Lorenz from the rest: a pitchfork at r = 1, Hopf points at r = 470/19 on what crosses there.
    const auto rest = specials_of(lorenz, zero(3), {.from = 0.2, .to = 30});
    BOOST_TEST_REQUIRE(rest.size() == 1U);
    BOOST_TEST(std::abs(rest[0].p[0] - 1) < 1e-9);
    const auto sides = specials_of(lorenz, rest[0].crossing_y, {.from = rest[0].crossing_p[0], .to = 30});
    BOOST_TEST_REQUIRE(sides.size() == 1U);
    const auto& h = sides[0];
    BOOST_TEST((h.ok() && h.kind == sc::point_kind::hopf));
    BOOST_TEST(std::abs(h.p[0] - 470. / 19) < 1e-11);
    // omega^2 = b (sigma + r).
    BOOST_TEST(std::abs(h.period - 2 * pi / std::sqrt(8. / 3 * (10 + 470. / 19))) < 1e-11);
    BOOST_TEST(std::abs(std::abs(h.y[0]) - std::sqrt(8. / 3 * (470. / 19 - 1))) < 1e-11);
    // Brusselator with A = 2: B = 5, omega = 2; the small orbits solve the linearised equation.
    const auto brusselator = [](const auto&, const auto& y, const auto& p, auto& f) {
        f[0] = 2. + y[0] * y[0] * y[1] - (p[0] + 1.) * y[0], f[1] = p[0] * y[0] - y[0] * y[0] * y[1];
    };
    const auto b = specials_of(brusselator, Vector2d(2, 1), {.from = 2, .to = 7});
    BOOST_TEST_REQUIRE(b.size() == 1U);
    BOOST_TEST(std::abs(b[0].p[0] - 5) < 1e-12);
    BOOST_TEST(std::abs(b[0].period - pi) < 1e-12);
    Eigen::Matrix2d A;
    A << 4, 4, -5, -4;
    BOOST_TEST((A * b[0].cosine - 2 * b[0].sine).norm() < 1e-11);
    BOOST_TEST((A * b[0].sine + 2 * b[0].cosine).norm() < 1e-11);
    BOOST_TEST(std::abs(b[0].cosine.norm() - 1) < 1e-12);
    BOOST_TEST(b[0].sine.norm() <= 1 + 1e-12);
    // FitzHugh-Nagumo: where 1 - v^2 = 0.064, twice.
    const auto nerve = [](const auto&, const auto& y, const auto& p, auto& f) {
        f[0] = y[0] - y[0] * y[0] * y[0] / 3. - y[1] + p[0];
        f[1] = 0.08 * (y[0] + 0.7 - 0.8 * y[1]);
    };
    const auto n = specials_of(nerve, Vector2d(-1.2, -0.6), {.from = 0, .to = 2});
    BOOST_TEST_REQUIRE(n.size() == 2U);
    for (const int k : {0, 1}) {
        const double v = (k == 0 ? -1 : 1) * std::sqrt(0.936), p = (v + 0.7) / 0.8 - v + v * v * v / 3;
        BOOST_TEST(std::abs(n[static_cast<std::size_t>(k)].p[0] - p) < 1e-11);
    }
}

BOOST_AUTO_TEST_CASE(signs_of_rounding_are_no_hopf_points) {
    // A pendulum under a torque, without friction: +-i omega all the way, then a fold at p = 1.
    const auto pendulum = [](const auto&, const auto& y, const auto& p, auto& f) {
        using std::sin;
        f[0] = y[1], f[1] = p[0] - sin(y[0]);
    };
    const auto found =
        specials_of(pendulum, zero(2), {.from = -0.5, .to = 2}, "the path has come back to `from`");
    BOOST_TEST_REQUIRE(found.size() == 1U);
    BOOST_TEST((found[0].kind == sc::point_kind::fold));
    BOOST_TEST(std::abs(found[0].p[0] - 1) < 1e-13);
    // Real eigenvalues that pass each other's negative.
    const auto saddle = [](const auto&, const auto& y, const auto& p, auto& f) {
        f[0] = 1. * y[0], f[1] = -(1.03 + p[0]) * y[1];
    };
    BOOST_TEST(specials_of(saddle, zero(2), {.from = -0.5, .to = 1}).empty());
    // By differences the real parts are known to 1e-7, and p is not known to the tolerance.
    const auto plain = [](double, const VectorXd& y, const Eigen::Matrix<double, 1, 1>& p, VectorXd& f) {
        f[0] = 2 + y[0] * y[0] * y[1] - (p[0] + 1) * y[0], f[1] = p[0] * y[0] - y[0] * y[0] * y[1];
    };
    const auto b = specials_of(plain, Vector2d(2, 1), {.from = 2, .to = 7});
    BOOST_TEST_REQUIRE(b.size() == 1U);
    BOOST_TEST((b[0].status == sc::bvp_status::tolerance_not_met));
    BOOST_TEST(std::abs(b[0].p[0] - 5) < 1e-6);
    BOOST_TEST(specials_of(plain, Vector2d(2, 1), {.from = 2, .to = 7, .rtol = 1e-5})[0].ok());
}

BOOST_AUTO_TEST_CASE(two_pairs_in_one_step_are_both_found) {
    const auto pairs = [](const auto&, const auto& y, const auto& p, auto& f) {
        const auto one = p[0] - 0.30, two = p[0] - 0.32;
        f[0] = one * y[0] - y[1], f[1] = one * y[1] + y[0];
        f[2] = two * y[2] - 3. * y[3], f[3] = two * y[3] + 3. * y[2];
    };
    const auto found = specials_of(pairs, zero(4), {.from = 0, .to = 1});
    BOOST_TEST_REQUIRE(found.size() == 2U);
    BOOST_TEST(std::abs(found[0].p[0] - 0.30) < 1e-12);
    BOOST_TEST(std::abs(found[1].p[0] - 0.32) < 1e-12);
    BOOST_TEST(std::abs(found[1].period - 2 * pi / 3) < 1e-12);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_followed_says_so) {
    const auto none = [](const auto&, const auto& y, const auto& p, auto& f) {
        f[0] = 1. + y[0] * y[0] + p[0];
    };
    const auto all = sc::equilibrium_continuation(none, zero(1), {.from = 1, .to = 2});
    BOOST_TEST(all.size() == 1U);
    BOOST_TEST((all[0].status == sc::bvp_status::newton_failed));
    BOOST_TEST(!all[0].message.empty());
    const auto line = [](const auto&, const auto& y, const auto& p, auto& f) { f[0] = p[0] - y[0]; };
    BOOST_TEST(
        sc::equilibrium_continuation(line, zero(1), {.max_points = 3}).back().message.find("max_points") !=
        std::string::npos);
    BOOST_CHECK_THROW(sc::equilibrium_continuation(line, VectorXd::Constant(1, std::nan("")), {}),
                      std::invalid_argument);
    BOOST_CHECK_THROW(sc::equilibrium_continuation(line, zero(0), {}), std::invalid_argument);
    BOOST_CHECK_THROW(sc::equilibrium_continuation(line, zero(1), {.from = std::nan("")}),
                      std::invalid_argument);
}

// Steps may end on a special point, to the last bit: it is not lost between the two beside it.
BOOST_AUTO_TEST_CASE(a_point_of_the_path_that_is_special_itself_is_found) {
    const auto normal_form = [](const auto&, const auto& y, const auto& p, auto& f) {
        const auto square = y[0] * y[0] + y[1] * y[1];
        f[0] = p[0] * y[0] - y[1] - square * y[0], f[1] = y[0] + p[0] * y[1] - square * y[1];
    };
    for (const double step : {1.0, 0.5, 0.25, 0.3}) {
        const sc::continuation_options<double> steps{.step = step, .largest_step = step};
        auto o = steps;
        o.from = -1, o.to = 1.7;
        const auto hopf = specials_of(normal_form, zero(2), o);
        BOOST_TEST_REQUIRE(hopf.size() == 1U);
        BOOST_TEST((hopf[0].ok() && hopf[0].kind == sc::point_kind::hopf));
        BOOST_TEST(std::abs(hopf[0].p[0]) < 1e-13);
        o.from = -2, o.to = 2.7;
        const auto pitchfork = specials_of(lorenz, zero(3), o);
        BOOST_TEST_REQUIRE(pitchfork.size() == 1U);
        BOOST_TEST((pitchfork[0].ok() && pitchfork[0].kind == sc::point_kind::branch_point));
        BOOST_TEST(std::abs(pitchfork[0].p[0] - 1) < 1e-13);
    }
}
