// SPDX-License-Identifier: BSL-1.0
// Chapters 4 to 6 of the lecture: what is stated there of linear and nonlinear boundary value problems, each statement with a
// case in which a hypothesis fails and the conclusion with it.
#define BOOST_TEST_MODULE bvp_lecture
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/dense_once.hpp>
#include <random>
#include <stagecraft/coefficients/lobatto_iiia.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/sensitivity/forward.hpp>
#include <stagecraft/tableaux/fixed_rational.hpp>
#include <stagecraft/theory/dynamics/green_function.hpp>

using namespace stagecraft;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using problem = theory::linear_two_point<double>;

namespace {

constexpr double pi = 3.14159265358979323846;

MatrixXd diagonal(const std::vector<double>& d) {
    return Eigen::Map<const VectorXd>(d.data(), static_cast<Eigen::Index>(d.size())).asDiagonal();
}
MatrixXd rotation(double t) {
    return (MatrixXd(2, 2) << std::cos(t), std::sin(t), -std::sin(t), std::cos(t)).finished();
}
const MatrixXd first = (MatrixXd(2, 2) << 1, 0, 0, 0).finished(),
               second = (MatrixXd(2, 2) << 0, 0, 1, 0).finished(), one = MatrixXd::Identity(2, 2);

// x' = diag(rates) x on [0, T].
problem modes(const std::vector<double>& rates, double T, const MatrixXd& B0, const MatrixXd& BT) {
    return {[rates](double t) {
                std::vector<double> e;
                for (const double r : rates) e.push_back(std::exp(r * t));
                return diagonal(e);
            },
            0, T, B0, BT};
}

MatrixXd random_matrix(std::mt19937& generator, Eigen::Index m) {
    std::normal_distribution<double> number;
    MatrixXd a(m, m);
    for (Eigen::Index k = 0; k < a.size(); ++k) a.data()[k] = number(generator);
    return a;
}

double norm(const MatrixXd& a) { return theory::two_norm<double>(a); }

}  // namespace

BOOST_AUTO_TEST_CASE(section_4_1_1_m_is_singular_at_multiples_of_pi_and_where_conditions_depend) {
    for (const double T : {1.0, 2.0, 3.0, 4.0})
        BOOST_TEST(std::abs(problem({rotation, 0, T, first, second}).solvability().determinant() -
                            std::sin(T)) < 1e-15);
    for (const int k : {1, 2, 3})
        BOOST_TEST(std::abs(problem({rotation, 0, k * pi, first, second}).solvability().determinant()) <
                   1e-15);
    const MatrixXd twice = 2 * first;  // rank (B0 BT) = 1
    MatrixXd dependent = first;
    dependent.row(1) = twice.row(0);
    BOOST_TEST(problem({rotation, 0, 1, dependent, MatrixXd::Zero(2, 2)}).solvability().determinant() == 0);
    BOOST_CHECK_THROW(theory::scaled(dependent, MatrixXd::Zero(2, 2)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(equation_4_4_gives_the_solution_and_greens_function_jumps_by_one) {
    // x' = rotation' x + q, q = (1, 0): x_1'' = -x_1 + 0, closed form below.
    const double T = 2;
    const problem p{rotation, 0, T, first, second};
    for (const double t : {0.3, 1.0, 1.7}) {
        const MatrixXd jump = p.from_left(t, t) - p.from_right(t, t);
        BOOST_TEST((jump - one).cwiseAbs().maxCoeff() < 1e-14);
        // By Simpson's rule on both sides of s = t.
        VectorXd x = p.phi(t) * Eigen::Vector2d(1, 3);
        const auto add = [&](double from, double to, bool left) {
            const int n = 200;
            for (int k = 0; k <= n; ++k) {
                const double s = from + (to - from) * k / n, w = (to - from) / (3 * n) *
                                                                 (k == 0 || k == n ? 1
                                                                  : k % 2 == 1     ? 4
                                                                                   : 2);
                x += w * ((left ? p.from_left(t, s) : p.from_right(t, s)) * Eigen::Vector2d(1, s));
            }
        };
        add(0, t, true);
        add(t, T, false);
        // x_1' = x_2 + 1, x_2' = -x_1 + t: x_1 = t + a cos t + b sin t, x_2 = -a sin t + b cos t.
        const double a = 1, b = (3 - T - a * std::cos(T)) / std::sin(T);
        BOOST_TEST(std::abs(x[0] - (t + a * std::cos(t) + b * std::sin(t))) < 1e-9);
        BOOST_TEST(std::abs(x[1] - (-a * std::sin(t) + b * std::cos(t))) < 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(lemma_4_4_holds_for_scaled_conditions_and_fails_for_others) {
    std::mt19937 generator(3);
    int sharp = 0;
    for (int k = 0; k < 1000; ++k) {
        const Eigen::Index m = 2 + k % 3;
        const MatrixXd V = random_matrix(generator, m), Vi = V.inverse(), B0 = random_matrix(generator, m),
                       BT = random_matrix(generator, m), rates = random_matrix(generator, m).row(0);
        const auto s = theory::scaled(B0, BT);
        // Definition 4.3: orthogonal rows, entries in [0, 1], one of each pair 1, and the same conditions.
        const MatrixXd G0 = s.B0 * s.B0.transpose(), GT = s.BT * s.BT.transpose();
        BOOST_TEST((G0 - MatrixXd(s.D0.cwiseAbs2().asDiagonal())).cwiseAbs().maxCoeff() < 1e-10);
        BOOST_TEST((GT - MatrixXd(s.DT.cwiseAbs2().asDiagonal())).cwiseAbs().maxCoeff() < 1e-10);
        BOOST_TEST((s.S * B0 - s.B0).cwiseAbs().maxCoeff() < 1e-10);
        for (Eigen::Index i = 0; i < m; ++i) BOOST_TEST(std::abs(std::max(s.D0[i], s.DT[i]) - 1) < 1e-14);
        const auto X = [&](double t) {
            return MatrixXd(V * MatrixXd((t * rates).array().exp().matrix().transpose().col(0).asDiagonal()) *
                            Vi);
        };
        const problem p{X, 0, 1, s.B0, s.BT};
        const double kappa1 = p.kappa1(6), kappa2 = p.kappa2(6);
        BOOST_TEST(kappa1 <= 2 * kappa2 * (1 + 1e-9));
        sharp += kappa1 > kappa2;
    }
    BOOST_TEST(sharp > 10);  // the 2 is needed
    const problem unscaled{rotation, 0, 1, first / 100, second / 100};
    BOOST_TEST(unscaled.kappa1(20) > 10 * unscaled.kappa2(20));
}

BOOST_AUTO_TEST_CASE(satz_4_6_dichotomy_bounds_greens_function_and_back) {
    const MatrixXd P = diagonal({1, 0}), Q = diagonal({0, 1});
    const problem fitting = modes({-2, 3}, 4, P, Q);  // B0 X(0) (1 - P) = 0, BT X(T) P = 0
    BOOST_TEST(std::abs(theory::dichotomy_constant<double>(fitting, P, 2, 3, 20) - 1) < 1e-12);
    BOOST_TEST(fitting.kappa2(20) <= 1 + 1e-12);
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 20; ++j) {
            const double t = fitting.at(i, 20), s = fitting.at(j, 20);
            const double bound = s <= t ? std::exp(-2 * (t - s)) : std::exp(-3 * (s - t));
            BOOST_TEST(norm(fitting.green(t, s)) <= bound * (1 + 1e-9));
        }
    // Part 2: the bound on G gives a dichotomy with the same constants, P = M^-1 B0 X(t0).
    const MatrixXd found = fitting.inverse(fitting.solvability()) * fitting.B0 * fitting.X(0);
    BOOST_TEST((found * found - found).cwiseAbs().maxCoeff() < 1e-14);
    BOOST_TEST(std::abs(theory::dichotomy_constant<double>(fitting, found, 2, 3, 20) - 1) < 1e-12);
    // Violated: a condition at the left end that sees the growing mode.
    const problem wrong = modes({-2, 3}, 4, one, MatrixXd::Zero(2, 2));
    BOOST_TEST(norm(wrong.B0 * wrong.X(0) * (one - P)) == 1);
    BOOST_TEST(wrong.kappa2(20) > std::exp(11.9));
}

BOOST_AUTO_TEST_CASE(the_c1_estimate_as_printed_is_refuted_and_with_the_missing_factors_holds) {
    // x' = 1, x(0) = 0 on [0, 1]: kappa_1 = kappa_2 = 1, |x| + |x'| = 2 > 1.
    const problem p{[](double) { return MatrixXd(MatrixXd::Identity(1, 1)); }, 0, 1, MatrixXd::Identity(1, 1),
                    MatrixXd::Zero(1, 1)};
    BOOST_TEST(p.kappa1(10) == 1);
    BOOST_TEST(p.kappa2(10) == 1);
    BOOST_TEST(1.0 + 1.0 > p.kappa1(10) * 0 + p.kappa2(10) * 1);
    // (1 + |A|) (kappa_1 |d| + kappa_2 (T - t_0) |q|) + |q| on x' = a x + q, x(0) = d for many a, q, d.
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> number(-2, 2);
    for (int k = 0; k < 1000; ++k) {
        const double a = number(generator), q = number(generator), d = number(generator);
        const problem r = modes({a}, 1, MatrixXd::Identity(1, 1), MatrixXd::Zero(1, 1));
        double x = 0, slope = 0;
        for (int i = 0; i <= 50; ++i) {
            const double t = i / 50.0, value = std::exp(a * t) * d + q * std::expm1(a * t) / a;
            x = std::max(x, std::abs(value)), slope = std::max(slope, std::abs(a * value + q));
        }
        const double bound =
            (1 + std::abs(a)) * (r.kappa1(10) * std::abs(d) + r.kappa2(10) * std::abs(q)) + std::abs(q);
        BOOST_TEST(x + slope <= bound * (1 + 1e-12));
    }
}

BOOST_AUTO_TEST_CASE(section_4_4_x_of_T_has_the_eigenvalue_1_with_the_direction_of_the_orbit) {
    const auto field = [](const auto&, const auto& x, const auto&, auto& f) {
        const auto r = 1 - x[0] * x[0] - x[1] * x[1];
        f[0] = x[1] + x[0] * r;
        f[1] = x[1] * r - x[0];
    };
    const Eigen::Matrix2d unit = Eigen::Matrix2d::Identity();
    const auto X_of_T = [&](const Eigen::Vector2d& start) {
        const auto r = sensitivities(radau_iia<5>(), field, start, Eigen::Vector2d(0, 0), 0.0, 2 * pi,
                                     {.rtol = 1e-12, .atol = 1e-12}, &unit);
        BOOST_REQUIRE(r.ok());
        return r.S;
    };
    const Eigen::Vector2d start(0, 1), direction(1, 0);  // f(start)
    const Eigen::Matrix2d X = X_of_T(start);
    BOOST_TEST((X * direction - direction).norm() < 1e-9);
    BOOST_TEST(std::abs((unit - X).determinant()) < 1e-9);  // Satz 4.7 does not apply
    BOOST_TEST(std::abs(X.determinant() - std::exp(-4 * pi)) < 1e-10);
    // off the orbit there is no eigenvalue 1
    BOOST_TEST(std::abs((unit - X_of_T({0, 0.5})).determinant()) > 1e-2);
    // x' = x/4 + sin t is not autonomous: 1 - X(T) = 1 - e^(pi/2) is regular.
    const auto forced = [](const auto& t, const auto& x, const auto&, auto& f) {
        using std::sin;
        f[0] = x[0] / 4 + sin(t);
    };
    using number = Eigen::Matrix<double, 1, 1>;
    const number one_by_one(1.0);
    const auto r = sensitivities(radau_iia<5>(), forced, number(-16.0 / 17), number(0.0), 0.0, 2 * pi,
                                 {.rtol = 1e-11, .atol = 1e-11}, &one_by_one);
    BOOST_TEST(std::abs(r.S(0, 0) - std::exp(pi / 2)) < 1e-8);
    BOOST_TEST(std::abs(r.y[0] + 16.0 / 17) < 1e-8);  // the periodic solution
}

BOOST_AUTO_TEST_CASE(satz_5_1_bounds_the_condition_of_multiple_shooting_and_its_inverse_has_a_minus_sign) {
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> rate(-3, 3);
    for (int k = 0; k < 100; ++k) {
        const MatrixXd B0 = random_matrix(generator, 2), BT = random_matrix(generator, 2);
        const auto s = theory::scaled(B0, BT);  // norms at most 1
        const problem p = modes({rate(generator), rate(generator)}, 2, s.B0, s.BT);
        std::vector<double> t;
        const int N = 2 + k % 5;
        for (int i = 0; i <= N; ++i) t.push_back(2.0 * i * i / (N * N));
        const MatrixXd S = theory::shooting_matrix(p, t), inverse = theory::shooting_inverse(p, t);
        const double size = norm(S) * norm(inverse);
        BOOST_TEST((S * inverse - MatrixXd::Identity(2 * N, 2 * N)).cwiseAbs().maxCoeff() < 1e-13 * size);
        MatrixXd printed = -inverse;  // with +G, and Phi as it is
        printed.rightCols(2) *= -1;
        BOOST_TEST((S * printed - MatrixXd::Identity(2 * N, 2 * N)).cwiseAbs().maxCoeff() > 0.9);
        double step = 0, kappa1 = 0, kappa2 = 0;
        for (int j = 0; j < N; ++j) step = std::max(step, norm(p.X(t[j + 1]) * p.inverse(p.X(t[j]))));
        for (int i = 0; i <= N; ++i) {
            kappa1 = std::max(kappa1, norm(p.phi(t[i])));
            for (int j = 0; j <= N; ++j) kappa2 = std::max(kappa2, norm(p.green(t[i], t[j])));
        }
        const double condition =
            theory::block_row_norm<double>(S, 2) * theory::block_row_norm<double>(inverse, 2);
        BOOST_TEST(condition <= (kappa1 + (N - 1) * kappa2) * (1 + step) * (1 + 1e-12));
    }
    // Conditions larger than 1, which the hypothesis excludes, pass the bound.
    const problem large = modes({-1, 1}, 1, 100 * diagonal({1, 0}), 100 * diagonal({0, 1}));
    const std::vector<double> t{0, 0.5, 1};
    const double condition = theory::block_row_norm<double>(theory::shooting_matrix(large, t), 2) *
                             theory::block_row_norm<double>(theory::shooting_inverse(large, t), 2);
    BOOST_TEST(condition > (large.kappa1(4) + large.kappa2(4)) * (1 + std::exp(0.5)));
}

namespace splines {

using q = tableaux::fixed_rational;

// (6.4): u'(mid) = 3/2 D - (u'_0 + u'_1)/4 with D = (u_1 - u_0)/h, hence h D = h sum_k b_k u'_k with
constexpr q b[] = {q(2, 3) * q(1, 4), q(2, 3), q(2, 3) * q(1, 4)};
// (6.5): u(mid) = (u_0 + u_1)/2 - h (u'_1 - u'_0)/8 = u_0 + h sum_k a_k u'_k with
constexpr q a[] = {b[0] / 2 + q(1, 8), b[1] / 2, b[2] / 2 - q(1, 8)};
static_assert(b[0] == q(1, 6) && b[1] == q(2, 3) && b[2] == q(1, 6));
static_assert(a[0] == q(5, 24) && a[1] == q(1, 3) && a[2] == q(-1, 24));
// C(3) at 1/2, and B(4) but not B(5): order 4 = 2 s - 2, not the 2 s - 1 that is printed.
static_assert(a[0] + a[1] + a[2] == q(1, 2) && a[1] / 2 + a[2] == q(1, 8) && a[1] / 4 + a[2] == q(1, 24));
static_assert(b[1] / 8 + b[2] == q(1, 4) && !(b[1] / 16 + b[2] == q(1, 5)));

/// By how much the slope of the collocation polynomial on [0, 1] differs from f at its ends, for x' = x/2, x(0) = 1.
template <int S>
Eigen::Vector2d defect_at_the_ends(const tableau<double, S>& m) {
    const int s = m.stages();
    const VectorXd slopes = (MatrixXd::Identity(s, s) - MatrixXd(m.A) / 2)
                                .partialPivLu()
                                .solve(VectorXd(VectorXd::Constant(s, 0.5)));
    Eigen::Vector2d defect(-0.5, -0.5 * (1 + m.b.dot(slopes)));
    for (int end = 0; end < 2; ++end)
        for (int j = 0; j < s; ++j) {
            double l = 1;
            for (int k = 0; k < s; ++k)
                if (k != j) l *= (end - m.c[k]) / (m.c[j] - m.c[k]);
            defect[end] += l * slopes[j];
        }
    return defect;
}

}  // namespace splines

BOOST_AUTO_TEST_CASE(lobatto_iiia_3_is_collocation_by_cubic_splines_and_radau_iia_is_continuous_only) {
    const auto m = lobatto_iiia<3>();
    for (int k = 0; k < 3; ++k) {
        const auto nearest = [](const splines::q& x) {
            return static_cast<double>(x.numerator()) / static_cast<double>(x.denominator());
        };
        BOOST_TEST(m.b[k] == nearest(splines::b[k]));
        BOOST_TEST(m.A(1, k) == nearest(splines::a[k]));
        BOOST_TEST(m.A(2, k) == m.b[k]);
        BOOST_TEST(m.A(0, k) == 0);
    }
    // Nodes 0 and 1: the slopes of neighbours are f at their common point. Without the node 0 they jump.
    BOOST_TEST(splines::defect_at_the_ends(m).cwiseAbs().maxCoeff() < 1e-15);
    BOOST_TEST(splines::defect_at_the_ends(lobatto_iiia<5>()).cwiseAbs().maxCoeff() < 1e-14);
    const Eigen::Vector2d radau = splines::defect_at_the_ends(radau_iia<3>());
    BOOST_TEST(std::abs(radau[0]) > 1e-4);
    BOOST_TEST(std::abs(radau[1]) < 1e-15);
}
