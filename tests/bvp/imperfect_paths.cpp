// SPDX-License-Identifier: BSL-1.0
// Paths that come close to each other without crossing, as imperfections leave them of branch points.
#define BOOST_TEST_MODULE bvp_imperfect_paths
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/bvp/continuation.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <string>

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

constexpr double pi = 3.14159265358979323846;

/// A rod: u'' = -p (sin u + load), u'(0) = 0 = u(1).
struct rod {
    double load;
    template <class T, class Y, class P>
    void operator()(const T&, const Y& y, const P& p, Y& f) const {
        using std::sin;
        f[0] = y[1];
        f[1] = -p[0] * (sin(y[0]) + load);
    }
};
/// u'' = -p u - u^2 + load, u(0) = 0 = u(1).
struct quadratic {
    double load;
    template <class T, class Y, class P>
    void operator()(const T&, const Y& y, const P& p, Y& f) const {
        f[0] = y[1];
        f[1] = -p[0] * y[0] - y[0] * y[0] + load;
    }
};

struct ends {
    int left;  ///< the component that is zero there
    template <class Y, class P, class R>
    void operator()(const Y& a, const Y& b, const P&, R& r) const {
        r[0] = a[left];
        r[1] = b[0];
    }
};

auto path(const rod& f, const sc::continuation_options<double>& o) {
    return sc::continuation(sc::gauss<4>(), sc::two_point(f, ends{1}), 0.0, 1.0, Vector2d(-f.load, 0), o);
}
auto path(const quadratic& f) {
    return sc::continuation(sc::gauss<4>(), sc::two_point(f, ends{0}), 0.0, 1.0, Vector2d(0, 0),
                            {.from = 5, .to = 15});
}

template <class Path>
Path special(const Path& all) {
    Path found;
    for (const auto& point : all) {
        BOOST_TEST(sc::name(point.status) == std::string("success"));
        if (point.kind != sc::point_kind::regular) found.push_back(point);
    }
    return found;
}

/// u(1) of the rod with u(0) = a, u'(0) = 0, by the classical Runge-Kutta method.
double shot(const rod& f, double p, double a) {
    constexpr int steps = 1000;
    const Eigen::Matrix<double, 1, 1> q(p);
    Vector2d y(a, 0), k[4];
    for (int i = 0; i < steps; ++i) {
        f(0, y, q, k[0]);
        for (int j = 1; j < 4; ++j) f(0, Vector2d(y + (j < 3 ? 0.5 : 1.0) / steps * k[j - 1]), q, k[j]);
        y += (k[0] + 2 * k[1] + 2 * k[2] + k[3]) / (6 * steps);
    }
    return y[0];
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_rod_with_a_small_load_bends_to_the_side_of_the_load_and_branches_nowhere) {
    // u(0) at p = 2.46, 2.48, 3.358414156, 5 by shooting with bisection, made for this test alone.
    struct known {
        double load, u[4];
    };
    const double loads[] = {2.46, 2.48, 3.358414156, 5};
    for (const known& k : {known{1e-2, {0.450473266979, 0.497125589863, 1.54371117231, 2.20509556079}},
                           known{1e-3, {0.180189892766, 0.278268856093, 1.52119485847, 2.19211576469}},
                           known{1e-4, {0.0397128807303, 0.213285444651, 1.5188926298, 2.19080785521}},
                           known{1e-6, {0.000423155128654, 0.201872593599, 1.51863879873, 2.19066387306}}}) {
        const rod f{k.load};
        const auto points = path(f, {.from = 0.1, .to = 5});
        BOOST_TEST(special(points).empty());
        BOOST_TEST(points.back().p[0] > 5);
        double p = 0, u = 0;
        for (const auto& point : points) {
            BOOST_TEST(point.p[0] > p);
            BOOST_TEST(point.y(0.0)[0] > u);
            p = point.p[0], u = point.y(0.0)[0];
            BOOST_TEST(std::abs(shot(f, p, u)) < 1e-9);
        }
        for (int i = 0; i < 4; ++i) {
            const auto* near = &points[0];
            for (const auto& point : points)
                if (std::abs(point.p[0] - loads[i]) < std::abs(near->p[0] - loads[i])) near = &point;
            const auto at = sc::continuation(sc::gauss<4>(), sc::two_point(f, ends{1}), 0.0, 1.0, near->y,
                                             {.from = loads[i], .max_points = 1});
            BOOST_TEST_REQUIRE(at[0].ok());
            BOOST_TEST(std::abs(at[0].y(0.0)[0] - k.u[i]) < 1e-9);
        }
    }
}

BOOST_AUTO_TEST_CASE(the_other_path_of_the_rod_turns_back_in_a_fold) {
    for (const double load : {1e-2, 1e-3, 1e-6}) {
        const auto points = path({load}, {.from = 10, .to = 0.1});
        const auto folds = special(points);
        BOOST_TEST_REQUIRE(folds.size() == 1U);
        BOOST_TEST(sc::name(folds[0].kind) == std::string("fold"));
        BOOST_TEST(folds[0].p[0] > pi * pi / 4);
        BOOST_TEST(points.back().p[0] > 10);
        for (const auto& point : points) BOOST_TEST(point.y(0.0)[0] < 0);
    }
}

BOOST_AUTO_TEST_CASE(without_a_load_or_with_one_below_the_tolerance_the_rod_buckles) {
    for (const double load : {0.0, 1e-12}) {
        const auto crossings = special(path({load}, {.from = 0.1, .to = 30}));
        BOOST_TEST_REQUIRE(crossings.size() == 2U);
        for (int k = 0; k < 2; ++k) {
            const auto& at = crossings[static_cast<std::size_t>(k)];
            const double p = (2 * k + 1) * (2 * k + 1) * pi * pi / 4;
            BOOST_TEST(sc::name(at.kind) == std::string("branch point"));
            BOOST_TEST(std::abs(at.p[0] - p) < 1e-10 * p);
            BOOST_TEST(std::abs(at.y(1.0)[0]) <= 1e-10);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_crossing_at_an_angle_becomes_two_paths_or_two_folds) {
    for (const double load : {1e-2, 1e-4, 1e-7}) {
        const auto around = path(quadratic{load}), back = path(quadratic{-load});
        BOOST_TEST(special(around).empty());
        BOOST_TEST(around.back().p[0] > 15);
        for (const auto& point : around) BOOST_TEST(point.y(0.5)[0] < 0);
        const auto folds = special(back);
        BOOST_TEST_REQUIRE(folds.size() == 1U);
        BOOST_TEST(sc::name(folds[0].kind) == std::string("fold"));
        // The amplitude a of sin(pi x): (p - pi^2) a / 2 + 4 / (3 pi) a^2 = 2 load / pi, to first order in the load.
        const double gap = 8 / pi * std::sqrt(2 * load / 3);
        BOOST_TEST(std::abs(pi * pi - folds[0].p[0] - gap) < 0.1 * load);
        BOOST_TEST(back.back().p[0] < 5);
    }
}

BOOST_AUTO_TEST_CASE(a_path_that_bends_within_the_smallest_step_ends_there) {
    const auto points = path(rod{1e-7}, {.from = 0.1, .to = 5, .step = 10, .largest_step = 10});
    BOOST_TEST(sc::name(points.back().status) == std::string("tolerance_not_met"));
    BOOST_TEST(points.back().message.find("smallest step") != std::string::npos);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        BOOST_TEST(sc::name(points[i].kind) == std::string("regular"));
        BOOST_TEST(points[i].y(0.0)[0] > 0);
        BOOST_TEST(points[i].p[0] < pi * pi / 4);
    }
}
