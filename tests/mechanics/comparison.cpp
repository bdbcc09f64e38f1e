// SPDX-License-Identifier: BSL-1.0
// Thesis, section 3.1: Dini derivatives, comparison of solutions, and the comparison system in the proof of Theorem 6.
#define BOOST_TEST_MODULE comparison
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <stagecraft/linear/logarithmic_norm.hpp>
#include <stagecraft/mechanics/regularisation/asymptotic_expansion.hpp>
#include <vector>

using namespace stagecraft;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

using field = std::function<Vector2d(double, const Vector2d&)>;

// y' = f(t, y) at the given times, by the library's integrator.
std::vector<Vector2d> solution_of(const field& f, const Vector2d& start, const std::vector<double>& times) {
    detail::erased_problem system;
    system.M = Eigen::MatrixXd::Identity(3, 3);
    system.f = [&](double, const VectorXd& y, VectorXd& out) {  // the time as a third component
        out.resize(3);
        out << f(y[2], y.head(2)), 1;
    };
    VectorXd y(3);
    y << start, 0;
    const Eigen::MatrixXd values = detail::run("comparison", system, y, times, 1e-11);
    std::vector<Vector2d> out;
    for (Eigen::Index k = 0; k < values.cols(); ++k) out.push_back(values.col(k).head(2));
    return out;
}

std::vector<double> times_to(double end, int n) {
    std::vector<double> t;
    for (int k = 1; k <= n; ++k) t.push_back(end * k / n);
    return t;
}

const Matrix2d shear = (Matrix2d() << -1, 4, 0, -2).finished();

double norm(const Vector2d& x, int p) {
    return p == 1 ? x.lpNorm<1>() : p == 2 ? x.norm() : x.lpNorm<Eigen::Infinity>();
}

double mu(const Matrix2d& A, int p) {
    const auto all = logarithmic_norm(A);
    return p == 1 ? all.one : p == 2 ? all.euclidean : all.infinity;
}

// Lower and upper Dini derivative at t from the right: quotients over h from 1e-2 down to 1e-9, the larger ones left out.
template <class Y>
std::pair<double, double> dini(const Y& y, double t) {
    double low = 1e300, high = -1e300;
    for (int k = 4000; k <= 9000; ++k) {
        const double h = std::pow(10, -k / 1000.0), q = (y(t + h) - y(t)) / h;
        low = std::min(low, q), high = std::max(high, q);
    }
    return {low, high};
}

}  // namespace

BOOST_AUTO_TEST_CASE(definition_3_1_both_dini_derivatives_and_where_they_differ) {
    // y = t sin(log t), y(0) = 0, is continuous: D_+ y(0) = -1, D^+ y(0) = 1.
    const auto wild = [](double t) { return t > 0 ? t * std::sin(std::log(t)) : 0; };
    const auto [low, high] = dini(wild, 0);
    BOOST_TEST((std::abs(low + 1) < 1e-4 && std::abs(high - 1) < 1e-4));
    const auto [left, right] =
        dini([](double t) { return std::sin(3 * t); }, 0.5);  // differentiable: one number
    BOOST_TEST((std::abs(left - 3 * std::cos(1.5)) < 1e-3 && std::abs(right - 3 * std::cos(1.5)) < 1e-3));
    // D_+ |x| <= mu(A) |x| along x' = A x, with equality for some x; |x| itself has corners in the 1-norm.
    for (const int p : {1, 2, 0}) {
        double largest = -1e300;
        for (int k = 0; k < 2000; ++k) {
            const double angle = k * 3.14159265358979 / 1000, h = 1e-7;
            const Vector2d x(std::cos(angle), std::sin(angle));
            largest = std::max(largest, (norm(x + h * (shear * x), p) / norm(x, p) - 1) / h);
        }
        BOOST_TEST(largest <= mu(shear, p) + 1e-5);
        BOOST_TEST(largest > mu(shear, p) - 1e-2);
    }
}

BOOST_AUTO_TEST_CASE(lemma_3_3_comparison_with_all_four_conditions_and_without_each) {
    // g(t, s) = (-s1 + s2^2, t s1 - s2^3), growing with the other component where s >= 0.
    const field g = [](double t, const Vector2d& s) {
        return Vector2d(-s[0] + s[1] * s[1], t * s[0] - s[1] * s[1] * s[1]);
    };
    const auto plus = [](const field& f, const Vector2d& by) -> field {
        return [f, by](double t, const Vector2d& s) { return Vector2d(f(t, s) + by); };
    };
    const auto times = times_to(3, 60);
    const auto below = [&](const field& of_m, const field& of_u, const Vector2d& m0, const Vector2d& u0) {
        const auto m = solution_of(of_m, m0, times), u = solution_of(of_u, u0, times);
        bool all = true;
        for (std::size_t k = 0; k < times.size(); ++k)
            all = all && m[k][0] <= u[k][0] + 1e-8 && m[k][1] <= u[k][1] + 1e-8;
        return all;
    };
    const Vector2d start(1, 0.5), small(0.1, 0.01);
    // m' = g(t, m) - |sin 5t| has kinks in m': only D_+ m <= g is asked
    const field rough = [&](double t, const Vector2d& s) {
        return Vector2d(g(t, s) - std::abs(std::sin(5 * t)) * Vector2d(0.2, 0.1));
    };
    BOOST_TEST(below(rough, plus(g, small), start, start));
    BOOST_TEST(below(g, plus(g, small), start, start));
    BOOST_TEST(!below(plus(g, 2 * small), plus(g, small), start, start));    // 1: D_+ m > g
    BOOST_TEST(!below(g, plus(g, -small), start, start));                    // 2: D_+ u < g
    BOOST_TEST(!below(g, plus(g, small), start, start - Vector2d(0.3, 0)));  // 3: u(0) < m(0)
    const field turned = [](double t, const Vector2d& s) {                   // 4: g_1 falls with s2
        return Vector2d(-s[0] - s[1] * s[1], t * s[0] - s[1] * s[1] * s[1]);
    };
    BOOST_TEST(!below(turned, plus(turned, {0.01, 2}), start, start));
    // 2 must be strict where g is not Lipschitz: g = 2 sqrt(s), m = t^2 and u = 0 satisfy it with equality.
    const auto m = [](double t) { return t * t; };
    for (const double t : {0.1, 0.5, 2.0}) {
        BOOST_TEST(std::abs(dini(m, t).second - 2 * std::sqrt(m(t))) < 1e-3);
        BOOST_TEST(m(t) > 0);
    }
}

BOOST_AUTO_TEST_CASE(lemma_3_4_bounds_the_distance_to_any_curve_for_nonlinear_f_with_l_and_delta_of_t) {
    const field f = [](double t, const Vector2d& y) {
        return Vector2d(-y[0] * y[0] * y[0] + t * y[1], -std::sin(y[0]) - 2 * y[1]);
    };
    const auto f_y = [](double t, const Vector2d& y) {
        return (Matrix2d() << -3 * y[0] * y[0], t, -std::cos(y[0]), -2).finished();
    };
    // v is no solution: v' - f(t, v) = delta(t) in norm.
    const auto v = [](double t) { return Vector2d(std::cos(t), 0.3 * std::sin(2 * t)); };
    const auto slope = [](double t) { return Vector2d(-std::sin(t), 0.6 * std::cos(2 * t)); };
    const Vector2d start(0.8, 0.2);
    const int n = 2000;
    const auto times = times_to(3, n);
    const auto y = solution_of(f, start, times);
    for (const int p : {1, 2, 0}) {
        double L = 0, integral = 0, closest = 1e300, with_eigenvalues = 1e300, L_low = 0, low = 0;
        const double C = norm(start - v(0), p);
        for (int k = 0; k < n; ++k) {
            const double t = times[static_cast<std::size_t>(k)], h = 3.0 / n;
            const Vector2d& yt = y[static_cast<std::size_t>(k)];
            double l = -1e300, abscissa = -1e300;
            for (int j = 0; j <= 8; ++j) {
                const Matrix2d A = f_y(t, yt + (v(t) - yt) * j / 8.0);
                l = std::max(l, mu(A, p));
                abscissa = std::max(abscissa, A.eigenvalues().real().maxCoeff());
            }
            const double delta = norm(slope(t) - f(t, v(t)), p);
            L += h * l, L_low += h * abscissa;
            integral += h * std::exp(-L) * delta, low += h * std::exp(-L_low) * delta;
            closest = std::min(closest, std::exp(L) * (C + integral) - norm(yt - v(t), p));
            with_eigenvalues = std::min(with_eigenvalues, std::exp(L_low) * (C + low) - norm(yt - v(t), p));
        }
        BOOST_TEST(closest >= -2e-3);  // the rectangle rule with 2000 points
        BOOST_TEST(closest < 0.5);
        BOOST_TEST(with_eigenvalues < closest);
    }
    // mu, and not the largest real part of an eigenvalue: for x' = shear x, delta = 0, that part is -1.
    const auto moved =
        solution_of([](double, const Vector2d& x) { return Vector2d(shear * x); }, Vector2d(0, 1), {0.5});
    BOOST_TEST(moved[0].norm() > std::exp(-0.5));
    BOOST_TEST(moved[0].norm() <= std::exp(0.5 * mu(shear, 2)));
    // l(t) >= mu(f_y) all the way from y to v: for y' = y^2, y = 0, v(0) = 1/2, it is 0 at y alone, and v reaches 1 at t = 1.
    const auto grown = solution_of([](double, const Vector2d& x) { return Vector2d(x[0] * x[0], 0); },
                                   Vector2d(0.5, 0), {1.0});
    BOOST_TEST(std::abs(grown[0][0] - 1) < 1e-8);
    BOOST_TEST(grown[0][0] > 0.5 * std::exp(0.0));
    BOOST_TEST(grown[0][0] <= 0.5 * std::exp(2.0));  // l = 2 max |eta| = 2
}

namespace {

/// (3.42): u' = L1 u + L2 v + C1, eps v' = L3 u - v + C2.
struct comparison_system {
    double L1, L2, L3, eps;
    Matrix2d matrix() const { return (Matrix2d() << L1, L2, L3 / eps, -1 / eps).finished(); }
    /// alpha_+ and alpha_-; the thesis prints L1 eps^2 for L1^2 eps^2.
    Vector2d roots(double last) const {
        const double root = std::sqrt(1 + eps * (2 * L1 + 4 * L2 * L3) + last * eps * eps);
        return {(L1 - (1 + root) / eps) / 2, (L1 - (1 - root) / eps) / 2};
    }
    /// The solution from (u, v) at t with constant inhomogeneities, by the library's integrator.
    Vector2d at(double t, const Vector2d& start, double C1, double C2) const {
        const Matrix2d A = matrix();
        return solution_of(
            [=, this](double, const Vector2d& x) { return Vector2d(A * x + Vector2d(C1, C2 / eps)); }, start,
            {t})[0];
    }
};

/// A polynomial times e^-x.
struct decaying {
    std::vector<double> p;
    double operator()(double x) const {
        double value = 0;
        for (auto a = p.rbegin(); a != p.rend(); ++a) value = value * x + *a;
        return value * std::exp(-x);
    }
    decaying derivative() const {
        decaying d{p};
        for (std::size_t k = 0; k < p.size(); ++k) {
            d.p[k] = -p[k];
            if (k + 1 < p.size()) d.p[k] += static_cast<double>(k + 1) * p[k + 1];
        }
        return d;
    }
};

// The terms of Theorem 6 for y' = z, eps z' = -y - z, y(0) = z(0) = 1, from the two modes of the linear equation.
const std::vector<decaying> y_j{{{1}}, {{2, -1}}, {{5, -4, 0.5}}}, z_j{{{-1}}, {{-3, 1}}, {{-9, 5, -0.5}}},
    eta_j{{{-2}}, {{-5, -2}}, {{-16, -7, -1}}}, zeta_j{{{2}}, {{3, 2}}, {{9, 5, 1}}};

/// (y^, z^) with terms up to N, eta_N included or not, and its slope.
struct truncated {
    double eps;
    int N;
    bool last_eta = true;
    template <class Outer, class Layer>
    Vector2d sum(double t, Outer outer, Layer layer, double of_layer) const {
        Vector2d x(0, 0);
        double power = 1;
        for (std::size_t j = 0; j <= static_cast<std::size_t>(N); ++j, power *= eps) {
            x += power * Vector2d(outer(y_j[j])(t), outer(z_j[j])(t));
            x[1] += of_layer * power * layer(zeta_j[j])(t / eps);
            if (last_eta || j < static_cast<std::size_t>(N))
                x[0] += of_layer * power * eps * layer(eta_j[j])(t / eps);
        }
        return x;
    }
    Vector2d operator()(double t) const {
        const auto itself = [](const decaying& d) { return d; };
        return sum(t, itself, itself, 1);
    }
    Vector2d slope(double t) const {
        const auto derivative = [](const decaying& d) { return d.derivative(); };
        return sum(t, derivative, derivative, 1 / eps);
    }
};

Vector2d exact_relaxation(double eps, double t) {
    const double root = std::sqrt(1 - 4 * eps), slow = (-1 + root) / (2 * eps),
                 fast = (-1 - root) / (2 * eps);
    const double b = (1 - slow) / (fast - slow), a = 1 - b;
    return {a * std::exp(slow * t) + b * std::exp(fast * t),
            a * slow * std::exp(slow * t) + b * fast * std::exp(fast * t)};
}

struct relaxation {
    static constexpr int slow = 1, fast = 1;
    template <class S>
    Eigen::Matrix<S, 1, 1> f(const Eigen::Matrix<S, 1, 1>&, const Eigen::Matrix<S, 1, 1>& z) const {
        return z;
    }
    template <class S>
    Eigen::Matrix<S, 1, 1> g(const Eigen::Matrix<S, 1, 1>& y, const Eigen::Matrix<S, 1, 1>& z) const {
        return Eigen::Matrix<S, 1, 1>(S(-y[0] - z[0]));
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(equation_3_42_has_the_roots_with_l1_squared_and_not_as_printed) {
    const comparison_system c{3, 2, 5, 0.1};
    const Eigen::Vector2cd eigenvalues = c.matrix().eigenvalues();
    const double low = eigenvalues.real().minCoeff(), high = eigenvalues.real().maxCoeff();
    BOOST_TEST((c.roots(9) - Vector2d(low, high)).norm() < 1e-12);
    BOOST_TEST((c.roots(9) - Vector2d(-15.4269, 8.4269)).norm() < 1e-4);
    BOOST_TEST((c.roots(3) - Vector2d(-15.3638, 8.3638)).norm() < 1e-4);  // as printed
    BOOST_TEST((c.roots(3) - Vector2d(low, high)).norm() > 0.08);
    // alpha_- = L1 + L2 L3 + O(eps), alpha_+ = -1/eps + O(1): what the proof needs of them
    for (const double eps : {1e-3, 1e-5}) {
        const Vector2d roots = comparison_system{3, 2, 5, eps}.roots(9);
        BOOST_TEST(std::abs(roots[1] - 13) < 200 * eps);
        BOOST_TEST(std::abs(roots[0] + 1 / eps) < 20);
    }
}

BOOST_AUTO_TEST_CASE(theorem_6_to_n_2_and_the_errors_stay_below_the_comparison_system) {
    // The library's terms, N = 0 and 1, are those of the modes.
    const Eigen::Matrix<double, 1, 1> one(1.0);
    const asymptotic_expansion<relaxation> library({}, one, one);
    for (const double t : {0.3, 1.0}) {
        const auto o = library.outer(t);
        const auto l = library.layer(t);
        BOOST_TEST(std::abs(o.y0[0] - y_j[0](t)) + std::abs(o.y1[0] - y_j[1](t)) < 1e-8);
        BOOST_TEST(std::abs(o.z0[0] - z_j[0](t)) + std::abs(o.z1[0] - z_j[1](t)) < 1e-8);
        BOOST_TEST(std::abs(l.eta0[0] - eta_j[0](t)) < 1e-8);
        BOOST_TEST(std::abs(l.zeta0[0] - zeta_j[0](t)) + std::abs(l.zeta1[0] - zeta_j[1](t)) < 1e-8);
    }
    const auto times = [](double eps) {
        return std::vector<double>{0, 0.5 * eps, 2 * eps, 6 * eps, 0.1, 0.5, 1};
    };
    for (int N = 0; N <= 2; ++N) {
        double before = 0;
        for (const double eps : {4e-3, 2e-3}) {
            const truncated theorem{eps, N, false}, whole{eps, N};
            double worst = 0, C1 = 0, C2 = 0;
            for (double t = 0; t <= 1; t += t < 10 * eps ? eps / 20 : 0.01) {
                const Vector2d x = whole(t), d = whole.slope(t);
                C1 = std::max(C1, std::abs(d[0] - x[1]));
                C2 = std::max(C2, std::abs(eps * d[1] + x[0] + x[1]));
                worst = std::max(worst, (theorem(t) - exact_relaxation(eps, t)).norm());
            }
            // (3.34), (3.35): defects O(eps^{N+1}); Theorem 6: the remainder is O(eps^{N+1})
            BOOST_TEST(std::max(C1, C2) < 50 * std::pow(eps, N + 1));
            if (before > 0) BOOST_TEST(std::abs(std::log2(before / worst) - (N + 1)) < 0.1);
            before = worst;
            // (3.39) to (3.42) with L1 = 0, L2 = L3 = 1
            const comparison_system c{0, 1, 1, eps};
            const Vector2d start = (whole(0) - Vector2d(1, 1)).cwiseAbs();
            for (const double t : times(eps)) {
                const Vector2d error = (whole(t) - exact_relaxation(eps, t)).cwiseAbs(),
                               bound = t > 0 ? c.at(t, start, 1.01 * C1, 1.01 * C2) : start;
                BOOST_TEST(error[0] <= bound[0] * (1 + 1e-6) + 1e-13);
                BOOST_TEST(error[1] <= bound[1] * (1 + 1e-6) + 1e-13);
                BOOST_TEST(bound.norm() < 200 * std::pow(eps, N + 1));
            }
        }
    }
}
