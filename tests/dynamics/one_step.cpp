// SPDX-License-Identifier: BSL-1.0
// Lecture: one-step methods as x_n = x_(n-1) + h phi, what the stages say of contraction and dissipativity, and what stays at
// rest.
#define BOOST_TEST_MODULE one_step
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/dense_once.hpp>
#include <random>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/theory/dynamics/contraction.hpp>
#include <stagecraft/theory/dynamics/dissipativity.hpp>
#include <stagecraft/theory/dynamics/krawczyk.hpp>
#include <stagecraft/theory/dynamics/multistep.hpp>
#include <stagecraft/theory/dynamics/rk_map.hpp>

#include "../catalogue.hpp"
#include "../message.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;
using tableaux::family;
using tableaux::quadratic;

namespace {

using point = state<double, 1>;

tableau<quadratic> exact(family f, int s) { return *tableaux::exact_tableau(f, s); }

std::vector<tableau<quadratic>> algebraically_stable_ones() {
    return {exact(family::gauss, 1),    exact(family::gauss, 2),     exact(family::radau_iia, 1),
            exact(family::radau_ia, 2), exact(family::radau_iia, 2), exact(family::lobatto_iiic, 2)};
}

tableau<double> explicit_euler() {
    tableau<double> t;
    t.A = Eigen::MatrixXd::Zero(1, 1), t.b = Eigen::VectorXd::Ones(1), t.c = Eigen::VectorXd::Zero(1);
    return t;
}

tableau<double> rk4() {
    tableau<double> t;
    t.A = Eigen::Matrix4d{{0, 0, 0, 0}, {0.5, 0, 0, 0}, {0, 0.5, 0, 0}, {0, 0, 1, 0}};
    t.b = Eigen::Vector4d(1, 2, 2, 1) / 6, t.c = Eigen::Vector4d(0, 0.5, 0.5, 1);
    return t;
}

// x' = sin x, Lipschitz constant 1, x(t) = 2 atan(e^t tan(x0/2)).
const auto sine = [](const auto&, const auto& x, auto& f) {
    using std::sin;
    f[0] = sin(x[0]);
};
double sine_solution(double x0, double t) { return 2 * std::atan(std::exp(t) * std::tan(x0 / 2)); }

const auto cubic = [](const auto&, const auto& x, auto& f) { f[0] = x[0] - x[0] * x[0] * x[0]; };
const auto lorenz = [](const auto&, const auto& x, auto& f) {
    f[0] = 10 * (x[1] - x[0]);
    f[1] = 28 * x[0] - x[1] - x[0] * x[2];
    f[2] = x[0] * x[1] - 8 * x[2] / 3;
};

}  // namespace

BOOST_AUTO_TEST_CASE(
    definition_2_2_the_increment_function_is_f_for_small_h_and_not_where_2_3_has_no_solution) {
    for (const double h : {0.5, 0.01}) {
        const auto parts = rk_parts<1>(rk4(), sine, point(0.7), h);
        BOOST_REQUIRE(parts.has_value());
        BOOST_TEST(std::abs(parts->end[0] - 0.7 - h * parts->increment[0]) < 1e-15);  // (2.2)
        BOOST_TEST(parts->end[0] == (*rk_step<1>(rk4(), sine, point(0.7), h))[0]);
        // phi of the classical method, by hand
        const double k1 = std::sin(0.7), k2 = std::sin(0.7 + h / 2 * k1), k3 = std::sin(0.7 + h / 2 * k2),
                     k4 = std::sin(0.7 + h * k3);
        BOOST_TEST(std::abs(parts->increment[0] - (k1 + 2 * k2 + 2 * k3 + k4) / 6) < 1e-15);
        BOOST_TEST(parts->stages[2][0] == 0.7 + h / 2 * k2, boost::test_tools::tolerance(1e-15));
    }
    // phi(x, t, h) -> f(x, t) as h -> 0 for consistent methods, sum_i b_i f(x, t) for any
    auto half = rk4();
    half.b /= 2;
    const double small = 1e-7;
    BOOST_TEST(std::abs(rk_parts<1>(rk4(), sine, point(0.7), small)->increment[0] - std::sin(0.7)) < 1e-6);
    BOOST_TEST(std::abs(rk_parts<1>(half, sine, point(0.7), small)->increment[0] - std::sin(0.7) / 2) < 1e-6);
    // well defined where (2.3) has one solution: for x' = x^2 the implicit Euler method has X = 1 + h X^2
    const auto square = [](const auto&, const auto& x, auto& f) { f[0] = x[0] * x[0]; };
    const auto implicit = in_doubles(exact(family::radau_iia, 1));
    const auto solvable = rk_parts<1>(implicit, square, point(1.0), 0.2);
    BOOST_REQUIRE(solvable.has_value());
    BOOST_TEST(std::abs(solvable->end[0] - (1 - std::sqrt(0.2)) / 0.4) < 1e-12);
    BOOST_TEST(!rk_parts<1>(implicit, square, point(1.0), 0.3).has_value());  // 1 - 4h < 0
    BOOST_TEST(message([&] { rk_parts<1>(rk4(), sine, point(0.7), 0); }).starts_with("h: "));
}

BOOST_AUTO_TEST_CASE(section_2_3_the_printed_bound_with_l_phi_and_tau_minus_delta) {
    // L_phi of the classical method for L = 1; of explicit Euler 1.
    const double T = 2, x0 = 0.4;
    std::mt19937 random(23);
    std::uniform_real_distribution<double> pick(-1, 1);
    for (const bool euler : {true, false})
        for (const int N : {10, 40}) {
            const auto method = euler ? explicit_euler() : rk4();
            const double h = T / N, L = euler ? 1 : 1 + h / 2 + h * h / 6 + h * h * h / 24;
            for (const double size : {0.0, 1e-6, 1e-3}) {
                double most = 0, largest_tau = 0;
                point with_delta(x0), with_tau(x0);
                for (int n = 1; n <= N; ++n) {
                    const point before(sine_solution(x0, (n - 1) * h));
                    const double after = sine_solution(x0, n * h), delta = size * pick(random);
                    // Definition 2.3: what the exact solution leaves in (2.2)
                    const double tau =
                        (after - before[0]) / h - rk_parts<1>(method, sine, before, h)->increment[0];
                    most = std::max(most, std::abs(tau - delta));
                    largest_tau = std::max(largest_tau, std::abs(tau));
                    with_delta[0] += h * (rk_parts<1>(method, sine, with_delta, h)->increment[0] + delta);
                    with_tau[0] += h * (rk_parts<1>(method, sine, with_tau, h)->increment[0] + tau);
                    const double error = std::abs(after - with_delta[0]);
                    BOOST_TEST(error <= (std::pow(1 + L * h, n) - 1) / L * most * (1 + 1e-9) + 1e-14);
                    BOOST_TEST(error <= std::pow(1 + L * h, n) / L * most + 1e-14);  // as printed in the end
                    BOOST_TEST(std::abs(after - with_tau[0]) < 1e-13);  // delta_l = tau_l: no error at all
                }
                if (size == 0) BOOST_TEST(largest_tau > (euler ? 1e-3 : 1e-9));
            }
        }
    // phi Lipschitz is needed: x' = sqrt x from 0 has x = t^2/4. tau = h/4 goes to 0, and Euler stays at 0.
    const auto root = [](const auto&, const auto& x, auto& f) {
        using std::sqrt;
        f[0] = sqrt(x[0]);
    };
    for (const int N : {10, 1000}) {
        point x(0.0);
        double tau = 0;
        const double h = T / N;
        for (int n = 1; n <= N; ++n) {
            const double before = (n - 1) * h, after = n * h;
            tau = std::max(
                tau,
                std::abs((after * after - before * before) / (4 * h) -
                         rk_parts<1>(explicit_euler(), root, point(before * before / 4), h)->increment[0]));
            x = *rk_step<1>(explicit_euler(), root, x, h);
        }
        BOOST_TEST(tau <= h / 4 * (1 + 1e-9));
        BOOST_TEST(std::abs(T * T / 4 - x[0]) == 1);
    }
}

BOOST_AUTO_TEST_CASE(inequality_1_15_holds_for_algebraically_stable_methods_and_fails_for_explicit_ones) {
    // |x_1|^2 <= |x_0|^2 + 2 h sum_i b_i (alpha - beta |X_i|^2), distances from the centre.
    std::mt19937 random(115);
    std::uniform_real_distribution<double> pick(-1, 1);
    const auto excess = [](const tableau<double>& m, const auto& f, const auto& x, const auto& centre,
                           double h, double alpha, double beta) -> std::optional<double> {
        constexpr int N = std::decay_t<decltype(x)>::RowsAtCompileTime;
        const auto parts = rk_parts<N>(m, f, x, h);
        if (!parts) return {};
        double right = (x - centre).squaredNorm();
        for (std::size_t i = 0; i < parts->stages.size(); ++i)
            right += 2 * h * m.b[static_cast<Eigen::Index>(i)] *
                     (alpha - beta * (parts->stages[i] - centre).squaredNorm());
        return ((parts->end - centre).squaredNorm() - right) / (1 + x.squaredNorm());
    };
    const auto d = dissipativity<1>(cubic, 1);
    state<rational, 3> c;
    c << rational(0), rational(0), rational(38);
    const auto e = dissipativity<3>(lorenz, 1, c);
    const state<double, 3> centre(0, 0, 38);
    int seen = 0;
    for (const auto& m : algebraically_stable_ones()) {
        const auto doubles = in_doubles(m);
        double largest = -1e300;
        for (int k = 0; k < 100; ++k) {
            const double h = std::pow(10, pick(random) * 2);
            const auto one = excess(doubles, cubic, point(5 * pick(random)), point(0.0), h,
                                    d.alpha.to<double>(), d.beta.to<double>());
            const state<double, 3> x =
                centre + 50 * state<double, 3>(pick(random), pick(random), pick(random));
            const auto three =
                excess(doubles, lorenz, x, centre, h / 50, e.alpha.to<double>(), e.beta.to<double>());
            for (const auto& seen_here : {one, three})
                if (seen_here) largest = std::max(largest, *seen_here), ++seen;
        }
        BOOST_TEST(largest <= 1e-9);
    }
    BOOST_TEST(seen > 600);
    // explicit Euler from 10 with h = 1/10: 89^2 against 100 + 0.2 (1 - 100)
    const auto euler = excess(explicit_euler(), cubic, point(10.0), point(0.0), 0.1, 1, 1);
    BOOST_TEST(*euler * 101 == 89.0 * 89 - 100 + 0.2 * 99, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(bemerkung_1_19_the_factor_with_k_and_l_bounds_runs_and_is_below_1_for_gauss_methods) {
    // gamma = -1 and L = sqrt 50 < 8 of a spiral with a bounded nonlinear part (its slope is in [-1/2, 1/2]).
    const auto f = [](const auto&, const auto& x, auto& out) {
        using std::sin;
        out[0] = -1.5 * x[0] - 7 * x[1] + sin(x[0]) / 2;
        out[1] = 7 * x[0] - 1.5 * x[1] + sin(x[1]) / 2;
    };
    const rational gamma(-1), L(8);
    std::mt19937 random(119);
    std::uniform_real_distribution<double> pick(-3, 3);
    for (const auto& m : algebraically_stable_ones()) {
        const auto doubles = in_doubles(m);
        for (const rational& h : {rational(1, 50), rational(1, 4), rational(2)}) {
            const double factor = lipschitz_contraction(m, gamma, L, h);
            BOOST_TEST(factor < 1);
            for (int k = 0; k < 40; ++k) {
                const state<double, 2> x(pick(random), pick(random)), y(pick(random), pick(random));
                const auto u = rk_step<2>(doubles, f, x, h.to<double>()),
                           v = rk_step<2>(doubles, f, y, h.to<double>());
                if (u && v) BOOST_TEST((*u - *v).norm() <= factor * (x - y).norm() * (1 + 1e-9));
            }
        }
    }
    // Implicit Euler: K = 0, 1/(1 - 2 gamma h). Without L Gauss methods have the factor 1 only.
    BOOST_TEST(lipschitz_contraction(exact(family::radau_iia, 1), gamma, L, 2) == std::sqrt(0.2),
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST(contraction(exact(family::gauss, 2), rational(-2)).factor >= 1 - 1e-6);
    // L is needed: along x' = lambda x the midpoint rule's |R(h lambda)| goes to 1 with -h lambda
    const double fixed = lipschitz_contraction(exact(family::gauss, 1), gamma, 1, 1);
    BOOST_TEST(std::abs((1 - 500.0) / (1 + 500.0)) > fixed);
    // what is not asked of
    const auto refused = [&](const tableau<quadratic>& t, const rational& g, const rational& l) {
        return message([&] { lipschitz_contraction(t, g, l, 1); });
    };
    BOOST_TEST(refused(exact(family::gauss, 1), 1, 8).starts_with("gamma: "));
    BOOST_TEST(refused(exact(family::gauss, 1), -2, 1).starts_with("L: "));
    BOOST_TEST(
        refused(exact(family::lobatto_iiia, 2), -1, 8).starts_with("method: not algebraically stable"));
}

namespace {

// f(c, t) = 0 for all t at c = 1 (and, for the first, at -2).
const auto two_at_rest = [](const auto& t, const auto& x, auto& f) {
    f[0] = (1 + t) * (x[0] - 1) * (x[0] + 2) * (t * x[0] + 3);
};
const auto plane_at_rest = [](const auto& t, const auto& x, auto& f) {
    f[0] = t * (x[0] - 1) - (x[1] - 2);
    f[1] = (x[1] - 2) * x[0] - t * t * (x[0] - 1);
};

/// x_k of a linear multistep method from x_0 = ... = x_(k-1) = c where f = 0 along the way.
rational next_at_rest(const multistep& m, const rational& c) {
    rational sum = 0;
    for (int j = 0; j < m.steps(); ++j) sum += m.rho[j] * c;
    return -sum / m.rho[m.steps()];
}

}  // namespace

BOOST_AUTO_TEST_CASE(definition_1_13_equilibria_of_f_of_x_and_t_are_zeros_at_all_times) {
    const auto at = [](const rational& c) { return state<rational, 1>(c); };
    BOOST_TEST(is_equilibrium<1>(two_at_rest, at(1)));
    BOOST_TEST(is_equilibrium<1>(two_at_rest, at(-2)));
    BOOST_TEST(!is_equilibrium<1>(two_at_rest, at(-3)));  // f(-3, 1) = 0, but f(-3, 0) != 0
    BOOST_TEST(exact_value<1>([](const auto&, const auto& x, auto& f) { two_at_rest(rational(1), x, f); },
                              at(-3))[0] == 0);
    const auto moving = [](const auto& t, const auto& x, auto& f) { f[0] = t - x[0]; };
    for (const int c : {-1, 0, 1})
        BOOST_TEST(!is_equilibrium<1>(moving, at(c)));  // a zero at each t, never the same
    state<rational, 2> c;
    c << rational(1), rational(2);
    BOOST_TEST(is_equilibrium<2>(plane_at_rest, c));
}

BOOST_AUTO_TEST_CASE(satz_1_24_equilibria_stay_under_every_method_that_uses_f_alone) {
    // f(x, t) with time: the library's steps stay at c to the last bit, at any h, and a point beside c is moved.
    int count = 0;
    for (const auto& [name, t] : read_once::exact_methods()) {
        const auto m = in_doubles(t);
        ++count;
        for (const double h : {0.3, 7.0})
            for (const double start : {0.0, 2.5}) {
                for (const double c : {1.0, -2.0}) {
                    const auto x = rk_step<1>(m, two_at_rest, point(c), h, start);
                    BOOST_TEST((x.has_value() && (*x)[0] == c), name);
                }
                const auto y = rk_step<2>(m, plane_at_rest, state<double, 2>(1, 2), h, start);
                BOOST_TEST((y.has_value() && *y == (state<double, 2>(1, 2))), name);
            }
        const auto moved = rk_step<1>(m, two_at_rest, point(1.001), 0.01, 0.0);
        BOOST_TEST((moved.has_value() && (*moved)[0] != 1.001), name);
        // x' = t - x has no equilibrium: no point stays for two steps
        const auto moving = [](const auto& time, const auto& x, auto& f) { f[0] = time - x[0]; };
        const auto first = rk_step<1>(m, moving, point(0.0), 0.3, 0.0);
        BOOST_TEST((first.has_value() && rk_step<1>(m, moving, *first, 0.3, 0.3) != first), name);
    }
    BOOST_TEST(count >= 60);
    // Methods for which it could fail: those with rho(1) != 0 leave c, whatever f does there.
    const rational c(5, 3);
    for (int k = 1; k <= 6; ++k)
        for (const auto& m : {adams_bashforth(k), adams_moulton(k), bdf(k)})
            BOOST_TEST((next_at_rest(m, c) == c));
    const multistep damped{polynomial<rational>{rational(-9, 10), 1}, polynomial<rational>{1}};
    BOOST_TEST(consistent_method(damped).is_refuted());
    BOOST_TEST((next_at_rest(damped, c) == rational(3, 2)));
}
