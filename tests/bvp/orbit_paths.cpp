// SPDX-License-Identifier: BSL-1.0
// Paths of periodic orbits, and multipliers that are known, in two to four dimensions.
#define BOOST_TEST_MODULE bvp_orbit_paths
#include <Eigen/LU>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <problems/dense_once.hpp>
#include <stagecraft/bvp/orbit_continuation.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/last_return.hpp>
#include <string>
#include <utility>
#include <vector>

namespace sc = stagecraft;
using Eigen::VectorXd;
using parameter = Eigen::Matrix<double, 1, 1>;

namespace {

constexpr double pi = 3.14159265358979323846;

/// planar: r' = r (p + rate r^2 - r^4), theta' = 1 + r^2, with rate = 1 where nothing else is said.
/// brusselator: 1 + x^2 y - (p + 1) x, p x - x^2 y.
/// focus: r' = r (p - r^2), theta' = 2 in coordinates turned and stretched by 10, and a component that follows with rate -3.
/// moebius: the unit circle in the plane of the first two, run through in 2 pi; seen from it, the directions with rates p and
/// `rate` turn by half a turn: multipliers 1, -e^(2 pi p), -e^(2 pi rate).
/// spiral: the unit circle again, and two components with rates p +- 0.3 i.
/// pair: two components with rates p and rate, uncoupled.
/// loop: x'' = x - x^2 - x' (H - p), H = x'^2/2 - x^2/2 + x^3/3: cycles H = p from the centre, p = -1/6, to the loop, p = 0.
/// canard: van der Pol's equation with a constant drive, x' = (y - x^3/3 + x)/rate, y' = p - x.
struct family {
    enum { planar, moebius, spiral, pair, roessler, brusselator, focus, lorenz, loop, canard } which = planar;
    double rate = 1;

    template <class T, class Y, class P>
    void operator()(const T&, const Y& y, const P& p, Y& f) const {
        using std::sqrt;
        const auto square = y[0] * y[0] + y[1] * y[1];
        if (which == planar) {
            const auto growth = p[0] + rate * square - square * square, turn = 1 + square;
            f[0] = growth * y[0] - turn * y[1];
            f[1] = growth * y[1] + turn * y[0];
        } else if (which == moebius) {
            const auto r = sqrt(square), out = r - 1, c = y[0] / r, s = y[1] / r;
            const auto mean = (p[0] + rate) / 2, difference = (p[0] - rate) / 2;
            const auto rise = (mean + difference * c) * out + (difference * s - 0.5) * y[2];
            f[0] = c * rise - y[1];
            f[1] = s * rise + y[0];
            f[2] = (difference * s + 0.5) * out + (mean - difference * c) * y[2];
        } else if (which == brusselator) {
            f[0] = 1 + y[0] * y[0] * y[1] - (p[0] + 1) * y[0];
            f[1] = p[0] * y[0] - y[0] * y[0] * y[1];
        } else if (which == focus) {
            const auto u = 0.6 * y[0] + 0.8 * y[1] - p[0], v = (0.6 * y[1] - 0.8 * y[0]) / 10,
                       growth = p[0] - u * u - v * v;
            const auto du = growth * u - 2 * v, dv = 10 * (growth * v + 2 * u);
            f[0] = 0.6 * du - 0.8 * dv;
            f[1] = 0.8 * du + 0.6 * dv;
            f[2] = y[0] - 3 * y[2];
        } else if (which == lorenz) {
            f[0] = 10. * (y[1] - y[0]), f[1] = p[0] * y[0] - y[1] - y[0] * y[2];
            f[2] = y[0] * y[1] - 8. / 3 * y[2];
        } else if (which == loop) {
            const auto H = (y[1] * y[1] - y[0] * y[0]) / 2 + y[0] * y[0] * y[0] / 3;
            f[0] = y[1], f[1] = y[0] - y[0] * y[0] - y[1] * (H - p[0]);
        } else if (which == canard) {
            f[0] = (y[1] - y[0] * y[0] * y[0] / 3 + y[0]) / rate, f[1] = p[0] - y[0];
        } else if (which == roessler) {
            f[0] = -y[1] - y[2];
            f[1] = y[0] + 0.2 * y[1];
            f[2] = 0.2 + y[2] * (y[0] - p[0]);
        } else {
            f[0] = (1 - square) * y[0] - y[1];
            f[1] = (1 - square) * y[1] + y[0];
            const double swing = which == spiral ? 0.3 : 0;
            f[2] = p[0] * y[2] - swing * y[3] + y[2] * y[3];
            f[3] = (which == spiral ? p[0] : p[0] * 0 + rate) * y[3] + swing * y[2];
        }
    }
};

struct at_parameter {
    family f;
    parameter p;
    template <class T, class Y>
    void operator()(const T& t, const Y& y, Y& out) const {
        f(t, y, p, out);
    }
};

auto guess_for(const family& f, double p, const VectorXd& start, double end) {
    return sc::last_return(sc::radau_iia<3>(), at_parameter{f, parameter(p)}, start, 0.0, end);
}

VectorXd on_the_circle(int n) {
    VectorXd y = VectorXd::Zero(n);
    y[0] = 1;
    return y;
}

template <class Path>
Path of_kind(const Path& all, sc::point_kind kind) {
    Path found;
    for (const auto& point : all)
        if (point.kind == kind) found.push_back(point);
    return found;
}

template <class Path>
void ends_in_a_hopf_point(const Path& all, double p, double period, const VectorXd& y, double accuracy) {
    for (const auto& point : all) BOOST_TEST(sc::name(point.status) == std::string("success"));
    const auto& end = all.back();
    BOOST_TEST(sc::name(end.kind) == std::string("Hopf point"));
    BOOST_TEST(end.message.find("Hopf") != std::string::npos);
    BOOST_TEST(std::abs(end.p[0] - p) <= accuracy);
    BOOST_TEST(std::abs(end.period - period) <= accuracy * period);
    for (const double t : {0.0, 0.3, 1.0}) BOOST_TEST((end.y(t) - y).norm() <= accuracy);
    BOOST_TEST(end.y.derivative(0.5).norm() == 0);
    for (const int k : {0, 1})
        BOOST_TEST(std::abs(end.multipliers[static_cast<std::size_t>(k)].value - 1.0) <= 10 * accuracy);
    BOOST_TEST(of_kind(all, sc::point_kind::hopf).size() == 1U);
}

}  // namespace

BOOST_AUTO_TEST_CASE(cycles_of_a_planar_system_fold) {
    const auto all =
        sc::orbit_continuation(sc::gauss<4>(), family{}, guess_for({}, 0.5, on_the_circle(2), 20),
                               {.from = 0.5, .to = -1, .max_points = 9});
    for (const auto& point : all) {
        BOOST_TEST(sc::name(point.status) == std::string("success"));
        const double square = point.y(0.0).squaredNorm(), p = point.p[0], T = 2 * pi / (1 + square),
                     multiplier = std::exp(T * (2 * square - 4 * square * square));
        BOOST_TEST(std::abs(p + square - square * square) < 1e-9);
        BOOST_TEST(std::abs(point.period - T) < 1e-9);
        const auto& m = point.multipliers;
        const bool first = std::abs(m[0].value - multiplier) < std::abs(m[1].value - multiplier);
        const auto &other = m[first ? 0 : 1], &one = m[first ? 1 : 0];
        BOOST_TEST(std::abs(one.value - 1.0) <= 10 * one.error);
        BOOST_TEST(std::abs(other.value - multiplier) <= 10 * other.error + 1e-9 * multiplier);
        if (point.kind != sc::point_kind::fold)
            BOOST_TEST(std::abs(other.value - multiplier) <= 1e-8 * multiplier);
    }
    BOOST_TEST(all.back().message.find("max_points") != std::string::npos);
    const auto folds = of_kind(all, sc::point_kind::fold);
    BOOST_TEST_REQUIRE(folds.size() == 1U);
    BOOST_TEST(std::abs(folds[0].p[0] + 0.25) < 1e-11);
    BOOST_TEST(of_kind(all, sc::point_kind::branch_point).empty());
}

BOOST_AUTO_TEST_CASE(a_path_of_cycles_that_shrink_ends_in_the_hopf_point) {
    // On its way p turns in a fold of cycles at -1/4 and -1; all orbits lie on r^4 - rate r^2 = p.
    for (const double rate : {1.0, 2.0}) {
        const family f{family::planar, rate};
        const auto all = sc::orbit_continuation(sc::gauss<4>(), f, guess_for(f, 0.5, on_the_circle(2), 20),
                                                {.from = 0.5, .to = -3});
        ends_in_a_hopf_point(all, 0, 2 * pi, VectorXd::Zero(2), 1e-14);
        BOOST_TEST(of_kind(all, sc::point_kind::branch_point).empty());
        const auto folds = of_kind(all, sc::point_kind::fold);
        BOOST_TEST_REQUIRE(folds.size() == 1U);
        BOOST_TEST(std::abs(folds[0].p[0] + rate * rate / 4) < 1e-11);
        BOOST_TEST(std::abs(all.back().arclength - folds[0].arclength) > 0.5);
        for (const auto& point : all) {
            const double square = point.y(0.0).squaredNorm();
            BOOST_TEST(std::abs(point.p[0] + rate * square - square * square) < 1e-9);
        }
    }
}

BOOST_AUTO_TEST_CASE(cycles_that_are_no_circles_shrink_too_whatever_the_tolerance_and_the_step) {
    const family brusselator{family::brusselator}, focus{family::focus};
    VectorXd at_focus(3);
    at_focus << 0, 0, 0;
    const auto shrinking = guess_for(brusselator, 3, on_the_circle(2), 60),
               round = guess_for(focus, 1, on_the_circle(3), 60);
    for (const auto& o : {sc::continuation_options<double>{.from = 0, .rtol = 1e-10},
                          {.from = 0, .rtol = 1e-4},
                          {.from = 0, .rtol = 1e-7, .step = 0.05, .largest_step = 0.2}}) {
        auto options = o;
        options.from = 3, options.to = 1.9;
        // x = 1, y = B: the trace of f_y is B - 2, its determinant 1.
        ends_in_a_hopf_point(sc::orbit_continuation(sc::gauss<4>(), brusselator, shrinking, options), 2,
                             2 * pi, Eigen::Vector2d(1, 2), 1e-14);
        options.from = 1, options.to = -1;
        ends_in_a_hopf_point(sc::orbit_continuation(sc::gauss<4>(), focus, round, options), 0, pi, at_focus,
                             1e-14);
    }
    // Where f takes doubles alone its derivatives are differences.
    const auto by_differences = [&](double t, const VectorXd& y, const parameter& p, VectorXd& f) {
        brusselator(t, y, p, f);
    };
    ends_in_a_hopf_point(sc::orbit_continuation(sc::gauss<4>(), by_differences, shrinking,
                                                {.from = 3, .to = 1.9, .rtol = 1e-6}),
                         2, 2 * pi, Eigen::Vector2d(1, 2), 1e-6);
}

BOOST_AUTO_TEST_CASE(a_point_begins_on_a_coarser_mesh_where_the_last_one_was_finer_than_the_tolerance_asks) {
    sc::detail::path_state<VectorXd, parameter> point;
    for (int k = 0; k <= 41; ++k) point.mesh.push_back(k / 41.0);
    // Four stages: half of the intervals have 2^7 times the error.
    for (const auto& [error, size] : {std::pair(1e-9, 42U), std::pair(1e-11, 22U), std::pair(1e-16, 12U)}) {
        point.error = error;
        const auto mesh = point.coarser(4, 1e-8, 10);
        BOOST_TEST(mesh.size() == size);
        BOOST_TEST(mesh.front() == 0);
        BOOST_TEST(mesh.back() == 1);
        BOOST_TEST(std::is_sorted(mesh.begin(), mesh.end()));
    }
}

BOOST_AUTO_TEST_CASE(a_period_doubles_where_a_multiplier_passes_minus_1) {
    const family f{family::moebius, -0.5};
    const auto all = sc::orbit_continuation(sc::gauss<4>(), f, guess_for(f, -0.3, on_the_circle(3), 20),
                                            {.from = -0.3, .to = 0.3});
    for (const auto& point : all) {
        BOOST_TEST(sc::name(point.status) == std::string("success"));
        for (const double known : {1.0, -std::exp(2 * pi * point.p[0]), -std::exp(-pi)}) {
            double nearest = 1;
            for (const auto& m : point.multipliers) nearest = std::min(nearest, std::abs(m.value - known));
            BOOST_TEST(nearest <= 1e-8 * std::abs(known));
        }
    }
    const auto doublings = of_kind(all, sc::point_kind::period_doubling);
    BOOST_TEST_REQUIRE(doublings.size() == 1U);
    BOOST_TEST(std::abs(doublings[0].p[0]) < 1e-9);
    BOOST_TEST(of_kind(all, sc::point_kind::torus).empty());
    BOOST_TEST(of_kind(all, sc::point_kind::branch_point).empty());
}

BOOST_AUTO_TEST_CASE(the_first_period_doubling_of_roessler_with_a_and_b_0_2) {
    const family f{family::roessler};
    VectorXd start(3);
    start << 1, 1, 0;
    const auto all = sc::orbit_continuation(sc::gauss<4>(), f, guess_for(f, 2.5, start, 300),
                                            {.from = 2.5, .to = 3, .rtol = 1e-9});
    const auto doublings = of_kind(all, sc::point_kind::period_doubling);
    BOOST_TEST_REQUIRE(doublings.size() == 1U);
    BOOST_TEST(std::abs(doublings[0].p[0] - 2.83244503) < 1e-7);
}

BOOST_AUTO_TEST_CASE(
    a_torus_where_a_complex_pair_passes_the_unit_circle_and_none_where_real_ones_are_inverse) {
    const family spiral{family::spiral}, pair{family::pair, 0.2};
    const auto all = sc::orbit_continuation(
        sc::gauss<4>(), spiral, guess_for(spiral, -0.3, on_the_circle(4), 20), {.from = -0.3, .to = 0.3});
    const auto tori = of_kind(all, sc::point_kind::torus);
    BOOST_TEST_REQUIRE(tori.size() == 1U);
    BOOST_TEST(std::abs(tori[0].p[0]) < 1e-9);
    const std::complex<double> known = std::polar(1.0, 0.6 * pi);
    BOOST_TEST(std::abs(std::complex<double>(tori[0].multipliers[0].value.real(),
                                             std::abs(tori[0].multipliers[0].value.imag())) -
                        known) < 1e-8);
    const auto real = sc::orbit_continuation(
        sc::gauss<4>(), pair, guess_for(pair, -0.3, on_the_circle(4), 20), {.from = -0.3, .to = -0.1});
    BOOST_TEST(sc::name(real.back().status) == std::string("success"));
    BOOST_TEST(of_kind(real, sc::point_kind::torus).empty());
}

BOOST_AUTO_TEST_CASE(a_period_that_grows_without_bound_ends_a_path_in_the_homoclinic_orbit) {
    // Lorenz' cycles have positive multipliers all along; born at r = 24.7368 they are guessed by the linearised equation near
    // there. The homoclinic orbit lies at 13.926557407520 (Kuznetsov 2004, section 6.4, gives 13.926).
    const double r = 24.5, x = std::sqrt(8. / 3 * (r - 1));
    const auto linear = [=](double, const VectorXd& y, VectorXd& f) {
        const double a = y[0] - x, b = y[1] - x, c = y[2] - r + 1;
        f.resize(3);
        f << 10 * (b - a), a - b - x * c, x * (a + b) - 8. / 3 * c;
    };
    VectorXd start(3);
    start << x + 2.5, x + 2.5, r - 1;
    const family f{family::lorenz};
    for (const double rtol : {1e-6, 1e-8, 1e-10}) {
        const auto guess = sc::last_return(sc::radau_iia<3>(), linear, start, 0.0, 3.0);
        const auto all = sc::orbit_continuation(sc::gauss<4>(), f, guess,
                                                {.from = r, .to = 10, .rtol = rtol, .max_points = 150});
        const auto& end = all.back();
        BOOST_TEST(sc::name(end.kind) == std::string("homoclinic orbit"));
        BOOST_TEST(end.ok());
        BOOST_TEST(std::abs(end.p[0] - 13.926557407520) <= 15 * rtol);
        BOOST_TEST(end.message.find("the period grows without bound at p = 13.92656") == 0U);
        for (std::size_t k = 0; k + 1 < all.size(); ++k) {
            BOOST_TEST(all[k].ok());
            BOOST_TEST(sc::name(all[k].kind) == std::string("regular"));
        }
    }
}

BOOST_AUTO_TEST_CASE(a_loop_of_the_plane_is_found_and_a_canard_is_none) {
    const family loop{family::loop}, canard{family::canard, 0.2};
    VectorXd start(2);
    start << 1.5, 0;
    const auto cycles = sc::orbit_continuation(sc::gauss<4>(), loop, guess_for(loop, -0.1, start, 400),
                                               {.from = -0.1, .to = 1, .max_points = 100});
    BOOST_TEST(sc::name(cycles.back().kind) == std::string("homoclinic orbit"));
    BOOST_TEST(std::abs(cycles.back().p[0]) <= 1e-10);
    BOOST_TEST(cycles.size() < 60U);
    const auto relaxing = sc::orbit_continuation(sc::gauss<4>(), canard, guess_for(canard, 0.9, start, 20),
                                                 {.from = 0.9, .to = 1.1, .rtol = 1e-6, .max_points = 100});
    BOOST_TEST(of_kind(relaxing, sc::point_kind::homoclinic).empty());
    BOOST_TEST(sc::name(relaxing.back().kind) == std::string("Hopf point"));
}

BOOST_AUTO_TEST_CASE(multipliers_below_what_a_double_holds_are_known_by_their_logarithms) {
    const double strong = -1577.3 / (2 * pi), weak = std::log(1e-5) / (2 * pi);  // e^-1577.3 = 1e-685
    const at_parameter f{{family::moebius, strong}, parameter(weak)};
    const auto orbit = sc::periodic_orbit(sc::gauss<4>(), f, guess_for(f.f, weak, on_the_circle(3), 20));
    BOOST_TEST(orbit.ok());
    BOOST_TEST_REQUIRE(orbit.multipliers.size() == 3U);
    const auto& least = orbit.multipliers.back();
    BOOST_TEST(std::abs(least.value) == 0);
    BOOST_TEST(least.error > 0);
    BOOST_TEST(std::abs(least.logarithm.real() + 1577.3) <= 10 * least.logarithm_error);
    BOOST_TEST(least.logarithm_error <= 1e-6);
    BOOST_TEST(std::abs(std::abs(least.logarithm.imag()) - pi) <= 1e-6);
}

BOOST_AUTO_TEST_CASE(multipliers_1e_5_and_1e_30_keep_their_relative_error) {
    const double strong = std::log(1e-30) / (2 * pi), weak = std::log(1e-5) / (2 * pi);
    const at_parameter f{{family::moebius, strong}, parameter(weak)};
    const auto orbit =
        sc::periodic_orbit(sc::gauss<4>(), f, guess_for(f.f, weak, on_the_circle(3), 20), {.rtol = 1e-10});
    BOOST_TEST(orbit.ok());
    BOOST_TEST_REQUIRE(orbit.multipliers.size() == 3U);
    const double known[] = {1, -1e-5, -1e-30};
    for (int k = 0; k < 3; ++k) {
        const auto& m = orbit.multipliers[static_cast<std::size_t>(k)];
        BOOST_TEST(std::abs(m.value - known[k]) <= 1e-7 * std::abs(known[k]));
        BOOST_TEST(std::abs(m.value - known[k]) <= 10 * m.error);
        BOOST_TEST(m.error <= 1e-6 * std::abs(known[k]));
    }
}

BOOST_AUTO_TEST_CASE(eigenvalues_of_products_complex_pairs_far_below_1_and_close_ones) {
    using Eigen::MatrixXd;
    constexpr int L = 40;
    std::vector<MatrixXd> frames, factors;
    for (int k = 0; k < L; ++k) {
        MatrixXd a(4, 4);
        for (int i = 0; i < 16; ++i) a(i / 4, i % 4) = std::sin(17.0 * k + 5 * i * i + i);
        frames.push_back(a + 2 * MatrixXd::Identity(4, 4));
    }
    for (const bool tiny : {false, true}) {
        // Eigenvalues (e^(4 i), 1e-5, 0.89e-5) or (1, 1e-5, 1e-30 e^(4 i)).
        factors.clear();
        for (int k = 0; k < L; ++k) {
            MatrixXd step = MatrixXd::Zero(4, 4);
            const int at = tiny ? 2 : 0, rest = 2 - at;
            const double size = tiny ? std::pow(1e-30, 1.0 / L) : 1;
            step(at, at) = step(at + 1, at + 1) = size * std::cos(4.0 / L);
            step(at, at + 1) = size * std::sin(4.0 / L);
            step(at + 1, at) = -step(at, at + 1);
            step(rest, rest) = std::pow(tiny ? 1.0 : 1e-5, 1.0 / L);
            step(rest + 1, rest + 1) = std::pow(tiny ? 1e-5 : 0.89e-5, 1.0 / L);
            const auto& next = frames[static_cast<std::size_t>((k + 1) % L)];
            factors.push_back(next * step * frames[static_cast<std::size_t>(k)].inverse());
        }
        std::vector<std::complex<double>> values;
        for (const auto& m : sc::detail::product_logarithms(factors))
            values.push_back(sc::detail::number_of(m));
        const auto turned = std::polar(tiny ? 1e-30 : 1.0, 4.0);
        const auto first = values[tiny ? 2 : 0];
        BOOST_TEST(std::abs(std::complex(first.real(), -std::abs(first.imag())) - turned) <
                   1e-11 * std::abs(turned));
        BOOST_TEST(std::abs(values[tiny ? 0 : 2] - (tiny ? 1.0 : 1e-5)) < 1e-11 * (tiny ? 1.0 : 1e-5));
        BOOST_TEST(std::abs(values[tiny ? 1 : 3] - (tiny ? 1e-5 : 0.89e-5)) < 1e-11 * 1e-5);
    }
}
