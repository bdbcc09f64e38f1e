// SPDX-License-Identifier: BSL-1.0
// Lecture, chapters 4 to 6, of nonlinear boundary value problems: each statement on the library's own shooting, sensitivities
// and collocation, with a case in which a hypothesis fails and the conclusion with it.
#define BOOST_TEST_MODULE bvp_nonlinear
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <problems/dense_once.hpp>
#include <random>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/lobatto_iiia.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/sensitivity/forward.hpp>
#include <stagecraft/shooting.hpp>
#include <stagecraft/theory/dynamics/green_function.hpp>

#include "end_values.hpp"

using namespace stagecraft;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// u'' = -lambda e^u as a system, with q added; parameters are not used but asked for by sensitivities().
struct bratu {
    static constexpr int second_order_components =
        0;  // collocation as in chapter 6, u' = v like any equation
    double lambda = 1, q = 0;
    template <class T, class Y, class F>
    void operator()(const T& t, const Y& y, F& f) const {
        using std::cos;
        using std::exp;
        using std::sin;
        f[0] = y[1] + q * sin(3 * t);
        f[1] = -lambda * exp(y[0]) + q * cos(2 * t);
    }
    template <class T, class Y, class P, class F>
    void operator()(const T& t, const Y& y, const P&, F& f) const {
        (*this)(t, y, f);
    }
};

/// The two solutions of u'' = -lambda e^u, u(0) = u(1) = 0: theta = sqrt(2 lambda) cosh(theta/4), the other branch is larger.
struct exact_bratu {
    double theta;
    exact_bratu(double lambda, bool upper) {
        double low = upper ? 4 * 1.1996786402577339 : 0, high = upper ? 60 : low;
        if (!upper) high = 4 * 1.1996786402577339;
        const auto f = [&](double x) { return x - std::sqrt(2 * lambda) * std::cosh(x / 4); };
        for (int k = 0; k < 200; ++k) {
            const double middle = (low + high) / 2;
            ((f(middle) < 0) == upper ? high : low) = middle;
        }
        theta = low;
    }
    Vector2d operator()(double t) const {
        const double z = theta / 2 * (t - 0.5);
        return {2 * std::log(std::cosh(theta / 4) / std::cosh(z)), -theta * std::tanh(z)};
    }
};

/// X(t) of the equation linearised along the solution from y0, by the library's sensitivities.
template <class F>
MatrixXd fundamental(const F& f, const Vector2d& y0, double from, double to) {
    const Matrix2d one = Matrix2d::Identity();
    if (to == from) return one;
    const auto r =
        sensitivities(radau_iia<5>(), f, y0, Vector2d(0, 0), from, to, {.rtol = 1e-11, .atol = 1e-11}, &one);
    BOOST_REQUIRE(r.ok());
    return r.S;
}

const MatrixXd first = (MatrixXd(2, 2) << 1, 0, 0, 0).finished(),
               second = (MatrixXd(2, 2) << 0, 0, 1, 0).finished();

template <class Guess>
auto collocated(const bratu& f, const end_values& r, const Guess& guess, double rtol = 1e-11) {
    return solve_bvp(gauss<5>(), two_point(f, r), 0.0, 1.0, guess, {.rtol = rtol});
}

double slope(double h1, double e1, double h2, double e2) { return std::log(e1 / e2) / std::log(h1 / h2); }

}  // namespace

BOOST_AUTO_TEST_CASE(remarks_to_satz_5_1_bound_the_steps_and_the_condition_of_multiple_shooting) {
    for (const bool upper : {false, true}) {
        const exact_bratu exact(1, upper);
        const bratu f;
        theory::linear_two_point<double> p{[&](double t) { return fundamental(f, exact(0), 0, t); }, 0, 1,
                                           first, second};
        const double kappa1 = p.kappa1(16), kappa2 = p.kappa2(16);
        BOOST_TEST(kappa1 <= 2 * kappa2 * (1 + 1e-9));  // scaled conditions
        for (const int N : {2, 4, 8}) {
            const auto r = shooting(radau_iia<5>(), two_point(f, end_values{0, 0}), 0.0, 1.0,
                                    [&](double t) { return Vector2d(1.01 * exact(t)); },
                                    {.rtol = 1e-10, .growth = infinity, .intervals = N});
            BOOST_REQUIRE(r.ok());
            BOOST_REQUIRE(r.nodes.size() == static_cast<std::size_t>(N) + 1);
            // |X_j(t_{j+1})| <= e^{mu_j h}, mu_j the largest |A_*(t)| there, A_* = (0, 1; -e^u, 0)
            const double h = 1.0 / N;
            double mu = 0, largest = 0, frobenius = 0;
            for (int j = 0; j < N; ++j) {
                const auto u = static_cast<std::size_t>(j);
                BOOST_TEST((r.values[u] - exact(r.nodes[u])).norm() < 1e-7);
                double mu_j = 0;
                for (int k = 0; k <= 32; ++k)
                    mu_j = std::max({mu_j, 1.0, std::exp(exact(r.nodes[u] + h * k / 32)[0])});
                const MatrixXd X = fundamental(f, r.values[u], r.nodes[u], r.nodes[u + 1]);
                const double size = theory::two_norm<double>(X);
                BOOST_TEST(size <= std::exp(mu_j * h));
                BOOST_TEST(size >
                           1 + 1e-3);  // e^{alpha h} would not do: the eigenvalues of A_* are imaginary
                mu = std::max(mu, mu_j), largest = std::max(largest, size);
                frobenius = std::max(frobenius, X.norm());
            }
            BOOST_TEST(std::abs(r.growth - frobenius) < 1e-5 * frobenius);  // what shooting reports of itself
            const auto condition = [&](const theory::linear_two_point<double>& of) {
                return theory::block_row_norm<double>(theory::shooting_matrix(of, r.nodes), 2) *
                       theory::block_row_norm<double>(theory::shooting_inverse(of, r.nodes), 2);
            };
            const double cond = condition(p), slack = 1 + 1e-4;  // maxima over 17 points only
            BOOST_TEST(cond <= (kappa1 + (N - 1) * kappa2) * (1 + largest) * slack);
            BOOST_TEST(cond <= (kappa1 + kappa2 / h) * (1 + std::exp(mu * h)) * slack);
            BOOST_TEST(cond <= (N + 1) * kappa2 * (1 + largest) * slack);
            // conditions a thousandth as large are not scaled: kappa1 <= 2 kappa2 fails, and (N + 1) kappa2 with it
            const theory::linear_two_point<double> small{p.X, 0, 1, first / 1000, second / 1000};
            BOOST_TEST(condition(small) > (N + 1) * kappa2 * (1 + largest));
        }
    }
}

BOOST_AUTO_TEST_CASE(satz_4_7_part_2_perturbed_problems_are_solvable_nearby_and_depend_on_q_and_d) {
    const exact_bratu exact(1, false);
    const double t = 0.5;
    // x - x_* = Phi d + int G q to first order, by Simpson's rule on both sides of s = t.
    const theory::linear_two_point<double> p{[&](double s) { return fundamental(bratu{}, exact(0), 0, s); },
                                             0, 1, first, second};
    Vector2d predicted = p.phi(t) * Vector2d(0.3, -0.2);
    for (int k = 0; k <= 16; ++k) {
        const double w = (k == 0 || k == 16 ? 1 : k % 2 == 1 ? 4 : 2) * 0.5 / 48;
        const auto q = [](double s) { return Vector2d(std::sin(3 * s), std::cos(2 * s)); };
        const double left = 0.5 * k / 16, right = 0.5 + left;
        predicted += w * (p.from_left(t, left) * q(left) + p.from_right(t, right) * q(right));
    }
    std::vector<double> delta{4e-2, 1e-2, 2.5e-3}, first_order, second_order;
    for (const double d : delta) {
        const auto r = collocated({.q = d}, {0.3 * d, -0.2 * d}, exact);
        BOOST_REQUIRE(r.ok());
        const Vector2d change = r.y(t) - exact(t);
        first_order.push_back(change.norm());
        second_order.push_back((change - d * predicted).norm());
        // locally unique: from all around x_* the same solution
        for (int k = 0; k < 4; ++k) {
            const auto other = collocated({.q = d}, {0.3 * d, -0.2 * d}, [&](double s) {
                return Vector2d(exact(s) + 0.3 * Vector2d(std::cos(k + 2 * s), std::sin(k - s)));
            });
            BOOST_REQUIRE(other.ok());
            BOOST_TEST((other.y(t) - r.y(t)).norm() < 1e-9);
        }
    }
    BOOST_TEST(std::abs(slope(delta[0], first_order[0], delta[2], first_order[2]) - 1) < 0.05);
    BOOST_TEST(std::abs(slope(delta[0], second_order[0], delta[2], second_order[2]) - 2) < 0.1);
    // At the fold (4.10) has a solution z != 0. For lambda - delta there are two solutions nearby, at distances like the root
    // of delta, and for lambda + delta none.
    const double a = 4 * 1.1996786402577339, fold = a * a / (2 * std::cosh(a / 4) * std::cosh(a / 4));
    std::vector<double> distance;
    for (const double d : {1e-2, 1e-4}) {
        const exact_bratu low(fold - d, false), high(fold - d, true);
        const auto lower = collocated({.lambda = fold - d}, {0, 0}, low, 1e-9),
                   upper = collocated({.lambda = fold - d}, {0, 0}, high, 1e-9);
        BOOST_REQUIRE((lower.ok() && upper.ok()));
        distance.push_back((upper.y(t) - lower.y(t)).norm());
        BOOST_TEST(!collocated({.lambda = fold + d}, {0, 0}, high).ok());
    }
    BOOST_TEST(std::abs(slope(1e-2, distance[0], 1e-4, distance[1]) - 0.5) < 0.03);
}

BOOST_AUTO_TEST_CASE(satz_4_7_parts_3_and_4_initial_values_near_reach_the_end_and_s_prime_is_m) {
    // x' = x^2 on [0, 1], x_* = 1/(2 - t): from [0.1, 0.9] solutions x0/(1 - x0 t) reach 1, with derivative 1/(1 - x0)^2.
    const auto square = [](const auto&, const auto& y, const auto&, auto& f) { f[0] = y[0] * y[0]; };
    const auto plain = [](const auto&, const auto& y, auto& f) { f[0] = y[0] * y[0]; };
    using number = Eigen::Matrix<double, 1, 1>;
    const number one(1.0);
    for (const double x0 : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        const auto r = sensitivities(radau_iia<5>(), square, number(x0), number(0.0), 0.0, 1.0,
                                     {.rtol = 1e-11, .atol = 1e-11}, &one);
        BOOST_REQUIRE(r.ok());
        BOOST_TEST(r.y[0] == x0 / (1 - x0), boost::test_tools::tolerance(1e-8));
        BOOST_TEST(r.S(0, 0) == 1 / ((1 - x0) * (1 - x0)), boost::test_tools::tolerance(1e-8));
    }
    // "delta sufficiently small" is needed: from 1.01 the solution ends at t = 1/1.01.
    const auto ends = integrate(radau_iia<5>(), plain, number(1.01), 0.0, 1.0, {.rtol = 1e-10});
    BOOST_TEST(!ends.ok());
    BOOST_TEST(ends.t == 1 / 1.01, boost::test_tools::tolerance(1e-4));
    // 4. S(v) = (x_1(0) - 0, x_1(1; v) - 0): S' by differences of runs, M_* = B0 + BT X_*(1) by sensitivities
    for (const bool upper : {false, true}) {
        const Vector2d start = exact_bratu(1, upper)(0);
        const MatrixXd M = first + second * fundamental(bratu{}, start, 0, 1);
        for (int k = 0; k < 2; ++k) {
            const double h = 1e-5;
            const auto S = [&](double s) {
                const Vector2d x0 = start + s * Vector2d::Unit(k);
                const auto r =
                    integrate(radau_iia<5>(), bratu{}, x0, 0.0, 1.0, {.rtol = 1e-12, .atol = 1e-12});
                return Vector2d(x0[0], r.y[0]);
            };
            BOOST_TEST(((S(h) - S(-h)) / (2 * h) - M.col(k)).norm() < 1e-5 * M.norm());
        }
        BOOST_TEST(std::abs(M.determinant()) > 0.05);
    }
    // at the fold M_* is singular
    const double a = 4 * 1.1996786402577339, fold = a * a / (2 * std::cosh(a / 4) * std::cosh(a / 4));
    const MatrixXd M = first + second * fundamental(bratu{.lambda = fold}, exact_bratu(fold, false)(0), 0, 1);
    BOOST_TEST(std::abs(M.determinant()) < 1e-5);
}

namespace {

/// The cubic spline of given values and slopes, (6.2).
struct cubic_spline {
    std::vector<double> t;
    std::vector<Vector2d> u, slope;

    std::size_t at(double x) const {
        std::size_t i = 1;
        while (i + 1 < t.size() && x > t[i]) ++i;
        return i;
    }
    Vector2d operator()(double x) const {
        const auto i = at(x);
        const double h = t[i] - t[i - 1], a = x - t[i - 1], b = x - t[i];
        const Vector2d D = (u[i] - u[i - 1]) / h, v = (D - slope[i - 1]) / h,
                       w = (slope[i - 1] - 2 * D + slope[i]) / (h * h);
        return u[i - 1] + a * D + a * b * v + a * a * b * w;
    }
    Vector2d derivative(double x) const {
        const auto i = at(x);
        const double h = t[i] - t[i - 1], a = x - t[i - 1], b = x - t[i];
        const Vector2d D = (u[i] - u[i - 1]) / h, v = (D - slope[i - 1]) / h,
                       w = (slope[i - 1] - 2 * D + slope[i]) / (h * h);
        return D + (a + b) * v + (2 * a * b + a * a) * w;
    }
};

/// R_(n) of a function with its derivative.
template <class X, class D>
cubic_spline restricted(const std::vector<double>& t, const X& x, const D& derivative) {
    cubic_spline r{t, {}, {}};
    for (const double s : t) r.u.push_back(x(s)), r.slope.push_back(derivative(s));
    return r;
}

/// R^V_(n) v at x: the parabola (6.7) through the values at both ends and the middle of the interval.
template <class V>
Vector2d parabola(const std::vector<double>& t, const V& v, double x) {
    std::size_t i = 1;
    while (i + 1 < t.size() && x > t[i]) ++i;
    const double h = t[i] - t[i - 1], m = t[i - 1] + h / 2;
    const Vector2d a = v(t[i - 1]), b = v(m), c = v(t[i]);
    return a + (x - t[i - 1]) * (b - a) / (h / 2) -
           (x - t[i - 1]) * (x - m) * ((b - a) / (h * h / 2) - (c - b) / (h * h / 2));
}

Vector2d value(const bratu& f, double t, const Vector2d& y) {
    Vector2d out;
    f(t, y, out);
    return out;
}

/// |u - v| in C^1, sampled at nine points of each interval.
template <class U, class V>
double distance(const U& u, const V& v) {
    double x = 0, d = 0;
    for (std::size_t i = 1; i < u.t.size(); ++i)
        for (int k = 0; k <= 8; ++k) {
            const double s = u.t[i - 1] + (u.t[i] - u.t[i - 1]) * k / 8;
            x = std::max(x, (u(s) - v(s)).cwiseAbs().maxCoeff());
            d = std::max(d, (u.derivative(s) - v.derivative(s)).cwiseAbs().maxCoeff());
        }
    return x + d;
}

/// |F_(n) u| with u(0) = u(1) = 0 for conditions: the defect at mesh points and midpoints, and the conditions.
double discrete_norm(const bratu& f, const cubic_spline& u) {
    double most = std::max(std::abs(u(0)[0]), std::abs(u(u.t.back())[0]));
    for (std::size_t i = 1; i < u.t.size(); ++i)
        for (const double s : {u.t[i - 1], (u.t[i - 1] + u.t[i]) / 2, u.t[i]})
            most = std::max(most, (u.derivative(s) - value(f, s, u(s))).cwiseAbs().maxCoeff());
    return most;
}

std::vector<double> mesh(int N, double power) {
    std::vector<double> t;
    for (int i = 0; i <= N; ++i) t.push_back(std::pow(static_cast<double>(i) / N, power));
    return t;
}

/// The library's solution of (6.6) on a mesh, as the spline with u_i' = f(u_i).
template <class Guess>
cubic_spline spline_solution(const bratu& f, const end_values& r, const std::vector<double>& t,
                             const Guess& guess) {
    const auto result = solve_bvp(lobatto_iiia<3>(), two_point(f, r), 0.0, 1.0, guess,
                                  {.rtol = 1e-12, .mesh = t, .adapt = false, .conditioning = false});
    return restricted(
        t, [&](double s) { return Vector2d(result.y(s)); },
        [&](double s) { return value(f, s, result.y(s)); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(restrictions_are_projectors_and_collocation_gives_a_spline_with_defect_0) {
    const auto t = mesh(7, 1.5);
    const auto x = [](double s) { return Vector2d(std::exp(s), std::sin(5 * s)); };
    const auto dx = [](double s) { return Vector2d(std::exp(s), 5 * std::cos(5 * s)); };
    const cubic_spline u = restricted(t, x, dx),
                       twice = restricted(t, u, [&](double s) { return u.derivative(s); });
    BOOST_TEST(distance(u, twice) < 1e-12);  // R R = R
    for (int k = 0; k <= 100; ++k) {
        const double s = k / 100.0;
        const auto v = [&](double r) { return u.derivative(r); };
        BOOST_TEST((parabola(t, v, s) - u.derivative(s)).norm() < 1e-12);  // R^V u' = u' on X_(n)
        const auto once = [&](double r) { return parabola(t, x, r); };
        BOOST_TEST((parabola(t, once, s) - once(s)).norm() < 1e-12);  // R^V R^V = R^V
    }
    for (const double power : {1.0, 2.0}) {
        const cubic_spline found = spline_solution({}, {0, 0}, mesh(12, power), exact_bratu(1, false));
        BOOST_TEST(discrete_norm({}, found) < 1e-9);  // (6.3): at the mesh points and the midpoints
        double between = 0;
        for (int k = 0; k < 100; ++k)
            between = std::max(between,
                               (found.derivative(k / 100.0) - value({}, k / 100.0, found(k / 100.0))).norm());
        BOOST_TEST(between > 1e-7);  // and not elsewhere
    }
}

BOOST_AUTO_TEST_CASE(satz_6_3_stable_uniquely_solvable_and_the_error_is_at_most_s_times_the_local_error) {
    std::mt19937 generator(63);
    std::uniform_real_distribution<double> number(-1, 1);
    for (const bool upper : {false, true}) {
        const exact_bratu exact(1, upper);
        const bratu f;
        const auto slope_of = [&](double s) { return value(f, s, exact(s)); };
        // S from the linearised problem: |x|_{C^1} <= (1 + |A|) (kappa_1 |d| + kappa_2 |q|) + |q|, in maxima norms twice that
        const theory::linear_two_point<double> p{[&](double s) { return fundamental(f, exact(0), 0, s); }, 0,
                                                 1, first, second};
        const double A = std::exp(exact(0.5)[0]),
                     S = 2 * ((1 + std::max(1.0, A)) * (p.kappa1(16) + p.kappa2(16)) + 1);
        for (const double power : {1.0, 1.5}) {
            std::vector<double> tau, stability;
            for (const int N : {16, 32, 64}) {
                const auto t = mesh(N, power);
                const cubic_spline Rx = restricted(t, exact, slope_of),
                                   x = spline_solution(f, {0, 0}, t, exact);
                BOOST_TEST(discrete_norm(f, x) < 1e-8);
                // Definition 6.1, and |R x_* - x_n| <= S |tau|
                tau.push_back(discrete_norm(f, Rx));
                BOOST_TEST(distance(Rx, x) <= S * tau.back());
                // unique in a ball: from starts around R x_* the same solution
                for (int k = 0; k < 3; ++k) {
                    const Vector2d off(0.05 * number(generator), 0.2 * number(generator));
                    const auto other = spline_solution(
                        f, {0, 0}, t, [&](double s) { return Vector2d(exact(s) + std::cos(4 * s) * off); });
                    BOOST_TEST(distance(other, x) < 1e-7);
                }
                // (6.9): F_(n) y - F_(n) x = (q, d) for the solution y with q added to f and d to the conditions
                double most = 0;
                for (int k = 0; k < 4; ++k) {
                    const double size = 1e-3, d0 = size * number(generator), d1 = size * number(generator);
                    const cubic_spline y = spline_solution({.q = size}, {d0, d1}, t, exact);
                    const double difference =
                        std::max({size, std::abs(d0), std::abs(d1)});  // |sin 3t|, |cos 2t| reach 1
                    most = std::max(most, distance(y, x) / difference);
                }
                stability.push_back(most);
                BOOST_TEST(most <= S);
            }
            BOOST_TEST(std::abs(slope(1, tau[1], 0.5, tau[2]) - 4) < 0.4);  // printed: O(h)
            BOOST_TEST(stability[2] < 4 * stability[0]);
        }
    }
    // M_* singular at the fold: no constant. From x_* the perturbed equations have solutions at distances like the root of q.
    const double a = 4 * 1.1996786402577339, fold = a * a / (2 * std::cosh(a / 4) * std::cosh(a / 4));
    std::vector<double> ratio;
    for (const double d : {1e-2, 1e-4}) {
        const exact_bratu low(fold - d, false), high(fold - d, true);
        const auto t = mesh(64, 1);
        const bratu f{.lambda = fold - d};
        ratio.push_back(distance(spline_solution(f, {0, 0}, t, high), spline_solution(f, {0, 0}, t, low)) /
                        d);
    }
    BOOST_TEST(ratio[1] > 5 * ratio[0]);
}
