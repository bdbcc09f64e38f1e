// SPDX-License-Identifier: BSL-1.0
// Semi-infinite intervals and connecting orbits, against closed forms and published values. All of one size of state, that is
// known at run time.
#define BOOST_TEST_MODULE bvp_semi_infinite
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <stagecraft/bvp/connecting_orbit.hpp>
#include <stagecraft/bvp/semi_infinite.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace sc = stagecraft;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class F>
void refused(const std::string& what, F&& f) {
    BOOST_CHECK_EXCEPTION(f(), std::invalid_argument, [&](const std::invalid_argument& e) {
        return std::string(e.what()).find(what) != std::string::npos;
    });
}

const auto first_is = [](double value) {
    return [value](const auto& left, const auto&, auto& r) { r[0] = left[0] - value; };
};

/// y'' = g(t, y) as a system.
template <class G>
auto second_order(G g) {
    return [g](const auto& t, const auto& y, auto& f) {
        f[0] = y[1];
        f[1] = g(t, y[0]);
    };
}

/// u(0) is given, u goes to `limit`: u and the estimate of its error are right at all tolerances, and for every first end.
template <class F, class U>
void solves(const F& f, const U& u, double limit, const VectorXd& guess) {
    const double h = 1e-6;  // conditions and guesses know u alone
    for (const double b : {infinity, 2.0, 30.0})
        for (const double rtol : {1e-4, 1e-7, 1e-10}) {
            const auto r = sc::solve_bvp(
                sc::gauss<5>(), sc::two_point(f, first_is(u(0.)), sc::to_infinity(Vector2d(limit, 0))), 0.0,
                b, guess, {.rtol = rtol});
            BOOST_TEST_CONTEXT("b = " << b << ", rtol = " << rtol << ": " << r.message) {
                BOOST_TEST_REQUIRE(r.ok());
                BOOST_TEST(r.error.global <= rtol);
                double worst = 0;
                for (int k = 0; k <= 200; ++k) {
                    const double t = std::min(r.y.t1(), r.y.t1() * k / 200);
                    worst = std::max(worst, std::abs(r.y(t)[0] - u(t)) / (1 + std::abs(u(t))));
                }
                BOOST_TEST(worst <= rtol);
                BOOST_TEST(worst <= 2 * r.error.global + 1e-13);
                BOOST_TEST(std::abs(r.y(1)[1] - (u(1 + h) - u(1 - h)) / (2 * h)) < rtol * 2 + 1e-9);
            }
        }
}

}  // namespace

BOOST_AUTO_TEST_CASE(closed_forms_on_the_half_line) {
    using std::cosh;
    using std::exp;
    using std::tanh;
    // A kink, a pulse from beside its top, an exponential that decays more slowly than the linearisation, and one with a
    // coefficient that depends on t.
    solves(
        second_order([](const auto&, const auto& u) { return 2. * u * u * u - 2. * u; }),
        [](double t) { return tanh(t + 0.3); }, 1, Vector2d(1, 0));
    solves(
        second_order([](const auto&, const auto& u) { return 4. * u - 6. * u * u; }),
        [](double t) { return 1 / (cosh(t + 0.6) * cosh(t + 0.6)); }, 0, Vector2d(0, 0));
    solves(
        second_order([](const auto& t, const auto& u) {
            using std::exp;
            return 4. * u - 3. * exp(-t);
        }),
        [](double t) { return exp(-t); }, 0, Vector2d(0, 0));
    solves(
        second_order([](const auto& t, const auto& u) { return (1. + 2. / ((t + 1.) * (t + 1.))) * u; }),
        [](double t) { return exp(-t) * (1 + 1 / (t + 1)); }, 0, Vector2d(0, 0));
}

BOOST_AUTO_TEST_CASE(boundary_layers_of_falkner_and_skan) {
    // f''' + c f f'' + beta (1 - f'^2) = 0; f is t - p in the end with an unknown p. The guess is that of MATLAB's
    // documentation, constant. f''(0): 0.332057336215196 (Blasius), 0.469599988361, 0.927680039836653, 1.232587656820.
    struct layer {
        double c, beta, wall;
    };
    for (const layer& l : {layer{0.5, 0, 0.332057336215196}, layer{1, 0, 0.469599988361},
                           layer{1, 0.5, 0.927680039836653}, layer{1, 1, 1.232587656820}}) {
        const auto f = [&l](const auto&, const auto& y, const auto&, auto& d) {
            d[0] = y[1], d[1] = y[2];
            d[2] = -l.c * y[0] * y[2] - l.beta * (1. - y[1] * y[1]);
        };
        const auto wall = [](const auto& y, const auto&, const auto&, auto& r) { r[0] = y[0], r[1] = y[1]; };
        const auto stream = [](double t, const auto& p, auto& y) { y[0] = t - p[0], y[1] = 1, y[2] = 0; };
        for (const double rtol : {1e-5, 1e-10}) {
            const auto r = sc::solve_bvp(sc::gauss<5>(), sc::two_point(f, wall, sc::to_infinity(stream)), 0.0,
                                         infinity, VectorXd(Eigen::Vector3d(0, 0, 1)),
                                         VectorXd(VectorXd::Ones(1)), {.rtol = rtol});
            BOOST_TEST_REQUIRE(r.ok(), r.message);
            BOOST_TEST(std::abs(r.y(0)[2] - l.wall) <= rtol * (1 + l.wall));
            // The displacement of Blasius, 1.7207876573 (Schlichting).
            if (l.beta == 0 && l.c == 0.5) BOOST_TEST(std::abs(r.p[0] - 1.7207876573) <= 3 * rtol);
        }
    }
}

BOOST_AUTO_TEST_CASE(limits_that_are_known_up_to_a_parameter) {
    // The rotating disc (Rogers-Lance 1960): F'(0) = 0.51023, G'(0) = -0.61592, H goes to -0.88447.
    const auto disc = [](const auto&, const auto& y, const auto&, auto& f) {
        f[0] = y[1], f[1] = y[0] * y[0] - y[2] * y[2] + y[1] * y[4];
        f[2] = y[3], f[3] = 2. * y[0] * y[2] + y[3] * y[4];
        f[4] = -2. * y[0];
    };
    const auto surface = [](const auto& y, const auto&, const auto&, auto& r) {
        r[0] = y[0], r[1] = y[2] - 1, r[2] = y[4];
    };
    const auto inflow = [](double, const auto& p, auto& y) {
        for (int k = 0; k < 4; ++k) y[k] = 0;
        y[4] = -p[0];
    };
    const auto guess = [](double t) -> VectorXd {
        VectorXd y(5);
        y << 0, 0, std::exp(-t), -std::exp(-t), -1;
        return y;
    };
    const auto r = sc::solve_bvp(sc::gauss<5>(), sc::two_point(disc, surface, sc::to_infinity(inflow)), 0.0,
                                 infinity, guess, VectorXd(VectorXd::Ones(1)), {.rtol = 1e-9});
    BOOST_TEST_REQUIRE(r.ok(), r.message);
    BOOST_TEST(std::abs(r.y(0)[1] - 0.51023) < 5e-6);
    BOOST_TEST(std::abs(r.y(0)[3] + 0.61592) < 5e-6);
    BOOST_TEST(std::abs(r.p[0] - 0.88447) < 5e-6);
    // -u'' - 2 u/cosh^2 t = E u, even, u(0) = 1: E = -1, u = 1/cosh t. The decay depends on E.
    const auto well = [](const auto& t, const auto& y, const auto& p, auto& f) {
        using std::cosh;
        f[0] = y[1], f[1] = (-p[0] - 2. / (cosh(t) * cosh(t))) * y[0];
    };
    const auto even = [](const auto& y, const auto&, const auto&, auto& r) { r[0] = y[0] - 1, r[1] = y[1]; };
    const auto falling = [](double t) -> VectorXd { return Vector2d(std::exp(-t), 0); };
    const auto e =
        sc::solve_bvp(sc::gauss<5>(), sc::two_point(well, even, sc::to_infinity(VectorXd(VectorXd::Zero(2)))),
                      0.0, infinity, falling, VectorXd(VectorXd::Constant(1, -0.5)), {.rtol = 1e-10});
    BOOST_TEST_REQUIRE(e.ok(), e.message);
    BOOST_TEST(std::abs(e.p[0] + 1) < 2e-10);
    BOOST_TEST(std::abs(e.y(2)[0] - 1 / std::cosh(2.)) < 2e-10);
}

BOOST_AUTO_TEST_CASE(conditions_inside_and_on_integrals_beside_it) {
    const auto f = second_order([](const auto&, const auto& u) { return 1. * u; });
    const auto none = [](const auto&, const auto&, auto&) {};
    const VectorXd zero = VectorXd::Zero(2);
    const auto inside = sc::interior(2, [](const auto& y) { return y[0] - 1; });
    const auto r = sc::solve_bvp(sc::gauss<5>(), sc::two_point(f, none, inside, sc::to_infinity(zero)), 0.0,
                                 infinity, zero, {.rtol = 1e-9});
    BOOST_TEST_REQUIRE(r.ok(), r.message);
    BOOST_TEST(std::abs(r.y(0)[0] - std::exp(2.)) < 1e-8);
    const auto area = sc::integral([](const auto&, const auto& y) { return y[0]; }, 1);
    const auto q = sc::solve_bvp(sc::gauss<5>(), sc::two_point(f, none, area, sc::to_infinity(zero)), 0.0,
                                 infinity, zero, {.rtol = 1e-9});
    BOOST_TEST_REQUIRE(q.ok(), q.message);
    BOOST_TEST(std::abs(q.y(0)[0] - 1) < 2e-9);
}

BOOST_AUTO_TEST_CASE(waves_that_die_away_more_slowly_than_the_modes_beside_a_condition_inside) {
    // y_0' = -k (y_0 - s) + s', y_1' = 2 k (y_1 - s) + s', s = exp(-m t) cos w t, which passes zero again and again: what is
    // cut off falls like s, not like the modes, and not like |y| at an end where s is small.
    using std::cos;
    using std::exp;
    using std::sin;
    double m = 0, w = 0, k = 0;
    const auto f = [&](const auto& t, const auto& y, auto& d) {
        const auto s = exp(-m * t) * cos(w * t), slope = -m * s - w * exp(-m * t) * sin(w * t);
        d[0] = -k * (y[0] - s) + slope, d[1] = 2. * k * (y[1] - s) + slope;
    };
    const auto wave = [&](double t) { return exp(-m * t) * cos(w * t); };
    const auto inside = sc::interior(0.1, [&](const auto& y) { return y[0] - wave(0.1); });
    const auto none = [](const auto&, const auto&, auto&) {};
    const VectorXd zero = VectorXd::Zero(2);
    const double waves[][3] = {{0.4, 2, 1},  {0.1, 2, 1},  {0.03, 2, 0.5}, {0.1, 0.3, 1},
                               {0.03, 0, 1}, {0.01, 0, 1}, {0.3, 0, 10},   {0.1, 0.3, 10}};
    for (const auto& of : waves)
        for (const double rtol : {1e-4, 1e-7, 1e-10}) {
            m = of[0], w = of[1], k = of[2];
            const auto r =
                sc::solve_bvp(sc::gauss<5>(), sc::two_point(f, none, inside, sc::to_infinity(zero)), 0.0,
                              infinity, zero, {.rtol = rtol});
            BOOST_TEST_CONTEXT("m = " << m << ", w = " << w << ", k = " << k << ", rtol = " << rtol) {
                BOOST_TEST_REQUIRE(r.ok(), r.message);
                double worst = 0;
                for (int i = 0; i <= 400; ++i) {
                    const double t = std::min(r.y.t1(), r.y.t1() * i / 400);
                    worst = std::max(worst, (r.y(t) - VectorXd::Constant(2, wave(t))).cwiseAbs().maxCoeff());
                }
                BOOST_TEST(worst <= 4 * rtol);
                BOOST_TEST(worst <= 10 * r.error.global);
            }
        }
}

BOOST_AUTO_TEST_CASE(
    what_is_seen_of_a_limit_near_a_zero_of_a_wave_and_shorter_intervals_hold_what_is_inside) {
    // y' = -2 (y - s) + s', s = exp(-t/10) cos w t: near a zero of y' at the limit its next values fall like a power of t.
    double w = 0;
    const auto f = [&](const auto& t, const auto& y, auto& d) {
        using std::cos;
        using std::exp;
        using std::sin;
        d[0] = -2. * y[0] + exp(-0.1 * t) * (1.9 * cos(w * t) - w * sin(w * t));
    };
    const auto wave = [&](double t) { return std::exp(-0.1 * t) * std::cos(w * t); };
    const auto none = [](const auto&, const auto&, auto&) {};
    const VectorXd zero = VectorXd::Zero(1);
    const auto solve = [&](double t, auto condition) {
        return sc::solve_bvp(sc::gauss<5>(),
                             sc::two_point(f, none, sc::interior(t, condition), sc::to_infinity(zero)), 0.0,
                             infinity, zero, {.rtol = 1e-4});
    };
    for (const double turns : {0.23, 0.44, 0.9, 1.11}) {
        w = turns;
        const auto r = solve(0.1, [&](const auto& y) { return y[0] - wave(0.1); });
        BOOST_TEST_REQUIRE(r.ok(), r.message);
        for (const double t : {0.0, 1.0, 4.0}) BOOST_TEST(std::abs(r.y(t)[0] - wave(t)) < 4e-4);
    }
    // Nothing satisfies this condition. Shorter intervals are tried as long as they hold its time.
    BOOST_TEST(sc::name(solve(2, [](const auto& y) { return 1. + y[0] * y[0]; }).status) ==
               std::string("newton_failed"));
}

BOOST_AUTO_TEST_CASE(what_is_no_limit_is_refused) {
    const auto solve = [](const auto& f, const VectorXd& limit, int conditions = 1, double b = infinity) {
        const auto some = [conditions](const auto& left, const auto&, auto& r) {
            for (int k = 0; k < conditions; ++k) r[k] = left[0] - 1;
        };
        const VectorXd guess = VectorXd::Zero(limit.size());
        return sc::solve_bvp(sc::gauss<5>(), sc::two_point(f, some, sc::to_infinity(limit)), 1.0, b, guess);
    };
    const auto saddle = second_order([](const auto&, const auto& u) { return 1. * u; });
    const VectorXd zero = VectorXd::Zero(2), one = VectorXd::Zero(1);
    for (const double b : {infinity, 3.0}) {
        refused("to_infinity(limit): limit must be a solution", [&] { solve(saddle, Vector2d(1, 0), 1, b); });
        refused("must write 1 number(s) with to_infinity(limit)", [&] { solve(saddle, zero, 2, b); });
        refused("must write 1 number(s) with to_infinity(limit)", [&] { solve(saddle, zero, 0, b); });
        refused("to_infinity(limit): at limit f_y has eigenvalues on the imaginary axis",
                [&] { solve(second_order([](const auto&, const auto& u) { return -u; }), zero, 1, b); });
        // 1/t, 1/t^2, and by a linear equation.
        const char* none = "to_infinity(limit): at limit f_y has no eigenvalue with a negative real part";
        refused(none, [&] { solve([](auto&, auto& y, auto& f) { f[0] = -y[0] * y[0]; }, one, 1, b); });
        refused(none, [&] { solve(second_order([](auto&, auto& u) { return 6. * u * u; }), zero, 1, b); });
        refused("to_infinity(limit): near limit solutions decay no faster than a power of t",
                [&] { solve([](auto& t, auto& y, auto& f) { f[0] = -y[0] / t; }, one, 1, b); });
        refused("to_infinity(limit): f(t, limit) - limit' falls like a power of t",
                [&] { solve([](auto& t, auto& y, auto& f) { f[0] = -y[0] + 1. / (t * t); }, one, 1, b); });
    }
    refused("a and b", [&] { solve(saddle, zero, 1, std::nan("")); });
    refused("a must be below b", [&] { solve(saddle, zero, 1, 0.5); });
    refused("limit must be finite", [&] { solve(saddle, Vector2d(std::nan(""), 0)); });
    // What a limit of few digits is off by would stay in y.
    const auto to = [&](double limit, double rtol) {
        return sc::solve_bvp(sc::gauss<5>(),
                             sc::two_point(saddle, first_is(1.), sc::to_infinity(Vector2d(limit, 0))), 0.,
                             infinity, VectorXd(Vector2d(1, -1)), {.rtol = rtol});
    };
    refused("to_infinity(limit): limit must be a solution", [&] { to(1e-7, 1e-10); });
    BOOST_TEST(sc::name(to(1e-8, 1e-6).status) == std::string("success"));
}

namespace {

/// nagumo: u'' + p u' + u (1 - u) (u - a) = 0 (p = 0.5 where none is given), fronts u(x - p t) of u_t = u_xx + u (1 - u) (u - a); fisher: the same with
/// u (1 - u), a = 0 as p is given. energy: x'' = x - x^2 + (p - 0.3) x' + 2 x' H, where H, the energy, is zero on
/// x = 1.5 / cosh^2(t/2), so that p = 0.3. fold: no equilibrium.
struct connected {
    enum { nagumo, fisher, energy, lorenz, fold } which;
    double a = 0;
    template <class T, class Y, class P>
    void operator()(const T&, const Y& y, const P& p, Y& f) const {
        f[0] = y[1];
        if (which == nagumo) {
            auto speed = 0.5 + 0. * y[0];
            if (p.size() > 0) speed = p[0] + 0. * y[0];
            f[1] = -speed * y[1] - y[0] * (1. - y[0]) * (y[0] - a);
        } else if (which == fisher) {
            f[1] = -a * y[1] - y[0] * (1. - y[0]);
        } else if (which == energy) {
            const auto H = y[1] * y[1] / 2. - y[0] * y[0] / 2. + y[0] * y[0] * y[0] / 3.;
            f[1] = y[0] - y[0] * y[0] + (p[0] - 0.3) * y[1] + 2. * y[1] * H;
        } else if (which == lorenz) {
            f[0] = 10. * (y[1] - y[0]), f[1] = p[0] * y[0] - y[1] - y[0] * y[2];
            f[2] = y[0] * y[1] - 8. / 3 * y[2];
        } else {
            f[1] = 1. + p[0] + y[0] * y[0];
        }
    }
};
using guess_function = std::function<VectorXd(double)>;
VectorXd numbers(std::vector<double> v) {
    return Eigen::Map<VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
}
auto connect(const connected& f, const VectorXd& from, const VectorXd& to, const guess_function& guess,
             std::vector<double> p, double rtol = 1e-8) {
    return sc::connecting_orbit(sc::gauss<5>(), f, from, to, guess, numbers(std::move(p)), {.rtol = rtol});
}
/// A front that goes down with twice the slope of Nagumo's, or so.
VectorXd front(double t) {
    const double u = 1 / (1 + std::exp(1.4 * t));
    return Vector2d(u, -1.4 * u * (1 - u));
}
const VectorXd rest = VectorXd::Zero(2), excited = Vector2d(1, 0);

/// The largest error of y_0 and y_1 beside the closed form u and its derivative at times 400.
template <class Result, class U>
double largest_error(const Result& r, const U& u) {
    double worst = 0;
    for (int k = 0; k <= 400; ++k) {
        const double t = std::min(r.y.t1(), r.y.t0() + (r.y.t1() - r.y.t0()) * k / 400);
        worst = std::max(worst, std::abs(r.y(t)[0] - u(t)) / (1 + std::abs(u(t))));
    }
    return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(fronts_and_pulses_in_closed_form) {
    // u = 1/(1 + exp(x / sqrt 2)), p = (1 - 2a)/sqrt 2; the phase is that of the guess.
    for (const double a : {0.1, 0.3, 0.7})
        for (const double rtol : {1e-4, 1e-8, 1e-11}) {
            const auto r =
                connect({connected::nagumo, a}, Vector2d(0.98, 0.01), Vector2d(0.02, 0), front, {0.3}, rtol);
            BOOST_TEST_CONTEXT("a = " << a << ", rtol = " << rtol << ": " << r.message) {
                BOOST_TEST_REQUIRE(r.ok());
                const double off = std::abs(r.p[0] - (1 - 2 * a) / std::sqrt(2.)), u = r.y(0.)[0],
                             begin = -std::sqrt(2.) * std::log(1 / u - 1);
                const double worst = largest_error(
                    r, [&](double t) { return 1 / (1 + std::exp((t - begin) / std::sqrt(2.))); });
                BOOST_TEST_MESSAGE("nagumo " << a << ' ' << rtol << ": p " << off << " ("
                                             << r.error.parameters[0] << "), y " << worst << " ("
                                             << r.error.global << "), f " << r.report.f << ", " << r.y.t0()
                                             << " to " << r.y.t1());
                BOOST_TEST(off <= rtol);
                BOOST_TEST(worst <= rtol);
                BOOST_TEST(worst <= 10 * r.error.global + 1e-13);
                BOOST_TEST((r.from - excited).norm() < 1e-12);
                BOOST_TEST(r.to.norm() < 1e-12);
            }
        }
    const auto pulse = [](double t) -> VectorXd {
        const double c = 1 / std::cosh(0.4 * t);
        return Vector2d(1.2 * c * c, -0.96 * c * c * std::tanh(0.4 * t));
    };
    for (const double rtol : {1e-4, 1e-7, 1e-10}) {
        const auto r = connect({connected::energy}, rest, rest, pulse, {0.2}, rtol);
        BOOST_TEST_CONTEXT("rtol = " << rtol << ": " << r.message) {
            BOOST_TEST_REQUIRE(r.ok());
            // At its top x = 1.5, y = 0.
            double low = r.y.t0(), high = r.y.t1();
            for (int k = 0; k < 60; ++k) (r.y((low + high) / 2)[1] > 0 ? low : high) = (low + high) / 2;
            const double worst = largest_error(r, [&](double t) {
                const double c = std::cosh((t - low) / 2);
                return 1.5 / (c * c);
            });
            BOOST_TEST_MESSAGE("pulse " << rtol << ": p " << std::abs(r.p[0] - 0.3) << " ("
                                        << r.error.parameters[0] << "), y " << worst << " (" << r.error.global
                                        << "), f " << r.report.f);
            BOOST_TEST(std::abs(r.p[0] - 0.3) <= rtol);
            BOOST_TEST(worst <= rtol);
            BOOST_TEST(worst <= 10 * r.error.global + 1e-13);
        }
    }
    // Fisher's equation: fronts into a node are there for every speed.
    const auto r = connect({connected::fisher, 2.5}, excited, rest, front, {});
    BOOST_TEST_REQUIRE(r.ok(), r.message);
    BOOST_TEST(r.p.size() == 0);
}

BOOST_AUTO_TEST_CASE(the_homoclinic_orbit_of_lorenz) {
    // At r = 13.926557407 (Sparrow has 13.926...). The guess: the orbit that leaves the origin at r = 13.926, until it is near it
    // again, by a Runge-Kutta method of order four.
    const connected f{connected::lorenz};
    const VectorXd r = numbers({13.926});
    const double grows = (-11 + std::sqrt(121 + 40 * 12.92)) / 2, h = 1e-3;
    VectorXd y = numbers({10, 10 + grows, 0}) / 1000, k[4];
    std::vector<VectorXd> table{y};
    double away = 0;
    while (away < 10 || table.back().norm() > 0.6) {
        for (int s = 0; s < 4; ++s) {
            VectorXd at = s == 0 ? y : VectorXd(y + (s < 3 ? h / 2 : h) * k[s - 1]);
            k[s] = at, f(0., at, r, k[s]);
        }
        y += h / 6 * (k[0] + 2 * k[1] + 2 * k[2] + k[3]);
        table.push_back(y), away = std::max(away, y.norm());
        BOOST_TEST_REQUIRE(table.size() < 10000U);
    }
    const guess_function guess = [&](double t) -> VectorXd {
        const double end = h * static_cast<double>(table.size() - 1);
        if (t <= -1) return std::exp(grows * (t + 1)) * table[0];
        if (t + 1 >= end) return std::exp(-8. / 3 * (t + 1 - end)) * table.back();
        return table[static_cast<std::size_t>((t + 1) / h)];
    };
    const auto orbit = connect(f, VectorXd::Zero(3), VectorXd::Zero(3), guess, {13.92}, 1e-10);
    BOOST_TEST_REQUIRE(orbit.ok(), orbit.message);
    BOOST_TEST_MESSAGE("lorenz off " << orbit.p[0] - 13.926557407 << ", f " << orbit.report.f);
    BOOST_TEST(std::abs(orbit.p[0] - 13.926557407) < 1e-8);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_connected_says_why) {
    const connected f{connected::nagumo, 0.3};
    refused(
        "connecting_orbit: 1 direction(s) come to `from`, 1 leave `to`: an orbit between them has 3 "
        "conditions, with its phase, for 2 components and 0 parameter(s); 1 parameter(s) more must be "
        "unknown",
        [&] { connect(f, excited, rest, front, {}); });
    refused("there is a family of them: 1 condition(s) are missing", [&] {
        connect(f, excited, rest, front, {0.3, 0});
    });
    // (a, 0) is a centre for p = 0.
    refused("`from` is not hyperbolic: f_y has 2 eigenvalue(s) on the imaginary axis",
            [&] { connect(f, Vector2d(0.3, 0), rest, front, {0}); });
    refused("`from` must be near an equilibrium",
            [&] { connect({connected::fold}, rest, rest, front, {0}); });
    refused("guess(t) must come near `from`", [&] { connect(f, rest, excited, front, {0.3}); });
    refused("`from` is left by no orbit", [&] {
        connect({connected::fisher, 2.5}, rest, excited, [](double t) { return front(-t); }, {});
    });
    refused("`to` must be finite and have n components",
            [&] { connect(f, excited, VectorXd::Zero(3), front, {0.3}); });
}
