// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE bvp_statuses
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/lobatto_iiia.hpp>
#include <stagecraft/coefficients/lobatto_iiic.hpp>
#include <string>

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

constexpr double pi = 3.14159265358979323846;

// x'' = -x and what else the cases ask for, as one type: the solver is instantiated once per method.
struct oscillator {
    int fault = 0;
    double e = 1;
    void operator()(double t, const Vector2d& y, Vector2d& f) const {
        f = Vector2d(y[1], -y[0]);
        if (fault == 0 && e > 1) f = Vector2d(y[1], e * e * y[0]);
        if (fault == 8) f = Vector2d(y[1], y[0] * y[1] / e);
        if (fault == 1 && t == 0) f[1] = std::numeric_limits<double>::quiet_NaN();
        if (fault == 2) throw std::runtime_error("no");
        if (fault == 4) f = Vector2d(50 * y[0], -50 * y[1]);
        if (fault == 5) f = Vector2d(y[0] * y[1], 0);
        if (fault == 6) f = Vector2d(y[1], -std::sin(y[0]));
        if (fault == 7) f = Vector2d(y[1], -3.6 * std::exp(y[0]));  // Bratu beyond its fold
        if (fault == 9) f = Vector2d(y[1], -0.2 * y[1] - y[0] * y[0] * y[0] + e * std::cos(t));  // Duffing
        if (fault == 10) f = Vector2d(1 / t, y[0] - y[1]);
        if (fault == 3 && t > 0.4) f[0] = std::numeric_limits<double>::infinity();
    }
};

// x_1(0) = alpha, x_1(T) = beta; or coupled and degenerate ones.
struct ends {
    double alpha, beta;
    int kind = 0;
    void operator()(const Vector2d& a, const Vector2d& b, Vector2d& r) const {
        if (kind == 0) r = Vector2d(a[0] - alpha, b[0] - beta);
        if (kind == 1) r = a - b;                                    // periodic
        if (kind == 2) r = Vector2d(a[0] - alpha, 2 * a[0] - beta);  // dependent
        if (kind == 3) r[0] = a[0];                                  // one is not written
        if (kind == 5) r = Vector2d(a[1], a[0] - b[0]);
        if (kind == 7) r = a;
        if (kind == 4) throw std::runtime_error("no");
        if (kind == 6) r.data()[2] = b[1];  // as r[2] without assertions
    }
};

auto solve(double T, const ends& r, int fault = 0, const sc::bvp_options<double>& o = {.rtol = 1e-10},
           const Vector2d& guess = Vector2d(0, 0), double e = 1) {
    return sc::solve_bvp(sc::gauss<5>(), sc::two_point(oscillator{fault, e}, r), 0.0, T, guess, o);
}

std::string word(sc::bvp_status s) { return (std::ostringstream() << s).str(); }

template <class F>
void names(const std::string& argument, F&& f) {
    BOOST_CHECK_EXCEPTION(f(), std::invalid_argument, [&](const std::invalid_argument& e) {
        return std::string(e.what()).find(argument) != std::string::npos;
    });
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_solution_and_many_solutions_are_told_apart) {
    const auto none = solve(2 * pi, {0, 1});
    BOOST_TEST(word(none.status) == "singular");
    const auto many = solve(2 * pi, {0, 0});
    BOOST_TEST(word(many.status) == "not_isolated");
    BOOST_TEST(many.kernel == 1);
    const auto all = solve(2 * pi, {0, 0, 1});  // the harmonic oscillator: M = 0
    BOOST_TEST(word(all.status) == "not_isolated");
    BOOST_TEST(all.kernel == 2);
    const auto dependent = solve(1, {1, 5, 2});
    BOOST_TEST(word(dependent.status) == "singular");
    BOOST_TEST(dependent.message.find("r[1]") != std::string::npos);
    BOOST_TEST(word(solve(1, {0, 1}).status) == "success");  // and with a T that is harmless
}

// y' = y z, z' = 0, z(0) = 0, y(0) = y(1): every constant y. Newton's iteration ends after one step with factors of the
// guess, where M is regular as long as z is not 0.
BOOST_AUTO_TEST_CASE(isolation_is_judged_at_the_solution_and_not_at_the_guess) {
    for (const double tolerance : {1e-4, 1e-10})
        for (const double z : {1.0, 0.3, 1e-3, 0.0}) {
            const auto r = solve(1, {0, 0, 5}, 5, {.rtol = tolerance}, Vector2d(1, z));
            BOOST_TEST(word(r.status) == "not_isolated");
            BOOST_TEST(r.kernel == 1);
        }
}

BOOST_AUTO_TEST_CASE(the_error_of_what_is_no_solution_is_not_known) {
    const auto r = solve(1, {0, 0}, 7);
    BOOST_TEST(word(r.status) == "newton_failed");
    BOOST_TEST(r.error.global == std::numeric_limits<double>::infinity());
    const auto threw = solve(1, {0, 0}, 2);
    for (const auto& e : {r.error, threw.error}) {
        BOOST_TEST(e.components[0] == std::numeric_limits<double>::infinity());
        BOOST_TEST(e.components[1] == std::numeric_limits<double>::infinity());
        BOOST_TEST(e.parameters.size() == 0);
    }
}

// x_1(0) = c_1, x_1(T) = c_2, T = pi (1 - 10^-k): 1/kappa_1^2 = 1 - |cos T|, 1/kappa_2 = |sin T|, by pi - T.
BOOST_AUTO_TEST_CASE(near_resonance_runs_end_and_the_condition_numbers_are_known) {
    const double beyond = 1.2246467991473532e-16, eps = std::numeric_limits<double>::epsilon();
    for (const double tolerance : {1e-6, 1e-10})
        for (const ends& r : {ends{0, 1}, ends{1, 2}, ends{1, -1}})
            for (int k = 1; k <= 14; ++k) {
                const double T = pi * (1 - std::pow(10.0, -k)), gap = (pi - T) + beyond;
                const double kappa1 = 1 / (std::sqrt(2.0) * std::sin(gap / 2)), kappa2 = 1 / std::sin(gap);
                const auto answer = solve(T, r, 0, {.rtol = tolerance});
                BOOST_TEST_CONTEXT("k = " << k << ", c = " << r.alpha << ", " << r.beta << ", rtol "
                                          << tolerance << ": " << word(answer.status)) {
                    BOOST_TEST(answer.report.meshes <= 12);
                    // Gauss methods of five stages turn by (5!)^2/(10! 11!) h^11 too little in a step.
                    const double h = T / answer.report.intervals,
                                 off = 20 * eps + 1e-10 * T * std::pow(h, 10);
                    BOOST_TEST(std::abs(answer.conditioning.kappa1 / kappa1 - 1) < 5e-6 + off * kappa1);
                    BOOST_TEST(std::abs(answer.conditioning.kappa2 / kappa2 - 1) < 5e-6 + off * kappa1);
                    const bool ill = answer.status == sc::bvp_status::ill_conditioned;
                    const bool singular = answer.status == sc::bvp_status::singular ||
                                          answer.status == sc::bvp_status::not_isolated;
                    BOOST_TEST((answer.ok() || ill || (singular && eps * kappa1 > 1e-4)));
                    if (200 * eps * kappa1 < tolerance) BOOST_TEST(answer.ok());
                    if (eps * kappa1 > tolerance) BOOST_TEST(!answer.ok());
                    if (!answer.ok()) continue;
                    const double c = (r.beta + r.alpha * std::cos(gap)) / std::sin(gap);
                    double worst = 0;
                    for (const double t : {0.0, 0.1, 0.5, 1.0, 1.5, 2.0, 2.5, 2.8, T}) {
                        const double exact = r.alpha * std::cos(t) + c * std::sin(t);
                        worst = std::max(worst, std::abs(answer.y(t)[0] - exact) / (1 + std::abs(exact)));
                    }
                    BOOST_TEST(worst <= tolerance);
                }
            }
}

BOOST_AUTO_TEST_CASE(at_resonance_solutions_do_not_exist_or_are_not_isolated) {
    for (const int half_turns : {1, 2}) {
        const double T = half_turns * pi, same = half_turns == 1 ? -1 : 1;
        BOOST_TEST(word(solve(T, {0, 1}).status) == "singular");
        BOOST_TEST(word(solve(T, {1, -same}).status) == "singular");
        BOOST_TEST(word(solve(T, {0, 0}).status) == "not_isolated");
        BOOST_TEST(word(solve(T, {1, same}).status) == "not_isolated");
    }
}

// On ten intervals M_h of two stages is as regular as its errors make it: kappa_1 = 753 and 33,500.
BOOST_AUTO_TEST_CASE(what_the_errors_of_a_coarse_mesh_make_regular_is_singular) {
    for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
        const auto with = [&](double T, const ends& r, double speed) {
            return sc::solve_bvp(sc::gauss<2>(), sc::two_point(oscillator{0, speed}, r), 0.0, T,
                                 Vector2d(0, 0), {.rtol = tolerance});
        };
        const auto periodic = with(2 * pi, {0, 0, 1}, 1), straight = with(pi, {0, 0}, 1);
        BOOST_TEST(word(periodic.status) == "not_isolated");
        BOOST_TEST(periodic.kernel == 2);
        BOOST_TEST(word(straight.status) == "not_isolated");
        BOOST_TEST(straight.kernel == 1);
        BOOST_TEST(word(with(pi, {0, 1}, 1).status) == "singular");
        for (const double T : {1.0, 6.0, 3.0}) {  // well posed ones are not refused
            const auto good = with(T, {0, 1}, 1);
            BOOST_TEST(word(good.status) == "success");
        }
        // and fast modes that the solution does not have cost no intervals
        BOOST_TEST(with(1, {0, 0, 1}, 100).report.intervals == 10);
    }
}

// The layers of e y'' = y y' are found from where M is singular to rounding; where y(0) = 1, y(1) = -1, their place is
// known to exp(-1/(2 e)), and M is singular at the solution as well.
BOOST_AUTO_TEST_CASE(singular_iterates_say_nothing_of_nonlinear_problems) {
    for (const double e : {1e-2, 3e-3, 1e-3, 1e-4})
        for (const double left : {0.5, 1.0})
            for (const double tolerance : {1e-4, 1e-7}) {
                const auto r = solve(1, {left, -1}, 8, {.rtol = tolerance}, Vector2d(0, 0), e);
                BOOST_TEST(word(r.status) != "singular");
                BOOST_TEST((!r.ok() || left < 1));
            }
    // The pendulum's solutions of period 8 have every phase. With differences M is regular by their errors.
    const auto pendulum = [](const auto&, const auto& y, auto& f) {
        using std::sin;
        f[0] = y[1];
        f[1] = -sin(y[0]);
    };
    const auto swing = [](double most) {
        return [=](double t) -> Vector2d {
            return most * Vector2d(std::cos(pi * t / 4), -pi / 4 * std::sin(pi * t / 4));
        };
    };
    for (const double most : {2.0, 1.94})
        for (double tolerance = 1e-3; tolerance > 2e-13; tolerance /= 1.7) {
            const auto r = sc::solve_bvp(sc::gauss<5>(), sc::two_point(pendulum, ends{0, 0, 1}), 0.0, 8.0,
                                         swing(most), {.rtol = tolerance});
            const bool family = r.status == sc::bvp_status::not_isolated && r.kernel == 1;
            BOOST_TEST((family || r.status == sc::bvp_status::ill_conditioned));
            BOOST_TEST(std::abs(r.y(3.0)[0]) + std::abs(r.y(3.0)[1]) > 1);
        }
    const auto blurred = sc::two_point(oscillator{6}, ends{0, 0, 1});
    for (const double tolerance : {1e-4, 1e-7, 1e-10})
        BOOST_TEST(!sc::solve_bvp(sc::gauss<5>(), blurred, 0.0, 8.0, swing(2), {.rtol = tolerance}).ok());
}

// Damping alone ends before iterates at which the equations are singular, on every mesh. The values are those of
// scipy.integrate.solve_bvp with tol = 1e-8.
BOOST_AUTO_TEST_CASE(newtons_iteration_gets_past_singular_iterates) {
    const auto wave = [](double t) { return Vector2d(std::cos(t), -std::sin(t)); };
    for (const auto& [force, x, v] :
         {std::array{1.0, 1.43935192, 0.75171721}, std::array{5.0, 2.42172711, 0.73264385}}) {
        const auto r = sc::solve_bvp(sc::gauss<5>(), sc::two_point(oscillator{9, force}, ends{0, 0, 1}), 0.0,
                                     2 * pi, wave, {.rtol = 1e-6});
        BOOST_TEST(word(r.status) == "success");
        BOOST_TEST((r.y(0.0) - Vector2d(x, v)).norm() < 1e-5);
        BOOST_TEST(r.report.intervals < 80);
    }
}

// Falkner and Skan's boundary layer from a constant guess beyond an iterate at which M is singular; f''(0) is published.
BOOST_AUTO_TEST_CASE(other_guesses_are_tried_where_newtons_iteration_fails_from_the_users) {
    const auto ends = [](const auto& a, const auto& b, auto& r) {
        r[0] = a[0], r[1] = a[1], r[2] = b[1] - 1;
    };
    struct flow {
        double beta, length, guess, shear;
    };
    for (const flow& of : {flow{0.5, 6, 1, 0.927680}, flow{1, 10, 1.2, 1.2325877}}) {
        const auto f = [=](const auto&, const auto& y, auto& d) {
            d[0] = y[1], d[1] = y[2], d[2] = -y[0] * y[2] - of.beta * (1 - y[1] * y[1]);
        };
        const auto r = sc::solve_bvp(sc::gauss<5>(), sc::two_point(f, ends), 0.0, of.length,
                                     Eigen::Vector3d(0, 0, of.guess), {.rtol = 1e-6});
        BOOST_TEST(r.ok());
        BOOST_TEST(std::abs(r.y(0.0)[2] - of.shear) < 1e-5);
        BOOST_TEST(r.report.f < 200000);
    }
    // Bratu's problem beyond its fold has no solution, which is not known after many more evaluations either.
    const auto none = solve(1, {0, 0}, 7, {.rtol = 1e-6});
    BOOST_TEST(sc::name(none.status) == std::string("newton_failed"));
    BOOST_TEST(none.message.find("continuation()") != std::string::npos);
    BOOST_TEST(none.report.f < 800000);
}

// v = u'/e is of size 1e14 and as exact as u.
BOOST_AUTO_TEST_CASE(large_components_are_not_singular) {
    const auto f = [](const auto&, const auto& y, auto& out) {
        out[0] = y[1] / 1e14;
        out[1] = 1e14 * y[0];
    };
    const auto r = [](const auto& a, const auto& b, auto& out) {
        out[0] = a[0];
        out[1] = b[0] - 1;
    };
    const auto good = sc::solve_bvp(sc::gauss<5>(), sc::two_point(f, r), 0.0, 1.0, Vector2d(0, 0));
    BOOST_TEST(word(good.status) == "success");
    BOOST_TEST(std::abs(good.y(0.5)[0] - std::sinh(0.5) / std::sinh(1.0)) < 1e-9);
}

// Where the mesh is coarse beside 1/50, Green's function is large at s = t and at s = a only.
BOOST_AUTO_TEST_CASE(the_jump_of_greens_function_and_its_values_at_the_ends_belong_to_kappa_2) {
    const auto r = solve(1, {0, 0, 1}, 4);  // x' = diag(50, -50) x, periodic: kappa = 1/(1 - e^-50)
    BOOST_TEST(r.ok());
    BOOST_TEST(std::abs(r.conditioning.kappa1 - 1) < 1e-6);
    BOOST_TEST(std::abs(r.conditioning.kappa2 - 1) < 1e-6);
}

BOOST_AUTO_TEST_CASE(what_callables_do_wrong_is_a_status) {
    const auto throwing = solve(1, {0, 1}, 2);
    BOOST_TEST(word(throwing.status) == "function_threw");
    BOOST_CHECK_THROW(std::rethrow_exception(throwing.exception), std::runtime_error);
    BOOST_TEST(word(solve(1, {0, 1, 4}).status) == "function_threw");
    const auto infinite = solve(1, {0, 1}, 3);
    BOOST_TEST(word(infinite.status) == "non_finite");
    BOOST_TEST(infinite.message.find("t = 0.4") != std::string::npos);
    const auto unwritten = solve(1, {0, 1, 3});
    BOOST_TEST(word(unwritten.status) == "non_finite");
    BOOST_TEST(unwritten.message.find("conditions") != std::string::npos);

    // NaN at an end is met by Lobatto and not by Gauss.
    BOOST_TEST(word(solve(1, {0, 1}, 1).status) == "success");
    const auto lobatto = sc::solve_bvp(sc::lobatto_iiia<3>(), sc::two_point(oscillator{1}, ends{0, 1}), 0.0,
                                       1.0, Vector2d(0, 0));
    BOOST_TEST(word(lobatto.status) == "non_finite");
    BOOST_TEST(lobatto.message.find("t = 0,") != std::string::npos);
    BOOST_TEST(lobatto.message.find("Gauss") != std::string::npos);
}

// x' = 1/t: the error of log t stays as the mesh closes in on t = 0.
BOOST_AUTO_TEST_CASE(a_singularity_without_a_solution_ends_the_run) {
    for (const double tolerance : {1e-3, 1e-8}) {
        const auto r = solve(1, {0, 0, 7}, 10, {.rtol = tolerance});
        BOOST_TEST(word(r.status) == "tolerance_not_met");
        BOOST_TEST(!(r.error.global < 0.1));
        BOOST_TEST(r.report.meshes < 60);
    }
}

BOOST_AUTO_TEST_CASE(resized_outputs_and_wrong_numbers_of_conditions_are_named) {
    const auto f = [](double, const Eigen::VectorXd& y, Eigen::VectorXd& out) { out = -y; };
    const auto resizing = [](double, const Eigen::VectorXd&, Eigen::VectorXd& out) { out.setZero(3); };
    const auto one = [](const Eigen::VectorXd& a, const Eigen::VectorXd&, Eigen::VectorXd& r) { r = a; };
    const auto three = [](const Eigen::VectorXd&, const Eigen::VectorXd&, Eigen::VectorXd& r) {
        r.setZero(3);
    };
    const Eigen::VectorXd two = Eigen::VectorXd::Ones(2);
    using rhs = std::function<void(double, const Eigen::VectorXd&, Eigen::VectorXd&)>;
    using conditions = std::function<void(const Eigen::VectorXd&, const Eigen::VectorXd&, Eigen::VectorXd&)>;
    const auto run = [&](const rhs& g, const conditions& r, const auto& guess) {
        return sc::solve_bvp(sc::gauss<2>(), sc::two_point(g, r), 0.0, 1.0, guess);
    };
    BOOST_TEST(word(run(resizing, one, two).status) == "size_changed");
    names("conditions", [&] { run(f, three, two); });
    names("guess", [&] { run(f, one, Eigen::VectorXd(0)); });
    BOOST_TEST(word(run(f, one, two).status) == "success");
    const auto shrinking = [&](double t) -> Eigen::VectorXd { return two.head(t > 0.5 ? 1 : 2); };
    names("guess must have the same number of components at every t", [&] { run(f, one, shrinking); });
}

BOOST_AUTO_TEST_CASE(bad_arguments_are_named) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto with = [](const sc::bvp_options<double>& o) { solve(1, {0, 1}, 0, o); };
    names("a must be below b", [] { solve(0, {0, 1}); });
    names("finite", [&] { solve(nan, {0, 1}); });
    names("rtol", [&] { with({.rtol = 1e-16}); });
    names("atol", [&] { with({.atol = -1}); });
    names("mesh", [&] { with({.mesh = {0, 0.5, 0.5, 1}}); });
    names("mesh", [&] { with({.mesh = {0, 0.5}}); });
    names("fixed_points", [&] { with({.fixed_points = {1.5}}); });
    names("intervals", [&] { with({.intervals = -1}); });
    names("max_intervals", [&] { with({.intervals = 20, .max_intervals = 5}); });
    names("max_intervals", [&] { with({.mesh = {0, 0.25, 0.5, 1}, .max_intervals = 2}); });
    names("conditions must write n + n_p numbers", [&] { solve(1, {0, 1, 6}); });
    names("newton_iterations", [&] { with({.newton_iterations = 0}); });
    names("guess", [&] {
        sc::solve_bvp(sc::gauss<5>(), sc::two_point(oscillator{}, ends{0, 1}), 0.0, 1.0, Vector2d(nan, 0));
    });
    names("collocation", [] {
        sc::solve_bvp(sc::lobatto_iiic<3>(), sc::two_point(oscillator{}, ends{0, 1}), 0.0, 1.0,
                      Vector2d(0, 0));
    });
}

BOOST_AUTO_TEST_CASE(intervals_are_limited_and_counts_are_what_they_cost) {
    const auto few = solve(40, {0, 1}, 0, {.rtol = 1e-12, .max_intervals = 15});
    BOOST_TEST(word(few.status) == "too_many_intervals");
    BOOST_TEST(few.y.steps() > 0);  // the best iterate is kept
    const auto fixed = solve(1, {0, 1}, 0, {.rtol = 1e-10, .adapt = false, .conditioning = false});
    BOOST_TEST(fixed.ok());
    BOOST_TEST(fixed.report.meshes == 1);
    BOOST_TEST(fixed.report.factorisations == 1);  // linear: one
    BOOST_TEST(fixed.report.error_solves == 1);
    BOOST_TEST(fixed.report.jacobians == 10 * 5 + 10);  // one per interval: are they constant?
    // Where no mode is fast six intervals are tried first, after a look at f in the middle of each and one at its form;
    const auto easy = solve(1, {0, 1}, 0, {.rtol = 1e-6});
    BOOST_TEST(easy.ok());
    BOOST_TEST(easy.report.intervals == 6);
    BOOST_TEST(easy.report.f <= 1 + 6 * (1 + 2 * 5 + 7 + 2) + 6);
    BOOST_TEST(easy.report.factorisations <= 2);
    // where they see too little, they cost one step of Newton's iteration and, where they seemed enough, its estimate.
    const sc::bvp_options<double> strict{.rtol = 1e-10}, ten{.rtol = 1e-10, .intervals = 10};
    for (const double T : {10.0, 20.0, 40.0, 80.0}) {
        const auto after = solve(T, {0, 1}, 0, strict), alone = solve(T, {0, 1}, 0, ten);
        BOOST_TEST(after.ok());
        BOOST_TEST(after.report.f <= alone.report.f + 6 * (1 + 2 * 5 + 7 + 2) + 6);
    }
    const auto tiny = sc::solve_bvp(sc::gauss<5>(), sc::two_point(oscillator{}, ends{0, 1e-15}), 0.0, 1e-15,
                                    Vector2d(0, 0), {.rtol = 1e-10});
    BOOST_TEST(word(tiny.status) != "newton_failed");
}

// Where y is large somewhere, its rounding errors there are more than the tolerance allows where it is small. And where
// Green's function is large, rounding errors inside are too, though kappa_1 is small: of e y'' - t y' + y = 0 on [-1, 1],
// y(-1) = 1, y(1) = 0, the part -t/2 hangs on exp(-1/(2 e)). It had come back as 0, with success.
BOOST_AUTO_TEST_CASE(what_rounding_leaves_of_large_values_is_no_success) {
    const auto with = [](double size, int conditions = 2, double e = 0) {
        const auto f = [e](const auto& t, const auto& y, auto& out) {
            out[0] = y[1], out[1] = y[0];
            if (e > 0) out[1] = (t * y[1] - y[0]) / e;
        };
        const auto ends = [=](const auto& left, const auto& right, auto& r) {
            r[0] = left[0] - size, r[1] = right[0];
            for (int i = 2; i < conditions; ++i) r[i] = right[0];
        };
        return sc::solve_bvp(sc::gauss<5>(), sc::two_point(f, ends), e > 0 ? -1.0 : 0.0, 1.0, Vector2d(0, 0),
                             {.rtol = 1e-8});
    };
    const auto turning = with(1, 2, 0.1);
    BOOST_TEST(turning.ok());
    BOOST_TEST(std::abs(turning.y(0.0)[1] + 0.5) < 1e-8);
    int refined = 0;  // where nothing but rounding is left, meshes may be refined to the end
    for (const double e : {0.01, 0.007, 0.005, 0.004, 0.003, 0.002, 0.001}) {
        const std::string status = word(with(1, 2, e).status);
        refined += status == "too_many_intervals";
        BOOST_TEST((status == "ill_conditioned" || status == "too_many_intervals"));
    }
    BOOST_TEST(refined <= 1);
    const auto usual = with(1e6);  // y = 1e6 sinh(1 - t) / sinh(1)
    BOOST_TEST(usual.ok());
    BOOST_TEST(std::abs(usual.y(0.5)[0] / (1e6 * std::sinh(0.5) / std::sinh(1.)) - 1) < 1e-8);
    BOOST_TEST(word(with(1e12).status) == "ill_conditioned");
    BOOST_TEST(word(with(1e15).status) == "ill_conditioned");
    names("the conditions must write n + n_p numbers, n = 2", [&] { with(1, 3); });
    names("the conditions must write n + n_p numbers, n = 2", [&] { with(1, 5); });
    // Conditions for double alone are differentiated by differences, which such values must not hide.
    const auto differences = [](const Vector2d& left, const Vector2d& right, Vector2d& r) {
        r[0] = left[0] - 1e8, r[1] = right[0];
    };
    const auto f = [](double, const Vector2d& y, Vector2d& out) { out = Vector2d(y[1], y[0]); };
    const auto seen = sc::solve_bvp(sc::gauss<5>(), sc::two_point(f, differences), 0.0, 1.0, Vector2d(0, 0),
                                    {.rtol = 1e-6});
    BOOST_TEST(seen.ok());
    BOOST_TEST(std::abs(seen.y(0.5)[0] / (1e8 * std::sinh(0.5) / std::sinh(1.)) - 1) < 1e-6);
}

// y' = 100 y grows by e^(100 T): M is regular, but answers so much that rounding errors count. Conditions that depend on
// each other are another matter.
BOOST_AUTO_TEST_CASE(solutions_that_grow_are_ill_conditioned_and_not_singular) {
    const auto with = [](double T, double first, bool dependent) {
        const auto f = [](const auto&, const auto& y, auto& out) {
            out[0] = 100 * y[0];
            out[1] = -y[1];
        };
        const auto r = [=](const auto& left, const auto&, auto& out) {
            out[0] = left[0] - first;
            if (dependent) out[0] = left[1];
            out[1] = left[1] - 1;
        };
        return sc::solve_bvp(sc::gauss<5>(), sc::two_point(f, r), 0.0, T, Vector2d(0, 0));
    };
    for (const double first : {0.0, 1.0}) {
        BOOST_TEST(with(0.1, first, false).ok());
        for (const double T : {0.5, 1.0, 5.0})
            BOOST_TEST(word(with(T, first, false).status) == "ill_conditioned");
    }
    BOOST_TEST(word(with(1, 0, true).status) == "singular");
}
