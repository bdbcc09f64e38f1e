// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE bvp_undecided
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <string>

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

constexpr double pi = 3.14159265358979323846;

// e y'' + p(t) y' + q y = what makes y = exp(t) a solution, or |t - 1/pi|^3 with `kink`.
struct equation {
    double e, constant = 0, linear = 0, square = 0, wave = 0, q = 0;
    bool kink = false;
    double p(double t) const { return constant + linear * t + square * t * t + wave * std::sin(t); }
    double exact(double t, int derivative) const {
        const double x = t - 1 / pi;
        if (!kink) return std::exp(t);
        return derivative == 0   ? std::abs(x * x * x)
               : derivative == 1 ? 3 * x * std::abs(x)
                                 : 6 * std::abs(x);
    }
    void operator()(double t, const Vector2d& y, Vector2d& f) const {
        f[0] = y[1];
        f[1] = exact(t, 2) + (p(t) * (exact(t, 1) - y[1]) + q * (exact(t, 0) - y[0])) / e;
    }
    void jacobian(double t, const Vector2d&, Eigen::Matrix2d& J) const { J << 0, 1, -q / e, -p(t) / e; }
};

enum class ends { values, slopes, periodic };

auto solve(const equation& f, ends kind, double tolerance, double a = 0) {
    const auto r = [=](const auto& left, const auto& right, auto& out) {
        const int c = kind == ends::slopes ? 1 : 0;
        out[0] = left[c] - f.exact(a, c), out[1] = right[c] - f.exact(1, c);
        if (kind == ends::periodic)
            for (int i = 0; i < 2; ++i) out[i] = left[i] - right[i] - f.exact(a, i) + f.exact(1, i);
    };
    return sc::solve_bvp(sc::gauss<5>(), sc::two_point(f, r), a, 1.0, Vector2d(0, 0), {.rtol = tolerance});
}

template <class Result>
bool right(const equation& f, const Result& r, double tolerance) {
    double worst = 0;
    for (int k = 0; k <= 100; ++k) {
        const double t = r.mesh.front() + (1 - r.mesh.front()) * k / 100, y = f.exact(t, 0);
        worst = std::max(worst, std::abs(r.y(t)[0] - y) / (1 + std::abs(y)));
    }
    return r.ok() && worst <= 2 * tolerance;
}

// The pendulum, or y'' = -y^3.
struct motion {
    int kind;
    template <class Time, class Vector>
    void operator()(const Time&, const Vector& y, Vector& f) const {
        using std::sin;
        f[0] = y[1];
        f[1] = kind == 0 ? -1 * sin(y[0]) : -1 * y[0] * y[0] * y[0];
    }
};

// e^2 y'' = y^3 - y (Allen-Cahn): y = tanh(t / (e sqrt(2))) but for exponentially small terms, which hold its layer in place.
struct layer {
    double e;
    template <class Time, class Vector>
    void operator()(const Time&, const Vector& y, Vector& f) const {
        f[0] = y[1];
        f[1] = (y[0] * y[0] * y[0] - y[0]) / (e * e);
    }
};

}  // namespace

// Nothing fixes the constant that may be added to y: elimination makes a regular matrix of its rounding errors, and y as large
// as these let it be, beside which its errors look small.
BOOST_AUTO_TEST_CASE(a_family_is_no_success_however_large_the_solution_found_is) {
    for (double tolerance = 1e-3; tolerance > 1e-11; tolerance /= 10) {
        for (const double e : {1e-1, 1e-2, 1e-3, 1e-5, 1e-7})
            for (const double sign : {1, -1}) {
                const equation f{.e = e, .constant = 2 * sign, .wave = sign};
                BOOST_TEST(!solve(f, ends::slopes, tolerance).ok());
            }
        for (const double e : {1e-6, 1e-8})
            BOOST_TEST(!solve({.e = e, .linear = 1}, ends::slopes, tolerance, -1).ok());
        BOOST_TEST(!solve({.e = 1}, ends::periodic, tolerance).ok());
        BOOST_TEST(!solve({.e = 1, .kink = true}, ends::slopes, tolerance).ok());
    }
}

BOOST_AUTO_TEST_CASE(what_conditions_fix_is_a_success) {
    for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
        for (const double e : {1e-1, 1e-3, 1e-5, 1e-7}) {
            const equation f{.e = e, .constant = 2, .wave = 1}, fixed{.e = e, .constant = 2, .q = -1};
            if (e * tolerance > 1e-13) {
                BOOST_TEST(right(f, solve(f, ends::values, tolerance), tolerance));
                BOOST_TEST(right(fixed, solve(fixed, ends::periodic, tolerance), tolerance));
            }
            // Layers that y does not have count where M is asked for: they are resolved, not taken for a family.
            const equation flat{.e = e, .square = 1};
            BOOST_TEST(right(flat, solve(flat, ends::values, tolerance, -1), tolerance));
        }
        for (const double distance : {1e-2, 1e-4, 1e-6}) {
            const equation near{.e = 1, .q = -distance};
            if (distance * tolerance > 1e-12)
                BOOST_TEST(right(near, solve(near, ends::slopes, tolerance), tolerance));
        }
    }
}

// y = exp(t) says nothing of the modes exp(i w t), which end in phase with both conditions or do not: a mesh that does not
// show their phase does not show which.
BOOST_AUTO_TEST_CASE(oscillations_that_the_mesh_does_not_show_are_shown_before_success) {
    for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11})
        for (const int half_waves : {10, 40, 100, 300}) {
            const double w = half_waves * pi, beside = (half_waves + 0.4) * pi;
            BOOST_TEST(!solve({.e = 1, .q = w * w}, ends::values, tolerance).ok());
            BOOST_TEST(!solve({.e = 1, .q = w * w}, ends::slopes, tolerance).ok());
            const equation f{.e = 1, .q = beside * beside};
            const auto r = solve(f, ends::values, tolerance);
            BOOST_TEST(right(f, r, tolerance));
            // An interval may hold half a wave and more.
            if (tolerance > 1e-8) BOOST_TEST(r.report.intervals <= std::max(20, 2 * half_waves));
        }
    // Where they decay from one end to the other, no phase reaches the other end, and no mesh has to show it.
    for (const double w : {100.0, 1000.0}) {
        const equation f{.e = 1, .constant = 60, .q = w * w};
        const auto r = solve(f, ends::periodic, 1e-5);
        BOOST_TEST(right(f, r, 1e-5));
        BOOST_TEST(r.report.intervals <= 20);
    }
}

// Of e y'' - t y' + q y = ... on [-1, 1] the homogeneous equation has solutions with layers at both ends, 1 and t inside, for
// q = 0 and 1 (Ackerberg-O'Malley resonance): what lies inside hangs on exp(-1/(2 e)).
BOOST_AUTO_TEST_CASE(resonance_at_a_turning_point_is_ill_conditioned) {
    for (const double e : {1e-2, 1e-6, 1e-7})
        for (const double tolerance : {1e-6, 1e-8}) {
            BOOST_TEST(!solve({.e = e, .linear = -1}, ends::values, tolerance, -1).ok());
            if (e < 1e-5) continue;
            const equation f{.e = e, .linear = -1, .q = 0.5};
            BOOST_TEST(right(f, solve(f, ends::values, tolerance, -1), tolerance));
        }
}

// Solutions that may be moved in time, or of which the conditions say the energy twice: at loose tolerances M of what is found
// is as regular as the error of y makes it.
BOOST_AUTO_TEST_CASE(an_error_of_the_solution_does_not_make_its_family_isolated) {
    const auto run = [](int kind, double T, double tolerance) {
        const auto r = [kind](const auto& a, const auto& b, auto& out) {
            const auto energy = [](const auto& y) {
                return y[1] * y[1] / 2 + y[0] * y[0] * y[0] * y[0] / 4 - 1;
            };
            for (int i = 0; i < 2 && kind == 0; ++i) out[i] = a[i] - b[i];
            if (kind == 1) out[0] = energy(a), out[1] = energy(b);
            if (kind == 2) out[0] = a[0], out[1] = energy(b);
        };
        const auto guess = [=](double t) {
            const double w = kind == 0 ? 2 * pi / T : 1, size = kind == 0 ? 2 : 1;
            return kind == 2 ? Vector2d(std::sin(t), std::cos(t))
                             : Vector2d(size * std::cos(w * t) + (kind == 0 ? 0 : 0.5),
                                        -size * w * std::sin(w * t));
        };
        return sc::solve_bvp(sc::gauss<5>(), sc::two_point(motion{kind}, r), 0.0, T, guess,
                             {.rtol = tolerance});
    };
    for (const double tolerance : {1e-2, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10}) {
        for (const double T : {8.0, 12.0}) BOOST_TEST(!run(0, T, tolerance).ok());
        for (const double T : {0.5, 5.0}) BOOST_TEST(!run(1, T, tolerance).ok());
        BOOST_TEST(run(2, 5, tolerance).ok());  // the place at the left is given, not the energy
    }
}

// The pendulum from a given angle with the energy of rest there: v(0)^2 = 0, a double solution, at which M = v(0) vanishes. The
// error of x leaves v(0) at its square root, so that M looks regular, more so the looser the tolerance.
BOOST_AUTO_TEST_CASE(an_error_of_the_solution_does_not_make_a_double_one_isolated) {
    for (const double angle : {0.8, 1.2, 1.6, 2.0})
        for (const double T : {1.0, 2.0, 4.0, 6.6, 7.5})
            for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
                const auto r = [=](const auto& a, const auto& b, auto& out) {
                    using std::cos;
                    out[0] = a[0] - angle, out[1] = b[1] * b[1] / 2 - cos(b[0]) + std::cos(angle);
                };
                const double w = 0.97, size = 1.05 * angle;
                const auto guess = [=](double t) {
                    return Vector2d(size * std::cos(w * t), -size * w * std::sin(w * t));
                };
                BOOST_TEST(!sc::solve_bvp(sc::gauss<5>(), sc::two_point(motion{0}, r), 0.0, T, guess,
                                          {.rtol = tolerance})
                                .ok());
            }
}

// kappa is exp(2 sqrt(2) / e) up to a factor. Every mesh holds the layer where the guess has put it, and its M is regular; the
// derivative of y, which has next to nothing at the ends, is not among its answers.
BOOST_AUTO_TEST_CASE(a_layer_that_only_the_mesh_holds_in_place_is_no_success) {
    const auto run = [](double e, double place, double tolerance, int component) {
        const auto r = [=](const auto& a, const auto& b, auto& out) {
            out[0] = a[component] + (1 - component), out[1] = b[component] - (1 - component);
        };
        const auto guess = [=](double t) {
            const double k = 1 / (std::sqrt(2.0) * e), y = std::tanh(k * (t - place));
            return Vector2d(y, k * (1 - y * y));
        };
        return sc::solve_bvp(sc::gauss<5>(), sc::two_point(layer{e}, r), -1.0, 1.0, guess,
                             {.rtol = tolerance});
    };
    for (const int component : {0, 1}) {
        BOOST_TEST(!run(0.03, 0.1, 1e-3, component).ok());
        BOOST_TEST(!run(0.05, 0, 1e-6, component).ok());
        for (const double tolerance : {1e-3, 1e-6, 1e-8})
            for (const double e : {0.2, 0.3, 0.5}) {
                const auto r = run(e, 0, tolerance, component);
                BOOST_TEST(r.ok());
                BOOST_TEST(std::abs(r.y(0.0)[0]) <= 2 * tolerance);
                BOOST_TEST(r.report.intervals <= 60);
            }
    }
}
