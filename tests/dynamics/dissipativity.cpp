// SPDX-License-Identifier: BSL-1.0
// Lecture, sections 1.1 and 1.2.1, dissipativity: absorbing balls of differential equations and of methods.
#define BOOST_TEST_MODULE dissipativity
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <problems/dense_once.hpp>
#include <random>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/theory/dynamics/absorbing.hpp>
#include <stagecraft/theory/dynamics/rk_map.hpp>

#include "../message.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;
using Eigen::VectorXd;
using tableaux::family;
using tableaux::quadratic;

namespace {

using field = std::function<void(double, const VectorXd&, VectorXd&)>;

VectorXd at(const field& f, const VectorXd& x0, double t) {
    const auto r = integrate(radau_iia<3>(), f, x0, 0.0, t, {.rtol = 1e-10, .atol = 1e-12});
    BOOST_REQUIRE(r.ok());
    return r.y;
}

const auto decay = [](const auto&, const auto& x, auto& f) { f[0] = -x[0]; };
const auto cubic = [](const auto&, const auto& x, auto& f) { f[0] = x[0] - x[0] * x[0] * x[0]; };
const auto outwards = [](const auto&, const auto& x, auto& f) { f[0] = x[0] * x[0] * x[0] - x[0]; };
const auto lorenz = [](const auto&, const auto& x, auto& f) {
    f[0] = 10 * (x[1] - x[0]);
    f[1] = 28 * x[0] - x[1] - x[0] * x[2];
    f[2] = x[0] * x[1] - 8 * x[2] / 3;
};
const auto forced = [](const auto&, const auto& x, auto& f) { f[0] = 4 * sin(x[0]) - 2 * x[0]; };

state<rational, 3> lorenz_centre() {
    state<rational, 3> c;
    c << rational(0), rational(0), rational(38);
    return c;
}

tableau<quadratic> exact(family f, int s) { return *tableaux::exact_tableau(f, s); }

tableau<rational> euler() {
    tableau<rational> t;
    t.A.resize(1, 1);
    t.b.resize(1);
    t.c.resize(1);
    t.A(0, 0) = t.c[0] = 0;
    t.b[0] = 1;
    return t;
}

}  // namespace

BOOST_AUTO_TEST_CASE(definition_1_11_the_least_alpha_is_decided) {
    const auto d = dissipativity<1>(cubic, 1);  // 2x^2 - x^4 <= 1
    BOOST_TEST((d.verdict.is_proved() && d.exact && d.alpha == 1));
    const auto e = dissipativity<1>(cubic, 3);  // 4x^2 - x^4 <= 4
    BOOST_TEST((e.exact && e.alpha == 4));
    const auto f = dissipativity<1>(decay, 1);  // inequality (1.4)
    BOOST_TEST((f.exact && f.alpha == 0));
    BOOST_TEST(dissipativity<1>(decay, rational(101, 100)).verdict.is_refuted());
    BOOST_TEST(dissipativity<1>(outwards, 1).verdict.is_refuted());
    const auto l = dissipativity<3>(lorenz, 1, lorenz_centre());
    BOOST_TEST((l.verdict.is_proved() && l.exact && l.alpha == rational(23104, 15)));
    // around the origin the cubic terms cancel as well, but 38 xy remains: no alpha for any beta
    BOOST_TEST(dissipativity<3>(lorenz, 1).verdict.is_refuted());
}

BOOST_AUTO_TEST_CASE(within_a_radius_alpha_is_bounded_in_intervals) {
    const auto d = dissipativity_within<1>(forced, 1, 5.0);
    BOOST_TEST(d.verdict.is_proved());
    double largest = 0;
    for (double x = -5; x <= 5; x += 1e-3) largest = std::max(largest, (4 * std::sin(x) - 2 * x) * x + x * x);
    BOOST_TEST(d.alpha.to<double>() >= largest - 1e-12);
    BOOST_TEST(d.alpha.to<double>() <= largest * 1.01);
    const auto l =
        dissipativity_within<3>(lorenz, 1, 60.0, lorenz_centre(), {.relative = 0.2, .boxes = 100'000});
    BOOST_TEST(l.alpha.to<double>() >= 23104.0 / 15 - 1e-9);
    BOOST_TEST(dissipativity_within<1>(forced, 1, 5.0, origin<1>(), {.relative = 1e-12, .boxes = 9})
                   .verdict.is_consistent());
}

BOOST_AUTO_TEST_CASE(satz_1_12_balls_are_invariant_and_absorb_after_t_star) {
    const auto check = [](const field& f, const auto& d, const VectorXd& centre, double start,
                          double epsilon) {
        const double radius = d.absorbing_radius(epsilon), t = d.absorption_time(start, epsilon);
        BOOST_TEST(t > 0);
        std::mt19937 random(3);
        std::normal_distribution<double> pick;
        for (int k = 0; k < 6; ++k) {
            VectorXd e = VectorXd::NullaryExpr(centre.size(), [&] { return pick(random); });
            e /= e.norm();
            for (const double more : {0.0, 0.1, 1.0})
                BOOST_TEST((at(f, centre + start * e, t + more) - centre).norm() <= radius * (1 + 1e-8));
            for (const double later : {0.01, 0.1, 1.0})
                BOOST_TEST((at(f, centre + radius * e, later) - centre).norm() <= radius * (1 + 1e-8));
        }
    };
    const VectorXd zero = VectorXd::Zero(1);
    check(decay, dissipativity<1>(decay, 1), zero, 5, 0.01);
    check(cubic, dissipativity<1>(cubic, 1), zero, 10, 0.01);
    Eigen::Vector3d centre(0, 0, 38);
    check(lorenz, dissipativity<3>(lorenz, 1, lorenz_centre()), centre, 100, 1.0);
    BOOST_TEST(dissipativity<1>(cubic, 1).absorption_time(0.5, 0.01) == 0);
}

BOOST_AUTO_TEST_CASE(definition_1_9_positively_and_negatively_invariant_intervals) {
    // Runs from the ends and from inside, forwards and (f -> -f) backwards, that stay or do not.
    const auto stays = [](const field& f, double low, double high, int direction) {
        const field g = [&](double t, const VectorXd& x, VectorXd& out) {
            f(direction * t, x, out);
            out *= direction;
        };
        for (const double part : {0.0, 0.3, 0.8, 1.0}) {
            VectorXd x = VectorXd::Constant(1, low + part * (high - low));
            for (int k = 0; k < 8; ++k) {
                const auto r = integrate(radau_iia<3>(), g, x, 0.0, 0.5, {.rtol = 1e-10, .atol = 1e-12});
                if (!r.ok() || !(low - 1e-8 <= r.y[0] && r.y[0] <= high + 1e-8)) return false;
                x = r.y;
            }
        }
        return true;
    };
    const field falls = decay, with_three = cubic,
                grows = [](double, const VectorXd&x, VectorXd&f) { f = x; };
    BOOST_TEST((stays(falls, -1, 1, 1) && !stays(falls, -1, 1, -1)));                   // positively only
    BOOST_TEST((!stays(grows, -1, 1, 1) && stays(grows, -1, 1, -1)));                   // negatively only
    BOOST_TEST((stays(with_three, -1, 1, 1) && stays(with_three, -1, 1, -1)));          // invariant
    BOOST_TEST((stays(with_three, -2, 2, 1) && !stays(with_three, -2, 2, -1)));         // an absorbing set
    BOOST_TEST((!stays(with_three, 0.1, 0.5, 1) && !stays(with_three, 0.1, 0.5, -1)));  // neither
    BOOST_TEST((stays(falls, 0, 0, 1) && stays(falls, 0, 0, -1)));                      // an equilibrium
}

BOOST_AUTO_TEST_CASE(satz_1_12_for_minus_t_x_from_t0_on_beta_is_t0_and_none_serves_for_negative_t0) {
    const auto f = [](const auto& t, const auto& x, auto& out) { out[0] = -t * x[0]; };
    for (const rational& t0 : {rational(1, 2), rational(3)}) {
        const auto d = dissipativity_from<1>(f, t0, t0);
        BOOST_TEST((d.verdict.is_proved() && d.alpha == 0 && d.beta == t0));
        BOOST_TEST(!dissipativity_from<1>(f, t0 + rational(1, 100), t0).verdict.is_proved());
        // every solution is in the ball of radius 1/10 after t*
        const double start = t0.to<double>(), after = d.absorption_time(7, 0.01);
        BOOST_TEST(7 * std::exp(-start * after - after * after / 2) <= 0.1);
    }
    BOOST_TEST(!dissipativity_from<1>(f, rational(1, 1000), -2).verdict.is_proved());
    BOOST_TEST(0.3 * std::exp(2.0) > 2);  // the solution from x(-2) = 0.3 reaches this at t = 0
    const auto spiral = [](const auto& t, const auto& x, auto& out) {
        out[0] = -t * x[0] - t * x[1];
        out[1] = t * x[0] - 2 * t * x[1];
    };
    BOOST_TEST(dissipativity_from<2>(spiral, 1, 1).verdict.is_proved());
}

BOOST_AUTO_TEST_CASE(satz_1_12_without_the_inequality_solutions_leave_every_ball) {
    const field f = outwards;
    const auto r = integrate(radau_iia<3>(), f, VectorXd::Constant(1, 1.01), 0.0, 10.0);
    BOOST_TEST(!r.ok());
    BOOST_TEST(std::abs(r.y[0]) > 1e3);
    BOOST_TEST(std::abs(at(f, VectorXd::Constant(1, 0.99), 10)[0]) < 0.01);
}

BOOST_AUTO_TEST_CASE(lemma_1_20_and_satz_1_22_implicit_euler_is_absorbed_with_any_step_sizes) {
    const auto d = dissipativity<1>(cubic, 1);
    const auto ball = absorbing_ball_of_implicit_euler<1>(d, 1e-2);
    BOOST_TEST(ball.radius <= std::sqrt(1.01) + 1e-12);  // free of the steps: sqrt(alpha/beta + epsilon)
    const auto method = in_doubles(exact(family::radau_iia, 1));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> exponent(-2, 3);
    for (const double start : {-50.0, 3.0, 0.7}) {
        state<double, 1> x(start);
        double time = 0;
        const double enough = static_cast<double>(ball.steps_from(std::abs(start)));
        bool inside = false;
        for (int n = 0; n < 20'000 && time < enough + 10; ++n) {
            const double h = std::pow(10.0, exponent(random));
            const auto next = rk_step<1>(method, cubic, x, h);
            BOOST_REQUIRE(next.has_value());
            x = *next;
            time += h;
            if (inside) BOOST_TEST(std::abs(x[0]) <= ball.radius);  // invariant
            inside = inside || std::abs(x[0]) <= ball.radius;
        }
        BOOST_TEST(inside);
    }
}

BOOST_AUTO_TEST_CASE(satz_1_22_explicit_euler_leaves_the_ball) {
    const auto x = rk_step<1>(in_doubles(euler()), cubic, state<double, 1>(10.0), 0.1);
    BOOST_REQUIRE(x.has_value());
    BOOST_TEST(std::abs((*x)[0] - (-89.0)) < 1e-12);
    BOOST_TEST(message([] {
                   absorbing_ball(euler(), cubic, dissipativity<1>(cubic, 1), rational(1, 10));
               }).starts_with("method: not algebraically stable"));
}

BOOST_AUTO_TEST_CASE(satz_1_23_the_radius_bounds_every_run_of_five_algebraically_stable_methods) {
    const auto d = dissipativity<1>(cubic, 1);
    const std::vector<tableau<quadratic>> methods{exact(family::gauss, 1), exact(family::gauss, 2),
                                                  exact(family::radau_iia, 2), exact(family::radau_ia, 2),
                                                  exact(family::lobatto_iiic, 2)};
    int runs = 0, unsolved = 0;
    for (const auto& m : methods) {
        const auto doubles = in_doubles(m);
        for (const rational& h : {rational(1, 10), rational(1), rational(10), rational(100)}) {
            const auto ball = absorbing_ball(m, cubic, d, h, 0.1);
            for (const double start : {-20.0, 0.3, 4.0}) {
                state<double, 1> x(start);
                const long most = ball.steps_from(std::abs(start));
                double last = 0;
                for (long n = 0; n < std::min(most + 50, 2000L); ++n) {
                    const auto next = rk_step<1>(doubles, cubic, x, h.to<double>());
                    if (!next) {  // Newton's iteration ends: nothing more is measured of this run
                        ++unsolved;
                        break;
                    }
                    x = *next;
                    if (n >= most) {
                        last = std::max(last, std::abs(x[0]));
                        ++runs;
                    }
                }
                BOOST_TEST(last <= ball.radius);
            }
        }
    }
    BOOST_TEST(runs > 2000);
    BOOST_TEST(unsolved <= 3);  // of 60
    // Where a row of A is b the radius does not grow with h.
    const double small = absorbing_ball(methods[2], cubic, d, rational(1, 10), 0.1).radius;
    const double large = absorbing_ball(methods[2], cubic, d, rational(1000), 0.1).radius;
    BOOST_TEST(large <= std::sqrt(1.1 / 0.25) + 1e-9);
    BOOST_TEST(small < large);
    BOOST_TEST(absorbing_ball(methods[1], cubic, d, rational(1000), 0.1).radius > 100);
}

BOOST_AUTO_TEST_CASE(satz_1_23_rk4_is_not_algebraically_stable_and_diverges) {
    tableau<double> rk4;
    rk4.A = Eigen::Matrix4d{{0, 0, 0, 0}, {0.5, 0, 0, 0}, {0, 0.5, 0, 0}, {0, 0, 1, 0}};
    rk4.b = Eigen::Vector4d(1, 2, 2, 1) / 6;
    rk4.c = Eigen::Vector4d(0, 0.5, 0.5, 1);
    state<double, 1> x(10.0);
    for (int n = 0; n < 3; ++n) {
        const auto next = rk_step<1>(rk4, cubic, x, 1.0);
        if (!next) break;
        BOOST_TEST(std::abs((*next)[0]) > std::abs(x[0]));
        x = *next;
    }
    BOOST_TEST(std::abs(x[0]) > 1e20);
}

BOOST_AUTO_TEST_CASE(bad_input_of_dissipativity_and_of_absorbing_balls_is_named) {
    BOOST_TEST(message([] { dissipativity<1>(cubic, 0); }).starts_with("beta: must be positive"));
    BOOST_TEST(message([] { dissipativity_within<1>(cubic, 1, -1.0); }).starts_with("radius: "));
    const auto d = dissipativity<1>(cubic, 1);
    BOOST_TEST(message([&] { absorbing_ball(exact(family::gauss, 2), cubic, d, 0); }).starts_with("h: "));
    auto zero_weight = euler();
    zero_weight.b[0] = 0;
    BOOST_TEST(message([&] { absorbing_ball(zero_weight, cubic, d, 1); }).starts_with("method: needs b > 0"));
    zero_weight.b[0] = 2;
    BOOST_TEST(
        message([&] { absorbing_ball(zero_weight, cubic, d, 1); }).starts_with("method: not consistent"));
    const auto box_only = dissipativity_within<1>(cubic, 1, 3.0);
    BOOST_TEST(
        message([&] { absorbing_ball(exact(family::gauss, 1), cubic, box_only, 1); }).starts_with("d: "));
    BOOST_TEST(message([&] { d.absorption_time(-1, 1); }).starts_with("start: "));
    BOOST_TEST(message([&] { d.absorption_time(HUGE_VAL, 1); }).starts_with("start: "));
    BOOST_TEST(message([&] { d.absorption_time(std::nan(""), 1); }).starts_with("start: "));
    auto negative = d;
    negative.alpha = -1;
    BOOST_TEST(message([&] { negative.absorbing_radius(); }) == "alpha: must not be negative, is -1");
    BOOST_TEST(message([&] { absorbing_ball_of_implicit_euler<1>(negative); }).starts_with("alpha: "));
    negative = d;
    negative.beta = 0;
    BOOST_TEST(message([&] { absorbing_ball(exact(family::gauss, 1), cubic, negative, 1); }) ==
               "beta: must be positive, is 0");
    const auto pole = [](const auto&, const auto& x, auto& f) { f[0] = 1 / x[0]; };
    // (1/x - x) x = 1 - x^2 has no pole, f has one
    const auto cancels = [](const auto&, const auto& x, auto& f) { f[0] = 1 / x[0] - x[0]; };
    BOOST_TEST(message([&] { dissipativity<1>(cancels, 1); }).starts_with("f: divides through zero"));
    BOOST_TEST(message([&] { dissipativity_within<1>(pole, 1, 1.0); }).starts_with("f: cannot be bounded"));
    BOOST_TEST(message([&] { dissipativity_within<1>(cubic, 1, HUGE_VAL); }).starts_with("radius: "));
    BOOST_TEST(message([&] { absorbing_ball_of_implicit_euler<1>(d, 0); }).starts_with("epsilon: "));
    BOOST_TEST(message([&] { d.absorption_time(1, 0); }).starts_with("epsilon: "));
}
